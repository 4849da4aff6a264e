// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dirichlet {

/// std::any_of for what is almost never so: without a way out, the loop goes over many values at once.
template <class Values, class Predicate>
bool any_value(const Values& values, Predicate predicate) {
  int found = 0;
  for (const auto value : values) found |= static_cast<int>(predicate(value));
  return found != 0;
}

} // namespace dirichlet
