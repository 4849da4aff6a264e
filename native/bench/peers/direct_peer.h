// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>

#include "system.h"

namespace peers {

/// A sparse Cholesky: somebody else's, or ours on the same terms. Lower triangles go in.
class DirectPeer {
 public:
  virtual ~DirectPeer() = default;
  virtual void analyze(const SparseMatrix& lower) = 0; ///< ordering and symbolic step
  virtual void start_from(const System&) {}            ///< before strokes on it: for who keeps a factor to change it
  virtual void factor(const System& system) = 0;       ///< of the matrix analysed, painted
  [[nodiscard]] virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) = 0;
};

std::unique_ptr<DirectPeer> make_eigen_peer(); ///< SimplicialLDLT, approximate minimum degree

/// Of that matrix, which it wants with both triangles: made here, not when the time is taken. It changes the factor of
/// the last painting where others start over.
std::unique_ptr<DirectPeer> make_ours_peer(const SparseMatrix& lower);

enum class CholmodOrdering : std::uint8_t { amd, metis };
std::unique_ptr<DirectPeer> make_cholmod_peer(CholmodOrdering ordering); ///< supernodal

} // namespace peers
