// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon_laplacian.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>

#include <Eigen/Dense>

#include "dirichlet/error.h"
#include "edge_weights.h"
#include "face_extent.h"
#include "index.h"
#include "memory.h"
#include "message.h"
#include "parallel.h"
#include "triangle_shape.h"

namespace dirichlet {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Place = Eigen::Index; ///< of a corner in its polygon

/// Some x with A x = b for a positive semi-definite A, 0 in directions where it is not above the share `least`.
Vector3d solve_as_far_as_known(const Matrix3d& A, const Vector3d& b, double least) {
  Eigen::FullPivLU<Matrix3d> lu;
  lu.setThreshold(least);
  return lu.compute(A).solve(b);
}

Vector3 to_vector3(const Vector3d& a) {
  return {a.x(), a.y(), a.z()};
}

/// Weights and masses of polygon after polygon, keeping its memory. A triangle is its own element.
class PolygonElement {
 public:
  explicit PolygonElement(std::span<const double> positions) : positions_(positions) {}

  void load(std::span<const Index> corners) {
    size_ = static_cast<Place>(corners.size());
    place(corners);
    if (size_ == 3) return load_triangle();
    find_virtual_vertex();
    find_spokes();
    share_out_mass();
  }

  /// (k,) the share of every corner
  [[nodiscard]] const Eigen::VectorXd& mass() const { return mass_; }

  /// Of the corners i < j: −(Pᵀ K P)(i,j) for the stiffness K of the triangles and P, which writes the virtual vertex
  /// as Σ weights_[i] corner i.
  [[nodiscard]] double pair_weight(Place i, Place j) const {
    const double around = spokes_[i] * weights_[j] + spokes_[j] * weights_[i] - weights_[i] * weights_[j] * all_spokes_;
    if (j == i + 1) return around + sides_[i];
    return i == 0 && j + 1 == size_ ? around + sides_[j] : around;
  }

 private:
  /// Corners around their mean, of size about 1: neither offset nor scale costs any digits.
  void place(std::span<const Index> corners) {
    const FaceExtent extent = face_extent(positions_, corners);
    points_.resize(3, size_);
    for (Place i = 0; i < size_; ++i) {
      const Vector3 q = point(positions_, corners[static_cast<std::size_t>(i)]) - extent.origin;
      points_.col(i) << q.x, q.y, q.z;
    }
    scale_ = unit_scale(extent.size);
    points_ *= scale_;
    const Vector3d mean = points_.rowwise().mean();
    points_.colwise() -= mean;
  }

  [[nodiscard]] Vector3d side(Place i) const { return corner(i + 1 == size_ ? 0 : i + 1) - corner(i); }
  [[nodiscard]] Vector3d corner(Place i) const { return points_.col(i); }

  void load_triangle() {
    const auto shape = triangle_shape({to_vector3(corner(0)), to_vector3(corner(1)), to_vector3(corner(2))});
    weights_ = spokes_ = Vector3d::Zero();
    sides_ = Vector3d(shape.cotangents[2], shape.cotangents[0], shape.cotangents[1]) / 2;
    mass_.setConstant(3, shape.area / scale_ / scale_ / 3);
  }

  void find_virtual_vertex() {
    Matrix3d A = Matrix3d::Zero();
    Vector3d b = Vector3d::Zero();
    for (Place i = 0; i < size_; ++i) {
      const Vector3d e = side(i), p = corner(i);
      A += e.squaredNorm() * Matrix3d::Identity() - e * e.transpose();
      b += e.squaredNorm() * p - e.dot(p) * e;
    }
    constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
    const Vector3d least_areas = solve_as_far_as_known(A, b, kRounding);
    const Vector3d slope = solve_as_far_as_known(points_ * points_.transpose(), least_areas, kThin * kThin);
    weights_ = points_.transpose() * slope; // they sum to 0, and with 1/k to 1
    weights_.array() += 1 / static_cast<double>(size_);
    virtual_ = points_ * weights_;
    normal_.setZero();
    for (Place i = 0; i < size_; ++i) normal_ += corner(i).cross(side(i));
  }

  /// The triangles around the virtual vertex.
  void find_spokes() {
    spokes_.setZero(size_);
    sides_.setZero(size_);
    areas_.setZero(size_);
    for (Place i = 0; i < size_; ++i) {
      const Place next = i + 1 == size_ ? 0 : i + 1;
      const Vector3d from = corner(i), to = corner(next);
      const auto shape = triangle_shape({to_vector3(from), to_vector3(to), to_vector3(virtual_)});
      spokes_[i] += shape.cotangents[1] / 2;
      spokes_[next] += shape.cotangents[0] / 2;
      sides_[i] = shape.cotangents[2] / 2;
      const bool behind = (from - virtual_).cross(to - virtual_).dot(normal_) < 0;
      areas_[i] = behind ? -shape.area : shape.area;
    }
    all_spokes_ = spokes_.sum();
  }

  void share_out_mass() {
    const double area = areas_.sum();
    const auto shares = [&](const Eigen::VectorXd& areas, const Eigen::VectorXd& weights) {
      mass_.resize(size_);
      for (Place i = 0; i < size_; ++i)
        mass_[i] = (areas[i] + areas[i == 0 ? size_ - 1 : i - 1] + weights[i] * areas.sum()) / 3;
    };
    shares(areas_, weights_);
    if (mass_.minCoeff() < 0) { // a folded polygon may have more behind than in front
      const double least = std::max(area, normal_.norm() / 2);
      const Eigen::VectorXd sizes = areas_.cwiseAbs() * (least / areas_.cwiseAbs().sum());
      shares(sizes, Eigen::VectorXd::Constant(sizes.size(), 1 / static_cast<double>(size_)));
    }
    mass_ = mass_ / scale_ / scale_;
  }

  std::span<const double> positions_;
  Place size_ = 0;
  double scale_ = 1;
  Eigen::Matrix<double, 3, Eigen::Dynamic> points_;
  Eigen::VectorXd weights_;        ///< (k,) of the virtual vertex
  Vector3d virtual_, normal_;      ///< normal_: twice the area vector
  Eigen::VectorXd spokes_, sides_; ///< (k,) weights of the edges to the virtual vertex, and from a corner to the next
  Eigen::VectorXd areas_;          ///< (k,) of the triangles; negative where seen from behind
  double all_spokes_ = 0;          ///< their sum
  Eigen::VectorXd mass_;
};

constexpr std::int64_t kMostPolygonCorners = 7000;
constexpr std::int64_t kMostWork = kMostPolygonCorners * kMostPolygonCorners * kMostPolygonCorners;
constexpr std::int64_t kLargePolygon = 500; // whose block takes much of the time in any mesh

std::size_t largest_face(std::span<const Index> offsets) {
  std::size_t largest = 0;
  for (std::size_t f = 1; f + 1 < offsets.size(); ++f)
    if (offsets[f + 1] - offsets[f] > offsets[largest + 1] - offsets[largest]) largest = f;
  return largest;
}

/// (F + 1,) where the pairs of every face start. \throws InputError  too many; names the largest face
std::vector<std::int64_t> count_pairs(const Mesh& mesh) {
  const auto offsets = mesh.offsets();
  const std::size_t largest = largest_face(offsets);
  const auto size = [&](std::size_t f) { return std::int64_t{offsets[f + 1] - offsets[f]}; };
  const auto face = [&] {
    return message("face ", mesh.number_with_repeats(static_cast<Index>(largest)), " with its ", size(largest),
                   " corners");
  };
  if (size(largest) > kMostPolygonCorners)
    throw InputError(message(face(), " is beyond the ", kMostPolygonCorners,
                             " that the polygon Laplacian takes, as its ",
                             "time grows with their cube; the other Laplacians take any number"));
  std::vector<std::int64_t> starts(offsets.size(), 0);
  std::int64_t work = 0;
  for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
    starts[f + 1] = starts[f] + size(f) * (size(f) - 1) / 2;
    if (size(f) > kLargePolygon) work += size(f) * size(f) * size(f);
  }
  if (work > kMostWork)
    throw InputError(message("the large faces, the largest of which is ", face(), ", take more time together than one ",
                             "of ", kMostPolygonCorners, " corners, the most that the polygon Laplacian takes; the ",
                             "other Laplacians take any number"));

  // Each pair has two entries, numbered in 32 bits with the diagonal's; both take these bytes where K is made.
  constexpr std::int64_t kBytes = 72, kMost = std::numeric_limits<Index>::max() / 4;
  const std::int64_t most = std::min(kMost, physical_memory() / kBytes);
  if (starts.back() > most)
    throw InputError(message("the faces, the largest of which is ", face(), ", make ", starts.back(),
                             " pairs of corners, more than the ", most, " that there is memory for; ",
                             "the other Laplacians take any number"));
  return starts;
}

} // namespace

PolygonLaplacian polygon_laplacian(const Mesh& mesh) {
  const auto corners = mesh.corners(), offsets = mesh.offsets();
  const auto starts = count_pairs(mesh);
  Buffer<Index> pairs(2 * static_cast<std::size_t>(starts.back()));
  Buffer<double> weights(static_cast<std::size_t>(starts.back()));
  Buffer<double> shares(corners.size());
  constexpr std::size_t kGrain = 1 << 12;
  parallel_chunks(at(mesh.face_count()), kGrain, [&](std::size_t begin, std::size_t end) {
    PolygonElement element(mesh.positions());
    for (std::size_t face = begin; face < end; ++face) {
      const auto polygon = corners.subspan(at(offsets[face]), at(offsets[face + 1] - offsets[face]));
      element.load(polygon);
      std::ranges::copy(element.mass(), shares.begin() + offsets[face]);
      auto pair = static_cast<std::size_t>(starts[face]);
      for (std::size_t i = 0; i < polygon.size(); ++i)
        for (std::size_t j = i + 1; j < polygon.size(); ++j, ++pair) {
          pairs[2 * pair] = polygon[i];
          pairs[2 * pair + 1] = polygon[j];
          weights[pair] = element.pair_weight(static_cast<Place>(i), static_cast<Place>(j));
        }
    }
  });
  PolygonLaplacian result;
  result.K = stiffness_of_edges(mesh.vertex_count(), pairs, weights);
  result.mass.assign(at(mesh.vertex_count()), 0.0);
  for (std::size_t c = 0; c < corners.size(); ++c) result.mass[at(corners[c])] += shares[c];
  return result;
}

} // namespace dirichlet
