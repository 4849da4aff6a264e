// SPDX-License-Identifier: GPL-3.0-or-later
// What is done to every row of a matrix or vector, on all cores. Sums are taken over blocks of a fixed size and added
// in their order, so that no bit depends on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "for_row.h"
#include "parallel.h"

namespace dirichlet::multigrid {

/// Rows that are worth a thread.
inline constexpr std::size_t kRowGrain = 8192;

template <class Integer>
std::size_t at(Integer i) {
  return static_cast<std::size_t>(i);
}

/// Calls f(row) for all of [0, count).
template <class Integer, class F>
void for_rows(Integer count, const F& f) {
  parallel_chunks(at(count), kRowGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) f(static_cast<Index>(i));
  });
}

/// The sum of f(row) over [0, count).
template <class Integer, class F>
double sum_rows(Integer count, const F& f) {
  constexpr std::size_t kBlock = 1024;
  const std::size_t n = at(count);
  std::vector<double> sums((n + kBlock - 1) / kBlock);
  parallel_chunks(sums.size(), kRowGrain / kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      double sum = 0;
      for (std::size_t i = block * kBlock; i < std::min(n, (block + 1) * kBlock); ++i) sum += f(static_cast<Index>(i));
      sums[block] = sum;
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// A(row,:) x
template <class Matrix>
double row_product(const Matrix& A, Index row, const std::vector<double>& x) {
  double sum = 0;
  for_row(A, row, [&](Index j, double a) { sum += a * x[at(j)]; });
  return sum;
}

} // namespace dirichlet::multigrid
