// SPDX-License-Identifier: GPL-3.0-or-later
// The compiled half of dirichlet_surface: converts, releases the GIL, maps errors; no mathematics.
#include "bindings.h"

PYBIND11_MODULE(_native, module) {
  module.doc() = "Compiled half of dirichlet_surface; use the package, which checks and documents its arguments.";
  using namespace dirichlet::bindings;
  bind_build(module);
  bind_errors(module);
  bind_mesh(module);
  bind_field(module);
  bind_geodesic(module);
  bind_isolines(module);
  bind_line_shaping(module);
  bind_files(module);
  bind_patches(module);
}
