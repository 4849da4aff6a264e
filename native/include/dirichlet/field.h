// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dirichlet/mesh.h"
#include "dirichlet/solver.h"

namespace dirichlet {

/// What was solved, how well and how fast. Ranges are over all columns of a field.
struct SolveReport {
  Index vertices = 0;
  Index painted = 0;                ///< distinct painted vertices
  Index unknowns = 0;               ///< free vertices that have an equation
  std::int64_t nonzeros = 0;        ///< of the injected matrix; direct: of its lower triangle
  std::int64_t factor_nonzeros = 0; ///< numbers stored for the factor; 0 for an iterative method
  Index iterations = 0;             ///< 0 for a direct method
  double relative_residual = 0;     ///< ‖rhs − Kφ‖ / ‖rhs‖ over the free vertices, the worst column
  double minimum = 0;               ///< of the defined values
  double maximum = 0;
  double painted_minimum = 0;
  double painted_maximum = 0;
  Index outside = 0;               ///< values the solver left outside the painted range of their region, by rounding;
  double farthest_outside = 0;     ///< and how far; projected back onto it (only without a source)
  Index undefined = 0;             ///< vertices of pieces without paint: NaN
  Index first_undefined = -1;      ///< the lowest of them, or -1
  double connectivity_seconds = 0; ///< wall time: the mesh's validation and connectivity
  double laplacian_seconds = 0;
  double injection_seconds = 0;
  double factor_seconds = 0;
  double solve_seconds = 0;          ///< this right-hand side alone
  std::vector<std::string> warnings; ///< one sentence each
};

/// φ, one column per right-hand side, and its report.
struct Field {
  Eigen::MatrixXd values; ///< (V, k); NaN on connected pieces without paint, finite elsewhere
  SolveReport report;
};

/// Laplace's (or Poisson's) equation on a mesh with values prescribed on painted vertices. Built once per mesh and
/// painted set, then solves any values; keeps nothing of the mesh but its matrix.
///
/// Without a source the graph Laplacian has a maximum principle, so every field lies in the range painted at the rim of
/// its region; what rounding leaves outside is projected onto it and counted in the report.
class HarmonicSolver {
 public:
  /// \param painted  (C,) vertices with a value, any order; a repeated one must be given equal values.
  /// \throws InputError   nothing painted, an index out of range (named with its place), an option out of range
  /// \throws SolverError  the factorisation failed
  /// Cost: see make_solver.
  HarmonicSolver(const Mesh& mesh, std::span<const Index> painted, const SolverOptions& options = {});

  /// \param values  (C, k) finite, aligned with `painted`.
  /// \param source  (V,) finite, or empty: at free vertices (I − D⁻¹A) φ = source, so a positive source raises φ.
  ///                Entries at painted vertices are not read.
  /// \throws InputError   a wrong length, a number that is not finite, one vertex with two values; names it
  /// \throws SolverError  not converged
  [[nodiscard]] Field solve(const Eigen::Ref<const Eigen::MatrixXd>& values, std::span<const double> source = {}) const;

  [[nodiscard]] Index vertex_count() const { return static_cast<Index>(stiffness_.rows()); }
  [[nodiscard]] Index painted_count() const { return static_cast<Index>(painted_.size()); } ///< C

  HarmonicSolver(const HarmonicSolver&) = delete; // its solver refers to its matrix
  HarmonicSolver& operator=(const HarmonicSolver&) = delete;

 private:
  /// (V, k): the values where painted, source times mass where free.
  [[nodiscard]] Eigen::MatrixXd prescribe(const Eigen::Ref<const Eigen::MatrixXd>& values,
                                          std::span<const double> source) const;

  SparseMatrix stiffness_;
  std::vector<Index> painted_;
  std::vector<std::array<Index, 2>> repeats_; ///< places of painted_ that name a vertex again, and where it stood first
  Mask fixed_;                                ///< painted, or undefined: rows without an equation of their own
  FreeRegions regions_;
  std::unique_ptr<const Solver> solver_;
  SolveReport base_; ///< what does not depend on the values
};

/// The paper's square matrix for a painted set, (I − M)(I − D⁻¹A) + M. \throws InputError  as HarmonicSolver.
SparseMatrix dirichlet_laplacian(const Mesh& mesh, std::span<const Index> painted);

} // namespace dirichlet
