// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>

#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "dirichlet/mesh.h"
#include "dirichlet/mesh_io.h"

namespace dirichlet::bindings {
namespace {

py::tuple read(const std::string& path) {
  MeshArrays arrays;
  {
    const py::gil_scoped_release release;
    arrays = read_mesh_file(path);
  }
  const auto vertices = static_cast<py::ssize_t>(arrays.positions.size()) / 3;
  return py::make_tuple(to_numpy(std::move(arrays.positions), {vertices, 3}), to_numpy(std::move(arrays.offsets)),
                        to_numpy(std::move(arrays.corners)));
}

void write(const std::string& path, const Mesh& mesh, const std::optional<Array<unsigned char>>& colors) {
  const auto bytes = colors ? view(*colors) : std::span<const unsigned char>{};
  const py::gil_scoped_release release;
  write_mesh_file(path, mesh.positions(), mesh.offsets(), mesh.corners(), bytes);
}

} // namespace

void bind_files(py::module_& module) {
  module.def("read_mesh_file", &read, py::arg("path"));
  module.def("write_mesh_file", &write, py::arg("path"), py::arg("mesh"), py::arg("colors"));
}

} // namespace dirichlet::bindings
