// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <shared_mutex>
#include <span>
#include <string>
#include <vector>

#include "dirichlet/defects.h"
#include "dirichlet/mesh.h"
#include "dirichlet/solver.h"

namespace dirichlet {

/// What had to be computed for a painting, given the one before.
enum class Update : std::uint8_t {
  nothing, ///< the same vertices, values and source: the field is the last one
  values,  ///< the same vertices: substitution alone
  partial, ///< the part of the factor that depends on the vertices that changed
  full,    ///< the whole factor
};

/// What was solved, how well and how fast. Ranges are over all columns of a field.
struct SolveReport {
  Laplacian laplacian = Laplacian::graph; ///< the one taken, never automatic
  std::string reason;                     ///< why automatic took it; else empty
  Index flat_faces = 0;                   ///< faces without an area
  Method method = Method::direct;         ///< the one taken, never automatic
  Update update = Update::full;           ///< by the last change of paint
  double repeated = 1;                    ///< its share of the work of a whole factorisation, in [0, 1]
  Index vertices = 0;
  Index painted = 0;                ///< distinct painted vertices
  Index unknowns = 0;               ///< free vertices that have an equation
  std::int64_t nonzeros = 0;        ///< of the square matrix, the same for every painting
  std::int64_t factor_nonzeros = 0; ///< numbers stored for the factor; 0 for an iterative method
  Index iterations = 0;             ///< 0 for a direct method in float64
  double relative_residual = 0;     ///< see HarmonicSolver
  double minimum = 0;               ///< of the defined values
  double maximum = 0;
  double painted_minimum = 0;
  double painted_maximum = 0;
  Index outside = 0;               ///< values outside the painted range of their region (looked for without a source),
  double farthest_outside = 0;     ///< and how far; see HarmonicSolver for what becomes of them
  Index undefined = 0;             ///< vertices of pieces without paint: NaN
  Index first_undefined = -1;      ///< the lowest of them, or -1
  double connectivity_seconds = 0; ///< wall time: the mesh's validation and connectivity
  double laplacian_seconds = 0;
  double analysis_seconds = 0;       ///< ordering and symbolic analysis; like the two above 0 after the first `paint`
  double injection_seconds = 0;      ///< of the last change of paint
  double factor_seconds = 0;         ///< of the last change of paint
  double solve_seconds = 0;          ///< this right-hand side; the first of a painting also waits for its regions
  std::vector<std::string> warnings; ///< one sentence each
};

/// φ, one column per right-hand side, and its report.
struct Field {
  Eigen::MatrixXd values; ///< (V, k); NaN on connected pieces without paint, finite elsewhere
  SolveReport report;
};

class FixedRows;
class RegionSearch;
struct Outside;

/// Laplace's (or Poisson's) equation on a mesh with values prescribed on painted vertices. Lives as long as the mesh
/// does not change: the matrix is ordered and analysed once, then `paint` follows the brush and computes no more than
/// what changed, and `solve` serves any values of the painting that is there. Keeps nothing of the mesh but its matrix,
/// and the field painted last.
///
/// Without a source an operator of a maximum principle (graph and intrinsic Delaunay always, the others where no weight
/// is negative) keeps every field in the range painted at the rim of its region; what rounding leaves outside is
/// projected onto it, and counted in the report where it is more than the last digits. Where there is no such principle
/// nothing is moved: the report counts what lies outside and warns.
///
/// The relative residual is that of the symmetric twin, ‖s − Kφ‖ / ‖b‖ over the free vertices in the worst column: what
/// is left of the differences to their neighbours, times weights and with the source s; b is what the source and
/// painted neighbours give them (see injection.h). A direct method in float64, where no weight is negative, has
/// each column of φ right to its last digits even where weights differ enormously: there a row counts only as far as it
/// exceeds 8 ε max|φ| Σ_j |K_ij|, which rounding of φ alone may leave. Other methods are not spared: where weights
/// differ as much, their residual tells of their error, which may be a hundred times as large; and far larger where
/// negative weights all but cancel the others, as on quads whose corners are far out of one plane.
///
/// May be used from several threads: a `paint` waits for the `solve`s that run, and they for it.
class HarmonicSolver {
 public:
  /// Nothing painted yet. \throws InputError  an option out of its range; and as make_stiffness. Cost: see make_solver.
  explicit HarmonicSolver(const Mesh& mesh, const SolverOptions& options = {}, Laplacian laplacian = Laplacian::graph);

  /// The vertices painted, their values still to come with `solve`.
  /// \param painted  (C,) vertices with a value, any order; a repeated one must be given equal values.
  /// \throws InputError   nothing painted, an index out of range (named with its place), an option out of range
  /// \throws SolverError  the factorisation failed
  HarmonicSolver(const Mesh& mesh, std::span<const Index> painted, const SolverOptions& options = {},
                 Laplacian laplacian = Laplacian::graph);

  ~HarmonicSolver();

  /// A new painting and its field; the report tells how much of the last one could be used. The result does not depend
  /// on what was painted before: direct in float64 it is the same bit for bit, else to the tolerance.
  /// \param painted  as above
  /// \param values   (C, k) finite, aligned with `painted`.
  /// \param source   (V,) finite, or empty: at free vertices mass⁻¹ K φ = source, so a positive source raises φ.
  ///                 Entries at painted vertices are not read.
  /// \throws InputError   a wrong length, a number that is not finite, one vertex with two values; names it. The last
  ///                      painting stays.
  /// \throws SolverError  the factorisation failed: nothing is painted then; or not converged. Another painting may do
  ///                      better. So it is with the CancelledError of options.cancel.
  Field paint(std::span<const Index> painted, const Eigen::Ref<const Eigen::MatrixXd>& values,
              std::span<const double> source = {});

  /// The field of other values, the painted vertices as they are. Arguments and errors as above.
  [[nodiscard]] Field solve(const Eigen::Ref<const Eigen::MatrixXd>& values, std::span<const double> source = {}) const;

  [[nodiscard]] Index vertex_count() const { return base_.vertices; }

  HarmonicSolver(const HarmonicSolver&) = delete;
  HarmonicSolver& operator=(const HarmonicSolver&) = delete;

 private:
  using Repeats = std::vector<std::array<Index, 2>>;
  void repaint(std::span<const Index> painted, Repeats repeats);
  void describe(const Stiffness& stiffness, const Defects& defects);
  void report_painting();
  void report_outside(const Outside& outside, SolveReport& report) const;
  [[nodiscard]] Field unchanged();
  [[nodiscard]] Block prescribe(const Eigen::Ref<const Eigen::MatrixXd>& values, std::span<const double> source,
                                const std::vector<int>& exponents) const;
  [[nodiscard]] Field compute(const Eigen::Ref<const Eigen::MatrixXd>& values, std::span<const double> source,
                              const Eigen::MatrixXd& guess) const;
  [[nodiscard]] Block start_from(const Eigen::MatrixXd& field, const std::vector<int>& exponents) const;
  void finish(const Eigen::Ref<const Eigen::MatrixXd>& values, const std::vector<int>& exponents, Block& x) const;

  std::unique_ptr<Solver> solver_;
  std::vector<Index> position_; ///< (V,) the row of every vertex
  std::vector<double> mass_;    ///< (V,) of every vertex
  bool maximum_principle_ = true;
  std::unique_ptr<FixedRows> rows_;
  std::unique_ptr<RegionSearch> regions_;    ///< of the free rows
  std::vector<Index> painted_;               ///< as given; empty while nothing is painted
  Repeats repeats_;                          ///< places of painted_ that name a vertex again, and where it stood first
  std::vector<std::string> mesh_warnings_;   ///< for every report
  std::vector<std::array<Index, 2>> obtuse_; ///< see DelaunayNotes
  SolveReport base_;                         ///< what does not depend on the values

  // The last painting, to tell what changed.
  Eigen::MatrixXd values_;
  std::vector<double> source_;
  Field last_;
  mutable std::shared_mutex mutex_;
};

/// The paper's square matrix for a painted set, (I − M) mass⁻¹ K + M. \throws InputError  as HarmonicSolver, and as
/// laplace_operator.
SparseMatrix dirichlet_laplacian(const Mesh& mesh, std::span<const Index> painted,
                                 Laplacian laplacian = Laplacian::graph);

} // namespace dirichlet
