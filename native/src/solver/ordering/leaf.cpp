// SPDX-License-Identifier: GPL-3.0-or-later
#include "leaf.h"

#include <array>
#include <bit>
#include <cstdint>

namespace dirichlet::ordering {
namespace {

using Bits = std::uint64_t;
constexpr std::size_t kWord = 64;

constexpr Bits bit(std::size_t i) {
  return Bits{1} << i;
}

/// Numbers the vertices around a leaf as they are met.
class Halo {
 public:
  /// A set of one; empty when there is no number left.
  Bits find(Index vertex) {
    std::size_t i = 0;
    while (i < count_ && vertices_[i] != vertex) ++i;
    if (i == kWord) return 0;
    if (i == count_) vertices_[count_++] = vertex;
    return bit(i);
  }

 private:
  std::array<Index, kWord> vertices_; // NOLINT(cppcoreguidelines-pro-type-member-init): written before it is read
  std::size_t count_ = 0;
};

struct Row {
  Bits inside, outside;
  int degree;
  void count() { degree = std::popcount(inside) + std::popcount(outside); }
};

std::size_t minimum_degree(const std::array<Row, kWord>& rows, Bits left) {
  std::size_t best = 0;
  for (int least = 2 * static_cast<int>(kWord); left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    if (rows[i].degree < least) {
      least = rows[i].degree;
      best = i;
    }
  }
  return best;
}

} // namespace

void order_leaf(const Graph& graph, std::span<const Index> vertices, const Index* place, Index position, Index* order) {
  std::array<Row, kWord> rows{};
  Halo halo;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (Index e = graph.offsets[vertices[i]]; e < graph.offsets[vertices[i] + 1]; ++e) {
      const Index u = graph.neighbours[e];
      const auto k = static_cast<std::size_t>(static_cast<std::int64_t>(place[u]) - position);
      if (k < vertices.size())
        rows[i].inside |= bit(k);
      else
        rows[i].outside |= halo.find(u);
    }
  for (Row& row : rows) row.count();

  Bits left = vertices.size() == kWord ? ~Bits{0} : bit(vertices.size()) - 1;
  for (std::size_t step = 0; step < vertices.size(); ++step) {
    const std::size_t pivot = minimum_degree(rows, left);
    order[step] = vertices[pivot];
    left &= ~bit(pivot);
    const Bits inside = rows[pivot].inside & left, outside = rows[pivot].outside;
    for (Bits rest = inside; rest != 0; rest &= rest - 1) {
      Row& row = rows[static_cast<std::size_t>(std::countr_zero(rest))];
      row.inside = (row.inside | inside) & left & ~(rest & -rest);
      row.outside |= outside;
      row.count();
    }
  }
}

} // namespace dirichlet::ordering
