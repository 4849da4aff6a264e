// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"
#include "dirichlet/error.h"

namespace dirichlet::bindings {
namespace {

namespace py = pybind11;

/// The C++ class as a Python class of the package, so that tracebacks and documentation name it as users import it.
template <class Error>
py::object bind(py::module_& module, const char* name, const py::handle& base, const char* doc) {
  py::object type = py::register_exception<Error>(module, name, base);
  type.attr("__module__") = "dirichlet_surface";
  type.attr("__doc__") = doc;
  return type;
}

} // namespace

void bind_errors(py::module_& module) {
  // The base first: translators are asked in the opposite order.
  const py::object base =
      bind<DirichletError>(module, "DirichletError", PyExc_Exception,
                           "The one family of errors of this package: one sentence, what and where.");
  bind<InputError>(module, "InputError", base, "An argument or a file is not what it has to be.");
  bind<TopologyError>(module, "TopologyError", base, "The pieces are valid but cannot form what was asked for.");
  const py::object solver =
      bind<SolverError>(module, "SolverError", base, "The linear system could not be solved to the promised residual.");
  bind<CancelledError>(module, "CancelledError", solver, "Somebody asked for the work to stop.");
}

} // namespace dirichlet::bindings
