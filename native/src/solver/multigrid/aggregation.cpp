// SPDX-License-Identifier: GPL-3.0-or-later
#include "aggregation.h"

#include <algorithm>

#include "for_row.h"
#include "rows.h"

namespace dirichlet::multigrid {
namespace {

/// Calls visit(neighbour) for what is strong to both sides: a stiff part and a soft one do not mix.
template <class Visit>
void for_strong(const SparseMatrix& A, std::span<const double> strongest, Index i, Visit visit) {
  for_row(A, i, [&](Index j, double a) {
    const double scale = strongest[at(i)] * strongest[at(j)]; // 0 where one has no say
    if (j != i && scale > 0 && a < 0 && a * a >= kWeakShare * kWeakShare * scale) visit(j);
  });
}

} // namespace

std::vector<double> strongest_attractions(const SparseMatrix& A, const Mask& mask) {
  const auto free = [&](Index i) { return mask.empty() || mask[at(i)] == 0; };
  std::vector<double> strongest(at(A.rows()), 0.0);
  for_rows(A.rows(), [&](Index i) {
    if (!free(i)) return;
    double largest = 0;
    for_row(A, i, [&](Index j, double a) {
      if (j != i && free(j)) largest = std::max(largest, -a);
    });
    strongest[at(i)] = largest;
  });
  return strongest;
}

Aggregates aggregate(const SparseMatrix& A, std::span<const double> strongest) {
  const auto n = static_cast<Index>(A.rows());
  Aggregates result;
  std::vector<Index>& label = result.label;
  label.assign(at(n), Aggregates::kNone);
  for (Index i = 0; i < n; ++i) {
    bool whole = label[at(i)] == Aggregates::kNone, lonely = true;
    for_strong(A, strongest, i, [&](Index j) {
      whole = whole && label[at(j)] == Aggregates::kNone;
      lonely = false;
    });
    if (!whole || lonely) continue;
    label[at(i)] = result.count;
    for_strong(A, strongest, i, [&](Index j) { label[at(j)] = result.count; });
    ++result.count;
  }
  const auto late = [](Index aggregate) { return -2 - aggregate; }; // its own inverse; nobody may join a late comer
  for (Index i = 0; i < n; ++i) {
    if (strongest[at(i)] == 0 || label[at(i)] != Aggregates::kNone) continue;
    double best = 0;
    for_row(A, i, [&](Index j, double a) {
      if (label[at(j)] < 0 || -a <= best) return;
      best = -a;
      label[at(i)] = late(label[at(j)]);
    });
  }
  for (Index& aggregate : label)
    if (aggregate < Aggregates::kNone) aggregate = late(aggregate);
  return result;
}

} // namespace dirichlet::multigrid
