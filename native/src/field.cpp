// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dirichlet/error.h"
#include "for_row.h"
#include "message.h"
#include "stopwatch.h"

namespace dirichlet {
namespace {

using Column = Eigen::Ref<Eigen::VectorXd>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

/// 1 at every painted vertex.
Mask paint(Index vertex_count, std::span<const Index> painted) {
  if (painted.empty()) throw InputError("no vertex is painted, so the field has no values to start from");
  const auto bad = [=](Index v) { return v < 0 || v >= vertex_count; };
  const auto first = std::find_if(painted.begin(), painted.end(), bad);
  if (first != painted.end())
    throw InputError(message("painted vertex ", *first, " (at place ", first - painted.begin(),
                             ") is not one of the vertices 0 to ", vertex_count - 1,
                             and_more(std::count_if(first, painted.end(), bad) - 1, "place")));
  Mask mask(at(vertex_count), 0);
  for (const Index v : painted) mask[at(v)] = 1;
  return mask;
}

std::vector<std::array<Index, 2>> find_repeats(std::span<const Index> painted, Index painted_count, Index n) {
  std::vector<std::array<Index, 2>> repeats;
  if (painted_count == static_cast<Index>(painted.size())) return repeats;
  std::vector<Index> first(at(n), -1);
  for (Index c = 0; c < static_cast<Index>(painted.size()); ++c) {
    Index& place = first[at(painted[at(c)])];
    if (place < 0)
      place = c;
    else
      repeats.push_back({c, place});
  }
  return repeats;
}

template <class Numbers>
void check_finite(const Numbers& numbers, const char* what, const char* where) {
  const auto bad = [](double x) { return !std::isfinite(x); };
  const auto first = std::find_if(numbers.begin(), numbers.end(), bad);
  if (first != numbers.end())
    throw InputError(message(what, " at ", where, ' ', first - numbers.begin(), " is ", *first,
                             and_more(std::count_if(first, numbers.end(), bad) - 1, where)));
}

/// The power of two that brings the largest number of a column to [1/2, 1), so that no sum can overflow; exact to undo.
int scale_of(const Column& column) {
  int exponent = 0;
  std::frexp(column.cwiseAbs().maxCoeff(), &exponent);
  return exponent;
}

void scale(Column column, int exponent) {
  for (double& x : column) x = std::ldexp(x, exponent);
}

/// ‖rhs − Kφ‖ / ‖rhs‖ over the rows that have an equation; rhs is what the known vertices and the source contribute.
double relative_residual(const SparseMatrix& K, const Mask& fixed, const Eigen::VectorXd& prescribed,
                         const Eigen::VectorXd& x) {
  double residual = 0, norm = 0;
  for (Index i = 0; i < K.rows(); ++i) {
    if (fixed[at(i)] != 0) continue;
    double rhs = prescribed[i], product = 0;
    for_row(K, i, [&](Index j, double k) {
      if (fixed[at(j)] != 0)
        rhs -= k * prescribed[j];
      else
        product += k * x[j];
    });
    residual += (rhs - product) * (rhs - product);
    norm += rhs * rhs;
  }
  return norm > 0 ? std::sqrt(residual / norm) : std::sqrt(residual);
}

/// The maximum principle, region by region: no value leaves the range painted at the rim. Rounding may, by an ulp, and
/// an isoline at exactly that value would be noise.
void project(const FreeRegions& regions, Column values, SolveReport& report) {
  std::vector<std::array<double, 2>> range(at(regions.count), {kInfinity, -kInfinity});
  for (const auto& [region, vertex] : regions.rim) {
    auto& [low, high] = range[at(region)];
    low = std::min(low, values[vertex]);
    high = std::max(high, values[vertex]);
  }
  for (Index i = 0; i < values.size(); ++i) {
    const Index region = regions.label[at(i)];
    if (region == FreeRegions::kPainted) continue;
    const auto& [low, high] = range[at(region)];
    if (low > high) continue; // no paint, no range
    const double inside = std::clamp(values[i], low, high);
    if (inside == values[i]) continue;
    ++report.outside;
    report.farthest_outside = std::max(report.farthest_outside, std::abs(values[i] - inside));
    values[i] = inside;
  }
}

/// Takes one finished column, still without its NaN, into the report.
void report_column(const Eigen::VectorXd& values, const FreeRegions& regions, const Mask& fixed, SolveReport& report) {
  for (Index i = 0; i < values.size(); ++i) {
    if (fixed[at(i)] != 0 && regions.label[at(i)] != FreeRegions::kPainted) continue; // undefined
    report.minimum = std::min(report.minimum, values[i]);
    report.maximum = std::max(report.maximum, values[i]);
  }
}

} // namespace

HarmonicSolver::HarmonicSolver(const Mesh& mesh, std::span<const Index> painted, const SolverOptions& options)
    : painted_(painted.begin(), painted.end()), fixed_(paint(mesh.vertex_count(), painted)) {
  base_.vertices = mesh.vertex_count();
  base_.painted = static_cast<Index>(std::count(fixed_.begin(), fixed_.end(), 1));
  base_.connectivity_seconds = mesh.build_seconds();
  repeats_ = find_repeats(painted_, base_.painted, base_.vertices);

  Stopwatch watch;
  stiffness_ = graph_stiffness(mesh);
  base_.laplacian_seconds = watch.restart();

  regions_ = free_regions(stiffness_, fixed_);
  std::vector<std::uint8_t> ruled(at(regions_.count), 0);
  for (const auto& [region, vertex] : regions_.rim) ruled[at(region)] = 1;
  for (Index i = 0; i < base_.vertices; ++i) {
    const Index region = regions_.label[at(i)];
    if (region == FreeRegions::kPainted || ruled[at(region)] != 0) continue;
    fixed_[at(i)] = 1; // singular otherwise; its value becomes NaN
    if (base_.undefined++ == 0) base_.first_undefined = i;
  }
  const double regions_seconds = watch.seconds();

  solver_ = make_solver(stiffness_, fixed_, options);
  const SolverStatistics& statistics = solver_->statistics();
  base_.unknowns = statistics.unknowns;
  base_.nonzeros = statistics.nonzeros;
  base_.factor_nonzeros = statistics.factor_nonzeros;
  base_.injection_seconds = regions_seconds + statistics.inject_seconds;
  base_.factor_seconds = statistics.factor_seconds;
  if (base_.undefined > 0)
    base_.warnings.push_back(message(base_.undefined, base_.undefined == 1 ? " vertex lies" : " vertices lie",
                                     " on pieces without paint and has no value; the first is vertex ",
                                     base_.first_undefined));
}

Eigen::MatrixXd HarmonicSolver::prescribe(const Eigen::Ref<const Eigen::MatrixXd>& values,
                                          std::span<const double> source) const {
  if (values.cols() < 1) throw InputError("no column of values was given");
  if (values.rows() != painted_count())
    throw InputError(message(values.rows(), " values were given for ", painted_count(), " painted vertices"));
  for (Eigen::Index column = 0; column < values.cols(); ++column)
    check_finite(std::span(values.col(column).data(), painted_.size()), "the painted value", "place");
  for (const auto& [again, first] : repeats_)
    if (values.row(again) != values.row(first))
      throw InputError(message("vertex ", painted_[at(again)], " is painted with ", values(first, 0), " (at place ",
                               first, ") and with ", values(again, 0), " (at place ", again, ")"));
  if (!source.empty() && source.size() != at(vertex_count()))
    throw InputError(message("a source of ", source.size(), " numbers does not fit ", vertex_count(), " vertices"));
  check_finite(source, "the source", "vertex");

  Eigen::MatrixXd prescribed = Eigen::MatrixXd::Zero(vertex_count(), values.cols());
  if (!source.empty()) {
    const Eigen::VectorXd mass = stiffness_.diagonal();
    for (Index i = 0; i < vertex_count(); ++i)
      if (fixed_[at(i)] == 0) prescribed.row(i).setConstant(mass[i] * source[at(i)]);
  }
  for (Index c = 0; c < painted_count(); ++c) prescribed.row(painted_[at(c)]) = values.row(c);
  return prescribed;
}

Field HarmonicSolver::solve(const Eigen::Ref<const Eigen::MatrixXd>& values, std::span<const double> source) const {
  const Stopwatch watch;
  Field field{{}, base_};
  SolveReport& report = field.report;
  Eigen::MatrixXd prescribed = prescribe(values, source);
  report.painted_minimum = values.minCoeff();
  report.painted_maximum = values.maxCoeff();

  std::vector<int> exponents;
  for (auto column : prescribed.colwise()) {
    exponents.push_back(scale_of(column));
    scale(column, -exponents.back());
  }
  field.values = solver_->solve(prescribed, report.iterations);
  if (!field.values.allFinite()) throw SolverError("the solver returned a value that is not finite");

  report.minimum = kInfinity;
  report.maximum = -kInfinity;
  for (Eigen::Index k = 0; k < field.values.cols(); ++k) {
    auto column = field.values.col(k);
    report.relative_residual =
        std::max(report.relative_residual, relative_residual(stiffness_, fixed_, prescribed.col(k), column));
    scale(column, exponents[static_cast<std::size_t>(k)]);
    for (Index c = 0; c < painted_count(); ++c) column[painted_[at(c)]] = values(c, k);
    if (source.empty()) project(regions_, column, report);
    report_column(column, regions_, fixed_, report);
    if (source.empty() && values.col(k).minCoeff() == values.col(k).maxCoeff())
      report.warnings.push_back(message("every painted value is ", values(0, k), ", so the field is constant"));
  }
  for (Index i = 0; i < vertex_count() && report.undefined > 0; ++i)
    if (fixed_[at(i)] != 0 && regions_.label[at(i)] != FreeRegions::kPainted)
      field.values.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
  report.solve_seconds = watch.seconds();
  return field;
}

SparseMatrix dirichlet_laplacian(const Mesh& mesh, std::span<const Index> painted) {
  return inject(random_walk(graph_stiffness(mesh)), paint(mesh.vertex_count(), painted));
}

} // namespace dirichlet
