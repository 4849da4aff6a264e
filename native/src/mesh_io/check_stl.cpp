// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

#include "mesh_io/byte_order.h"
#include "mesh_io/checked_file.h"

namespace dirichlet {
namespace {

using Corner = std::array<float, 3>;
using Triangle = std::array<Corner, 3>;

constexpr std::size_t kHeader = 84;   ///< 80 bytes of anything, then the number of triangles
constexpr std::size_t kTriangle = 50; ///< normal, three corners, two bytes

/// Whether OpenMesh joins them.
bool equal(const Corner& a, const Corner& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::abs(a[axis] - b[axis]) > std::numeric_limits<float>::min()) return false;
  return true;
}

/// Once equal corners are joined, OpenMesh drops the triangles that have become an edge or a point.
void count(const Triangle& t, CheckedFile& checked) {
  if (equal(t[0], t[1]) || equal(t[1], t[2]) || equal(t[2], t[0])) return;
  ++checked.faces;
  checked.corners += 3;
}

CheckedFile check_binary(const FileBytes& file) {
  const std::string& bytes = file.bytes;
  const std::size_t triangles =
      bytes.size() < kHeader ? 0 : load<std::uint32_t>(&bytes[kHeader - 4], std::endian::little);
  if (bytes.size() < kHeader || kHeader + kTriangle * triangles != bytes.size())
    throw InputError(message(file.name, ", byte 80: the file promises ", triangles, " triangles, which take ",
                             kHeader + kTriangle * triangles, " bytes, but has ", bytes.size()));
  CheckedFile checked;
  for (std::size_t t = 0; t < triangles; ++t) {
    Triangle triangle;
    for (std::size_t i = 0; i < 9; ++i) {
      const std::size_t at = kHeader + kTriangle * t + 12 + 4 * i;
      const float value = load<float>(&bytes[at], std::endian::little);
      if (!std::isfinite(value))
        throw InputError(message(file.name, ", byte ", at, ": triangle ", t, " has a coordinate that is not finite"));
      triangle[i / 3][i % 3] = value;
    }
    count(triangle, checked);
  }
  checked.binary = true;
  checked.stream = bytes;
  return checked;
}

class TextCheck {
 public:
  explicit TextCheck(const FileBytes& file) : in_(file, {}) {}

  CheckedFile run() {
    do solid();
    while (!in_.at_end());
    return std::move(checked_);
  }

 private:
  /// The next word in lower case: some programs write the keywords in capitals.
  std::string keyword(std::string_view expected) {
    std::string word(in_.expect(expected));
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    return word;
  }

  void expect(std::string_view expected) {
    if (const auto word = keyword(expected); word != expected)
      in_.fail(quoted(word), " stands where '", expected, "' should be");
  }

  void solid() {
    expect("solid");
    in_.next_line(); // its name
    std::string word;
    while ((word = keyword("facet or endsolid")) == "facet") facet();
    if (word != "endsolid") in_.fail(quoted(word), " stands where 'facet' or 'endsolid' should be");
    in_.next_line(); // the name once more
  }

  void facet() {
    expect("normal");
    for (int axis = 0; axis < 3; ++axis) in_.expect("a normal"); // often a zero, at times not a number: not used
    expect("outer");
    expect("loop");
    checked_.stream += "outer loop\n";
    Triangle triangle;
    for (Corner& corner : triangle) vertex(corner);
    expect("endloop");
    expect("endfacet");
    count(triangle, checked_);
  }

  void vertex(Corner& corner) {
    expect("vertex");
    checked_.stream += "vertex";
    for (float& coordinate : corner) {
      const auto word = in_.expect("a coordinate");
      in_.coordinate(word);
      coordinate = parse<float>(word).value_or(0);
      if (!std::isfinite(coordinate)) in_.fail(quoted(word), " is beyond the single precision of STL");
      checked_.stream.append(" ").append(word);
    }
    checked_.stream += '\n';
  }

  TextScanner in_;
  CheckedFile checked_;
};

/// Programs write "solid" at the head of binary files too; a text has no zero byte.
bool is_text(std::string_view bytes) {
  const auto first = std::min(bytes.find_first_not_of("\xEF\xBB\xBF \t\r\n"), bytes.size());
  constexpr std::string_view solid = "solid";
  const auto head = bytes.substr(first, solid.size());
  return std::equal(head.begin(), head.end(), solid.begin(), solid.end(),
                    [](unsigned char a, char b) { return std::tolower(a) == b; }) &&
         bytes.find('\0') == std::string_view::npos;
}

} // namespace

CheckedFile check_stl(const FileBytes& file) {
  return is_text(file.bytes) ? TextCheck(file).run() : check_binary(file);
}

} // namespace dirichlet
