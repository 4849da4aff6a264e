// SPDX-License-Identifier: GPL-3.0-or-later
// A solver that lives: whatever was painted before, a painting has the field that a new solver gives it.
#include <algorithm>
#include <array>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "denied_memory.h"
#include "dirichlet/error.h"
#include "dirichlet/field.h"
#include "dirichlet/isolines.h"
#include "index.h"
#include "mesh_makers.h"
#include "refusal.h"

namespace dirichlet {
namespace {

using makers::make_mesh;
using makers::PolygonSoup;

struct Painting {
  std::vector<Index> vertices;
  Eigen::VectorXd values;
};

/// Strokes: discs of consecutive vertices that come, go and change their value.
class Strokes {
 public:
  Strokes(Index vertex_count, unsigned seed) : count_(vertex_count), random_(seed) { stroke(); }

  Painting next() {
    for (int more = static_cast<int>(random_() % 3); more > 0; --more) stroke();
    if (patches_.size() > 1 && random_() % 3 == 0) patches_.erase(patches_.begin());
    if (random_() % 2 == 0) patches_.back().value = value();
    Painting painting;
    std::vector<double> values;
    std::vector<bool> taken(at(count_));
    for (const Patch& patch : patches_)
      for (Index v = patch.first; v < std::min(count_, patch.first + patch.size); ++v) {
        if (taken[at(v)]) continue;
        taken[at(v)] = true;
        painting.vertices.push_back(v);
        values.push_back(patch.value);
      }
    painting.values = Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    return painting;
  }

 private:
  struct Patch {
    Index first, size;
    double value;
  };
  double value() { return std::uniform_real_distribution<double>(-2, 3)(random_); }
  void stroke() {
    const auto first = static_cast<Index>(random_() % at(count_)), size = static_cast<Index>(1 + random_() % 9);
    patches_.push_back({first, size, value()});
  }
  Index count_;
  std::mt19937 random_;
  std::vector<Patch> patches_;
};

Eigen::MatrixXd fresh(const Mesh& mesh, const Painting& painting, const SolverOptions& options = {}) {
  return HarmonicSolver(mesh, painting.vertices, options).solve(painting.values).values;
}

TEST(Painting, after_any_strokes_the_field_is_a_new_solvers_bit_for_bit) {
  for (const Index side : {5, 40, 240}) { // the largest is ordered by dissection and repaired in part
    const auto mesh = make_mesh(makers::torus(side, side));
    HarmonicSolver solver(*mesh);
    Strokes strokes(mesh->vertex_count(), static_cast<unsigned>(side));
    for (int k = 0; k < (side < 100 ? 30 : 5); ++k) {
      const Painting painting = strokes.next();
      EXPECT_EQ(solver.paint(painting.vertices, painting.values).values, fresh(*mesh, painting)) << side << ' ' << k;
    }
  }
}

TEST(Painting, in_float32_or_by_multigrid_keeps_to_the_tolerance_after_any_strokes) {
  const auto mesh = make_mesh(makers::torus(60, 50));
  for (const auto& [method, precision] :
       {std::pair(Method::direct, Precision::float32), std::pair(Method::multigrid, Precision::float64)}) {
    SolverOptions options;
    options.method = method;
    options.precision = precision;
    HarmonicSolver solver(*mesh, options);
    Strokes strokes(mesh->vertex_count(), 11);
    for (int k = 0; k < 10; ++k) {
      const Painting painting = strokes.next();
      const Field field = solver.paint(painting.vertices, painting.values);
      EXPECT_LE(field.report.relative_residual, 1e-10);
      EXPECT_EQ(field.report.method, method);
      EXPECT_LE((field.values - fresh(*mesh, painting)).cwiseAbs().maxCoeff(), 1e-7);
    }
  }
}

TEST(Painting, says_what_it_had_to_compute) {
  const auto mesh = make_mesh(makers::torus(240, 240));
  HarmonicSolver solver(*mesh);
  std::vector<Index> vertices{0, 1, 2, 30'000};
  Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(4, 0, 1);
  const auto paint = [&] { return solver.paint(vertices, values).report; };
  EXPECT_EQ(paint().update, Update::full);
  const SolveReport again = paint();
  EXPECT_EQ(again.update, Update::nothing);
  EXPECT_EQ(again.repeated, 0);
  values[1] = 0.5;
  EXPECT_EQ(paint().update, Update::values);
  std::swap(vertices[0], vertices[1]);
  std::swap(values[0], values[1]);
  EXPECT_EQ(paint().update, Update::values);
  vertices[3] = 30'001;
  const SolveReport stroke = paint();
  EXPECT_EQ(stroke.update, Update::partial);
  EXPECT_GT(stroke.repeated, 0);
  EXPECT_LT(stroke.repeated, 0.6);
}

TEST(Painting, a_sign_of_zero_or_a_source_is_a_change) {
  const auto mesh = make_mesh(makers::torus(9, 9));
  HarmonicSolver solver(*mesh);
  const std::vector<Index> vertices{3, 50};
  const std::vector<double> source(81, 0.25);
  Eigen::VectorXd values(2);
  values << 0.0, 1.0;
  static_cast<void>(solver.paint(vertices, values));
  values[0] = -0.0;
  EXPECT_TRUE(std::signbit(solver.paint(vertices, values).values(3, 0)));
  const Field raised = solver.paint(vertices, values, source);
  EXPECT_EQ(raised.report.update, Update::values);
  EXPECT_GT(raised.values(40, 0), solver.paint(vertices, values).values(40, 0));
}

TEST(Painting, pieces_gain_and_lose_their_values_with_their_paint) {
  const auto mesh = make_mesh(makers::copies(makers::torus(8, 8), 2));
  HarmonicSolver solver(*mesh);
  const Painting first{{5}, Eigen::VectorXd::Constant(1, 2)}, second{{70}, Eigen::VectorXd::Constant(1, 3)},
      both{{5, 70}, Eigen::Vector2d(2, 3)};
  for (const Painting& painting : {first, second, both, second, first}) {
    const Field field = solver.paint(painting.vertices, painting.values);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const Index ruler = v < 64 ? 5 : 70;
      const auto place =
          std::find(painting.vertices.begin(), painting.vertices.end(), ruler) - painting.vertices.begin();
      if (place == static_cast<Index>(painting.vertices.size()))
        EXPECT_TRUE(std::isnan(field.values(v, 0))) << v;
      else
        EXPECT_EQ(field.values(v, 0), painting.values[place]) << v;
    }
    EXPECT_EQ(field.report.undefined, painting.vertices.size() == 2 ? 0 : 64);
    EXPECT_EQ(field.report.first_undefined, painting.vertices.size() == 2 ? -1 : painting.vertices[0] == 5 ? 64 : 0);
  }
}

TEST(Painting, that_is_refused_leaves_the_last_one) {
  const auto mesh = make_mesh(makers::torus(12, 12));
  HarmonicSolver solver(*mesh);
  EXPECT_REFUSED(static_cast<void>(solver.solve(Eigen::VectorXd())), InputError, "no vertex is painted yet");
  const std::vector<Index> vertices{0, 70};
  const Eigen::Vector2d values(0, 1);
  const Eigen::MatrixXd field = solver.paint(vertices, values).values;
  EXPECT_REFUSED(solver.paint({}, Eigen::VectorXd()), InputError, "no vertex is painted");
  EXPECT_REFUSED(solver.paint(std::vector<Index>{0, 144}, values), InputError, "vertex 144");
  EXPECT_REFUSED(solver.paint(std::vector<Index>{1, 1}, values), InputError, "vertex 1", "with 0", "with 1");
  EXPECT_REFUSED(solver.paint(vertices, values, std::vector<double>(3)), InputError, "the source has 3 numbers");
  EXPECT_EQ(solver.solve(values).values, field);
  EXPECT_EQ(solver.paint(vertices, values).report.update, Update::nothing);
}

/// Of what `new` gives: Eigen's own arrays are not denied.
TEST(Painting, whichever_request_for_memory_is_denied_the_next_painting_is_right) {
  const auto mesh = make_mesh(makers::copies(makers::torus(13, 11), 2)); // 143 vertices each
  const Painting before{{0, 200}, Eigen::Vector2d(0, 1)};                // both pieces
  const Painting denied{{0, 100, 20, 100}, Eigen::Vector4d(0, 2, 1, 2)}; // one piece, and a vertex twice
  const Painting after{{100, 30, 200}, Eigen::Vector3d(2, 0, 3)};
  const std::vector<double> source(286, 0.5);
  HarmonicSolver solver(*mesh);
  for (const std::span<const double> with : {std::span<const double>{}, std::span(source)}) {
    const Eigen::MatrixXd expected = HarmonicSolver(*mesh, denied.vertices).solve(denied.values, with).values;
    long granted = 0;
    for (bool happened = true; happened; ++granted) {
      static_cast<void>(solver.paint(before.vertices, before.values));
      {
        const DeniedMemory deny(granted);
        try {
          static_cast<void>(solver.paint(denied.vertices, denied.values, with));
        } catch (const SolverError& error) {
          EXPECT_NE(std::string(error.what()).find("not enough memory"), std::string::npos);
        }
        happened = DeniedMemory::happened();
      }
      if (granted % 2 == 0) {
        EXPECT_EQ(solver.paint(after.vertices, after.values).values, fresh(*mesh, after)) << granted;
      } else {
        const Eigen::MatrixXd again = solver.paint(denied.vertices, denied.values, with).values;
        EXPECT_TRUE(again.topRows(143) == expected.topRows(143)) << granted;
        EXPECT_TRUE(again.bottomRows(143).array().isNaN().all()) << granted;
      }
    }
    EXPECT_GT(granted, 20);
  }
}

TEST(Painting, a_multigrid_iteration_starts_from_the_last_field) {
  const auto mesh = make_mesh(makers::torus(60, 50));
  SolverOptions options;
  options.method = Method::multigrid;
  HarmonicSolver solver(*mesh, options);
  const std::vector<Index> vertices{0, 700, 1500};
  Eigen::Vector3d values(0, 1, 2);
  const Index cold = solver.paint(vertices, values).report.iterations;
  values[1] += 1e-6;
  EXPECT_LT(solver.paint(vertices, values).report.iterations, cold - 2);
}

TEST(Painting, what_the_paint_is_far_from_does_not_hide_it) {
  const auto mesh = make_mesh(makers::copies(makers::torus(30, 20), 2)); // 600 vertices each
  for (const auto& [method, precision] :
       {std::pair(Method::direct, Precision::float32), std::pair(Method::multigrid, Precision::float64)}) {
    SolverOptions options;
    options.method = method;
    options.precision = precision;
    // All of the second piece is painted, and nothing of its 1e300 reaches a free row.
    std::vector<Index> vertices{0, 300};
    for (Index v = 600; v < 1200; ++v) vertices.push_back(v);
    Eigen::VectorXd all = Eigen::VectorXd::Constant(602, 1e300);
    all[0] = 0;
    all[1] = 1;
    const Field field = HarmonicSolver(*mesh, vertices, options).solve(all);
    const Eigen::MatrixXd alone = fresh(*mesh, {{0, 300}, Eigen::Vector2d(0, 1)});
    EXPECT_LE((field.values - alone).topRows(600).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_LE(field.report.relative_residual, 1e-10);
  }
}

TEST(Painting, may_go_on_while_others_solve) {
  const auto mesh = make_mesh(makers::torus(70, 70)); // large enough for regions to be searched on another thread
  HarmonicSolver solver(*mesh);
  const std::vector<Index> even{0, 400}, odd{1, 401};
  const Eigen::Vector2d values(0, 1);
  const Eigen::MatrixXd fields[]{fresh(*mesh, {even, values}), fresh(*mesh, {odd, values})};
  static_cast<void>(solver.paint(even, values));
  std::thread painter([&] {
    for (int k = 0; k < 50; ++k) static_cast<void>(solver.paint(k % 2 == 0 ? odd : even, values));
  });
  for (int k = 0; k < 50; ++k) {
    const Eigen::MatrixXd field = solver.solve(values).values;
    EXPECT_TRUE(field == fields[0] || field == fields[1]);
  }
  painter.join();
}

TEST(Painting, of_two_solvers_in_two_threads_reads_one_mesh) {
  PolygonSoup soup = makers::torus(70, 70, /*triangles=*/false);
  soup.faces.push_back(soup.faces[7]); // repeated, and not triangular: what the mesh makes when it is first asked
  const auto mesh = make_mesh(soup);
  const std::vector<Index> vertices{0, 400};
  std::vector<double> heights;
  for (std::size_t v = 2; v < soup.positions.size(); v += 3) heights.push_back(soup.positions[v]);
  std::array<Eigen::MatrixXd, 2> fields;
  std::array<std::size_t, 2> lines{};
  const auto work = [&](std::size_t k) {
    fields[k] = HarmonicSolver(*mesh, vertices, {}, Laplacian::cotangent).solve(Eigen::Vector2d(0, 1)).values;
    lines[k] = extract_isolines(*mesh, heights, std::vector<double>{0, 0.1}).closed.size();
  };
  std::thread other(work, 0);
  work(1);
  other.join();
  EXPECT_EQ(fields[0], fields[1]);
  EXPECT_EQ(lines[0], lines[1]);
  EXPECT_GT(lines[0], 0);
}

TEST(Painting, may_be_given_up_while_another_thread_searches_its_regions) {
  const auto mesh = make_mesh(makers::torus(90, 80));
  for (Index v = 0; v < 20; ++v) const HarmonicSolver solver(*mesh, std::vector<Index>{v});
  HarmonicSolver solver(*mesh);
  const std::vector<double> source(7200, 0.0); // with one, regions are not asked for
  for (Index v = 0; v < 20; ++v) {
    const Field field = solver.paint(std::vector<Index>{v}, Eigen::VectorXd::Ones(1), source);
    EXPECT_NEAR(field.values.minCoeff(), 1, 1e-12);
  }
}

TEST(Painting, in_float32_solves_many_columns_to_the_tolerance) {
  const auto mesh = make_mesh(makers::torus(70, 80));
  SolverOptions options;
  options.precision = Precision::float32;
  const std::vector<Index> vertices{0, 900, 2000, 5000};
  Eigen::MatrixXd values = Eigen::MatrixXd::Identity(4, 6);
  values.col(4) *= 1e200;
  values.col(5).setZero();
  const Field field = HarmonicSolver(*mesh, vertices, options).solve(values);
  const Field reference = HarmonicSolver(*mesh, vertices).solve(values);
  EXPECT_GT(field.report.iterations, 0);
  EXPECT_LE(field.report.relative_residual, 1e-10);
  for (Eigen::Index k = 0; k < 6; ++k)
    EXPECT_LE((field.values.col(k) - reference.values.col(k)).cwiseAbs().maxCoeff(),
              1e-8 * values.col(k).cwiseAbs().maxCoeff());
  options.max_iterations = 1;
  options.tolerance = 1e-14;
  EXPECT_REFUSED(HarmonicSolver(*mesh, vertices, options).solve(values), SolverError, "float32", "after 1 step,",
                 "float64");
}

TEST(Painting, what_does_not_fit_the_memory_budget_is_solved_by_multigrid) {
  const auto mesh = make_mesh(makers::torus(40, 40));
  const Painting painting{{0, 777}, Eigen::Vector2d(0, 1)};
  SolverOptions options;
  options.memory_budget = 1000;
  const Field field = HarmonicSolver(*mesh, painting.vertices, options).solve(painting.values);
  EXPECT_EQ(field.report.method, Method::multigrid);
  EXPECT_EQ(field.report.factor_nonzeros, 0);
  EXPECT_LE((field.values - fresh(*mesh, painting)).cwiseAbs().maxCoeff(), 1e-8);
  options.memory_budget = 100'000'000;
  EXPECT_EQ(HarmonicSolver(*mesh, painting.vertices, options).solve(painting.values).report.method, Method::direct);
  options.memory_budget = -1;
  EXPECT_REFUSED(HarmonicSolver(*mesh, options), InputError, "memory budget", "-1");
}

} // namespace
} // namespace dirichlet
