// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/symbolic.h"

#include <algorithm>
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

/// Whether storing `zeros` superfluous numbers is worth a larger dense block: very few of them cost less than one more
/// block would.
bool worth_merging(std::int64_t width, std::int64_t rows, std::int64_t zeros) {
  const std::int64_t stored = width * (width + 1) / 2 + width * rows;
  return zeros <= 100 || zeros < stored / 20;
}

/// Columns of equal structure joined, then a supernode with the last of its children where that is worth it.
std::vector<Supernode> find_supernodes(const EliminationTree& tree) {
  const auto n = static_cast<Index>(tree.parent.size());
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
  std::vector<Index> owner(tree.parent.size()), parent;
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

/// Numbers supernodes and columns anew: one half, the other half, what they share; in each as before.
/// \returns for every new position the old one, in postorder.
std::vector<Index> place(const std::vector<Supernode>& supernodes, const std::vector<Index>& old_parent,
                         SymbolicFactor& factor) {
  const std::vector<Index> group = split_forest(supernodes, old_parent);
  std::vector<Index> old, rank(supernodes.size());
  factor.columns.push_back(0);
  factor.row_offsets.push_back(0);
  factor.panel_offsets.push_back(0);
  for (const Index which : {0, 1, 2}) {
    factor.group[at(which)] = factor.supernode_count();
    for (std::size_t s = 0; s < supernodes.size(); ++s) {
      if (group[s] != which) continue;
      const auto& [first, width, rows, zeros] = supernodes[s];
      rank[s] = factor.supernode_count();
      factor.parent.push_back(old_parent[s]);
      for (Index j = first; j < first + width; ++j) old.push_back(j);
      factor.owner.insert(factor.owner.end(), at(width), rank[s]);
      factor.columns.push_back(static_cast<Index>(old.size()));
      factor.row_offsets.push_back(factor.row_offsets.back() + rows);
      factor.panel_offsets.push_back(factor.panel_offsets.back() + panel_size(width, rows));
    }
  }
  for (Index& up : factor.parent)
    if (up >= 0) up = rank[at(up)];
  return old;
}

/// The rows below every supernode's columns: row i is in all supernodes on the paths from its entries up to its own.
/// \param column  the number that every position has in the pattern.
void list_rows(const OrderedPattern& pattern, std::span<const Index> column, SymbolicFactor& factor) {
  std::vector<Index> owner(column.size()); // by number in the pattern
  for (std::size_t i = 0; i < column.size(); ++i) owner[at(column[i])] = factor.owner[i];
  factor.rows.resize(static_cast<std::size_t>(factor.row_offsets.back()));
  std::vector<std::int64_t> next(factor.row_offsets.begin(), factor.row_offsets.end() - 1);
  std::vector<Index> mark(factor.parent.size(), -1);
  for (Index i = 0; i < pattern.size(); ++i) { // ascending, so are the rows
    mark[at(factor.owner[at(i)])] = i;
    for (Index e = pattern.offsets[at(column[at(i)])]; e < pattern.upper[at(column[at(i)])]; ++e)
      for (Index s = owner[at(pattern.columns[at(e)])]; mark[at(s)] != i; s = factor.parent[at(s)]) {
        mark[at(s)] = i;
        factor.rows[static_cast<std::size_t>(next[at(s)]++)] = i;
      }
  }
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
  const OrderedPattern pattern = order_pattern(graph, elimination_order, inverse_permutation(elimination_order));
  const EliminationTree tree = eliminate(pattern);
  const std::vector<Supernode> supernodes = find_supernodes(tree);
  SymbolicFactor factor;
  std::vector<Index> column = place(supernodes, supernode_parents(tree, supernodes), factor);
  const std::vector<Index> post = inverse_permutation(tree.rank);
  for (Index& j : column) j = post[at(j)];
  list_rows(pattern, column, factor);
  for (const Index j : column) factor.order.push_back(elimination_order[at(j)]);
  factor.position = inverse_permutation(factor.order);
  return factor;
}

} // namespace dirichlet
