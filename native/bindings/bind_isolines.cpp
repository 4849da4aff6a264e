// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "dirichlet/isolines.h"
#include "dirichlet/levels.h"
#include "line_arrays.h"

namespace dirichlet::bindings {
namespace {

py::dict extract(const Mesh& mesh, const Array<double>& values, const Array<double>& levels) {
  const auto field = view(values), cuts = view(levels);
  Isolines lines;
  {
    const py::gil_scoped_release release;
    lines = extract_isolines(mesh, field, cuts);
  }
  return to_dict(std::move(lines));
}

double through_point(const Mesh& mesh, const Array<double>& values, const std::array<double, 3>& point) {
  const auto field = view(values);
  const py::gil_scoped_release release;
  return level_through_point(mesh, field, point);
}

} // namespace

void bind_isolines(py::module_& module) {
  module.def("extract_isolines", &extract, py::arg("mesh"), py::arg("values").noconvert(),
             py::arg("levels").noconvert());
  module.def("even_levels",
             [](double low, double high, Index count) { return to_numpy(even_levels(low, high, count)); });
  module.def("stepped_levels", [](double low, double high, double step, double phase) {
    return to_numpy(stepped_levels(low, high, step, phase));
  });
  module.def("level_through_point", &through_point, py::arg("mesh"), py::arg("values").noconvert(), py::arg("point"));
}

} // namespace dirichlet::bindings
