// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <mutex>
#include <span>

#include "dirichlet/array.h"
#include "parallel.h"

namespace dirichlet {

/// Faces without an area: how many, and the lowest.
struct FlatFaces {
  static constexpr Index kNone = std::numeric_limits<Index>::max();
  Index count = 0;
  Index first = kNone;

  void add(Index face) { merge({1, face}); }
  void merge(const FlatFaces& other) {
    count += other.count;
    first = std::min(first, other.first);
  }
};

/// Calls is_flat(face) for every face, on all cores. \returns the faces of which it is true.
template <class MakeTest>
FlatFaces find_flat_faces(Index face_count, const MakeTest& make_test) {
  FlatFaces all;
  std::mutex mutex;
  parallel_chunks(static_cast<std::size_t>(face_count), std::size_t{1} << 12, [&](std::size_t begin, std::size_t end) {
    FlatFaces flat;
    auto is_flat = make_test();
    for (auto face = static_cast<Index>(begin); face < static_cast<Index>(end); ++face)
      if (is_flat(face)) flat.add(face);
    const std::scoped_lock lock(mutex);
    all.merge(flat);
  });
  return all;
}

} // namespace dirichlet
