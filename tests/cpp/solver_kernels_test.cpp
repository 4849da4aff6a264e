// SPDX-License-Identifier: GPL-3.0-or-later
// Every kernel of every instruction set of this machine against plain loops. What the kernels may read but must not
// use (strict upper triangles) and must not touch (rows between the matrix and ld, other columns) is filled with NaN.
#include "solver/dense_kernels.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "dirichlet/error.h"

namespace dirichlet {
namespace {

template <class Real>
struct Matrix {
  Index rows = 0, columns = 0, ld = 0;
  std::vector<Real> entry; ///< NaN outside rows

  Matrix(Index m, Index n, Index gap)
      : rows(m), columns(n), ld(m + gap), entry(static_cast<std::size_t>(ld) * static_cast<std::size_t>(n)) {
    std::fill(entry.begin(), entry.end(), std::numeric_limits<Real>::quiet_NaN());
  }
  Real& operator()(Index i, Index j) { return entry[index(i, j)]; }
  Real operator()(Index i, Index j) const { return entry[index(i, j)]; }
  [[nodiscard]] std::size_t index(Index i, Index j) const {
    return static_cast<std::size_t>(i) + static_cast<std::size_t>(j) * static_cast<std::size_t>(ld);
  }
};

template <class Real>
Matrix<Real> random_matrix(Index m, Index n, Index gap = 0) {
  std::mt19937 generator(static_cast<unsigned>(m * 1000 + n));
  std::uniform_real_distribution<double> number(-1, 1);
  Matrix<Real> A(m, n, gap);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < m; ++i) A(i, j) = static_cast<Real>(number(generator));
  return A;
}

/// The lower part of a panel whose first columns are those of a positive definite matrix.
template <class Real>
Matrix<Real> random_panel(Index m, Index w, Index gap) {
  Matrix<Real> A = random_matrix<Real>(m, w, gap);
  for (Index j = 0; j < w; ++j) {
    for (Index i = 0; i < j; ++i) A(i, j) = std::numeric_limits<Real>::quiet_NaN();
    A(j, j) = static_cast<Real>(m + 1);
  }
  return A;
}

template <class Real>
Matrix<double> plain_factor(const Matrix<Real>& A) {
  Matrix<double> L(A.rows, A.columns, 0);
  for (Index j = 0; j < A.columns; ++j)
    for (Index i = j; i < A.rows; ++i) {
      double sum = A(i, j);
      for (Index p = 0; p < j; ++p) sum -= L(i, p) * L(j, p);
      L(i, j) = i == j ? std::sqrt(sum) : sum / L(j, j);
    }
  return L;
}

/// Lower triangles agree, and NaN is where it was.
template <class Real, class Expected>
void expect_lower(const Matrix<Real>& actual, const Matrix<Expected>& expected, double tolerance, const char* what) {
  double worst = 0;
  bool leaked = false;
  for (Index j = 0; j < actual.columns; ++j)
    for (Index i = j; i < actual.ld; ++i) {
      if (i >= actual.rows)
        leaked |= !std::isnan(actual(i, j));
      else
        worst = std::max(worst, std::abs(static_cast<double>(actual(i, j)) - static_cast<double>(expected(i, j))));
      if (i < actual.rows && std::isnan(actual(i, j))) worst = std::numeric_limits<double>::infinity();
    }
  EXPECT_LE(worst, tolerance) << what << " of " << actual.rows << " x " << actual.columns << ", ld " << actual.ld;
  EXPECT_FALSE(leaked) << what << " wrote below its matrix";
}

std::vector<InstructionSet> supported_sets() {
  std::vector<InstructionSet> sets{InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512};
  std::erase_if(sets, [](InstructionSet set) { return !is_supported(set); });
  return sets;
}

const auto serially = [](Index count, const auto& f) {
  for (Index i = 0; i < count; ++i) f(i);
};
const auto backwards_in_threads = [](Index count, const auto& f) {
  std::vector<std::thread> threads;
  for (Index i = count; i-- > 0;) threads.emplace_back([&f, i] { f(i); });
  for (auto& thread : threads) thread.join();
};

// Around the vectors, the tiles, the blocks of columns and the rows finished together.
const std::vector<Index> kWidths{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 15, 16, 17, 23, 31, 32};
const std::vector<Index> kHeights{0, 1, 2, 3, 4, 5, 7, 8, 9, 11, 12, 13, 15, 16, 17, 24, 31, 33, 49, 100, 121, 250};

template <class Real>
class SolverKernels : public testing::Test {
 protected:
  static constexpr Real* kNone = nullptr;
  static constexpr double kEpsilon = std::numeric_limits<Real>::epsilon();
  template <class F>
  void for_sets(const F& f) {
    for (const InstructionSet set : supported_sets()) {
      SCOPED_TRACE("instruction set " + std::to_string(static_cast<int>(set)));
      f(dense_kernels<Real>(set));
    }
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(SolverKernels, Reals);

TYPED_TEST(SolverKernels, factor_a_panel_like_plain_loops) {
  this->for_sets([&](const auto& kernels) {
    for (const Index w : kWidths)
      for (const Index r : kHeights)
        for (const Index gap : {0, 3}) {
          Matrix<TypeParam> A = random_panel<TypeParam>(w + r, w, gap);
          const Matrix<double> L = plain_factor(A);
          ASSERT_EQ(kernels.factor_panel(A.entry.data(), A.rows, w, A.ld, nullptr), w);
          expect_lower(A, L, 16 * this->kEpsilon * std::sqrt(w + r + 1), "panel");
        }
  });
}

TYPED_TEST(SolverKernels, name_the_first_pivot_that_is_not_a_positive_normal_number) {
  using Limits = std::numeric_limits<TypeParam>;
  this->for_sets([&](const auto& kernels) {
    for (const TypeParam pivot : {TypeParam{0}, TypeParam{-1}, Limits::quiet_NaN(), Limits::infinity(),
                                  -Limits::infinity(), Limits::denorm_min()})
      for (const Index w : {1, 3, 4, 13, 40})
        for (Index bad = 0; bad < w; ++bad) {
          Matrix<TypeParam> A = random_panel<TypeParam>(w + 5, w, 0);
          for (Index j = 0; j < bad; ++j) A(bad, j) = 0; // nothing is subtracted from the bad pivot
          for (Index j = bad; j < w; ++j) A(j, j) = pivot;
          EXPECT_EQ(factor_panel(kernels, A.entry.data(), A.rows, w, A.ld, this->kNone, 1, serially), bad);
        }
  });
}

TYPED_TEST(SolverKernels, find_an_indefinite_panel_that_has_a_positive_diagonal) {
  this->for_sets([](const auto& kernels) {
    Matrix<TypeParam> A = random_panel<TypeParam>(30, 20, 0);
    A(17, 11) = 100;
    EXPECT_EQ(kernels.factor_panel(A.entry.data(), A.rows, A.columns, A.ld, nullptr), 17);
  });
}

/// C (r, r) − A Aᵀ in doubles.
template <class Real>
Matrix<double> plain_update(const Matrix<Real>& C, const Matrix<Real>& A) {
  Matrix<double> result(C.rows, C.columns, 0);
  for (Index j = 0; j < C.columns; ++j)
    for (Index i = j; i < C.rows; ++i) {
      double sum = C(i, j);
      for (Index p = 0; p < A.columns; ++p) sum -= static_cast<double>(A(i, p)) * A(j, p);
      result(i, j) = sum;
    }
  return result;
}

template <class Real>
Matrix<Real> random_lower(Index r, Index gap) {
  Matrix<Real> C = random_matrix<Real>(r, r, gap);
  for (Index j = 0; j < r; ++j)
    for (Index i = 0; i < j; ++i) C(i, j) = std::numeric_limits<Real>::quiet_NaN();
  return C;
}

TYPED_TEST(SolverKernels, update_a_lower_triangle_like_plain_loops) {
  std::vector<std::pair<Index, Index>> sizes{{96, 191}, {97, 192}, {200, 193}, {191, 400}, {301, 24}};
  for (const Index w : kWidths)
    for (const Index r : kHeights) sizes.emplace_back(r, w);
  for (const auto& size : sizes)
    for (const Index gap : {0, 5}) {
      const Index r = size.first, w = size.second;
      const Matrix<TypeParam> A = random_matrix<TypeParam>(r, w, gap), before = random_lower<TypeParam>(r, gap);
      const Matrix<double> expected = plain_update(before, A);
      this->for_sets([&](const auto& kernels) {
        Matrix<TypeParam> C = before;
        kernels.rank_update(C.entry.data(), C.ld, A.entry.data(), A.ld, r, w, 0, r);
        expect_lower(C, expected, 4 * this->kEpsilon * (w + 1), "triangle");
      });
    }
}

TYPED_TEST(SolverKernels, give_the_same_bits_however_the_columns_are_split_and_touch_no_other) {
  for (const auto& size : {std::pair<Index, Index>{6, 3}, {29, 17}, {230, 50}, {150, 300}})
    this->for_sets([&](const auto& kernels) {
      const Index r = size.first, w = size.second;
      const Matrix<TypeParam> A = random_matrix<TypeParam>(r, w);
      const Matrix<TypeParam> before = random_lower<TypeParam>(r, 0);
      Matrix<TypeParam> whole = before;
      kernels.rank_update(whole.entry.data(), r, A.entry.data(), r, r, w, 0, r);
      for (const Index cut : {0, 1, 2, 5, r / 2, r - 1, r}) {
        Matrix<TypeParam> parts = before;
        kernels.rank_update(parts.entry.data(), r, A.entry.data(), r, r, w, cut, r);
        for (Index j = 0; j < cut; ++j)
          for (Index i = j; i < r; ++i) ASSERT_EQ(parts(i, j), before(i, j)) << "column " << j << " is not asked for";
        kernels.rank_update(parts.entry.data(), r, A.entry.data(), r, r, w, 0, cut);
        expect_lower(parts, whole, 0, "split triangle");
      }
    });
}

TYPED_TEST(SolverKernels, factor_wide_panels_with_the_same_bits_in_any_number_of_pieces_and_threads) {
  for (const auto& size : {std::pair<Index, Index>{40, 33}, {130, 130}, {301, 201}, {700, 260}})
    this->for_sets([&](const auto& kernels) {
      const Index m = size.first, w = size.second;
      const Matrix<TypeParam> A = random_panel<TypeParam>(m, w, 1);
      Matrix<TypeParam> one = A;
      ASSERT_EQ(factor_panel(kernels, one.entry.data(), m, w, one.ld, this->kNone, 1, serially), w);
      expect_lower(one, plain_factor(A), 32 * this->kEpsilon * std::sqrt(m), "wide panel");
      for (const Index pieces : {2, 3, 8}) {
        Matrix<TypeParam> several = A;
        ASSERT_EQ(factor_panel(kernels, several.entry.data(), m, w, one.ld, this->kNone, pieces, backwards_in_threads),
                  w);
        expect_lower(several, one, 0, "shared panel");
      }
    });
}

/// Runs both substitutions on k right-hand sides of a factored panel and compares with plain loops.
template <class Real>
void check_substitution(const DenseKernels<Real>& kernels, Index w, Index r, Index k, double tolerance) {
  Matrix<Real> L = random_panel<Real>(w + r, w, 2);
  const Matrix<double> plain = plain_factor(L);
  for (Index j = 0; j < w; ++j)
    for (Index i = j; i < w + r; ++i) L(i, j) = static_cast<Real>(plain(i, j));
  const Matrix<Real> x = random_matrix<Real>(k, w + r); // row-major (w + r, k)
  Matrix<double> down(k, w + r, 0), up(k, w + r, 0);
  for (Index q = 0; q < k; ++q) {
    for (Index i = 0; i < w + r; ++i) down(q, i) = up(q, i) = x(q, i);
    for (Index j = 0; j < w; ++j) {
      down(q, j) /= plain(j, j);
      for (Index i = j + 1; i < w + r; ++i) down(q, i) -= plain(i, j) * down(q, j);
    }
    for (Index j = w; j-- > 0;) {
      for (Index i = j + 1; i < w + r; ++i) up(q, j) -= plain(i, j) * up(q, i);
      up(q, j) /= plain(j, j);
    }
  }
  const std::ptrdiff_t head = static_cast<std::ptrdiff_t>(w) * k;
  std::vector<Real> forward = x.entry, backward = x.entry;
  kernels.forward(L.entry.data(), w + r, w, L.ld, forward.data(), forward.data() + head, k);
  kernels.backward(L.entry.data(), w + r, w, L.ld, backward.data(), backward.data() + head, k);
  double worst = 0;
  for (std::size_t i = 0; i < forward.size(); ++i)
    worst = std::max({worst, std::abs(forward[i] - down.entry[i]), std::abs(backward[i] - up.entry[i])});
  EXPECT_LE(worst, tolerance) << "panel " << w + r << " x " << w << ", " << k << " right-hand sides";
}

TYPED_TEST(SolverKernels, substitute_forward_and_backward_like_plain_loops) {
  this->for_sets([&](const auto& kernels) {
    for (const Index w : kWidths)
      for (const Index r : {0, 1, 3, 4, 7, 8, 13, 17, 40, 121})
        for (const Index k : {1, 2, 3, 4, 5, 8, 16, 19})
          check_substitution<TypeParam>(kernels, w, r, k, 16 * this->kEpsilon * std::sqrt(w + r + 1));
    check_substitution<TypeParam>(kernels, 100, 70, 1, 64 * this->kEpsilon * 16);
    check_substitution<TypeParam>(kernels, 100, 70, 16, 64 * this->kEpsilon * 16);
  });
}

TEST(CutTriangle, gives_pieces_of_about_the_same_area) {
  for (const auto& [r, end] : {std::pair<Index, Index>{0, 0}, {3, 3}, {1000, 1000}, {1000, 10}, {3000, 1500}})
    for (const Index pieces : {1, 2, 5}) {
      EXPECT_EQ(cut_triangle(r, end, 0, pieces), 0);
      EXPECT_EQ(cut_triangle(r, end, pieces, pieces), end);
      for (Index piece = 0; piece < pieces; ++piece) {
        const Index from = cut_triangle(r, end, piece, pieces), to = cut_triangle(r, end, piece + 1, pieces);
        ASSERT_LE(from, to);
        const double area = 0.5 * (to - from) * (2 * r - from - to), fair = 0.5 * end * (2 * r - end) / pieces;
        EXPECT_NEAR(area, fair, 4 * r + 4) << "piece " << piece << " of " << pieces;
      }
    }
}

void set_environment(const char* variable, const char* value) {
#ifdef _WIN32
  _putenv_s(variable, value);
#else
  setenv(variable, value, 1);
#endif
}

TEST(InstructionSets, are_limited_by_the_environment_which_has_to_name_one) {
  constexpr const char* kVariable = "DIRICHLET_INSTRUCTION_SET";
  const char* const found = std::getenv(kVariable);
  const std::string before = found != nullptr ? found : "";
  set_environment(kVariable, "baseline");
  EXPECT_EQ(best_instruction_set(), InstructionSet::baseline);
  set_environment(kVariable, "avx512");
  EXPECT_EQ(best_instruction_set(), supported_sets().back());
  set_environment(kVariable, "AVX9");
  EXPECT_THROW(best_instruction_set(), InputError);
  set_environment(kVariable, before.c_str());
  EXPECT_TRUE(is_supported(best_instruction_set()));
}

} // namespace
} // namespace dirichlet
