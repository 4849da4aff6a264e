// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <new>
#include <numeric>

#include <gtest/gtest.h>

#include "denied_memory.h"
#include "mesh_makers.h"
#include "solver/factor.h"

namespace dirichlet {
namespace {

constexpr std::int64_t kPlenty = std::int64_t{1} << 40;

struct Torus {
  SparseMatrix K;
  std::shared_ptr<const SymbolicFactor> symbolic;
  std::shared_ptr<const OrderedMatrix> matrix;

  explicit Torus(int size) : K(graph_stiffness(*makers::make_mesh(makers::torus(size, size)))) {
    std::vector<Index> order(static_cast<std::size_t>(K.rows()));
    std::iota(order.begin(), order.end(), 0);
    const Graph graph{{K.outerIndexPtr(), order.size() + 1}, {K.innerIndexPtr(), std::size_t(K.nonZeros())}};
    symbolic = std::make_shared<const SymbolicFactor>(analyse(graph, order));
    matrix = std::make_shared<const OrderedMatrix>(order_matrix(K, symbolic->order));
  }

  std::vector<double> solve() const {
    Mask fixed(symbolic->order.size(), 0);
    fixed[0] = 1;
    Factor<double> factor(symbolic, matrix, Pivots::subtracted, kPlenty);
    factor.factor(fixed);
    std::vector<double> x(fixed.size(), 1);
    factor.solve(x, 1);
    return x;
  }
};

TEST(FactorMemory, is_known_before_it_is_allocated) {
  const Torus torus(60);
  for (const std::int64_t most_kept : {std::int64_t{0}, kPlenty}) {
    const std::int64_t told = Factor<float>::bytes_needed(*torus.symbolic, torus.K.nonZeros(), most_kept);
    const std::int64_t before = bytes_asked_for();
    const Factor<float> factor(torus.symbolic, torus.matrix, Pivots::subtracted, most_kept);
    const std::int64_t asked_for = bytes_asked_for() - before; // with what is only used while it is set up
    EXPECT_EQ(factor.bytes(), told);
    const std::int64_t known = 8 * torus.symbolic->size() + 4 * std::int64_t(torus.symbolic->rows.size()) +
                               12 * torus.K.nonZeros(); // the matrix and the symbolic factor, most of them
    EXPECT_NEAR(static_cast<double>(asked_for + known), static_cast<double>(told), 0.1 * static_cast<double>(told));
  }
}

TEST(FactorMemory, denied_anywhere_is_a_bad_alloc_and_harms_nobody) {
  const Torus torus(64); // large enough for two threads
  const std::vector<double> expected = torus.solve();
  std::int64_t granted = 0;
  for (bool denied = true; denied; ++granted) {
    std::vector<double> x;
    {
      const DeniedMemory deny(granted, DeniedMemory::kAll);
      try {
        x = torus.solve();
      } catch (const std::bad_alloc&) { // a thread that there was no memory for is done without
      }
      denied = DeniedMemory::happened();
    }
    EXPECT_TRUE(x.empty() || x == expected);
  }
  EXPECT_GT(granted, 10);
}

} // namespace
} // namespace dirichlet
