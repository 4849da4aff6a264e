// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/ordered_matrix.h"

#include "index.h"
#include "parallel.h"
#include "prefetch.h"

namespace dirichlet {
namespace {

constexpr std::size_t kRowsWorthThread = 1 << 13;

std::vector<Index> row_offsets(const Graph& graph, std::span<const Index> order) {
  std::vector<Index> offsets(order.size() + 1, 0);
  parallel_chunks(order.size(), kRowsWorthThread, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      offsets[i + 1] = graph.offsets[at(order[i] + 1)] - graph.offsets[at(order[i])];
  });
  for (std::size_t i = 0; i < order.size(); ++i) offsets[i + 1] += offsets[i];
  return offsets;
}

/// Fills `result`, and `to` beside its columns with the values of the graph's entries if it has any. Rows of the graph
/// are all over memory: they are asked for some rows ahead.
template <bool kHasValues>
void renumber(const Graph& graph, [[maybe_unused]] const double* values, std::span<const Index> order,
              std::span<const Index> position, OrderedPattern& result, [[maybe_unused]] double* to) {
  constexpr std::size_t kAhead = 8;
  parallel_chunks(order.size(), kRowsWorthThread, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i + 2 * kAhead < end) {
        const Index soon = graph.offsets[at(order[i + kAhead])];
        prefetch(graph.neighbours.data() + soon);
        if constexpr (kHasValues) prefetch(values + soon);
        prefetch(graph.offsets.data() + order[i + 2 * kAhead]);
      }
      const Index first = graph.offsets[at(order[i])], last = graph.offsets[at(order[i] + 1)];
      Index lower = result.offsets[i], upper = lower;
      for (Index e = first; e < last; ++e) upper += position[at(graph.neighbours[at(e)])] < static_cast<Index>(i);
      result.upper[i] = upper;
      for (Index e = first; e < last; ++e) {
        const Index column = position[at(graph.neighbours[at(e)])];
        const bool left = column < static_cast<Index>(i); // as likely as not: counted, not branched on
        const Index place = left ? lower : upper;
        lower += left;
        upper += !left;
        result.columns[at(place)] = column;
        if constexpr (kHasValues) to[place] = values[e];
      }
    }
  });
}

void resize(OrderedPattern& pattern, const Graph& graph, std::span<const Index> order) {
  pattern.offsets = row_offsets(graph, order);
  pattern.upper.resize(order.size());
  pattern.columns.resize(at(pattern.offsets.back()));
}

} // namespace

OrderedPattern order_pattern(const Graph& graph, std::span<const Index> order, std::span<const Index> position) {
  OrderedPattern pattern;
  resize(pattern, graph, order);
  renumber<false>(graph, nullptr, order, position, pattern, nullptr);
  return pattern;
}

OrderedMatrix order_matrix(const SparseMatrix& K, std::span<const Index> order) {
  const Graph graph{{K.outerIndexPtr(), at(static_cast<Index>(K.rows())) + 1},
                    {K.innerIndexPtr(), static_cast<std::size_t>(K.nonZeros())}};
  OrderedMatrix matrix;
  resize(matrix, graph, order);
  matrix.values.resize(matrix.columns.size());
  renumber<true>(graph, K.valuePtr(), order, inverse_permutation(order), matrix, matrix.values.data());
  return matrix;
}

std::vector<Index> inverse_permutation(std::span<const Index> order) {
  std::vector<Index> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[at(order[k])] = static_cast<Index>(k);
  return position;
}

} // namespace dirichlet
