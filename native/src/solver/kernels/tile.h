// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/kernels/simd.h"

namespace dirichlet {
namespace {

constexpr int kTileColumns = 4;

/// The lower triangle of N columns with the reciprocals of its diagonal, since multiplying is faster than dividing.
template <class Real, int N>
struct Triangle {
  Real entry[N][N]; ///< [column][row]

  Triangle() = default;
  DIRICHLET_INLINE Triangle(const Real* l, Size ld) {
    DIRICHLET_UNROLL
    for (int j = 0; j < N; ++j) {
      entry[j][j] = 1 / l[j + j * ld];
      DIRICHLET_UNROLL
      for (int i = j + 1; i < N; ++i) entry[j][i] = l[i + j * ld];
    }
  }
};

/// A block of a matrix held in registers: R vectors of rows × N columns. All work on dense blocks is done in tiles.
template <class S, int R, int N>
struct Tile {
  using Real = typename S::Real;
  typename S::Vector value[N][R];

  DIRICHLET_INLINE Tile(const Real* c, Size ld) {
    DIRICHLET_UNROLL
    for (int n = 0; n < N; ++n) {
      DIRICHLET_UNROLL
      for (int r = 0; r < R; ++r) value[n][r] = S::load(c + n * ld + r * S::kLanes);
    }
  }

  /// Stores all rows but the first `kept`.
  DIRICHLET_INLINE void store(Real* c, Size ld, Size kept) const {
    DIRICHLET_UNROLL
    for (int n = 0; n < N; ++n) {
      DIRICHLET_UNROLL
      for (int r = 0; r < R; ++r) {
        Real* const to = c + n * ld + r * S::kLanes;
        if (kept > 0)
          S::store_behind(to, value[n][r], kept - r * S::kLanes);
        else
          S::store(to, value[n][r]);
      }
    }
  }

  /// −= A B with A (rows, depth) and B (depth, N); columns of A are `lda` apart, rows of B `b_row`, columns `b_column`.
  DIRICHLET_INLINE void subtract(const Real* a, Size lda, const Real* b, Size b_row, Size b_column, Size depth) {
    for (Size p = 0; p < depth; ++p, a += lda, b += b_row) {
      typename S::Vector x[R];
      DIRICHLET_UNROLL
      for (int r = 0; r < R; ++r) x[r] = S::load(a + r * S::kLanes);
      DIRICHLET_UNROLL
      for (int n = 0; n < N; ++n) {
        const typename S::Vector factor = S::fill(b[n * b_column]);
        DIRICHLET_UNROLL
        for (int r = 0; r < R; ++r) S::subtract_product(value[n][r], x[r], factor);
      }
    }
  }

  /// X := X L⁻ᵀ
  DIRICHLET_INLINE void divide_by_transpose(const Triangle<Real, N>& L) {
    DIRICHLET_UNROLL
    for (int n = 0; n < N; ++n) {
      DIRICHLET_UNROLL
      for (int r = 0; r < R; ++r) {
        DIRICHLET_UNROLL
        for (int q = 0; q < n; ++q) S::subtract_product(value[n][r], value[q][r], S::fill(L.entry[q][n]));
        value[n][r] *= L.entry[n][n];
      }
    }
  }

  /// X := X L⁻¹
  DIRICHLET_INLINE void divide(const Triangle<Real, N>& L) {
    DIRICHLET_UNROLL
    for (int n = N - 1; n >= 0; --n) {
      DIRICHLET_UNROLL
      for (int r = 0; r < R; ++r) {
        DIRICHLET_UNROLL
        for (int q = n + 1; q < N; ++q) S::subtract_product(value[n][r], value[q][r], S::fill(L.entry[n][q]));
        value[n][r] *= L.entry[n][n];
      }
    }
  }
};

/// Calls f(Count<N>, column) for the blocks of N <= 4 columns that make up [begin, end).
template <class F>
DIRICHLET_INLINE void for_columns(Size begin, Size end, const F& f) {
  Size j = begin;
  for (; j + kTileColumns <= end; j += kTileColumns) f(Count<kTileColumns>{}, j);
  switch (end - j) {
  case 3:
    return f(Count<3>{}, j);
  case 2:
    return f(Count<2>{}, j);
  case 1:
    return f(Count<1>{}, j);
  default:
    return;
  }
}

/// The same blocks, last one first.
template <class F>
DIRICHLET_INLINE void for_columns_backwards(Size begin, Size end, const F& f) {
  const Size whole = (end - begin) / kTileColumns * kTileColumns;
  for_columns(begin + whole, end, f);
  for (Size j = begin + whole - kTileColumns; j >= begin; j -= kTileColumns) f(Count<kTileColumns>{}, j);
}

/// Calls f(Count<R>, row, kept) for tiles of R <= Most vectors that cover rows [begin, end). Rows that do not fill a
/// vector are the end of one that reaches back above them: its first `kept` rows are to stay as they are. Needs
/// end >= kLanes.
template <class S, int Most, class F>
DIRICHLET_INLINE void for_rows(Size begin, Size end, const F& f) {
  static_assert(Most == 2 || Most == 3);
  Size i = begin;
  for (; i + Most * S::kLanes <= end; i += Most * S::kLanes) f(Count<Most>{}, i, Size{0});
  if (Most == 3 && i + 2 * S::kLanes <= end) {
    f(Count<2>{}, i, Size{0});
    i += 2 * S::kLanes;
  }
  if (i + S::kLanes <= end) {
    f(Count<1>{}, i, Size{0});
    i += S::kLanes;
  }
  if (i < end) f(Count<1>{}, end - S::kLanes, S::kLanes - (end - i));
}

} // namespace
} // namespace dirichlet
