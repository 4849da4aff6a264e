// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "index.h"

namespace dirichlet::fuzz {
namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

std::vector<Range> painted_ranges(const Components& pieces, const Painting& painting) {
  std::vector<Range> ranges(at(pieces.count));
  for (std::size_t c = 0; c < painting.vertices.size(); ++c) {
    auto& [low, high] = ranges[at(pieces.label[at(painting.vertices[c])])];
    low = std::min(low, painting.values[c]);
    high = std::max(high, painting.values[c]);
  }
  return ranges;
}

bool keeps_range(Laplacian laplacian) {
  return laplacian != Laplacian::cotangent && laplacian != Laplacian::polygon;
}

} // namespace

void expect_result_or_refusal(const std::function<void()>& body) {
  try {
    body();
  } catch (const DirichletError& error) {
    const std::string sentence = error.what();
    EXPECT_FALSE(sentence.empty());
    EXPECT_TRUE(std::ranges::none_of(sentence, [](unsigned char c) { return c < ' ' || c == 127; })) << sentence;
  }
}

void expect_lawful_field(const Mesh& mesh, const Problem& problem, const Field& field) {
  const Painting& painting = problem.painting;
  for (std::size_t c = 0; c < painting.vertices.size(); ++c)
    EXPECT_EQ(field.values(painting.vertices[c], 0), painting.values[c]) // equal zeros may differ in their sign
        << "painted vertex " << painting.vertices[c];

  const Components pieces = mesh.components();
  const std::vector<Range> ranges = painted_ranges(pieces, painting);
  const double slack = keeps_range(problem.laplacian) ? 0 : field.report.farthest_outside;
  Index undefined = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const double value = field.values(v, 0);
    const auto& [low, high] = ranges[at(pieces.label[at(v)])];
    const bool painted = low <= high;
    EXPECT_EQ(std::isnan(value), !painted) << "vertex " << v;
    EXPECT_FALSE(std::isinf(value)) << "vertex " << v;
    if (painted && problem.source.empty()) // a difference, since that is what the report has rounded
      EXPECT_LE(std::max(low - value, value - high), slack) << "vertex " << v << ": " << value;
    undefined += painted ? 0 : 1;
  }
  EXPECT_EQ(field.report.undefined, undefined);
}

} // namespace dirichlet::fuzz

/// libFuzzer's, before the first input.
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  GTEST_FLAG_SET(break_on_failure, true);
  std::signal(SIGTRAP, [](int) { std::abort(); }); // which libFuzzer takes for a finding, and keeps the input
  return 0;
}
