// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/injection.h"
#include "dirichlet/mesh.h"
#include "index.h"

namespace dirichlet {

/// The rows of a system that have no equation of their own: painted ones, and all of a connected piece without paint,
/// where the system would be singular.
class FixedRows {
 public:
  /// Nothing painted. \param pieces  of the surface, by vertex; \param order  (n,) the vertex of every row. Cost: O(n).
  FixedRows(const Components& pieces, std::span<const Index> order);

  /// \param painted  rows, any order, repeated at will. Cost: O(n). Changes nothing when it throws.
  /// \returns  whether other rows are fixed now
  bool paint(std::span<const Index> painted);

  [[nodiscard]] const Mask& fixed() const { return fixed_; } ///< (n,)
  [[nodiscard]] bool is_undefined(Index row) const { return ruled_[at(piece_[at(row)])] == 0; }
  [[nodiscard]] Index painted_count() const { return painted_count_; } ///< distinct
  [[nodiscard]] Index undefined_count() const { return undefined_count_; }
  [[nodiscard]] Index free_count() const {
    return static_cast<Index>(fixed_.size()) - painted_count_ - undefined_count_;
  }

 private:
  std::vector<Index> piece_; ///< (n,) of every row
  std::vector<Index> size_;  ///< rows of every piece
  Mask ruled_;               ///< pieces with paint
  Mask fixed_;
  Index painted_count_ = 0, undefined_count_ = 0;
};

} // namespace dirichlet
