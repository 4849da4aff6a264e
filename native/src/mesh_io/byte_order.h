// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace dirichlet {

/// The number that lies at `bytes` in the given order.
template <class T>
T load(const char* bytes, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::copy_n(bytes, raw.size(), raw.begin());
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

/// Appends a number, lowest byte first.
template <class T>
void store(std::string& out, T value) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (std::endian::native != std::endian::little) std::reverse(raw.begin(), raw.end());
  out.append(raw.data(), raw.size());
}

} // namespace dirichlet
