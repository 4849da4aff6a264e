// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "dirichlet/array.h"

namespace dirichlet {

/// What a caller paints is checked here, once, before anything changes. Each throws an InputError that names what and
/// where: the first offender, and where they can be many, how many more there are.

/// At least one vertex, each in [0, vertex_count).
void check_painted(Index vertex_count, std::span<const Index> painted);

/// Places that name a vertex again, and the place where it stood first.
std::vector<std::array<Index, 2>> find_repeats(Index vertex_count, std::span<const Index> painted);

/// (C, k) finite, C those of `painted`, at least one column, and the same for a vertex that is named twice.
void check_values(std::span<const Index> painted, const std::vector<std::array<Index, 2>>& repeats,
                  const Eigen::Ref<const Eigen::MatrixXd>& values);

/// Empty, or (V,) finite.
void check_source(Index vertex_count, std::span<const double> source);

} // namespace dirichlet
