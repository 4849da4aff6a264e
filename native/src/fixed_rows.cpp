// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed_rows.h"

#include <utility>

namespace dirichlet {

FixedRows::FixedRows(const SparseView& K)
    : pieces_(free_regions(K, Mask(at(static_cast<Index>(K.rows())), 0))), size_(at(pieces_.count), 0),
      ruled_(at(pieces_.count), 0), fixed_(pieces_.label.size(), 1),
      undefined_count_(static_cast<Index>(fixed_.size())) {
  for (const Index piece : pieces_.label) ++size_[at(piece)];
}

bool FixedRows::paint(std::span<const Index> painted) {
  Mask fixed(fixed_.size(), 0), ruled(ruled_.size(), 0);
  Index count = 0;
  for (const Index row : painted) {
    count += std::exchange(fixed[at(row)], 1) == 0 ? 1 : 0;
    ruled[at(pieces_.label[at(row)])] = 1;
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
