// SPDX-License-Identifier: GPL-3.0-or-later
// Wall time of every stage between arrays in and isolines out, at the size of the paper's Dragon, ten times it, and a
// million vertices: tori with two painted squares, at 0 and at 1.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>

#include "dirichlet/field.h"
#include "dirichlet/isolines.h"
#include "dirichlet/levels.h"
#include "mesh_makers.h"

namespace {

using namespace dirichlet;

/// A torus of side² vertices and its paint.
class Scene {
 public:
  std::unique_ptr<const Mesh> mesh;
  std::vector<Index> painted;
  Eigen::VectorXd values;
  Mask mask;

  explicit Scene(Index side) : mesh(makers::make_mesh(makers::torus(side, side))) {
    mask.assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0);
    for (const Index corner : {0, side / 2})
      for (Index j = corner; j < corner + side / 10; ++j)
        for (Index i = corner; i < corner + side / 10; ++i) painted.push_back(i + j * side);
    for (const Index vertex : painted) mask[static_cast<std::size_t>(vertex)] = 1;
    values.setZero(static_cast<Eigen::Index>(painted.size()));
    values.tail(values.size() / 2).setOnes();
  }

  /// Factored once: the benchmark library calls `solve` several times to find how often to repeat it.
  const HarmonicSolver& solver() {
    if (!solver_) solver_ = std::make_unique<const HarmonicSolver>(*mesh, painted);
    return *solver_;
  }

  /// What the isolines run through: the height, so that their time needs no solver.
  [[nodiscard]] std::vector<double> height() const {
    std::vector<double> result(static_cast<std::size_t>(mesh->vertex_count()));
    for (std::size_t v = 0; v < result.size(); ++v) result[v] = mesh->positions()[3 * v + 1];
    return result;
  }

 private:
  std::unique_ptr<const HarmonicSolver> solver_;
};

/// Made once per size, whichever stages are asked for.
Scene& scene(const benchmark::State& state) {
  static std::map<Index, Scene> scenes;
  const auto side = static_cast<Index>(state.range(0));
  return scenes.try_emplace(side, side).first->second;
}

void connectivity(benchmark::State& state) {
  const Mesh& mesh = *scene(state).mesh;
  for (auto _ : state)
    benchmark::DoNotOptimize(Mesh(SharedArray<double>(mesh.positions(), nullptr), mesh.corners(), 3).edge_count());
}

void assembly(benchmark::State& state) {
  const Mesh& mesh = *scene(state).mesh;
  for (auto _ : state) benchmark::DoNotOptimize(graph_stiffness(mesh).nonZeros());
}

void regions(benchmark::State& state) {
  const Scene& paint = scene(state);
  const SparseMatrix K = graph_stiffness(*paint.mesh);
  for (auto _ : state) benchmark::DoNotOptimize(free_regions(K, paint.mask).count);
}

void factor(benchmark::State& state) {
  const Scene& paint = scene(state);
  const SparseMatrix K = graph_stiffness(*paint.mesh);
  for (auto _ : state) benchmark::DoNotOptimize(make_solver(K, paint.mask, {})->statistics().factor_nonzeros);
}

void solve(benchmark::State& state) {
  Scene& paint = scene(state);
  const HarmonicSolver& solver = paint.solver();
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve(paint.values).values.data());
}

void isolines(benchmark::State& state) {
  const Scene& paint = scene(state);
  const std::vector<double> height = paint.height();
  const auto [low, high] = std::minmax_element(height.begin(), height.end());
  const std::vector<double> levels = even_levels(*low, *high, static_cast<Index>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(extract_isolines(*paint.mesh, height, levels).points.data());
}

const std::vector<std::int64_t> kSides{119, 354, 1000}; // 14,161, 125,316 and 1,000,000 vertices

void sizes(benchmark::internal::Benchmark* stage) {
  stage->ArgName("side")->ArgsProduct({kSides})->Unit(benchmark::kMillisecond)->UseRealTime();
}

void sizes_and_levels(benchmark::internal::Benchmark* stage) {
  stage->ArgNames({"side", "levels"})->ArgsProduct({kSides, {13, 100}})->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(connectivity)->Apply(sizes);
BENCHMARK(assembly)->Apply(sizes);
BENCHMARK(regions)->Apply(sizes);
BENCHMARK(factor)->Apply(sizes);
BENCHMARK(solve)->Apply(sizes);
BENCHMARK(isolines)->Apply(sizes_and_levels);

} // namespace
