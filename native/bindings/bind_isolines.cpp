// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "dirichlet/isolines.h"
#include "dirichlet/levels.h"
#include "line_arrays.h"

namespace dirichlet::bindings {
namespace {

py::dict extract(const Mesh& mesh, const Array<double>& values, const Array<double>& levels,
                 const CancelToken& cancel) {
  const auto field = view(values), cuts = view(levels);
  Isolines lines;
  {
    const py::gil_scoped_release release;
    lines = extract_isolines(mesh, field, cuts, cancel);
  }
  return to_dict(std::move(lines));
}

using Spread = std::vector<double> (*)(const Mesh&, std::span<const double>, Index, std::optional<double>,
                                       std::optional<double>, const CancelToken&);

/// A function that spreads levels over a surface, for Python.
auto spreading(Spread spread) {
  return [spread](const Mesh& mesh, const Array<double>& values, Index count, std::optional<double> low,
                  std::optional<double> high, const CancelToken& cancel) {
    const auto field = view(values);
    std::vector<double> levels;
    {
      const py::gil_scoped_release release;
      levels = spread(mesh, field, count, low, high, cancel);
    }
    return to_numpy(std::move(levels));
  };
}

double through_point(const Mesh& mesh, const Array<double>& values, const std::array<double, 3>& point) {
  const auto field = view(values);
  const py::gil_scoped_release release;
  return level_through_point(mesh, field, point);
}

} // namespace

void bind_isolines(py::module_& module) {
  module.def("extract_isolines", &extract, py::arg("mesh"), py::arg("values").noconvert(),
             py::arg("levels").noconvert(), py::arg("cancel"));
  module.def("even_levels",
             [](double low, double high, Index count) { return to_numpy(even_levels(low, high, count)); });
  module.def("stepped_levels", [](double low, double high, double step, double phase) {
    return to_numpy(stepped_levels(low, high, step, phase));
  });
  module.def("equal_area_levels", spreading(&equal_area_levels), py::arg("mesh"), py::arg("values").noconvert(),
             py::arg("count"), py::arg("low"), py::arg("high"), py::arg("cancel"));
  module.def("equal_distance_levels", spreading(&equal_distance_levels), py::arg("mesh"), py::arg("values").noconvert(),
             py::arg("count"), py::arg("low"), py::arg("high"), py::arg("cancel"));
  module.def("level_through_point", &through_point, py::arg("mesh"), py::arg("values").noconvert(), py::arg("point"));
}

} // namespace dirichlet::bindings
