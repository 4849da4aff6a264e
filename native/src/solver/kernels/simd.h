// SPDX-License-Identifier: GPL-3.0-or-later
// Every file of this folder is compiled once per instruction set. So that the linker never takes a function made for
// one processor in place of another's, everything is in the anonymous namespace and no template of the standard
// library is called.
#pragma once

#include <cstddef>
#include <cstring>

#if defined(__FMA__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

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

#if defined(__FMA__) || defined(__aarch64__)
DIRICHLET_INLINE float fused(float v, float x, float y) {
  return __builtin_fmaf(-x, y, v);
}
DIRICHLET_INLINE double fused(double v, double x, double y) {
  return __builtin_fma(-x, y, v);
}
#endif
#if defined(__FMA__)
DIRICHLET_INLINE __m128 fused(__m128 v, __m128 x, __m128 y) {
  return _mm_fnmadd_ps(x, y, v);
}
DIRICHLET_INLINE __m128d fused(__m128d v, __m128d x, __m128d y) {
  return _mm_fnmadd_pd(x, y, v);
}
DIRICHLET_INLINE __m256 fused(__m256 v, __m256 x, __m256 y) {
  return _mm256_fnmadd_ps(x, y, v);
}
DIRICHLET_INLINE __m256d fused(__m256d v, __m256d x, __m256d y) {
  return _mm256_fnmadd_pd(x, y, v);
}
#if defined(__AVX512F__)
DIRICHLET_INLINE __m512 fused(__m512 v, __m512 x, __m512 y) {
  return _mm512_fnmadd_ps(x, y, v);
}
DIRICHLET_INLINE __m512d fused(__m512d v, __m512d x, __m512d y) {
  return _mm512_fnmadd_pd(x, y, v);
}
#endif
#elif defined(__aarch64__)
DIRICHLET_INLINE float32x4_t fused(float32x4_t v, float32x4_t x, float32x4_t y) {
  return vfmsq_f32(v, x, y);
}
DIRICHLET_INLINE float64x2_t fused(float64x2_t v, float64x2_t x, float64x2_t y) {
  return vfmsq_f64(v, x, y);
}
#else
template <class V>
DIRICHLET_INLINE V fused(V v, V x, V y) {
  return v - x * y;
}
#endif

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

  DIRICHLET_INLINE static Vector fill(Real x) {
    return x - Vector{}; // not plus, for the sign of 0
  }

  /// v −= x y, rounded once where the instruction set can, else twice. Said in so many words, and the compiler is told
  /// to contract nothing by itself: it would depend on the shape of a tile, and so would the bits of the result.
  DIRICHLET_INLINE static void subtract_product(Vector& v, const Vector& x, const Vector& y) { v = fused(v, x, y); }

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
