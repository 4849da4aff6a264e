// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dirichlet/injection.h"

namespace dirichlet {

/// What was moved, and how far at most.
struct Projection {
  Index count = 0;
  double farthest = 0;
};

using Column = Eigen::Ref<Eigen::VectorXd, 0, Eigen::InnerStride<>>;

/// The maximum principle, region by region: no value leaves the range painted at the rim. Rounding may, by an ulp, and
/// an isoline at exactly that value would be noise; such values are moved to the end of the range. Regions without a
/// rim have none, and stay. Cost: O(n + rim).
Projection project_onto_painted_range(const FreeRegions& regions, Column values);

} // namespace dirichlet
