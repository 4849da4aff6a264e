// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Cholesky>

#include "dirichlet/cancel.h"
#include "dirichlet/injection.h"
#include "solver/multigrid/transfer.h"

namespace dirichlet {

/// Conjugate gradients on the injected twin A = (I − M) K (I − M) + M, preconditioned by a V-cycle of smoothed
/// aggregation: for meshes whose Cholesky factor would not fit. Memory is a small multiple of n, some tenths of a
/// factor's, and K itself is the finest level.
///
/// Relaxation is a Chebyshev polynomial of the fourth kind in D⁻¹A, where D(i,i) = Σⱼ |A(i,j)|: no eigenvalue has to be
/// guessed, as those of D⁻¹A lie in (0, 1] for every positive definite A, and rows are independent of each other.
/// Sources: Vaněk, Mandel & Brezina 1996 (hierarchy); Baker, Falgout, Kolev & Yang 2011 (D); Lottes 2023 (polynomial).
/// Results are equal bit for bit, whatever the number of threads. const, and safe from several threads at once.
class Multigrid {
 public:
  /// Builds the hierarchy of one painted set.
  /// \param K     (n, n) symmetric, positive definite on the free vertices. Kept by reference: it has to live as long.
  /// \param mask  (n,) 1 where painted.
  /// \throws InputError      a mask of a wrong length
  /// \throws SolverError     a diagonal entry that is not positive (names the vertex), or a coarse matrix that is not
  ///                         positive definite
  /// \throws std::bad_alloc  not enough memory
  /// \throws CancelledError  between levels, and then by `solve` between steps
  /// Cost: O(non-zeros), about ten steps of solve.
  Multigrid(const SparseMatrix& K, const Mask& mask, CancelToken cancel = {});

  struct Result {
    Index iterations;         ///< V-cycles done
    double relative_residual; ///< ‖b − A x‖ / ‖b‖ over free vertices; painted ones are exact
  };

  /// Solves A x = b.
  /// \param rhs             (n,) b
  /// \param x               (n,) in: where to start; out: the solution
  /// \param tolerance       stop at ‖b − A x‖ ≤ tolerance ‖b‖, both over free vertices
  /// \param max_iterations  give up after so many steps
  /// \param to_rounding     be content with a residual that rounding alone may leave, m ε |A| |x| for a row of m
  /// entries
  ///                        (at least 8), where it grows no smaller
  /// \throws InputError   an array of a wrong length
  /// \throws SolverError  short of the tolerance after max_iterations or where rounding ends, A is not positive
  ///                      definite, or a number is not finite. x is not changed then.
  /// Cost: O(non-zeros) per step; five working arrays (n,).
  Result solve(std::span<const double> rhs, std::span<double> x, double tolerance, Index max_iterations,
               bool to_rounding = false) const;

  /// What is held beside K.
  [[nodiscard]] std::int64_t bytes() const;

 private:
  struct Level {
    SparseMatrix own;                 ///< empty on the finest level, which is K
    std::vector<double> scaling;      ///< (n,) D⁻¹, 0 at painted vertices: whatever is scaled by it stays 0 there
    multigrid::Transfer prolongation; ///< from the next level; no columns where relaxation does all
    multigrid::Transfer restriction;  ///< its transpose
  };
  struct Vectors;
  class Iteration;

  [[nodiscard]] const SparseMatrix& matrix(std::size_t level) const { return level == 0 ? K_ : levels_[level].own; }
  void relax(std::size_t level, bool from_zero, Vectors& v) const;
  void precondition(std::size_t level, std::vector<Vectors>& work) const;

  const SparseMatrix& K_;
  CancelToken cancel_;
  std::vector<Level> levels_;
  Eigen::LLT<Eigen::MatrixXd> coarsest_;
};

} // namespace dirichlet
