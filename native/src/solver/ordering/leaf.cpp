// SPDX-License-Identifier: GPL-3.0-or-later
#include "leaf.h"

#include <array>
#include <bit>
#include <cstdint>

namespace dirichlet::ordering {
namespace {

using Bits = std::uint64_t;
constexpr std::size_t kMost = 448; // vertices of a leaf and around it
constexpr std::size_t kWords = kMost / 64, kInnerWords = kLargestLeaf / 64;
using Row = std::array<Bits, kWords>;
using Set = std::array<Bits, kInnerWords>; // of vertices of the leaf

constexpr Bits bit(std::size_t i) {
  return Bits{1} << (i % 64);
}

/// The number of bits in a row (Warren 2012), its words side by side.
std::size_t count(const Row& row) {
  constexpr Bits kPairs = 0x3333333333333333, kBytes = 0x0f0f0f0f0f0f0f0f, kShorts = 0x00ff00ff00ff00ff;
  Bits bytes = 0;
  for (Bits x : row) {
    x -= x >> 1 & 0x5555555555555555;
    x = (x & kPairs) + (x >> 2 & kPairs);
    bytes += (x + (x >> 4)) & kBytes;
  }
  return ((bytes & kShorts) + (bytes >> 8 & kShorts)) * 0x0001000100010001 >> 48;
}

/// Calls f(i) for every member of a set.
template <class F>
void for_each(const Set& set, const F& f) {
  for (std::size_t w = 0; w < set.size(); ++w)
    for (Bits rest = set[w]; rest != 0; rest &= rest - 1) f(64 * w + static_cast<std::size_t>(std::countr_zero(rest)));
}

/// The elimination graph of a leaf. Vertices that have become indistinguishable, that is, adjacent and with the same
/// other neighbours, are one of them, their head; they do not count in each other's degree (Liu 1985).
class Leaf {
 public:
  Leaf(const Graph& graph, std::span<const Index> vertices, const Index* place, Index position);
  /// Eliminates a head of least degree, of these the last. \returns it and who it stands for.
  Set eliminate_next();

 private:
  std::size_t number_outside(Index vertex);
  void file(std::size_t head);
  std::size_t take_least();
  void connect(std::size_t head, const Row& front, const Set& eliminated);
  void join(std::size_t head, std::size_t other);
  [[nodiscard]] bool are_indistinguishable(std::size_t a, std::size_t b) const;

  std::array<Row, kLargestLeaf> rows_;          // the neighbours of each head: first in the leaf, then outside
  std::array<std::size_t, kLargestLeaf> count_; // how many these are
  std::array<Set, kLargestLeaf> members_{};     // who each head stands for
  std::array<std::size_t, kLargestLeaf> member_count_;
  std::array<std::size_t, kLargestLeaf> degree_; // of each head
  std::array<Set, kMost> by_degree_{};           // the heads of each degree
  Set heads_{};
  std::array<Index, kMost> outside_; // the vertices around the leaf, as they are met
  std::size_t size_, outside_size_ = 0;
  std::size_t least_ = kMost - 1; // no head has a lower degree
};

Leaf::Leaf(const Graph& graph, std::span<const Index> vertices, const Index* place, Index position)
    : size_(vertices.size()) {
  for (std::size_t i = 0; i < size_; ++i) {
    Row& row = rows_[i];
    row = {};
    for (Index e = graph.offsets[vertices[i]]; e < graph.offsets[vertices[i] + 1]; ++e) {
      const Index u = graph.neighbours[e];
      auto k = static_cast<std::size_t>(static_cast<std::int64_t>(place[u]) - position);
      if (k >= size_) k = number_outside(u);
      if (k < kMost) row[k / 64] |= bit(k);
    }
    members_[i][i / 64] = bit(i);
    member_count_[i] = 1;
    count_[i] = count(row);
    heads_[i / 64] |= bit(i);
    file(i);
  }
}

/// \returns kMost or more when there is no number left.
std::size_t Leaf::number_outside(Index vertex) {
  std::size_t i = 0;
  while (i < outside_size_ && outside_[i] != vertex) ++i;
  if (i == outside_size_ && size_ + i < kMost) outside_[outside_size_++] = vertex;
  return size_ + i;
}

void Leaf::file(std::size_t head) {
  degree_[head] = count_[head] + 1 - member_count_[head];
  by_degree_[degree_[head]][head / 64] |= bit(head);
  least_ = std::min(least_, degree_[head]);
}

std::size_t Leaf::take_least() {
  for (;; ++least_) {
    Set& set = by_degree_[least_];
    for (std::size_t w = set.size(); w-- > 0;)
      if (set[w] != 0) {
        const std::size_t last = 63 - static_cast<std::size_t>(std::countl_zero(set[w]));
        set[w] &= ~bit(last);
        return 64 * w + last;
      }
  }
}

Set Leaf::eliminate_next() {
  const std::size_t pivot = take_least();
  const Set eliminated = members_[pivot];
  Row front = rows_[pivot];
  Set heads;
  heads_[pivot / 64] &= ~bit(pivot);
  for (std::size_t w = 0; w < kInnerWords; ++w) {
    front[w] &= ~eliminated[w];
    heads[w] = front[w] & heads_[w];
  }
  std::array<std::size_t, kLargestLeaf> touched; // NOLINT(cppcoreguidelines-pro-type-member-init)
  std::size_t touched_count = 0;
  for_each(heads, [&](std::size_t head) {
    connect(head, front, eliminated);
    for (std::size_t k = 0; k < touched_count; ++k)
      if (count_[touched[k]] == count_[head] && are_indistinguishable(touched[k], head)) return join(touched[k], head);
    touched[touched_count++] = head;
  });
  for (std::size_t k = 0; k < touched_count; ++k) file(touched[k]);
  return eliminated;
}

/// Makes the front of an elimination neighbours of a head, which is one of it.
void Leaf::connect(std::size_t head, const Row& front, const Set& eliminated) {
  Row& row = rows_[head];
  by_degree_[degree_[head]][head / 64] &= ~bit(head);
  for (std::size_t w = 0; w < kWords; ++w) row[w] |= front[w];
  for (std::size_t w = 0; w < kInnerWords; ++w) row[w] &= ~eliminated[w];
  row[head / 64] &= ~bit(head);
  count_[head] = count(row);
}

bool Leaf::are_indistinguishable(std::size_t a, std::size_t b) const {
  Row difference;
  for (std::size_t w = 0; w < kWords; ++w) difference[w] = rows_[a][w] ^ rows_[b][w];
  difference[a / 64] ^= bit(a);
  difference[b / 64] ^= bit(b);
  return difference == Row{};
}

void Leaf::join(std::size_t head, std::size_t other) {
  for (std::size_t w = 0; w < kInnerWords; ++w) members_[head][w] |= members_[other][w];
  member_count_[head] += member_count_[other];
  heads_[other / 64] &= ~bit(other);
}

} // namespace

void order_leaf(const Graph& graph, std::span<const Index> vertices, const Index* place, Index position, Index* order) {
  Leaf leaf(graph, vertices, place, position);
  for (const Index* const end = order + vertices.size(); order < end;)
    for_each(leaf.eliminate_next(), [&](std::size_t i) { *order++ = vertices[i]; });
}

} // namespace dirichlet::ordering
