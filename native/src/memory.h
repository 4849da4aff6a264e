// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <new>

#include "dirichlet/array.h"
#include "dirichlet/error.h"
#include "message.h"

namespace dirichlet {

/// Bytes of memory this machine has; without bound where the system does not tell.
std::int64_t physical_memory();

/// Gives back to the system what the whole process has freed and would keep for later. Cost: that of writing to it
/// again.
void return_freed_memory();

/// f(), whose being denied memory is told like any other failure of a solver.
template <class F>
auto with_memory(Index vertices, const F& f) {
  try {
    return f();
  } catch (const std::bad_alloc&) {
    throw SolverError(message("there is not enough memory to solve for ", counted(vertices, "vertex"),
                              "; the method that needs least is multigrid"));
  }
}

} // namespace dirichlet
