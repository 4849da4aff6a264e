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

void FixedRows::paint(std::span<const Index> painted) {
  Mask fixed(fixed_.size(), 0), ruled(ruled_.size(), 0);
  painted_count_ = 0;
  for (const Index row : painted) {
    painted_count_ += std::exchange(fixed[at(row)], 1) == 0 ? 1 : 0;
    ruled[at(pieces_.label[at(row)])] = 1;
  }
  ruled_.swap(ruled);
  fixed_.swap(fixed);

  undefined_count_ = 0;
  for (std::size_t piece = 0; piece < ruled_.size(); ++piece) undefined_count_ += ruled_[piece] == 0 ? size_[piece] : 0;
  if (undefined_count_ == 0) return;
  for (Index row = 0; row < static_cast<Index>(fixed_.size()); ++row)
    if (is_undefined(row)) fixed_[at(row)] = 1;
}

} // namespace dirichlet
