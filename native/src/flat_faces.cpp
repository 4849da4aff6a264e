// SPDX-License-Identifier: GPL-3.0-or-later
#include "flat_faces.h"

#include <algorithm>

#include "face_extent.h"
#include "index.h"
#include "parallel_collect.h"

namespace dirichlet {
bool is_flat(std::span<const double> positions, std::span<const Index> face) {
  const FaceExtent extent = face_extent(positions, face);
  constexpr double kSmall = 1e-60, kLarge = 1e60; // in between no product of four lengths vanishes or overflows
  const double scale = extent.size > kSmall && extent.size < kLarge ? 1 : unit_scale(extent.size);
  const Vector3 line = scale * extent.line;
  const double rounding = scale * extent.rounding, least = rounding * rounding * dot(line, line);
  return std::all_of(face.begin() + 1, face.end(), [&](Index v) {
    const Vector3 twice_area = cross(line, scale * (point(positions, v) - extent.origin));
    return dot(twice_area, twice_area) <= least;
  });
}

Buffer<Index> find_flat_faces(std::span<const double> positions, std::span<const Index> offsets,
                              std::span<const Index> corners) {
  constexpr std::size_t kGrain = 1 << 14;
  return parallel_collect<Index>(offsets.size() - 1, kGrain,
                                 [&](std::size_t begin, std::size_t end, Buffer<Index>& found) {
                                   for (std::size_t f = begin; f < end; ++f) {
                                     const auto first = at(offsets[f]), last = at(offsets[f + 1]);
                                     if (is_flat(positions, corners.subspan(first, last - first)))
                                       found.push_back(static_cast<Index>(f));
                                   }
                                 });
}

} // namespace dirichlet
