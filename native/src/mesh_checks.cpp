// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_checks.h"

#include <algorithm>
#include <cmath>

#include "any_value.h"
#include "dirichlet/error.h"
#include "message.h"

namespace dirichlet {

bool is_coordinate(double x) {
  constexpr double kLargest = 1e150; // squares have to stay finite, for lengths and areas
  return std::abs(x) <= kLargest;
}

void check_positions(std::span<const double> positions) {
  if (positions.size() % 3 != 0)
    throw InputError(message("positions have ", positions.size(), " numbers, which is not a multiple of 3"));
  if (positions.size() / 3 > kMostCorners)
    throw InputError(message("a mesh has at most ", kMostCorners, " vertices, not ", positions.size() / 3));
  const auto bad = [](double x) { return !is_coordinate(x); };
  if (!any_value(positions, bad)) return;
  const auto first = std::find_if(positions.begin(), positions.end(), bad);
  const auto count = std::count_if(first, positions.end(), bad);
  throw InputError(message("vertex ", (first - positions.begin()) / 3, " has the coordinate ", *first,
                           ", which is not finite or beyond 1e150", and_more(count - 1, "coordinate")));
}

void check_offsets(std::span<const Index> offsets, std::size_t corner_count) {
  if (offsets.size() < 2 || corner_count == 0) throw InputError("the mesh has no faces");
  if (corner_count > kMostCorners)
    throw InputError(message("a mesh has at most ", kMostCorners, " corners, not ", corner_count));
  if (offsets.front() != 0 || offsets.back() != static_cast<Index>(corner_count))
    throw InputError(message("face offsets run from ", offsets.front(), " to ", offsets.back(),
                             ", but have to run from 0 to the number of corners, ", corner_count));
  const auto drop = std::is_sorted_until(offsets.begin(), offsets.end());
  if (drop != offsets.end())
    throw InputError(
        message("face offsets descend at place ", drop - offsets.begin(), ", from ", *(drop - 1), " to ", *drop));
}

void check_corner_range(std::span<const Index> offsets, std::span<const Index> corners, Index vertex_count) {
  const auto bad = [=](Index v) { return (v < 0) | (v >= vertex_count); };
  if (!any_value(corners, bad)) return;
  const auto first = std::find_if(corners.begin(), corners.end(), bad);
  const auto place = static_cast<Index>(first - corners.begin());
  const auto face = std::upper_bound(offsets.begin(), offsets.end(), place) - offsets.begin() - 1;
  throw InputError(message("face ", face, " names vertex ", *first, ", but the vertices are 0 to ", vertex_count - 1,
                           and_more(std::count_if(first, corners.end(), bad) - 1, "corner")));
}

} // namespace dirichlet
