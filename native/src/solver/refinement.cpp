// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/refinement.h"

#include <utility>
#include <vector>

#include "dirichlet/error.h"
#include "index.h"
#include "message.h"
#include "parallel.h"
#include "twin.h"

namespace dirichlet {
namespace {

/// z ≈ A⁻¹ r, with the columns of r scaled so that they fit single precision.
void precondition(const Factor<float>& factor, const Block& r, const Eigen::ArrayXd& norm, std::vector<float>& work,
                  Block& z) {
  const auto k = static_cast<std::size_t>(r.cols()), rows = static_cast<std::size_t>(r.rows());
  const Eigen::ArrayXd scale = (norm > 0).select(norm, 1), inverse = 1 / scale;
  work.resize(rows * k);
  const auto for_all = [&](const auto& f) { // f(place, column)
    parallel_chunks(rows, 1 << 14, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin * k; i < end * k; i += k)
        for (std::size_t c = 0; c < k; ++c) f(i + c, static_cast<Eigen::Index>(c));
    });
  };
  for_all([&](std::size_t e, Eigen::Index c) { work[e] = static_cast<float>(r.data()[e] * inverse[c]); });
  factor.solve(work, static_cast<Index>(k));
  for_all([&](std::size_t e, Eigen::Index c) { z.data()[e] = scale[c] * static_cast<double>(work[e]); });
}

/// Quotients, 0 where a column is finished.
Eigen::ArrayXd quotient(const Eigen::ArrayXd& a, const Eigen::ArrayXd& b) {
  return (b != 0).select(a / b, 0);
}

} // namespace

Index refine(const SparseView& K, const Mask& mask, const Factor<float>& factor, const Block& rhs, Block& x,
             double tolerance, Index max_iterations) {
  // Fixed rows are solved exactly; the rest starts from 0.
  x = rhs;
  Block r = rhs;
  for (std::size_t i = 0; i < mask.size(); ++i) (mask[i] != 0 ? r : x).row(static_cast<Eigen::Index>(i)).setZero();

  const Eigen::ArrayXd goal = tolerance * free_dots(mask, rhs, rhs).sqrt();
  Eigen::ArrayXd norm = goal / tolerance, rz = Eigen::ArrayXd::Zero(r.cols());
  Block p, q(r.rows(), r.cols()); // the direction; A p, and before that the preconditioned r
  std::vector<float> work;
  bool restart = true;
  for (Index step = 0;; ++step) {
    if ((norm <= goal).all()) { // r is only what rhs − A x would be without rounding
      multiply_twin(K, mask, x, r);
      r = rhs - r;
      norm = free_dots(mask, r, r).sqrt();
      if ((norm <= goal).all()) return step;
      restart = true;
    }
    if (step == max_iterations)
      throw SolverError(message("refinement of the float32 factor stopped at the relative residual ",
                                roughly((norm / goal).maxCoeff() * tolerance), " after ", counted(step, "step"),
                                ", short of the tolerance ", tolerance,
                                "; a float64 factor needs no steps, a larger tolerance fewer"));
    precondition(factor, r, norm, work, q);
    const Eigen::ArrayXd last = rz;
    rz = (norm <= goal).select(0, free_dots(mask, r, q));
    if (!restart) add_columns(p, quotient(rz, last), q);
    std::swap(p, q);
    restart = false;
    multiply_twin(K, mask, p, q);
    const Eigen::ArrayXd length = quotient(rz, free_dots(mask, p, q));
    add_columns(p, length, x);
    add_columns(q, -length, r);
    norm = free_dots(mask, r, r).sqrt();
  }
}

} // namespace dirichlet
