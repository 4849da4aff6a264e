// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "dirichlet/array.h"
#include "solver/summed_pivots.h"

namespace dirichlet {

/// Instructions the kernels are compiled for; each set contains those before it.
enum class InstructionSet : std::uint8_t {
  baseline, ///< what every processor of the architecture has: SSE2, NEON
  avx2,     ///< with FMA
  avx512,   ///< F and VL
};

/// The dense blocks of a multifrontal Cholesky factorisation. Matrices are column-major, (i, j) at i + j ld, with no
/// alignment and any ld >= rows; every size may be 0. Nothing is allocated; a call takes up to 200 kB of stack.
///
/// Only the lower triangle of L11 and C has a meaning. The strict upper one is working space: it is read and written,
/// whatever it holds.
template <class Real>
struct DenseKernels {
  /// Cholesky of the leading w columns of an (m, w) panel, m >= w, in place: A11 = L11 L11ᵀ, L21 = A21 L11⁻ᵀ.
  /// Made for w <= kPanelColumns; the function below takes any panel.
  /// \param pivots  (w,) squares of L's diagonal, where they are known better than by subtraction: A's is not read; or
  ///                null
  /// \returns the first column whose pivot is not a positive normal number, with the panel left half done; or w.
  Index (*factor_panel)(Real* a, Index m, Index w, Index ld, const Real* pivots);

  /// Columns [begin, end) of C −= A Aᵀ, with C (r, r) and A (r, w). Writes to no other column; every number of the
  /// lower triangle comes from the same operations whatever the columns are split into.
  void (*rank_update)(Real* c, Index ldc, const Real* a, Index lda, Index r, Index w, Index begin, Index end);

  /// x1 := L11⁻¹ x1, then x2 −= L21 x1, for an (m, w) panel. Row-major x1 (w, k) and x2 (m − w, k) with rows k apart.
  /// One right-hand side is limited by memory; several are fastest by the multiple of 4.
  void (*forward)(const Real* l, Index m, Index w, Index ld, Real* x1, Real* x2, Index k);

  /// x1 := L11⁻ᵀ (x1 − L21ᵀ x2)
  void (*backward)(const Real* l, Index m, Index w, Index ld, Real* x1, const Real* x2, Index k);
};

/// The best set of this processor; at most the one the environment variable DIRICHLET_INSTRUCTION_SET names.
/// \throws InputError  the variable names none.
InstructionSet best_instruction_set();

/// Whether this processor and this build have the set.
bool is_supported(InstructionSet set);

/// \param set  a supported one.
template <class Real>
const DenseKernels<Real>& dense_kernels(InstructionSet set);

/// Where to cut columns [0, end) of a lower triangle (r, r) so that piece `piece` of `pieces` begins there and all have
/// about the same area.
inline Index cut_triangle(Index r, Index end, Index piece, Index pieces) {
  if (piece == pieces) return end;
  const double rows = r, area = end * (2 * rows - end) * piece / pieces; // twice the area before the cut
  const auto column = static_cast<Index>(rows - std::sqrt(rows * rows - area));
  return column / 4 * 4;
}

/// The first `end` columns of rank_update in `pieces` pieces, which `parallel_for(pieces, f)` has to hand to f once
/// each, in any order and at once if it likes. The result depends on neither.
template <class Real, class ParallelFor>
void rank_update(const DenseKernels<Real>& kernels, Real* c, Index ldc, const Real* a, Index lda, Index r, Index w,
                 Index end, Index pieces, const ParallelFor& parallel_for) {
  parallel_for(pieces, [&](Index piece) {
    kernels.rank_update(c, ldc, a, lda, r, w, cut_triangle(r, end, piece, pieces),
                        cut_triangle(r, end, piece + 1, pieces));
  });
}

/// DenseKernels::factor_panel for a panel of any width, by halves (Gustavson 1997, "Recursion leads to automatic
/// variable blocking for dense linear-algebra algorithms"); the updates between them are shared out as above.
/// \param slack  (m,) of every row, to sum pivots as in summed_pivots.h; in [w, m) then what is left of it. Or null.
template <class Real, class ParallelFor>
Index factor_panel(const DenseKernels<Real>& kernels, Real* a, Index m, Index w, Index ld, Real* slack, Index pieces,
                   const ParallelFor& parallel_for) {
  if (w <= kPanelColumns) {
    if (slack == nullptr) return kernels.factor_panel(a, m, w, ld, nullptr);
    std::array<Real, static_cast<std::size_t>(kPanelColumns)> pivots;
    sum_pivots(a, m, w, ld, slack, pivots.data());
    const Index good = kernels.factor_panel(a, m, w, ld, pivots.data());
    if (good == w)
      kernels.forward(a, m, w, ld, slack, slack + w, 1); // which adds, as L is negative beside its diagonal
    return good;
  }
  const Index left = (w / 2 + kPanelColumns - 1) / kPanelColumns * kPanelColumns;
  const Index good = factor_panel(kernels, a, m, left, ld, slack, pieces, parallel_for);
  if (good < left) return good;
  Real* const below = a + left;
  Real* const rest = below + static_cast<std::ptrdiff_t>(left) * ld;
  rank_update(kernels, rest, ld, below, ld, m - left, left, w - left, pieces, parallel_for);
  return left + factor_panel(kernels, rest, m - left, w - left, ld, slack == nullptr ? nullptr : slack + left, pieces,
                             parallel_for);
}

} // namespace dirichlet
