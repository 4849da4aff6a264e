// SPDX-License-Identifier: GPL-3.0-or-later
// Any surface, damage, paint and levels: the laws hold, or a clear refusal.
#include "dirichlet/levels.h"
#include "laws.h"
#include "line_checks.h"

namespace dirichlet::fuzz {
namespace {

/// The levels asked for, and those of a range or of an area, where there is one.
std::vector<double> choose_levels(const Mesh& mesh, const Problem& problem, const std::vector<double>& values,
                                  const SolveReport& report) {
  std::vector<double> levels = problem.levels;
  const auto append = [&](const std::vector<double>& more) { levels.insert(levels.end(), more.begin(), more.end()); };
  if (problem.even > 0 && report.minimum < report.maximum)
    append(even_levels(report.minimum, report.maximum, problem.even));
  if (problem.equal > 0)
    expect_result_or_refusal([&] {
      const auto equal = equal_area_levels(mesh, values, problem.equal);
      EXPECT_TRUE(std::is_sorted(equal.begin(), equal.end()));
      EXPECT_EQ(equal.size(), at(problem.equal));
      append(equal);
    });
  return levels;
}

void solve_and_check(const Problem& problem) {
  const auto mesh = makers::make_mesh(problem.soup);
  const HarmonicSolver solver(*mesh, problem.painting.vertices, problem.options, problem.laplacian);
  const Field field = solver.solve(problem.painting.column(), problem.source);
  expect_lawful_field(*mesh, problem, field);

  const std::vector<double> values(field.values.data(), field.values.data() + field.values.size());
  const std::vector<double> levels = choose_levels(*mesh, problem, values, field.report);
  const Isolines lines = extract_isolines(*mesh, values, levels);
  expect_lawful(*mesh, lines, values, levels);
  expect_ends_where_lines_may_end(*mesh, lines, values, levels);
}

} // namespace
} // namespace dirichlet::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dirichlet::fuzz;
  const Problem problem = read_problem(Script({data, size}));
  expect_result_or_refusal([&] { solve_and_check(problem); });
  return 0;
}
