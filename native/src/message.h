// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>

namespace dirichlet {

/// The fewest digits that read back as the same double.
inline std::string exactly(double value) {
  if (std::isnan(value)) return "nan"; // whatever its sign
  constexpr double kWhole = 1e15;      // smaller whole numbers are written without an exponent
  std::array<char, 32> digits{};
  const bool whole = std::abs(value) < kWhole && value == std::trunc(value);
  const auto write = [&](auto... format) {
    return std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0, format...).ptr; // 0 for -0
  };
  return {digits.data(), whole ? write(std::chars_format::fixed) : write()};
}

/// Its arguments written one after the other. A double that is a float, as hosts hand them over, shows the digits of
/// the float: -0.1, and not -0.10000000149011612.
template <class... Parts>
std::string message(const Parts&... parts) {
  std::ostringstream out;
  out.imbue(std::locale::classic()); // no grouping of digits, whatever the host has set
  const auto write = [&out](const auto& part) {
    if constexpr (std::is_floating_point_v<std::decay_t<decltype(part)>>) {
      std::array<char, 32> digits{};
      const auto single = static_cast<float>(part);
      const bool is_single = std::abs(part) < 1e6 && static_cast<double>(single) == part && part != std::trunc(part);
      if (is_single)
        out << std::string_view(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), single).ptr);
      else
        out << exactly(part);
    } else {
      out << part;
    }
  };
  (write(parts), ...);
  return out.str();
}

/// For what matters by its size alone, such as a residual: two digits.
inline std::string roughly(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(2);
  out << value;
  return out.str();
}

/// A noun as it goes with a number: "step" with 1, "steps" with others.
template <class Count>
std::string number_of(Count count, std::string_view noun) {
  if (count == 1) return std::string(noun);
  if (noun.ends_with("vertex")) return std::string(noun.substr(0, noun.size() - 2)) + "ices";
  return std::string(noun) + "s";
}

/// "1 step", "2 steps".
template <class Count>
std::string counted(Count count, std::string_view noun) {
  return message(count, " ", number_of(count, noun));
}

/// " (and 3 more corners)", or nothing for none.
template <class Count>
std::string and_more(Count count, std::string_view noun) {
  return count <= 0 ? std::string() : message(" (and ", count, " more ", number_of(count, noun), ")");
}

/// "1.3 GB"
inline std::string in_bytes(std::int64_t count) {
  constexpr double kMega = 1e6, kGiga = 1e9;
  const auto bytes = static_cast<double>(count);
  return bytes < kGiga ? message(std::ceil(bytes / kMega), " MB") : message(std::ceil(10 * bytes / kGiga) / 10, " GB");
}

} // namespace dirichlet
