// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stdexcept>

#include "system.h"

namespace peers {

/// A sparse Cholesky of somebody else. Lower triangles go in.
class DirectPeer {
 public:
  virtual ~DirectPeer() = default;
  virtual void analyze(const SparseMatrix& lower) = 0; ///< ordering and symbolic step
  virtual void factor(const SparseMatrix& lower) = 0;  ///< of a matrix with the pattern analysed
  [[nodiscard]] virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) = 0;
};

std::unique_ptr<DirectPeer> make_eigen_peer(); ///< SimplicialLDLT, approximate minimum degree

enum class CholmodOrdering { amd, metis };
std::unique_ptr<DirectPeer> make_cholmod_peer(CholmodOrdering ordering); ///< supernodal

} // namespace peers
