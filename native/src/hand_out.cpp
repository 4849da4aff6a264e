// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_out.h"

#include <algorithm>
#include <mutex>

#include "dirichlet/buffer.h"
#include "parallel.h"

namespace dirichlet {
namespace {

void merge(const FieldRange& part, FieldRange& all) {
  all.minimum = std::min(all.minimum, part.minimum);
  all.maximum = std::max(all.maximum, part.maximum);
  all.outside.count += part.outside.count;
  all.outside.farthest = std::max(all.outside.farthest, part.outside.farthest);
  all.outside.share = std::max(all.outside.share, part.outside.share);
}

} // namespace

FieldRange hand_out(const Block& x, std::span<const Index> order, const FixedRows& rows, const PaintedRanges* ranges,
                    Eigen::MatrixXd& values) {
  values.resize(x.rows(), x.cols());
  prefer_large_pages(values.data(), static_cast<std::size_t>(values.size()) * sizeof(double));
  const auto k = static_cast<Index>(x.cols());
  const bool any_undefined = rows.undefined_count() > 0;

  const auto some = [&](Index begin, Index end, Index column, FieldRange& range) {
    for (Index row = begin; row < end; ++row) {
      double value = x(row, column);
      if (ranges != nullptr) value = ranges->hold(row, column, value, range.outside);
      if (any_undefined && rows.is_undefined(row)) {
        value = std::numeric_limits<double>::quiet_NaN();
      } else {
        range.minimum = std::min(range.minimum, value);
        range.maximum = std::max(range.maximum, value);
      }
      values(order[at(row)], column) = value;
    }
  };
  FieldRange all;
  std::mutex mutex;
  constexpr std::size_t kGrain = 1 << 15;
  parallel_chunks(order.size(), std::max<std::size_t>(1, kGrain / at(k)), [&](std::size_t begin, std::size_t end) {
    FieldRange range;
    constexpr Index kRows = 256; // stay in the cache for all their columns
    for (auto first = static_cast<Index>(begin), last = static_cast<Index>(end); first < last; first += kRows)
      for (Index column = 0; column < k; ++column) some(first, std::min(first + kRows, last), column, range);
    const std::scoped_lock lock(mutex);
    merge(range, all);
  });
  return all;
}

} // namespace dirichlet
