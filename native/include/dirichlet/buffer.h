// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace dirichlet {

/// Asks the system to back fresh memory by large pages where it fills them: one fault instead of five hundred, and
/// addresses that the processor finds again. To be called before the first write; a system without them takes no
/// notice.
void prefer_large_pages(void* memory, std::size_t bytes);

/// Leaves numbers uninitialised, and prefers large pages.
template <class T>
struct BufferAllocator : std::allocator<T> {
  template <class U>
  struct rebind { // NOLINT(readability-identifier-naming): so named by the standard
    using other = BufferAllocator<U>;
  };

  BufferAllocator() = default;
  template <class U>
  BufferAllocator(const BufferAllocator<U>& /*other*/) noexcept {} // NOLINT(google-explicit-constructor): as asked for

  [[nodiscard]] T* allocate(std::size_t count) {
    T* const memory = std::allocator<T>::allocate(count);
    prefer_large_pages(memory, count * sizeof(T));
    return memory;
  }

  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

/// A vector of numbers that are all written after `resize` and before they are read.
template <class T>
using Buffer = std::vector<T, BufferAllocator<T>>;

} // namespace dirichlet
