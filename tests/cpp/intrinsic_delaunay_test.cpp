// SPDX-License-Identifier: GPL-3.0-or-later
#include "intrinsic_delaunay.h"

#include <random>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "cotangent_laplacian.h"
#include "dirichlet/field.h"
#include "index.h"
#include "intrinsic/cover.h"
#include "mesh_makers.h"
#include "parallel.h"
#include "triangle_lengths.h"
#include "union_find.h"
#include "vector3.h"

namespace dirichlet {
namespace {

using makers::make_mesh;
using makers::PolygonSoup;

SparseMatrix stiffness(const Mesh& triangles) {
  DelaunayNotes notes;
  return intrinsic_delaunay_stiffness(triangles.without_repeats(), measure_cotangents(triangles).weights, notes);
}

Cover cover_of(const Mesh& triangles) {
  return cover(triangles.without_repeats(), measure_cotangents(triangles).weights);
}

SparseMatrix stiffness(const PolygonSoup& soup) {
  return stiffness(make_mesh(soup)->triangulated());
}

Vector3 position(const PolygonSoup& soup, Index v) {
  return {soup.positions[3 * at(v)], soup.positions[3 * at(v) + 1], soup.positions[3 * at(v) + 2]};
}

/// A triangle's half cotangents from dot and cross products: (V, V) as they come.
Eigen::MatrixXd plain_cotangents(const PolygonSoup& soup) {
  const auto n = static_cast<Eigen::Index>(soup.positions.size() / 3);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (const auto& face : soup.faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = face[i], b = face[(i + 1) % 3], c = face[(i + 2) % 3];
      const Vector3 u = position(soup, a) - position(soup, c), v = position(soup, b) - position(soup, c);
      const double weight = dot(u, v) / std::sqrt(dot(cross(u, v), cross(u, v))) / 2;
      K(a, b) -= weight;
      K(b, a) -= weight;
      K(a, a) += weight;
      K(b, b) += weight;
    }
  return K;
}

/// The field that is values[v] where painted[v]; free vertices that nothing holds are 0.
Eigen::VectorXd solve(const SparseMatrix& K, const std::vector<bool>& painted, const Eigen::VectorXd& values) {
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(K.rows());
  for (Index i = 0; i < K.rows(); ++i) {
    if (painted[at(i)] || K.coeff(i, i) == 0) {
      entries.emplace_back(i, i, 1);
      right[i] = painted[at(i)] ? values[i] : 0;
      continue;
    }
    for (SparseMatrix::InnerIterator entry(K, i); entry; ++entry)
      if (painted[at(static_cast<Index>(entry.col()))])
        right[i] -= entry.value() * values[entry.col()];
      else
        entries.emplace_back(i, entry.col(), entry.value());
  }
  Eigen::SparseMatrix<double> A(K.rows(), K.cols());
  A.setFromTriplets(entries.begin(), entries.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(A).solve(right);
}

/// Every weight ≥ 0 and finite, symmetric, rows that sum to 0, and connected where faces connect.
void expect_maximum_principle(const Mesh& mesh, const std::string& name) {
  const SparseMatrix K = stiffness(mesh);
  UnionFind by_weights(mesh.vertex_count()), by_faces(mesh.vertex_count());
  double largest = 0, asymmetry = 0;
  for (Index i = 0; i < K.rows(); ++i)
    for (SparseMatrix::InnerIterator entry(K, i); entry; ++entry) {
      const auto j = static_cast<Index>(entry.col());
      ASSERT_TRUE(std::isfinite(entry.value())) << name;
      ASSERT_TRUE(i == j || entry.value() <= 0) << name << ", entry " << i << ", " << j;
      asymmetry = std::max(asymmetry, std::abs(entry.value() - K.coeff(j, i)));
      largest = std::max(largest, std::abs(entry.value()));
      if (entry.value() < 0) by_weights.unite(i, j);
    }
  const auto& edges = mesh.connectivity().edges;
  for (std::size_t e = 0; e < edges.size(); e += 2) by_faces.unite(edges[e], edges[e + 1]);
  EXPECT_EQ(asymmetry, 0) << name;
  EXPECT_LE((K * Eigen::VectorXd::Ones(K.cols())).cwiseAbs().maxCoeff(), 1e-13 * largest) << name;
  for (Index v = 0; v < mesh.vertex_count(); ++v) EXPECT_EQ(by_weights.find(v), by_faces.find(v)) << name;
}

std::vector<bool> border(const Mesh& mesh) {
  std::vector<bool> on_border(at(mesh.vertex_count()), false);
  for (const Index v : mesh.border_loops().vertices) on_border[at(v)] = true;
  return on_border;
}

/// Vertices of a grid moved about in its plane, its quads cut at random: triangles get angles near π, and do not fold
/// where nothing moves by 1/4.
PolygonSoup shaken_grid(Index n, unsigned seed, double reach) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<> move(-reach, reach);
  PolygonSoup soup = makers::grid(n, n, false);
  for (std::size_t v = 0; v < soup.positions.size(); v += 3)
    for (const std::size_t k : {0U, 1U}) soup.positions[v + k] += move(random);
  auto quads = std::move(soup.faces);
  soup.faces.clear();
  for (const auto& q : quads) {
    const std::size_t s = random() % 2;
    soup.faces.push_back({q[s], q[s + 1], q[s + 2]});
    soup.faces.push_back({q[s], q[s + 2], q[(s + 3) % 4]});
  }
  return soup;
}

TEST(IntrinsicDelaunay, is_the_plain_cotangent_operator_where_no_edge_wants_flipping) {
  for (const PolygonSoup& soup : {makers::grid(5, 4), makers::torus(30, 17), makers::sphere(6, 16)}) {
    const Eigen::MatrixXd K = stiffness(soup);
    EXPECT_LE((K - plain_cotangents(soup)).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(IntrinsicDelaunay, reproduces_linear_functions_in_a_plane_with_a_painted_border) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    PolygonSoup soup = shaken_grid(12, seed, 0.2499);
    for (std::size_t v = 0; v < soup.positions.size(); v += 3) soup.positions[v] *= 1 + seed;
    Eigen::VectorXd linear(static_cast<Eigen::Index>(soup.positions.size() / 3));
    for (Index v = 0; v < linear.size(); ++v) linear[v] = 3 * position(soup, v).x - 2 * position(soup, v).y;
    const Eigen::VectorXd field = solve(stiffness(soup), border(*make_mesh(soup)), linear);
    EXPECT_LE((field - linear).cwiseAbs().maxCoeff(), 1e-9) << "seed " << seed;
  }
}

TEST(IntrinsicDelaunay, needles_and_what_has_shrunk_to_a_point_leave_seven_digits_to_linear_functions) {
  for (const double size : {1e-6, 1e-9, 1e-12, 1e-15, 0.0}) {
    PolygonSoup soup = shaken_grid(24, 4, 0.2);
    double* const p = soup.positions.data();
    const auto shrink = [&](std::size_t to, std::size_t v) {
      for (std::size_t k = 0; k < 2; ++k) p[3 * v + k] = p[3 * to + k] + size * (p[3 * v + k] - p[3 * to + k]);
    };
    for (std::size_t j = 1; j < 24; ++j)
      for (std::size_t i = 1; i < 24; ++i)
        if (i > 8 && i < 16 && j > 8 && j < 16)
          shrink(12 + 12 * 25, i + j * 25);
        else if (i % 3 == 2)
          shrink(i + j * 25 - 1, i + j * 25);
    const auto mesh = make_mesh(soup);
    Eigen::VectorXd linear(mesh->vertex_count());
    for (Index v = 0; v < linear.size(); ++v) linear[v] = 1 + (position(soup, v).x + position(soup, v).y) / 48;
    std::vector<Index> painted;
    for (Index v = 0; v < mesh->vertex_count(); ++v)
      if (border(*mesh)[at(v)]) painted.push_back(v);
    HarmonicSolver solver(*mesh, {}, Laplacian::intrinsic_delaunay);
    const Field field = solver.paint(painted, linear(painted));
    EXPECT_LE((field.values.col(0) - linear).cwiseAbs().maxCoeff(), 1e-6) << "size " << size;
  }
}

/// Whether d lies inside the circle through a, b, c, which turn counter-clockwise.
double inside_circle(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  Eigen::Matrix3d M;
  Index row = 0;
  for (const Vector3& p : {a, b, c}) {
    const Vector3 q = p - d;
    M.row(row++) << q.x, q.y, dot(q, q);
  }
  return M.determinant();
}

TEST(IntrinsicDelaunay, in_a_plane_it_is_made_of_the_triangles_whose_circles_are_empty) {
  // A convex outline, so that every Delaunay triangle of the points is inside.
  PolygonSoup soup;
  std::mt19937 random(3);
  std::uniform_real_distribution<> any(-0.6, 0.6);
  constexpr Index outline = 12, inside = 14, n = outline + inside;
  for (Index i = 0; i < outline; ++i)
    soup.positions.insert(soup.positions.end(), {std::cos(2 * std::numbers::pi * i / outline) + 0.01 * any(random),
                                                 std::sin(2 * std::numbers::pi * i / outline), 0});
  for (Index i = 0; i < inside; ++i) soup.positions.insert(soup.positions.end(), {any(random), any(random), 0});
  const auto turn = [&](Index a, Index b, Index c) {
    return cross(position(soup, b) - position(soup, a), position(soup, c) - position(soup, a)).z;
  };
  for (Index i = 1; i + 1 < outline; ++i) soup.faces.push_back({0, i, i + 1});
  for (Index v = outline; v < n; ++v) { // each point splits the triangle that it lies in
    const auto home = std::find_if(soup.faces.begin(), soup.faces.end(), [&](const auto& f) {
      return turn(f[0], f[1], v) > 0 && turn(f[1], f[2], v) > 0 && turn(f[2], f[0], v) > 0;
    });
    ASSERT_NE(home, soup.faces.end());
    const std::array<Index, 3> f{(*home)[0], (*home)[1], (*home)[2]};
    *home = {f[0], f[1], v};
    soup.faces.push_back({f[1], f[2], v});
    soup.faces.push_back({f[2], f[0], v});
  }
  const Eigen::MatrixXd K = stiffness(soup);
  PolygonSoup delaunay{soup.positions, {}};
  for (Index a = 0; a < n; ++a)
    for (Index b = a + 1; b < n; ++b)
      for (Index c = a + 1; c < n; ++c) {
        if (b == c || turn(a, b, c) <= 0) continue;
        bool empty = true;
        for (Index d = 0; d < n; ++d)
          empty &= d == a || d == b || d == c ||
                   inside_circle(position(soup, a), position(soup, b), position(soup, c), position(soup, d)) < 0;
        if (empty) delaunay.faces.push_back({a, b, c});
      }
  ASSERT_EQ(delaunay.faces.size(), soup.faces.size());
  const Eigen::MatrixXd expected = plain_cotangents(delaunay);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      if (i >= outline || j >= outline) {
        EXPECT_NEAR(K(i, j), expected(i, j), 1e-10) << i << ", " << j;
      }
}

Eigen::VectorXd ramp(const PolygonSoup& soup, std::vector<bool>& painted) {
  const auto n = static_cast<Eigen::Index>(soup.positions.size() / 3);
  painted.assign(soup.positions.size() / 3, false);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(n);
  painted.front() = painted[1] = painted.back() = true;
  values[n - 1] = 1;
  values[1] = 0.25;
  return values;
}

Eigen::VectorXd field_of(const PolygonSoup& soup) {
  std::vector<bool> painted;
  const Eigen::VectorXd values = ramp(soup, painted);
  return solve(stiffness(soup), painted, values);
}

PolygonSoup triangles_of(const PolygonSoup& soup) {
  const auto mesh = make_mesh(soup);
  PolygonSoup triangles{soup.positions, {}};
  const std::span<const Index> corners = mesh->triangulated().corners();
  for (std::size_t c = 0; c < corners.size(); c += 3)
    triangles.faces.push_back({corners[c], corners[c + 1], corners[c + 2]});
  return triangles;
}

/// Bent out of its plane.
PolygonSoup hilly_grid(Index n) {
  PolygonSoup soup = shaken_grid(n, 5, 0.45);
  for (std::size_t v = 0; v < soup.positions.size(); v += 3)
    soup.positions[v + 2] = std::sin(soup.positions[v]) + 0.3 * std::cos(2 * soup.positions[v + 1]);
  return soup;
}

TEST(IntrinsicDelaunay, the_field_does_not_depend_on_the_direction_or_the_order_of_faces) {
  for (const PolygonSoup& soup :
       {hilly_grid(9), makers::sphere(7, 11), makers::moebius(12), makers::klein_bottle(8, 11), makers::book(5, 4)}) {
    const PolygonSoup triangles = triangles_of(soup);
    const Eigen::VectorXd field = field_of(triangles);
    std::mt19937 random(2);
    for (int trial = 0; trial < 5; ++trial) {
      PolygonSoup other = triangles;
      for (auto& face : other.faces) {
        std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random() % 3), face.end());
        if (random() % 2 == 0) std::reverse(face.begin(), face.end());
      }
      std::shuffle(other.faces.begin(), other.faces.end(), random);
      EXPECT_LE((field_of(other) - field).cwiseAbs().maxCoeff(), 1e-9);
    }
  }
}

TEST(IntrinsicDelaunay, faces_that_come_twice_count_once) {
  const PolygonSoup soup = hilly_grid(7);
  PolygonSoup repeated = soup;
  for (const std::size_t face : {0U, 13U, 40U, 40U}) repeated.faces.push_back(soup.faces[face]);
  std::swap(repeated.faces.back()[0], repeated.faces.back()[1]);
  EXPECT_LE((field_of(repeated) - field_of(soup)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(IntrinsicDelaunay, only_a_surface_without_a_direction_needs_two_sheets) {
  PolygonSoup soup = makers::torus(7, 9);
  for (std::size_t face = 0; face < soup.faces.size(); face += 2) std::swap(soup.faces[face][0], soup.faces[face][1]);
  EXPECT_EQ(cover_of(*make_mesh(soup)).sheets, 1);
  EXPECT_LE((Eigen::MatrixXd(stiffness(soup)) - Eigen::MatrixXd(stiffness(makers::torus(7, 9)))).cwiseAbs().maxCoeff(),
            1e-12);
  for (const PolygonSoup& twisted : {makers::moebius(9), makers::klein_bottle(6, 7), makers::book(3, 2)})
    EXPECT_EQ(cover_of(make_mesh(twisted)->triangulated()).sheets, 2);
}

TEST(IntrinsicDelaunay, glued_sides_of_faces_around_an_edge_see_the_same_space) {
  for (const Index pages : {3, 4, 5, 12}) {
    PolygonSoup soup = triangles_of(makers::book(pages, 2));
    std::shuffle(soup.faces.begin(), soup.faces.end(), std::mt19937(static_cast<unsigned>(pages)));
    const Cover sheets = cover_of(*make_mesh(soup));
    EXPECT_EQ(sheets.sheets, 2);
    const auto& half_edges = sheets.triangles.half_edges();
    Index glued = 0;
    for (Index h = 0; h < static_cast<Index>(half_edges.size()); ++h) {
      const Index t = half_edges[at(h)].twin, next = next_in_triangle(h);
      if (half_edges[at(h)].tail > 2 || half_edges[at(next)].tail > 2) continue; // not on the spine
      ++glued;
      ASSERT_NE(t, IntrinsicTriangulation::kBorder);
      const auto tip = [&](Index g) { return half_edges[at(next_in_triangle(next_in_triangle(g)))].tail; };
      const auto arm = [&](Index g) { return position(soup, tip(g)) - position(soup, half_edges[at(h)].tail); };
      const Vector3 along = position(soup, half_edges[at(next)].tail) - position(soup, half_edges[at(h)].tail);
      const Vector3 seen = cross(along, arm(h)); // from where its vertices turn counter-clockwise
      const double angle = std::atan2(dot(seen, arm(t)), dot(arm(h), arm(t)) - dot(along, arm(h)) * dot(along, arm(t)));
      EXPECT_NEAR(angle, 2 * std::numbers::pi / pages, 1e-9);
    }
    EXPECT_EQ(glued, 2 * 2 * pages);
  }
}

TEST(IntrinsicDelaunay, an_annulus_converges_at_second_order) {
  const auto error = [](Index n) {
    PolygonSoup soup;
    const auto place = [&](Index i, Index j) { return i % (4 * n) + j * 4 * n; };
    for (Index j = 0; j <= n; ++j)
      for (Index i = 0; i < 4 * n; ++i) {
        const double r = 1 + 3.0 * j / n, u = 2 * std::numbers::pi * (i + 1.3 * j) / (4 * n); // sheared
        soup.positions.insert(soup.positions.end(), {r * std::cos(u), r * std::sin(u), 0});
      }
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < 4 * n; ++i) {
        soup.faces.push_back({place(i, j), place(i, j + 1), place(i + 1, j)});
        soup.faces.push_back({place(i + 1, j), place(i, j + 1), place(i + 1, j + 1)});
      }
    Eigen::VectorXd exact(static_cast<Eigen::Index>(soup.positions.size() / 3));
    for (Index v = 0; v < exact.size(); ++v) {
      const Vector3 p = position(soup, v);
      exact[v] = std::log(dot(p, p)) / 2 / std::log(4);
    }
    return (solve(stiffness(soup), border(*make_mesh(soup)), exact) - exact).cwiseAbs().maxCoeff();
  };
  EXPECT_GT(std::log2(error(10) / error(20)), 1.8);
}

TEST(IntrinsicDelaunay, weights_do_not_depend_on_the_scale) {
  const PolygonSoup soup = hilly_grid(6);
  const Eigen::MatrixXd K = stiffness(soup);
  for (const int exponent : {-530, 490}) { // about 1e-160 and 1e147
    PolygonSoup scaled = soup;
    for (double& x : scaled.positions) x = std::ldexp(x, exponent);
    EXPECT_EQ(Eigen::MatrixXd(stiffness(scaled)), K);
  }
}

TEST(IntrinsicDelaunay, weights_are_never_negative_whatever_the_triangles) {
  const double needle = 1e-12;
  PolygonSoup lantern; // of Schwarz: far more rings than a ring has corners
  for (Index j = 0; j <= 60; ++j)
    for (Index i = 0; i < 6; ++i) {
      const double u = std::numbers::pi * (2 * i + j % 2) / 6;
      lantern.positions.insert(lantern.positions.end(), {std::cos(u), std::sin(u), j / 60.0});
    }
  for (Index j = 0; j < 60; ++j)
    for (Index i = 0; i < 6; ++i) {
      const Index shift = j % 2, a = 6 * j + i, b = 6 * j + (i + 1) % 6;
      lantern.faces.push_back({a, b, 6 * (j + 1) + (i + shift) % 6});
      lantern.faces.push_back({6 * (j + 1) + i, 6 * j + (i + 1 - shift) % 6, 6 * (j + 1) + (i + 1) % 6});
    }
  expect_maximum_principle(*make_mesh(lantern), "Schwarz's lantern");

  for (const double stretch : {1e-12, 1e-6, 1e6, 1e12}) {
    PolygonSoup soup = hilly_grid(20);
    for (std::size_t v = 0; v < soup.positions.size(); v += 3) soup.positions[v] *= stretch;
    expect_maximum_principle(*make_mesh(soup), "stretched " + std::to_string(stretch));
  }
  PolygonSoup needles = hilly_grid(10);
  for (std::size_t v = 0; v + 3 < needles.positions.size(); v += 6)
    for (std::size_t k = 0; k < 3; ++k)
      needles.positions[v + 3 + k] = needles.positions[v + k] + needle * static_cast<double>(k);
  expect_maximum_principle(*make_mesh(needles), "needles");

  PolygonSoup block = hilly_grid(10);
  for (std::size_t v = 3 * 30; v < 3 * 80; v += 3)
    for (std::size_t k = 0; k < 3; ++k) block.positions[v + k] = block.positions[k];
  expect_maximum_principle(*make_mesh(block), "a collapsed block");

  PolygonSoup line = hilly_grid(10);
  for (std::size_t v = 0; v < line.positions.size(); v += 3) line.positions[v + 1] = line.positions[v + 2] = 0;
  expect_maximum_principle(*make_mesh(line), "all on a line");
  for (double& x : line.positions) x = 7;
  expect_maximum_principle(*make_mesh(line), "all in a point");
}

/// Triangles between random vertices: many faces on an edge, crossing, repeated, in pieces; some of no area.
PolygonSoup random_soup(unsigned seed) {
  std::mt19937 random(seed);
  const auto n = static_cast<Index>(4 + random() % 12), faces = static_cast<Index>(1 + random() % 40);
  PolygonSoup soup;
  for (Index v = 0; v < n; ++v)
    for (int k = 0; k < 3; ++k)
      soup.positions.push_back(std::ldexp(static_cast<double>(random() % 5), random() % 8 == 0 ? -40 : 0));
  while (static_cast<Index>(soup.faces.size()) < faces) {
    const std::vector<Index> face{static_cast<Index>(random()) % n, static_cast<Index>(random()) % n,
                                  static_cast<Index>(random()) % n};
    if (*std::min_element(face.begin(), face.end()) < 0) continue;
    if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) soup.faces.push_back(face);
  }
  return soup;
}

TEST(IntrinsicDelaunay, weights_are_never_negative_on_any_soup) {
  for (unsigned seed = 0; seed < 2000; ++seed)
    expect_maximum_principle(*make_mesh(random_soup(seed)), "seed " + std::to_string(seed));
}

TEST(IntrinsicDelaunay, flips_that_were_given_up_are_told_and_break_no_maximum_principle) {
  const auto mesh = make_mesh(hilly_grid(30));
  const auto field = [&] {
    return HarmonicSolver(*mesh, {}, Laplacian::intrinsic_delaunay)
        .paint(std::vector<Index>{0, 500}, Eigen::Vector2d(0, 1));
  };
  ASSERT_TRUE(field().report.warnings.empty());
  flip_limit = 5;
  const Stiffness stiffness = make_stiffness(*mesh, Laplacian::intrinsic_delaunay);
  const Field stopped = field();
  expect_maximum_principle(*mesh, "given up");
  flip_limit = 0;
  EXPECT_GT(stiffness.delaunay.unflipped, 1);
  EXPECT_TRUE(stiffness.maximum_principle);
  EXPECT_EQ(stopped.report.outside, 0);
  ASSERT_EQ(stopped.report.warnings.size(), 1U);
  const std::string told = "negative weights of " + std::to_string(stiffness.delaunay.unflipped) + " edges";
  EXPECT_NE(stopped.report.warnings.front().find(told), std::string::npos) << stopped.report.warnings.front();
}

TEST(IntrinsicDelaunay, free_borders_opposite_to_very_obtuse_angles_are_counted_and_told) {
  const auto triangle = [](double height) { return make_mesh({{0, 0, 0, 2, 0, 0, 1, height, 0}, {{0, 1, 2}}}); };
  const auto mesh = triangle(0.4);
  const std::vector<std::array<Index, 2>> first{{0, 1}};
  EXPECT_EQ(make_stiffness(*mesh, Laplacian::intrinsic_delaunay).delaunay.obtuse, first);
  EXPECT_TRUE(make_stiffness(*triangle(0.5), Laplacian::intrinsic_delaunay).delaunay.obtuse.empty()); // 127 degrees

  HarmonicSolver solver(*mesh, {}, Laplacian::intrinsic_delaunay);
  const Field field = solver.paint(std::vector<Index>{0, 2}, Eigen::Vector2d(0, 1));
  ASSERT_EQ(field.report.warnings.size(), 1U);
  EXPECT_TRUE(field.report.warnings.front().starts_with("1 border edge that is not painted"))
      << field.report.warnings.front();
  EXPECT_TRUE(solver.paint(std::vector<Index>{0, 1}, Eigen::Vector2d(0, 1)).report.warnings.empty());
}

TEST(IntrinsicDelaunay, is_the_same_whatever_the_thread_count) {
  const auto mesh = make_mesh(hilly_grid(150));
  const SparseMatrix K = stiffness(*mesh);
  thread_limit = 1;
  const SparseMatrix serial = stiffness(*mesh);
  thread_limit = 0;
  ASSERT_EQ(serial.nonZeros(), K.nonZeros());
  EXPECT_TRUE(std::equal(K.valuePtr(), K.valuePtr() + K.nonZeros(), serial.valuePtr()));
}

} // namespace
} // namespace dirichlet
