// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "dirichlet/error.h"
#include "fixed_rows.h"
#include "for_row.h"
#include "hand_out.h"
#include "index.h"
#include "memory.h"
#include "message.h"
#include "painting_checks.h"
#include "parallel.h"
#include "region_search.h"
#include "stopwatch.h"
#include "twin.h"

namespace dirichlet {
namespace {

/// The power of two to divide numbers by whose squares and sums would else be a danger; 0 for ordinary ones. Huge ones
/// stay as large as they may, since others beside them, on another piece, may be tiny.
int scale_of(double largest) {
  constexpr int kSafe = 256;
  int exponent = 0;
  std::frexp(largest, &exponent);
  if (exponent > kSafe) return exponent - kSafe;
  return exponent < -kSafe ? exponent : 0;
}

int scale_of(const Eigen::Ref<const Eigen::VectorXd>& values, std::span<const double> source) {
  double largest = values.cwiseAbs().maxCoeff();
  for (const double s : source) largest = std::max(largest, std::abs(s));
  return scale_of(largest);
}

/// Brings what reaches the free rows to a range where it has norms: it may be far below the numbers it came from.
/// \returns  the power of two every column was divided by there
std::vector<int> scale_free_rows(const Mask& fixed, Block& rhs) {
  const auto n = static_cast<Index>(rhs.rows());
  std::vector<int> exponents;
  for (auto column : rhs.colwise()) {
    double largest = 0;
    for (Index row = 0; row < n; ++row)
      if (fixed[at(row)] == 0) largest = std::max(largest, std::abs(column[row]));
    const int exponent = scale_of(largest);
    exponents.push_back(exponent);
    for (Index row = 0; row < n && exponent != 0; ++row)
      if (fixed[at(row)] == 0) column[row] = std::ldexp(column[row], -exponent);
  }
  return exponents;
}

/// What the columns of an exact solution may be off by.
/// \param exponents  0 where fixed rows are in the scale of the free ones, which else are taken for exact
Eigen::ArrayXd rounding_of(const Block& x, const std::vector<int>& exponents) {
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  Eigen::ArrayXd rounding = x.cwiseAbs().colwise().maxCoeff().transpose() * kRounding;
  for (std::size_t c = 0; c < exponents.size(); ++c)
    if (exponents[c] != 0) rounding[static_cast<Eigen::Index>(c)] = 0;
  return rounding;
}

/// \param options  handed through: for a constructor that has to check before it delegates
SolverOptions checked(const Mesh& mesh, std::span<const Index> painted, const SolverOptions& options) {
  check_painted(mesh.vertex_count(), painted);
  return options;
}

[[noreturn]] void refuse_infinite(const Eigen::MatrixXd& values, bool harmonic) {
  if (!harmonic) throw SolverError("the source lifts the field beyond the largest number; scale it down");
  Eigen::Index vertex = 0;
  while (vertex + 1 < values.rows() && !values.row(vertex).array().isInf().any()) ++vertex;
  throw SolverError(message("the field leaves the painted range beyond the largest number at vertex ", vertex,
                            "; with the intrinsic Delaunay Laplacian it would not leave it"));
}

double scaled(double x, int exponent) {
  return exponent == 0 ? x : std::ldexp(x, exponent);
}

/// Bit for bit: -0 is not 0.
bool same(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

bool same(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::MatrixXd& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return false;
  const auto column = [rows = at(static_cast<Index>(a.rows()))](const auto& matrix, Eigen::Index k) {
    return std::span<const double>(matrix.col(k).data(), rows);
  };
  for (Eigen::Index k = 0; k < a.cols(); ++k)
    if (!same(column(a, k), column(b, k))) return false;
  return true;
}

} // namespace

HarmonicSolver::HarmonicSolver(const Mesh& mesh, const SolverOptions& options, Laplacian laplacian) {
  base_.vertices = mesh.vertex_count();
  base_.connectivity_seconds = mesh.build_seconds();
  with_memory(base_.vertices, [&] {
    const Stopwatch watch;
    auto inspection = in_background(at(base_.vertices), [&mesh] {
      Components pieces = mesh.components();
      const Defects defects = find_defects(mesh, pieces);
      return std::pair(std::move(pieces), defects);
    });
    Stiffness stiffness = make_stiffness(mesh, laplacian);
    base_.laplacian_seconds = watch.seconds();
    mass_ = std::move(stiffness.mass);
    solver_ = make_solver(std::move(stiffness.K), options);
    constexpr Index kLarge = 500'000; // whose analysis took about as much as the factor is going to
    if (solver_->statistics().method == Method::direct && base_.vertices >= kLarge) return_freed_memory();
    const std::span<const Index> order = solver_->order();
    position_.resize(order.size());
    for (std::size_t row = 0; row < order.size(); ++row) position_[at(order[row])] = static_cast<Index>(row);
    const auto [pieces, defects] = inspection.get();
    describe(stiffness, defects);
    rows_ = std::make_unique<FixedRows>(pieces, order);
  });
  const SolverStatistics& statistics = solver_->statistics();
  base_.method = statistics.method;
  base_.nonzeros = statistics.nonzeros;
  base_.factor_nonzeros = statistics.factor_nonzeros;
  base_.analysis_seconds = statistics.analysis_seconds;
  if (statistics.weak_links)
    mesh_warnings_.push_back(message(
        "some weights are over 1e8 times others, as across very thin faces, and the field may have lost as many "
        "digits; ",
        maximum_principle_ ? "the direct method in float64 loses none"
                           : "with the intrinsic Delaunay Laplacian the direct method in float64 loses none",
        options.method == Method::automatic && base_.method == Method::multigrid
            ? ", but takes more than the memory budget"
            : ""));
  if (const auto budget = options.memory_budget.value_or(default_memory_budget()); statistics.factor_bytes > budget)
    mesh_warnings_.push_back(message("the direct method takes ", in_bytes(statistics.factor_bytes),
                                     " for its factor, more than the memory budget of ", in_bytes(budget),
                                     "; multigrid takes less"));
}

HarmonicSolver::HarmonicSolver(const Mesh& mesh, std::span<const Index> painted, const SolverOptions& options,
                               Laplacian laplacian)
    : HarmonicSolver(mesh, checked(mesh, painted, options), laplacian) {
  with_memory(base_.vertices, [&] { repaint(painted, find_repeats(base_.vertices, painted)); });
}

HarmonicSolver::~HarmonicSolver() = default;

void HarmonicSolver::describe(const Stiffness& stiffness, const Defects& defects) {
  maximum_principle_ = stiffness.maximum_principle;
  base_.laplacian = stiffness.laplacian;
  base_.reason = stiffness.reason;
  base_.flat_faces = defects.flat_faces;
  mesh_warnings_ = defects.warnings();
  for (std::string& told : stiffness.delaunay.warnings()) mesh_warnings_.push_back(std::move(told));
  obtuse_ = stiffness.delaunay.obtuse;
}

/// Brings mask, factor and regions up to a painting that was checked.
void HarmonicSolver::repaint(std::span<const Index> painted, Repeats repeats) {
  Stopwatch watch;
  std::vector<Index> rows(painted.size());
  for (std::size_t c = 0; c < rows.size(); ++c) rows[c] = position_[at(painted[c])];
  painted_.clear(); // until all is done: a failure leaves nothing painted
  if (rows_->paint(rows) || !regions_) {
    regions_.reset(); // before the next takes its memory
    regions_ = std::make_unique<RegionSearch>(solver_->matrix(), rows_->fixed());
  }
  base_.injection_seconds = watch.restart();
  base_.repeated = solver_->inject(rows_->fixed());
  base_.factor_seconds = watch.restart();
  base_.update = base_.repeated == 0 ? Update::values : base_.repeated < 1 ? Update::partial : Update::full;
  report_painting();
  repeats_ = std::move(repeats);
  painted_.assign(painted.begin(), painted.end());
}

void HarmonicSolver::report_painting() {
  base_.painted = rows_->painted_count();
  base_.undefined = rows_->undefined_count();
  base_.unknowns = rows_->free_count();
  base_.first_undefined = -1;
  base_.warnings = mesh_warnings_;
  const auto is_free = [this](Index v) { return rows_->fixed()[at(position_[at(v)])] == 0; };
  const auto free_edges = static_cast<Index>(
      std::ranges::count_if(obtuse_, [&](const auto& ends) { return is_free(ends[0]) || is_free(ends[1]); }));
  if (free_edges > 0)
    base_.warnings.push_back(
        message(counted(free_edges, "border edge"), free_edges == 1 ? " that is" : " that are",
                " not painted and opposite to an angle of more than 135 degrees would have ",
                free_edges == 1 ? "a negative weight" : "negative weights",
                ", which the intrinsic Delaunay Laplacian leaves out: the field along there may be off by percents"));
  if (base_.undefined == 0) return;
  while (!rows_->is_undefined(position_[at(++base_.first_undefined)])) {
  }
  base_.warnings.push_back(
      message(base_.undefined, base_.undefined == 1 ? " vertex lies on a piece" : " vertices lie on pieces",
              " without paint, where the field has no value; the first is vertex ", base_.first_undefined));
}

Field HarmonicSolver::paint(std::span<const Index> painted, const Eigen::Ref<const Eigen::MatrixXd>& values,
                            std::span<const double> source) {
  const std::unique_lock lock(mutex_);
  return with_memory(base_.vertices, [&] {
    check_painted(base_.vertices, painted);
    auto repeats = find_repeats(base_.vertices, painted);
    check_values(painted, repeats, values);
    check_source(base_.vertices, source);
    if (std::ranges::equal(painted, painted_) && same(source, source_) && same(values, values_)) return unchanged();
    values_.resize(0, 0); // until all is done, the last painting is none to compare with
    repaint(painted, std::move(repeats));
    if (base_.method != Method::multigrid) last_ = {}; // where an iteration would start; else it is only in the way
    last_ = compute(values, source, last_.values);
    source_.assign(source.begin(), source.end());
    values_ = values;
    base_.connectivity_seconds = base_.laplacian_seconds = base_.analysis_seconds = 0; // once per mesh
    return last_;
  });
}

Field HarmonicSolver::unchanged() {
  SolveReport& report = last_.report;
  report.update = Update::nothing;
  report.repeated = report.injection_seconds = report.factor_seconds = report.solve_seconds = 0;
  report.connectivity_seconds = report.laplacian_seconds = report.analysis_seconds = 0;
  return last_;
}

Field HarmonicSolver::solve(const Eigen::Ref<const Eigen::MatrixXd>& values, std::span<const double> source) const {
  const std::shared_lock lock(mutex_);
  return with_memory(base_.vertices, [&] {
    if (painted_.empty()) throw InputError("no vertex is painted yet, or the last painting failed");
    check_values(painted_, repeats_, values);
    check_source(base_.vertices, source);
    return compute(values, source, {});
  });
}

/// (n, k): the values where painted, source times mass where free; divided by the power of two of their column.
Block HarmonicSolver::prescribe(const Eigen::Ref<const Eigen::MatrixXd>& values, std::span<const double> source,
                                const std::vector<int>& exponents) const {
  Block prescribed = Block::Zero(base_.vertices, values.cols());
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    const int exponent = -exponents[static_cast<std::size_t>(k)];
    if (!source.empty())
      for (Index row = 0; row < base_.vertices; ++row)
        if (const auto v = at(solver_->order()[at(row)]); rows_->fixed()[at(row)] == 0)
          prescribed(row, k) = mass_[v] * scaled(source[v], exponent);
    for (std::size_t c = 0; c < painted_.size(); ++c)
      prescribed(position_[at(painted_[c])], k) = scaled(values(static_cast<Eigen::Index>(c), k), exponent);
  }
  return prescribed;
}

/// \param guess  (V, k) the last field, or anything of another shape
Field HarmonicSolver::compute(const Eigen::Ref<const Eigen::MatrixXd>& values, std::span<const double> source,
                              const Eigen::MatrixXd& guess) const {
  const Stopwatch watch;
  Field field{{}, base_};
  SolveReport& report = field.report;
  std::vector<int> exponents;
  for (const auto column : values.colwise()) exponents.push_back(scale_of(column, source));

  Block rhs = inject_right_hand_side(solver_->matrix(), rows_->fixed(), prescribe(values, source, exponents));
  const std::vector<int> more = scale_free_rows(rows_->fixed(), rhs);
  std::ranges::transform(exponents, more, exponents.begin(), std::plus<>{});
  Block x;
  if (report.method == Method::multigrid && guess.rows() == rhs.rows() && guess.cols() == rhs.cols())
    x = start_from(guess, exponents);
  report.iterations = solver_->solve(rhs, x);
  const bool exact = solver_->statistics().sums_pivots && report.iterations == 0 && maximum_principle_;
  report.relative_residual = relative_residual(solver_->matrix(), rows_->fixed(), rhs, x,
                                               exact ? rounding_of(x, more) : Eigen::ArrayXd::Zero(x.cols()));
  if (!std::isfinite(report.relative_residual))
    throw SolverError("the solver returned a value that is not finite; another method may do better");
  constexpr double kGood = 1e-8; // what a field of single precision does not see
  if (report.relative_residual > kGood)
    report.warnings.push_back(
        message("the field holds to its equations only to a relative residual of ", roughly(report.relative_residual),
                ": the tolerance is no smaller, or weights differ too much in size, as where faces are very thin"));
  rhs.resize(0, 0); // before the field takes its memory
  finish(values, exponents, x);
  std::optional<PaintedRanges> ranges;
  if (source.empty()) ranges.emplace(regions_->result(), x, maximum_principle_);
  const FieldRange range = hand_out(x, solver_->order(), *rows_, ranges ? &*ranges : nullptr, field.values);
  if (!std::isfinite(range.minimum) || !std::isfinite(range.maximum)) refuse_infinite(field.values, source.empty());
  report.minimum = range.minimum + 0.0; // 0 for -0: of equal ones, any thread's may come first
  report.maximum = range.maximum + 0.0;
  report.painted_minimum = values.minCoeff();
  report.painted_maximum = values.maxCoeff();
  report_outside(range.outside, report);
  for (const auto column : values.colwise())
    if (source.empty() && column.minCoeff() == column.maxCoeff())
      report.warnings.push_back(message("every painted value is ", column[0], ", so the field is constant"));
  report.solve_seconds = watch.seconds();
  return field;
}

void HarmonicSolver::report_outside(const Outside& outside, SolveReport& report) const {
  report.outside = outside.count;
  report.farthest_outside = outside.farthest;
  constexpr double kVisible = 1e-9; // of a range: what an iteration's tolerance may leave is not said
  if (maximum_principle_ || outside.share <= kVisible) return;
  report.warnings.push_back(message(outside.count, outside.count == 1 ? " value lies" : " values lie",
                                    " outside the painted range, by up to ", outside.farthest,
                                    "; with the intrinsic Delaunay Laplacian none would"));
}

/// The free rows as the last field had them: where an iteration starts.
Block HarmonicSolver::start_from(const Eigen::MatrixXd& field, const std::vector<int>& exponents) const {
  Block x = Block::Zero(field.rows(), field.cols());
  for (Index row = 0; row < base_.vertices; ++row)
    for (Eigen::Index k = 0; k < x.cols(); ++k)
      if (const double last = field(solver_->order()[at(row)], k); rows_->fixed()[at(row)] == 0 && std::isfinite(last))
        x(row, k) = scaled(last, -exponents[static_cast<std::size_t>(k)]);
  return x;
}

/// A solution back in its scale, and with the painted values bit for bit.
void HarmonicSolver::finish(const Eigen::Ref<const Eigen::MatrixXd>& values, const std::vector<int>& exponents,
                            Block& x) const {
  for (Eigen::Index k = 0; k < x.cols(); ++k) {
    auto column = x.col(k);
    if (const int exponent = exponents[static_cast<std::size_t>(k)]; exponent != 0)
      for (double& number : column) number = std::ldexp(number, exponent);
    for (std::size_t c = 0; c < painted_.size(); ++c)
      column[position_[at(painted_[c])]] = values(static_cast<Eigen::Index>(c), k);
  }
}

SparseMatrix dirichlet_laplacian(const Mesh& mesh, std::span<const Index> painted, Laplacian laplacian) {
  check_painted(mesh.vertex_count(), painted);
  Mask mask(at(mesh.vertex_count()), 0);
  for (const Index v : painted) mask[at(v)] = 1;
  return inject(laplace_operator(make_stiffness(mesh, laplacian)), mask);
}

} // namespace dirichlet
