// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "rows.h"

namespace dirichlet::multigrid {

/// Consecutive rows of a matrix, before it is known where they begin in the whole.
template <class Real>
struct RowBlock {
  std::vector<Index> sizes;
  std::vector<Index> columns;
  std::vector<Real> values;
};

template <class Real>
Eigen::SparseMatrix<Real, Eigen::RowMajor, Index> join(Eigen::Index rows, Eigen::Index columns,
                                                       const std::vector<RowBlock<Real>>& blocks) {
  Eigen::SparseMatrix<Real, Eigen::RowMajor, Index> result(rows, columns);
  Index* offset = result.outerIndexPtr();
  *offset = 0;
  for (const auto& block : blocks)
    for (const Index size : block.sizes) {
      offset[1] = offset[0] + size;
      ++offset;
    }
  result.resizeNonZeros(*offset);
  Index* column = result.innerIndexPtr();
  Real* value = result.valuePtr();
  for (const auto& block : blocks) {
    column = std::copy(block.columns.begin(), block.columns.end(), column);
    value = std::copy(block.values.begin(), block.values.end(), value);
  }
  return result;
}

/// A matrix from its rows, on all cores: every thread makes an `append` of its own, with what memory that needs, and
/// calls append(row, block) for the rows it has; append adds columns, values and a size.
template <class Real, class Make>
Eigen::SparseMatrix<Real, Eigen::RowMajor, Index> matrix_by_rows(Eigen::Index rows, Eigen::Index columns,
                                                                 const Make& make_append) {
  constexpr std::size_t kBlock = 1024;
  const std::size_t n = at(rows);
  std::vector<RowBlock<Real>> blocks((n + kBlock - 1) / kBlock);
  parallel_chunks(blocks.size(), 1, [&](std::size_t begin, std::size_t end) {
    auto append = make_append();
    for (std::size_t b = begin; b < end; ++b)
      for (std::size_t row = b * kBlock; row < std::min(n, (b + 1) * kBlock); ++row)
        append(static_cast<Index>(row), blocks[b]);
  });
  return join(rows, columns, blocks);
}

} // namespace dirichlet::multigrid
