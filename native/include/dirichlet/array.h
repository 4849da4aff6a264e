// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace dirichlet {

/// Vertices, faces, corners and edges are counted in 32 bits, like in NumPy's int32, Eigen and Blender.
using Index = std::int32_t;

/// A read-only array together with what keeps it alive, so that a caller's buffer (a NumPy array, say) is used in
/// place. Copying it copies two pointers. Cost: O(1).
template <class T>
class SharedArray {
 public:
  SharedArray() = default;

  /// Takes over a vector.
  SharedArray(std::vector<T>&& values) { // NOLINT(google-explicit-constructor): a vector is one
    auto owner = std::make_shared<const std::vector<T>>(std::move(values));
    view_ = *owner;
    owner_ = std::move(owner);
  }

  /// Refers to `view`, which lives for as long as `owner` does.
  SharedArray(std::span<const T> view, std::shared_ptr<const void> owner) : view_(view), owner_(std::move(owner)) {}

  [[nodiscard]] std::span<const T> view() const { return view_; }
  [[nodiscard]] std::size_t size() const { return view_.size(); }

 private:
  std::span<const T> view_;
  std::shared_ptr<const void> owner_;
};

} // namespace dirichlet
