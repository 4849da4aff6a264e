// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_checks.h"

#include <algorithm>
#include <cmath>

#include "any_value.h"
#include "dirichlet/error.h"
#include "index.h"
#include "message.h"

namespace dirichlet {

void check_field_size(std::span<const double> field, Index vertex_count) {
  if (field.size() != at(vertex_count))
    throw InputError(
        message("the field has ", counted(field.size(), "value"), ", but the mesh ", counted(vertex_count, "vertex")));
}

void check_field(std::span<const double> field, Index vertex_count) {
  check_field_size(field, vertex_count);
  const auto bad = [](double value) { return std::isinf(value); };
  if (!any_value(field, bad)) return;
  const auto first = std::find_if(field.begin(), field.end(), bad);
  throw InputError(message("the field is infinite at vertex ", first - field.begin(),
                           and_more(std::count_if(first, field.end(), bad) - 1, "value")));
}

} // namespace dirichlet
