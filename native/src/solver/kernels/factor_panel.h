// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

#include "solver/kernels/tile.h"

namespace dirichlet {
namespace {

// Rows of a tall panel that are finished together, so that they stay in the nearest cache.
constexpr Size kPanelRows = 120;

DIRICHLET_INLINE double square_root(double x) {
  return std::sqrt(x); // plain C; the overload for float is a function of the library's headers, see simd.h
}
DIRICHLET_INLINE float square_root(float x) {
  return static_cast<float>(std::sqrt(static_cast<double>(x)));
}

/// Cholesky of an N × N block in place. It goes the root-free way (LDLᵀ), which leaves one division per column in the
/// chain of dependent operations; roots are taken beside it.
/// \param pivots  to be taken for those that come out, or null
/// \returns how many pivots were positive normal numbers before one was not.
template <int N, class Real>
DIRICHLET_INLINE int factor_block(Real* a, Size ld, const Real* pivots, Triangle<Real, N>& L) {
  constexpr Real kSmallest = std::numeric_limits<Real>::min(), kLargest = std::numeric_limits<Real>::max();
  Real s[N][N];
  DIRICHLET_UNROLL
  for (int j = 0; j < N; ++j) {
    DIRICHLET_UNROLL
    for (int i = j; i < N; ++i) s[j][i] = a[i + j * ld];
  }
  DIRICHLET_UNROLL
  for (int j = 0; j < N; ++j) {
    const Real pivot = pivots == nullptr ? s[j][j] : pivots[j];
    if (!(pivot >= kSmallest && pivot <= kLargest)) return j;
    const Real root = square_root(pivot), reciprocal = 1 / pivot;
    DIRICHLET_UNROLL
    for (int i = j + 1; i < N; ++i) {
      const Real factor = s[j][i] * reciprocal;
      DIRICHLET_UNROLL
      for (int k = i; k < N; ++k) Scalar<Real>::subtract_product(s[i][k], s[j][k], factor);
    }
    a[j + j * ld] = root;
    L.entry[j][j] = root * reciprocal;
    DIRICHLET_UNROLL
    for (int i = j + 1; i < N; ++i) a[i + j * ld] = L.entry[j][i] = s[j][i] * L.entry[j][j];
  }
  return N;
}

/// Columns [j, j + N) of rows [begin, end) of X := X L⁻ᵀ; the columns before are done.
template <class S, int N, class Real>
DIRICHLET_INLINE void solve_columns(Real* x, Size ldx, Size begin, Size end, const Real* l, Size ld, Size j,
                                    const Triangle<Real, N>& diagonal) {
  for_rows<S, 3>(begin, end, [&]<int R>(Count<R>, Size i, Size kept) {
    Tile<S, R, N> tile(x + i + j * ldx, ldx);
    tile.subtract(x + i, ldx, l + j, ld, 1, j);
    tile.divide_by_transpose(diagonal);
    tile.store(x + i + j * ldx, ldx, kept);
  });
}

/// Rows [begin, end) of X := X L⁻ᵀ with L (w, w). Needs end >= kLanes.
template <class S, class Real>
DIRICHLET_INLINE void solve_rows(Real* x, Size ldx, Size begin, Size end, const Real* l, Size w, Size ld) {
  for_columns(0, w, [&]<int N>(Count<N>, Size j) {
    solve_columns<S, N>(x, ldx, begin, end, l, ld, j, Triangle<Real, N>(l + j + j * ld, ld));
  });
}

/// Columns [j, j + N) of the first m rows of a panel whose columns before are done. Needs m >= kLanes.
/// \returns how many pivots were good.
template <class S, int N, class Real>
DIRICHLET_INLINE int factor_columns(Real* a, Size m, Size j, Size ld, const Real* pivots) {
  if (j > 0) { // so there are kTileColumns rows above the end of the diagonal block, whichever N
    using D = Simd<Real, smaller(S::kLanes, kTileColumns)>;
    const Size i = j + N - kTileColumns;
    Tile<D, kTileColumns / D::kLanes, N> tile(a + i + j * ld, ld);
    tile.subtract(a + i, ld, a + j, ld, 1, j);
    tile.store(a + i + j * ld, ld, kTileColumns - N);
  }
  Triangle<Real, N> diagonal;
  const int good = factor_block<N>(a + j + j * ld, ld, pivots == nullptr ? nullptr : pivots + j, diagonal);
  if (good == N) solve_columns<S, N>(a, ld, j + N, m, a, ld, j, diagonal);
  return good;
}

/// See DenseKernels::factor_panel. Needs m >= kLanes.
template <class S, class Real>
Size factor_narrow_panel(Real* a, Size m, Size w, Size ld, const Real* pivots) {
  const Size top = smaller(m, w < kPanelRows ? kPanelRows : w);
  Size good = 0;
  for_columns(0, w, [&]<int N>(Count<N>, Size j) {
    if (good == j) good += factor_columns<S, N>(a, top, j, ld, pivots);
  });
  if (good == w)
    for (Size i = top; i < m; i += kPanelRows) solve_rows<S>(a, ld, i, smaller(i + kPanelRows, m), a, w, ld);
  return good;
}

} // namespace
} // namespace dirichlet
