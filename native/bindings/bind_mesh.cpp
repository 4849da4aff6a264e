// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "dirichlet/defects.h"
#include "dirichlet/mesh.h"

namespace dirichlet::bindings {
namespace {

/// A property that shows one of the mesh's arrays: no copy, read-only, keeps the mesh alive.
template <class Get>
auto array_of(Get get, py::ssize_t width) {
  return [get, width](const py::object& self) {
    const auto values = get(self.cast<const Mesh&>());
    const auto rows = static_cast<py::ssize_t>(values.size()) / width;
    return view_of(values, width == 1 ? std::vector{rows} : std::vector{rows, width}, self);
  };
}

py::array triangles(const py::object& self) {
  const Mesh& mesh = self.cast<const Mesh&>();
  const Mesh* triangulated = nullptr;
  {
    const py::gil_scoped_release release;
    triangulated = &mesh.triangulated();
  }
  return view_of(triangulated->corners(), {triangulated->face_count(), 3}, self);
}

py::dict defects(const Mesh& mesh) {
  using namespace py::literals;
  Defects found;
  {
    const py::gil_scoped_release release;
    found = find_defects(mesh);
  }
  return py::dict("repeated_faces"_a = found.repeated_faces, "flat_faces"_a = found.flat_faces,
                  "crossing_faces"_a = found.crossing_faces, "coincident_vertices"_a = found.coincident_vertices,
                  "warnings"_a = py::tuple(py::cast(found.warnings())));
}

} // namespace

void bind_mesh(py::module_& module) {
  const auto uniform = [](const Array<double>& positions, const Array<Index>& faces) {
    SharedArray<double> shared = share(positions);
    const auto corners = view(faces);
    const auto width = static_cast<Index>(faces.shape(1));
    const py::gil_scoped_release release;
    return std::make_unique<Mesh>(std::move(shared), corners, width);
  };
  const auto polygons = [](const Array<double>& positions, const Array<Index>& offsets, const Array<Index>& corners) {
    SharedArray<double> shared = share(positions);
    const auto starts = view(offsets), vertices = view(corners);
    const py::gil_scoped_release release;
    return std::make_unique<Mesh>(std::move(shared), starts, vertices);
  };
  const auto moved = [](const Mesh& faces, const Array<double>& positions) {
    SharedArray<double> shared = share(positions);
    const py::gil_scoped_release release;
    return std::make_unique<Mesh>(faces, std::move(shared));
  };
  py::class_<Mesh>(module, "Mesh")
      .def(py::init(uniform), py::arg("positions").noconvert(), py::arg("faces").noconvert())
      .def(py::init(polygons), py::arg("positions").noconvert(), py::arg("offsets").noconvert(),
           py::arg("corners").noconvert())
      .def(py::init(moved), py::arg("faces"), py::arg("positions").noconvert())
      .def_property_readonly("vertex_count", &Mesh::vertex_count)
      .def_property_readonly("face_count", &Mesh::face_count)
      .def_property_readonly("edge_count", &Mesh::edge_count)
      .def_property_readonly("build_seconds", &Mesh::build_seconds)
      .def_property_readonly("positions", array_of([](const Mesh& mesh) { return mesh.positions(); }, 3))
      .def_property_readonly("offsets", array_of([](const Mesh& mesh) { return mesh.offsets(); }, 1))
      .def_property_readonly("corners", array_of([](const Mesh& mesh) { return mesh.corners(); }, 1))
      .def_property_readonly(
          "edges", array_of([](const Mesh& mesh) { return std::span<const Index>(mesh.connectivity().edges); }, 2))
      .def_property_readonly("triangles", &triangles)
      .def("components",
           [](const Mesh& mesh) {
             Components components;
             {
               const py::gil_scoped_release release;
               components = mesh.components();
             }
             return py::make_tuple(to_numpy(std::move(components.label)), components.count);
           })
      .def("border_loops", [](const Mesh& mesh) {
        BorderLoops loops;
        {
          const py::gil_scoped_release release;
          loops = mesh.border_loops();
        }
        return py::make_tuple(to_numpy(std::move(loops.offsets)), to_numpy(std::move(loops.vertices)));
      });
  module.def("find_defects", &defects, py::arg("mesh"));
}

} // namespace dirichlet::bindings
