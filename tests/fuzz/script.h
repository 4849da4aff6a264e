// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "dirichlet/array.h"

namespace dirichlet::fuzz {

/// A fuzzer's bytes as a text of commands, one letter each and followed by numbers of one byte, so that seeds can be
/// read and every byte that a fuzzer changes still says something. Past the end there are zeros.
class Script {
 public:
  explicit Script(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] bool at_end() const { return place_ == bytes_.size(); }

  char letter(); ///< '\0' past the end

  /// In [0, limit): '0' is 0, '9' is 9, 'A' is 17 … modulo the limit. 0 where there is no such number.
  Index number(Index limit);

  /// '0' … '9'; '-' the negative of the value that follows; ',' and a byte: so many sixteenths; '^' and a byte: a power
  /// of two from 2^-128; '#' and eight bytes: any number at all; a letter: one of those at the ends of the doubles.
  double value();

 private:
  double raw();

  std::span<const std::uint8_t> bytes_;
  std::size_t place_ = 0;
};

} // namespace dirichlet::fuzz
