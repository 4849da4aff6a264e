// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "dirichlet/geodesic.h"

namespace dirichlet::bindings {
namespace {

py::tuple disc(const Mesh& mesh, const std::array<double, 3>& point, double radius, std::optional<Index> face,
               const CancelToken& cancel) {
  GeodesicDisc disc;
  {
    const py::gil_scoped_release release;
    disc = geodesic_disc(mesh, point, radius, face, cancel);
  }
  return py::make_tuple(to_numpy(std::move(disc.vertices)), to_numpy(std::move(disc.distances)));
}

} // namespace

void bind_geodesic(py::module_& module) {
  module.def("geodesic_disc", &disc, py::arg("mesh"), py::arg("point"), py::arg("radius"), py::arg("face"),
             py::arg("cancel"));
}

} // namespace dirichlet::bindings
