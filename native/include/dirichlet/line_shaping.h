// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "dirichlet/isolines.h"

namespace dirichlet {

// What can be done to isolines once they are there. Every function gives new lines: their order, levels and closedness
// stay, their lengths are measured anew. Lines may be any arrays that fit together as those of Isolines do; others are
// refused with an InputError. What can take long is stopped by `cancel` within a fraction of a second, by a
// CancelledError. Same result whatever the thread count.

/// The lines that are no shorter than `least` >= 0; theirs is the length that was given. Cost: O(P).
Isolines keep_long(const Isolines& lines, double least);

/// Lines with fewer kinks that still run on the surface: in each of the steps every point slides along its own edge,
/// half of the way to where the line between its neighbours would cross the edge if its two triangles were unfolded,
/// all at the same time. What is straight stays so, and no step makes a line longer. A point comes no closer to an end
/// of its edge than a hundredth of the edge, unless it was closer: lines neither cross a vertex nor gather in it. The
/// ends of open lines stay where they are. \param steps  0 … 10,000 \throws InputError  lines without edges (resampled
/// ones), an edge that the mesh does not have vertices for. Cost: O(P steps), lines on all cores.
Isolines smooth_lines(const Mesh& mesh, Isolines lines, Index steps, const CancelToken& cancel = {});

/// The lines without the points that matter least: what is left out lies within `tolerance` >= 0 of the segment that
/// takes its place. The ends of open lines stay, and three points or more of closed ones (two of one that had two).
/// Source: Douglas and Peucker 1973. Cost: O(P log P) as a rule, O(P²) for spirals.
Isolines simplify_lines(const Isolines& lines, double tolerance, const CancelToken& cancel = {});

/// Every line as points evenly spaced along it: length / spacing segments, rounded, at least 1 of an open line and 3
/// of a closed one, beginning at its first point. They lie on the line but on no edge, so `edges` and `t` are empty.
/// \param spacing  > 0, finite
/// \throws InputError  2^30 points or more. Cost: O(P + output).
Isolines resample_lines(const Isolines& lines, double spacing, const CancelToken& cancel = {});

/// The same lines on vertices that have moved, as on a mesh in another pose: (1 - t) positions[a] + t positions[b].
/// \param positions  (V, 3), finite where the lines are
/// \throws InputError  lines without edges (resampled ones), an edge whose vertex has no position. Cost: O(P).
Isolines move_lines(Isolines lines, std::span<const double> positions);

} // namespace dirichlet
