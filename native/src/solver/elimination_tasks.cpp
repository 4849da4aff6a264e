// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elimination_tasks.h"

#include <algorithm>

namespace dirichlet {
namespace {

/// Numbers on the stack of update matrices while the supernodes of one task are factored one after the other: all are
/// there when a parent's is made, before those of its children go.
std::int64_t stack_peak(const SymbolicFactor& symbolic, const EliminationTasks::Task& task) {
  std::vector<std::int64_t> sizes;
  std::int64_t now = 0, peak = 0;
  std::vector<Index> children(at(task.last - task.first + 1), 0);
  for (Index s = task.first; s < task.last; ++s) {
    now += UpdateLayout::size(symbolic.row_count(s));
    peak = std::max(peak, now);
    for (Index child = children[at(s - task.first)]; child > 0; --child) {
      now -= sizes.back();
      sizes.pop_back();
    }
    sizes.push_back(UpdateLayout::size(symbolic.row_count(s)));
    if (symbolic.row_count(s) > 0) ++children[at(symbolic.parent[at(s)] - task.first)];
  }
  return peak;
}

EliminationTasks cut(const SymbolicFactor& symbolic, Index most_columns) {
  const Index count = symbolic.supernode_count();
  std::vector<Index> columns(at(count), 0), first(at(count)); // of every subtree
  for (Index s = 0; s < count; ++s) first[at(s)] = s;
  for (Index s = 0; s < count; ++s) {
    columns[at(s)] += symbolic.width(s);
    if (const Index up = symbolic.parent[at(s)]; up >= 0) {
      columns[at(up)] += columns[at(s)];
      first[at(up)] = std::min(first[at(up)], first[at(s)]);
    }
  }
  const auto whole = [&](Index s) { return s < symbolic.group[2] && columns[at(s)] <= most_columns; };
  EliminationTasks result;
  result.owner.assign(at(count), -1);
  result.shared = -1;
  for (Index s = 0; s < count; ++s) {
    const Index up = symbolic.parent[at(s)];
    if (whole(s) && up >= 0 && whole(up)) continue; // part of a larger subtree
    const Index begin = whole(s) ? first[at(s)] : s;
    if (s >= symbolic.group[2] && result.shared < 0) result.shared = static_cast<Index>(result.tasks.size());
    std::fill(result.owner.begin() + begin, result.owner.begin() + s + 1, static_cast<Index>(result.tasks.size()));
    result.tasks.push_back({begin, s, -1, result.kept_size});
    result.kept_size += UpdateLayout::size(symbolic.row_count(s));
  }
  if (result.shared < 0) result.shared = static_cast<Index>(result.tasks.size());
  for (auto& task : result.tasks) {
    if (const Index up = symbolic.parent[at(task.last)]; up >= 0) task.parent = result.owner[at(up)];
    result.stack_size = std::max(result.stack_size, stack_peak(symbolic, task));
  }
  return result;
}

} // namespace

EliminationTasks cut_into_tasks(const SymbolicFactor& symbolic, std::int64_t most_kept) {
  constexpr Index kSmallest = 256;  // columns; below, a task costs more than it saves
  constexpr Index kMostTasks = 256; // about: what is kept for more of them takes long to write and saves little
  for (Index most = std::max(kSmallest, symbolic.size() / kMostTasks);;
       most = most > symbolic.size() / 2 ? symbolic.size() : 2 * most) {
    EliminationTasks tasks = cut(symbolic, most);
    if (tasks.kept_size <= most_kept || most >= symbolic.size()) return tasks;
  }
}

} // namespace dirichlet
