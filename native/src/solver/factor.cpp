// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/factor.h"

#include <algorithm>
#include <array>

#include "dirichlet/error.h"
#include "index.h"
#include "message.h"
#include "parallel.h"
#include "team.h"

namespace dirichlet {
namespace {

/// The lower triangle of a child's update matrix added into the panel and the update matrix of its parent.
template <class Real>
void extend_add(const Real* child, std::span<const Index> place, Index w, Index m, Real* panel, Real* update) {
  const auto r = static_cast<Index>(place.size());
  for (Index j = 0; j < r; ++j) {
    const Real* from = child + UpdateLayout::column(r, j);
    const Index column = place[at(j)];
    Real* to = column < w ? panel + std::int64_t{column} * m : update + UpdateLayout::column(m - w, column - w) - w;
    for (Index i = j; i < r; ++i) to[place[at(i)]] += from[i];
  }
}

template <class Real>
EliminationTasks cut(const SymbolicFactor& symbolic, std::int64_t most_kept) {
  return cut_into_tasks(symbolic, most_kept / static_cast<std::int64_t>(sizeof(Real)));
}

/// See Factor::bytes_needed.
template <class Real>
std::int64_t count_bytes(const SymbolicFactor& symbolic, const EliminationTasks& tasks, std::int64_t entries) {
  const std::int64_t n = symbolic.size(), supernodes = symbolic.supernode_count();
  const std::int64_t numbers = symbolic.factor_size() + tasks.kept_size + 2 * tasks.stack_size;
  const std::int64_t of_symbolic = 2 * n + 2 * supernodes + static_cast<std::int64_t>(symbolic.rows.size());
  const std::int64_t of_matrix = 2 * n + entries, of_factor = 2 * n;
  const std::int64_t of_trees = 3 * supernodes; // children, and the tasks that supernodes belong to
  return numbers * std::int64_t{sizeof(Real)} +
         (of_symbolic + of_matrix + of_factor + of_trees) * std::int64_t{sizeof(Index)} +
         2 * supernodes * std::int64_t{sizeof(std::int64_t)} + entries * std::int64_t{sizeof(double)} +
         static_cast<std::int64_t>(tasks.tasks.size() * (sizeof(EliminationTasks::Task) + sizeof(double)));
}

} // namespace

template <class Real>
Factor<Real>::Factor(std::shared_ptr<const SymbolicFactor> symbolic, std::shared_ptr<const OrderedMatrix> matrix,
                     Pivots pivots, std::int64_t most_kept, CancelToken cancel)
    : symbolic_(std::move(symbolic)), matrix_(std::move(matrix)), pivots_(pivots), cancel_(std::move(cancel)),
      tasks_(cut<Real>(*symbolic_, most_kept)), kernels_(dense_kernels<Real>(best_instruction_set())),
      panels_(static_cast<std::size_t>(symbolic_->factor_size())), kept_(static_cast<std::size_t>(tasks_.kept_size)) {
  const SymbolicFactor& f = *symbolic_;
  const Index count = f.supernode_count();
  child_offsets_.assign(at(count) + 1, 0);
  for (Workspace& space : spaces_) {
    space.place.resize(at(f.size()));
    space.stack.resize(static_cast<std::size_t>(tasks_.stack_size));
  }
  work_.assign(tasks_.tasks.size(), 0);
  for (Index s = 0; s < count; ++s) {
    const double m = f.width(s) + f.row_count(s);
    work_[at(tasks_.owner[at(s)])] += f.width(s) * m * m;
    if (const Index up = f.parent[at(s)]; up >= 0) ++child_offsets_[at(up) + 1];
  }
  for (Index s = 0; s < count; ++s) child_offsets_[at(s) + 1] += child_offsets_[at(s)];
  children_.resize(at(child_offsets_.back()));
  std::vector<Index> next(child_offsets_.begin(), child_offsets_.end() - 1);
  for (Index s = 0; s < count; ++s)
    if (const Index up = f.parent[at(s)]; up >= 0) children_[at(next[at(up)]++)] = s;
}

/// What the fixed neighbours of a column are joined to it by.
template <class Real>
Real Factor<Real>::weights_to(Index column, const Mask& fixed) const {
  double sum = 0;
  for (auto e = at(matrix_->offsets[at(column)]); e < at(matrix_->offsets[at(column) + 1]); ++e)
    if (fixed[at(matrix_->columns[e])] != 0) sum -= matrix_->values[e];
  return static_cast<Real>(sum);
}

/// The entries of K, and nothing else; slacks for its diagonal where pivots are summed. Notes the place of every row.
template <class Real>
void Factor<Real>::fill_panel(Index s, const Mask& fixed, Index* place, Real* panel) const {
  const SymbolicFactor& f = *symbolic_;
  const Index w = f.width(s), m = w + f.row_count(s), first = f.columns[at(s)];
  for (Index c = 0; c < w; ++c) place[first + c] = c;
  for (Index p = w; const Index row : f.rows_of(s)) place[row] = p++;
  std::fill_n(panel, std::int64_t{m} * w, Real{0});
  const bool summed = pivots_ == Pivots::summed;
  for (Index c = 0; c < w; ++c) {
    const Index j = first + c;
    Real* const column = panel + std::int64_t{c} * m;
    if (fixed[at(j)] != 0) {
      column[c] = 1;
      continue;
    }
    for (auto e = at(matrix_->upper[at(j)]); e < at(matrix_->offsets[at(j) + 1]); ++e) // of row j: K is symmetric
      if (const Index i = matrix_->columns[e]; fixed[at(i)] == 0)
        column[place[i]] = static_cast<Real>(matrix_->values[e]);
    if (summed) column[c] = weights_to(j, fixed);
  }
}

template <class Real>
void Factor<Real>::eliminate(Index s, const Mask& fixed, Real* update, std::span<const Real* const> child_updates,
                             Workspace& space) {
  cancel_.check();
  const SymbolicFactor& f = *symbolic_;
  const Index w = f.width(s), r = f.row_count(s), m = w + r, first = f.columns[at(s)];
  Real* panel = panels_.data() + f.panel_offsets[at(s)];
  std::fill_n(update, UpdateLayout::size(r), Real{0});

  fill_panel(s, fixed, space.place.data(), panel);
  for (std::size_t k = 0; k < child_updates.size(); ++k) {
    const auto rows = f.rows_of(children_[at(child_offsets_[at(s)]) + k]);
    space.child_place.resize(rows.size());
    std::transform(rows.begin(), rows.end(), space.child_place.begin(),
                   [&](Index row) { return space.place[at(row)]; });
    extend_add(child_updates[k], std::span<const Index>(space.child_place), w, m, panel, update);
  }

  if (const Index good = factor_front(s, panel, update, space.slack, space.team); good < w)
    throw SolverError(message("the matrix is singular", sizeof(Real) < sizeof(double) ? " to single precision" : "",
                              " at vertex ", f.order[at(first + good)], ", as very thin faces there can make it; ",
                              sizeof(Real) < sizeof(double)
                                  ? "a float64 factor, or thicker faces, would do better"
                                  : "thicker faces, or the intrinsic Delaunay or graph Laplacian, mend it"));
}

/// What is assembled, in place: the columns of the factor, and the update matrix for what comes later.
/// \returns the columns that had a good pivot
template <class Real>
Index Factor<Real>::factor_front(Index s, Real* panel, Real* update, std::vector<Real>& slack, Team* space_team) const {
  const SymbolicFactor& f = *symbolic_;
  const Index w = f.width(s), r = f.row_count(s), m = w + r;
  const bool summed = pivots_ == Pivots::summed;
  if (summed) {
    slack.resize(at(m));
    for (Index c = 0; c < w; ++c) slack[at(c)] = panel[std::int64_t{c} * m + c];
    for (Index i = 0; i < r; ++i) slack[at(w + i)] = update[UpdateLayout::column(r, i) + i];
  }
  constexpr double kWorthSharing = 2e6; // floating-point operations
  Team* const team = 1.0 * w * m * m < kWorthSharing ? nullptr : space_team;
  const auto share_out = [team](Index parts, const auto& part) {
    if (team != nullptr) return team->share_out(parts, part);
    for (Index i = 0; i < parts; ++i) part(i);
  };
  const auto pieces = team == nullptr ? 1 : static_cast<Index>(team->size());
  const Index good = factor_panel(kernels_, panel, m, w, m, summed ? slack.data() : nullptr, pieces, share_out);
  if (good < w) return good;
  share_out((r + UpdateLayout::kBlock - 1) / UpdateLayout::kBlock, [&](Index block) {
    const Index j = block * UpdateLayout::kBlock, below = r - j;
    kernels_.rank_update(update + UpdateLayout::block(r, j), below, panel + w + j, m, below, w, 0,
                         std::min(UpdateLayout::kBlock, below));
  });
  if (summed)
    for (Index i = 0; i < r; ++i) update[UpdateLayout::column(r, i) + i] = slack[at(w + i)];
  return w;
}

template <class Real>
void Factor<Real>::run_task(Index number, const Mask& fixed, Workspace& space) {
  const SymbolicFactor& f = *symbolic_;
  const auto& task = tasks_.tasks[at(number)];
  const auto child_count = [&](Index s) { return at(child_offsets_[at(s) + 1] - child_offsets_[at(s)]); };
  Real* const kept = kept_.data() + task.update;
  if (task.first == task.last) { // its children, if any, are tasks
    space.updates.clear();
    for (auto c = child_offsets_[at(task.last)]; c < child_offsets_[at(task.last) + 1]; ++c)
      space.updates.push_back(kept_.data() + tasks_.tasks[at(tasks_.owner[at(children_[at(c)])])].update);
    return eliminate(task.last, fixed, kept, space.updates, space);
  }
  Real* top = space.stack.data();
  space.updates.clear();
  for (Index s = task.first; s <= task.last; ++s) {
    const std::size_t count = child_count(s);
    const std::span<const Real* const> children(space.updates.data() + space.updates.size() - count, count);
    if (s == task.last) return eliminate(s, fixed, kept, children, space);
    eliminate(s, fixed, top, children, space);
    const std::int64_t size = UpdateLayout::size(f.row_count(s));
    Real* const place = count == 0 ? top : const_cast<Real*>(children.front()); // where its children were, in the stack
    std::copy_n(top, size, place);
    space.updates.resize(space.updates.size() - count);
    space.updates.push_back(place);
    top = place + size;
  }
}

template <class Real>
void Factor<Real>::run(const Mask& fixed, const std::vector<std::uint8_t>& dirty) {
  const auto& tasks = tasks_.tasks;
  const Index middle = symbolic_->group[1] < symbolic_->supernode_count() ? tasks_.owner[at(symbolic_->group[1])]
                                                                          : static_cast<Index>(tasks.size());
  const auto any = [&](Index begin, Index end) {
    return std::any_of(dirty.begin() + begin, dirty.begin() + end, [](std::uint8_t d) { return d != 0; });
  };
  double work = 0;
  for (std::size_t t = 0; t < dirty.size(); ++t) work += dirty[t] != 0 ? work_[t] : 0;
  constexpr double kWorthSecond = 4e6, kWorthAll = 1e8; // less is done before they have started
  Team team(work < kWorthSecond ? 1 : work < kWorthAll ? std::min<std::size_t>(2, core_count()) : core_count());
  const auto run_range = [&](Index begin, Index end, Workspace& space) {
    for (Index t = begin; t < end; ++t)
      if (dirty[at(t)] != 0) run_task(t, fixed, space);
  };
  const bool both = any(0, middle) && any(middle, tasks_.shared);
  for (Workspace& space : spaces_) space.team = both ? nullptr : &team;
  if (both)
    team.share_out(2, [&](Index half) {
      run_range(half == 0 ? 0 : middle, half == 0 ? middle : tasks_.shared, spaces_[at(half)]);
    });
  else
    run_range(0, tasks_.shared, spaces_[0]);
  spaces_[0].team = &team;
  run_range(tasks_.shared, static_cast<Index>(tasks.size()), spaces_[0]);
}

template <class Real>
void Factor<Real>::factor(const Mask& fixed) {
  run(fixed, std::vector<std::uint8_t>(tasks_.tasks.size(), 1));
}

template <class Real>
double Factor<Real>::refactor(const Mask& fixed, std::span<const Index> changed) {
  std::vector<std::uint8_t> dirty(tasks_.tasks.size(), 0);
  for (const Index column : changed) dirty[at(tasks_.owner[at(symbolic_->owner[at(column)])])] = 1;
  double total = 0, again = 0;
  for (std::size_t t = 0; t < dirty.size(); ++t) {
    total += work_[t];
    if (dirty[t] == 0) continue;
    again += work_[t];
    if (const Index up = tasks_.tasks[t].parent; up >= 0) dirty[at(up)] = 1;
  }
  run(fixed, dirty);
  return again / total;
}

template <class Real>
void Factor<Real>::forward(Index begin, Index end, Real* x, Real* shared, Index k) const {
  const SymbolicFactor& f = *symbolic_;
  const Index shared_begin = f.columns[at(f.group[2])];
  std::vector<Real> below;
  for (Index s = begin; s < end; ++s) {
    cancel_.check();
    const Index w = f.width(s), m = w + f.row_count(s);
    Real* const own = x + std::int64_t{f.columns[at(s)]} * k;
    if (std::all_of(own, own + std::int64_t{w} * k, [](Real value) { return value == 0; })) continue; // as is most of x
    below.assign(at(m - w) * at(k), Real{0});
    kernels_.forward(panels_.data() + f.panel_offsets[at(s)], m, w, m, own, below.data(), k);
    const Real* from = below.data();
    for (const Index row : f.rows_of(s)) {
      Real* to = row < shared_begin ? x + std::int64_t{row} * k : shared + std::int64_t{row - shared_begin} * k;
      for (Index c = 0; c < k; ++c) to[c] += *from++;
    }
  }
}

template <class Real>
void Factor<Real>::backward(Index begin, Index end, Real* x, Index k) const {
  const SymbolicFactor& f = *symbolic_;
  std::vector<Real> below;
  for (Index s = end; s-- > begin;) {
    cancel_.check();
    const Index w = f.width(s), m = w + f.row_count(s);
    below.resize(at(m - w) * at(k));
    Real* to = below.data();
    for (const Index row : f.rows_of(s)) to = std::copy_n(x + std::int64_t{row} * k, k, to);
    kernels_.backward(panels_.data() + f.panel_offsets[at(s)], m, w, m, x + std::int64_t{f.columns[at(s)]} * k,
                      below.data(), k);
  }
}

template <class Real>
void Factor<Real>::solve(std::span<Real> x, Index k) const {
  const SymbolicFactor& f = *symbolic_;
  const Index shared_begin = f.columns[at(f.group[2])];
  constexpr std::int64_t kWorthSecond = 1 << 19; // numbers; fewer are read before a second thread has started
  Team team(f.factor_size() * k < kWorthSecond ? 1 : std::min<std::size_t>(2, core_count()));
  const std::size_t shared_size = at(f.size() - shared_begin) * at(k);
  std::array<std::vector<Real>, 2> shared; // each half's part; added in this order, whoever is first
  team.share_out(2, [&](Index half) {
    shared[at(half)].assign(shared_size, Real{0});
    forward(f.group[at(half)], f.group[at(half) + 1], x.data(), shared[at(half)].data(), k);
  });
  Real* const top = x.data() + std::int64_t{shared_begin} * k;
  for (std::size_t i = 0; i < shared_size; ++i) top[i] += shared[0][i] + shared[1][i];
  forward(f.group[2], f.supernode_count(), x.data(), top, k);
  backward(f.group[2], f.supernode_count(), x.data(), k);
  team.share_out(2, [&](Index half) { backward(f.group[at(half)], f.group[at(half) + 1], x.data(), k); });
}

template <class Real>
std::int64_t Factor<Real>::bytes() const {
  return count_bytes<Real>(*symbolic_, tasks_, static_cast<std::int64_t>(matrix_->values.size()));
}

template <class Real>
std::int64_t Factor<Real>::bytes_needed(const SymbolicFactor& symbolic, std::int64_t entries, std::int64_t most_kept) {
  return count_bytes<Real>(symbolic, cut<Real>(symbolic, most_kept), entries);
}

template class Factor<float>;
template class Factor<double>;

} // namespace dirichlet
