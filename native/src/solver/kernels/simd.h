// SPDX-License-Identifier: GPL-3.0-or-later
// Every file of this folder is compiled once per instruction set. So that the linker never takes a function made for
// one processor in place of another's, everything is in the anonymous namespace and no template of the standard
// library is called.
#pragma once

#include <cstddef>
#include <cstring>

#if defined(__GNUC__) || defined(__clang__)
#define DIRICHLET_VECTORS 1 // GCC's vector types, written like numbers
#define DIRICHLET_INLINE [[gnu::always_inline]] inline
#define DIRICHLET_UNROLL _Pragma("GCC unroll 8")
#else
#define DIRICHLET_VECTORS 0
#define DIRICHLET_INLINE inline
#define DIRICHLET_UNROLL
#endif

namespace dirichlet {
namespace {

using Size = std::ptrdiff_t;

template <class Real, int kLanes>
struct VectorOf {
#if DIRICHLET_VECTORS
  using Type [[gnu::vector_size(kLanes * sizeof(Real))]] = Real;
#endif
};
template <class Real>
struct VectorOf<Real, 1> {
  using Type = Real;
};

/// Vectors of `Lanes` numbers; of one where the compiler has no vectors or an array is shorter than they are.
template <class R, int Lanes>
struct Simd {
  using Real = R;
  using Vector = typename VectorOf<R, Lanes>::Type;
  static constexpr int kLanes = Lanes;

  DIRICHLET_INLINE static Vector load(const Real* from) {
    Vector v;
    std::memcpy(&v, from, sizeof v);
    return v;
  }

  DIRICHLET_INLINE static void store(Real* to, const Vector& v) { std::memcpy(to, &v, sizeof v); }

  /// `front` in the first `count` lanes, `back` in the others.
  DIRICHLET_INLINE static Vector join(const Vector& front, const Vector& back, Size count) {
    if constexpr (kLanes == 1) {
      return count < 1 ? back : front;
    } else {
      constexpr Real kNumber[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
      return load(kNumber) < static_cast<Real>(count) ? front : back;
    }
  }

  /// Stores all lanes but the first `kept`, whose numbers in memory stay.
  DIRICHLET_INLINE static void store_behind(Real* to, const Vector& v, Size kept) {
    store(to, join(load(to), v, kept));
  }

  /// Loads all lanes but the first `left`, which are 0.
  DIRICHLET_INLINE static Vector load_behind(const Real* from, Size left) { return join(Vector{}, load(from), left); }

  DIRICHLET_INLINE static Real sum(const Vector& v) {
    if constexpr (kLanes == 1) {
      return v;
    } else {
      Real lane[kLanes];
      store(lane, v);
      for (int width = kLanes / 2; width > 0; width /= 2)
        for (int i = 0; i < width; ++i) lane[i] += lane[i + width];
      return lane[0];
    }
  }
};

template <class Real>
using Scalar = Simd<Real, 1>;

/// A number known when compiling, as an argument.
template <int N>
struct Count {};

/// Asks for the cache line that will be written next.
DIRICHLET_INLINE void prefetch([[maybe_unused]] const void* address) {
#if DIRICHLET_VECTORS
  __builtin_prefetch(address, 1);
#endif
}

constexpr Size smaller(Size a, Size b) {
  return a < b ? a : b;
}

} // namespace
} // namespace dirichlet
