// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/cancel.h"

#include <array>
#include <chrono>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "dirichlet/field.h"
#include "dirichlet/geodesic.h"
#include "dirichlet/isolines.h"
#include "dirichlet/levels.h"
#include "dirichlet/line_shaping.h"
#include "mesh_makers.h"
#include "refusal.h"
#include "solver/ordering.h"

namespace dirichlet {
namespace {

using makers::make_mesh;

const std::vector<Index> kPainted{0, 77};
const Eigen::MatrixXd kValues = Eigen::Vector2d(0, 1);

SolverOptions with(const CancelToken& cancel, Method method, Precision precision = Precision::float64) {
  SolverOptions options;
  options.method = method;
  options.precision = precision;
  options.cancel = cancel;
  return options;
}

TEST(CancelToken, is_raised_for_all_its_copies_until_it_is_lowered) {
  const CancelToken token, other;
  const std::vector copies(2, token);
  token.check();
  copies[0].cancel();
  EXPECT_TRUE(token.is_cancelled());
  EXPECT_REFUSED(token.check(), CancelledError, "cancelled");
  other.check();
  token.reset();
  copies[1].check();
}

TEST(CancelToken, stops_every_part_of_every_solver_which_is_as_good_as_new_afterwards) {
  const auto mesh = make_mesh(makers::torus(60, 40));
  for (const auto& [method, precision] : {std::pair{Method::direct, Precision::float64},
                                          {Method::direct, Precision::float32},
                                          {Method::multigrid, Precision::float64},
                                          {Method::least_squares_cg, Precision::float64}}) {
    const CancelToken token;
    const SolverOptions options = with(token, method, precision);
    HarmonicSolver solver(*mesh, options);
    const Field expected = solver.paint(kPainted, kValues);
    token.cancel();
    EXPECT_REFUSED(HarmonicSolver(*mesh, options), CancelledError, "cancelled");
    EXPECT_REFUSED(solver.solve(2 * kValues), CancelledError, "cancelled");
    EXPECT_REFUSED(solver.paint(std::vector<Index>{5, 9}, kValues), CancelledError, "cancelled");
    token.reset();
    EXPECT_REFUSED(solver.solve(kValues), InputError, "no vertex is painted");
    const Field again = solver.paint(kPainted, kValues);
    EXPECT_EQ(again.report.update, Update::full);
    EXPECT_TRUE(method != Method::direct || again.values == expected.values);
    EXPECT_TRUE(again.values.isApprox(expected.values, 1e-7));
    EXPECT_EQ(solver.solve(kValues).values.rows(), mesh->vertex_count());
  }
}

TEST(CancelToken, stops_an_order_that_is_looked_for) {
  const auto mesh = make_mesh(makers::torus(60, 40));
  const SparseMatrix K = graph_stiffness(*mesh);
  const CancelToken token;
  token.cancel();
  const std::span offsets(K.outerIndexPtr(), static_cast<std::size_t>(K.rows()) + 1);
  const std::span neighbours(K.innerIndexPtr(), static_cast<std::size_t>(K.nonZeros()));
  EXPECT_REFUSED(fill_reducing_order(offsets, neighbours, 2, token), CancelledError, "cancelled");
}

TEST(CancelToken, raised_by_another_thread_stops_work_that_has_begun) {
  const auto mesh = make_mesh(makers::torus(200, 150));
  const CancelToken token;
  HarmonicSolver solver(*mesh, with(token, Method::direct));
  std::atomic<int> painted{0};
  std::thread other([&] {
    while (painted < 2) std::this_thread::yield();
    token.cancel();
  });
  const auto paint_on = [&] { // until it is stopped, wherever it is
    for (Index v = 0;; ++v) {
      solver.paint(std::vector<Index>{v % 30'000, (v + 999) % 30'000}, kValues);
      ++painted;
    }
  };
  EXPECT_REFUSED(paint_on(), CancelledError, "cancelled");
  other.join();
  token.reset();
  EXPECT_EQ(solver.paint(kPainted, kValues).values, HarmonicSolver(*mesh).paint(kPainted, kValues).values);
}

TEST(CancelToken, raised_by_another_thread_stops_conjugate_gradients_between_two_steps) {
  const auto mesh = make_mesh(makers::torus(60, 40));
  const CancelToken token;
  SolverOptions options = with(token, Method::least_squares_cg);
  options.tolerance = 1e-200; // out of reach: left alone, it would give up after the last step
  options.max_iterations = 200'000;
  HarmonicSolver solver(*mesh, options);
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    token.cancel();
  });
  EXPECT_REFUSED(solver.paint(kPainted, kValues), CancelledError, "cancelled");
  other.join();
}

/// x at every vertex of the mesh.
std::vector<double> ramp(const Mesh& mesh) {
  std::vector<double> field;
  for (Index v = 0; v < mesh.vertex_count(); ++v) field.push_back(mesh.positions()[3 * static_cast<std::size_t>(v)]);
  return field;
}

TEST(CancelToken, stops_all_that_can_take_long_with_lines_and_leaves_no_trace) {
  const auto mesh = make_mesh(makers::torus(60, 40));
  const auto field = ramp(*mesh);
  const std::vector<double> levels = even_levels(-2, 2, 9);
  const Isolines lines = extract_isolines(*mesh, field, levels);
  const std::array<double, 3> point{2, 0, 0.7};
  const CancelToken token;
  token.cancel();
  EXPECT_REFUSED(extract_isolines(*mesh, field, levels, token), CancelledError, "cancelled");
  EXPECT_REFUSED(smooth_lines(*mesh, lines, 3, token), CancelledError, "cancelled");
  EXPECT_REFUSED(simplify_lines(lines, 0.1, token), CancelledError, "cancelled");
  EXPECT_REFUSED(resample_lines(lines, 0.1, token), CancelledError, "cancelled");
  EXPECT_REFUSED(equal_area_levels(*mesh, field, 9, {}, {}, token), CancelledError, "cancelled");
  EXPECT_REFUSED(equal_distance_levels(*mesh, field, 9, {}, {}, token), CancelledError, "cancelled");
  EXPECT_REFUSED(geodesic_disc(*mesh, point, 1, {}, token), CancelledError, "cancelled");
  token.reset();
  EXPECT_EQ(extract_isolines(*mesh, field, levels, token).points, lines.points);
  EXPECT_EQ(smooth_lines(*mesh, lines, 3, token).points, smooth_lines(*mesh, lines, 3).points);
  EXPECT_EQ(simplify_lines(lines, 0.1, token).points, simplify_lines(lines, 0.1).points);
  EXPECT_EQ(resample_lines(lines, 0.1, token).points, resample_lines(lines, 0.1).points);
  EXPECT_EQ(equal_area_levels(*mesh, field, 9, {}, {}, token), equal_area_levels(*mesh, field, 9));
  EXPECT_EQ(equal_distance_levels(*mesh, field, 9, {}, {}, token), equal_distance_levels(*mesh, field, 9));
  EXPECT_EQ(geodesic_disc(*mesh, point, 1, {}, token).vertices, geodesic_disc(*mesh, point, 1).vertices);
}

/// Has another thread raise the token while `work`, which left alone would take minutes, is going on.
template <class Work>
void expect_stopped_on_its_way(const CancelToken& token, const Work& work) {
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    token.cancel();
  });
  EXPECT_REFUSED(work(), CancelledError, "cancelled");
  other.join();
  token.reset();
}

TEST(CancelToken, raised_by_another_thread_stops_a_single_long_line_between_two_steps) {
  constexpr Index kPoints = 200'000;
  const auto strip = make_mesh(makers::grid(kPoints, 1));
  std::vector<double> height;
  for (Index v = 0; v < strip->vertex_count(); ++v)
    height.push_back(strip->positions()[3 * static_cast<std::size_t>(v) + 1]);
  Isolines line = extract_isolines(*strip, height, std::vector<double>{0.5});
  ASSERT_EQ(line.closed.size(), 1U);
  const CancelToken token;
  expect_stopped_on_its_way(token, [&] { return smooth_lines(*strip, line, 10'000, token); });
  // An arc of which the part to look at loses a point or two each time: a spiral that turns ever closer.
  for (std::size_t i = 0; 3 * i < line.points.size(); ++i) {
    const double turn = 3.0 * static_cast<double>(i), radius = std::exp(-1e-4 * static_cast<double>(i));
    line.points[3 * i] = radius * std::cos(turn);
    line.points[3 * i + 1] = radius * std::sin(turn);
  }
  expect_stopped_on_its_way(token, [&] { return simplify_lines(line, 0, token); });
}

TEST(CancelToken, raised_by_another_thread_stops_tracing_between_two_triangles) {
  const auto mesh = make_mesh(makers::torus(400, 300));
  const auto field = ramp(*mesh);
  const std::vector<double> levels = even_levels(-2.7, 2.7, 999);
  const CancelToken token;
  expect_stopped_on_its_way(token, [&] {
    for (;;) extract_isolines(*mesh, field, levels, token);
  });
  expect_stopped_on_its_way(token, [&] {
    for (;;) equal_area_levels(*mesh, field, 999, {}, {}, token);
  });
}

} // namespace
} // namespace dirichlet
