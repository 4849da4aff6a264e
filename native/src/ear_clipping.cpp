// SPDX-License-Identifier: GPL-3.0-or-later
#include "ear_clipping.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dirichlet {
namespace {

constexpr int kRemoved = 2;

} // namespace

bool EarClipper::cut(std::span<const Point2> polygon, double rounding, std::vector<Index>& triangles) {
  rounding_ = rounding;
  start(polygon);
  while (left_ > 3) {
    if (waiting_.empty()) { // a corner becomes an ear only when a neighbour is cut off, so no others are left
      const Index flat = first_flat();
      if (flat < 0) return false;
      remove(flat, triangles);
    }
    cut_ears(triangles);
  }
  const auto last = std::find_if(turn_.begin(), turn_.end(), [](int turn) { return turn != kRemoved; });
  if (*last < 0) return false;
  remove(static_cast<Index>(last - turn_.begin()), triangles);
  return true;
}

void EarClipper::start(std::span<const Point2> polygon) {
  polygon_ = polygon;
  const auto size = static_cast<Index>(polygon.size());
  left_ = polygon.size();
  round_ = 0;
  previous_.resize(left_);
  next_.resize(left_);
  turn_.assign(left_, 0);
  touched_.assign(left_, 0);
  hollow_.build(polygon);
  waiting_.clear();
  for (Index i = 0; i < size; ++i) {
    previous_[at(i)] = (i + size - 1) % size;
    next_[at(i)] = (i + 1) % size;
  }
  for (Index i = 0; i < size; ++i) {
    turn_[at(i)] = side(previous_[at(i)], i, next_[at(i)]);
    hollow_.mark(i, turn_[at(i)] <= 0);
    waiting_.push_back(i);
  }
}

/// One round over the corners waiting. Neighbours of a cut wait for the next one, so that a convex polygon is cut at
/// every other corner, and not into a fan of slivers; and that goes the other way round, so that a band is cut to and
/// fro.
void EarClipper::cut_ears(std::vector<Index>& triangles) {
  ++round_;
  std::swap(waiting_, now_);
  waiting_.clear();
  if (round_ % 2 == 0) std::ranges::reverse(now_);
  for (const Index corner : now_)
    if (left_ > 3 && touched_[at(corner)] != round_ && is_ear(corner)) remove(corner, triangles);
}

/// Cuts off the triangle at `corner`.
void EarClipper::remove(Index corner, std::vector<Index>& triangles) {
  const Index before = previous_[at(corner)], after = next_[at(corner)];
  triangles.insert(triangles.end(), {before, corner, after});
  turn_[at(corner)] = kRemoved;
  hollow_.mark(corner, false);
  --left_;
  next_[at(before)] = after;
  previous_[at(after)] = before;
  update(before);
  update(after);
}

/// After a change of its neighbours.
void EarClipper::update(Index corner) {
  turn_[at(corner)] = side(previous_[at(corner)], corner, next_[at(corner)]);
  touched_[at(corner)] = round_;
  hollow_.mark(corner, turn_[at(corner)] <= 0);
  waiting_.push_back(corner);
}

/// Only hollow corners are asked: were a side to enter the triangle, one of its corners inside would be hollow, namely
/// that farthest from the cut. And only those near the triangle.
bool EarClipper::is_ear(Index corner) const {
  if (turn_[at(corner)] != 1) return false;
  const auto place = [&](Index i) { return polygon_[at(i)]; };
  const double margin = 4 * rounding_; // of which `side` takes half
  return !hollow_.any_in({place(previous_[at(corner)]), place(corner), place(next_[at(corner)])}, margin,
                         [&](Index other) { return blocks(corner, other); });
}

/// Whether `corner` lies on the cut that would take off `ear`, or a side from it enters the open triangle, or its two
/// sides are those of the triangle, seen from outside.
bool EarClipper::blocks(Index ear, Index corner) const {
  const std::array<Index, 4> ring{previous_[at(ear)], ear, next_[at(ear)], previous_[at(ear)]};
  std::array<int, 3> inside{};
  for (std::size_t i = 0; i < 3; ++i)
    if (inside[i] = side(ring[i], ring[i + 1], corner); inside[i] < 0) return false;
  bool between = true;
  for (const Index end : {previous_[at(corner)], next_[at(corner)]}) {
    int least = 1; // over the triangle's sides on which `corner` lies
    for (std::size_t i = 0; i < 3; ++i)
      if (inside[i] == 0) least = std::min(least, side(ring[i], ring[i + 1], end));
    if (least > 0) return true;
    between = between && least == 0;
  }
  const bool at_ear = inside[0] == 0 && inside[1] == 0, on_cut = inside[0] > 0 && inside[1] > 0;
  return on_cut || (at_ear && between);
}

/// 1 if c lies left of the line from a to b, -1 right of it, 0 on it as far as rounded coordinates can tell.
int EarClipper::side(Index a, Index b, Index c) const {
  const Point2 p = polygon_[at(a)], q = polygon_[at(b)], r = polygon_[at(c)];
  const double ux = q.x - p.x, uy = q.y - p.y, vx = r.x - p.x, vy = r.y - p.y;
  const double area = ux * vy - uy * vx;
  if (std::abs(area) <= 2 * rounding_ * (std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy))) return 0;
  return area > 0 ? 1 : -1;
}

Index EarClipper::first_flat() const {
  const auto flat = std::find(turn_.begin(), turn_.end(), 0);
  return flat == turn_.end() ? -1 : static_cast<Index>(flat - turn_.begin());
}

} // namespace dirichlet
