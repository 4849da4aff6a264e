// SPDX-License-Identifier: GPL-3.0-or-later
// A block of k right-hand sides is row-major, which is k rows of a column-major matrix Xᵀ. So forward substitution does
// to Xᵀ what factor_panel does to L21, with the same tiles.
#pragma once

#include "solver/kernels/factor_panel.h"

namespace dirichlet {
namespace {

// Columns of L that forward substitution takes together: fewer go through memory more often, more are too many streams.
constexpr Size kStreams = 32;

/// Y −= L X with L (rows, depth), for k >= kLanes right-hand sides.
template <class S, class Real>
DIRICHLET_INLINE void subtract_product(Real* y, Size rows, const Real* l, Size ld, const Real* x, Size depth, Size k) {
  for_columns(0, rows, [&]<int N>(Count<N>, Size i) {
    for_rows<S, 2>(0, k, [&]<int R>(Count<R>, Size q, Size kept) {
      Tile<S, R, N> tile(y + i * k + q, k);
      tile.subtract(x + q, k, l + i, ld, 1, depth);
      tile.store(y + i * k + q, k, kept);
    });
  });
}

template <class S, class Real>
void forward_block(const Real* l, Size m, Size w, Size ld, Real* x1, Real* x2, Size k) {
  for (Size p = 0; p < w; p += kStreams) {
    const Size depth = smaller(kStreams, w - p), next = p + depth;
    solve_rows<S>(x1 + p * k, k, 0, k, l + p + p * ld, depth, ld);
    subtract_product<S>(x1 + next * k, w - next, l + next + p * ld, ld, x1 + p * k, depth, k);
    subtract_product<S>(x2, m - w, l + w + p * ld, ld, x1 + p * k, depth, k);
  }
}

template <class S, class Real>
void backward_block(const Real* l, Size m, Size w, Size ld, Real* x1, const Real* x2, Size k) {
  for_columns_backwards(0, w, [&]<int N>(Count<N>, Size j) {
    const Size next = j + N;
    const Real* const column = l + j * ld;
    const Triangle<Real, N> diagonal(column + j, ld);
    for_rows<S, 2>(0, k, [&]<int R>(Count<R>, Size q, Size kept) {
      Tile<S, R, N> tile(x1 + j * k + q, k);
      tile.subtract(x1 + next * k + q, k, column + next, 1, ld, w - next);
      tile.subtract(x2 + q, k, column + w, 1, ld, m - w);
      tile.divide(diagonal);
      tile.store(x1 + j * k + q, k, kept);
    });
  });
}

/// y −= L x with L (rows, N): one right-hand side.
template <class S, int N, class Real>
DIRICHLET_INLINE void subtract_columns(Real* y, Size rows, const Real* l, Size ld, const Real* x) {
  if constexpr (S::kLanes > 1)
    if (rows < S::kLanes) return subtract_columns<Scalar<Real>, N>(y, rows, l, ld, x);
  for_rows<S, 3>(0, rows, [&]<int R>(Count<R>, Size i, Size kept) {
    Tile<S, R, 1> tile(y + i, 0);
    tile.subtract(l + i, ld, x, 1, 0, N);
    tile.store(y + i, 0, kept);
  });
}

template <class S, class Real>
void forward_vector(const Real* l, Size m, Size w, Size ld, Real* x1, Real* x2) {
  for_columns(0, w, [&]<int N>(Count<N>, Size j) {
    const Real* const column = l + j * ld;
    Tile<Scalar<Real>, 1, N> tile(x1 + j, 1);
    tile.divide_by_transpose(Triangle<Real, N>(column + j, ld));
    tile.store(x1 + j, 1, 0);
    subtract_columns<S, N>(x1 + j + N, w - j - N, column + j + N, ld, x1 + j);
    subtract_columns<S, N>(x2, m - w, column + w, ld, x1 + j);
  });
}

/// Subtracts from sum[n] column n of L (rows, N) times x, lane by lane; what is too short for a vector goes to `result`
/// itself.
template <class S, int N, class Real>
DIRICHLET_INLINE void subtract_products(typename S::Vector (&sum)[N], Tile<Scalar<Real>, 1, N>& result, Size rows,
                                        const Real* l, Size ld, const Real* x) {
  if (rows < S::kLanes) return result.subtract(x, 1, l, 1, ld, rows);
  const auto subtract = [&](Size i, const typename S::Vector& part) {
    DIRICHLET_UNROLL
    for (int n = 0; n < N; ++n) S::subtract_product(sum[n], S::load(l + i + n * ld), part);
  };
  Size i = 0;
  for (; i + S::kLanes <= rows; i += S::kLanes) subtract(i, S::load(x + i));
  const Size last = rows - S::kLanes;
  if (i < rows) subtract(last, S::load_behind(x + last, i - last));
}

template <class S, class Real>
void backward_vector(const Real* l, Size m, Size w, Size ld, Real* x1, const Real* x2) {
  for_columns_backwards(0, w, [&]<int N>(Count<N>, Size j) {
    const Real* const column = l + j * ld;
    Tile<Scalar<Real>, 1, N> tile(x1 + j, 1);
    typename S::Vector sum[N] = {};
    subtract_products<S>(sum, tile, m - w, column + w, ld, x2);
    subtract_products<S>(sum, tile, w - j - N, column + j + N, ld, x1 + j + N);
    DIRICHLET_UNROLL
    for (int n = 0; n < N; ++n) tile.value[n][0] += S::sum(sum[n]);
    tile.divide(Triangle<Real, N>(column + j, ld));
    tile.store(x1 + j, 1, 0);
  });
}

} // namespace
} // namespace dirichlet
