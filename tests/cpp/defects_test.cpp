// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/defects.h"

#include <gtest/gtest.h>

#include "dirichlet/field.h"
#include "dirichlet/isolines.h"
#include "mesh_makers.h"

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
    for (const std::size_t f : {4, 1}) {
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
