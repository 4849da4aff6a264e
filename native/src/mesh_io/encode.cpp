// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_io/encode.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "dirichlet/error.h"
#include "dirichlet/triangulation.h"
#include "mesh_io/byte_order.h"
#include "message.h"

namespace dirichlet {
namespace {

/// The shortest digits that read back as the same number; independent of the locale.
template <class Number>
void append_number(std::string& out, Number value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out.append(digits.data(), end);
}

/// Numbers with a blank before each, then the end of the line.
template <class Number>
void append_line(std::string& out, std::span<const Number> numbers, Number shift = 0) {
  for (const Number value : numbers) {
    out += ' ';
    append_number(out, value + shift);
  }
  out += '\n';
}

using Point = std::array<float, 3>;

Point single_precision(const MeshView& mesh, Index vertex) {
  Point point;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = mesh.positions[3 * static_cast<std::size_t>(vertex) + axis];
    if (!(std::abs(x) <= static_cast<double>(std::numeric_limits<float>::max())))
      throw InputError(message("vertex ", vertex, " has the coordinate ", x, ", beyond the single precision of STL"));
    point[axis] = static_cast<float>(x);
  }
  return point;
}

/// Unit normal of a triangle, zero where it has none.
std::array<double, 3> normal(const std::array<Point, 3>& t) {
  std::array<double, 3> a, b;
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = static_cast<double>(t[1][i]) - static_cast<double>(t[0][i]);
    b[i] = static_cast<double>(t[2][i]) - static_cast<double>(t[0][i]);
  }
  std::array<double, 3> n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  for (double& x : n) x = length > 0 ? x / length : 0;
  return n;
}

} // namespace

std::string encode_obj(const MeshView& mesh) {
  std::string out;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    out += 'v';
    append_line(out, mesh.positions.subspan(3 * v, 3));
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out += 'f';
    append_line(out, mesh.face(f), Index{1});
  }
  return out;
}

std::string encode_off(const MeshView& mesh) {
  std::string out = message("OFF\n", mesh.vertex_count(), " ", mesh.face_count(), " 0\n");
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) append_line(out, mesh.positions.subspan(3 * v, 3));
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    append_number(out, mesh.face(f).size());
    append_line(out, mesh.face(f));
  }
  return out;
}

std::string encode_ply(const MeshView& mesh, std::span<const unsigned char> colors) {
  std::size_t largest = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) largest = std::max(largest, mesh.face(f).size());
  const bool small = largest < 256; // most programs expect the byte, so it is used where it can
  std::string out =
      message("ply\nformat binary_little_endian 1.0\nelement vertex ", mesh.vertex_count(),
              "\nproperty double x\nproperty double y\nproperty double z\n",
              colors.empty() ? "" : "property uchar red\nproperty uchar green\nproperty uchar blue\n", "element face ",
              mesh.face_count(), "\nproperty list ", small ? "uchar" : "int", " int vertex_indices\nend_header\n");
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    for (const double x : mesh.positions.subspan(3 * v, 3)) store(out, x);
    if (!colors.empty())
      for (const unsigned char c : colors.subspan(3 * v, 3)) store(out, c);
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (small)
      store(out, static_cast<unsigned char>(face.size()));
    else
      store(out, static_cast<Index>(face.size()));
    for (const Index v : face) store(out, v);
  }
  return out;
}

std::string encode_stl(const MeshView& mesh) {
  const std::vector<Index> triangles = triangulate(mesh.positions, mesh.offsets, mesh.corners);
  std::string out(80, ' '); // must not begin with "solid", the mark of a text
  store(out, static_cast<std::uint32_t>(triangles.size() / 3));
  bool any = triangles.empty();
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const std::array<Point, 3> points{single_precision(mesh, triangles[t]), single_precision(mesh, triangles[t + 1]),
                                      single_precision(mesh, triangles[t + 2])};
    any = any || (points[0] != points[1] && points[1] != points[2] && points[2] != points[0]);
    for (const double x : normal(points)) store(out, static_cast<float>(x));
    for (const Point& point : points)
      for (const float x : point) store(out, x);
    store(out, std::uint16_t{0});
  }
  if (!any) throw InputError("in the single precision of STL no triangle has three different corners");
  return out;
}

} // namespace dirichlet
