// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_io/ply_header.h"

#include <algorithm>
#include <array>

namespace dirichlet {
namespace {

struct TypeNames {
  std::string_view name, other_name;
  std::size_t size;
  bool whole;
};

/// In the order of PlyType.
constexpr std::array<TypeNames, 8> kTypes{{{"char", "int8", 1, true},
                                           {"uchar", "uint8", 1, true},
                                           {"short", "int16", 2, true},
                                           {"ushort", "uint16", 2, true},
                                           {"int", "int32", 4, true},
                                           {"uint", "uint32", 4, true},
                                           {"float", "float32", 4, false},
                                           {"double", "float64", 8, false}}};

PlyType read_type(TextScanner& in, std::string_view word) {
  const auto is_it = [=](const TypeNames& type) { return type.name == word || type.other_name == word; };
  const auto found = std::find_if(kTypes.begin(), kTypes.end(), is_it);
  if (found == kTypes.end()) in.fail(quoted(word), " is not a type of PLY");
  return static_cast<PlyType>(found - kTypes.begin());
}

PlyEncoding read_encoding(TextScanner& in) {
  const auto word = in.word();
  if (word == "ascii") return PlyEncoding::ascii;
  if (word == "binary_little_endian") return PlyEncoding::binary_little_endian;
  if (word == "binary_big_endian") return PlyEncoding::binary_big_endian;
  in.fail(quoted(word), " is not a format of PLY");
}

PlyElement read_element(TextScanner& in) {
  const std::string name(in.word());
  const std::int64_t count = in.whole(in.word(), "the number of " + quoted(name) + " elements");
  if (count < 0) in.fail("the number of ", quoted(name), " elements is ", count);
  return {name, static_cast<std::size_t>(count), {}};
}

PlyProperty read_property(TextScanner& in) {
  PlyProperty property;
  auto word = in.word();
  if (word == "list") {
    property.count = read_type(in, in.word());
    if (!is_whole(*property.count)) in.fail("a list cannot be counted in fractions");
    word = in.word();
  }
  property.type = read_type(in, word);
  property.name = in.word();
  if (property.name.empty()) in.fail("the property has no name");
  return property;
}

/// The least that one instance takes: a digit and a blank for each number of a text, the bare numbers else.
std::size_t least_size(const PlyElement& element, PlyEncoding encoding) {
  std::size_t size = 0;
  for (const PlyProperty& p : element.properties)
    size += encoding == PlyEncoding::ascii ? 2 : size_of(p.count.value_or(p.type));
  return size;
}

void check_promises(const TextScanner& in, const PlyHeader& header) {
  for (const PlyElement& element : header.elements) {
    const std::size_t least = least_size(element, header.encoding);
    if (least > 0 && element.count > (in.remaining() + 1) / least) // the last blank may be missing
      in.fail("the header promises ", element.count, " ", quoted(element.name), " elements, with only ",
              counted(in.remaining(), "byte"), " left");
  }
}

} // namespace

std::size_t size_of(PlyType type) {
  return kTypes[static_cast<std::size_t>(type)].size;
}
bool is_whole(PlyType type) {
  return kTypes[static_cast<std::size_t>(type)].whole;
}

PlyHeader read_ply_header(TextScanner& in) {
  PlyHeader header;
  if (const auto magic = in.word(); magic != "ply" && magic != "PLY") in.fail("a PLY file begins with 'ply'");
  bool has_format = false;
  for (std::string_view keyword; keyword != "end_header";) {
    if (!in.next_line()) in.fail("the header has no end");
    keyword = in.word();
    if (keyword == "format") {
      header.encoding = read_encoding(in);
      has_format = true;
    } else if (keyword == "element")
      header.elements.push_back(read_element(in));
    else if (keyword == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(read_property(in));
    else if (keyword != "comment" && keyword != "obj_info" && keyword != "end_header" && !keyword.empty())
      in.fail(quoted(keyword), " does not belong in a PLY header");
  }
  if (!has_format) in.fail("the header names no format");
  in.next_line();
  check_promises(in, header);
  return header;
}

} // namespace dirichlet
