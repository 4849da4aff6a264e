// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/injection.h"

#include "dirichlet/error.h"
#include "for_row.h"
#include "message.h"
#include "union_find.h"

namespace dirichlet {
namespace {

void check_mask(const SparseView& matrix, const Mask& mask) {
  if (matrix.rows() != matrix.cols() || mask.size() != static_cast<std::size_t>(matrix.rows()))
    throw InputError(
        message("a mask of ", mask.size(), " entries does not fit a matrix of ", matrix.rows(), " × ", matrix.cols()));
}

bool painted(const Mask& mask, Index i) {
  return mask[static_cast<std::size_t>(i)] != 0;
}

/// The entries keep(row, column) lets through, in their order, and 1 on the diagonal of painted rows. With rows read as
/// columns the same arrays are a column-major matrix.
template <class Result, class Keep>
Result filter(const SparseMatrix& matrix, const Mask& mask, Keep keep) {
  check_mask(matrix, mask);
  const auto n = static_cast<Index>(matrix.rows());
  Result result(n, n);
  Index* start = result.outerIndexPtr();
  start[0] = 0;
  for (Index i = 0; i < n; ++i) {
    Index count = 0;
    for_row(matrix, i, [&](Index j, double) { count += keep(i, j); });
    start[i + 1] = start[i] + (painted(mask, i) ? 1 : count);
  }
  result.resizeNonZeros(start[n]);
  Index* inner = result.innerIndexPtr();
  double* value = result.valuePtr();
  for (Index i = 0; i < n; ++i) {
    if (painted(mask, i)) {
      *inner++ = i;
      *value++ = 1;
      continue;
    }
    for_row(matrix, i, [&](Index j, double a) {
      if (!keep(i, j)) return;
      *inner++ = j;
      *value++ = a;
    });
  }
  return result;
}

} // namespace

SparseMatrix inject(const SparseMatrix& L, const Mask& mask) {
  return filter<SparseMatrix>(L, mask, [](Index, Index) { return true; });
}

SymmetricMatrix inject_symmetric(const SparseMatrix& K, const Mask& mask) {
  return filter<SymmetricMatrix>(K, mask, [&](Index i, Index j) { return j >= i && !painted(mask, j); });
}

Block inject_right_hand_side(const SparseView& K, const Mask& mask, Block prescribed) {
  check_mask(K, mask);
  for (Index i = 0; i < K.rows(); ++i) {
    if (!painted(mask, i)) continue;
    for_row(K, i, [&](Index j, double k) { // K is symmetric: its column is its row
      if (!painted(mask, j)) prescribed.row(j) -= k * prescribed.row(i);
    });
  }
  return prescribed;
}

FreeRegions free_regions(const SparseView& K, const Mask& mask) {
  check_mask(K, mask);
  const auto n = static_cast<Index>(K.rows());
  UnionFind sets(n);
  for (Index i = 0; i < n; ++i) {
    if (painted(mask, i)) continue;
    for_row(K, i, [&](Index j, double) {
      if (j < i && !painted(mask, j)) sets.unite(i, j);
    });
  }
  FreeRegions regions;
  regions.label.assign(mask.size(), FreeRegions::kPainted);
  regions.count = sets.label([&](Index i) { return !painted(mask, i); }, regions.label);
  for (Index i = 0; i < n; ++i) {
    if (!painted(mask, i)) continue; // the rim is looked for from the painted side, which is the smaller one
    for_row(K, i, [&](Index j, double) {
      if (!painted(mask, j)) regions.rim.push_back({regions.label[static_cast<std::size_t>(j)], i});
    });
  }
  return regions;
}

} // namespace dirichlet
