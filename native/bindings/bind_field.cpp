// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "dirichlet/field.h"

namespace dirichlet::bindings {
namespace {

// Python's names of the enumerators, in their order.
constexpr std::array kLaplacians{"auto", "graph", "cotangent", "intrinsic_delaunay", "polygon"};
constexpr std::array kMethods{"auto", "direct", "multigrid", "lscg"};
constexpr std::array kPrecisions{"float64", "float32"};
constexpr std::array kUpdates{"nothing", "values", "partial", "full"};

/// The enumerator of a name, which the Python side has checked.
template <class Enum, std::size_t kCount>
Enum named(const std::array<const char*, kCount>& names, const std::string& name) {
  return static_cast<Enum>(std::find(names.begin(), names.end(), name) - names.begin());
}

py::dict to_dict(const SolveReport& report) {
  using namespace py::literals;
  const py::dict seconds("connectivity"_a = report.connectivity_seconds, "laplacian"_a = report.laplacian_seconds,
                         "analysis"_a = report.analysis_seconds, "injection"_a = report.injection_seconds,
                         "factorisation"_a = report.factor_seconds, "solve"_a = report.solve_seconds);
  return py::dict(
      "laplacian"_a = kLaplacians.at(static_cast<std::size_t>(report.laplacian)), "reason"_a = report.reason,
      "flat_faces"_a = report.flat_faces, "method"_a = kMethods.at(static_cast<std::size_t>(report.method)),
      "update"_a = kUpdates.at(static_cast<std::size_t>(report.update)), "repeated"_a = report.repeated,
      "vertices"_a = report.vertices, "painted"_a = report.painted, "unknowns"_a = report.unknowns,
      "nonzeros"_a = report.nonzeros, "factor_nonzeros"_a = report.factor_nonzeros, "iterations"_a = report.iterations,
      "relative_residual"_a = report.relative_residual, "minimum"_a = report.minimum, "maximum"_a = report.maximum,
      "painted_minimum"_a = report.painted_minimum, "painted_maximum"_a = report.painted_maximum,
      "outside"_a = report.outside, "farthest_outside"_a = report.farthest_outside, "undefined"_a = report.undefined,
      "first_undefined"_a = report.first_undefined, "seconds"_a = seconds,
      "warnings"_a = py::tuple(py::cast(report.warnings)));
}

/// Indices that are checked stay as they were, whatever another thread writes to the array meanwhile.
std::vector<Index> copy(const Array<Index>& array) {
  const auto items = view(array);
  return {items.begin(), items.end()};
}

std::unique_ptr<HarmonicSolver> make(const Mesh& mesh, const std::optional<Array<Index>>& painted,
                                     const std::string& laplacian, const std::string& method,
                                     const std::string& precision, std::optional<std::int64_t> memory_budget,
                                     std::optional<double> tolerance, std::optional<Index> max_iterations,
                                     const CancelToken& cancel) {
  const SolverOptions options{named<Method>(kMethods, method),
                              named<Precision>(kPrecisions, precision),
                              memory_budget,
                              tolerance,
                              max_iterations,
                              cancel};
  const auto kind = named<Laplacian>(kLaplacians, laplacian);
  const std::vector<Index> vertices = painted ? copy(*painted) : std::vector<Index>{};
  const py::gil_scoped_release release;
  if (!painted) return std::make_unique<HarmonicSolver>(mesh, options, kind);
  return std::make_unique<HarmonicSolver>(mesh, vertices, options, kind);
}

using Values = Eigen::Ref<const Eigen::MatrixXd>;

/// (V, k) in columns, and the report.
template <class Solve>
py::tuple solved(const std::optional<Array<double>>& source, const Solve& solve) {
  const auto numbers = source ? view(*source) : std::span<const double>{};
  Field field;
  {
    const py::gil_scoped_release release;
    field = solve(numbers);
  }
  return py::make_tuple(std::move(field.values), to_dict(field.report));
}

py::tuple paint(HarmonicSolver& solver, const Array<Index>& painted, const Values& values,
                const std::optional<Array<double>>& source) {
  const std::vector<Index> vertices = copy(painted);
  return solved(source, [&](std::span<const double> numbers) { return solver.paint(vertices, values, numbers); });
}

py::tuple solve(const HarmonicSolver& solver, const Values& values, const std::optional<Array<double>>& source) {
  return solved(source, [&](std::span<const double> numbers) { return solver.solve(values, numbers); });
}

/// indptr, indices and data of a matrix that is made without the GIL, and that they keep alive.
template <class Make>
py::tuple csr(const Make& make_matrix) {
  std::unique_ptr<SparseMatrix> owner;
  {
    const py::gil_scoped_release release;
    // In place, as make_unique is not: Eigen 3.4 copies what is moved.
    owner.reset(new SparseMatrix(make_matrix())); // NOLINT(modernize-make-unique)
  }
  const SparseMatrix& K = *owner;
  const py::capsule capsule(owner.release(), [](void* pointer) { delete static_cast<SparseMatrix*>(pointer); });
  return py::make_tuple(Array<Index>(K.rows() + 1, K.outerIndexPtr(), capsule),
                        Array<Index>(K.nonZeros(), K.innerIndexPtr(), capsule),
                        Array<double>(K.nonZeros(), K.valuePtr(), capsule));
}

py::tuple injected_matrix(const Mesh& mesh, const Array<Index>& painted, const std::string& laplacian) {
  const std::vector<Index> vertices = copy(painted);
  return csr([&] { return dirichlet_laplacian(mesh, vertices, named<Laplacian>(kLaplacians, laplacian)); });
}

py::tuple stiffness(const Mesh& mesh, const std::string& laplacian) {
  return csr([&] {
    Stiffness made = make_stiffness(mesh, named<Laplacian>(kLaplacians, laplacian));
    SparseMatrix K;
    K.swap(made.K);
    return K;
  });
}

py::array mass(const Mesh& mesh, const std::string& laplacian) {
  std::vector<double> result;
  {
    const py::gil_scoped_release release;
    result = make_stiffness(mesh, named<Laplacian>(kLaplacians, laplacian)).mass;
  }
  return to_numpy(std::move(result));
}

} // namespace

void bind_field(py::module_& module) {
  py::class_<CancelToken>(module, "CancelToken")
      .def(py::init())
      .def("cancel", &CancelToken::cancel)
      .def("reset", &CancelToken::reset)
      .def_property_readonly("is_cancelled", &CancelToken::is_cancelled);
  py::class_<HarmonicSolver>(module, "HarmonicSolver")
      .def(py::init(&make), py::arg("mesh"), py::arg("vertices").noconvert(), py::arg("laplacian"), py::arg("method"),
           py::arg("precision"), py::arg("memory_budget"), py::arg("tolerance"), py::arg("max_iterations"),
           py::arg("cancel"))
      .def("paint", &paint, py::arg("vertices").noconvert(), py::arg("values"), py::arg("source"))
      .def("solve", &solve, py::arg("values"), py::arg("source"));
  module.def("dirichlet_laplacian", &injected_matrix, py::arg("mesh"), py::arg("vertices").noconvert(),
             py::arg("laplacian"));
  module.def("stiffness_matrix", &stiffness, py::arg("mesh"), py::arg("laplacian"));
  module.def("lumped_mass", &mass, py::arg("mesh"), py::arg("laplacian"));
}

} // namespace dirichlet::bindings
