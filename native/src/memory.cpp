// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory.h"

#include <limits>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef _WIN32
#ifndef NOMINMAX // GCC's headers for Windows do so themselves
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#else
#include <unistd.h>
#endif

namespace dirichlet {

std::int64_t physical_memory() {
#ifdef _WIN32
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  if (GlobalMemoryStatusEx(&status) != 0) return static_cast<std::int64_t>(status.ullTotalPhys);
#elif defined(_SC_PHYS_PAGES)
  const std::int64_t pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  if (pages > 0 && page > 0) return pages * page;
#endif
  return std::numeric_limits<std::int64_t>::max();
}

void return_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace dirichlet
