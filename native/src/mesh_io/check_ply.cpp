// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "mesh_checks.h"
#include "mesh_io/checked_file.h"
#include "mesh_io/ply_values.h"

namespace dirichlet {
namespace {

bool is_corner_list(const PlyProperty& p) {
  return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
}

const PlyElement& only_element(const TextScanner& in, const PlyHeader& header, std::string_view name) {
  const auto is_it = [=](const PlyElement& e) { return e.name == name; };
  const auto found = std::find_if(header.elements.begin(), header.elements.end(), is_it);
  if (found == header.elements.end()) in.fail("the header names no ", name, " element");
  if (std::count_if(found, header.elements.end(), is_it) > 1) in.fail("the header names the ", name, " element twice");
  return *found;
}

/// The place of every coordinate among a vertex's properties.
std::array<std::size_t, 3> find_axes(const TextScanner& in, const PlyElement& vertex) {
  std::array<std::size_t, 3> axes{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const auto found = std::find_if(vertex.properties.begin(), vertex.properties.end(),
                                    [&](const PlyProperty& p) { return p.name == name && !p.count; });
    if (found == vertex.properties.end()) in.fail("the vertices have no ", name);
    axes[axis] = static_cast<std::size_t>(found - vertex.properties.begin());
  }
  return axes;
}

/// OpenMesh knows few of the types a list may be counted in; the unsigned type (or int) of that size reads the same.
std::string_view plain_type(PlyType type) {
  return size_of(type) == 1 ? "uchar" : size_of(type) == 2 ? "uint16" : "int";
}

std::string plain_header(PlyEncoding encoding, std::size_t faces, const PlyProperty& corners) {
  constexpr std::array<std::string_view, 3> names{"ascii", "binary_little_endian", "binary_big_endian"};
  return message("ply\nformat ", names[static_cast<std::size_t>(encoding)],
                 " 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nelement face ", faces,
                 "\nproperty list ", plain_type(*corners.count), " ", plain_type(corners.type),
                 " vertex_indices\nend_header\n");
}

class BodyCheck {
 public:
  BodyCheck(const FileBytes& file, PlyValues& in, std::size_t vertex_count)
      : file_(file), in_(in), vertex_count_(static_cast<double>(vertex_count)) {}

  void vertices(const PlyElement& element, const std::array<std::size_t, 3>& axes, std::vector<double>& positions) {
    positions.reserve(3 * element.count);
    std::vector<double> values(element.properties.size());
    for (std::size_t v = 0; v < element.count; ++v) {
      for (std::size_t p = 0; p < values.size(); ++p) values[p] = property(element.properties[p]);
      for (const std::size_t axis : axes) {
        if (!is_coordinate(values[axis]))
          in_.fail("vertex ", v, " has a coordinate that is not finite or beyond 1e150");
        positions.push_back(values[axis]);
      }
    }
  }

  void faces(const PlyElement& element, CheckedFile& checked) {
    for (std::size_t f = 0; f < element.count; ++f)
      for (const PlyProperty& p : element.properties) {
        const std::size_t begin = in_.position();
        if (!is_corner_list(p)) {
          property(p);
          continue;
        }
        checked.corners += corners(f, p);
        checked.stream.append(file_.bytes, begin, in_.position() - begin);
      }
    checked.stream += '\n'; // ends the last number of a text
    checked.faces = element.count;
  }

  void skip(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::size_t i = 0; i < element.count; ++i)
      for (const PlyProperty& p : element.properties) property(p);
  }

 private:
  /// Passes a property; its value, unless it is a list.
  double property(const PlyProperty& p) {
    if (!p.count) return in_.next(p.type);
    for (std::size_t left = list_length(p); left > 0; --left) in_.next(p.type);
    return 0;
  }

  std::size_t list_length(const PlyProperty& p) {
    const double count = in_.next(*p.count);
    if (count < 0) in_.fail("a list cannot have ", count, " entries");
    if (count > static_cast<double>(in_.remaining()))
      in_.fail("a list of ", count, " entries is promised, with only ", counted(in_.remaining(), "byte"), " left");
    return static_cast<std::size_t>(count);
  }

  std::size_t corners(std::size_t face, const PlyProperty& p) {
    const std::size_t count = list_length(p);
    if (count < 3)
      in_.fail("face ", face, " has ", counted(static_cast<std::int64_t>(count), "corner"), ", not three or more");
    for (std::size_t c = 0; c < count; ++c) {
      const double vertex = in_.next(p.type);
      if (vertex < 0 || vertex >= vertex_count_)
        in_.fail("face ", face, " names vertex ", vertex, ", but the file's vertices are 0 to ", vertex_count_ - 1);
    }
    return count;
  }

  const FileBytes& file_;
  PlyValues& in_;
  double vertex_count_;
};

} // namespace

CheckedFile check_ply(const FileBytes& file) {
  TextScanner in(file, {});
  const PlyHeader header = read_ply_header(in);
  const PlyElement& vertex = only_element(in, header, "vertex");
  const PlyElement& face = only_element(in, header, "face");
  const auto axes = find_axes(in, vertex);
  const auto corners = std::find_if(face.properties.begin(), face.properties.end(), is_corner_list);
  if (corners == face.properties.end() || !is_whole(corners->type)) in.fail("the faces have no list of vertex indices");
  if (std::count_if(corners, face.properties.end(), is_corner_list) > 1)
    in.fail("the faces have two lists of vertex indices");

  std::unique_ptr<PlyValues> values;
  if (header.encoding == PlyEncoding::ascii)
    values = std::make_unique<PlyText>(in);
  else
    values = std::make_unique<PlyBinary>(file, in.position(),
                                         header.encoding == PlyEncoding::binary_big_endian ? std::endian::big
                                                                                           : std::endian::little);

  CheckedFile checked;
  checked.stream = plain_header(header.encoding, face.count, *corners);
  BodyCheck body(file, *values, vertex.count);
  for (const PlyElement& element : header.elements)
    if (&element == &vertex)
      body.vertices(element, axes, checked.positions);
    else if (&element == &face)
      body.faces(element, checked);
    else
      body.skip(element);
  if (!values->at_end()) values->fail("the file goes on after the last element");
  return checked;
}

} // namespace dirichlet
