// SPDX-License-Identifier: GPL-3.0-or-later
#include "intrinsic/intrinsic_triangulation.h"

#include <cmath>
#include <utility>

#include "index.h"
#include "parallel_collect.h"

namespace dirichlet {
namespace {

constexpr std::size_t kGrain = 1 << 13;

/// A triangle over a base of length 1: how far its tip's foot is from both ends of the base, and how high it is.
struct Tip {
  double from_begin, from_end, height;
};

/// From the cotangents at both ends of the base and at the tip, no digit of which is lost, however thin the triangle.
Tip tip_over(double at_begin, double at_end, double at_tip) {
  const double product = at_begin * at_end; // of products of two, the three have a sum of 1
  const double height = product < 0 ? at_tip / (1 - product) : 1 / (at_begin + at_end);
  return {at_begin * height, at_end * height, height};
}

/// The half cotangents of the triangle of one end of the base and both tips: at that end, at one tip, at the other.
struct Half {
  double at_end, at_one, at_other;
};

Half half_beside(double one_foot, double one_height, double other_foot, double other_height) {
  const double twice = 2 * (one_foot * other_height + other_foot * one_height), apart = one_height + other_height;
  return {(one_foot * other_foot - one_height * other_height) / twice,
          (one_foot * (one_foot - other_foot) + one_height * apart) / twice,
          (other_foot * (other_foot - one_foot) + other_height * apart) / twice};
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
  const auto cotangent = [this](Index side) { return 2 * half_edge(side).half_cotangent; }; // of the opposite angle
  const Tip above = tip_over(cotangent(h1), cotangent(h2), cotangent(h));
  const Tip below = tip_over(cotangent(t2), cotangent(t1), cotangent(t));
  const Half ljk = half_beside(above.from_end, above.height, below.from_end, below.height);
  const Half kil = half_beside(above.from_begin, above.height, below.from_begin, below.height);
  const double before = half_edge(h).half_cotangent + half_edge(t).half_cotangent, after = ljk.at_end + kil.at_end;
  if (!(std::isfinite(after) && after > before)) return false;

  const HalfEdge ki = half_edge(h2), lj = half_edge(t2);
  const Index k = ki.tail, l = lj.tail;
  half_edge(h) = {lj.twin == h2 ? t : lj.twin, l, ljk.at_one};
  half_edge(t) = {ki.twin == t2 ? h : ki.twin, k, kil.at_other};
  half_edge(h1).half_cotangent = ljk.at_other;
  half_edge(t1).half_cotangent = kil.at_one;
  half_edge(h2) = {t2, k, ljk.at_end};
  half_edge(t2) = {h2, l, kil.at_end};
  for (const Index moved : {h, t})
    if (const Index twin = half_edge(moved).twin; twin != kBorder) half_edge(twin).twin = moved;
  return true;
}

Index IntrinsicTriangulation::make_delaunay() {
  constexpr std::int64_t kPerTriangle = 64, kMore = 1'000'000;
  const std::int64_t limit = flip_limit.load(std::memory_order_relaxed);
  std::int64_t left = limit != 0 ? limit : kMore + kPerTriangle * static_cast<std::int64_t>(half_edges_.size() / 3);
  std::vector<Index> open;
  for (const Index first : find_others()) {
    open.push_back(first);
    while (!open.empty()) {
      const Index h = open.back();
      open.pop_back();
      if (is_delaunay(h)) continue;
      if (left == 0) return static_cast<Index>(find_others().size());
      const Index t = half_edge(h).twin;
      if (!flip(h)) continue;
      --left;
      for (const Index side : {h, next_in_triangle(h), t, next_in_triangle(t)}) open.push_back(side);
    }
  }
  return 0;
}

} // namespace dirichlet
