// SPDX-License-Identifier: GPL-3.0-or-later
#include "denied_memory.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> left{INT64_MAX}; ///< requests until one is denied
std::atomic<std::int64_t> most_denied{0};
std::atomic<std::int64_t> bytes{0};

void* request(std::size_t size) {
  bytes += static_cast<std::int64_t>(size);
  const std::int64_t before = left--;
  if (before > 0 || before + most_denied <= 0)
    if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

} // namespace

namespace dirichlet {

DeniedMemory::DeniedMemory(std::int64_t granted, std::int64_t denied) {
  most_denied = denied;
  left = granted;
}

DeniedMemory::~DeniedMemory() {
  left = INT64_MAX;
}

bool DeniedMemory::happened() {
  return left < 0;
}

std::int64_t bytes_asked_for() {
  return bytes;
}

} // namespace dirichlet

// The whole test program gets its memory here.
void* operator new(std::size_t size) {
  return request(size);
}
void* operator new[](std::size_t size) {
  return request(size);
}
// The C++ library asks so for buffers it can do without; left to others, it would come from elsewhere than it goes to.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size == 0 ? 1 : size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}
