// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/geodesic.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "closest_point.h"
#include "dirichlet/error.h"
#include "groups.h"
#include "index.h"
#include "message.h"
#include "numbering.h"
#include "vector3.h"

namespace dirichlet {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double norm(const Vector3& a) {
  return std::sqrt(dot(a, a));
}

/// A place in the plane of a triangle: how far along one of its edges, and how far beside it.
struct Flat {
  double along = 0, beside = 0;
};

/// An edge as the axis of such planes.
class Axis {
 public:
  Axis(const Vector3& from, const Vector3& to) : from_(from), length_(norm(to - from)) {
    if (length_ > 0) direction_ = (1 / length_) * (to - from);
  }

  [[nodiscard]] double length() const { return length_; }

  [[nodiscard]] Flat place(const Vector3& p) const {
    return {dot(p - from_, direction_), norm(cross(p - from_, direction_))};
  }

  /// The place that is so far from the edge's ends; on the axis where there is none.
  [[nodiscard]] Flat place(double from_first, double from_second) const {
    const double along = (length_ + (from_first - from_second) * ((from_first + from_second) / length_)) / 2;
    return {along, std::sqrt(std::max(0.0, (from_first - along) * (from_first + along)))};
  }

  /// How far it is from a place on one side to one on the other, if the straight way crosses the edge; else infinite.
  [[nodiscard]] double across(const Flat& one, const Flat& other) const {
    const double width = one.beside + other.beside;
    const double crossing = width > 0 ? one.along + (other.along - one.along) * (one.beside / width) : other.along;
    return crossing >= 0 && crossing <= length_ ? std::hypot(other.along - one.along, width) : kInfinity;
  }

 private:
  Vector3 from_, direction_;
  double length_;
};

/// How far c is through the edge from a to b, whose distances are known; infinite if the way there misses it.
double distance_through(const Vector3& a, double from_a, const Vector3& b, double from_b, const Vector3& c) {
  if (from_b < from_a) return distance_through(b, from_b, a, from_a, c); // small numbers have small errors
  const Axis axis(a, b);
  if (axis.length() == 0 || from_b == kInfinity) return kInfinity;
  return axis.across(axis.place(from_a, from_b), axis.place(c));
}

/// Distances from one point, outwards. A vertex may be reached again on a shorter way, by an edge whose other end is
/// farther than itself; then it passes that on once more. Since every way's length grows with those it is made of, the
/// order in which this happens has no say in the result.
class Front {
 public:
  Front(const Mesh& triangles, const SurfacePoint& source)
      : triangles_(triangles), corners_(triangles.corners()), around_(triangles.corners_by_vertex()) {
    place_source(source);
    const std::array<Index, 3> corner{meet(source.vertices[0]), meet(source.vertices[1]), meet(source.vertices[2])};
    for (const Index i : corner) offer(i, 0);
    for (std::size_t i = 0; i < 3; ++i) leave(corner[i], corner[(i + 1) % 3]);
  }

  GeodesicDisc within(double radius, const CancelToken& cancel) {
    radius *= scale_;
    double edge = 0; // the longest in the disc: a vertex that is so much farther may still say how far one inside is
    constexpr std::size_t kSteps = 1 << 10; // between looks at the token
    for (std::size_t step = 0; !queue_.empty(); ++step) {
      if (step % kSteps == 0) cancel.check();
      const auto [distance, i] = queue_.top();
      queue_.pop();
      if (distance > places_[at(i)].distance) continue; // it was reached on a shorter way
      if (distance > radius + edge) break;
      const double longest = pass_on(i);
      if (distance <= radius) edge = std::max(edge, longest);
    }
    return disc(radius);
  }

 private:
  struct Place {
    Vector3 position; ///< seen from the source
    double distance = kInfinity;
  };

  /// All is measured from the source, in a unit that makes its triangle about 1 large.
  void place_source(const SurfacePoint& source) {
    const auto position = [&](std::size_t i) { return triangles_.positions().data() + 3 * at(source.vertices[i]); };
    double size = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      origin_[axis] = position(0)[axis];
      for (const std::size_t i : {1U, 2U}) size = std::max(size, std::abs(position(i)[axis] - origin_[axis]));
    }
    scale_ = unit_scale(size);
    source_ = source.weights[1] * seen(source.vertices[1]) + source.weights[2] * seen(source.vertices[2]);
  }

  [[nodiscard]] Vector3 seen(Index vertex) const {
    const double* p = triangles_.positions().data() + 3 * at(vertex);
    return Vector3{scale_ * (p[0] - origin_[0]), scale_ * (p[1] - origin_[1]), scale_ * (p[2] - origin_[2])} - source_;
  }

  /// The number of a vertex among those met.
  Index meet(Index vertex) {
    const Index i = number_(vertex);
    if (at(i) == places_.size()) places_.push_back({seen(vertex), kInfinity});
    return i;
  }

  /// Calls visit(j, k) for the other two corners of every triangle at i.
  template <class Visit>
  void for_triangles(Index i, const Visit& visit) {
    for (const Index corner : around_[number_.items()[at(i)]]) {
      const Index next = next_in_triangle(corner);
      const Index j = meet(corners_[at(next)]), k = meet(corners_[at(next_in_triangle(next))]);
      visit(j, k);
    }
  }

  /// From the source through the edge between i and j of its own triangle, straight: their distances tell badly how
  /// near it is to the edge.
  void leave(Index i, Index j) {
    for_triangles(i, [&](Index one, Index two) {
      if (one != j && two != j) return;
      const Index k = one == j ? two : one;
      const Axis axis(position(i), position(j));
      if (axis.length() > 0) offer(k, axis.across(axis.place(Vector3{}), axis.place(position(k))));
    });
  }

  /// \returns the length of the longest edge at i
  double pass_on(Index i) {
    double longest = 0;
    for_triangles(i, [&](Index j, Index k) {
      for (const auto& [through, to] : {std::pair{j, k}, {k, j}}) {
        const double edge = norm(position(to) - position(i)), distance = places_[at(i)].distance;
        longest = std::max(longest, edge);
        offer(to, std::min(distance + edge, distance_through(position(i), distance, position(through),
                                                             places_[at(through)].distance, position(to))));
      }
    });
    return longest;
  }

  /// A way to i of this length; no way is shorter than the straight one.
  void offer(Index i, double distance) {
    Place& place = places_[at(i)];
    distance = std::max(distance, norm(place.position));
    constexpr double kWorthIt = 1 - 1e-13; // not for rounding
    if (!(distance < kWorthIt * place.distance)) return;
    place.distance = distance;
    queue_.emplace(distance, i);
  }

  [[nodiscard]] const Vector3& position(Index i) const { return places_[at(i)].position; }

  [[nodiscard]] GeodesicDisc disc(double radius) const {
    std::vector<std::pair<Index, double>> inside;
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (const double d = places_[i].distance; d <= radius && d < kInfinity)
        inside.emplace_back(number_.items()[i], d / scale_);
    std::sort(inside.begin(), inside.end());
    GeodesicDisc disc;
    for (const auto& [vertex, distance] : inside) {
      disc.vertices.push_back(vertex);
      disc.distances.push_back(distance);
    }
    return disc;
  }

  using Reached = std::pair<double, Index>;

  const Mesh& triangles_;
  std::span<const Index> corners_;
  const Groups& around_;
  std::array<double, 3> origin_{};
  double scale_ = 1;
  Vector3 source_;
  Numbering number_;
  std::vector<Place> places_; ///< of the vertices met, by number
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue_;
};

/// The triangles that a polygon was cut into.
std::pair<Index, Index> triangles_of(const Mesh& mesh, Index face) {
  if (face < 0 || face >= mesh.face_count())
    throw InputError(message("there is no face ", face, ": the faces are 0 to ", mesh.face_count() - 1));
  const auto before = [&](Index f) { return mesh.offsets()[at(f)] - 2 * f; };
  return {before(face), before(face + 1)};
}

} // namespace

GeodesicDisc geodesic_disc(const Mesh& mesh, const std::array<double, 3>& point, double radius,
                           std::optional<Index> face, const CancelToken& cancel) {
  for (const double x : point)
    if (!std::isfinite(x)) throw InputError(message("the point has the coordinate ", x, ", which is not finite"));
  if (!(radius >= 0)) throw InputError(message("the radius is ", radius, ", but has to be 0 or more"));
  const Mesh& triangles = mesh.triangulated();
  if (!face) return Front(triangles, closest_point(triangles, point)).within(radius, cancel);
  const auto [first, last] = triangles_of(mesh, *face);
  return Front(triangles, closest_point(triangles, point, first, last)).within(radius, cancel);
}

} // namespace dirichlet
