// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <tuple>
#include <utility>

#include "arrays.h"
#include "dirichlet/isolines.h"

namespace dirichlet::bindings {

/// The arrays of Isolines, in their order, by the names that Python gives them; the vectors move into them.
inline py::dict to_dict(Isolines&& lines) {
  const auto count = static_cast<py::ssize_t>(lines.points.size()) / 3;
  const auto on_edges = static_cast<py::ssize_t>(lines.t.size());
  using namespace py::literals;
  return py::dict("points"_a = to_numpy(std::move(lines.points), {count, 3}),
                  "edges"_a = to_numpy(std::move(lines.edges), {on_edges, 2}), "t"_a = to_numpy(std::move(lines.t)),
                  "offsets"_a = to_numpy(std::move(lines.offsets)),
                  "closed"_a = to_numpy(std::move(lines.closed)).attr("view")("bool"),
                  "level"_a = to_numpy(std::move(lines.level)), "length"_a = to_numpy(std::move(lines.length)));
}

/// The same from Python, `closed` as bytes.
using LineArrays = std::tuple<Array<double>, Array<Index>, Array<double>, Array<Index>, Array<std::uint8_t>,
                              Array<Index>, Array<double>>;

inline Isolines from_arrays(const LineArrays& arrays) {
  const auto copy = [](const auto& array, auto& to) { to.assign(array.data(), array.data() + array.size()); };
  Isolines lines;
  copy(std::get<0>(arrays), lines.points);
  copy(std::get<1>(arrays), lines.edges);
  copy(std::get<2>(arrays), lines.t);
  copy(std::get<3>(arrays), lines.offsets);
  copy(std::get<4>(arrays), lines.closed);
  copy(std::get<5>(arrays), lines.level);
  copy(std::get<6>(arrays), lines.length);
  return lines;
}

} // namespace dirichlet::bindings
