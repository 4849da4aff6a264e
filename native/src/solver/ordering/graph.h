// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>

#include "dirichlet/array.h"

namespace dirichlet::ordering {

constexpr Index kNone = -1;

/// An array that only ever grows, and whose new elements are not written: thousands of small graphs pass through the
/// same few arrays without an allocation each.
template <class T>
class Scratch {
 public:
  /// At least `size` elements. What was there is lost when that takes a larger block.
  T* fit(Index size) {
    if (size > capacity_) {
      capacity_ = std::max(size, capacity_ + capacity_ / 2);
      data_ = std::make_unique_for_overwrite<T[]>(static_cast<std::size_t>(capacity_)); // NOLINT: not an std::array
    }
    return data_.get();
  }
  /// The same, all new elements `value`; elements that were there before must all be `value` too.
  T* fit_filled(Index size, T value) {
    if (size > capacity_) {
      fit(size);
      std::fill_n(data_.get(), capacity_, value);
    }
    return data_.get();
  }

  T* data() { return data_.get(); }
  [[nodiscard]] const T* data() const { return data_.get(); }
  T& operator[](Index i) { return data_[static_cast<std::size_t>(i)]; }
  const T& operator[](Index i) const { return data_[static_cast<std::size_t>(i)]; }

 private:
  std::unique_ptr<T[]> data_; // NOLINT(modernize-avoid-c-arrays)
  Index capacity_ = 0;
};

/// Rows of neighbours, without the diagonal. Every vertex and every edge weighs 1.
struct Graph {
  Index size = 0;
  const Index* offsets = nullptr; ///< (size + 1,)
  const Index* neighbours = nullptr;

  [[nodiscard]] static Index weight(Index /*vertex*/) { return 1; }
  [[nodiscard]] static Index edge_weight(Index /*entry*/) { return 1; }
};

/// The same with weights.
struct WeightedGraph {
  Index size = 0;
  const Index* offsets = nullptr; ///< (size + 1,)
  const Index* neighbours = nullptr;
  const Index* weights = nullptr;      ///< (size,)
  const Index* edge_weights = nullptr; ///< one for each neighbour

  [[nodiscard]] Index weight(Index vertex) const { return weights[vertex]; }
  [[nodiscard]] Index edge_weight(Index entry) const { return edge_weights[entry]; }
};

/// A graph whose vertices stand for connected sets of vertices of a finer one, its edges for the edges between them.
struct CoarseGraph {
  Index size = 0;
  Scratch<Index> offsets, neighbours, weights, edge_weights;
  Scratch<Index> aggregate; ///< (finer size,) the vertex of this graph a finer one belongs to

  [[nodiscard]] WeightedGraph graph() const {
    return {size, offsets.data(), neighbours.data(), weights.data(), edge_weights.data()};
  }
};

} // namespace dirichlet::ordering
