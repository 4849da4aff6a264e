// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon_laplacian.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include <Eigen/Dense>

#include "dirichlet/error.h"
#include "edge_weights.h"
#include "index.h"
#include "message.h"
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

  /// All triangles are.
  [[nodiscard]] bool is_flat() const { return flat_; }
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
    const Vector3 origin = point(positions_, corners.front());
    double size = 0, farthest = 0;
    points_.resize(3, size_);
    for (Place i = 0; i < size_; ++i) {
      const Vector3 p = point(positions_, corners[static_cast<std::size_t>(i)]), q = p - origin;
      farthest = std::max(farthest, largest_part(p));
      size = std::max(size, largest_part(q));
      points_.col(i) << q.x, q.y, q.z;
    }
    scale_ = unit_scale(size);
    rounding_ = rounding_of(scale_ * farthest);
    points_ *= scale_;
    const Vector3d mean = points_.rowwise().mean();
    points_.colwise() -= mean;
  }

  [[nodiscard]] Vector3d side(Place i) const { return corner(i + 1 == size_ ? 0 : i + 1) - corner(i); }
  [[nodiscard]] Vector3d corner(Place i) const { return points_.col(i); }

  void load_triangle() {
    const auto shape = triangle_shape({to_vector3(corner(0)), to_vector3(corner(1)), to_vector3(corner(2))}, rounding_);
    flat_ = shape.flat;
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
    constexpr double kThin = 1e-10; // the square of a thickness that coordinates in float32 have by rounding alone
    const Vector3d least_areas = solve_as_far_as_known(A, b, kRounding);
    const Vector3d slope = solve_as_far_as_known(points_ * points_.transpose(), least_areas, kThin);
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
    flat_ = true;
    for (Place i = 0; i < size_; ++i) {
      const Place next = i + 1 == size_ ? 0 : i + 1;
      const Vector3d from = corner(i), to = corner(next);
      const auto shape = triangle_shape({to_vector3(from), to_vector3(to), to_vector3(virtual_)}, rounding_);
      flat_ = flat_ && shape.flat;
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
  double scale_ = 1, rounding_ = 0;
  Eigen::Matrix<double, 3, Eigen::Dynamic> points_;
  Eigen::VectorXd weights_;        ///< (k,) of the virtual vertex
  Vector3d virtual_, normal_;      ///< normal_: twice the area vector
  Eigen::VectorXd spokes_, sides_; ///< (k,) weights of the edges to the virtual vertex, and from a corner to the next
  Eigen::VectorXd areas_;          ///< (k,) of the triangles; negative where seen from behind
  double all_spokes_ = 0;          ///< their sum
  bool flat_ = true;
  Eigen::VectorXd mass_;
};

/// (F + 1,) where the pairs of every face start. \throws InputError  too many
std::vector<std::int64_t> count_pairs(std::span<const Index> offsets) {
  constexpr std::int64_t kMost = std::numeric_limits<Index>::max() / 4; // each makes two entries
  std::vector<std::int64_t> starts(offsets.size(), 0);
  for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
    const std::int64_t k = offsets[f + 1] - offsets[f];
    starts[f + 1] = starts[f] + k * (k - 1) / 2;
    if (starts[f + 1] > kMost)
      throw InputError(message("face ", f, " with its ", k, " corners makes more than the ", kMost,
                               " pairs of corners that the polygon Laplacian can hold; the others have no such limit"));
  }
  return starts;
}

} // namespace

PolygonLaplacian polygon_laplacian(const Mesh& mesh) {
  const auto corners = mesh.corners(), offsets = mesh.offsets();
  const auto starts = count_pairs(offsets);
  Buffer<Index> pairs(2 * static_cast<std::size_t>(starts.back()));
  Buffer<double> weights(static_cast<std::size_t>(starts.back()));
  Buffer<double> shares(corners.size());
  PolygonLaplacian result;
  result.flat = find_flat_faces(mesh.face_count(), [&] {
    return [&, element = PolygonElement(mesh.positions())](Index face) mutable {
      const auto first = at(offsets[at(face)]);
      const auto polygon = corners.subspan(first, at(offsets[at(face) + 1]) - first);
      element.load(polygon);
      std::ranges::copy(element.mass(), shares.begin() + offsets[at(face)]);
      auto pair = static_cast<std::size_t>(starts[at(face)]);
      for (std::size_t i = 0; i < polygon.size(); ++i)
        for (std::size_t j = i + 1; j < polygon.size(); ++j, ++pair) {
          pairs[2 * pair] = polygon[i];
          pairs[2 * pair + 1] = polygon[j];
          weights[pair] = element.pair_weight(static_cast<Place>(i), static_cast<Place>(j));
        }
      return element.is_flat();
    };
  });
  result.K = stiffness_of_edges(mesh.vertex_count(), pairs, weights);
  result.mass.assign(at(mesh.vertex_count()), 0.0);
  for (std::size_t c = 0; c < corners.size(); ++c) result.mass[at(corners[c])] += shares[c];
  return result;
}

} // namespace dirichlet
