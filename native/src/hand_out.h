// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>

#include "fixed_rows.h"
#include "maximum_principle.h"

namespace dirichlet {

/// Of the defined values of all columns.
struct FieldRange {
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();
  Outside outside;
};

/// A finished field by row to the same by vertex, NaN where it is undefined.
/// \param x       (n, k)
/// \param order   (n,) the vertex of every row
/// \param ranges  to which values are held, or null
/// \param values  becomes (n, k)
/// Cost: O(n k), on all cores.
FieldRange hand_out(const Block& x, std::span<const Index> order, const FixedRows& rows, const PaintedRanges* ranges,
                    Eigen::MatrixXd& values);

} // namespace dirichlet
