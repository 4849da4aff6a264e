// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_weights.h"

#include <algorithm>
#include <numeric>

#include "dirichlet/buffer.h"
#include "index.h"
#include "parallel.h"

namespace dirichlet {
namespace {

constexpr std::size_t kGrain = 1 << 13;

struct Entry {
  Index column;
  double weight;
};

bool operator<(const Entry& a, const Entry& b) {
  return a.column < b.column;
}

/// Calls visit(row, column, weight) for both directions of every edge whose row is in [begin, end), in order of edges.
template <class Visit>
void for_rows(std::size_t begin, std::size_t end, std::span<const Index> edges, std::span<const double> weights,
              const Visit& visit) {
  for (std::size_t e = 0; e < weights.size(); ++e) {
    const std::size_t i = at(edges[2 * e]), j = at(edges[2 * e + 1]);
    if (i == j) continue;
    if (i >= begin && i < end) visit(i, static_cast<Index>(j), weights[e]);
    if (j >= begin && j < end) visit(j, static_cast<Index>(i), weights[e]);
  }
}

/// Keeps the order of equal columns.
void sort_row(std::span<Entry> row) {
  constexpr std::size_t kInsertion = 24;
  if (row.size() > kInsertion) {
    if (!std::is_sorted(row.begin(), row.end())) std::stable_sort(row.begin(), row.end());
    return;
  }
  for (std::size_t i = 1; i < row.size(); ++i) {
    const Entry inserted = row[i];
    std::size_t j = i;
    for (; j > 0 && inserted < row[j - 1]; --j) row[j] = row[j - 1];
    row[j] = inserted;
  }
}

/// Sorted entries of one column in one. \returns how many are left.
std::size_t merge_row(std::span<Entry> row) {
  std::size_t count = 0;
  for (const Entry& entry : row)
    if (count > 0 && row[count - 1].column == entry.column)
      row[count - 1].weight += entry.weight;
    else
      row[count++] = entry;
  return count;
}

/// Row i of the matrix, with its diagonal, from its entries.
void write_row(Index i, std::span<const Entry> row, Index* column, double* value) {
  double sum = 0;
  for (const Entry& entry : row) sum += entry.weight;
  std::size_t e = 0;
  const auto copy = [&] {
    *column++ = row[e].column;
    *value++ = 0.0 - row[e++].weight; // no -0
  };
  while (e < row.size() && row[e].column < i) copy();
  *column++ = i;
  *value++ = sum;
  while (e < row.size()) copy();
}

} // namespace

SparseMatrix stiffness_of_edges(Index n, std::span<const Index> edges, std::span<const double> weights) {
  Buffer<Index> starts(at(n) + 1, 0); // of every row in `entries`
  Buffer<Index> next(at(n));
  SparseMatrix K(n, n);
  Index* const row_start = K.outerIndexPtr();

  parallel_chunks(at(n), kGrain, [&](std::size_t begin, std::size_t end) {
    for_rows(begin, end, edges, weights, [&](std::size_t row, Index, double) { ++starts[row + 1]; });
  });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  Buffer<Entry> entries(at(starts.back()));
  row_start[0] = 0;
  parallel_chunks(at(n), kGrain, [&](std::size_t begin, std::size_t end) {
    std::copy(starts.data() + begin, starts.data() + end, next.data() + begin);
    for_rows(begin, end, edges, weights, [&](std::size_t row, Index column, double weight) {
      entries[at(next[row]++)] = {column, weight};
    });
    for (std::size_t row = begin; row < end; ++row) {
      const std::span all(entries.data() + starts[row], entries.data() + starts[row + 1]);
      sort_row(all);
      row_start[row + 1] = static_cast<Index>(merge_row(all)) + 1; // one more for the diagonal
    }
  });
  std::partial_sum(row_start, row_start + n + 1, row_start);
  K.resizeNonZeros(row_start[n]);
  Index* const column = K.innerIndexPtr();
  double* const value = K.valuePtr();
  prefer_large_pages(column, at(row_start[n]) * sizeof(Index));
  prefer_large_pages(value, at(row_start[n]) * sizeof(double));
  parallel_chunks(at(n), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const Index first = row_start[row], count = row_start[row + 1] - first - 1;
      write_row(static_cast<Index>(row), {entries.data() + starts[row], at(count)}, column + first, value + first);
    }
  });
  return K;
}

} // namespace dirichlet
