// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "dirichlet/isolines.h"
#include "vector3.h"

namespace dirichlet {

/// Which points of a line matter, by Douglas and Peucker; the parts still to look at are on a stack of its own. See
/// simplify_lines.
class LineSimplifier {
 public:
  LineSimplifier(const Isolines& lines, double tolerance);

  /// Sets kept[i] to 1 for the points of line l that stay. May be called for several lines at once.
  void mark(std::size_t l, const CancelToken& cancel, std::vector<std::uint8_t>& kept) const;

 private:
  using Farthest = std::pair<double, std::size_t>;
  [[nodiscard]] Vector3 point(std::size_t i) const;
  [[nodiscard]] Farthest farthest(std::size_t first, std::size_t last, std::size_t end) const;
  void mark_between(std::size_t first, std::size_t last, std::size_t end, const CancelToken& cancel,
                    std::vector<std::uint8_t>& kept) const;

  const Isolines& lines_;
  double scale_; ///< to a unit in which squares neither vanish nor overflow
  double tolerance_;
};

} // namespace dirichlet
