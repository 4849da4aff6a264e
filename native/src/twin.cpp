// SPDX-License-Identifier: GPL-3.0-or-later
#include "twin.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "index.h"
#include "parallel.h"

namespace dirichlet {
namespace {

constexpr std::size_t kGrain = 1 << 14; // rows

/// Row i of K, its fixed columns left out, times the k columns of x.
template <int kColumns>
void multiply_row(const SparseView& K, const Mask& mask, Index i, const double* x, double* y, Index columns) {
  const Index k = kColumns == 1 ? 1 : columns;
  std::fill_n(y, k, 0.0);
  const Index* column = K.innerIndexPtr();
  const double* value = K.valuePtr();
  for (Index e = K.outerIndexPtr()[i]; e < K.outerIndexPtr()[i + 1]; ++e) {
    const double weight = mask[at(column[e])] != 0 ? 0 : value[e];
    const double* from = x + std::int64_t{column[e]} * k;
    for (Index c = 0; c < k; ++c) y[c] += weight * from[c];
  }
}

} // namespace

void multiply_twin(const SparseView& K, const Mask& mask, const Block& x, Block& y) {
  y.resize(x.rows(), x.cols());
  const auto k = static_cast<Index>(x.cols());
  const auto multiply = k == 1 ? multiply_row<1> : multiply_row<Eigen::Dynamic>;
  parallel_chunks(mask.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = static_cast<Index>(i);
      if (mask[i] != 0)
        y.row(row) = x.row(row);
      else
        multiply(K, mask, row, x.data(), y.data() + std::int64_t{row} * k, k);
    }
  });
}

Eigen::ArrayXd free_dots(const Mask& mask, const Block& a, const Block& b) {
  const auto k = static_cast<std::size_t>(a.cols());
  const std::size_t blocks = (mask.size() + kGrain - 1) / kGrain;
  Eigen::ArrayXXd sums = Eigen::ArrayXXd::Zero(a.cols(), static_cast<Eigen::Index>(blocks));
  parallel_chunks(blocks, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t block = first; block < last; ++block) {
      double* const sum = sums.col(static_cast<Eigen::Index>(block)).data();
      const std::size_t end = std::min(mask.size(), (block + 1) * kGrain);
      for (std::size_t i = block * kGrain; i < end; ++i) {
        if (mask[i] != 0) continue;
        const double *x = a.data() + i * k, *y = b.data() + i * k;
        for (std::size_t c = 0; c < k; ++c) sum[c] += x[c] * y[c];
      }
    }
  });
  return sums.rowwise().sum();
}

double relative_residual(const SparseView& K, const Mask& mask, const Block& rhs, const Block& x) {
  Block difference;
  multiply_twin(K, mask, x, difference);
  add_columns(rhs, Eigen::ArrayXd::Constant(rhs.cols(), -1), difference);
  const Eigen::ArrayXd norm = free_dots(mask, rhs, rhs), residual = free_dots(mask, difference, difference);
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
