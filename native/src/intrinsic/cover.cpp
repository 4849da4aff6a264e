// SPDX-License-Identifier: GPL-3.0-or-later
#include "intrinsic/cover.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "index.h"
#include "parallel.h"
#include "side_lengths.h"
#include "triangle_lengths.h"
#include "vector3.h"

namespace dirichlet {
namespace {

using HalfEdge = IntrinsicTriangulation::HalfEdge;
constexpr Index kBorder = IntrinsicTriangulation::kBorder;
constexpr std::size_t kGrain = 1 << 13;

/// Whether the faces have it already: the common case.
bool has_one_direction(const Mesh& mesh) {
  const std::span<const Index> corners = mesh.corners();
  const Buffer<Index>& opposite = mesh.connectivity().opposite;
  std::atomic<bool> one = true;
  parallel_chunks(corners.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
      if (opposite[c] == Connectivity::kNonManifold || (opposite[c] >= 0 && corners[c] == corners[at(opposite[c])])) {
        one = false;
        return;
      }
  });
  return one;
}

enum class Turn : std::uint8_t { unknown, kept, reversed };

/// Which faces to reverse so that all have one direction; nothing where that cannot be.
std::optional<Buffer<Turn>> find_direction(const Mesh& mesh) {
  const std::span<const Index> corners = mesh.corners();
  const Buffer<Index>& opposite = mesh.connectivity().opposite;
  Buffer<Turn> turns(at(mesh.face_count()), Turn::unknown);
  std::vector<Index> reached;
  for (Index seed = 0; seed < mesh.face_count(); ++seed) {
    if (turns[at(seed)] != Turn::unknown) continue;
    turns[at(seed)] = Turn::kept;
    for (reached.push_back(seed); !reached.empty();) {
      const Index face = reached.back();
      reached.pop_back();
      const Turn turn = turns[at(face)], other_turn = turn == Turn::kept ? Turn::reversed : Turn::kept;
      for (Index c = 3 * face; c < 3 * face + 3; ++c) {
        const Index across = opposite[at(c)];
        if (across == Connectivity::kNonManifold) return std::nullopt;
        if (across == Connectivity::kBorder) continue;
        const Turn wanted = corners[at(c)] == corners[at(across)] ? other_turn : turn;
        Turn& found = turns[at(across / 3)];
        if (found == Turn::unknown) {
          found = wanted;
          reached.push_back(across / 3);
        } else if (found != wanted)
          return std::nullopt;
      }
    }
  }
  return turns;
}

/// The place of a half-edge in its face when that is reversed.
Index mirrored(Index c) {
  return c + 2 - 2 * (c % 3);
}

/// Every face with its angles, its sides not yet glued. They are those in space wherever lengths are, which of thin
/// triangles would tell them with fewer digits.
Buffer<HalfEdge> make_front(const Mesh& mesh, std::span<const double> in_space, const SideLengths& sides) {
  const std::span<const Index> corners = mesh.corners();
  const auto is_lengthened = [&](std::size_t face) {
    return !sides.lengthened.empty() && std::any_of(&corners[3 * face], &corners[3 * face] + 3,
                                                    [&](Index v) { return sides.lengthened[at(v)] != 0; });
  };
  Buffer<HalfEdge> front(corners.size());
  parallel_chunks(at(mesh.face_count()), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t face = begin; face < end; ++face) {
      const double* const angle = &in_space[3 * face];
      const double* const length = &sides.lengths[3 * face];
      const Sides half_cotangent = is_lengthened(face) ? half_cotangents({length[0], length[1], length[2]})
                                                       : Sides{angle[0], angle[1], angle[2]};
      for (std::size_t k = 0; k < 3; ++k) front[3 * face + k] = {kBorder, corners[3 * face + k], half_cotangent[k]};
    }
  });
  return front;
}

/// The faces of edges that have three or more, in the order in which they lie around them.
class Fans {
 public:
  explicit Fans(const Mesh& mesh) : mesh_(mesh), corners_(mesh.corners()) {
    const Buffer<Index>& opposite = mesh.connectivity().opposite;
    for (Index c = 0; c < static_cast<Index>(corners_.size()); ++c)
      if (opposite[at(c)] == Connectivity::kNonManifold) pages_.push_back(page(c));
    std::sort(pages_.begin(), pages_.end(), [](const Page& a, const Page& b) {
      return std::tie(a.low, a.high, a.tip, a.corner) < std::tie(b.low, b.high, b.tip, b.corner);
    });
  }

  /// Faces of which another one has the same vertices, every time but once.
  [[nodiscard]] std::vector<Index> repeated_faces() const {
    std::vector<Index> faces;
    for (std::size_t i = 1; i < pages_.size(); ++i)
      if (std::tie(pages_[i - 1].low, pages_[i - 1].high, pages_[i - 1].tip) ==
          std::tie(pages_[i].low, pages_[i].high, pages_[i].tip))
        faces.push_back(pages_[i].corner / 3);
    return faces;
  }

  /// Calls visit(corner, following) for every corner and the one whose face comes next when one turns around the edge
  /// from its lower to its higher vertex; itself where it is alone. `leave_out(face)` says what is not there.
  template <class LeaveOut, class Visit>
  void for_neighbours(const LeaveOut& leave_out, const Visit& visit) {
    std::erase_if(pages_, [&](const Page& page) { return leave_out(page.corner / 3); });
    std::sort(pages_.begin(), pages_.end(), [](const Page& a, const Page& b) {
      return std::tie(a.low, a.high, a.angle, a.tip) < std::tie(b.low, b.high, b.angle, b.tip);
    });
    for (std::size_t first = 0, last = 0; first < pages_.size(); first = last) {
      const auto same_edge = [&](const Page& page) {
        return page.low == pages_[first].low && page.high == pages_[first].high;
      };
      while (last < pages_.size() && same_edge(pages_[last])) ++last;
      for (std::size_t i = first; i < last; ++i) visit(pages_[i].corner, pages_[i + 1 < last ? i + 1 : first].corner);
    }
  }

 private:
  struct Page {
    Index low, high, tip; ///< vertices: the edge's, and the face's third
    Index corner;         ///< the half-edge
    double angle;         ///< around the edge, from somewhere
  };

  [[nodiscard]] Page page(Index corner) const {
    const Index next = next_in_triangle(corner), a = corners_[at(corner)], b = corners_[at(next)];
    const Index low = std::min(a, b), high = std::max(a, b), tip = corners_[at(next_in_triangle(next))];
    return {low, high, tip, corner, angle(low, high, tip)};
  }

  /// Of the tip around the axis, seen so that it points at the eye, from a direction that the axis alone decides.
  [[nodiscard]] double angle(Index low, Index high, Index tip) const {
    const Vector3 axis = unit_difference(low, high), arm = unit_difference(low, tip);
    const double x = std::abs(axis.x), y = std::abs(axis.y), z = std::abs(axis.z);
    const Vector3 aside = x <= y && x <= z ? Vector3{1, 0, 0} : y <= z ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
    const Vector3 up = cross(axis, aside);
    return std::atan2(dot(cross(arm, axis), up), dot(arm, up) * std::sqrt(dot(axis, axis)));
  }

  /// From one vertex to another, brought to a length of about 1.
  [[nodiscard]] Vector3 unit_difference(Index from, Index to) const {
    const double *const p = mesh_.positions().data() + 3 * at(from), *const q = mesh_.positions().data() + 3 * at(to);
    const Vector3 d{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    return unit_scale(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)})) * d;
  }

  const Mesh& mesh_;
  std::span<const Index> corners_;
  std::vector<Page> pages_;
};

/// Front and back of every face.
class TwoSheets {
 public:
  TwoSheets(const Mesh& mesh, std::span<const double> in_space, const SideLengths& sides)
      : corners_(mesh.corners()), half_edges_(make_front(mesh, in_space, sides)) {
    Fans fans(mesh);
    remove(fans.repeated_faces());
    add_back();
    const Buffer<Index>& opposite = mesh.connectivity().opposite;
    for_corners([&](Index c) {
      const Index other = opposite[at(c)];
      if (other < c || is_removed(c / 3) || is_removed(other / 3)) return;
      glue(c, other);
      glue(other, c);
    });
    fans.for_neighbours([&](Index face) { return is_removed(face); },
                        [&](Index c, Index following) {
                          if (c != following) glue(c, following);
                        });
  }

  [[nodiscard]] Buffer<HalfEdge> half_edges() && { return std::move(half_edges_); }

 private:
  template <class Visit>
  void for_corners(const Visit& visit) const {
    parallel_chunks(corners_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (auto c = static_cast<Index>(begin); c < static_cast<Index>(end); ++c) visit(c);
    });
  }

  void remove(const std::vector<Index>& faces) {
    for (const Index face : faces)
      for (std::size_t k = 0; k < 3; ++k) half_edges_[3 * at(face) + k].half_cotangent = 0;
  }
  /// No triangle has three right angles.
  [[nodiscard]] bool is_removed(Index face) const {
    const HalfEdge* const side = &half_edges_[3 * at(face)];
    return side[0].half_cotangent == 0 && side[1].half_cotangent == 0 && side[2].half_cotangent == 0;
  }

  /// The back of side k of a face is side 2 - k of another, so that both turn the right way.
  [[nodiscard]] Index back(Index c) const { return static_cast<Index>(corners_.size()) + mirrored(c); }

  void add_back() {
    half_edges_.resize(2 * corners_.size());
    for_corners([this](Index c) {
      half_edges_[at(back(c))] = half_edges_[at(c)];
      half_edges_[at(back(c))].tail = corners_[at(next_in_triangle(c))];
    });
  }

  /// The half-edge of the two sides of a face that runs from the edge's lower vertex to its higher one, or back.
  [[nodiscard]] Index running(Index c, bool up) const {
    return (corners_[at(c)] < corners_[at(next_in_triangle(c))]) == up ? c : back(c);
  }

  /// The half-edge that runs up has its face on the left, and sees what comes when one turns around the edge.
  void glue(Index c, Index following) {
    const Index one = running(c, true), other = running(following, false);
    half_edges_[at(one)].twin = other;
    half_edges_[at(other)].twin = one;
  }

  std::span<const Index> corners_;
  Buffer<HalfEdge> half_edges_;
};

/// The mesh itself, some of its faces reversed.
/// \param turns  (F,) or none where no face is
Buffer<HalfEdge> one_sheet(const Mesh& mesh, std::span<const double> in_space, const SideLengths& sides,
                           const Buffer<Turn>& turns) {
  Buffer<HalfEdge> half_edges = make_front(mesh, in_space, sides);
  const std::span<const Index> corners = mesh.corners();
  const Buffer<Index>& opposite = mesh.connectivity().opposite;
  const auto place = [&](Index c) { return !turns.empty() && turns[at(c / 3)] == Turn::reversed ? mirrored(c) : c; };
  parallel_chunks(at(mesh.face_count()), kGrain, [&](std::size_t begin, std::size_t end) {
    for (auto first = static_cast<Index>(3 * begin); first < static_cast<Index>(3 * end); first += 3) {
      if (place(first) != first) std::swap(half_edges[at(first)], half_edges[at(first) + 2]);
      for (Index c = first; c < first + 3; ++c) {
        HalfEdge& half_edge = half_edges[at(place(c))];
        half_edge.twin = opposite[at(c)] >= 0 ? place(opposite[at(c)]) : kBorder;
        half_edge.tail = corners[at(place(first) == first ? c : next_in_triangle(c))];
      }
    }
  });
  return half_edges;
}

} // namespace

Cover cover(const Mesh& triangles, std::span<const double> half_cotangents) {
  const SideLengths sides = mollified_sides(triangles);
  const auto one = [&](const Buffer<Turn>& turns) {
    return Cover{IntrinsicTriangulation(one_sheet(triangles, half_cotangents, sides, turns)), 1, sides.thickened};
  };
  if (has_one_direction(triangles)) return one({});
  if (const auto turns = find_direction(triangles)) return one(*turns);
  return {IntrinsicTriangulation(TwoSheets(triangles, half_cotangents, sides).half_edges()), 2, sides.thickened};
}

} // namespace dirichlet
