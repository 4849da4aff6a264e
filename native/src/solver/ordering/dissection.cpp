// SPDX-License-Identifier: GPL-3.0-or-later
#include "dissection.h"

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

constexpr Index kSmallestTask = 20000; // vertices worth a thread
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
    const Piece all{0, graph_.size, 0};
    std::iota(stores_[0].vertices.get(), stores_[0].vertices.get() + graph_.size, Index{0});
    std::copy_n(graph_.offsets, graph_.size + 1, stores_[0].offsets.get());
    std::copy_n(graph_.neighbours, graph_.offsets[graph_.size], stores_[0].neighbours.get());
    Workspace workspace;
    dissect(all, 0, workspace);
    return std::move(order_);
  }

 private:
  void dissect(const Piece& piece, unsigned depth, Workspace& workspace);
  void dissect_both(const Piece& left, const Piece& right, unsigned depth, Workspace& workspace);
  void order_whole(const Piece& piece, const Store& store, Workspace& workspace);
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

void extract(const Graph& graph, const Index* vertices, const std::uint8_t* part, Index* number, const Store& to,
             Piece& left, Piece& right) {
  Index count[2] = {0, 0};
  Index edges = 0;
  Index* child_vertices[2] = {to.vertices_of(left), to.vertices_of(right)};
  for (Index v = 0; v < graph.size; ++v) {
    const std::uint8_t p = part[v];
    if (p == kSeparator) {
      number[v] = -1;
      continue;
    }
    child_vertices[p][count[p]] = vertices[v];
    number[v] = count[p]++;
    if (p == kLeft) edges += graph.offsets[v + 1] - graph.offsets[v];
  }
  right.first_edge = left.first_edge + static_cast<std::size_t>(edges);
  Index* offsets[2] = {to.offsets_of(left), to.offsets_of(right)};
  Index* neighbours[2] = {to.neighbours_of(left), to.neighbours_of(right)};
  Index end[2] = {0, 0};
  for (Index v = 0; v < graph.size; ++v) {
    const std::uint8_t p = part[v];
    if (p == kSeparator) continue;
    offsets[p][number[v]] = end[p];
    Index* out = neighbours[p];
    Index w = end[p];
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      const Index u = number[graph.neighbours[e]];
      if (u >= 0) out[w++] = u;
    }
    end[p] = w;
  }
  offsets[0][left.size] = end[0];
  offsets[1][right.size] = end[1];
}

void Dissection::dissect(const Piece& piece, unsigned depth, Workspace& workspace) {
  const Store& store = stores_[depth % 2];
  if (piece.size <= kLargestLeaf || depth > kDeepest) return order_whole(piece, store, workspace);
  const Graph graph = store.graph(piece);
  const std::uint8_t* part = workspace.separator.separate(graph, workspace.bisection.halve(graph));
  const Index left_size = workspace.separator.size(kLeft), right_size = workspace.separator.size(kRight);
  if (left_size == 0 || right_size == 0) return order_whole(piece, store, workspace);

  Piece left{piece.first_vertex, left_size, piece.first_edge};
  Piece right{piece.first_vertex + left_size, right_size, piece.first_edge};
  Index position = right.first_vertex + right_size;
  for (Index v = 0; v < graph.size; ++v)
    if (part[v] == kSeparator) settle(store.vertices_of(piece)[v], position++);
  extract(graph, store.vertices_of(piece), part, workspace.numbers.fit(graph.size), stores_[(depth + 1) % 2], left,
          right);
  dissect_both(left, right, depth + 1, workspace);
}

void Dissection::dissect_both(const Piece& left, const Piece& right, unsigned depth, Workspace& workspace) {
  const bool fork = right.size >= kSmallestTask && threads_ > 1 && depth <= std::bit_width(threads_);
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

void Dissection::order_whole(const Piece& piece, const Store& store, Workspace& workspace) {
  const Index* vertices = store.vertices_of(piece);
  const Index first = piece.first_vertex;
  if (piece.size > kLargestLeaf) {
    Index* order = workspace.numbers.fit(piece.size);
    order_lump(store.graph(piece), order);
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
