// SPDX-License-Identifier: GPL-3.0-or-later
#include "twin.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "index.h"
#include "parallel.h"

namespace dirichlet {
namespace {

constexpr std::size_t kGrain = 1 << 14; // rows

/// Row i of K, its fixed columns left out, times the k columns of x.
inline void multiply_row(const SparseView& K, const Mask& mask, Index i, const double* x, double* y, Index k) {
  const Index* const column = K.innerIndexPtr();
  const double* const value = K.valuePtr();
  const Index begin = K.outerIndexPtr()[i], end = K.outerIndexPtr()[i + 1];
  const auto weight = [&](Index e) { return mask[at(column[e])] != 0 ? 0 : value[e]; };
  if (k == 1) { // the usual case: its sum stays in a register
    double sum = 0;
    for (Index e = begin; e < end; ++e) sum += weight(e) * x[column[e]];
    *y = sum;
    return;
  }
  std::fill_n(y, k, 0.0);
  for (Index e = begin; e < end; ++e) {
    const double factor = weight(e), *const from = x + std::int64_t{column[e]} * k;
    for (Index c = 0; c < k; ++c) y[c] += factor * from[c];
  }
}

/// What row i of rhs − A x leaves in each of the k columns, by differences of neighbours: a diagonal that is stored has
/// lost all weights below the rounding of the largest. \returns  the sum of the row's sizes
template <bool kSingle>
inline double leave_row(const SparseView& K, const Mask& mask, Index i, const double* rhs, const double* x,
                        Index columns, double* left) {
  const Index k = kSingle ? 1 : columns; // known when compiled, it costs no loop
  const double* const own = x + std::int64_t{i} * k;
  std::copy_n(rhs, k, left);
  double sizes = 0;
  for (Index e = K.outerIndexPtr()[i]; e < K.outerIndexPtr()[i + 1]; ++e) {
    const Index j = K.innerIndexPtr()[e];
    const double entry = K.valuePtr()[e], free = mask[at(j)] != 0 ? 0 : 1; // the values of the fixed are in rhs
    sizes += std::abs(entry);
    const double weight = j == i ? 0 : entry;
    const double* const other = x + std::int64_t{j} * k;
    for (Index c = 0; c < k; ++c) left[c] -= weight * (free * other[c] - own[c]);
  }
  return sizes;
}

/// (count,) sums: add(row, sums) for every row that is not fixed, block by block, and then the blocks.
template <class Add>
Eigen::ArrayXd sum_over_free_rows(const Mask& mask, std::size_t count, const Add& add) {
  const std::size_t blocks = (mask.size() + kGrain - 1) / kGrain;
  Eigen::ArrayXXd sums = Eigen::ArrayXXd::Zero(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(blocks));
  parallel_chunks(blocks, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t block = first; block < last; ++block) {
      double* const sum = sums.col(static_cast<Eigen::Index>(block)).data();
      const std::size_t end = std::min(mask.size(), (block + 1) * kGrain);
      for (std::size_t i = block * kGrain; i < end; ++i)
        if (mask[i] == 0) add(i, sum);
    }
  });
  return sums.rowwise().sum();
}

} // namespace

void multiply_twin(const SparseView& K, const Mask& mask, const Block& x, Block& y) {
  y.resize(x.rows(), x.cols());
  const auto k = static_cast<Index>(x.cols());
  parallel_chunks(mask.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = static_cast<Index>(i);
      if (mask[i] != 0)
        y.row(row) = x.row(row);
      else
        multiply_row(K, mask, row, x.data(), y.data() + std::int64_t{row} * k, k);
    }
  });
}

Eigen::ArrayXd free_dots(const Mask& mask, const Block& a, const Block& b) {
  const auto k = static_cast<std::size_t>(a.cols());
  return sum_over_free_rows(mask, k, [&](std::size_t i, double* sum) {
    const double *x = a.data() + i * k, *y = b.data() + i * k;
    for (std::size_t c = 0; c < k; ++c) sum[c] += x[c] * y[c];
  });
}

double relative_residual(const SparseView& K, const Mask& mask, const Block& rhs, const Block& x,
                         const Eigen::ArrayXd& error) {
  const auto k = static_cast<std::size_t>(x.cols());
  const Eigen::ArrayXd sums = sum_over_free_rows(mask, 3 * k, [&](std::size_t i, double* sum) { // two norms, and
    double* const left = sum + 2 * k;                                                           // room for a row
    const double* const b = rhs.data() + i * k;
    const auto row = static_cast<Index>(i), columns = static_cast<Index>(k);
    const double sizes = k == 1 ? leave_row<true>(K, mask, row, b, x.data(), columns, left)
                                : leave_row<false>(K, mask, row, b, x.data(), columns, left);
    for (std::size_t c = 0; c < k; ++c) {
      const double counted = std::abs(left[c]) - sizes * error[static_cast<Eigen::Index>(c)];
      if (!(counted <= 0)) sum[c] += counted * counted; // NaN counts
      sum[k + c] += b[c] * b[c];
    }
  });
  const Eigen::ArrayXd residual = sums.head(rhs.cols()), norm = sums.segment(rhs.cols(), rhs.cols());
  if (!residual.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  return (norm > 0).select(residual / norm, residual).sqrt().maxCoeff();
}

void add_columns(const Block& b, const Eigen::ArrayXd& factors, Block& a) {
  const auto k = static_cast<std::size_t>(a.cols());
  parallel_chunks(static_cast<std::size_t>(a.rows()), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * k; i < end * k; i += k)
      for (std::size_t c = 0; c < k; ++c) a.data()[i + c] += factors[static_cast<Eigen::Index>(c)] * b.data()[i + c];
  });
}

} // namespace dirichlet
