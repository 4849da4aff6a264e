// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/symbolic.h"

#include <algorithm>
#include <numeric>
#include <queue>

#include "solver/elimination_tree.h"

namespace dirichlet {
namespace {

/// A run of columns that is to be one supernode, as known before its rows are listed.
struct Supernode {
  Index first, width;
  Index rows;         ///< below the columns
  std::int64_t zeros; ///< stored though they are 0
};

std::int64_t panel_size(std::int64_t width, std::int64_t rows) {
  return width * (width + rows);
}

/// Whether storing `zeros` superfluous numbers is worth a larger dense block. Small blocks cost more in overhead than
/// in arithmetic.
bool worth_merging(std::int64_t width, std::int64_t rows, std::int64_t zeros) {
  const auto stored = static_cast<double>(width * (width + 1) / 2 + width * rows);
  const double share = static_cast<double>(zeros) / stored;
  return width <= 4 || (width <= 16 && share < 0.5) || (width <= 48 && share < 0.12) || share < 0.05;
}

/// Columns of equal structure joined, then a supernode with the last of its children where that is worth it.
std::vector<Supernode> find_supernodes(const EliminationTree& tree) {
  const auto n = static_cast<Index>(tree.order.size());
  std::vector<Supernode> supernodes;
  for (Index j = 0; j < n;) {
    Supernode now{j, 1, tree.count[at(j)] - 1, 0};
    while (j + 1 < n && tree.parent[at(j)] == j + 1 && tree.count[at(j)] == tree.count[at(j) + 1] + 1) {
      ++j;
      ++now.width;
      --now.rows;
    }
    ++j;
    while (!supernodes.empty()) {
      const Supernode& child = supernodes.back();
      const Index up = tree.parent[at(now.first - 1)];
      if (up == -1 || up >= now.first + now.width) break;
      const std::int64_t added = std::int64_t{child.width} * (now.width + now.rows - child.rows);
      const Supernode merged{child.first, child.width + now.width, now.rows, child.zeros + now.zeros + added};
      if (added > 0 && !worth_merging(merged.width, merged.rows, merged.zeros)) break;
      now = merged;
      supernodes.pop_back();
    }
    supernodes.push_back(now);
  }
  return supernodes;
}

std::vector<Index> supernode_parents(const EliminationTree& tree, const std::vector<Supernode>& supernodes) {
  std::vector<Index> owner(tree.order.size()), parent;
  for (Index s = 0; const Supernode& node : supernodes) std::fill_n(owner.begin() + node.first, node.width, s++);
  for (const Supernode& node : supernodes) {
    const Index up = tree.parent[at(node.first + node.width - 1)];
    parent.push_back(up == -1 ? -1 : owner[at(up)]);
  }
  return parent;
}

/// Which half every supernode belongs to: 0 or 1, or 2 where both meet. The heaviest subtrees are opened from the roots
/// down until two piles of the rest balance.
std::vector<Index> split_forest(const std::vector<Supernode>& supernodes, const std::vector<Index>& parent) {
  const auto count = static_cast<Index>(parent.size());
  std::vector<std::int64_t> weight(at(count), 0); // of the subtree
  std::vector<std::vector<Index>> children(at(count));
  using Entry = std::pair<std::int64_t, Index>;
  std::priority_queue<Entry> open;
  std::int64_t total = 0;
  for (Index s = 0; s < count; ++s) {
    weight[at(s)] += panel_size(supernodes[at(s)].width, supernodes[at(s)].rows);
    if (const Index up = parent[at(s)]; up >= 0) {
      weight[at(up)] += weight[at(s)];
      children[at(up)].push_back(s);
    } else {
      open.emplace(weight[at(s)], s);
      total += weight[at(s)];
    }
  }
  constexpr Index kShared = 2;
  std::vector<Index> group(at(count), -1);
  for (int opened = 0; !open.empty() && open.top().first > total / 8 && opened < 64; ++opened) {
    const Index s = open.top().second;
    if (children[at(s)].empty()) break;
    open.pop();
    group[at(s)] = kShared;
    for (const Index child : children[at(s)]) open.emplace(weight[at(child)], child);
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

/// Numbers supernodes and columns anew: one half, the other half, what they share; in each as before.
void place(const EliminationTree& tree, const std::vector<Supernode>& supernodes, SymbolicFactor& factor) {
  const std::vector<Index> old_parent = supernode_parents(tree, supernodes);
  const std::vector<Index> group = split_forest(supernodes, old_parent);
  std::vector<Index> rank(supernodes.size());
  factor.columns.push_back(0);
  for (const Index which : {0, 1, 2}) {
    factor.group[at(which)] = factor.supernode_count();
    for (std::size_t s = 0; s < supernodes.size(); ++s) {
      if (group[s] != which) continue;
      rank[s] = factor.supernode_count();
      factor.parent.push_back(old_parent[s]);
      const auto first = tree.order.begin() + supernodes[s].first;
      factor.order.insert(factor.order.end(), first, first + supernodes[s].width);
      factor.owner.insert(factor.owner.end(), at(supernodes[s].width), rank[s]);
      factor.columns.push_back(static_cast<Index>(factor.order.size()));
    }
  }
  for (Index& up : factor.parent)
    if (up >= 0) up = rank[at(up)];
  factor.position.resize(factor.order.size());
  for (std::size_t k = 0; k < factor.order.size(); ++k) factor.position[at(factor.order[k])] = static_cast<Index>(k);
}

/// Calls visit(s, i) for every supernode s and every row i below its columns, ascending in i: row i is in all
/// supernodes on the paths from its entries up to its own.
template <class Visit>
void for_each_row(const Graph& graph, const SymbolicFactor& factor, Visit visit) {
  std::vector<Index> mark(factor.parent.size(), -1);
  for (Index i = 0; i < graph.size(); ++i) {
    const Index v = factor.order[at(i)], own = factor.owner[at(i)];
    mark[at(own)] = i;
    for (Index e = graph.offsets[at(v)]; e < graph.offsets[at(v) + 1]; ++e) {
      const Index j = factor.position[at(graph.neighbours[at(e)])];
      if (j >= i) continue;
      for (Index s = factor.owner[at(j)]; mark[at(s)] != i; s = factor.parent[at(s)]) {
        mark[at(s)] = i;
        visit(s, i);
      }
    }
  }
}

void list_rows(const Graph& graph, const std::vector<Index>& counts, SymbolicFactor& factor) {
  factor.row_offsets.assign(1, 0);
  factor.panel_offsets.assign(1, 0);
  for (Index s = 0; s < factor.supernode_count(); ++s) {
    factor.row_offsets.push_back(factor.row_offsets.back() + counts[at(s)]);
    factor.panel_offsets.push_back(factor.panel_offsets.back() + panel_size(factor.width(s), counts[at(s)]));
  }
  factor.rows.resize(static_cast<std::size_t>(factor.row_offsets.back()));
  std::vector<std::int64_t> next(factor.row_offsets.begin(), factor.row_offsets.end() - 1);
  for_each_row(graph, factor, [&](Index s, Index i) { factor.rows[static_cast<std::size_t>(next[at(s)]++)] = i; });
}

} // namespace

double SymbolicFactor::flops() const {
  double sum = 0;
  for (Index s = 0; s < supernode_count(); ++s)
    for (Index column = 0; column < width(s); ++column) {
      const double below = width(s) - column + row_count(s);
      sum += below * below;
    }
  return sum;
}

SymbolicFactor analyse(const Graph& graph, std::span<const Index> elimination_order) {
  SymbolicFactor factor;
  {
    const EliminationTree tree = eliminate(graph, elimination_order);
    place(tree, find_supernodes(tree), factor);
  }
  std::vector<Index> counts(factor.parent.size(), 0);
  for_each_row(graph, factor, [&](Index s, Index) { ++counts[at(s)]; });
  list_rows(graph, counts, factor);
  return factor;
}

} // namespace dirichlet
