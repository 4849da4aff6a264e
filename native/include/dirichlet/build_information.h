// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace dirichlet {

/// What a report of a bug should tell: name and text of the library's version, the compiler, Eigen, OpenMesh, the
/// instruction set that the solver's kernels use here, and the number of cores.
std::vector<std::pair<std::string, std::string>> build_information();

/// How many threads this library shares work out to, beside which one more may search in the background; 0 for as many
/// as there are cores, which is also the most. Work that has begun goes on with its own. Results do not depend on it.
void set_thread_limit(unsigned count);

} // namespace dirichlet
