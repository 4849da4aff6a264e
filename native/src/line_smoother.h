// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "dirichlet/isolines.h"

namespace dirichlet {

/// Damped Jacobi steps on a line's length, which is a convex function of the places of its points on their edges. See
/// smooth_lines.
class LineSmoother {
 public:
  /// \param positions  (V, 3) of the vertices of all edges
  LineSmoother(std::span<const double> positions, const Isolines& lines);

  /// Moves the places t of line l. May be called for several lines at once. Cost: O(points steps).
  void smooth(std::size_t l, Index steps, const CancelToken& cancel, Isolines& lines) const;

 private:
  std::span<const double> positions_;
  double scale_; ///< to a unit in which squares neither vanish nor overflow
};

} // namespace dirichlet
