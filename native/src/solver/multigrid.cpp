// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/multigrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dirichlet/error.h"
#include "message.h"
#include "solver/multigrid/rows.h"

namespace dirichlet {

using multigrid::at;
using multigrid::for_rows;
using multigrid::row_product;
using multigrid::sum_rows;

namespace {

constexpr Index kLargestDense = 300; ///< rows of a coarse matrix that is factored
constexpr Index kDegree = 2;         ///< of the polynomial that relaxes, before and after the coarse correction

/// D⁻¹ for the twin's sums D(i,i) of absolute values, 0 where painted.
std::vector<double> relaxation_scaling(const SparseMatrix& A, const Mask& mask) {
  const auto free = [&](Index i) { return mask.empty() || mask[at(i)] == 0; };
  std::vector<double> scaling(at(A.rows()), 0.0);
  for_rows(A.rows(), [&](Index i) {
    if (!free(i)) return;
    double sum = 0, diagonal = 0;
    for_row(A, i, [&](Index j, double a) {
      if (free(j)) sum += std::abs(a);
      if (j == i) diagonal = a;
    });
    scaling[at(i)] = diagonal > 0 && std::isfinite(1 / sum) ? 1 / sum : -1;
  });
  const auto bad = std::find(scaling.begin(), scaling.end(), -1);
  if (bad != scaling.end())
    throw SolverError(message("the matrix is not positive definite: row ", bad - scaling.begin(), " of ",
                              scaling.size(), " has no positive, finite diagonal"));
  return scaling;
}

template <class Matrix>
std::int64_t matrix_bytes(const Matrix& A) {
  return static_cast<std::int64_t>(A.nonZeros()) *
             static_cast<std::int64_t>(sizeof(typename Matrix::Scalar) + sizeof(Index)) +
         static_cast<std::int64_t>(sizeof(Index)) * (A.rows() + 1);
}

} // namespace

struct Multigrid::Vectors {
  std::vector<double> b, x, spare;
};

Multigrid::Multigrid(const SparseMatrix& K, const Mask& mask, CancelToken cancel) : K_(K), cancel_(std::move(cancel)) {
  if (K.rows() != K.cols() || mask.size() != at(K.rows()))
    throw InputError(
        message("a mask of ", mask.size(), " entries does not fit a matrix of ", K.rows(), " × ", K.cols()));
  SparseMatrix coarse;
  do {
    cancel_.check();
    Level level;
    const bool finest = levels_.empty();
    const SparseMatrix& A = finest ? K : coarse;
    level.scaling = relaxation_scaling(A, finest ? mask : Mask{});
    const auto strongest = multigrid::strongest_attractions(A, finest ? mask : Mask{});
    level.prolongation = multigrid::smoothed_prolongation(A, multigrid::aggregate(A, strongest), strongest);
    level.restriction = level.prolongation.transpose();
    SparseMatrix next = multigrid::galerkin_product(A, level.prolongation, level.restriction);
    level.own = std::exchange(coarse, std::move(next));
    levels_.push_back(std::move(level));
  } while (coarse.rows() > kLargestDense);
  if (coarse.rows() == 0) return;
  coarsest_.compute(Eigen::MatrixXd(coarse));
  if (coarsest_.info() != Eigen::Success)
    throw SolverError(message("the matrix is not positive definite: that of its ", coarse.rows(),
                              " coarsest unknowns has a pivot that is not positive"));
}

/// degree steps of xₖ₊₁ = xₖ + momentum (xₖ − xₖ₋₁) + step D⁻¹(b − A xₖ); the new x is written over the one before
/// last.
void Multigrid::relax(std::size_t level, bool from_zero, Vectors& v) const {
  const SparseMatrix& A = matrix(level);
  const auto& scaling = levels_[level].scaling;
  for (Index k = 1; k <= kDegree; ++k) {
    const double momentum = k == 1 ? 0 : (2.0 * k - 3) / (2 * k + 1), step = (8.0 * k - 4) / (2 * k + 1);
    for_rows(A.rows(), [&](Index row) {
      const auto i = at(row);
      if (k == 1 && from_zero) {
        v.x[i] = 0;
        v.spare[i] = step * scaling[i] * v.b[i];
      } else {
        const double residual = v.b[i] - row_product(A, row, v.x);
        v.spare[i] = v.x[i] + momentum * (v.x[i] - v.spare[i]) + step * scaling[i] * residual;
      }
    });
    std::swap(v.x, v.spare);
  }
}

void Multigrid::precondition(std::size_t number, std::vector<Vectors>& work) const {
  Vectors& v = work[number];
  if (number == levels_.size()) {
    if (v.b.empty()) return;
    const auto size = static_cast<Eigen::Index>(v.b.size());
    Eigen::Map<Eigen::VectorXd>(v.x.data(), size) = coarsest_.solve(Eigen::Map<Eigen::VectorXd>(v.b.data(), size));
    return;
  }
  const Level& level = levels_[number];
  const SparseMatrix& A = matrix(number);
  Vectors& coarse = work[number + 1];
  relax(number, true, v);
  for_rows(A.rows(), [&](Index i) { v.spare[at(i)] = v.b[at(i)] - row_product(A, i, v.x); });
  for_rows(coarse.b.size(), [&](Index i) { coarse.b[at(i)] = row_product(level.restriction, i, v.spare); });
  precondition(number + 1, work);
  for_rows(A.rows(), [&](Index i) { v.x[at(i)] += row_product(level.prolongation, i, coarse.x); });
  relax(number, false, v);
}

/// Conjugate gradients with painted rows at 0, so that K and the twin act alike.
class Multigrid::Iteration {
 public:
  Iteration(const Multigrid& multigrid, std::span<const double> rhs, std::span<const double> start)
      : grid_(multigrid), rhs_(rhs), x_(start.begin(), start.end()), direction_(rhs.size()) {
    for (const Level& level : grid_.levels_) add_vectors(level.scaling.size());
    add_vectors(at(grid_.levels_.back().prolongation.cols()));
    scale_ = std::sqrt(sum_rows(x_.size(), [&](Index i) { return painted(i) ? 0 : rhs_[at(i)] * rhs_[at(i)]; }));
    for_rows(x_.size(), [&](Index i) {
      if (painted(i) || scale_ == 0) x_[at(i)] = 0;
    });
  }

  Result run(double tolerance, Index max_iterations, bool to_rounding) {
    Index steps = 0;
    double before = std::numeric_limits<double>::infinity(); // the residual of the last beginning
    for (;;) {
      double residual = true_residual();
      if (residual <= tolerance) return {steps, residual};
      if (!std::isfinite(residual)) throw SolverError("a number of the right-hand side or start is not finite");
      const bool stands = residual > std::exchange(before, residual) / 2; // rounding allows no less
      if (stands && to_rounding && residual <= rounding()) return {steps, residual};
      if (steps >= max_iterations || stands)
        throw SolverError(message("multigrid conjugate gradients stopped at a relative residual of ", roughly(residual),
                                  " after ", counted(steps, "step"), ", short of the tolerance ", tolerance,
                                  stands ? ", where rounding ends; allow" : "; allow more steps or",
                                  " a larger tolerance, or take the direct method"));
      double rho = 0;
      do {
        grid_.cancel_.check();
        residual = advance(rho);
        ++steps;
      } while (residual > tolerance && steps < max_iterations);
    }
  }

  void write(std::span<double> x) const {
    for_rows(x.size(), [&](Index i) { x[at(i)] = painted(i) ? rhs_[at(i)] : x_[at(i)]; });
  }

 private:
  bool painted(Index i) const { return grid_.levels_.front().scaling[at(i)] == 0; }
  Vectors& finest() { return work_.front(); }

  void add_vectors(std::size_t n) {
    work_.push_back({std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)});
  }

  /// r = b − A x; the rounding that an iteration gathers is not in it.
  double true_residual() {
    auto& r = finest().b;
    const double square = sum_rows(r.size(), [&](Index i) {
      r[at(i)] = painted(i) ? 0 : rhs_[at(i)] - row_product(grid_.K_, i, x_);
      return r[at(i)] * r[at(i)];
    });
    return scale_ == 0 ? 0 : std::sqrt(square) / scale_; // where b = 0, x started at the solution
  }

  /// What sums of so many products of this size may be off by, relative like a residual.
  double rounding() const {
    const double square = sum_rows(x_.size(), [&](Index i) {
      double sum = 0, count = 0;
      if (!painted(i))
        for_row(grid_.K_, i, [&](Index j, double a) {
          sum += std::abs(a * x_[at(j)]);
          ++count;
        });
      sum *= std::max(8.0, count);
      return sum * sum;
    });
    return std::numeric_limits<double>::epsilon() * std::sqrt(square) / scale_;
  }

  /// One step. \param rho  rᵀz of the step before, 0 at the first. \returns ‖r‖ / ‖b‖
  double advance(double& rho) {
    grid_.precondition(0, work_);
    auto &r = finest().b, &q = finest().spare;
    const auto& z = finest().x;
    const double last_rho = std::exchange(rho, sum_rows(r.size(), [&](Index i) { return r[at(i)] * z[at(i)]; }));
    const double beta = last_rho == 0 ? 0 : rho / last_rho;
    for_rows(r.size(), [&](Index i) { direction_[at(i)] = z[at(i)] + beta * direction_[at(i)]; });
    const double curvature = sum_rows(r.size(), [&](Index i) {
      q[at(i)] = painted(i) ? 0 : row_product(grid_.K_, i, direction_);
      return q[at(i)] * direction_[at(i)];
    });
    if (!(rho > 0 && curvature > 0))
      throw SolverError(message("the matrix is not positive definite: a direction of search has the energy ",
                                std::min(rho, curvature)));
    const double step = rho / curvature;
    const double square = sum_rows(r.size(), [&](Index i) {
      x_[at(i)] += step * direction_[at(i)];
      r[at(i)] -= step * q[at(i)];
      return r[at(i)] * r[at(i)];
    });
    return std::sqrt(square) / scale_;
  }

  const Multigrid& grid_;
  std::span<const double> rhs_;
  std::vector<double> x_, direction_;
  std::vector<Vectors> work_;
  double scale_ = 0;
};

Multigrid::Result Multigrid::solve(std::span<const double> rhs, std::span<double> x, double tolerance,
                                   Index max_iterations, bool to_rounding) const {
  if (rhs.size() != at(K_.rows()) || x.size() != rhs.size())
    throw InputError(message("a right-hand side of ", rhs.size(), " and a start of ", x.size(),
                             " numbers do not fit a matrix of ", K_.rows(), " rows"));
  Iteration iteration(*this, rhs, x);
  const Result result = iteration.run(tolerance, max_iterations, to_rounding);
  iteration.write(x);
  return result;
}

std::int64_t Multigrid::bytes() const {
  const Eigen::MatrixXd& factor = coarsest_.matrixLLT();
  auto sum = static_cast<std::int64_t>(factor.size() * static_cast<Eigen::Index>(sizeof(double)));
  for (const Level& level : levels_)
    sum += matrix_bytes(level.own) + matrix_bytes(level.prolongation) + matrix_bytes(level.restriction) +
           static_cast<std::int64_t>(level.scaling.size() * sizeof(double));
  return sum;
}

} // namespace dirichlet
