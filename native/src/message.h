// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>
#include <string>
#include <string_view>

namespace dirichlet {

/// Its arguments written one after the other. Doubles show enough digits to be told apart.
template <class... Parts>
std::string message(const Parts&... parts) {
  std::ostringstream out;
  out.precision(12);
  (out << ... << parts);
  return out.str();
}

/// " (and 3 more corners)", or nothing for none.
template <class Count>
std::string and_more(Count count, std::string_view noun) {
  if (count <= 0) return {};
  std::string name(noun);
  if (count != 1) name = noun == "vertex" ? "vertices" : name + "s";
  return message(" (and ", count, " more ", name, ")");
}

} // namespace dirichlet
