// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <new>
#include <string_view>
#include <utility>

#include "bindings.h"
#include "dirichlet/error.h"

namespace dirichlet::bindings {
namespace {

namespace py = pybind11;

/// The C++ class as a Python class of the package, so that tracebacks and documentation name it as users import it.
template <class Error>
py::object bind(py::module_& module, const char* name, const py::handle& base, const char* doc) {
  static const py::handle type = py::exception<Error>(module, name, base).release(); // lives as long as the module
  type.attr("__module__") = "dirichlet_surface";
  type.attr("__doc__") = doc;
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(std::move(pointer));
    } catch (const Error& error) { // a file's name may be no text
      const std::string_view what = error.what();
      const auto text = py::reinterpret_steal<py::object>(
          PyUnicode_DecodeUTF8(what.data(), static_cast<py::ssize_t>(what.size()), "replace"));
      PyErr_SetObject(type.ptr(), text.ptr());
    }
  });
  return py::reinterpret_borrow<py::object>(type);
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
  py::register_exception_translator([](std::exception_ptr error) { // the last one is asked first, and hands on
    try {
      if (error) std::rethrow_exception(std::move(error));
    } catch (const std::bad_alloc&) {
      throw DirichletError("there is not enough memory for this");
    }
  });
}

} // namespace dirichlet::bindings
