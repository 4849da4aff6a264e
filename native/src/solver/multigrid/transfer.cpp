// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer.h"

#include <algorithm>
#include <utility>

#include "row_blocks.h"

namespace dirichlet::multigrid {
namespace {

/// Adds up rows of a product one after the other. Of the dense row only what the block names is ever used.
template <class Real>
class RowSum {
 public:
  explicit RowSum(Eigen::Index columns) : sums_(at(columns)), last_row_(at(columns), -1) {}

  void begin(Index row, const RowBlock<Real>& block) {
    row_ = row;
    first_ = block.columns.size();
  }

  void add(Index column, double value, RowBlock<Real>& block) {
    if (std::exchange(last_row_[at(column)], row_) == row_) {
      sums_[at(column)] += value;
      return;
    }
    sums_[at(column)] = value;
    block.columns.push_back(column);
  }

  void end(RowBlock<Real>& block) {
    const auto first = block.columns.begin() + static_cast<std::ptrdiff_t>(first_);
    std::sort(first, block.columns.end());
    std::for_each(first, block.columns.end(),
                  [&](Index column) { block.values.push_back(static_cast<Real>(sums_[at(column)])); });
    block.sizes.push_back(static_cast<Index>(block.columns.end() - first));
  }

 private:
  std::vector<double> sums_;
  std::vector<Index> last_row_; ///< by column: the row that its sum belongs to
  std::size_t first_ = 0;
  Index row_ = 0;
};

/// The rows of a smoothed prolongation.
class SmoothedRows {
 public:
  SmoothedRows(const SparseMatrix& A, const Aggregates& aggregates, std::span<const double> strongest)
      : A_(A), aggregates_(aggregates), strongest_(strongest), sum_(aggregates.count) {}

  void operator()(Index row, RowBlock<float>& block) {
    sum_.begin(row, block);
    if (has_aggregate(row)) add_smoothed(row, block);
    sum_.end(block);
  }

 private:
  /// 4/3 over the largest eigenvalue of D⁻¹A, which is 1.5 or more in meshes of triangles and at most 2.
  static constexpr double kDamping = 0.8;
  /// A vertex with more strong neighbours is a hub: smoothed, it would tie all aggregates around it to each other, and
  /// the coarse matrix would fill up.
  static constexpr Index kMostNeighbours = 40;

  [[nodiscard]] bool has_aggregate(Index i) const { return aggregates_.label[at(i)] != Aggregates::kNone; }

  [[nodiscard]] bool strong(Index row, Index j, double a) const {
    return j != row && -a >= kWeakShare * strongest_[at(row)] && has_aggregate(j);
  }

  void add_smoothed(Index row, RowBlock<float>& block) {
    // The strong part of A: other entries are moved to the diagonal, so that it keeps the sum of the row.
    double row_sum = 0, attraction = 0;
    Index neighbours = 0;
    for_row(A_, row, [&](Index j, double a) {
      if (j == row || has_aggregate(j)) row_sum += a;
      if (!strong(row, j, a)) return;
      attraction -= a;
      ++neighbours;
    });
    const bool smoothed = neighbours > 0 && neighbours <= kMostNeighbours;
    sum_.add(aggregates_.label[at(row)], smoothed ? 1 - kDamping : 1, block);
    if (!smoothed) return;
    const double scale = kDamping / (attraction + std::max(row_sum, 0.0));
    for_row(A_, row, [&](Index j, double a) {
      if (strong(row, j, a)) sum_.add(aggregates_.label[at(j)], -a * scale, block);
    });
  }

  const SparseMatrix& A_;
  const Aggregates& aggregates_;
  std::span<const double> strongest_;
  RowSum<float> sum_;
};

/// The rows of R A P.
class ProductRows {
 public:
  ProductRows(const SparseMatrix& A, const Transfer& P, const Transfer& R) : A_(A), P_(P), R_(R), sum_(P.cols()) {}

  void operator()(Index row, RowBlock<double>& block) {
    sum_.begin(row, block);
    for_row(R_, row, [&](Index i, double r) {
      for_row(A_, i, [&](Index k, double a) {
        const double ra = r * a;
        for_row(P_, k, [&](Index column, double p) { sum_.add(column, ra * p, block); });
      });
    });
    sum_.end(block);
  }

 private:
  const SparseMatrix& A_;
  const Transfer& P_;
  const Transfer& R_;
  RowSum<double> sum_;
};

} // namespace

Transfer smoothed_prolongation(const SparseMatrix& A, const Aggregates& aggregates, std::span<const double> strongest) {
  return matrix_by_rows<float>(A.rows(), aggregates.count, [&] { return SmoothedRows(A, aggregates, strongest); });
}

SparseMatrix galerkin_product(const SparseMatrix& A, const Transfer& P, const Transfer& R) {
  return matrix_by_rows<double>(R.rows(), R.rows(), [&] { return ProductRows(A, P, R); });
}

} // namespace dirichlet::multigrid
