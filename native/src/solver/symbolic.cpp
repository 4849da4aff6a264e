// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/symbolic.h"

#include <algorithm>
#include <queue>

#include "parallel.h"
#include "solver/elimination_forest.h"

namespace dirichlet {
namespace {

/// A run of columns that is to be one supernode.
struct Supernode {
  Index first, width; ///< columns in postorder
  Index top;          ///< the last of the exact supernodes it is made of, whose rows are its own
  Index rows;         ///< below the columns
  std::int64_t zeros; ///< stored though they are 0
};

std::int64_t panel_size(std::int64_t width, std::int64_t rows) {
  return width * (width + rows);
}

/// Whether storing `zeros` superfluous numbers is worth a larger dense block: very few of them cost less than one more
/// block would.
bool worth_merging(std::int64_t width, std::int64_t rows, std::int64_t zeros) {
  const std::int64_t stored = width * (width + 1) / 2 + width * rows;
  return zeros <= 100 || zeros < stored / 20;
}

/// Every supernode joined with the last of its children where that is worth it.
std::vector<Supernode> amalgamate(const EliminationForest& forest) {
  std::vector<Supernode> supernodes;
  for (Index s = 0, first = 0; s < forest.size(); first += forest.width[at(s++)]) {
    Supernode now{first, forest.width[at(s)], s, forest.row_count[at(s)], 0};
    while (!supernodes.empty()) {
      const Supernode& child = supernodes.back();
      const Index up = forest.parent[at(child.top)];
      if (up == -1 || up > s) break;
      const std::int64_t added = std::int64_t{child.width} * (now.width + now.rows - child.rows);
      const Supernode merged{child.first, child.width + now.width, s, now.rows, child.zeros + now.zeros + added};
      if (added > 0 && !worth_merging(merged.width, merged.rows, merged.zeros)) break;
      now = merged;
      supernodes.pop_back();
    }
    supernodes.push_back(now);
  }
  return supernodes;
}

std::vector<Index> supernode_parents(const EliminationForest& forest, const std::vector<Supernode>& supernodes) {
  std::vector<Index> owner(forest.parent.size()), parent; // of exact supernodes
  for (Index s = 0, exact = 0; const Supernode& node : supernodes) {
    while (exact <= node.top) owner[at(exact++)] = s;
    ++s;
  }
  for (const Supernode& node : supernodes) {
    const Index up = forest.parent[at(node.top)];
    parent.push_back(up == -1 ? -1 : owner[at(up)]);
  }
  return parent;
}

/// Which half every supernode belongs to: 0 or 1, or 2 where both meet. The heaviest subtrees are opened from the roots
/// down until two piles of the rest balance.
std::vector<Index> split_forest(const std::vector<Supernode>& supernodes, const std::vector<Index>& parent) {
  const auto count = static_cast<Index>(parent.size());
  std::vector<std::int64_t> weight(at(count), 0); // of the subtree
  std::vector<Index> size(at(count), 1);          // supernodes in it, which are one run
  using Entry = std::pair<std::int64_t, Index>;
  std::priority_queue<Entry> open;
  std::int64_t total = 0;
  for (Index s = 0; s < count; ++s) {
    weight[at(s)] += panel_size(supernodes[at(s)].width, supernodes[at(s)].rows);
    if (const Index up = parent[at(s)]; up >= 0) {
      weight[at(up)] += weight[at(s)];
      size[at(up)] += size[at(s)];
    } else {
      open.emplace(weight[at(s)], s);
      total += weight[at(s)];
    }
  }
  constexpr Index kShared = 2;
  std::vector<Index> group(at(count), -1);
  for (int opened = 0; !open.empty() && open.top().first > total / 8 && opened < 64; ++opened) {
    const Index s = open.top().second;
    if (size[at(s)] == 1) break;
    open.pop();
    group[at(s)] = kShared;
    for (Index child = s - 1; child > s - size[at(s)]; child -= size[at(child)]) open.emplace(weight[at(child)], child);
  }
  std::array<std::int64_t, 2> load{};
  for (; !open.empty(); open.pop()) { // heaviest first
    const Index lighter = load[1] < load[0] ? 1 : 0;
    load[at(lighter)] += open.top().first;
    group[at(open.top().second)] = lighter;
  }
  for (Index s = count; s-- > 0;)
    if (group[at(s)] == -1) group[at(s)] = group[at(parent[at(s)])];
  return group;
}

/// Numbers the supernodes anew: one half, the other half, what they share; in each as before.
/// \returns the old number of every new one.
std::vector<Index> place(const std::vector<Supernode>& supernodes, const std::vector<Index>& parent,
                         SymbolicFactor& factor) {
  const std::vector<Index> group = split_forest(supernodes, parent);
  std::vector<Index> old, rank(supernodes.size());
  factor.columns.push_back(0);
  factor.row_offsets.push_back(0);
  factor.panel_offsets.push_back(0);
  for (const Index which : {0, 1, 2}) {
    factor.group[at(which)] = static_cast<Index>(old.size());
    for (std::size_t s = 0; s < supernodes.size(); ++s) {
      if (group[s] != which) continue;
      const std::int64_t width = supernodes[s].width, rows = supernodes[s].rows;
      rank[s] = static_cast<Index>(old.size());
      old.push_back(static_cast<Index>(s));
      factor.columns.push_back(factor.columns.back() + supernodes[s].width);
      factor.row_offsets.push_back(factor.row_offsets.back() + rows);
      factor.panel_offsets.push_back(factor.panel_offsets.back() + panel_size(width, rows));
    }
  }
  for (const Index s : old) factor.parent.push_back(parent[at(s)] < 0 ? -1 : rank[at(parent[at(s)])]);
  return old;
}

/// \returns the position of every column of the pattern: exact supernodes one after the other, as they were placed.
std::vector<Index> place_columns(const EliminationForest& forest, const std::vector<Supernode>& supernodes,
                                 const std::vector<Index>& old, SymbolicFactor& factor) {
  std::vector<Index> next(forest.parent.size()), position(forest.owner.size());
  factor.owner.resize(position.size());
  for (std::size_t s = 0; s < old.size(); ++s) {
    const Index from = old[s] == 0 ? 0 : supernodes[at(old[s] - 1)].top + 1;
    Index column = factor.columns[s];
    std::fill(factor.owner.begin() + column, factor.owner.begin() + factor.columns[s + 1], static_cast<Index>(s));
    for (Index exact = from; exact <= supernodes[at(old[s])].top; ++exact) {
      next[at(exact)] = column;
      column += forest.width[at(exact)];
    }
  }
  for (std::size_t j = 0; j < position.size(); ++j) position[j] = next[at(forest.owner[j])]++;
  return position;
}

/// Ancestors stay in their order whatever the postorder, so the rows of each supernode stay ascending.
void place_rows(const EliminationForest& forest, const std::vector<Supernode>& supernodes,
                const std::vector<Index>& old, const std::vector<Index>& position, SymbolicFactor& factor) {
  factor.rows.resize(static_cast<std::size_t>(factor.row_offsets.back()));
  parallel_chunks(old.size(), 1 << 13, [&](std::size_t begin, std::size_t end) {
    Index* to = factor.rows.data() + factor.row_offsets[begin];
    for (std::size_t s = begin; s < end; ++s)
      for (const Index row : forest.rows_of(supernodes[at(old[s])].top)) *to++ = position[at(row)];
  });
}

} // namespace

SymbolicFactor analyse(const Graph& graph, std::span<const Index> elimination_order) {
  const EliminationForest forest =
      eliminate(order_pattern(graph, elimination_order, inverse_permutation(elimination_order)));
  const std::vector<Supernode> supernodes = amalgamate(forest);
  SymbolicFactor factor;
  const std::vector<Index> old = place(supernodes, supernode_parents(forest, supernodes), factor);
  const std::vector<Index> position = place_columns(forest, supernodes, old, factor);
  place_rows(forest, supernodes, old, position, factor);
  factor.order.resize(position.size());
  for (std::size_t j = 0; j < position.size(); ++j) factor.order[at(position[j])] = elimination_order[j];
  return factor;
}

} // namespace dirichlet
