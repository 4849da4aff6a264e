// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/weak_links.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

#include "dirichlet/error.h"
#include "for_row.h"
#include "index.h"
#include "message.h"
#include "parallel.h"
#include "union_find.h"

namespace dirichlet {
namespace {

constexpr std::size_t kGrain = 1 << 14; // rows

struct WeightRange {
  double least = std::numeric_limits<double>::infinity(), largest = 0; ///< sizes of those that are not 0
  bool is_laplacian = true;                                            ///< every row sums to 0
};

/// One row taken into account. Its sum may be as far from 0 as adding up so many numbers can make it.
void widen(const SparseMatrix& K, Index i, WeightRange& range) {
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  double count = 0, sum = 0, sizes = 0;
  for_row(K, i, [&](Index j, double k) {
    ++count;
    sum += k;
    sizes += std::abs(k);
    if (j != i && k != 0) {
      range.largest = std::max(range.largest, std::abs(k));
      range.least = std::min(range.least, std::abs(k));
    }
  });
  range.is_laplacian = range.is_laplacian && std::abs(sum) <= kRounding * count * sizes;
}

WeightRange weight_range(const SparseMatrix& K) {
  WeightRange all;
  std::mutex mutex;
  parallel_chunks(at(static_cast<Index>(K.rows())), kGrain, [&](std::size_t begin, std::size_t end) {
    WeightRange some;
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) widen(K, i, some);
    const std::scoped_lock lock(mutex);
    all.largest = std::max(all.largest, some.largest);
    all.least = std::min(all.least, some.least);
    all.is_laplacian = all.is_laplacian && some.is_laplacian;
  });
  return all;
}

/// Makes weights no larger than kMost, and rows sum to 0 again.
/// \returns  whether some row had several that were larger, and differed
bool level_weights(SparseMatrix& K) {
  constexpr double kMost = 0x1p26, kAlike = 1 + 1e-8;
  const WeightRange range = weight_range(K);
  if (!range.is_laplacian || range.largest <= kMost) return false;
  std::atomic<bool> levelled = false;
  parallel_chunks(at(static_cast<Index>(K.rows())), kGrain, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      double sum = 0, *diagonal = nullptr;
      double least = std::numeric_limits<double>::infinity(), largest = 0; // of those above kMost
      for (Index e = K.outerIndexPtr()[i]; e < K.outerIndexPtr()[i + 1]; ++e) {
        double& k = K.valuePtr()[e];
        if (K.innerIndexPtr()[e] == i) {
          diagonal = &k;
          continue;
        }
        if (const double size = std::abs(k); size > kMost) {
          least = std::min(least, size);
          largest = std::max(largest, size);
        }
        sum += k = std::clamp(k, -kMost, kMost);
      }
      if (diagonal != nullptr) *diagonal = 0 - sum;
      if (largest > kAlike * least) levelled = true;
    }
  });
  return levelled;
}

} // namespace

bool has_uneven_weights(const SparseMatrix& K) {
  constexpr double kUneven = 1e-4;
  const WeightRange range = weight_range(K);
  return range.is_laplacian && range.least < kUneven * range.largest;
}

bool has_weak_links(const SparseMatrix& K, double ratio) {
  const WeightRange range = weight_range(K);
  const double weak = ratio * range.largest;
  if (!range.is_laplacian || range.least >= weak) return false;
  const auto n = static_cast<Index>(K.rows());
  UnionFind parts(n);
  const auto any_edge = [&](bool strong, const auto& visit) {
    bool any = false;
    for (Index i = 0; i < n && !any; ++i)
      for_row(K, i, [&](Index j, double k) {
        if (j < i && k != 0 && (std::abs(k) >= weak) == strong) any = any || visit(i, j);
      });
    return any;
  };
  any_edge(true, [&](Index i, Index j) {
    parts.unite(i, j);
    return false;
  });
  return any_edge(false, [&](Index i, Index j) { return parts.find(i) != parts.find(j); });
}

bool limit_weights(SparseMatrix& K, const char* method) {
  constexpr double kSeen = 1e-8, kTooWeak = 1e-13; // single precision begins to see the first
  const bool levelled = level_weights(K);
  if (has_weak_links(K, kTooWeak))
    throw SolverError(message("some weights are over 1e13 times others, as across very thin faces, and ", method,
                              " would lose as many digits; the direct method in float64 is made for them"));
  return has_weak_links(K, kSeen) || levelled;
}

} // namespace dirichlet
