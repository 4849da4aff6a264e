// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "dirichlet/cancel.h"
#include "dirichlet/mesh.h"

namespace dirichlet {

/// `count` levels spread evenly inside the window [low, high]: low + (k + 1/2) (high - low) / count, ascending. Never
/// one more or less, and none at the ends. Source: the sliding window on the colour ramp of "Dirichlet Surface
/// Isolines". Where the window holds too few doubles, levels
/// repeat. \throws InputError  count not in 1 … 1,000,000, an empty window, or ends that are not finite.
std::vector<double> even_levels(double low, double high, Index count);

/// The levels (k + phase) step for all whole k that lie strictly inside (low, high), ascending; animate `phase` from 0
/// to 1 and the lines move by one step. \throws InputError  step not > 0, an empty window, a number that is not finite,
/// or more than 1,000,000 levels.
std::vector<double> stepped_levels(double low, double high, double step, double phase);

/// `count` levels inside the window [low, high] whose strips on the surface have equal areas: those between neighbours,
/// and the two between a level and an end of the window. Triangles on which the field is constant do not count, since
/// no line divides them; nor do those with a NaN.
/// \param low, high  nothing said: the least and greatest value of the triangles that count
/// \param cancel     stops the work within a fraction of a second, by a CancelledError
/// \returns ascending; the areas are equal to 1e-9 of their sum, where there are enough doubles. A level in a gap that
///          no value of the surface fills may lie anywhere in it.
/// \throws InputError     as even_levels; a field of a wrong length or with an infinite value; a field that is constant
///                        or has no values; a window that holds none of the surface, or only what has no area
/// \throws TopologyError  a polygon that has no triangulation
/// Cost: O(V + T) about five times, plus that of 2000 isolines. Same result whatever the thread count.
std::vector<double> equal_area_levels(const Mesh& mesh, std::span<const double> field, Index count,
                                      std::optional<double> low = std::nullopt,
                                      std::optional<double> high = std::nullopt, const CancelToken& cancel = {});

/// The same for distances: from one level to the next lines advance equally far on average, as from the ends of the
/// window to the levels beside them. How far lines advance is the area they sweep, divided by their length, added up
/// over two thousand steps or so: even parts of the window, cut further where many vertices have their values. Neither
/// this nor the above changes its lines when another function that ascends is applied to the field, but for what lies
/// between vertices and within a step.
std::vector<double> equal_distance_levels(const Mesh& mesh, std::span<const double> field, Index count,
                                          std::optional<double> low = std::nullopt,
                                          std::optional<double> high = std::nullopt, const CancelToken& cancel = {});

/// The field's value at the point of the surface nearest to `point`: the level whose line runs through it.
/// Cost: O(F). \throws InputError  field of a wrong length, or NaN there; a point that is not finite.
double level_through_point(const Mesh& mesh, std::span<const double> field, const std::array<double, 3>& point);

} // namespace dirichlet
