// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "bindings.h"
#include "dirichlet/build_information.h"
#include "dirichlet/solver.h"

namespace dirichlet::bindings {

void bind_build(pybind11::module_& module) {
  namespace py = pybind11;
  module.def("build_information", [] {
    py::dict result;
    for (const auto& [name, text] : build_information()) result[py::str(name)] = text;
    result["pybind11"] = std::to_string(PYBIND11_VERSION_MAJOR) + '.' + std::to_string(PYBIND11_VERSION_MINOR);
    return result;
  });
  module.def("default_memory_budget", &default_memory_budget);
  module.def("set_thread_limit", &set_thread_limit, py::arg("count"));
}

} // namespace dirichlet::bindings
