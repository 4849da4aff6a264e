// SPDX-License-Identifier: GPL-3.0-or-later
#include "painting_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "dirichlet/error.h"
#include "index.h"
#include "message.h"

namespace dirichlet {
namespace {

void check_finite(std::span<const double> numbers, const std::string& what, const char* where) {
  const auto bad = [](double x) { return !std::isfinite(x); };
  const auto first = std::find_if(numbers.begin(), numbers.end(), bad);
  if (first != numbers.end())
    throw InputError(message(what, " at ", where, ' ', first - numbers.begin(), " is ", *first,
                             and_more(std::count_if(first, numbers.end(), bad) - 1, where)));
}

} // namespace

void check_painted(Index vertex_count, std::span<const Index> painted) {
  if (painted.empty()) throw InputError("no vertex is painted, so the field has no values to start from");
  const auto bad = [=](Index v) { return v < 0 || v >= vertex_count; };
  const auto first = std::find_if(painted.begin(), painted.end(), bad);
  if (first != painted.end())
    throw InputError(message("painted vertex ", *first, " (at place ", first - painted.begin(),
                             ") is not one of the vertices 0 to ", vertex_count - 1,
                             and_more(std::count_if(first, painted.end(), bad) - 1, "place")));
}

std::vector<std::array<Index, 2>> find_repeats(Index vertex_count, std::span<const Index> painted) {
  std::vector<std::uint8_t> seen(at(vertex_count), 0);
  bool any = false;
  for (const Index v : painted) any |= std::exchange(seen[at(v)], 1) != 0;
  std::vector<std::array<Index, 2>> repeats;
  if (!any) return repeats;
  std::vector<Index> first(at(vertex_count), -1);
  for (Index c = 0; c < static_cast<Index>(painted.size()); ++c) {
    Index& place = first[at(painted[at(c)])];
    if (place < 0)
      place = c;
    else
      repeats.push_back({c, place});
  }
  return repeats;
}

void check_values(std::span<const Index> painted, const std::vector<std::array<Index, 2>>& repeats,
                  const Eigen::Ref<const Eigen::MatrixXd>& values) {
  if (values.cols() < 1) throw InputError("no column of values was given");
  if (values.rows() != static_cast<Eigen::Index>(painted.size()))
    throw InputError(message(counted(values.rows(), "value"), values.rows() == 1 ? " was" : " were", " given for ",
                             counted(painted.size(), "painted vertex")));
  for (Eigen::Index column = 0; column < values.cols(); ++column)
    check_finite({values.col(column).data(), painted.size()},
                 values.cols() == 1 ? "the painted value" : message("in column ", column, " the painted value"),
                 "place");
  const auto differs = [&](const std::array<Index, 2>& repeat) {
    return values.row(repeat[0]) != values.row(repeat[1]);
  };
  const auto clash = std::find_if(repeats.begin(), repeats.end(), differs);
  if (clash == repeats.end()) return;
  const auto& [again, first] = *clash;
  Eigen::Index column = 0;
  while (values(again, column) == values(first, column)) ++column;
  throw InputError(message("vertex ", painted[at(again)], " is painted with ", exactly(values(first, column)),
                           " (at place ", first, ") and with ", exactly(values(again, column)), " (at place ", again,
                           ")", and_more(std::count_if(clash, repeats.end(), differs) - 1, "place")));
}

void check_source(Index vertex_count, std::span<const double> source) {
  if (!source.empty() && source.size() != at(vertex_count))
    throw InputError(message("the source has ", counted(source.size(), "number"), ", but the mesh ",
                             counted(vertex_count, "vertex")));
  check_finite(source, "the source", "vertex");
}

} // namespace dirichlet
