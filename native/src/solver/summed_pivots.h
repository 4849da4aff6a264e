// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dirichlet/array.h"

namespace dirichlet {

constexpr Index kPanelColumns = 32; ///< of a panel that is factored as one

/// Elimination without a subtraction, for Laplacians of weights that are not negative. A pivot is the sum of what is
/// left of its column, and of its *slack*: the weights to painted vertices, which elimination passes on like weights.
/// So every number of the factor is exact to a few roundings, however much larger some weights are than others; while
/// a diagonal that is stored and subtracted from has lost all weights below the rounding of the largest.
/// Source: Grassmann, Taksar, Heyman, "Regenerative Analysis and Steady State Distributions for Markov Chains", 1985;
/// Alfa, Xue, Ye, "Accurate Computation of the Smallest Eigenvalue of a Diagonally Dominant M-matrix", 2002.

/// The pivots of the leading w <= kPanelColumns columns of an (m, w) panel, column-major with columns ld apart. Of A
/// only what is below the diagonal is read: minus the weights.
/// \param slack   (w,) what painted vertices and eliminated ones have left
/// \param pivots  (w,) the result
template <class Real>
void sum_pivots(const Real* a, Index m, Index w, Index ld, const Real* slack, Real* pivots);

} // namespace dirichlet
