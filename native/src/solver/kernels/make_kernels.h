// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/dense_kernels.h"
#include "solver/kernels/rank_update.h"
#include "solver/kernels/substitution.h"

namespace dirichlet {
namespace {

/// The kernels for vectors of `kBytes` bytes, with the arithmetic of the file this is compiled in.
template <class Real, int kBytes>
struct Kernels {
  template <int kWidth>
  using Vectors = Simd<Real, DIRICHLET_VECTORS ? kWidth / int{sizeof(Real)} : 1>;
  using Wide = Vectors<kBytes>;
  using Narrow = Vectors<(kBytes > 16 ? kBytes / 2 : 16)>;

  // Copying A costs a pass over it, which pays where it is larger than the first cache and used often.
  static constexpr Index kPackedSize = 4096, kPackedDepth = 24;

  /// Calls f with the widest vectors of which `length` numbers fill `times`, or with numbers one by one.
  template <class F>
  static auto with_vectors(Index length, Index times, const F& f) {
    if (length >= times * Wide::kLanes) return f(Wide{});
    if (length >= Narrow::kLanes) return f(Narrow{});
    return f(Scalar<Real>{});
  }

  static Index factor_panel(Real* a, Index m, Index w, Index ld, const Real* pivots) {
    return with_vectors(m, 2,
                        [&]<class S>(S) { return static_cast<Index>(factor_narrow_panel<S>(a, m, w, ld, pivots)); });
  }

  static void rank_update(Real* c, Index ldc, const Real* a, Index lda, Index r, Index w, Index begin, Index end) {
    if (w >= kPackedDepth && Size{r} * w >= kPackedSize && r >= Wide::kLanes)
      return update_packed<Wide>(c, ldc, a, lda, r, w, begin, end);
    with_vectors(r, 2, [&]<class S>(S) { update_direct<S>(c, ldc, a, lda, r, w, begin, end); });
  }

  static void forward(const Real* l, Index m, Index w, Index ld, Real* x1, Real* x2, Index k) {
    if (k == 1) return forward_vector<Wide>(l, m, w, ld, x1, x2);
    with_vectors(k, 1, [&]<class S>(S) { forward_block<S>(l, m, w, ld, x1, x2, k); });
  }

  static void backward(const Real* l, Index m, Index w, Index ld, Real* x1, const Real* x2, Index k) {
    if (k == 1) return backward_vector<Wide>(l, m, w, ld, x1, x2);
    with_vectors(k, 1, [&]<class S>(S) { backward_block<S>(l, m, w, ld, x1, x2, k); });
  }

  static constexpr DenseKernels<Real> kTable = {factor_panel, rank_update, forward, backward};
};

} // namespace
} // namespace dirichlet
