// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/injection.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "mesh_makers.h"
#include "refusal.h"

namespace dirichlet {
namespace {

using makers::make_mesh;

struct Problem {
  SparseMatrix K = graph_stiffness(*make_mesh(makers::grid(4, 3, false)));
  Mask mask = Mask(20, 0);
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(20, 20), I = Eigen::MatrixXd::Identity(20, 20);
  Problem() {
    for (const std::size_t v : {0U, 1U, 7U, 13U, 19U}) mask[v] = 1;
    for (Eigen::Index i = 0; i < 20; ++i) M(i, i) = mask[static_cast<std::size_t>(i)];
  }
};

TEST(Injection, is_the_papers_equation_three) {
  const Problem p;
  const SparseMatrix L = random_walk(p.K);
  EXPECT_EQ(Eigen::MatrixXd(inject(L, p.mask)), (p.I - p.M) * Eigen::MatrixXd(L) + p.M);
}

TEST(Injection, its_symmetric_twin_is_symmetric_positive_definite) {
  const Problem p;
  const Eigen::MatrixXd twin =
      Eigen::MatrixXd(Eigen::MatrixXd(inject_symmetric(p.K, p.mask)).selfadjointView<Eigen::Lower>());
  EXPECT_EQ(twin, (p.I - p.M) * Eigen::MatrixXd(p.K) * (p.I - p.M) + p.M);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(twin).eigenvalues()[0], 0);
}

TEST(Injection, the_twin_has_the_solution_of_the_papers_matrix) {
  const Problem p;
  const Eigen::VectorXd prescribed = p.M * Eigen::VectorXd::Random(20);
  const Eigen::VectorXd paper = Eigen::MatrixXd(inject(random_walk(p.K), p.mask)).partialPivLu().solve(prescribed);
  const Eigen::MatrixXd twin = Eigen::MatrixXd(inject_symmetric(p.K, p.mask)).selfadjointView<Eigen::Lower>();
  const Eigen::VectorXd ours = twin.llt().solve(inject_right_hand_side(p.K, p.mask, prescribed));
  EXPECT_LE((paper - ours).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Injection, the_right_hand_side_keeps_painted_values_bit_for_bit_and_moves_known_columns) {
  const Problem p;
  const Eigen::MatrixXd prescribed = Eigen::MatrixXd::Random(20, 3); // source where free
  const Eigen::MatrixXd free = p.I - p.M;
  const Eigen::MatrixXd expected = p.M * prescribed + free * (prescribed - Eigen::MatrixXd(p.K) * p.M * prescribed);
  const Eigen::MatrixXd rhs = inject_right_hand_side(p.K, p.mask, prescribed);
  EXPECT_LE((rhs - expected).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(p.M * rhs, p.M * prescribed);
}

TEST(FreeRegions, paint_across_a_strip_cuts_it_in_two_and_each_side_knows_its_rim) {
  const SparseMatrix K = graph_stiffness(*make_mesh(makers::grid(4, 1, false))); // columns 0 … 4, two rows
  Mask mask(10, 0);
  mask[2] = mask[7] = 1;
  const FreeRegions regions = free_regions(K, mask);
  EXPECT_EQ(regions.count, 2);
  EXPECT_EQ(regions.label, (std::vector<Index>{0, 0, -1, 1, 1, 0, 0, -1, 1, 1}));
  EXPECT_EQ(regions.rim, (std::vector<std::array<Index, 2>>{{0, 2}, {1, 2}, {0, 7}, {1, 7}}));
}

TEST(FreeRegions, do_not_meet_through_a_painted_vertex) {
  const makers::PolygonSoup bow_tie{std::vector<double>(15), {{0, 1, 2}, {0, 3, 4}}};
  const FreeRegions regions = free_regions(graph_stiffness(*make_mesh(bow_tie)), {1, 0, 0, 0, 0});
  EXPECT_EQ(regions.label, (std::vector<Index>{-1, 0, 0, 1, 1}));
}

TEST(FreeRegions, a_piece_without_paint_has_no_rim) {
  auto soup = makers::grid(1, 1);
  soup.positions.insert(soup.positions.end(), 3, 0.0);
  Mask mask(5, 0);
  mask[0] = 1;
  const FreeRegions regions = free_regions(graph_stiffness(*make_mesh(soup)), mask);
  EXPECT_EQ(regions.label.back(), 1);
  for (const auto& [region, vertex] : regions.rim) EXPECT_EQ(region, 0);
}

TEST(InjectionRefuses, a_mask_that_does_not_fit) {
  const Problem p;
  EXPECT_REFUSED(inject(p.K, Mask(19)), InputError, "19", "20");
  EXPECT_REFUSED(inject_symmetric(p.K, Mask(21)), InputError, "21", "20");
  EXPECT_REFUSED(free_regions(p.K, Mask(0)), InputError, "0 entries");
}

} // namespace
} // namespace dirichlet
