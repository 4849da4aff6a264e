// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/laplacian.h"

#include <algorithm>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "mesh_makers.h"
#include "parallel.h"
#include "refusal.h"

namespace dirichlet {
namespace {

using makers::make_mesh;

/// D − A written down entry by entry from the faces.
Eigen::MatrixXd dense_stiffness(const makers::PolygonSoup& soup) {
  const auto n = static_cast<Eigen::Index>(soup.positions.size() / 3);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  for (const auto& face : soup.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i], b = face[(i + 1) % face.size()];
      A(a, b) = A(b, a) = 1;
    }
  return Eigen::MatrixXd(A.rowwise().sum().asDiagonal()) - A;
}

std::vector<makers::PolygonSoup> soups() {
  auto damaged = makers::grid(4, 3, false);
  damaged.faces.push_back(damaged.faces[0]);               // a duplicate face
  damaged.positions.insert(damaged.positions.end(), 3, 0); // an isolated vertex
  return {makers::grid(3, 4), makers::torus(5, 4, false), makers::moebius(6), damaged};
}

TEST(GraphStiffness, is_valence_minus_adjacency_of_the_polygon_edges) {
  for (const auto& soup : soups()) EXPECT_EQ(Eigen::MatrixXd(graph_stiffness(*make_mesh(soup))), dense_stiffness(soup));
}

TEST(GraphStiffness, columns_ascend_in_every_row_and_every_diagonal_is_stored) {
  for (const auto& soup : soups()) {
    const SparseMatrix K = graph_stiffness(*make_mesh(soup));
    for (Index i = 0; i < K.rows(); ++i) {
      Eigen::Index last = -1;
      bool diagonal = false;
      for (SparseMatrix::InnerIterator entry(K, i); entry; ++entry) {
        EXPECT_GT(entry.col(), last);
        last = entry.col();
        diagonal |= last == i;
      }
      EXPECT_TRUE(diagonal);
    }
  }
}

TEST(RandomWalk, rows_sum_to_zero_with_a_unit_diagonal_but_an_isolated_vertex_has_no_equation) {
  const auto soup = soups().back();
  const SparseMatrix L = random_walk(graph_stiffness(*make_mesh(soup)));
  const Eigen::Index isolated = L.rows() - 1;
  EXPECT_LE((L * Eigen::VectorXd::Ones(L.cols())).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_TRUE(Eigen::VectorXd(L.diagonal()).head(isolated).isOnes(0));
  EXPECT_EQ(L.coeff(isolated, isolated), 0);
}

TEST(LaplaceOperator, of_the_graph_is_the_random_walk) {
  for (const auto& soup : soups()) {
    const auto mesh = make_mesh(soup);
    const SparseMatrix L = laplace_operator(make_stiffness(*mesh, Laplacian::graph));
    EXPECT_EQ(Eigen::MatrixXd(L), Eigen::MatrixXd(random_walk(graph_stiffness(*mesh))));
  }
}

TEST(Stiffness, has_a_maximum_principle_where_no_weight_is_negative) {
  auto stretched = makers::grid(5, 4, false);
  for (std::size_t x = 0; x < stretched.positions.size(); x += 3) stretched.positions[x] *= 9;
  auto sheared = makers::grid(5, 4);
  for (std::size_t x = 0; x < sheared.positions.size(); x += 3) sheared.positions[x] -= 3 * sheared.positions[x + 1];
  const auto holds = [](const makers::PolygonSoup& soup, Laplacian laplacian) {
    return make_stiffness(*make_mesh(soup), laplacian).maximum_principle;
  };
  EXPECT_TRUE(holds(makers::grid(5, 4), Laplacian::cotangent));
  EXPECT_FALSE(holds(sheared, Laplacian::cotangent));
  EXPECT_TRUE(holds(sheared, Laplacian::graph));
  EXPECT_TRUE(holds(makers::grid(5, 4, false), Laplacian::polygon));
  EXPECT_FALSE(holds(stretched, Laplacian::polygon));
}

TEST(Stiffness, is_the_same_whatever_the_number_of_threads) {
  const auto triangles = make_mesh(makers::torus(220, 110)), quads = make_mesh(makers::torus(220, 110, false));
  for (const Laplacian laplacian : {Laplacian::cotangent, Laplacian::polygon}) {
    const Mesh& mesh = laplacian == Laplacian::polygon ? *quads : *triangles;
    thread_limit = 1;
    const Stiffness alone = make_stiffness(mesh, laplacian);
    for (const unsigned threads : {2U, 5U}) {
      thread_limit = threads;
      const Stiffness together = make_stiffness(mesh, laplacian);
      EXPECT_TRUE(std::equal(alone.K.valuePtr(), alone.K.valuePtr() + alone.K.nonZeros(), together.K.valuePtr()));
      EXPECT_EQ(alone.mass, together.mass);
    }
    thread_limit = 0;
  }
}

TEST(Stiffness, names_faces_by_their_number_among_all_though_repeats_are_left_out) {
  auto soup = makers::grid(3, 3, false);
  const auto n = static_cast<Index>(soup.positions.size() / 3);
  soup.faces.push_back(soup.faces.front());
  for (const Index k : {0, 2, 4, 1, 3}) { // a pentagram
    const double angle = 2 * std::numbers::pi * k / 5;
    soup.positions.insert(soup.positions.end(), {std::cos(angle), std::sin(angle), 9});
  }
  soup.faces.push_back({n, n + 1, n + 2, n + 3, n + 4});
  EXPECT_REFUSED(make_stiffness(*make_mesh(soup), Laplacian::cotangent), TopologyError, "face 10 crosses itself");

  soup = makers::grid(3, 3);
  soup.faces.push_back(soup.faces.front());
  soup.faces.emplace_back();
  for (Index i = 0; i < 9000; ++i) {
    soup.faces.back().push_back(static_cast<Index>(soup.positions.size() / 3));
    soup.positions.insert(soup.positions.end(), {std::cos(1e-3 * i), std::sin(1e-3 * i), 9});
  }
  soup.faces.push_back({1, 2, 3});
  EXPECT_REFUSED(make_stiffness(*make_mesh(soup), Laplacian::polygon), InputError, "face 19 with its 9000 corners",
                 "beyond the 7000");
}

/// Regular polygons, one above the other.
makers::PolygonSoup stack(Index faces, Index corners) {
  makers::PolygonSoup soup;
  for (Index f = 0; f < faces; ++f) {
    soup.faces.emplace_back();
    for (Index i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      soup.faces.back().push_back(f * corners + i);
      soup.positions.insert(soup.positions.end(), {std::cos(angle), std::sin(angle), 1.0 * f});
    }
  }
  return soup;
}

TEST(Stiffness, of_many_polygons_is_refused_by_the_pairs_that_all_make) {
  EXPECT_REFUSED(make_stiffness(*make_mesh(stack(4400, 500)), Laplacian::polygon), InputError,
                 "face 0 with its 500 corners, make 548900000 pairs of corners", "there is memory for");
}

TEST(Stiffness, of_large_polygons_is_refused_by_the_time_that_all_take) {
  EXPECT_REFUSED(make_stiffness(*make_mesh(stack(3, 5000)), Laplacian::polygon), InputError,
                 "the large faces, the largest of which is face 0 with its 5000 corners, take more time together",
                 "the other Laplacians take any number");
}

TEST(Laplacian, a_triangle_that_two_polygons_share_counts_once) {
  const makers::PolygonSoup quads = makers::grid(3, 3, false);
  for (const Laplacian laplacian : {Laplacian::cotangent, Laplacian::intrinsic_delaunay}) {
    makers::PolygonSoup more = quads;
    const std::vector<Index> quad = quads.faces[4];
    more.faces.push_back({quad[0], quad[1], quad[2]});
    more.faces.push_back({quad[3], quad[2], quad[0]}); // the other half, turned to the same side
    const Stiffness once = make_stiffness(*make_mesh(quads), laplacian);
    const Stiffness shared = make_stiffness(*make_mesh(more), laplacian);
    EXPECT_LE((Eigen::MatrixXd(once.K) - Eigen::MatrixXd(shared.K)).cwiseAbs().maxCoeff(), 1e-13);
    for (std::size_t v = 0; v < once.mass.size(); ++v) EXPECT_NEAR(shared.mass[v], once.mass[v], 1e-13);
  }
}

} // namespace
} // namespace dirichlet
