// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/summed_pivots.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "index.h"

namespace dirichlet {
namespace {

/// The sum of N columns of a panel each, rows [begin, end): several at once, as each waits for its last addition.
template <std::size_t N, class Real>
void sum_columns(const Real* a, Index begin, Index end, Index ld, Real* sums) {
  std::array<Real, N> sum{};
  for (std::ptrdiff_t i = begin; i < end; ++i)
    for (std::size_t c = 0; c < N; ++c) sum[c] += a[i + static_cast<std::ptrdiff_t>(c) * ld];
  std::copy(sum.begin(), sum.end(), sums);
}

} // namespace

template <class Real>
void sum_pivots(const Real* a, Index m, Index w, Index ld, const Real* slack, Real* pivots) {
  std::array<Real, static_cast<std::size_t>(kPanelColumns * kPanelColumns)> weight; // (w, w) in the same order
  std::array<Real, static_cast<std::size_t>(kPanelColumns)> outside{};              // to all but these columns
  Index c = 0;
  for (; c + 4 <= w; c += 4) sum_columns<4>(a + std::ptrdiff_t{c} * ld, w, m, ld, outside.data() + c);
  for (; c < w; ++c) sum_columns<1>(a + std::ptrdiff_t{c} * ld, w, m, ld, outside.data() + c);
  for (Index j = 0; j < w; ++j) {
    outside[at(j)] = slack[j] - outside[at(j)];
    for (Index i = j + 1; i < w; ++i) weight[at(j * w + i)] = -a[i + std::ptrdiff_t{j} * ld];
  }
  for (Index k = 0; k < w; ++k) {
    const Real* const column = weight.data() + std::ptrdiff_t{k} * w;
    Real pivot = outside[at(k)];
    for (Index i = k + 1; i < w; ++i) pivot += column[i];
    pivots[k] = pivot;
    for (Index j = k + 1; j < w; ++j) {
      const Real share = column[j] / pivot;
      outside[at(j)] += share * outside[at(k)];
      for (Index i = j + 1; i < w; ++i) weight[at(j * w + i)] += share * column[i];
    }
  }
}

template void sum_pivots(const float*, Index, Index, Index, const float*, float*);
template void sum_pivots(const double*, Index, Index, Index, const double*, double*);

} // namespace dirichlet
