// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gain_queue.h"

namespace dirichlet::ordering {

enum Part : std::uint8_t { kLeft = 0, kRight = 1, kSeparator = 2 };

/// Turns a cut through edges into a set of vertices without which no edge joins left and right, and makes that set
/// small by moving its vertices to either side, their neighbours on the other side taking their place (Ashcraft & Liu
/// 1995; Hendrickson & Rothberg 1998). Holds its arrays for the next graph.
class Separator {
 public:
  /// \param side (size,) kLeft or kRight of every vertex.
  /// \returns the part of every vertex, until the next call.
  const std::uint8_t* separate(const Graph& graph, const std::uint8_t* side);

  [[nodiscard]] Index size(Part part) const { return size_[part]; }

 private:
  void cover_cut(const Graph& graph);
  void enqueue(const Graph& graph, Index v);
  void dequeue(Index v);
  bool choose(Index& v, Part& to);
  void move(const Graph& graph, Index v, Part to);
  void relabel(const Graph& graph, Index v, Part to);
  bool improve(const Graph& graph);

  struct Change {
    Index vertex;
    Part before;
  };
  Index largest_ = 0; // a side that is not to grow beyond it
  std::array<Index, 3> size_{};
  std::array<GainQueue, 2> queue_{GainQueue(16), GainQueue(16)}; // separator vertices, by the side they may move to
  Scratch<std::uint8_t> part_;
  Scratch<std::uint8_t> locked_;
  std::vector<Change> changes_;
  std::vector<Index> separator_, touched_;
};

} // namespace dirichlet::ordering
