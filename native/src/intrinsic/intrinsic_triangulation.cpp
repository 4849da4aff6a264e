// SPDX-License-Identifier: GPL-3.0-or-later
#include "intrinsic/intrinsic_triangulation.h"

#include <cmath>
#include <utility>

#include "index.h"
#include "parallel_collect.h"
#include "triangle_lengths.h"

namespace dirichlet {
namespace {

constexpr std::size_t kGrain = 1 << 13;

/// Where the tip of a triangle lies over its base: how far along it, and how high.
struct Tip {
  double along, height;
};

Tip tip_over(double base, double from_begin, double from_end) {
  return {(base + (from_begin - from_end) * ((from_begin + from_end) / base)) / 2,
          2 * triangle_area({base, from_begin, from_end}) / base};
}

} // namespace

/// Angles of together more than π have cotangents of together less than 0.
bool IntrinsicTriangulation::is_delaunay(Index h) {
  const Index t = half_edge(h).twin;
  if (t == kBorder) return true;
  constexpr double kRounding = 1e-14;
  const double one = half_edge(h).half_cotangent, other = half_edge(t).half_cotangent;
  return one + other >= -kRounding * (std::abs(one) + std::abs(other));
}

Buffer<Index> IntrinsicTriangulation::find_others() {
  return parallel_collect<Index>(half_edges_.size(), kGrain, [&](std::size_t begin, std::size_t end, auto& found) {
    for (auto h = static_cast<Index>(begin); h < static_cast<Index>(end); ++h)
      if (h < half_edge(h).twin && !is_delaunay(h)) found.push_back(h);
  });
}

double IntrinsicTriangulation::other_diagonal(Index h) {
  const Index h1 = next_in_triangle(h), h2 = next_in_triangle(h1);
  const Index t1 = next_in_triangle(half_edge(h).twin), t2 = next_in_triangle(t1);
  const double base = half_edge(h).length;
  const Tip above = tip_over(base, half_edge(h2).length, half_edge(h1).length);
  const Tip below = tip_over(base, half_edge(t1).length, half_edge(t2).length);
  return std::hypot(above.along - below.along, above.height + below.height);
}

/// h runs from i to j, with k on its left and l on its right. Then
///
///         k                      k          slot  before  after
///     h2 / \ h1             t   /|\ h1      h     i → j   l → j, what t2 was
///       /   \                  / | \        h1    j → k   j → k
///      i --- j       becomes  i  |  j       h2    k → i   k → l
///       \   /                  \ | /        t     j → i   k → i, what h2 was
///     t1 \ / t2             t1  \|/ h       t1    i → l   i → l
///         l                      l          t2    l → j   l → k
///
/// \returns  whether it did: not where it would not help, for rounding, nor where both sides are of one triangle.
bool IntrinsicTriangulation::flip(Index h) {
  const Index t = half_edge(h).twin;
  if (h / 3 == t / 3) return false;
  const Index h1 = next_in_triangle(h), h2 = next_in_triangle(h1), t1 = next_in_triangle(t), t2 = next_in_triangle(t1);
  const HalfEdge ki = half_edge(h2), lj = half_edge(t2);
  const double diagonal = other_diagonal(h);
  const Sides ljk = half_cotangents({lj.length, half_edge(h1).length, diagonal});
  const Sides kil = half_cotangents({ki.length, half_edge(t1).length, diagonal});
  const double before = half_edge(h).half_cotangent + half_edge(t).half_cotangent, after = ljk[2] + kil[2];
  if (!(std::isfinite(after) && after > before)) return false;

  const Index k = ki.tail, l = lj.tail;
  half_edge(h) = {lj.twin == h2 ? t : lj.twin, l, lj.length, ljk[0]};
  half_edge(t) = {ki.twin == t2 ? h : ki.twin, k, ki.length, kil[0]};
  half_edge(h1).half_cotangent = ljk[1];
  half_edge(t1).half_cotangent = kil[1];
  half_edge(h2) = {t2, k, diagonal, ljk[2]};
  half_edge(t2) = {h2, l, diagonal, kil[2]};
  for (const Index moved : {h, t})
    if (const Index twin = half_edge(moved).twin; twin != kBorder) half_edge(twin).twin = moved;
  return true;
}

std::int64_t IntrinsicTriangulation::make_delaunay() {
  constexpr std::int64_t kPerTriangle = 64, kMore = 1'000'000;
  const std::int64_t most = kMore + kPerTriangle * static_cast<std::int64_t>(half_edges_.size() / 3);
  std::int64_t flips = 0;
  std::vector<Index> open;
  for (const Index first : find_others()) {
    open.push_back(first);
    while (!open.empty() && flips < most) {
      const Index h = open.back();
      open.pop_back();
      if (is_delaunay(h)) continue;
      const Index t = half_edge(h).twin;
      if (!flip(h)) continue;
      ++flips;
      for (const Index side : {h, next_in_triangle(h), t, next_in_triangle(t)}) open.push_back(side);
    }
  }
  return flips;
}

} // namespace dirichlet
