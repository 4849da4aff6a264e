// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "division.h"
#include "gain_queue.h"

namespace dirichlet::ordering {

/// Turns a cut through edges into a set of vertices without which no edge joins left and right, and makes that set
/// small by moving its vertices to either side, their neighbours on the other side taking their place (Ashcraft & Liu
/// 1995; Hendrickson & Rothberg 1998). Holds its arrays for the next graph.
class Separator {
 public:
  /// \param division of the whole graph in two sides, with exactly their boundary; gets the separator as third part.
  void separate(const Graph& graph, Division& division);

  [[nodiscard]] Index size(Part part) const { return size_[part]; }

 private:
  struct Change {
    Index vertex;
    Part before;
  };

  void cover_cut(Division& division);
  bool improve(const Graph& graph, std::uint8_t* part);
  void enqueue(const Graph& graph, const std::uint8_t* part, Index v);
  bool choose(Index& v, Part& to);
  void move(const Graph& graph, Index v, Part to, std::uint8_t* part);
  void relabel(const Graph& graph, Index v, Part to, std::uint8_t* part);
  void end_pass(std::size_t kept, std::uint8_t* part);
  [[nodiscard]] double score() const { return division_score(size_[kSeparator], size_[kLeft], size_[kRight]); }

  std::array<Index, 3> size_{};
  Index largest_ = 0;                                            // a side that is not to grow beyond it
  std::array<GainQueue, 2> queue_{GainQueue(31), GainQueue(31)}; // separator vertices, by the side they may move to
  Scratch<std::uint8_t> locked_;                                 // vertices that have left the separator in this pass
  std::vector<Change> changes_;                                  // in this pass
  std::vector<Index> separator_, touched_;                       // touched: were in the separator in this pass
};

} // namespace dirichlet::ordering
