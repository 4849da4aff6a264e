// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elimination_tree.h"

#include <algorithm>

namespace dirichlet {
namespace {

std::vector<Index> inverse(std::span<const Index> permutation) {
  std::vector<Index> result(permutation.size());
  for (std::size_t i = 0; i < permutation.size(); ++i) result[at(permutation[i])] = static_cast<Index>(i);
  return result;
}

/// Calls visit(j) for the positions j < i of the neighbours of the vertex at position i.
template <class Visit>
void for_each_earlier(const Graph& graph, std::span<const Index> order, std::span<const Index> position, Index i,
                      Visit visit) {
  const Index v = order[at(i)];
  for (Index e = graph.offsets[at(v)]; e < graph.offsets[at(v) + 1]; ++e) {
    const Index j = position[at(graph.neighbours[at(e)])];
    if (j < i) visit(j);
  }
}

/// Row i of the factor reaches exactly the ancestors of its entries j, up to i: every path that ends so far is led to
/// i.
std::vector<Index> find_parents(const Graph& graph, std::span<const Index> order, std::span<const Index> position) {
  const Index n = graph.size();
  std::vector<Index> parent(at(n), -1), ancestor(at(n), -1);
  for (Index i = 0; i < n; ++i)
    for_each_earlier(graph, order, position, i, [&](Index j) {
      while (j != -1 && j != i) {
        const Index up = ancestor[at(j)];
        ancestor[at(j)] = i; // compresses the path
        if (up == -1) parent[at(j)] = i;
        j = up;
      }
    });
  return parent;
}

/// Positions in postorder: post[k] is visited k-th. Siblings keep their order.
std::vector<Index> postorder(std::span<const Index> parent) {
  const auto n = static_cast<Index>(parent.size());
  std::vector<Index> first_child(at(n), -1), next_sibling(at(n), -1), post, stack;
  for (Index i = n; i-- > 0;)
    if (const Index p = parent[at(i)]; p >= 0) {
      next_sibling[at(i)] = first_child[at(p)];
      first_child[at(p)] = i;
    }
  post.reserve(at(n));
  for (Index root = 0; root < n; ++root) {
    if (parent[at(root)] != -1) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const Index i = stack.back();
      if (const Index child = first_child[at(i)]; child >= 0) {
        first_child[at(i)] = next_sibling[at(child)];
        stack.push_back(child);
      } else {
        post.push_back(i);
        stack.pop_back();
      }
    }
  }
  return post;
}

/// How many rows every column has. Row i is in all columns on the paths from its entries up to i: a subtree, whose
/// nodes are counted as its leaves minus the lowest common ancestors of successive ones, summed up the tree in the end.
std::vector<Index> count_columns(const Graph& graph, std::span<const Index> order, std::span<const Index> position,
                                 std::span<const Index> parent) {
  const Index n = graph.size();
  std::vector<Index> count(at(n)), first(at(n), -1), last_seen(at(n), -1), last_leaf(at(n), -1), ancestor(at(n));
  for (Index j = 0; j < n; ++j) {
    ancestor[at(j)] = j;
    count[at(j)] = first[at(j)] == -1 ? 1 : 0; // a leaf of the elimination tree
    for (Index k = j; k != -1 && first[at(k)] == -1; k = parent[at(k)]) first[at(k)] = j; // its first descendant
  }
  const auto root_of = [&](Index j) {
    while (ancestor[at(j)] != j) j = ancestor[at(j)] = ancestor[at(ancestor[at(j)])];
    return j;
  };
  for (Index j = 0; j < n; ++j) {
    if (parent[at(j)] != -1) --count[at(parent[at(j)])];
    const Index v = order[at(j)];
    for (Index e = graph.offsets[at(v)]; e < graph.offsets[at(v) + 1]; ++e) {
      const Index i = position[at(graph.neighbours[at(e)])];
      if (i <= j || first[at(j)] <= last_seen[at(i)]) continue; // not a leaf of row i's subtree
      last_seen[at(i)] = first[at(j)];
      ++count[at(j)];
      if (const Index previous = last_leaf[at(i)]; previous != -1) --count[at(root_of(previous))];
      last_leaf[at(i)] = j;
    }
    if (parent[at(j)] != -1) ancestor[at(j)] = parent[at(j)];
  }
  for (Index j = 0; j < n; ++j)
    if (parent[at(j)] != -1) count[at(parent[at(j)])] += count[at(j)];
  return count;
}

} // namespace

EliminationTree eliminate(const Graph& graph, std::span<const Index> elimination_order) {
  EliminationTree tree;
  const std::vector<Index> raw = find_parents(graph, elimination_order, inverse(elimination_order));
  const std::vector<Index> post = postorder(raw), rank = inverse(post);
  tree.order.resize(post.size());
  tree.parent.resize(post.size());
  for (std::size_t k = 0; k < post.size(); ++k) {
    tree.order[k] = elimination_order[at(post[k])];
    const Index up = raw[at(post[k])];
    tree.parent[k] = up == -1 ? -1 : rank[at(up)];
  }
  tree.count = count_columns(graph, tree.order, inverse(tree.order), tree.parent);
  return tree;
}

} // namespace dirichlet
