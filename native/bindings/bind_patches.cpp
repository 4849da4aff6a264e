// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "dirichlet/patches.h"

namespace dirichlet::bindings {
namespace {

py::list inspect(const Mesh& mesh, const std::vector<Array<Index>>& patches) {
  std::vector<std::vector<Index>> vertices;
  for (const auto& patch : patches) vertices.emplace_back(view(patch).begin(), view(patch).end());
  std::vector<PatchFacts> facts;
  {
    const py::gil_scoped_release release;
    facts = inspect_patches(mesh, vertices);
  }
  using namespace py::literals;
  py::list result;
  for (const PatchFacts& fact : facts)
    result.append(py::dict("vertices"_a = fact.vertices, "edges"_a = fact.edges, "faces"_a = fact.faces,
                           "components"_a = fact.components, "euler_characteristic"_a = fact.euler_characteristic,
                           "border_loops"_a = fact.border_loops, "manifold"_a = fact.manifold, "disc"_a = fact.disc,
                           "overlaps"_a = py::tuple(py::cast(fact.overlaps))));
  return result;
}

} // namespace

void bind_patches(py::module_& module) {
  module.def("inspect_patches", &inspect, py::arg("mesh"), py::arg("patches"));
}

} // namespace dirichlet::bindings
