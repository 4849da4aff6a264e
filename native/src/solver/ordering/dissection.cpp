// SPDX-License-Identifier: GPL-3.0-or-later
#include "dissection.h"

#include <array>
#include <bit>
#include <future>
#include <numeric>
#include <span>

#include "bisection.h"
#include "leaf.h"
#include "lump.h"
#include "separator.h"

namespace dirichlet::ordering {
namespace {

constexpr Index kNone = -1;
constexpr Index kSmallestTask = 20000; // vertices worth a thread
constexpr Index kTooSmall = 1000;      // a graph that minimum degree orders as well as dissection
constexpr unsigned kDeepest = 64;      // halves of any graph of 32-bit numbers; only lumps go deeper

/// What a thread needs to dissect one graph after the other.
struct Workspace {
  Bisection bisection;
  Separator separator;
  Scratch<Index> numbers;
};

/// A subgraph and where it lives: its arrays begin at `first_vertex` (vertices), 2 * first_vertex (offsets) and
/// `first_edge` (neighbours) of a Store, its vertices will be eliminated from `first_vertex` on.
struct Piece {
  Index first_vertex, size;
  std::size_t first_edge;
};

/// Room for all pieces of one depth. The children of a piece fit in its place, in the store of the next depth: two
/// stores in turn serve the whole recursion, and threads do not meet.
struct Store {
  Store(std::size_t vertex_count, std::size_t entry_count)
      : vertices(std::make_unique_for_overwrite<Index[]>(vertex_count)),
        offsets(std::make_unique_for_overwrite<Index[]>(2 * vertex_count)),
        neighbours(std::make_unique_for_overwrite<Index[]>(entry_count)) {}
  explicit Store(const Graph& graph)
      : Store(static_cast<std::size_t>(graph.size), static_cast<std::size_t>(graph.offsets[graph.size])) {}

  [[nodiscard]] Index* vertices_of(const Piece& piece) const { return vertices.get() + piece.first_vertex; }
  [[nodiscard]] Index* offsets_of(const Piece& piece) const {
    return offsets.get() + 2 * static_cast<std::size_t>(piece.first_vertex);
  }
  [[nodiscard]] Index* neighbours_of(const Piece& piece) const { return neighbours.get() + piece.first_edge; }
  [[nodiscard]] Graph graph(const Piece& piece) const { return {piece.size, offsets_of(piece), neighbours_of(piece)}; }

  std::unique_ptr<Index[]> vertices, offsets, neighbours; // NOLINT(modernize-avoid-c-arrays)
};

class Dissection {
 public:
  Dissection(const Graph& graph, unsigned threads)
      : graph_(graph), threads_(threads), stores_{Store(graph), Store(graph)},
        place_(static_cast<std::size_t>(graph.size)), order_(static_cast<std::size_t>(graph.size)) {}

  std::vector<Index> run() {
    std::iota(stores_[0].vertices.get(), stores_[0].vertices.get() + graph_.size, Index{0});
    const Piece all{0, graph_.size, 0};
    Workspace workspace;
    if (all.size <= kTooSmall)
      order_whole(all, 0, workspace);
    else
      dissect(all, 0, workspace);
    return std::move(order_);
  }

 private:
  void dissect(const Piece& piece, unsigned depth, Workspace& workspace);
  void dissect_both(const Piece& left, const Piece& right, unsigned depth, Workspace& workspace);
  void order_whole(const Piece& piece, unsigned depth, Workspace& workspace);
  [[nodiscard]] Store& store(unsigned depth) { return stores_[depth % 2]; }
  [[nodiscard]] Graph graph(const Piece& piece, unsigned depth) {
    return depth == 0 ? graph_ : store(depth).graph(piece);
  }
  void settle(Index vertex, Index position) {
    place_[static_cast<std::size_t>(vertex)] = position;
    order_[static_cast<std::size_t>(position)] = vertex;
  }

  Graph graph_;
  unsigned threads_;
  Store stores_[2];          // of even and of odd depths
  std::vector<Index> place_; // where a vertex stands in order_, as far as that is known
  std::vector<Index> order_;
};

/// Numbers the vertices of either side and lists them. The separator gets number kNone. \returns the entries that the
/// left side's rows have, before those of the separator are left out.
Index number_sides(const Graph& graph, const Index* vertices, const std::uint8_t* part, std::array<Index*, 2> listed,
                   Index* number) {
  std::array<Index, 2> count{};
  Index left_entries = 0;
  for (Index v = 0; v < graph.size; ++v) {
    number[v] = kNone;
    if (part[v] == kSeparator) continue;
    listed[part[v]][count[part[v]]] = vertices[v];
    number[v] = count[part[v]]++;
    if (part[v] == kLeft) left_entries += graph.offsets[v + 1] - graph.offsets[v];
  }
  return left_entries;
}

/// Copies the two sides of a graph into a store, each as a graph of its own.
void extract(const Graph& graph, const Index* vertices, const std::uint8_t* part, Index* number, const Store& to,
             std::array<Piece, 2>& sides) {
  const Index left_entries =
      number_sides(graph, vertices, part, {to.vertices_of(sides[kLeft]), to.vertices_of(sides[kRight])}, number);
  sides[kRight].first_edge = sides[kLeft].first_edge + static_cast<std::size_t>(left_entries);
  const std::array<Index*, 2> offsets{to.offsets_of(sides[kLeft]), to.offsets_of(sides[kRight])};
  const std::array<Index*, 2> neighbours{to.neighbours_of(sides[kLeft]), to.neighbours_of(sides[kRight])};
  std::array<Index, 2> end{};
  for (Index v = 0; v < graph.size; ++v) {
    const std::uint8_t side = part[v];
    if (side == kSeparator) continue;
    offsets[side][number[v]] = end[side];
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
      if (const Index u = number[graph.neighbours[e]]; u != kNone) neighbours[side][end[side]++] = u;
  }
  for (const Part side : {kLeft, kRight}) offsets[side][sides[side].size] = end[side];
}

void Dissection::dissect(const Piece& piece, unsigned depth, Workspace& workspace) {
  if (piece.size <= kLargestLeaf || depth > kDeepest) return order_whole(piece, depth, workspace);
  const Graph graph = this->graph(piece, depth);
  const Index* vertices = store(depth).vertices_of(piece);
  Division& division = workspace.bisection.halve(graph);
  workspace.separator.separate(graph, division);
  const std::uint8_t* part = division.part.data();
  const Index left_size = workspace.separator.size(kLeft), right_size = workspace.separator.size(kRight);
  if (left_size == 0 || right_size == 0) return order_whole(piece, depth, workspace);

  std::array<Piece, 2> sides{Piece{piece.first_vertex, left_size, piece.first_edge},
                             Piece{piece.first_vertex + left_size, right_size, piece.first_edge}};
  Index position = piece.first_vertex + left_size + right_size;
  for (Index v = 0; v < graph.size; ++v)
    if (part[v] == kSeparator) settle(vertices[v], position++);
  extract(graph, vertices, part, workspace.numbers.fit(graph.size), store(depth + 1), sides);
  dissect_both(sides[kLeft], sides[kRight], depth + 1, workspace);
}

void Dissection::dissect_both(const Piece& left, const Piece& right, unsigned depth, Workspace& workspace) {
  const auto deepest = static_cast<unsigned>(std::bit_width(threads_)); // its type is another before GCC 13
  const bool fork = right.size >= kSmallestTask && threads_ > 1 && depth <= deepest;
  std::future<void> other;
  const auto dissect_right = [&] {
    Workspace own;
    dissect(right, depth, own);
  };
  if (fork) other = std::async(std::launch::async | std::launch::deferred, dissect_right);
  dissect(left, depth, workspace);
  if (fork)
    other.get();
  else
    dissect(right, depth, workspace);
}

void Dissection::order_whole(const Piece& piece, unsigned depth, Workspace& workspace) {
  const Index* vertices = store(depth).vertices_of(piece);
  const Index first = piece.first_vertex;
  if (piece.size > kLargestLeaf) {
    Index* order = workspace.numbers.fit(piece.size);
    order_lump(graph(piece, depth), order);
    for (Index k = 0; k < piece.size; ++k) settle(vertices[order[k]], first + k);
  } else {
    for (Index k = 0; k < piece.size; ++k) settle(vertices[k], first + k);
    order_leaf(graph_, {vertices, static_cast<std::size_t>(piece.size)}, place_.data(), first, order_.data() + first);
  }
}

} // namespace

std::vector<Index> dissect(const Graph& graph, unsigned threads) {
  return Dissection(graph, threads).run();
}

} // namespace dirichlet::ordering
