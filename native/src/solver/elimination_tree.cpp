// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elimination_tree.h"

#include "index.h"

namespace dirichlet {
namespace {

/// Row i of the factor reaches exactly the ancestors of its entries j, up to i: every path that ends so far is led to
/// i.
std::vector<Index> find_parents(const OrderedPattern& pattern) {
  const Index n = pattern.size();
  std::vector<Index> parent(at(n), -1), ancestor(at(n), -1);
  for (Index i = 0; i < n; ++i)
    for (Index e = pattern.offsets[at(i)]; e < pattern.upper[at(i)]; ++e)
      for (Index j = pattern.columns[at(e)]; j != -1 && j != i;) {
        const Index up = ancestor[at(j)];
        ancestor[at(j)] = i; // compresses the path
        if (up == -1) parent[at(j)] = i;
        j = up;
      }
  return parent;
}

std::vector<Index> subtree_sizes(const std::vector<Index>& parent) {
  std::vector<Index> size(parent.size(), 1);
  for (std::size_t j = 0; j < parent.size(); ++j)
    if (parent[j] >= 0) size[at(parent[j])] += size[j];
  return size;
}

/// Every node's place in postorder: subtrees fill the room before their root from its end. Siblings keep their order.
std::vector<Index> postorder(const std::vector<Index>& parent) {
  const auto n = static_cast<Index>(parent.size());
  const std::vector<Index> size = subtree_sizes(parent);
  std::vector<Index> rank(at(n)), end(at(n) + 1); // the end of the room that is left before a node; after all roots: n
  end.back() = n;
  for (Index j = n; j-- > 0;) {
    Index& room = end[at(parent[at(j)] < 0 ? n : parent[at(j)])];
    rank[at(j)] = end[at(j)] = room - 1;
    room -= size[at(j)];
  }
  return rank;
}

/// How many rows every column has, by rank. Row i is in all columns on the paths from its entries up to i: a subtree,
/// whose nodes are counted as its leaves minus the lowest common ancestors of successive ones, summed up the tree in
/// the end.
std::vector<Index> count_columns(const OrderedPattern& pattern, const std::vector<Index>& rank,
                                 const std::vector<Index>& parent) {
  const Index n = pattern.size();
  const std::vector<Index> size = subtree_sizes(parent), post = inverse_permutation(rank);
  std::vector<Index> count(at(n)), last_leaf(at(n), -1), ancestor(at(n));
  for (Index j = 0; j < n; ++j) ancestor[at(j)] = j;
  const auto root_of = [&](Index j) {
    while (ancestor[at(j)] != j) j = ancestor[at(j)] = ancestor[at(ancestor[at(j)])];
    return j;
  };
  for (Index j = 0; j < n; ++j) {
    const Index first = j - size[at(j)] + 1, column = post[at(j)]; // of its subtree
    count[at(j)] += first == j ? 1 : 0;
    for (Index e = pattern.upper[at(column)]; e < pattern.offsets[at(column) + 1]; ++e) {
      const Index i = rank[at(pattern.columns[at(e)])];
      if (i == j || last_leaf[at(i)] >= first) continue; // not a leaf of row i's subtree
      ++count[at(j)];
      if (const Index previous = last_leaf[at(i)]; previous != -1) --count[at(root_of(previous))];
      last_leaf[at(i)] = j;
    }
    if (const Index up = parent[at(j)]; up != -1) {
      --count[at(up)];
      ancestor[at(j)] = up;
    }
  }
  for (Index j = 0; j < n; ++j)
    if (parent[at(j)] != -1) count[at(parent[at(j)])] += count[at(j)];
  return count;
}

} // namespace

EliminationTree eliminate(const OrderedPattern& pattern) {
  const std::vector<Index> parent = find_parents(pattern);
  EliminationTree tree;
  tree.rank = postorder(parent);
  tree.parent.resize(parent.size());
  for (std::size_t j = 0; j < parent.size(); ++j)
    tree.parent[at(tree.rank[j])] = parent[j] == -1 ? -1 : tree.rank[at(parent[j])];
  tree.count = count_columns(pattern, tree.rank, tree.parent);
  return tree;
}

} // namespace dirichlet
