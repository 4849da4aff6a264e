// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh_io/text_scanner.h"

namespace dirichlet {

enum class PlyEncoding : std::uint8_t { ascii, binary_little_endian, binary_big_endian };
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t size_of(PlyType type); ///< in bytes
[[nodiscard]] bool is_whole(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count; ///< of a list: the type of the number in front of it
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements; ///< in the order of the file
};

/// Reads up to the line after "end_header".
/// \throws InputError  a line that is no part of a header, or an element that the file is too short for
PlyHeader read_ply_header(TextScanner& in);

} // namespace dirichlet
