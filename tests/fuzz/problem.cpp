// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem.h"

#include <algorithm>
#include <array>

#include "damage.h"
#include "index.h"

namespace dirichlet::fuzz {
namespace {

void choose_method(SolverOptions& options, Index number) {
  options.method = number == 2 ? Method::multigrid : Method::direct;
  options.precision = number == 1 ? Precision::float32 : Precision::float64;
}

} // namespace

bool paint(Painting& painting, Index vertex_count, char letter, Script& script) {
  if (letter != 'p' && letter != 'r') return false;
  const Index first = script.number(vertex_count + 1);
  const Index count = letter == 'p' ? 1 : std::min(script.number(64), vertex_count - first);
  const double value = script.value();
  for (Index v = first; v < first + count; ++v) {
    painting.vertices.push_back(v);
    painting.values.push_back(value);
  }
  return true;
}

Laplacian read_laplacian(Script& script) {
  constexpr std::array kLaplacians{Laplacian::graph, Laplacian::cotangent, Laplacian::intrinsic_delaunay,
                                   Laplacian::polygon, Laplacian::automatic};
  return kLaplacians[at(script.number(kLaplacians.size()))];
}

Problem read_problem(Script script) {
  Problem problem;
  while (!script.at_end()) {
    const char letter = script.letter();
    const auto count = static_cast<Index>(problem.soup.positions.size() / 3);
    if (add_surface(problem.soup, letter, script) || damage(problem.soup, letter, script) ||
        paint(problem.painting, count, letter, script))
      continue;
    switch (letter) {
    case 'l':
      problem.levels.push_back(script.value());
      break;
    case 'e':
      problem.even = script.number(40);
      break;
    case 'a':
      problem.equal = script.number(10);
      break;
    case 'd':
      choose_method(problem.options, script.number(3));
      break;
    case 'L':
      problem.laplacian = read_laplacian(script);
      break;
    case 'o':
      problem.source.resize(at(count));
      if (count > 0) problem.source[at(script.number(count))] = script.value();
      break;
    default:
      break;
    }
  }
  return problem;
}

} // namespace dirichlet::fuzz
