// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/ordered_matrix.h"

#include <algorithm>
#include <utility>

#include "for_row.h"
#include "index.h"
#include "parallel.h"

namespace dirichlet {
namespace {

constexpr std::size_t kRowsWorthThread = 1 << 13;

std::vector<Index> row_offsets(const SparseMatrix& K, std::span<const Index> order) {
  std::vector<Index> offsets(order.size() + 1, 0);
  parallel_chunks(order.size(), kRowsWorthThread, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      offsets[i + 1] = K.outerIndexPtr()[order[i] + 1] - K.outerIndexPtr()[order[i]];
  });
  for (std::size_t i = 0; i < order.size(); ++i) offsets[i + 1] += offsets[i];
  return offsets;
}

} // namespace

OrderedMatrix order_matrix(const SparseMatrix& K, const SymbolicFactor& symbolic) {
  OrderedMatrix matrix;
  matrix.offsets = row_offsets(K, symbolic.order);
  matrix.upper.resize(symbolic.order.size());
  matrix.columns.resize(at(matrix.offsets.back()));
  matrix.values.resize(at(matrix.offsets.back()));
  parallel_chunks(symbolic.order.size(), kRowsWorthThread, [&](std::size_t begin, std::size_t end) {
    std::vector<std::pair<Index, double>> row;
    for (std::size_t i = begin; i < end; ++i) {
      row.clear();
      for_row(K, symbolic.order[i], [&](Index u, double value) { row.emplace_back(symbolic.position[at(u)], value); });
      std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      auto e = at(matrix.offsets[i]);
      matrix.upper[i] = matrix.offsets[i];
      for (const auto& [column, value] : row) {
        matrix.upper[i] += column < static_cast<Index>(i);
        matrix.columns[e] = column;
        matrix.values[e++] = value;
      }
    }
  });
  return matrix;
}

} // namespace dirichlet
