// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace dirichlet {

struct Vector3 {
  double x = 0, y = 0, z = 0;
};

inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator*(double s, const Vector3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double largest_part(const Vector3& a) {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

/// The power of two that brings `size` >= 0 near 1, so that products of several lengths neither vanish nor overflow;
/// multiplying by it does not round.
inline double unit_scale(double size) {
  constexpr int kLargestExponent = 1000;
  return size > 0 ? std::ldexp(1.0, std::clamp(-std::ilogb(size), -kLargestExponent, kLargestExponent)) : 1.0;
}

} // namespace dirichlet
