// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"
#include "dirichlet/line_shaping.h"
#include "line_arrays.h"

namespace dirichlet::bindings {
namespace {

template <class Shape>
py::dict shaped(const LineArrays& arrays, const Shape& shape) {
  Isolines lines = from_arrays(arrays);
  {
    const py::gil_scoped_release release;
    lines = shape(std::move(lines));
  }
  return to_dict(std::move(lines));
}

} // namespace

void bind_line_shaping(py::module_& module) {
  module.def("keep_long", [](const LineArrays& arrays, double least) {
    return shaped(arrays, [=](const Isolines& lines) { return keep_long(lines, least); });
  });
  module.def("smooth_lines", [](const Mesh& mesh, const LineArrays& arrays, Index steps, const CancelToken& cancel) {
    return shaped(arrays, [&](Isolines&& lines) { return smooth_lines(mesh, std::move(lines), steps, cancel); });
  });
  module.def("simplify_lines", [](const LineArrays& arrays, double tolerance, const CancelToken& cancel) {
    return shaped(arrays, [&](const Isolines& lines) { return simplify_lines(lines, tolerance, cancel); });
  });
  module.def("resample_lines", [](const LineArrays& arrays, double spacing, const CancelToken& cancel) {
    return shaped(arrays, [&](const Isolines& lines) { return resample_lines(lines, spacing, cancel); });
  });
  module.def("move_lines", [](const LineArrays& arrays, const Array<double>& positions) {
    const auto places = view(positions);
    return shaped(arrays, [=](Isolines&& lines) { return move_lines(std::move(lines), places); });
  });
}

} // namespace dirichlet::bindings
