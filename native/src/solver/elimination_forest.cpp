// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elimination_forest.h"

#include <algorithm>
#include <utility>

#include "index.h"

namespace dirichlet {
namespace {

/// Eliminates columns one after the other (George & Liu 1980). The rows of a column are its entries and the rows of its
/// children, the supernodes whose first row it is. When these add nothing to those of the largest child, the column
/// joins it: then the child's list without its first row is the column's.
class Elimination {
 public:
  explicit Elimination(const OrderedPattern& pattern)
      : pattern_(pattern), first_child_(pattern.upper.size(), kNone), mark_(pattern.upper.size(), 0) {
    forest_.owner.resize(pattern.upper.size());
    forest_.rows.reserve(pattern.columns.size()); // about as many, for a mesh
    for (Index j = 0; j < pattern.size(); ++j) eliminate(j);
  }

  EliminationForest take() { return std::move(forest_); }

 private:
  static constexpr Index kNone = -1;

  void eliminate(Index j) {
    const Index largest = largest_child(j);
    mark_rows(largest);
    more_.clear();
    for (Index c = first_child_[at(j)]; c != kNone; c = sibling_[at(c)])
      if (c != largest) add(j, forest_.rows_of(c));
    const auto columns = pattern_.columns.data();
    add(j, {columns + pattern_.upper[at(j)], columns + pattern_.offsets[at(j) + 1]});
    const bool joins = largest != kNone && more_.empty();
    const Index own = joins ? largest : begin_supernode(largest);
    if (joins) {
      ++forest_.row_begin[at(own)];
      --forest_.row_count[at(own)];
    }
    marked_ = own; // its rows are those of the child, and more
    ++forest_.width[at(own)];
    forest_.owner[at(j)] = own;
    for (Index c = first_child_[at(j)]; c != kNone; c = sibling_[at(c)]) forest_.parent[at(c)] = own;
    forest_.parent[at(own)] = kNone;
    if (forest_.row_count[at(own)] == 0) return;
    Index& siblings = first_child_[at(forest_.rows_of(own).front())];
    sibling_[at(own)] = siblings;
    siblings = own;
  }

  Index largest_child(Index j) const {
    Index largest = kNone;
    for (Index c = first_child_[at(j)]; c != kNone; c = sibling_[at(c)])
      if (largest == kNone || forest_.row_count[at(c)] > forest_.row_count[at(largest)]) largest = c;
    return largest;
  }

  /// Marks the rows of a supernode, or none; along a chain of columns that join it, they still are.
  void mark_rows(Index s) {
    if (s != kNone && s == marked_) return;
    ++tag_;
    if (s == kNone) return;
    for (const Index i : forest_.rows_of(s)) mark_[at(i)] = tag_;
  }

  /// Those rows below column j that are not marked yet.
  void add(Index j, std::span<const Index> rows) {
    for (const Index i : rows) {
      if (i == j || mark_[at(i)] == tag_) continue;
      mark_[at(i)] = tag_;
      more_.push_back(i);
    }
  }

  /// With the rows of the largest child but the first, and more.
  Index begin_supernode(Index largest) {
    std::sort(more_.begin(), more_.end());
    auto& rows = forest_.rows;
    const std::size_t begin = rows.size();
    if (largest == kNone) {
      rows.insert(rows.end(), more_.begin(), more_.end());
    } else {
      const auto from = static_cast<std::size_t>(forest_.row_begin[at(largest)]) + 1;
      const std::size_t count = at(forest_.row_count[at(largest)]) - 1;
      rows.resize(begin + count + more_.size());
      std::merge(rows.begin() + static_cast<std::ptrdiff_t>(from),
                 rows.begin() + static_cast<std::ptrdiff_t>(from + count), more_.begin(), more_.end(),
                 rows.begin() + static_cast<std::ptrdiff_t>(begin));
    }
    forest_.row_begin.push_back(static_cast<std::int64_t>(begin));
    forest_.row_count.push_back(static_cast<Index>(rows.size() - begin));
    forest_.width.push_back(0);
    forest_.parent.push_back(kNone);
    sibling_.push_back(kNone);
    return forest_.size() - 1;
  }

  const OrderedPattern& pattern_;
  EliminationForest forest_;                 ///< supernodes in the order of their first columns
  std::vector<Index> first_child_, sibling_; ///< of a column; of a supernode
  std::vector<Index> mark_, more_;
  Index tag_ = 0, marked_ = kNone; ///< the supernode whose rows are marked with the tag
};

/// Every node's place in postorder: subtrees fill the room before their root from its end. Siblings keep their order.
/// \param parent  of every node, after it; -1 at a root.
std::vector<Index> postorder(const std::vector<Index>& parent) {
  const auto n = static_cast<Index>(parent.size());
  std::vector<Index> size(at(n), 1); // of the subtree
  for (std::size_t s = 0; s < parent.size(); ++s)
    if (parent[s] >= 0) size[at(parent[s])] += size[s];
  std::vector<Index> place(at(n)), end(at(n) + 1); // the end of the room that is left before a node; before no node: n
  end.back() = n;
  for (Index s = n; s-- > 0;) {
    Index& room = end[at(parent[at(s)] < 0 ? n : parent[at(s)])];
    place[at(s)] = end[at(s)] = room - 1;
    room -= size[at(s)];
  }
  return place;
}

/// Every supernode's place by its last column, which puts parents after their children.
std::vector<Index> rank_by_last_column(const EliminationForest& forest) {
  std::vector<Index> left = forest.width, rank(left.size());
  Index next = 0;
  for (const Index s : forest.owner)
    if (--left[at(s)] == 0) rank[at(s)] = next++;
  return rank;
}

template <class T>
std::vector<T> permuted(const std::vector<T>& values, const std::vector<Index>& rank) {
  std::vector<T> result(values.size());
  for (std::size_t s = 0; s < values.size(); ++s) result[at(rank[s])] = values[s];
  return result;
}

/// Renumbers the supernodes.
void renumber(EliminationForest& forest, const std::vector<Index>& rank) {
  for (Index& s : forest.owner) s = rank[at(s)];
  for (Index& s : forest.parent)
    if (s >= 0) s = rank[at(s)];
  forest.parent = permuted(forest.parent, rank);
  forest.width = permuted(forest.width, rank);
  forest.row_count = permuted(forest.row_count, rank);
  forest.row_begin = permuted(forest.row_begin, rank);
}

} // namespace

EliminationForest eliminate(const OrderedPattern& pattern) {
  EliminationForest forest = Elimination(pattern).take();
  renumber(forest, rank_by_last_column(forest));
  renumber(forest, postorder(forest.parent));
  return forest;
}

} // namespace dirichlet
