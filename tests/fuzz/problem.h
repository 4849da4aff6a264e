// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dirichlet/field.h"
#include "mesh_makers.h"
#include "script.h"

namespace dirichlet::fuzz {

/// Painted vertices and their values, one per place.
struct Painting {
  std::vector<Index> vertices;
  std::vector<double> values;

  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> column() const {
    return {values.data(), static_cast<Eigen::Index>(values.size())};
  }
};

/// p v x  paints a vertex, or the one behind the last, which is not there;  r v n x  paints n vertices from v on.
/// \returns false where the letter does not paint
bool paint(Painting& painting, Index vertex_count, char letter, Script& script);

/// L n: the operator.
Laplacian read_laplacian(Script& script);

/// A surface, damage, paint and levels, and how to solve.
struct Problem {
  makers::PolygonSoup soup;
  Painting painting;
  std::vector<double> source; ///< empty or (V,)
  std::vector<double> levels;
  Index even = 0, equal = 0; ///< so many levels more, spread evenly over the field's range and by area
  Laplacian laplacian = Laplacian::graph;
  SolverOptions options;
};

/// Any script is a problem. To the letters of add_surface, damage and paint come
///   l x  level    e n  even levels    a n  levels of equal areas    o v x  source    d n  method    L n  Laplacian
Problem read_problem(Script script);

} // namespace dirichlet::fuzz
