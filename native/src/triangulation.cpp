// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "dirichlet/error.h"
#include "ear_clipping.h"
#include "face_extent.h"
#include "flat_faces.h"
#include "index.h"
#include "message.h"
#include "parallel.h"
#include "parallel_collect.h"
#include "repeated_faces.h"

namespace dirichlet {
namespace {

/// A quad in two triangles, by twice their area vectors.
struct Halves {
  Vector3 one, two;

  /// Whether both face the way the whole quad does: neither folded over nor flat.
  [[nodiscard]] bool agree() const { return dot(one, one + two) > 0 && dot(two, one + two) > 0; }

  /// Whether they lie back to back, to within some ten degrees. Those at either diagonal do so where two sides cross;
  /// a quad that is bent or twisted by less has sides that pass each other at a distance.
  [[nodiscard]] bool fold() const {
    constexpr double kCosine = 0.98;
    const double sizes = std::sqrt(dot(one, one) * dot(two, two));
    return dot(one, two) < -kCosine * sizes && dot(one, one) > kThin * kThin && dot(two, two) > kThin * kThin;
  }
};

/// By the diagonal from a to c.
Halves halves(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  return {cross(b - a, c - a), cross(c - a, d - a)};
}

/// Twice the area vector.
Vector3 area_vector(std::span<const Vector3> polygon) {
  Vector3 sum;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum = sum + cross(polygon[i], polygon[(i + 1) % polygon.size()] - polygon[i]);
  return sum;
}

bool crosses_itself(std::span<const double> positions, std::span<const Index> quad) {
  const FaceExtent extent = face_extent(positions, quad);
  const double scale = unit_scale(extent.size);
  std::array<Vector3, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = scale * (point(positions, quad[i]) - extent.origin);
  return halves(p[0], p[1], p[2], p[3]).fold() && halves(p[1], p[2], p[3], p[0]).fold();
}

/// Twice the area vector of the largest triangle over a line from the first corner, which is 0.
Vector3 widest_triangle(std::span<const Vector3> polygon, const Vector3& line) {
  Vector3 widest;
  for (const Vector3& p : polygon)
    if (const Vector3 n = cross(line, p); dot(n, n) > dot(widest, widest)) widest = n;
  return widest;
}

/// Moves points along `normal` to the coordinate plane that is most across it, and so that they turn counter-clockwise
/// there. In an axis-parallel plane nothing is rounded.
void project(std::span<const Vector3> polygon, const Vector3& normal, std::vector<Point2>& flat) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  const auto turned = [&](const Vector3& p) { // its greatest part last
    if (z >= x && z >= y) return p;
    return y >= x ? Vector3{p.z, p.x, p.y} : Vector3{p.y, p.z, p.x};
  };
  const Vector3 n = turned(normal);
  flat.clear();
  for (const Vector3& point : polygon) {
    const Vector3 p = turned(point);
    const Point2 q{p.x - p.z * (n.x / n.z), p.y - p.z * (n.y / n.z)};
    flat.push_back(n.z > 0 ? q : Point2{q.y, q.x});
  }
}

/// Splits polygon after polygon, keeping its memory. The result names corners by their place in the polygon.
class PolygonSplitter {
 public:
  explicit PolygonSplitter(std::span<const double> positions) : positions_(positions) {}

  /// \returns whether there is a triangulation.
  bool split(std::span<const Index> corners) {
    triangles_.clear();
    if (corners.size() == 3) return use({0, 1, 2});
    load(corners);
    return corners.size() == 4 ? split_quad() : split_polygon();
  }
  [[nodiscard]] std::span<const Index> triangles() const { return triangles_; }

  /// Whether a polygon of more than four corners is cut into a fan though it is not flat.
  bool crosses_in_a_fan(std::span<const Index> corners) {
    load(corners);
    return is_thin() && !is_flat(positions_, corners) && !cut_across_normal();
  }

 private:
  bool use(std::initializer_list<Index> triangles) {
    triangles_ = triangles;
    return true;
  }

  /// Relative to the first corner, and of size about 1.
  void load(std::span<const Index> corners) {
    const FaceExtent extent = face_extent(positions_, corners);
    const double scale = unit_scale(extent.size);
    polygon_.clear();
    for (const Index corner : corners) polygon_.push_back(scale * (point(positions_, corner) - extent.origin));
    rounding_ = scale * extent.rounding;
    if (corners.size() > 4) widest_ = widest_triangle(polygon_, scale * extent.line);
  }

  [[nodiscard]] bool is_thin() const { return dot(widest_, widest_) <= kThin * kThin; }

  bool split_quad() {
    const auto& p = polygon_;
    const Halves one_way = halves(p[0], p[1], p[2], p[3]), other_way = halves(p[1], p[2], p[3], p[0]);
    if (!one_way.agree() && other_way.agree()) return use({0, 1, 3, 1, 2, 3});
    return use({0, 1, 2, 0, 2, 3});
  }

  bool split_polygon() {
    if (cut_across_normal()) return true;
    if (!is_thin()) return false;
    triangles_.clear();
    for (Index i = 1; i + 1 < static_cast<Index>(polygon_.size()); ++i)
      triangles_.insert(triangles_.end(), {0, i, i + 1});
    return true;
  }

  /// In the plane of the area vector, unless its parts cancel, as in a figure eight; else in that of the widest
  /// triangle.
  bool cut_across_normal() {
    const Vector3 area = area_vector(polygon_);
    const double width = dot(widest_, widest_);
    if (dot(area, area) > kThin * kThin * width && cut_across(area)) return true;
    return width > 0 && cut_across(dot(area, widest_) < 0 ? -1 * widest_ : widest_);
  }

  bool cut_across(const Vector3& normal) {
    triangles_.clear();
    project(polygon_, normal, flat_);
    return clipper_.cut(flat_, rounding_, triangles_);
  }

  std::span<const double> positions_;
  std::vector<Vector3> polygon_;
  double rounding_ = 0; ///< of its coordinates
  Vector3 widest_;      ///< twice the area vector of a triangle as wide as it
  std::vector<Point2> flat_;
  std::vector<Index> triangles_;
  EarClipper clipper_;
};

} // namespace

std::vector<Index> triangulate(std::span<const double> positions, std::span<const Index> offsets,
                               std::span<const Index> corners, std::span<const Index> left_out) {
  const std::size_t face_count = offsets.size() - 1;
  std::vector<Index> triangles(3 * (corners.size() - 2 * face_count));
  std::mutex mutex;
  std::vector<std::size_t> refused;
  parallel_chunks(face_count, std::size_t{1} << 13, [&](std::size_t begin, std::size_t end) {
    PolygonSplitter splitter(positions);
    for (std::size_t f = begin; f < end; ++f) {
      const auto first = static_cast<std::size_t>(offsets[f]), last = static_cast<std::size_t>(offsets[f + 1]);
      const auto polygon = corners.subspan(first, last - first);
      if (!splitter.split(polygon)) {
        const std::scoped_lock lock(mutex);
        refused.push_back(f);
        continue;
      }
      const auto out = triangles.begin() + static_cast<std::ptrdiff_t>(3 * (first - 2 * f));
      std::transform(splitter.triangles().begin(), splitter.triangles().end(), out,
                     [&](Index corner) { return polygon[static_cast<std::size_t>(corner)]; });
    }
  });
  if (refused.empty()) return triangles;
  const auto first = static_cast<Index>(*std::min_element(refused.begin(), refused.end()));
  throw TopologyError(message("face ", number_among_all(first, left_out),
                              " crosses itself and cannot be cut into triangles",
                              and_more(refused.size() - 1, "face")));
}

Buffer<Index> find_crossing_faces(std::span<const double> positions, std::span<const Index> offsets,
                                  std::span<const Index> corners) {
  constexpr std::size_t kGrain = 1 << 14;
  return parallel_collect<Index>(
      offsets.size() - 1, kGrain, [&](std::size_t begin, std::size_t end, Buffer<Index>& found) {
        PolygonSplitter splitter(positions);
        for (std::size_t f = begin; f < end; ++f) {
          const auto face = corners.subspan(at(offsets[f]), at(offsets[f + 1] - offsets[f]));
          if (face.size() == 4 ? crosses_itself(positions, face) : face.size() > 4 && splitter.crosses_in_a_fan(face))
            found.push_back(static_cast<Index>(f));
        }
      });
}

} // namespace dirichlet
