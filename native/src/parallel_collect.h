// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <iterator>
#include <map>
#include <mutex>
#include <utility>

#include "dirichlet/buffer.h"
#include "parallel.h"

namespace dirichlet {

/// parallel_chunks for an f(begin, end, buffer) that appends what it finds: the buffers of all pieces in one, in order.
template <class T, class F>
Buffer<T> parallel_collect(std::size_t count, std::size_t grain, const F& f) {
  std::map<std::size_t, Buffer<T>> pieces; // by where they begin
  std::mutex mutex;
  parallel_chunks(count, grain, [&](std::size_t begin, std::size_t end) {
    Buffer<T> piece;
    f(begin, end, piece);
    const std::scoped_lock lock(mutex);
    pieces.emplace(begin, std::move(piece));
  });
  std::size_t total = 0;
  for (const auto& [begin, piece] : pieces) total += piece.size();
  Buffer<T> all = std::move(pieces.begin()->second);
  all.reserve(total);
  for (auto piece = std::next(pieces.begin()); piece != pieces.end(); ++piece)
    all.insert(all.end(), piece->second.begin(), piece->second.end());
  return all;
}

} // namespace dirichlet
