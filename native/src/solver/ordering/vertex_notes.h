// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gain_queue.h"

namespace dirichlet::ordering {

/// What the refinement of divisions notes for each vertex. All threads share it, as each has vertices of its own.
struct VertexNotes {
  std::array<QueueLinks, 2> links;
  Scratch<Index> gain;          ///< of a vertex in a queue
  Scratch<std::uint8_t> locked; ///< not to move (again) in this pass; 0 between passes
  Scratch<std::uint8_t> listed; ///< in a vertex set

  void fit(Index size) {
    for (QueueLinks& link : links) link.fit(size);
    gain.fit(size);
    locked.fit_filled(size, 0);
    listed.fit_filled(size, 0);
  }
};

/// Vertices in the order in which they were added, each once, and no vertex in two sets.
class VertexSet {
 public:
  explicit VertexSet(VertexNotes& notes) : listed_(&notes.listed) {}

  void add(Index v) {
    if ((*listed_)[v] != 0) return;
    (*listed_)[v] = 1;
    vertices_.push_back(v);
  }
  void clear() {
    for (const Index v : vertices_) (*listed_)[v] = 0;
    vertices_.clear();
  }
  [[nodiscard]] std::span<const Index> all() const { return vertices_; }

 private:
  std::vector<Index> vertices_;
  Scratch<std::uint8_t>* listed_;
};

} // namespace dirichlet::ordering
