// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "dirichlet/cancel.h"
#include "dirichlet/injection.h"

namespace dirichlet {

enum class Method : std::uint8_t {
  automatic,        ///< direct where the factor fits the memory budget, else multigrid
  direct,           ///< multifrontal Cholesky of the symmetric twin, on all cores
  multigrid,        ///< conjugate gradients on the twin, preconditioned by smoothed aggregation
  least_squares_cg, ///< the paper's: conjugate gradients on LᵀL of the raw, unsymmetric matrix; the reference
};

enum class Precision : std::uint8_t {
  float64, ///< of the factor
  float32, ///< half the memory; conjugate gradients on doubles refine what it gives, to the tolerance
};

/// Bytes: half of the machine's memory; without bound where the system does not tell.
std::int64_t default_memory_budget();

struct SolverOptions {
  Method method = Method::automatic;
  Precision precision = Precision::float64; ///< of the direct method's factor
  /// Bytes that the factor and what makes strokes quick should take: automatic goes by it, direct keeps no more for
  /// strokes. Nothing said: default_memory_budget().
  std::optional<std::int64_t> memory_budget;
  /// In (0, 1). A float32 factor and multigrid stop at ‖r‖ ≤ tolerance ‖b‖ (nothing said: 1e-10, and multigrid where
  /// rounding ends if that is before, as with weights 1e8 times others), least squares at
  /// ‖Aᵀr‖ ≤ tolerance ‖Aᵀb‖ (nothing said: 1e-14). Norms are over a whole column: a piece whose values are small
  /// beside those of others is solved less exactly than they.
  std::optional<double> tolerance;
  /// Give up after so many steps. At least 1; nothing said: 20 n + 1000 for least squares, else 500.
  std::optional<Index> max_iterations;
  /// Stops analysis, factorisation and solution within a fraction of a second, by a CancelledError: they look at it
  /// between fronts, steps and levels; least squares only between columns.
  CancelToken cancel;
};

struct SolverStatistics {
  Method method = Method::direct;   ///< what automatic chose
  std::int64_t nonzeros = 0;        ///< of the matrix, the same for every painting
  std::int64_t factor_nonzeros = 0; ///< numbers stored for L; 0 for an iterative method
  std::int64_t factor_bytes = 0;    ///< that the factor needs, what makes strokes quick not counted; 0 as above
  double analysis_seconds = 0;      ///< ordering and symbolic analysis, once per matrix
  bool sums_pivots = false;         ///< weights differ much in size, and the factor is as exact as they are
  bool weak_links = false; ///< parts hang together by weights 1e-8 of others, and the method loses their digits
};

/// One way to solve the injected system. Made once per stiffness matrix; then masks come and go, and every mask serves
/// any number of right-hand sides.
///
/// It works in a numbering of its own: row i is row order()[i] of the matrix it was made of. A direct one is in order
/// of elimination, where neighbours are near each other however the matrix was numbered. Masks and right-hand sides are
/// by row.
class Solver {
 public:
  virtual ~Solver() = default;

  [[nodiscard]] virtual SparseView matrix() const = 0;            ///< K, renumbered
  [[nodiscard]] virtual std::span<const Index> order() const = 0; ///< (n,)
  [[nodiscard]] virtual const SolverStatistics& statistics() const = 0;

  /// Makes rows identity rows where the mask says so, and the others equations again; does no more than the change from
  /// the last mask asks for.
  /// \returns  the share of a whole factorisation's work that this took, in [0, 1]; 0 for the mask that is there
  /// \throws SolverError  the injected matrix is singular, or memory was denied. The next call starts from nothing.
  virtual double inject(const Mask& mask) = 0;

  /// \param rhs  (n, k) of the injected twin: see inject_right_hand_side
  /// \param x    (n, k) a guess, from which multigrid starts, or anything of another shape; then the solution
  /// \returns    the largest number of steps any column took; 0 for a direct method
  /// \throws SolverError  not converged. May be called from several threads at once.
  virtual Index solve(const Block& rhs, Block& x) const = 0;
};

/// \param K  (n, n) symmetric, positive definite on the free rows once a mask is injected; used up.
/// \throws InputError   an option out of its range
/// \throws SolverError  memory was denied; weights 1e13 times others, of which only the direct method in float64 keeps
///                      all digits
/// Cost: direct O(n^1.5) on surfaces, memory O(n log n); multigrid O(n); least squares O(n) per step.
std::unique_ptr<Solver> make_solver(SparseMatrix&& K, const SolverOptions& options);

} // namespace dirichlet
