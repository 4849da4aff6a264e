// SPDX-License-Identifier: GPL-3.0-or-later
#include "repeated_faces.h"

#include <algorithm>
#include <utility>

#include "index.h"
#include "parallel_collect.h"

namespace dirichlet {
namespace {

/// A face by what does not depend on where it starts and which way it runs.
struct Marked {
  std::uint64_t mark;
  Index face;
};

class RepeatFinder {
 public:
  RepeatFinder(std::span<const Index> offsets, std::span<const Index> corners, const Connectivity& connectivity)
      : offsets_(offsets), corners_(corners), opposite_(connectivity.opposite),
        triangular_(corners.size() == 3 * (offsets.size() - 1)) {
    if (triangular_) return;
    face_of_corner_.resize(corners.size());
    for (std::size_t f = 0; f + 1 < offsets.size(); ++f)
      std::fill(face_of_corner_.begin() + offsets[f], face_of_corner_.begin() + offsets[f + 1], static_cast<Index>(f));
  }

  [[nodiscard]] std::vector<std::array<Index, 2>> find() const {
    constexpr std::size_t kGrain = 1 << 15;
    Buffer<Marked> suspects = parallel_collect<Marked>(
        offsets_.size() - 1, kGrain, [&](std::size_t begin, std::size_t end, Buffer<Marked>& found) {
          for (auto f = static_cast<Index>(begin); f < static_cast<Index>(end); ++f)
            if (may_repeat(f)) found.push_back({mark(f), f});
        });
    std::sort(suspects.begin(), suspects.end(),
              [](const Marked& a, const Marked& b) { return std::pair(a.mark, a.face) < std::pair(b.mark, b.face); });
    std::vector<std::array<Index, 2>> repeats;
    std::vector<Index> firsts; // of the faces with one mark
    for (std::size_t i = 0; i < suspects.size(); ++i) {
      if (i == 0 || suspects[i].mark != suspects[i - 1].mark) firsts.clear();
      const Index face = suspects[i].face;
      const auto first = std::find_if(firsts.begin(), firsts.end(), [&](Index f) { return repeats_face(face, f); });
      if (first == firsts.end())
        firsts.push_back(face);
      else
        repeats.push_back({face, *first});
    }
    std::sort(repeats.begin(), repeats.end());
    return repeats;
  }

 private:
  [[nodiscard]] std::span<const Index> vertices(Index face) const {
    return corners_.subspan(at(offsets_[at(face)]), at(offsets_[at(face) + 1] - offsets_[at(face)]));
  }
  [[nodiscard]] Index face_of(Index corner) const { return triangular_ ? corner / 3 : face_of_corner_[at(corner)]; }

  /// Whether every side has another face, and those with one other face have the same one: seldom so.
  [[nodiscard]] bool may_repeat(Index face) const {
    Index neighbour = Connectivity::kNonManifold;
    for (Index c = offsets_[at(face)]; c < offsets_[at(face) + 1]; ++c) {
      const Index other = opposite_[at(c)];
      if (other == Connectivity::kBorder) return false;
      if (other < 0) continue;
      if (neighbour >= 0 && neighbour != face_of(other)) return false;
      neighbour = face_of(other);
    }
    return true;
  }

  /// The sum over its sides of a number that mixes the ends.
  [[nodiscard]] std::uint64_t mark(Index face) const {
    const auto v = vertices(face);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const auto [low, high] = std::minmax(v[i], v[i + 1 < v.size() ? i + 1 : 0]);
      std::uint64_t side = (static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high)) + 1;
      side *= 0x9E37'79B9'7F4A'7C15; // odd: no two sides share a product
      side ^= side >> 32;
      sum += side * side;
    }
    return sum;
  }

  [[nodiscard]] bool repeats_face(Index face, Index first) const {
    const auto a = vertices(face), b = vertices(first);
    if (a.size() != b.size()) return false;
    const auto start = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
    if (start == b.size()) return false;
    const std::size_t k = a.size();
    bool along = true, against = true;
    for (std::size_t i = 0; i < k; ++i) {
      along = along && a[i] == b[(start + i) % k];
      against = against && a[i] == b[(start + k - i) % k];
    }
    return along || (against && !is_closed(face));
  }

  /// Whether no side of a face has three or more faces.
  [[nodiscard]] bool is_closed(Index face) const {
    return std::all_of(opposite_.begin() + offsets_[at(face)], opposite_.begin() + offsets_[at(face) + 1],
                       [](Index other) { return other >= 0; });
  }

  std::span<const Index> offsets_;
  std::span<const Index> corners_;
  std::span<const Index> opposite_;
  bool triangular_;
  Buffer<Index> face_of_corner_; ///< empty for triangles
};

} // namespace

std::vector<std::array<Index, 2>> find_repeated_faces(std::span<const Index> offsets, std::span<const Index> corners,
                                                      const Connectivity& connectivity) {
  return RepeatFinder(offsets, corners, connectivity).find();
}

Index number_among_all(Index face, std::span<const Index> left_out) {
  for (const Index out : left_out) {
    if (out > face) break;
    ++face;
  }
  return face;
}

} // namespace dirichlet
