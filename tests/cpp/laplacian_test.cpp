// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/laplacian.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "mesh_makers.h"

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

} // namespace
} // namespace dirichlet
