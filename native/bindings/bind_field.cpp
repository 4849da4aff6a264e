// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "dirichlet/field.h"

namespace dirichlet::bindings {
namespace {

py::dict to_dict(const SolveReport& report) {
  using namespace py::literals;
  const py::dict seconds("connectivity"_a = report.connectivity_seconds, "laplacian"_a = report.laplacian_seconds,
                         "injection"_a = report.injection_seconds, "factorisation"_a = report.factor_seconds,
                         "solve"_a = report.solve_seconds);
  return py::dict("vertices"_a = report.vertices, "painted"_a = report.painted, "unknowns"_a = report.unknowns,
                  "nonzeros"_a = report.nonzeros, "factor_nonzeros"_a = report.factor_nonzeros,
                  "iterations"_a = report.iterations, "relative_residual"_a = report.relative_residual,
                  "minimum"_a = report.minimum, "maximum"_a = report.maximum,
                  "painted_minimum"_a = report.painted_minimum, "painted_maximum"_a = report.painted_maximum,
                  "outside"_a = report.outside, "farthest_outside"_a = report.farthest_outside,
                  "undefined"_a = report.undefined, "first_undefined"_a = report.first_undefined, "seconds"_a = seconds,
                  "warnings"_a = py::tuple(py::cast(report.warnings)));
}

std::unique_ptr<HarmonicSolver> make(const Mesh& mesh, const Array<Index>& painted, bool direct,
                                     std::optional<double> tolerance, std::optional<Index> max_iterations) {
  SolverOptions options;
  options.method = direct ? Method::direct : Method::least_squares_cg;
  options.tolerance = tolerance.value_or(options.tolerance);
  options.max_iterations = max_iterations;
  const auto vertices = view(painted);
  const py::gil_scoped_release release;
  return std::make_unique<HarmonicSolver>(mesh, vertices, options);
}

/// (C, k) → (V, k) in columns, and the report.
py::tuple solve(const HarmonicSolver& solver, const Eigen::Ref<const Eigen::MatrixXd>& values,
                const std::optional<Array<double>>& source) {
  const auto numbers = source ? view(*source) : std::span<const double>{};
  Field field;
  {
    const py::gil_scoped_release release;
    field = solver.solve(values, numbers);
  }
  return py::make_tuple(std::move(field.values), to_dict(field.report));
}

py::tuple matrix(const Mesh& mesh, const Array<Index>& painted) {
  const auto vertices = view(painted);
  auto owner = std::make_unique<SparseMatrix>();
  {
    const py::gil_scoped_release release;
    *owner = dirichlet_laplacian(mesh, vertices);
  }
  const SparseMatrix& K = *owner;
  const py::capsule capsule(owner.release(), [](void* pointer) { delete static_cast<SparseMatrix*>(pointer); });
  return py::make_tuple(Array<Index>(K.rows() + 1, K.outerIndexPtr(), capsule),
                        Array<Index>(K.nonZeros(), K.innerIndexPtr(), capsule),
                        Array<double>(K.nonZeros(), K.valuePtr(), capsule));
}

} // namespace

void bind_field(py::module_& module) {
  py::class_<HarmonicSolver>(module, "HarmonicSolver")
      .def(py::init(&make), py::arg("mesh"), py::arg("vertices").noconvert(), py::arg("direct"), py::arg("tolerance"),
           py::arg("max_iterations"))
      .def("solve", &solve, py::arg("values"), py::arg("source"));
  module.def("dirichlet_laplacian", &matrix, py::arg("mesh"), py::arg("vertices").noconvert());
}

} // namespace dirichlet::bindings
