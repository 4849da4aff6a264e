// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed_rows.h"

#include <utility>

namespace dirichlet {

FixedRows::FixedRows(const Components& pieces, std::span<const Index> order)
    : piece_(order.size()), size_(at(pieces.count), 0), ruled_(at(pieces.count), 0), fixed_(order.size(), 1),
      undefined_count_(static_cast<Index>(order.size())) {
  for (std::size_t row = 0; row < order.size(); ++row) {
    piece_[row] = pieces.label[at(order[row])];
    ++size_[at(piece_[row])];
  }
}

bool FixedRows::paint(std::span<const Index> painted) {
  Mask fixed(fixed_.size(), 0), ruled(ruled_.size(), 0);
  Index count = 0;
  for (const Index row : painted) {
    count += std::exchange(fixed[at(row)], 1) == 0 ? 1 : 0;
    ruled[at(piece_[at(row)])] = 1;
  }
  ruled_.swap(ruled);
  painted_count_ = count;

  undefined_count_ = 0;
  for (std::size_t piece = 0; piece < ruled_.size(); ++piece) undefined_count_ += ruled_[piece] == 0 ? size_[piece] : 0;
  if (undefined_count_ > 0)
    for (Index row = 0; row < static_cast<Index>(fixed.size()); ++row)
      if (is_undefined(row)) fixed[at(row)] = 1;
  fixed_.swap(fixed);
  return fixed_ != fixed;
}

} // namespace dirichlet
