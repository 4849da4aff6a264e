// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_io/checked_file.h"

namespace dirichlet {
namespace {

/// The head says what stands behind the coordinates on a vertex's line: [ST][C][N]OFF. All of that is skipped.
void read_head(TextScanner& in) {
  std::string_view word = in.expect("OFF");
  const auto off = word.find("OFF");
  std::string_view prefix = word.substr(0, std::min(off, word.size()));
  for (const std::string_view known : {"ST", "C", "N"})
    if (prefix.starts_with(known)) prefix.remove_prefix(known.size());
  if (off == std::string_view::npos || !prefix.empty())
    in.fail(quoted(word), " is not the head of an OFF file in three dimensions");
  in.unread(word.size() - off - 3); // "OFF8 6 12" is met too
  const auto next = in.word();
  if (next == "BINARY") in.fail("binary OFF is not supported");
  in.unread(next.size());
}

/// A count that the rest of the file can hold, at so many characters for each.
std::size_t read_count(TextScanner& in, std::string_view what, std::size_t characters) {
  const std::int64_t count = in.whole(in.expect(what), what);
  if (count < 0 || static_cast<std::size_t>(count) > in.remaining() / characters)
    in.fail(what, " is ", count, ", but the file goes on for ", counted(in.remaining(), "byte"), " only");
  return static_cast<std::size_t>(count);
}

void read_face(TextScanner& in, std::int64_t vertex_count, CheckedFile& checked) {
  constexpr std::string_view what = "the number of corners of a face";
  const std::size_t count = read_count(in, what, 2);
  if (count < 3) in.fail(what, " is ", count, ", not three or more");
  checked.stream += std::to_string(count);
  for (std::size_t c = 0; c < count; ++c) {
    const auto word = in.expect("a corner of a face");
    const std::int64_t vertex = in.whole(word, "a corner of a face");
    if (vertex < 0 || vertex >= vertex_count)
      in.fail("the face names vertex ", vertex, ", but the file's vertices are 0 to ", vertex_count - 1);
    checked.stream.append(" ").append(word);
  }
  checked.stream += '\n';
  checked.corners += count;
}

} // namespace

CheckedFile check_off(const FileBytes& file) {
  TextScanner in(file, {.comment = '#'});
  CheckedFile checked;
  read_head(in);
  const std::size_t vertices = read_count(in, "the number of vertices", std::string_view("0 0 0\n").size());
  checked.faces = read_count(in, "the number of faces", std::string_view("3 0 0 0").size());
  in.next_line(); // the number of edges is of no use, and sometimes left out
  checked.positions.reserve(3 * vertices);
  for (std::size_t v = 0; v < vertices; ++v, in.next_line())
    for (int axis = 0; axis < 3; ++axis) checked.positions.push_back(in.coordinate(in.expect("a coordinate")));
  checked.stream = message("OFF\n0 ", checked.faces, " 0\n");
  for (std::size_t f = 0; f < checked.faces; ++f, in.next_line()) // what follows the corners is a colour
    read_face(in, static_cast<std::int64_t>(vertices), checked);
  if (!in.at_end()) in.fail("the file goes on after the last face");
  return checked;
}

} // namespace dirichlet
