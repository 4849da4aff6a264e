// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <Eigen/Core>

#include "dirichlet/injection.h"

namespace dirichlet {

enum class Method {
  direct,           ///< multifrontal Cholesky of the symmetric twin, on all cores
  least_squares_cg, ///< the paper's: conjugate gradients on LᵀL of the raw, unsymmetric matrix; the reference
};

struct SolverOptions {
  Method method = Method::direct;
  /// least_squares_cg alone: stop at ‖Aᵀr‖ ≤ tolerance ‖Aᵀb‖. In (0, 1).
  double tolerance = 1e-14;
  /// least_squares_cg alone: give up after so many steps. At least 1; nothing said: 20 n + 1000.
  std::optional<Index> max_iterations;
};

struct SolverStatistics {
  Index unknowns = 0;               ///< free vertices
  std::int64_t nonzeros = 0;        ///< of the injected matrix; direct: of its lower triangle
  std::int64_t factor_nonzeros = 0; ///< numbers stored for L; 0 for an iterative method
  double inject_seconds = 0;        ///< building the injected matrix
  double factor_seconds = 0;        ///< ordering and factorisation
};

/// One way to solve the injected system. Built once per stiffness matrix and mask; solves any number of right-hand
/// sides, from several threads.
class Solver {
 public:
  virtual ~Solver() = default;

  /// \param prescribed  (n, k): painted values where painted, source times mass where free.
  /// \param iterations  the largest number of steps any column took; 0 for a direct method.
  /// \returns           (n, k)
  /// \throws SolverError  not converged, or not finite.
  [[nodiscard]] virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& prescribed, Index& iterations) const = 0;

  [[nodiscard]] virtual const SolverStatistics& statistics() const = 0;
};

/// \param K     (n, n) symmetric, positive definite on the free vertices once the mask is injected. The solver keeps a
///              reference to it: it has to live as long.
/// \throws InputError   an option out of its range
/// \throws SolverError  the injected matrix is singular, or memory was denied
/// Cost: direct O(n^1.5) on surfaces, memory O(n log n); least squares O(n) per step.
std::unique_ptr<Solver> make_solver(const SparseMatrix& K, const Mask& mask, const SolverOptions& options);

} // namespace dirichlet
