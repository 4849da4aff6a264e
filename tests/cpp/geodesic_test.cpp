// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/geodesic.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <thread>

#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "line_checks.h"
#include "mesh_makers.h"
#include "refusal.h"

namespace dirichlet {
namespace {

using makers::make_mesh;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Index> all_vertices(const Mesh& mesh) {
  std::vector<Index> vertices(at(mesh.vertex_count()));
  std::iota(vertices.begin(), vertices.end(), 0);
  return vertices;
}

/// The largest difference between the distances from a point and expected(position).
template <class Expected>
double error(const Mesh& mesh, const Point& point, const Expected& expected) {
  const GeodesicDisc disc = geodesic_disc(mesh, point, kInfinity);
  EXPECT_EQ(disc.vertices, all_vertices(mesh));
  double worst = 0;
  for (const Index v : disc.vertices)
    worst = std::max(worst, std::abs(disc.distances[at(v)] - expected(position(mesh, v))));
  return worst;
}

std::vector<Index> round_disc(const Mesh& mesh, const Point& point, double radius) {
  std::vector<Index> inside = all_vertices(mesh);
  std::erase_if(inside, [&](Index v) { return distance(point, position(mesh, v)) > radius; });
  return inside;
}

makers::PolygonSoup moved(makers::PolygonSoup soup, double scale, const Point& shift) {
  for (std::size_t i = 0; i < soup.positions.size(); i += 3) { // turned by the angle of 3, 4, 5
    const double x = soup.positions[i], y = soup.positions[i + 1], z = soup.positions[i + 2];
    soup.positions[i] = scale * (0.6 * x - 0.8 * y) + shift[0];
    soup.positions[i + 1] = scale * (0.8 * x + 0.6 * y) + shift[1];
    soup.positions[i + 2] = scale * z + shift[2];
  }
  return soup;
}

TEST(GeodesicDisc, is_the_round_disc_on_a_plane_of_triangles_or_quads) {
  for (const bool triangles : {true, false}) {
    const auto mesh = make_mesh(makers::grid(17, 23, triangles));
    for (const Point& p : {Point{8.3, 11.6, 0}, Point{4, 9, 0}, Point{4.5, 9, 0}, Point{4.25, 9.25, 0}, Point{0, 0, 0},
                           Point{4.2, 9 + 1e-12, 0}}) {
      EXPECT_LT(error(*mesh, p, [&](const Point& q) { return distance(p, q); }), 1e-11);
      EXPECT_EQ(geodesic_disc(*mesh, p, 5.37).vertices, round_disc(*mesh, p, 5.37));
    }
  }
}

TEST(GeodesicDisc, is_round_around_a_point_on_an_edge_or_beside_a_vertex) {
  const auto mesh = make_mesh(makers::grid(9, 9));
  for (double t = 1e-9; t < 1; t += 1.0 / 64)
    for (const Point& p : {Point{4 + t, 4, 0}, Point{4 + t, 4 + t, 0}, Point{4 + t, 4 + t / 1e9, 0}})
      EXPECT_LT(error(*mesh, p, [&](const Point& q) { return distance(p, q); }), 1e-12);
}

TEST(GeodesicDisc, is_the_same_on_needles_and_on_triangles_without_an_area) {
  auto needles = makers::grid(15, 15), doubled = needles, slanted = needles;
  for (std::size_t i = 0; i < needles.positions.size(); i += 3) {
    needles.positions[i] *= 50;
    slanted.positions[i] -= 2.3 * slanted.positions[i + 1];
    doubled.positions[i] = std::floor(doubled.positions[i] / 2); // every other column is flat
  }
  for (const auto& soup : {needles, slanted, doubled}) {
    const auto mesh = make_mesh(soup);
    for (const Index v : {0, 120, 133}) {
      const Point p = position(*mesh, v);
      EXPECT_LT(error(*mesh, p, [&](const Point& q) { return distance(p, q); }), 1e-9);
      for (const double radius : {1.7, 3.3, 5.1, 7.7, 101.0, 260.0})
        EXPECT_EQ(geodesic_disc(*mesh, p, radius).vertices, round_disc(*mesh, p, radius));
    }
  }
}

TEST(GeodesicDisc, unrolls_a_cylinder) {
  makers::PolygonSoup soup = makers::grid(30, 20);
  const double side = 2 * std::sin(std::numbers::pi / 30); // of the regular polygon with 30 corners
  for (std::size_t i = 0; i < soup.positions.size(); i += 3) {
    const double angle = 2 * std::numbers::pi * soup.positions[i] / 30, height = side * soup.positions[i + 1];
    soup.positions[i] = std::cos(angle);
    soup.positions[i + 1] = std::sin(angle);
    soup.positions[i + 2] = height;
  }
  const auto mesh = make_mesh(soup); // slit along a line, so there is one straight way alone
  const GeodesicDisc disc = geodesic_disc(*mesh, position(*mesh, 15 + 31 * 4), kInfinity);
  for (const Index v : disc.vertices)
    EXPECT_NEAR(disc.distances[at(v)], side * std::hypot(v % 31 - 15, v / 31 - 4), 1e-12);
}

TEST(GeodesicDisc, has_an_error_that_falls_as_a_sphere_is_refined) {
  double last = kInfinity;
  for (const Index n : {8, 16, 32, 64}) {
    const auto mesh = make_mesh(makers::sphere(n - 1, 2 * n));
    const Point p = position(*mesh, 1 + n / 3 * 2 * n);
    const GeodesicDisc disc = geodesic_disc(*mesh, p, 2);
    double worst = 0;
    for (std::size_t i = 0; i < disc.vertices.size(); ++i)
      worst = std::max(worst,
                       std::abs(disc.distances[i] - 2 * std::asin(distance(p, position(*mesh, disc.vertices[i])) / 2)));
    EXPECT_LT(worst, 0.7 * last);
    EXPECT_LT(worst, 0.8 / n);
    last = worst;
  }
}

TEST(GeodesicDisc, is_never_nearer_than_straight_through_space_nor_farther_than_along_edges) {
  for (const auto& soup : {makers::torus(31, 17), makers::klein_bottle(24, 20), makers::moebius(19), makers::book(5, 6),
                           makers::sphere(9, 12), makers::tetrahedron()}) {
    const auto mesh = make_mesh(soup);
    const GeodesicDisc disc = geodesic_disc(*mesh, position(*mesh, 3), kInfinity);
    ASSERT_EQ(disc.vertices, all_vertices(*mesh));
    EXPECT_EQ(disc.distances[3], 0);
    for (const Index v : disc.vertices)
      EXPECT_GE(disc.distances[at(v)], distance(position(*mesh, 3), position(*mesh, v)) * (1 - 1e-15));
    const auto& edges = mesh->triangulated().connectivity().edges;
    for (std::size_t e = 0; e < edges.size(); e += 2)
      EXPECT_LE(std::abs(disc.distances[at(edges[e])] - disc.distances[at(edges[e + 1])]),
                distance(position(*mesh, edges[e]), position(*mesh, edges[e + 1])) * (1 + 1e-12));
  }
}

TEST(GeodesicDisc, holds_every_smaller_one) {
  const auto mesh = make_mesh(makers::torus(50, 30));
  GeodesicDisc last;
  for (double radius = 0; radius < 8; radius += 0.37) {
    const GeodesicDisc disc = geodesic_disc(*mesh, {2.1, 0.3, 0.6}, radius);
    EXPECT_TRUE(std::ranges::includes(disc.vertices, last.vertices));
    EXPECT_TRUE(std::ranges::all_of(disc.distances, [=](double d) { return d <= radius; }));
    last = disc;
  }
  EXPECT_EQ(last.vertices, all_vertices(*mesh));
}

TEST(GeodesicDisc, goes_around_a_slit_and_not_across_it) {
  auto soup = makers::grid(20, 20);
  std::erase_if(soup.faces, [](const auto& face) { // a slot from the left border to x = 15
    return std::ranges::all_of(face, [](Index v) { return v % 21 <= 15 && v / 21 >= 10 && v / 21 <= 11; });
  });
  const auto mesh = make_mesh(soup);
  const Index start = 5 + 21 * 10, other_side = 5 + 21 * 11;
  const GeodesicDisc disc = geodesic_disc(*mesh, position(*mesh, start), kInfinity);
  EXPECT_NEAR(disc.distances[at(other_side)], 10 + 1 + 10, 0.5);
  const GeodesicDisc near = geodesic_disc(*mesh, position(*mesh, start), 15);
  EXPECT_FALSE(std::ranges::binary_search(near.vertices, other_side));
}

TEST(GeodesicDisc, never_leaves_its_piece) {
  const auto sheet = makers::grid(6, 6);
  const auto mesh = make_mesh(makers::copies(sheet, 3)); // all in the same place
  const GeodesicDisc disc = geodesic_disc(*mesh, {2, 2, 0}, kInfinity, 72 + 30);
  EXPECT_EQ(disc.vertices.front(), 49);
  EXPECT_EQ(disc.vertices.back(), 97);
  EXPECT_EQ(disc.vertices.size(), 49U);
}

TEST(GeodesicDisc, reaches_every_page_at_an_edge_of_many_faces) {
  const auto mesh = make_mesh(makers::book(5, 6));
  const Point p{0.5, 0, 2.5}; // on the first page; the others unfold about the spine
  const GeodesicDisc disc = geodesic_disc(*mesh, p, kInfinity);
  for (Index page = 1; page < 5; ++page)
    for (Index k = 0; k <= 6; ++k) EXPECT_NEAR(disc.distances[at((page + 1) * 7 + k)], std::hypot(1.5, k - 2.5), 1e-12);
}

TEST(GeodesicDisc, grows_with_the_surface_and_moves_with_it) {
  const auto soup = makers::torus(31, 17);
  const Point middle{2.1, 0.3, 0.6};
  const GeodesicDisc disc = geodesic_disc(*make_mesh(soup), middle, 2);
  EXPECT_GT(disc.vertices.size(), 50U);
  for (const double scale : {1e-200, 1e-20, 1.0, 1e20, 1e140})
    for (const double shift : {0.0, 3.0}) {
      const Point offset{shift * scale, -2 * shift * scale, shift * scale};
      const makers::PolygonSoup point = moved({{middle[0], middle[1], middle[2]}, {}}, scale, offset);
      const GeodesicDisc same = geodesic_disc(*make_mesh(moved(soup, scale, offset)),
                                              {point.positions[0], point.positions[1], point.positions[2]}, 2 * scale);
      ASSERT_EQ(same.vertices, disc.vertices);
      for (std::size_t i = 0; i < disc.distances.size(); ++i)
        EXPECT_NEAR(same.distances[i] / scale, disc.distances[i], 1e-12);
    }
}

TEST(GeodesicDisc, does_not_depend_on_the_order_of_faces_or_their_winding) {
  auto soup = makers::torus(31, 17);
  const GeodesicDisc disc = geodesic_disc(*make_mesh(soup), {2.1, 0.3, 0.6}, 3);
  std::shuffle(soup.faces.begin(), soup.faces.end(), std::mt19937(1));
  const GeodesicDisc same = geodesic_disc(*make_mesh(makers::turned_over(soup, 2)), {2.1, 0.3, 0.6}, 3);
  ASSERT_EQ(same.vertices, disc.vertices);
  for (std::size_t i = 0; i < disc.distances.size(); ++i) EXPECT_NEAR(same.distances[i], disc.distances[i], 1e-12);
}

TEST(GeodesicDisc, with_its_face_named_is_the_one_found_by_a_search) {
  for (const bool triangles : {true, false}) {
    const auto mesh = make_mesh(makers::torus(20, 12, triangles));
    for (Index face = 0; face < mesh->face_count(); face += 7) {
      Point middle{};
      const auto offsets = mesh->offsets();
      const auto corners = mesh->corners().subspan(at(offsets[at(face)]), 3);
      for (const Index v : corners)
        for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] += position(*mesh, v)[axis] / 3;
      const GeodesicDisc found = geodesic_disc(*mesh, middle, 1), named = geodesic_disc(*mesh, middle, 1, face);
      EXPECT_EQ(named.vertices, found.vertices);
      EXPECT_EQ(named.distances, found.distances);
    }
  }
}

TEST(GeodesicDisc, of_a_small_radius_is_the_vertex_that_the_point_is_or_empty) {
  const auto mesh = make_mesh(makers::sphere(9, 12));
  EXPECT_EQ(geodesic_disc(*mesh, position(*mesh, 20), 0).vertices, (std::vector<Index>{20}));
  EXPECT_EQ(geodesic_disc(*mesh, position(*mesh, 20), 0.01).distances, (std::vector<double>{0}));
  EXPECT_TRUE(geodesic_disc(*mesh, {0.1, 0.2, 0.9}, 0).vertices.empty());
  EXPECT_TRUE(geodesic_disc(*mesh, {0.1, 0.2, 0.9}, 1e-9).vertices.empty());
}

TEST(GeodesicDisc, around_a_triangle_that_is_a_point_reaches_the_others) {
  const auto mesh = make_mesh({{0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 4, 0}, {{0, 1, 2}, {2, 3, 4}}});
  const GeodesicDisc disc = geodesic_disc(*mesh, {0, 0, 0}, 10, 0);
  EXPECT_EQ(disc.vertices, (std::vector<Index>{0, 1, 2, 3, 4}));
  EXPECT_EQ(disc.distances, (std::vector<double>{0, 0, 0, 3, 4}));
}

TEST(GeodesicDisc, of_no_point_no_radius_or_no_face_is_refused) {
  const auto mesh = make_mesh(makers::grid(2, 2, false));
  EXPECT_REFUSED(geodesic_disc(*mesh, {0, kNan, 0}, 1), InputError, "nan");
  EXPECT_REFUSED(geodesic_disc(*mesh, {0, 0, kInfinity}, 1), InputError, "inf");
  EXPECT_REFUSED(geodesic_disc(*mesh, {0, 0, 0}, -1), InputError, "radius is -1");
  EXPECT_REFUSED(geodesic_disc(*mesh, {0, 0, 0}, kNan), InputError, "radius is nan");
  EXPECT_REFUSED(geodesic_disc(*mesh, {0, 0, 0}, 1, 4), InputError, "no face 4", "0 to 3");
  EXPECT_REFUSED(geodesic_disc(*mesh, {0, 0, 0}, 1, -1), InputError, "no face -1");
}

TEST(GeodesicDisc, may_be_asked_for_by_several_threads_at_once) {
  const auto mesh = make_mesh(makers::torus(40, 20, false));
  const GeodesicDisc expected = geodesic_disc(*make_mesh(makers::torus(40, 20, false)), {2.1, 0.3, 0.6}, 2);
  std::vector<GeodesicDisc> discs(4);
  std::vector<std::thread> threads;
  for (GeodesicDisc& disc : discs) threads.emplace_back([&] { disc = geodesic_disc(*mesh, {2.1, 0.3, 0.6}, 2); });
  for (std::thread& thread : threads) thread.join();
  for (const GeodesicDisc& disc : discs) EXPECT_EQ(disc.distances, expected.distances);
}

} // namespace
} // namespace dirichlet
