// SPDX-License-Identifier: GPL-3.0-or-later
#include "strips.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "index.h"
#include "level_numbers.h"
#include "parallel.h"
#include "vector3.h"

namespace dirichlet {
namespace {

/// (x - low) / (high - low), whose differences may overflow.
double part(double low, double x, double high) {
  return (x / 2 - low / 2) / (high / 2 - low / 2);
}

/// A corner of a triangle.
struct Corner {
  double value;
  Index number; ///< of the levels that are <= value
  Vector3 position;
};

/// Adds up one triangle after the other.
class StripMeter {
 public:
  explicit StripMeter(std::span<const double> levels)
      : levels_(levels), strips_{std::vector<double>(levels.size()), std::vector<double>(levels.size()),
                                 std::vector<double>(levels.size())},
        passed_(levels.size() + 1) {}

  /// \param corner  of ascending values
  void add(const std::array<Corner, 3>& corner) {
    const auto& [low, middle, high] = corner;
    if (!(low.value < high.value)) return;
    const Vector3 across = cross(middle.position - low.position, high.position - low.position);
    const double area = std::sqrt(dot(across, across)) / 2;
    const double bend = part(low.value, middle.value, high.value);
    const Vector3 facing = low.position + bend * (high.position - low.position) - middle.position;
    const double length = std::sqrt(dot(facing, facing)); // of the line through the middle corner, the longest
    std::size_t k = at(low.number);
    while (k > 0 && levels_[k - 1] == low.value) --k;
    for (; k < at(high.number); ++k) {
      const double level = levels_[k], rise = part(low.value, level, high.value), fall = 1 - rise;
      const bool lower = level < middle.value;
      strips_.area[k] += area * (lower ? rise * (rise / bend) : 1 - (bend < 1 ? fall * (fall / (1 - bend)) : 0));
      if (level > low.value) strips_.before[k] += length * (level <= middle.value ? rise / bend : fall / (1 - bend));
      if (level < high.value) strips_.after[k] += length * (lower ? rise / bend : fall / (1 - bend));
    }
    passed_[k] += area;
  }

  void add(const StripMeter& other) {
    const auto sum = [](std::vector<double>& to, const std::vector<double>& from) {
      for (std::size_t k = 0; k < to.size(); ++k) to[k] += from[k];
    };
    sum(strips_.area, other.strips_.area);
    sum(strips_.before, other.strips_.before);
    sum(strips_.after, other.strips_.after);
    sum(passed_, other.passed_);
  }

  Strips finish() {
    double below = 0; // of triangles that lie below the level
    for (std::size_t k = 0; k < levels_.size(); ++k) strips_.area[k] += below += passed_[k];
    return std::move(strips_);
  }

 private:
  std::span<const double> levels_;
  Strips strips_;
  std::vector<double> passed_; ///< (K + 1,) area of the triangles below that level and above the one before
};

/// The triangle's corners by value; false if one of them has none.
bool load(const Mesh& triangles, std::span<const double> field, std::span<const Index> numbers, std::size_t t,
          double scale, std::array<Corner, 3>& corner) {
  const auto position = [&](Index v) {
    const double* p = triangles.positions().data() + 3 * at(v);
    return scale * Vector3{p[0], p[1], p[2]};
  };
  const auto vertices = triangles.corners().subspan(3 * t, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const Index v = vertices[i];
    if (numbers[at(v)] == kUndefined) return false;
    corner[i] = {field[at(v)], numbers[at(v)], position(v)};
  }
  std::stable_sort(corner.begin(), corner.end(), [](const Corner& a, const Corner& b) { return a.value < b.value; });
  return true;
}

} // namespace

Strips measure_strips(const Mesh& triangles, std::span<const double> field, std::span<const double> levels,
                      const CancelToken& cancel) {
  double size = 0;
  for (const double x : triangles.positions()) size = std::max(size, std::abs(x));
  const double scale = unit_scale(size);
  const std::vector<Index> numbers = level_numbers(field, levels);
  const std::size_t count = at(triangles.face_count());
  // As many sums as there is room for, of the same triangles whatever the threads, so that rounding is the same too.
  constexpr std::size_t kWorthOne = 1 << 14, kRoom = 1 << 20;
  const std::size_t blocks =
      std::clamp(std::min(count / kWorthOne, kRoom / (levels.size() + 1)), std::size_t{1}, count);
  std::vector<StripMeter> meters(blocks, StripMeter(levels));
  parallel_chunks(blocks, 1, [&](std::size_t begin, std::size_t end) {
    std::array<Corner, 3> corner{};
    for (std::size_t block = begin; block < end; ++block)
      for (std::size_t t = count * block / blocks; t < count * (block + 1) / blocks; ++t) {
        if (t % kWorthOne == 0) cancel.check();
        if (load(triangles, field, numbers, t, scale, corner)) meters[block].add(corner);
      }
  });
  for (std::size_t block = 1; block < blocks; ++block) meters[0].add(meters[block]);
  return meters[0].finish();
}

} // namespace dirichlet
