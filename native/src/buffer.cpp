// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/buffer.h"

#if defined(__linux__)
#include <cstdint>

#include <sys/mman.h>
#endif

namespace dirichlet {

void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  constexpr std::uintptr_t kPage = std::uintptr_t{1} << 21; // of x86 and most others; elsewhere a hint like any other
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t begin = (address + kPage - 1) / kPage * kPage, end = (address + bytes) / kPage * kPage;
  if (begin < end) madvise(static_cast<char*>(memory) + (begin - address), end - begin, MADV_HUGEPAGE);
#endif
}

} // namespace dirichlet
