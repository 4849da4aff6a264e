// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

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

/// The field's value at the point of the surface nearest to `point`: the level whose line runs through it.
/// Cost: O(F). \throws InputError  field of a wrong length, or NaN there; a point that is not finite.
double level_through_point(const Mesh& mesh, std::span<const double> field, const std::array<double, 3>& point);

} // namespace dirichlet
