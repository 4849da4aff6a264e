// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_numbers.h"

#include <cmath>
#include <cstddef>

#include "parallel.h"

namespace dirichlet {
namespace {

/// A binary search in which only a factor depends on the outcome: a branch would be mispredicted every other time.
Index level_number(std::span<const double> levels, double value) {
  if (std::isnan(value)) return kUndefined;
  const double* base = levels.data();
  for (std::size_t size = levels.size(); size > 0;) {
    const std::size_t half = (size + 1) / 2;
    base += static_cast<std::size_t>(base[half - 1] <= value) * half;
    size -= half;
  }
  return static_cast<Index>(base - levels.data());
}

} // namespace

std::vector<Index> level_numbers(std::span<const double> field, std::span<const double> levels) {
  std::vector<Index> numbers(field.size());
  parallel_chunks(field.size(), std::size_t{1} << 15, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) numbers[v] = level_number(levels, field[v]);
  });
  return numbers;
}

} // namespace dirichlet
