// SPDX-License-Identifier: GPL-3.0-or-later
#include "damage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "index.h"

namespace dirichlet::fuzz {
namespace {

using makers::PolygonSoup;
using Face = std::vector<Index>;

constexpr std::size_t kMostVertices = 600, kMostFaces = 1200; // so that an input takes milliseconds

Index vertex_count(const PolygonSoup& soup) {
  return static_cast<Index>(soup.positions.size() / 3);
}

/// The surfaces side by side, without a vertex in common.
void append(PolygonSoup& soup, const PolygonSoup& more) {
  const Index shift = vertex_count(soup);
  soup.positions.insert(soup.positions.end(), more.positions.begin(), more.positions.end());
  for (Face face : more.faces) {
    for (Index& v : face) v += shift;
    soup.faces.push_back(std::move(face));
  }
}

/// The damages of a soup, at places that a script names.
class Vandal {
 public:
  Vandal(PolygonSoup& soup, Script& script) : soup_(soup), script_(script) {}

  bool to_faces(char letter) {
    if (soup_.faces.empty()) return false;
    Face& face = soup_.faces[face_number()];
    switch (letter) {
    case 'D':
      soup_.faces.push_back(face);
      return true;
    case 'R':
      std::reverse(face.begin(), face.end());
      return true;
    case 'O':
      return leave_out(face);
    case 'V':
      std::rotate(face.begin(), face.begin() + (face.empty() ? 0 : 1), face.end());
      return true;
    case 'J':
      return join(face, soup_.faces[face_number()]);
    default:
      return !face.empty() && to_corner(letter, face, at(script_.number(static_cast<Index>(face.size()))));
    }
  }

  bool to_vertices(char letter) {
    if (soup_.positions.empty()) return false;
    const Index v = vertex();
    switch (letter) {
    case 'X':
      *point(v) = script_.value() * 1e6;
      return true;
    case 'K':
      return move(v, vertex(), vertex(), 0.5);
    case 'Z':
      return move(v, vertex(), v, 0);
    case 'N':
      return move(v, vertex(), v, 1e-12);
    case 'Y':
      std::swap_ranges(point(v), point(v) + 3, point(vertex()));
      return true;
    case 'M':
      return merge(v, vertex());
    default:
      return false;
    }
  }

  bool to_all(char letter) {
    const Index axis = letter == 'S' ? 0 : script_.number(3);
    const double x = script_.value();
    for (std::size_t k = 0; k < soup_.positions.size(); ++k) {
      const bool meant = letter == 'S' || static_cast<Index>(k % 3) == axis;
      if (meant) soup_.positions[k] = letter == 'T' ? soup_.positions[k] + x : soup_.positions[k] * x;
    }
    return true;
  }

 private:
  bool to_corner(char letter, Face& face, std::size_t corner) {
    const Index v = face[corner], next = face[(corner + 1) % face.size()];
    const auto place = face.begin() + static_cast<std::ptrdiff_t>(corner);
    switch (letter) {
    case 'E':
      face.insert(place, v);
      return true;
    case 'W':
      std::swap(face[corner], face[(corner + 1) % face.size()]);
      return true;
    case 'C':
      *place = copy(v);
      return true;
    case 'F':
      soup_.faces.push_back(Face{v, next, vertex()});
      return true;
    default:
      return false;
    }
  }

  bool leave_out(Face& face) {
    std::swap(face, soup_.faces.back());
    soup_.faces.pop_back();
    return true;
  }

  /// The one polygon around both; one of them is left without corners, and goes.
  bool join(Face& one, Face& other) {
    for (std::size_t c = 0; c < one.size() && &one != &other; ++c) {
      const Index v = one[c], w = one[(c + 1) % one.size()];
      const auto from = std::find(other.begin(), other.end(), w);
      if (from == other.end() || *(from + 1 == other.end() ? other.begin() : from + 1) != v) continue;
      std::rotate(other.begin(), from, other.end()); // w v …
      one.insert(one.begin() + static_cast<std::ptrdiff_t>(c) + 1, other.begin() + 2, other.end());
      return leave_out(other);
    }
    return true;
  }

  bool merge(Index v, Index w) {
    for (Face& face : soup_.faces) std::replace(face.begin(), face.end(), v, w);
    return true;
  }

  /// To (1 - t) of the way from `to` to `beside`.
  bool move(Index v, Index to, Index beside, double t) {
    for (std::size_t axis = 0; axis < 3; ++axis) point(v)[axis] = std::lerp(point(to)[axis], point(beside)[axis], t);
    return true;
  }

  Index copy(Index v) {
    if (v < 0 || v >= vertex_count(soup_)) return v;
    const std::array<double, 3> p{point(v)[0], point(v)[1], point(v)[2]};
    soup_.positions.insert(soup_.positions.end(), p.begin(), p.end());
    return vertex_count(soup_) - 1;
  }

  std::size_t face_number() { return at(script_.number(static_cast<Index>(soup_.faces.size()))); }
  Index vertex() { return script_.number(vertex_count(soup_)); }
  double* point(Index v) { return soup_.positions.data() + 3 * at(v); }

  PolygonSoup& soup_;
  Script& script_;
};

PolygonSoup own_face(const PolygonSoup& soup, Script& script) {
  Face face(at(script.number(32)));
  const Index shift = vertex_count(soup);
  for (Index& v : face) v = script.number(shift + 3) - shift - 1; // also those that are not there
  return {{}, {face}};
}

} // namespace

bool add_surface(PolygonSoup& soup, char letter, Script& script) {
  if (soup.positions.size() > 3 * kMostVertices || soup.faces.size() > kMostFaces) return false;
  const auto size = [&](Index least) { return least + script.number(12); };
  switch (letter) {
  case 'g':
  case 'q': {
    const Index nx = size(1), ny = size(1);
    append(soup, makers::grid(nx, ny, letter == 'g'));
    return true;
  }
  case 't':
  case 'k': {
    const Index nu = size(3), nv = size(3);
    append(soup, letter == 't' ? makers::torus(nu, nv) : makers::klein_bottle(nu, nv));
    return true;
  }
  case 's': {
    const Index rings = size(1), sectors = size(3);
    append(soup, makers::sphere(rings, sectors));
    return true;
  }
  case 'b': {
    const Index pages = size(1), n = size(1);
    append(soup, makers::book(pages, n));
    return true;
  }
  case 'm':
    append(soup, makers::moebius(size(3)));
    return true;
  case 'h':
    append(soup, makers::tetrahedron());
    return true;
  case 'f':
    append(soup, own_face(soup, script));
    return true;
  case 'v':
    for (int axis = 0; axis < 3; ++axis) soup.positions.push_back(script.value());
    return true;
  default:
    return false;
  }
}

bool damage(PolygonSoup& soup, char letter, Script& script) {
  constexpr std::string_view kFaces = "DROVJEWCF", kVertices = "XKZNYM", kAll = "SAT";
  Vandal vandal(soup, script);
  if (kAll.find(letter) != kAll.npos) return vandal.to_all(letter);
  if (kVertices.find(letter) != kVertices.npos) return vandal.to_vertices(letter);
  return kFaces.find(letter) != kFaces.npos && soup.faces.size() < kMostFaces && vandal.to_faces(letter);
}

} // namespace dirichlet::fuzz
