// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "dirichlet/array.h"

namespace dirichlet {

/// \throws InputError  a field that has not one value per vertex
void check_field_size(std::span<const double> field, Index vertex_count);

/// \throws InputError  as above, or an infinite value; names the first. NaN stands for no value.
void check_field(std::span<const double> field, Index vertex_count);

} // namespace dirichlet
