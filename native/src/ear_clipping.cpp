// SPDX-License-Identifier: GPL-3.0-or-later
#include "ear_clipping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
  hollow_.clear();
  forgotten_ = 0;
  waiting_.clear();
  const auto extent = [&](auto part) {
    const auto [low, high] = std::minmax_element(polygon.begin(), polygon.end(),
                                                 [&](const Point2& a, const Point2& b) { return a.*part < b.*part; });
    return (*high).*part - (*low).*part;
  };
  along_x_ = extent(&Point2::x) >= extent(&Point2::y);
  for (Index i = 0; i < size; ++i) {
    previous_[at(i)] = (i + size - 1) % size;
    next_[at(i)] = (i + 1) % size;
  }
  for (Index i = 0; i < size; ++i) {
    turn_[at(i)] = side(previous_[at(i)], i, next_[at(i)]);
    if (turn_[at(i)] <= 0) hollow_.push_back(i);
    waiting_.push_back(i);
  }
  std::ranges::sort(hollow_, {}, [&](Index corner) { return std::pair(key(corner), corner); });
}

/// One round over the corners waiting. Neighbours of a cut wait for the next one, so that a convex polygon is cut at
/// every other corner, and not into a fan of slivers.
void EarClipper::cut_ears(std::vector<Index>& triangles) {
  ++round_;
  if (2 * forgotten_ > hollow_.size()) forget_hollow();
  std::swap(waiting_, now_);
  waiting_.clear();
  for (const Index corner : now_)
    if (left_ > 3 && touched_[at(corner)] != round_ && is_ear(corner)) remove(corner, triangles);
}

/// Cuts off the triangle at `corner`.
void EarClipper::remove(Index corner, std::vector<Index>& triangles) {
  const Index before = previous_[at(corner)], after = next_[at(corner)];
  triangles.insert(triangles.end(), {before, corner, after});
  forgotten_ += turn_[at(corner)] <= 0 ? 1 : 0;
  turn_[at(corner)] = kRemoved;
  --left_;
  next_[at(before)] = after;
  previous_[at(after)] = before;
  update(before);
  update(after);
}

/// After a change of its neighbours.
void EarClipper::update(Index corner) {
  const bool was_hollow = turn_[at(corner)] <= 0;
  turn_[at(corner)] = side(previous_[at(corner)], corner, next_[at(corner)]);
  touched_[at(corner)] = round_;
  if (const bool is_hollow = turn_[at(corner)] <= 0; was_hollow && !is_hollow)
    ++forgotten_;
  else if (is_hollow && !was_hollow)
    add_hollow(corner);
  waiting_.push_back(corner);
}

/// Corners become hollow seldom: where cutting off ears leaves no angle.
void EarClipper::add_hollow(Index corner) {
  const auto sorted = [&](Index i) { return std::pair(key(i), i); };
  const auto place = std::ranges::lower_bound(hollow_, sorted(corner), {}, sorted);
  if (place != hollow_.end() && *place == corner)
    --forgotten_; // it has been before
  else
    hollow_.insert(place, corner);
}

void EarClipper::forget_hollow() {
  std::erase_if(hollow_, [&](Index corner) { return turn_[at(corner)] > 0; });
  forgotten_ = 0;
}

/// Only hollow corners are asked: were a side to enter the triangle, one of its corners inside would be hollow, namely
/// that farthest from the cut. And only those beside the triangle, which has small ones wait for few of many.
bool EarClipper::is_ear(Index corner) const {
  if (turn_[at(corner)] != 1) return false;
  const auto [low, high] = std::minmax({key(previous_[at(corner)]), key(corner), key(next_[at(corner)])});
  const double margin = 8 * rounding_; // `side` counts as on a line what is so near
  for (auto i = std::ranges::lower_bound(hollow_, low - margin, {}, [&](Index other) { return key(other); });
       i != hollow_.end() && key(*i) <= high + margin; ++i)
    if (turn_[at(*i)] <= 0 && blocks(corner, *i)) return false;
  return true;
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
