// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

#include "dirichlet/error.h"
#include "ear_clipping.h"
#include "message.h"
#include "parallel.h"
#include "vector3.h"

namespace dirichlet {
namespace {

/// Whether the triangles 0 1 2 and 0 2 3 both face the way the whole quad does: neither folded over nor flat.
bool splits_well(const std::array<Vector3, 4>& quad) {
  const Vector3 diagonal = quad[2] - quad[0];
  const Vector3 one = cross(quad[1] - quad[0], diagonal), two = cross(diagonal, quad[3] - quad[0]);
  const Vector3 whole = one + two;
  return dot(one, whole) > 0 && dot(two, whole) > 0;
}

/// Twice the area vector.
Vector3 area_vector(std::span<const Vector3> polygon) {
  Vector3 sum;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum = sum + cross(polygon[i], polygon[(i + 1) % polygon.size()] - polygon[i]);
  return sum;
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

 private:
  bool use(std::initializer_list<Index> triangles) {
    triangles_ = triangles;
    return true;
  }

  /// Relative to the first corner, and of size about 1.
  void load(std::span<const Index> corners) {
    polygon_.clear();
    double size = 0, farthest = 0;
    for (const Index corner : corners) {
      const double* p = positions_.data() + 3 * static_cast<std::size_t>(corner);
      polygon_.push_back(Vector3{p[0], p[1], p[2]});
      farthest = std::max(farthest, largest_part(polygon_.back()));
      size = std::max(size, largest_part(polygon_.back() - polygon_.front()));
    }
    const double scale = unit_scale(size);
    const Vector3 origin = polygon_.front();
    for (Vector3& point : polygon_) point = scale * (point - origin);
    rounding_ = 4 * std::numeric_limits<double>::epsilon() * (scale * farthest);
  }

  bool split_quad() {
    const auto& p = polygon_;
    if (!splits_well({p[0], p[1], p[2], p[3]}) && splits_well({p[1], p[2], p[3], p[0]})) return use({0, 1, 3, 1, 2, 3});
    return use({0, 1, 2, 0, 2, 3});
  }

  bool split_polygon() {
    const Vector3 area = area_vector(polygon_);
    if (dot(area, area) == 0) { // in no plane, or on a line: any triangulation is as good
      for (Index i = 1; i + 1 < static_cast<Index>(polygon_.size()); ++i)
        triangles_.insert(triangles_.end(), {0, i, i + 1});
      return true;
    }
    project(polygon_, area, flat_);
    return clipper_.cut(flat_, rounding_, triangles_);
  }

  std::span<const double> positions_;
  std::vector<Vector3> polygon_;
  double rounding_ = 0; ///< of its coordinates
  std::vector<Point2> flat_;
  std::vector<Index> triangles_;
  EarClipper clipper_;
};

} // namespace

std::vector<Index> triangulate(std::span<const double> positions, std::span<const Index> offsets,
                               std::span<const Index> corners) {
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
  throw TopologyError(message("face ", *std::min_element(refused.begin(), refused.end()),
                              " crosses itself and cannot be cut into triangles",
                              and_more(refused.size() - 1, "face")));
}

} // namespace dirichlet
