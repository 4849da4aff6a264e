// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../native/src/solver/ordering.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <utility>

#include <Eigen/OrderingMethods>
#include <gtest/gtest.h>

#include "dirichlet/laplacian.h"
#include "elimination_cost.h"
#include "mesh_makers.h"

namespace dirichlet {
namespace {

using testing::elimination_cost;

struct Rows {
  std::vector<Index> offsets, neighbours;
};

using Edges = std::vector<std::pair<Index, Index>>;

Rows rows(Index n, Edges edges) {
  for (std::size_t k = edges.size(); k-- > 0;) edges.emplace_back(edges[k].second, edges[k].first);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  Rows out{std::vector<Index>(static_cast<std::size_t>(n) + 1, 0), {}};
  for (const auto& [a, b] : edges) {
    ++out.offsets[static_cast<std::size_t>(a) + 1];
    out.neighbours.push_back(b);
  }
  std::partial_sum(out.offsets.begin(), out.offsets.end(), out.offsets.begin());
  return out;
}

/// The pattern of a mesh's stiffness, diagonal included, its vertices renumbered.
Rows mesh_rows(const makers::PolygonSoup& soup, const std::vector<Index>& number) {
  const auto mesh = makers::make_mesh(soup);
  Edges edges;
  for (Index v = 0; v < mesh->vertex_count(); ++v) edges.emplace_back(v, v);
  const auto& ends = mesh->connectivity().edges;
  for (std::size_t e = 0; e < ends.size(); e += 2)
    edges.emplace_back(number[static_cast<std::size_t>(ends[e])], number[static_cast<std::size_t>(ends[e + 1])]);
  return rows(mesh->vertex_count(), std::move(edges));
}

std::vector<Index> identity(std::size_t n) {
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), Index{0});
  return order;
}

std::vector<Index> shuffled(std::size_t n, unsigned seed) {
  std::vector<Index> order = identity(n);
  std::mt19937 random(seed);
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

Rows mesh_rows(const makers::PolygonSoup& soup) {
  return mesh_rows(soup, identity(soup.positions.size() / 3));
}

Rows path(Index n) {
  Edges edges;
  for (Index v = 0; v + 1 < n; ++v) edges.emplace_back(v, v + 1);
  return rows(n, std::move(edges));
}

Rows clique(Index n) {
  Edges edges;
  for (Index a = 0; a < n; ++a)
    for (Index b = 0; b < a; ++b) edges.emplace_back(a, b);
  return rows(n, std::move(edges));
}

Rows stars(Index count, Index rays) {
  Edges edges;
  for (Index s = 0; s < count; ++s)
    for (Index r = 1; r <= rays; ++r) edges.emplace_back(s * (rays + 1), s * (rays + 1) + r);
  return rows(count * (rays + 1), std::move(edges));
}

Rows random_graph(Index n, Index edge_count, unsigned seed) {
  std::mt19937 random(seed);
  const auto any = [&] { return static_cast<Index>(random() % static_cast<unsigned>(n)); };
  Edges edges;
  for (Index e = 0; e < edge_count; ++e) edges.emplace_back(any(), any()); // diagonal entries among them
  return rows(n, std::move(edges));
}

std::vector<Index> order(const Rows& graph) {
  return fill_reducing_order(graph.offsets, graph.neighbours);
}

testing::EliminationCost cost(const Rows& graph) {
  return elimination_cost(graph.offsets, graph.neighbours, order(graph));
}

testing::EliminationCost minimum_degree_cost(const Rows& graph) {
  const auto n = static_cast<Index>(graph.offsets.size() - 1);
  SparseMatrix A(n, n);
  A.resizeNonZeros(static_cast<Eigen::Index>(graph.neighbours.size()));
  std::copy(graph.offsets.begin(), graph.offsets.end(), A.outerIndexPtr());
  std::copy(graph.neighbours.begin(), graph.neighbours.end(), A.innerIndexPtr());
  std::fill_n(A.valuePtr(), A.nonZeros(), 1.0);
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> P;
  Eigen::AMDOrdering<Index>()(Eigen::SparseMatrix<double, Eigen::ColMajor, Index>(A), P);
  return elimination_cost(graph.offsets, graph.neighbours, {P.indices().data(), static_cast<std::size_t>(n)});
}

void expect_permutation(const Rows& graph, const std::string& name) {
  for (std::vector<Index> all : {order(graph), minimum_degree_order(graph.offsets, graph.neighbours)}) {
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, identity(graph.offsets.size() - 1)) << name;
  }
}

TEST(FillReducingOrder, holds_every_vertex_once_on_graphs_of_every_kind) {
  EXPECT_TRUE(fill_reducing_order({}, {}).empty());
  for (const Index n : {0, 1, 2, 3, 64, 65, 1000}) {
    expect_permutation(path(n), "path " + std::to_string(n));
    expect_permutation(rows(n, {}), "isolated " + std::to_string(n));
  }
  for (const Index n : {3, 64, 65, 66, 200, 500}) expect_permutation(clique(n), "clique " + std::to_string(n));
  for (const Index rays : {5, 63, 64, 300, 5000}) expect_permutation(stars(20, rays), "stars " + std::to_string(rays));
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Index n = 1 + static_cast<Index>(seed * seed);
    expect_permutation(random_graph(n, n / 2, seed), "sparse random " + std::to_string(seed));
    expect_permutation(random_graph(n, 3 * n, seed), "random " + std::to_string(seed));
    expect_permutation(random_graph(n, 20 * n, seed), "dense random " + std::to_string(seed));
  }
  expect_permutation(mesh_rows(makers::copies(makers::torus(9, 8), 100)), "tori");
  expect_permutation(mesh_rows(makers::sphere(40, 900)), "poles of high valence");
}

TEST(FillReducingOrder, is_the_same_for_any_number_of_threads_and_every_time) {
  const auto soup = makers::torus(500, 400);
  const Rows graph = mesh_rows(soup, shuffled(soup.positions.size() / 3, 1));
  const auto alone = fill_reducing_order(graph.offsets, graph.neighbours, 1);
  for (const unsigned threads : {1U, 2U, 3U, 16U})
    EXPECT_EQ(fill_reducing_order(graph.offsets, graph.neighbours, threads), alone) << threads << " threads";
}

TEST(FillReducingOrder, factorises_surfaces_in_hardly_more_operations_than_minimum_degree) {
  for (const auto& soup : {makers::grid(200, 200), makers::grid(150, 300, false), makers::torus(200, 150)}) {
    const Rows graph = mesh_rows(soup);
    EXPECT_LE(cost(graph).flops, 1.1 * minimum_degree_cost(graph).flops);
  }
}

TEST(FillReducingOrder, factorises_small_surfaces_about_as_well_as_minimum_degree) {
  for (const Index n : {4, 8, 12, 20, 40}) {
    const Rows graph = mesh_rows(makers::grid(n, n));
    EXPECT_LE(cost(graph).flops, 1.15 * minimum_degree_cost(graph).flops) << n;
  }
}

TEST(FillReducingOrder, hardly_depends_on_the_numbering_of_the_vertices) {
  const auto soup = makers::torus(200, 150);
  const double flops = cost(mesh_rows(soup)).flops;
  for (const unsigned seed : {1U, 2U, 3U}) {
    const double other = cost(mesh_rows(soup, shuffled(soup.positions.size() / 3, seed))).flops;
    EXPECT_LE(std::max(flops, other) / std::min(flops, other), 1.25) << seed;
  }
}

TEST(MinimumDegreeOrder, fills_in_nothing_on_stars_and_little_on_surfaces) {
  const auto cost = [](const Rows& graph) {
    return elimination_cost(graph.offsets, graph.neighbours, minimum_degree_order(graph.offsets, graph.neighbours));
  };
  EXPECT_EQ(cost(stars(300, 20)).entries, 300 * 41);
  const Rows graph = mesh_rows(makers::grid(60, 60));
  EXPECT_LE(cost(graph).flops, 1.1 * minimum_degree_cost(graph).flops);
}

TEST(FillReducingOrder, fills_in_nothing_on_stars_and_forests_of_isolated_vertices) {
  const Rows graph = stars(300, 20);
  EXPECT_EQ(cost(graph).entries, 300 * 41);
  EXPECT_EQ(cost(rows(1000, {})).entries, 1000);
}

TEST(FillReducingOrder, treats_components_as_if_each_were_alone) {
  const auto soup = makers::grid(40, 40);
  const double alone = cost(mesh_rows(soup)).flops;
  EXPECT_LE(cost(mesh_rows(makers::copies(soup, 50))).flops, 1.1 * 50 * alone);
}

TEST(FillReducingOrder, is_not_fooled_by_a_vertex_that_everybody_knows) {
  const Rows plain = mesh_rows(makers::grid(100, 100));
  const auto n = static_cast<Index>(plain.offsets.size() - 1);
  Edges edges;
  for (Index v = 0; v < n; ++v) {
    edges.emplace_back(v, n);
    for (Index e = plain.offsets[static_cast<std::size_t>(v)]; e < plain.offsets[static_cast<std::size_t>(v) + 1]; ++e)
      edges.emplace_back(v, plain.neighbours[static_cast<std::size_t>(e)]);
  }
  const auto with_hub = cost(rows(n + 1, std::move(edges)));
  EXPECT_LE(with_hub.entries, 1.05 * (cost(plain).entries + n));
}

TEST(FillReducingOrder, survives_a_path_of_a_million_vertices_with_little_fill) {
  constexpr Index kLength = 1'000'000;
  EXPECT_LE(cost(path(kLength)).entries, 3.0 * kLength);
}

} // namespace
} // namespace dirichlet
