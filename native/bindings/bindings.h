// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace dirichlet::bindings {

void bind_build(pybind11::module_& module);
void bind_errors(pybind11::module_& module);
void bind_mesh(pybind11::module_& module);
void bind_field(pybind11::module_& module);
void bind_geodesic(pybind11::module_& module);
void bind_isolines(pybind11::module_& module);
void bind_line_shaping(pybind11::module_& module);
void bind_files(pybind11::module_& module);
void bind_patches(pybind11::module_& module);

} // namespace dirichlet::bindings
