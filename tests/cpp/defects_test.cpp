// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/defects.h"

#include <cmath>

#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "dirichlet/field.h"
#include "dirichlet/isolines.h"
#include "dirichlet/levels.h"
#include "mesh_makers.h"
#include "refusal.h"

namespace dirichlet {
namespace {

using makers::make_mesh;
using makers::PolygonSoup;

PolygonSoup scaled(PolygonSoup soup, double factor) {
  for (double& x : soup.positions) x *= factor;
  return soup;
}

TEST(Defects, of_ordinary_meshes_are_none_at_any_scale) {
  for (const double scale : {1e-160, 1.0, 1e148})
    for (const PolygonSoup& soup :
         {makers::grid(7, 5), makers::grid(4, 4, false), makers::torus(7, 5), makers::moebius(7), makers::sphere(4, 6),
          makers::book(5, 3), makers::tetrahedron()})
      EXPECT_TRUE(find_defects(*make_mesh(scaled(soup, scale / 3))).warnings().empty());
}

TEST(Defects, repeated_faces_are_found_in_any_direction_from_any_corner) {
  for (const bool triangles : {true, false}) {
    PolygonSoup soup = makers::grid(3, 3, triangles);
    const auto count = static_cast<Index>(soup.faces.size());
    for (const std::size_t f : {std::size_t{4}, std::size_t{1}}) {
      std::vector<Index> face = soup.faces[f];
      std::rotate(face.begin(), face.begin() + 1, face.end());
      soup.faces.push_back(face);
      std::reverse(face.begin(), face.end());
      soup.faces.push_back(face);
    }
    const auto mesh = make_mesh(soup);
    const std::vector<std::array<Index, 2>> expected{{count, 4}, {count + 1, 4}, {count + 2, 1}, {count + 3, 1}};
    EXPECT_EQ(std::vector(mesh->repeated_faces().begin(), mesh->repeated_faces().end()), expected);
    const Mesh& once = mesh->without_repeats();
    EXPECT_EQ(once.face_count(), count);
    EXPECT_TRUE(std::ranges::equal(once.connectivity().edges, mesh->connectivity().edges));
    EXPECT_TRUE(once.repeated_faces().empty());
    EXPECT_EQ(&once.without_repeats(), &once);
  }
}

TEST(Defects, quads_over_the_same_vertices_in_another_order_are_no_repeats) {
  PolygonSoup soup = makers::grid(1, 1, false);
  soup.faces = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 1, 3, 2}};
  EXPECT_TRUE(make_mesh(soup)->repeated_faces().empty());
}

TEST(Defects, two_faces_back_to_back_are_a_pillow_but_not_beside_others) {
  PolygonSoup soup = makers::grid(1, 1);
  soup.faces = {{0, 1, 2}, {2, 1, 0}};
  EXPECT_TRUE(make_mesh(soup)->repeated_faces().empty());
  soup.faces = {{0, 1, 2}, {1, 2, 0}};
  EXPECT_EQ(make_mesh(soup)->repeated_faces().size(), 1);
  soup.faces = {{0, 1, 2}, {2, 1, 0}, {1, 3, 2}};
  EXPECT_EQ(make_mesh(soup)->repeated_faces().size(), 1);
}

TEST(Defects, lines_pass_faces_that_are_there_twice_as_if_they_were_there_once) {
  PolygonSoup soup = makers::torus(12, 9);
  const auto once = make_mesh(soup);
  const auto again = soup.faces;
  soup.faces.insert(soup.faces.end(), again.begin(), again.begin() + 100);
  const auto twice = make_mesh(soup);
  std::vector<double> height;
  for (std::size_t v = 2; v < soup.positions.size(); v += 3) height.push_back(soup.positions[v]);
  const std::vector<double> levels{-0.3, 0.1};
  EXPECT_EQ(extract_isolines(*twice, height, levels).points, extract_isolines(*once, height, levels).points);
}

TEST(Defects, faces_without_an_area_are_counted_at_any_scale) {
  for (const double scale : {1e-160, 1.0, 1e148}) {
    PolygonSoup soup = makers::grid(4, 4);
    soup.faces.push_back({0, 1, 2});    // on a line
    soup.faces.push_back({0, 2, 3, 4}); // the same with more corners
    const Defects defects = find_defects(*make_mesh(scaled(soup, scale)));
    EXPECT_EQ(defects.flat_faces, 2);
    EXPECT_EQ(defects.first_flat, 32);
  }
}

TEST(Defects, faces_without_an_area_are_counted_by_one_measure_and_repeated_ones_once) {
  auto soup = makers::grid(60, 60, false); // several threads' worth
  const auto n = static_cast<Index>(soup.positions.size() / 3);
  for (const double x : {0.1, 0.2, 0.3, 0.4}) soup.positions.insert(soup.positions.end(), {3 * x, 7 * x, 9 * x});
  soup.faces.push_back(soup.faces.front()); // counts once, and does not shift the numbers of those after it
  for (const std::vector<Index>& face :
       {std::vector{n, n + 1, n + 2, n + 3}, {n, n + 1, n + 2}, {n + 1, n + 2, n}, {n + 1, n + 2, n + 3}})
    soup.faces.push_back(face); // on a line but for rounding
  const auto mesh = make_mesh(soup);
  EXPECT_TRUE(std::ranges::equal(mesh->flat_faces(), std::vector<Index>{3601, 3602, 3604}));
  for (const Laplacian laplacian :
       {Laplacian::graph, Laplacian::cotangent, Laplacian::intrinsic_delaunay, Laplacian::polygon}) {
    HarmonicSolver solver(*mesh, {}, laplacian);
    const SolveReport report = solver.paint(std::vector<Index>{0, 5}, Eigen::Vector2d(0, 1)).report;
    EXPECT_EQ(report.flat_faces, 3);
    EXPECT_EQ(report.warnings.at(1), "face 3601 has no area (and 2 more faces)");
  }
}

TEST(Defects, ends_of_edges_without_length_are_no_seam) {
  PolygonSoup soup = makers::grid(3, 2);
  std::copy_n(soup.positions.begin() + 3, 3, soup.positions.begin() + 6); // 1 and 2, next to each other on the border
  EXPECT_EQ(find_defects(*make_mesh(soup)).coincident_vertices, 0);
  std::copy_n(soup.positions.begin() + 3, 3, soup.positions.begin() + 9); // and 3, which an edge joins to 2 alone
  EXPECT_EQ(find_defects(*make_mesh(soup)).coincident_vertices, 0);
  std::copy_n(soup.positions.begin() + 3, 3, soup.positions.begin() + 30); // 10, and 11 beside it, across the grid
  std::copy_n(soup.positions.begin() + 3, 3, soup.positions.begin() + 33);
  const Defects defects = find_defects(*make_mesh(soup));
  EXPECT_EQ(defects.coincident_vertices, 1);
  EXPECT_EQ(defects.first_coincident, (std::array<Index, 2>{1, 10}));
}

TEST(Defects, quads_two_of_whose_sides_cross_are_told_at_any_scale) {
  for (const double scale : {1e-160, 1.0, 1e148}) {
    PolygonSoup soup = makers::grid(4, 4, false);
    std::swap(soup.faces[7][0], soup.faces[7][1]);
    std::swap(soup.faces[9][2], soup.faces[9][3]);
    soup.faces.push_back(soup.faces[9]);
    for (std::size_t z = 2; z < soup.positions.size(); z += 3)
      soup.positions[z] = 0.02 * std::sin(static_cast<double>(z));
    const auto mesh = make_mesh(scaled(soup, scale));
    const Defects defects = find_defects(*mesh);
    EXPECT_EQ(defects.crossing_faces, 2);
    EXPECT_EQ(defects.first_crossing, 7);
    HarmonicSolver solver(*mesh, {}, Laplacian::cotangent);
    EXPECT_EQ(solver.paint(std::vector<Index>{0, 24}, Eigen::Vector2d(0, 1)).report.warnings.at(1),
              "face 7 crosses itself (and 1 more face), so its triangles lie on each other");
  }
}

TEST(Defects, vertices_of_a_seam_are_counted_and_the_first_pair_is_named) {
  PolygonSoup soup = makers::grid(3, 2);
  const auto size = static_cast<Index>(soup.positions.size() / 3);
  PolygonSoup joined = soup; // above it, with the four vertices of the seam doubled
  for (std::size_t i = 0; i < soup.positions.size(); ++i)
    joined.positions.push_back(soup.positions[i] + (i % 3 == 1 ? 2 : 0));
  joined.positions[3 * 8] = -0.0; // the seam's first vertex, the lower one
  for (std::vector<Index> face : soup.faces) {
    for (Index& v : face) v += size;
    joined.faces.push_back(face);
  }
  const Defects defects = find_defects(*make_mesh(joined));
  EXPECT_EQ(defects.coincident_vertices, 4);
  EXPECT_EQ(defects.first_coincident, (std::array<Index, 2>{8, 12}));
  EXPECT_NE(defects.warnings().at(0).find("merging by distance"), std::string::npos);
}

TEST(Defects, faces_are_named_by_their_number_among_all_though_repeats_are_left_out) {
  PolygonSoup soup = makers::torus(5, 4, false);
  const auto n = static_cast<Index>(soup.positions.size() / 3);
  soup.faces.insert(soup.faces.begin() + 3, soup.faces[2]);
  soup.positions.insert(soup.positions.end(), {0, 0, 9, 2, 2, 9, 3, 1, 9, 2, 0, 9, 0, 2, 9});
  soup.faces.push_back({n, n + 1, n + 2, n + 3, n + 4});
  const auto mesh = make_mesh(soup);
  std::vector<double> field;
  for (std::size_t v = 0; v < soup.positions.size(); v += 3) field.push_back(soup.positions[v]);
  const std::vector<double> levels{0.5};
  EXPECT_REFUSED(extract_isolines(*mesh, field, levels), TopologyError, "face 21 crosses itself");
  EXPECT_REFUSED(equal_area_levels(*mesh, field, 3), TopologyError, "face 21 crosses itself");
  EXPECT_EQ(&mesh->without_inner_repeats(), &mesh->without_repeats()); // kept, and made once
  EXPECT_EQ(mesh->without_repeats().number_with_repeats(2), 2);
  EXPECT_EQ(mesh->without_repeats().number_with_repeats(3), 4);
}

TEST(Defects, repeats_at_a_border_stay_for_lines) {
  PolygonSoup soup = makers::grid(3, 3);
  const auto count = static_cast<Index>(soup.faces.size());
  soup.faces.push_back(soup.faces[0]); // at the border
  const auto border = make_mesh(soup);
  EXPECT_EQ(&border->without_inner_repeats(), border.get()); // and no other mesh is made
  soup.faces.push_back(soup.faces[9]);                       // inside
  const auto mesh = make_mesh(soup);
  EXPECT_EQ(mesh->without_repeats().face_count(), count);
  EXPECT_EQ(mesh->without_inner_repeats().face_count(), count + 1);
  EXPECT_EQ(&mesh->without_inner_repeats(), &mesh->without_inner_repeats());
}

TEST(Defects, are_told_with_every_field) {
  PolygonSoup soup = makers::grid(3, 3);
  soup.faces.push_back(soup.faces[2]);
  const auto mesh = make_mesh(soup);
  HarmonicSolver solver(*mesh);
  for (const Index v : {5, 6}) {
    const Field field = solver.paint(std::vector<Index>{0, v}, Eigen::Vector2d(0, 1));
    ASSERT_EQ(field.report.warnings.size(), 1);
    EXPECT_EQ(field.report.warnings[0], "face 18 repeats face 2, and counts once");
  }
}

} // namespace
} // namespace dirichlet
