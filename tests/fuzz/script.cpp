// SPDX-License-Identifier: GPL-3.0-or-later
#include "script.h"

#include <bit>
#include <cmath>
#include <limits>

namespace dirichlet::fuzz {

char Script::letter() {
  return at_end() ? '\0' : static_cast<char>(bytes_[place_++]);
}

Index Script::number(Index limit) {
  const auto byte = at_end() ? std::uint8_t{'0'} : bytes_[place_++];
  return limit > 0 ? static_cast<Index>(static_cast<std::uint8_t>(byte - '0')) % limit : 0;
}

double Script::raw() {
  std::uint64_t bits = 0;
  for (int byte = 0; byte < 8; ++byte) bits = bits << 8U | static_cast<std::uint8_t>(letter());
  return std::bit_cast<double>(bits);
}

double Script::value() {
  using Limits = std::numeric_limits<double>;
  double sign = 1;
  char first = letter();
  for (; first == '-'; first = letter()) sign = -sign;
  switch (first) {
  case ',':
    return sign * number(256) / 16;
  case '^':
    return sign * std::ldexp(1.0, number(256) - 128);
  case '#':
    return sign * raw();
  case 'd':
    return sign * Limits::denorm_min();
  case 'h':
    return sign * 1e300;
  case 'i':
    return sign * Limits::infinity();
  case 'm':
    return sign * Limits::max();
  case 'n':
    return Limits::quiet_NaN();
  case 's':
    return sign * Limits::min();
  case 'u':
    return sign * std::nextafter(1.0, 2.0);
  default:
    return sign * static_cast<double>(static_cast<std::uint8_t>(first - '0') % 10);
  }
}

} // namespace dirichlet::fuzz
