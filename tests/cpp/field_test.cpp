// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/field.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "mesh_makers.h"
#include "parallel.h"
#include "refusal.h"

namespace dirichlet {
namespace {

using makers::make_mesh;

Eigen::VectorXd column(std::initializer_list<double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

Eigen::VectorXd solve(const Mesh& mesh, const std::vector<Index>& painted, const Eigen::VectorXd& values,
                      Method method = Method::direct) {
  SolverOptions options;
  options.method = method;
  return HarmonicSolver(mesh, painted, options).solve(values).values.col(0);
}

/// A mesh and a painting with nothing regular about them.
struct Painting {
  std::unique_ptr<Mesh> mesh = make_mesh(makers::torus(23, 17));
  std::vector<Index> painted;
  Eigen::VectorXd values;
  explicit Painting(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Index> vertices(static_cast<std::size_t>(mesh->vertex_count()));
    std::iota(vertices.begin(), vertices.end(), 0);
    std::shuffle(vertices.begin(), vertices.end(), random);
    painted.assign(vertices.begin(), vertices.begin() + 40);
    values = Eigen::VectorXd::NullaryExpr(40, [&] { return std::uniform_real_distribution<double>(-3, 5)(random); });
  }
};

TEST(Field, painted_values_come_back_bit_for_bit) {
  for (const Method method : {Method::direct, Method::least_squares_cg}) {
    Painting p(1);
    p.values[3] = -0.0;
    p.values[4] = 5e-324;
    const Eigen::VectorXd field = solve(*p.mesh, p.painted, p.values, method);
    for (std::size_t c = 0; c < p.painted.size(); ++c)
      EXPECT_EQ(std::memcmp(&field[p.painted[c]], &p.values[static_cast<Eigen::Index>(c)], sizeof(double)), 0);
  }
}

TEST(Field, a_free_vertex_has_the_mean_of_its_neighbours) {
  const Painting p(2);
  const Field field = HarmonicSolver(*p.mesh, p.painted).solve(p.values);
  EXPECT_LE(field.report.relative_residual, 1e-13);
  Eigen::VectorXd residual = random_walk(graph_stiffness(*p.mesh)) * field.values.col(0);
  for (const Index v : p.painted) residual[v] = 0;
  EXPECT_LE(residual.cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Field, stays_within_the_painted_range) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Painting p(seed);
    const Eigen::VectorXd field = solve(*p.mesh, p.painted, p.values);
    EXPECT_GE(field.minCoeff(), p.values.minCoeff());
    EXPECT_LE(field.maxCoeff(), p.values.maxCoeff());
  }
}

TEST(Field, direct_and_least_squares_agree) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Painting p(seed);
    const Eigen::VectorXd direct = solve(*p.mesh, p.painted, p.values);
    const Eigen::VectorXd reference = solve(*p.mesh, p.painted, p.values, Method::least_squares_cg);
    EXPECT_LE((direct - reference).cwiseAbs().maxCoeff(), 1e-8 * direct.cwiseAbs().maxCoeff());
  }
}

TEST(Field, indicator_fields_are_non_negative_and_sum_to_one) {
  const Painting p(3);
  const Eigen::MatrixXd indicators = Eigen::MatrixXd::Identity(40, 40);
  const Eigen::MatrixXd fields = HarmonicSolver(*p.mesh, p.painted).solve(indicators).values;
  EXPECT_GE(fields.minCoeff(), 0);
  EXPECT_LE((fields.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-13);
  const Eigen::VectorXd combined = fields * p.values;
  EXPECT_LE((combined - solve(*p.mesh, p.painted, p.values)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Field, many_columns_are_the_same_as_one_after_the_other) {
  const Painting p(4);
  const HarmonicSolver solver(*p.mesh, p.painted);
  const Eigen::MatrixXd values = Eigen::MatrixXd::Random(40, 7);
  const Eigen::MatrixXd together = solver.solve(values).values;
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    const Eigen::VectorXd alone = solver.solve(Eigen::VectorXd(values.col(k))).values.col(0);
    EXPECT_LE((together.col(k) - alone).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(Field, is_linear_along_a_strip) {
  const auto mesh = make_mesh(makers::grid(50, 3, false));
  std::vector<Index> ends;
  Eigen::VectorXd values(8);
  for (Index j = 0; j < 4; ++j) {
    ends.push_back(j * 51);
    ends.push_back(j * 51 + 50);
    values.segment(2 * j, 2) << 2, 12;
  }
  const Eigen::VectorXd field = solve(*mesh, ends, values);
  for (Index v = 0; v < mesh->vertex_count(); ++v) EXPECT_NEAR(field[v], 2 + 10 * (v % 51) / 50.0, 1e-12);
}

TEST(Field, a_source_solves_poissons_equation) {
  const auto mesh =
      make_mesh(makers::grid(20, 2, false)); // φ'' = −2: φ = x (20 − x), times valence 4 of inner vertices
  std::vector<Index> ends;
  for (Index j = 0; j < 3; ++j)
    for (const Index end : {0, 20}) ends.push_back(j * 21 + end);
  const Eigen::VectorXd D = graph_stiffness(*mesh).diagonal();
  const Eigen::VectorXd source = 2 * D.cwiseInverse(); // K φ = D source = 2 everywhere
  for (const Method method : {Method::direct, Method::least_squares_cg}) {
    SolverOptions options;
    options.method = method;
    const Field field =
        HarmonicSolver(*mesh, ends, options).solve(Eigen::VectorXd::Zero(6), std::span(source.data(), 63));
    for (Index v = 0; v < 63; ++v) EXPECT_NEAR(field.values(v, 0), (v % 21) * (20 - v % 21), 1e-9);
    EXPECT_LE(field.report.relative_residual, 1e-10);
  }
}

TEST(Field, a_piece_without_paint_is_nan_and_reported_and_spoils_nothing) {
  auto soup = makers::grid(5, 5);
  soup.positions.insert(soup.positions.end(), {0, 0, 9, 1, 0, 9, 0, 1, 9, 7, 7, 7}); // a triangle, a loose vertex
  const auto alone = make_mesh(soup);
  soup.faces.push_back({36, 37, 38});
  const auto mesh = make_mesh(soup);
  const Field field = HarmonicSolver(*mesh, std::vector<Index>{0, 35}).solve(column({0, 1}));
  EXPECT_EQ(field.report.undefined, 4);
  EXPECT_EQ(field.report.first_undefined, 36);
  ASSERT_EQ(field.report.warnings.size(), 1U);
  EXPECT_NE(field.report.warnings[0].find("4 vertices"), std::string::npos);
  EXPECT_TRUE(field.values.bottomRows(4).array().isNaN().all());
  EXPECT_TRUE(field.values.topRows(36).allFinite());
  EXPECT_EQ(field.report.minimum, 0);
  EXPECT_EQ(field.report.maximum, 1);
}

TEST(Field, equal_paint_gives_the_constant_exactly_and_a_warning) {
  const Painting p(5);
  const Field field = HarmonicSolver(*p.mesh, p.painted).solve(Eigen::VectorXd::Constant(40, 0.1));
  EXPECT_TRUE((field.values.array() == 0.1).all());
  ASSERT_EQ(field.report.warnings.size(), 1U);
  EXPECT_NE(field.report.warnings[0].find("constant"), std::string::npos);
}

TEST(Field, a_region_with_one_value_at_its_rim_is_exactly_that_value) {
  const auto mesh = make_mesh(makers::grid(8, 2, false)); // cut by a painted column: left of it there is no other paint
  const Eigen::VectorXd field = solve(*mesh, {3, 12, 21, 8, 17, 26}, column({0.1, 0.1, 0.1, 0.7, 0.7, 0.7}));
  for (const Index v : {0, 1, 2, 9, 10, 11, 18, 19, 20}) EXPECT_EQ(field[v], 0.1);
}

TEST(Field, values_near_the_ends_of_the_number_range_work) {
  const auto mesh = make_mesh(makers::torus(9, 7));
  const Eigen::VectorXd plain = solve(*mesh, {0, 31}, column({-1, 1}));
  for (const double size : {1e300, 1.7e308, 1e-300}) {
    const Eigen::VectorXd field = solve(*mesh, {0, 31}, column({-size, size}));
    EXPECT_LE((field / size - plain).cwiseAbs().maxCoeff(), 1e-14);
  }
  const Eigen::VectorXd close = solve(*mesh, {0, 31}, column({1, std::nextafter(1.0, 2.0)}));
  EXPECT_EQ(close.minCoeff(), 1);
  EXPECT_EQ(close.maxCoeff(), std::nextafter(1.0, 2.0));
}

TEST(Field, everything_painted_is_returned_as_it_was) {
  const auto mesh = make_mesh(makers::tetrahedron());
  const Field field = HarmonicSolver(*mesh, std::vector<Index>{3, 2, 1, 0}).solve(column({4, 3, 2, 1}));
  EXPECT_EQ(field.values.col(0), column({1, 2, 3, 4}));
  EXPECT_EQ(field.report.unknowns, 0);
}

TEST(Field, the_report_counts_what_was_solved) {
  const Painting p(6);
  const SolveReport report = HarmonicSolver(*p.mesh, p.painted).solve(p.values).report;
  EXPECT_EQ(report.vertices, 23 * 17);
  EXPECT_EQ(report.painted, 40);
  EXPECT_EQ(report.unknowns, 23 * 17 - 40);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_GE(report.factor_nonzeros, 23 * 17 - 40);
  EXPECT_EQ(report.painted_minimum, p.values.minCoeff());
  EXPECT_EQ(report.maximum, p.values.maxCoeff());
  EXPECT_TRUE(report.warnings.empty());
}

TEST(Field, one_vertex_painted_twice_with_one_value_is_fine) {
  const auto mesh = make_mesh(makers::grid(3, 3));
  EXPECT_EQ(solve(*mesh, {0, 15, 0}, column({1, 2, 1})), solve(*mesh, {0, 15}, column({1, 2})));
}

TEST(Field, of_a_mesh_large_enough_for_dissection_is_right_and_the_same_on_one_thread) {
  const auto mesh = make_mesh(makers::torus(260, 200));
  const std::vector<Index> painted{0, 777, 26'100};
  Eigen::MatrixXd values(3, 4); // columns enough for several threads to hand the field out
  values << 0, 1, 5, -0.0, 1, 1, 6, 0.0, 2, 1, 7, 0.0;
  const auto solve_all = [&] { return HarmonicSolver(*mesh, painted).solve(values); };
  const Field field = solve_all();
  EXPECT_LE(field.report.relative_residual, 1e-10);
  EXPECT_EQ(field.values.minCoeff(), 0);
  EXPECT_EQ(field.values.maxCoeff(), 7);
  EXPECT_EQ(field.report.minimum, 0);
  EXPECT_FALSE(std::signbit(field.report.minimum));
  EXPECT_EQ(field.report.maximum, 7);
  thread_limit = 1;
  const Field alone = solve_all();
  thread_limit = 0;
  EXPECT_EQ(field.values, alone.values);
  EXPECT_EQ(field.report.minimum, alone.report.minimum);
  EXPECT_EQ(field.report.maximum, alone.report.maximum);
  EXPECT_EQ(field.report.outside, alone.report.outside);
  EXPECT_EQ(field.report.farthest_outside, alone.report.farthest_outside);
}

TEST(FieldRefuses, paint_that_makes_no_sense_naming_it) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto mesh = make_mesh(makers::grid(3, 3));
  EXPECT_REFUSED(solve(*mesh, {}, Eigen::VectorXd()), InputError, "no vertex is painted");
  EXPECT_REFUSED(solve(*mesh, {0, 16, -1}, column({1, 2, 3})), InputError, "vertex 16", "place 1", "0 to 15", "1 more");
  EXPECT_REFUSED(solve(*mesh, {0, 1}, column({1, 2, 3})), InputError, "3 values", "2 painted");
  EXPECT_REFUSED(solve(*mesh, {0, 1}, column({1, nan})), InputError, "place 1", "nan");
  EXPECT_REFUSED(solve(*mesh, {7, 1, 7}, column({1, 0, 2})), InputError, "vertex 7", "with 1", "with 2");
}

TEST(FieldRefuses, a_source_that_does_not_fit_or_is_not_finite) {
  const auto mesh = make_mesh(makers::grid(3, 3));
  const HarmonicSolver solver(*mesh, std::vector<Index>{0});
  EXPECT_REFUSED(solver.solve(column({1}), std::vector<double>(15)), InputError, "15", "16");
  std::vector<double> source(16);
  source[9] = std::numeric_limits<double>::infinity();
  EXPECT_REFUSED(solver.solve(column({1}), source), InputError, "vertex 9", "inf");
}

TEST(FieldRefuses, options_out_of_range_and_says_when_the_iteration_falls_short) {
  const Painting p(7);
  SolverOptions options;
  options.method = Method::least_squares_cg;
  options.tolerance = 0;
  EXPECT_REFUSED(HarmonicSolver(*p.mesh, p.painted, options), InputError, "tolerance");
  options.tolerance = 1e-12;
  options.max_iterations = 0;
  EXPECT_REFUSED(HarmonicSolver(*p.mesh, p.painted, options), InputError, "max_iterations", "0");
  options.max_iterations = 3;
  EXPECT_REFUSED(HarmonicSolver(*p.mesh, p.painted, options).solve(p.values), SolverError, "3 steps");
}

TEST(DirichletLaplacian, has_identity_rows_where_painted_and_rows_that_sum_to_zero_elsewhere) {
  const Painting p(8);
  const SparseMatrix matrix = dirichlet_laplacian(*p.mesh, p.painted);
  Eigen::VectorXd sums = matrix * Eigen::VectorXd::Ones(matrix.cols());
  for (const Index v : p.painted) {
    EXPECT_EQ(matrix.row(v).nonZeros(), 1);
    EXPECT_EQ(matrix.coeff(v, v), 1);
    sums[v] -= 1;
  }
  EXPECT_LE(sums.cwiseAbs().maxCoeff(), 1e-15);
}

} // namespace
} // namespace dirichlet
