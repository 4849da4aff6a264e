// SPDX-License-Identifier: GPL-3.0-or-later
#include "ear_clipping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dirichlet {
namespace {

constexpr int kRemoved = 2;

} // namespace

bool EarClipper::cut(std::span<const Point2> polygon, std::vector<Index>& triangles) {
  polygon_ = polygon;
  start();
  std::size_t left = polygon.size();
  bool progress = false;
  for (std::size_t head = 0; left > 3;) {
    Index corner = -1;
    if (head < waiting_.size()) {
      corner = waiting_[head++];
      if (!is_ear(corner)) continue;
    } else if (progress) { // a cut frees its neighbours as a rule; look at all the others before giving up
      progress = false;
      head = 0;
      waiting_.clear();
      for (Index i = 0; i < static_cast<Index>(polygon.size()); ++i) waiting_.push_back(i);
      continue;
    } else if (corner = first_flat(); corner < 0) {
      return false;
    }
    remove(corner, triangles);
    --left;
    progress = true;
  }
  const auto last = std::find_if(turn_.begin(), turn_.end(), [](int turn) { return turn != kRemoved; });
  if (last == turn_.end() || *last < 0) return false;
  const auto corner = static_cast<Index>(last - turn_.begin());
  triangles.insert(triangles.end(), {previous_[at(corner)], corner, next_[at(corner)]});
  return true;
}

/// Every other corner comes first, so that a convex polygon is not cut into a fan of slivers.
void EarClipper::start() {
  const auto size = static_cast<Index>(polygon_.size());
  previous_.resize(at(size));
  next_.resize(at(size));
  turn_.assign(at(size), 0);
  hollow_.clear();
  waiting_.clear();
  for (Index i = 0; i < size; ++i) {
    previous_[at(i)] = (i + size - 1) % size;
    next_[at(i)] = (i + 1) % size;
  }
  for (const Index parity : {0, 1})
    for (Index i = parity; i < size; i += 2) update(i);
}

/// Cuts off the triangle at `corner`.
void EarClipper::remove(Index corner, std::vector<Index>& triangles) {
  const Index before = previous_[at(corner)], after = next_[at(corner)];
  triangles.insert(triangles.end(), {before, corner, after});
  turn_[at(corner)] = kRemoved;
  next_[at(before)] = after;
  previous_[at(after)] = before;
  update(before);
  update(after);
}

/// After a change of its neighbours.
void EarClipper::update(Index corner) {
  turn_[at(corner)] = side(previous_[at(corner)], corner, next_[at(corner)]);
  if (turn_[at(corner)] <= 0) hollow_.push_back(corner);
  waiting_.push_back(corner);
}

/// Only hollow corners are asked: were a side to enter the triangle, one of its corners inside would be hollow, namely
/// that farthest from the cut.
bool EarClipper::is_ear(Index corner) {
  if (turn_[at(corner)] != 1) return false;
  for (std::size_t i = 0; i < hollow_.size();) {
    if (turn_[at(hollow_[i])] > 0) { // no longer
      hollow_[i] = hollow_.back();
      hollow_.pop_back();
    } else if (blocks(corner, hollow_[i])) {
      return false;
    } else {
      ++i;
    }
  }
  return true;
}

/// Whether `corner` lies on the cut that would take off `ear`, or a side from it enters the open triangle.
bool EarClipper::blocks(Index ear, Index corner) const {
  const std::array<Index, 4> ring{previous_[at(ear)], ear, next_[at(ear)], previous_[at(ear)]};
  std::array<int, 3> inside{};
  for (std::size_t i = 0; i < 3; ++i)
    if (inside[i] = side(ring[i], ring[i + 1], corner); inside[i] < 0) return false;
  for (const Index end : {previous_[at(corner)], next_[at(corner)]}) {
    bool enters = true;
    for (std::size_t i = 0; i < 3 && enters; ++i) enters = inside[i] > 0 || side(ring[i], ring[i + 1], end) > 0;
    if (enters) return true;
  }
  return inside[0] > 0 && inside[1] > 0; // hence not inside[2]: between the ends of the cut
}

/// 1 if c lies left of the line from a to b, -1 right of it, 0 on it as far as coordinates rounded at size 1 can tell.
int EarClipper::side(Index a, Index b, Index c) const {
  const Point2 p = polygon_[at(a)], q = polygon_[at(b)], r = polygon_[at(c)];
  const double ux = q.x - p.x, uy = q.y - p.y, vx = r.x - p.x, vy = r.y - p.y;
  const double area = ux * vy - uy * vx;
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  if (std::abs(area) <= kRounding * (std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy))) return 0;
  return area > 0 ? 1 : -1;
}

Index EarClipper::first_flat() const {
  const auto flat = std::find(turn_.begin(), turn_.end(), 0);
  return flat == turn_.end() ? -1 : static_cast<Index>(flat - turn_.begin());
}

} // namespace dirichlet
