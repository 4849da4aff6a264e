// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dirichlet {

/// Asks for memory that is to be read soon.
inline void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
#endif
}

} // namespace dirichlet
