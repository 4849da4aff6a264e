// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/kernels/tile.h"

namespace dirichlet {
namespace {

// A block of A that is copied to lie close together: kBlockColumns rows of it, as the columns of C they are for, stay
// in the second cache, and the rows of one tile in the first (Goto, van de Geijn 2008, "Anatomy of high-performance
// matrix multiplication").
constexpr Size kBlockColumns = 96, kBlockDepth = 192;

/// Columns [j, j + N) of rows [begin, end) of C −= A Bᵀ; c is row 0 of column j.
template <class S, int N, class Real>
DIRICHLET_INLINE void update_columns(Real* c, Size ldc, Size begin, Size end, const Real* a, Size lda, const Real* b,
                                     Size ldb, Size depth) {
  for_rows<S, 3>(begin, end, [&]<int R>(Count<R>, Size i, Size kept) {
    Tile<S, R, N> tile(c + i, ldc);
    tile.subtract(a + i, lda, b, ldb, 1, depth);
    tile.store(c + i, ldc, kept);
  });
}

/// DenseKernels::rank_update in place, for what fits the first cache. Needs r >= kLanes.
template <class S, class Real>
void update_direct(Real* c, Size ldc, const Real* a, Size lda, Size r, Size w, Size begin, Size end) {
  for_columns(begin, end,
              [&]<int N>(Count<N>, Size j) { update_columns<S, N>(c + j * ldc, ldc, j, r, a, lda, a + j, lda, w); });
}

/// Copies kRows rows of A into columns that follow each other.
template <int kRows, class Real>
DIRICHLET_INLINE void pack(Real* to, const Real* a, Size lda, Size depth) {
  for (Size p = 0; p < depth; ++p, a += lda, to += kRows) std::memcpy(to, a, kRows * sizeof(Real));
}

/// A few columns of C, whose diagonal begins in row 0 of r; `packed` is their side of the product.
template <class S, class Real>
void update_block(Real* c, Size ldc, const Real* packed, Size columns, const Real* a, Size lda, Size r, Size depth) {
  constexpr int kHeight = 3 * S::kLanes;
  Real rows[kHeight * kBlockDepth];
  Size i = 0;
  for (; i + kHeight <= r; i += kHeight) {
    pack<kHeight>(rows, a + i, lda, depth);
    const Size reach = (i + kHeight + kTileColumns - 1) / kTileColumns * kTileColumns; // tiles are packed whole
    for_columns(0, smaller(columns, reach), [&]<int N>(Count<N>, Size j) {
      Real* const at = c + i + j * ldc;
      for (int n = 0; n < N; ++n) { // what comes after this strip
        prefetch(at + n * ldc + kHeight);
        prefetch(at + n * ldc + 2 * kHeight - 1);
      }
      Tile<S, 3, N> tile(at, ldc);
      tile.subtract(rows, kHeight, packed + j * depth, N, 1, depth);
      tile.store(at, ldc, 0);
    });
  }
  for_columns(0, columns, [&]<int N>(Count<N>, Size j) {
    update_columns<S, N>(c + j * ldc, ldc, i, r, a, lda, packed + j * depth, N, depth);
  });
}

/// DenseKernels::rank_update by blocks. Needs r >= kLanes.
template <class S, class Real>
void update_packed(Real* c, Size ldc, const Real* a, Size lda, Size r, Size w, Size begin, Size end) {
  Real packed[kBlockColumns * kBlockDepth];
  for (Size p = 0; p < w; p += kBlockDepth) {
    const Size depth = smaller(kBlockDepth, w - p);
    for (Size j = begin; j < end; j += kBlockColumns) {
      const Size columns = smaller(kBlockColumns, end - j);
      const Real* const rows = a + j + p * lda;
      for_columns(0, columns, [&]<int N>(Count<N>, Size q) { pack<N>(packed + q * depth, rows + q, lda, depth); });
      update_block<S>(c + j + j * ldc, ldc, packed, columns, rows, lda, r - j, depth);
    }
  }
}

} // namespace
} // namespace dirichlet
