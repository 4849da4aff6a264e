// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "dirichlet/buffer.h"
#include "dirichlet/cancel.h"
#include "dirichlet/injection.h"
#include "solver/dense_kernels.h"
#include "solver/elimination_tasks.h"
#include "solver/ordered_matrix.h"
#include "solver/symbolic.h"

namespace dirichlet {

class Team;

/// Where the factor's diagonal comes from.
enum class Pivots : std::uint8_t {
  subtracted, ///< from the matrix's diagonal, by which any positive definite one can be factored
  summed,     ///< see summed_pivots.h
};

/// Multifrontal Cholesky factor L Lᵀ of the injected twin (I − M) K (I − M) + M (Duff & Reid 1983; Liu 1992), which can
/// follow changes of M: painted vertices are identity rows, so structure and storage never change.
///
/// Both halves of the forest are factored by a thread each; then all threads share the fronts of the separators on top.
/// Every number comes from the same operations in the same order, whatever the number of threads and whether it is
/// computed in a whole or a partial factorisation: results are equal bit for bit.
template <class Real>
class Factor {
 public:
  /// \param pivots     summed only for a matrix that has_uneven_weights
  /// \param most_kept  bytes that may be spent on update matrices kept for partial factorisations
  /// \throws std::bad_alloc  not enough memory
  Factor(std::shared_ptr<const SymbolicFactor> symbolic, std::shared_ptr<const OrderedMatrix> matrix, Pivots pivots,
         std::int64_t most_kept, CancelToken cancel = {});

  /// Factors anew what depends on the columns in `changed` (positions whose painted flag differs, or whose neighbours'
  /// does). \param fixed  (n,) by position: 1 for an identity row.
  /// \returns the share of floating-point work that was done again, in [0, 1].
  /// \throws SolverError  a pivot that is not positive; names the vertex. The next call then has to be a whole one. So
  ///                      it has after the CancelledError that every function but the constructor may throw.
  double refactor(const Mask& fixed, std::span<const Index> changed);

  /// All of it.
  void factor(const Mask& fixed);

  /// L Lᵀ x = b in place; x (n, k) row-major, by position.
  void solve(std::span<Real> x, Index k) const;

  /// What it holds: the factor, kept update matrices, working space, the matrix and the symbolic factor.
  [[nodiscard]] std::int64_t bytes() const;

  /// The same before anything is allocated; beside it, a solution takes a few numbers per unknown and front.
  /// \param entries  of the matrix, both triangles
  static std::int64_t bytes_needed(const SymbolicFactor& symbolic, std::int64_t entries, std::int64_t most_kept);

 private:
  /// What a thread needs of its own.
  struct Workspace {
    Buffer<Index> place;              ///< (n,) of every row of the front in work: its place there
    Buffer<Real> stack;               ///< update matrices inside a subtree
    std::vector<Real> slack;          ///< of the rows of the front in work
    std::vector<Index> child_place;   ///< of the rows of one of its children
    std::vector<const Real*> updates; ///< of the supernodes whose parent is still to come, in their order
    Team* team = nullptr;             ///< that may share a front
  };
  void run(const Mask& fixed, const std::vector<std::uint8_t>& dirty);
  void run_task(Index number, const Mask& fixed, Workspace& space);
  void eliminate(Index s, const Mask& fixed, Real* update, std::span<const Real* const> child_updates,
                 Workspace& space);
  void fill_panel(Index s, const Mask& fixed, Index* place, Real* panel) const;
  [[nodiscard]] Real weights_to(Index column, const Mask& fixed) const;
  Index factor_front(Index s, Real* panel, Real* update, std::vector<Real>& slack, Team* team) const;
  /// Supernodes [begin, end); what goes to the shared columns is added to `shared` instead of x.
  void forward(Index begin, Index end, Real* x, Real* shared, Index k) const;
  void backward(Index begin, Index end, Real* x, Index k) const;

  std::shared_ptr<const SymbolicFactor> symbolic_;
  std::shared_ptr<const OrderedMatrix> matrix_;
  Pivots pivots_;
  CancelToken cancel_;
  EliminationTasks tasks_;
  std::vector<Index> child_offsets_; ///< (S + 1,)
  std::vector<Index> children_;      ///< supernodes, by parent
  std::vector<double> work_;         ///< (tasks,) floating-point operations
  const DenseKernels<Real>& kernels_;
  Buffer<Real> panels_; ///< the factor
  Buffer<Real> kept_;   ///< update matrices of tasks
  std::array<Workspace, 2> spaces_;
};

} // namespace dirichlet
