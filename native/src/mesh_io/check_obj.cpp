// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "mesh_io/checked_file.h"

namespace dirichlet {
namespace {

constexpr TextScanner::Syntax kSyntax{.comment = '#', .continuation = true};

/// Faces may name vertices that follow, so their number is needed first.
std::int64_t count_vertices(const FileBytes& file) {
  TextScanner in(file, kSyntax);
  std::int64_t count = 0;
  do count += in.word() == "v" ? 1 : 0;
  while (in.next_line());
  return count;
}

class ObjCheck {
 public:
  explicit ObjCheck(const FileBytes& file) : in_(file, kSyntax), vertex_count_(count_vertices(file)) {}

  CheckedFile run() {
    do {
      const auto keyword = in_.word();
      if (keyword == "v")
        vertex();
      else if (keyword == "f")
        face();
    } while (in_.next_line());
    return std::move(checked_);
  }

 private:
  void vertex() {
    std::size_t count = 0;
    for (auto word = in_.word(); !word.empty(); word = in_.word(), ++count) {
      const double value = in_.coordinate(word);
      if (count < 3) checked_.positions.push_back(value);
    }
    if (count < 3) in_.fail("the vertex has ", counted(count, "coordinate"), ", not three");
    checked_.stream += "v\n"; // counted by OpenMesh for the sake of negative indices
  }

  void face() {
    corners_.clear();
    std::size_t words = 0;
    checked_.stream += 'f';
    for (auto word = in_.word(); !word.empty(); word = in_.word(), ++words) {
      const std::int64_t vertex = resolve(word);
      if (corners_.empty() || corners_.back() != vertex) corners_.push_back(vertex);
      checked_.stream.append(" ").append(word);
    }
    checked_.stream += '\n';
    if (words < 3) in_.fail("the face has ", counted(words, "corner"), ", not three or more");
    while (corners_.size() > 1 && corners_.back() == corners_.front()) corners_.pop_back();
    if (corners_.size() < 3) in_.fail("the face has fewer than three different vertices");
    ++checked_.faces;
    checked_.corners += corners_.size();
    refuse_repeats();
  }

  /// OpenMesh would leave a repeated vertex out and so change the face.
  void refuse_repeats() {
    std::sort(corners_.begin(), corners_.end());
    const auto twice = std::adjacent_find(corners_.begin(), corners_.end());
    if (twice != corners_.end()) in_.fail("the face names vertex ", *twice, " twice");
  }

  /// The vertex, from 1, of a corner written v, v/t, v//n or v/t/n.
  std::int64_t resolve(std::string_view corner) const {
    const auto slash = std::min(corner.find('/'), corner.size());
    const auto vertex = parse<std::int64_t>(corner.substr(0, slash));
    if (!vertex || !are_indices(corner.substr(slash))) in_.fail(quoted(corner), " is not a corner of a face");
    const auto so_far = static_cast<std::int64_t>(checked_.positions.size() / 3);
    const std::int64_t resolved = *vertex < 0 ? so_far + *vertex + 1 : *vertex;
    if (resolved >= 1 && resolved <= vertex_count_) return resolved;
    if (*vertex < 0)
      in_.fail("the face names vertex ", *vertex, ", with only ", counted(so_far, "vertex"), " before it");
    in_.fail("the face names vertex ", *vertex, ", but the file's vertices are 1 to ", vertex_count_);
  }

  /// Whether a corner goes on as /t, //n or /t/n, with either left out at will.
  static bool are_indices(std::string_view parts) {
    if (std::count(parts.begin(), parts.end(), '/') > 2) return false;
    while (!parts.empty()) {
      parts.remove_prefix(1);
      const auto index = parts.substr(0, parts.find('/'));
      if (!index.empty() && !parse<std::int64_t>(index)) return false;
      parts.remove_prefix(index.size());
    }
    return true;
  }

  TextScanner in_;
  std::int64_t vertex_count_;
  CheckedFile checked_;
  std::vector<std::int64_t> corners_;
};

} // namespace

CheckedFile check_obj(const FileBytes& file) {
  return ObjCheck(file).run();
}

} // namespace dirichlet
