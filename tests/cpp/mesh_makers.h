// SPDX-License-Identifier: GPL-3.0-or-later
// The meshes that tests are made of; closed forms where a law needs one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "dirichlet/mesh.h"

namespace dirichlet::makers {

/// Faces as lists of vertices, easy to write down and to damage.
struct PolygonSoup {
  std::vector<double> positions;
  std::vector<std::vector<Index>> faces;
};

inline std::unique_ptr<Mesh> make_mesh(const PolygonSoup& soup) {
  std::vector<Index> offsets{0};
  std::vector<Index> corners;
  for (const auto& face : soup.faces) {
    corners.insert(corners.end(), face.begin(), face.end());
    offsets.push_back(static_cast<Index>(corners.size()));
  }
  return std::make_unique<Mesh>(std::vector<double>(soup.positions), offsets, corners);
}

/// (nx + 1) × (ny + 1) vertices at integer places of the plane z = 0; vertex (i, j) is i + j (nx + 1). Quads, or
/// triangles cut along the diagonal from (i, j) to (i + 1, j + 1). Seen from +z it turns counter-clockwise.
inline PolygonSoup grid(Index nx, Index ny, bool triangles = true) {
  PolygonSoup soup;
  for (Index j = 0; j <= ny; ++j)
    for (Index i = 0; i <= nx; ++i)
      soup.positions.insert(soup.positions.end(), {static_cast<double>(i), static_cast<double>(j), 0.0});
  for (Index j = 0; j < ny; ++j)
    for (Index i = 0; i < nx; ++i) {
      const Index a = i + j * (nx + 1), b = a + 1, d = a + nx + 1, c = d + 1;
      if (triangles) {
        soup.faces.push_back({a, b, c});
        soup.faces.push_back({a, c, d});
      } else
        soup.faces.push_back({a, b, c, d});
    }
  return soup;
}

/// A torus of nu × nv quads or 2 nu nv triangles, outward orientation; vertex (i, j) is i + j nu, i around the axis.
inline PolygonSoup torus(Index nu, Index nv, bool triangles = true, double major = 2.0, double minor = 0.7) {
  PolygonSoup soup;
  for (Index j = 0; j < nv; ++j)
    for (Index i = 0; i < nu; ++i) {
      const double u = 2 * std::numbers::pi * i / nu, v = 2 * std::numbers::pi * j / nv;
      const double r = major + minor * std::cos(v);
      soup.positions.insert(soup.positions.end(), {r * std::cos(u), r * std::sin(u), minor * std::sin(v)});
    }
  for (Index j = 0; j < nv; ++j)
    for (Index i = 0; i < nu; ++i) {
      const Index a = i + j * nu, b = (i + 1) % nu + j * nu, c = (i + 1) % nu + (j + 1) % nv * nu,
                  d = i + (j + 1) % nv * nu;
      if (triangles) {
        soup.faces.push_back({a, b, c});
        soup.faces.push_back({a, c, d});
      } else
        soup.faces.push_back({a, b, c, d});
    }
  return soup;
}

/// The sphere of radius 1 in triangles: poles 0 and last, `rings` rings of `sectors` between them, outward orientation.
inline PolygonSoup sphere(Index rings, Index sectors) {
  PolygonSoup soup;
  soup.positions = {0, 0, 1};
  for (Index j = 0; j < rings; ++j)
    for (Index i = 0; i < sectors; ++i) {
      const double theta = std::numbers::pi * (j + 1) / (rings + 1), phi = 2 * std::numbers::pi * i / sectors;
      soup.positions.insert(soup.positions.end(),
                            {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
    }
  soup.positions.insert(soup.positions.end(), {0, 0, -1});
  const auto at = [&](Index j, Index i) { return 1 + j * sectors + i % sectors; };
  const Index south = 1 + rings * sectors;
  for (Index i = 0; i < sectors; ++i) {
    soup.faces.push_back({0, at(0, i), at(0, i + 1)});
    for (Index j = 0; j + 1 < rings; ++j) {
      soup.faces.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1)});
      soup.faces.push_back({at(j, i), at(j + 1, i + 1), at(j, i + 1)});
    }
    soup.faces.push_back({at(rings - 1, i), south, at(rings - 1, i + 1)});
  }
  return soup;
}

/// A band of n quads with a half twist: one border loop, no outside.
inline PolygonSoup moebius(Index n) {
  PolygonSoup soup;
  for (Index i = 0; i < n; ++i) {
    const double u = 2 * std::numbers::pi * i / n;
    for (const double s : {-0.4, 0.4})
      soup.positions.insert(soup.positions.end(), {(1 + s * std::cos(u / 2)) * std::cos(u),
                                                   (1 + s * std::cos(u / 2)) * std::sin(u), s * std::sin(u / 2)});
  }
  for (Index i = 0; i + 1 < n; ++i) soup.faces.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  soup.faces.push_back({2 * n - 2, 1, 0, 2 * n - 1});
  return soup;
}

/// A closed surface without an outside, nu × nv quads: a torus whose seam is joined upside down.
inline PolygonSoup klein_bottle(Index nu, Index nv) {
  PolygonSoup soup;
  for (Index j = 0; j < nv; ++j)
    for (Index i = 0; i < nu; ++i) {
      const double u = 2 * std::numbers::pi * j / nv, v = 2 * std::numbers::pi * i / nu;
      const double r = 2 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
      soup.positions.insert(soup.positions.end(), {r * std::cos(u), r * std::sin(u),
                                                   std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v)});
    }
  const auto at = [&](Index i, Index j) { return j < nv ? i % nu + j * nu : (2 * nu - i) % nu; };
  for (Index j = 0; j < nv; ++j)
    for (Index i = 0; i < nu; ++i) soup.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return soup;
}

/// Pages of n quads each around the spine x = y = 0: every spine edge has as many faces as there are pages. Vertices
/// 0 … n are the spine, from z = 0 to z = n.
inline PolygonSoup book(Index pages, Index n) {
  PolygonSoup soup;
  for (Index page = -1; page < pages; ++page)
    for (Index k = 0; k <= n; ++k) {
      const double angle = 2 * std::numbers::pi * page / pages, r = page < 0 ? 0 : 1;
      soup.positions.insert(soup.positions.end(), {r * std::cos(angle), r * std::sin(angle), static_cast<double>(k)});
    }
  for (Index page = 0; page < pages; ++page)
    for (Index k = 0; k < n; ++k) {
      const Index outside = (page + 1) * (n + 1) + k;
      soup.faces.push_back({k, outside, outside + 1, k + 1});
    }
  return soup;
}

/// The same surface many times over, piece after piece.
inline PolygonSoup copies(const PolygonSoup& soup, Index count) {
  PolygonSoup all;
  for (Index k = 0; k < count; ++k) {
    const auto shift = static_cast<Index>(all.positions.size() / 3);
    all.positions.insert(all.positions.end(), soup.positions.begin(), soup.positions.end());
    for (auto face : soup.faces) {
      for (Index& v : face) v += shift;
      all.faces.push_back(std::move(face));
    }
  }
  return all;
}

/// Turns over every `step`-th face.
inline PolygonSoup turned_over(PolygonSoup soup, std::size_t step = 1) {
  for (std::size_t f = 0; f < soup.faces.size(); f += step) std::reverse(soup.faces[f].begin(), soup.faces[f].end());
  return soup;
}

inline PolygonSoup tetrahedron() {
  return {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

} // namespace dirichlet::makers
