// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>
#include <vector>

#include "dirichlet/solver.h"
#include "index.h"
#include "solver/weak_links.h"

namespace dirichlet {

// Of the methods that solve the symmetric twin step by step.
constexpr double kTwinTolerance = 1e-10;
constexpr Index kMostTwinIterations = 500;

/// What methods share that keep the matrix in the order in which it came, and set up anew for every mask.
class IterativeSolver : public Solver {
 public:
  [[nodiscard]] SparseView matrix() const final { return K_; }
  [[nodiscard]] std::span<const Index> order() const final { return order_; }
  [[nodiscard]] const SolverStatistics& statistics() const final { return statistics_; }

  double inject(const Mask& mask) final {
    if (mask == mask_) return 0;
    mask_.clear(); // until all is done
    set_up(mask);
    mask_ = mask;
    return 1;
  }

 protected:
  /// \param method  that it is, whatever was asked for
  IterativeSolver(SparseMatrix&& K, Method method, Method asked, double analysis_seconds)
      : order_(at(static_cast<Index>(K.rows()))), statistics_{.method = method,
                                                              .nonzeros = K.nonZeros(),
                                                              .analysis_seconds = analysis_seconds,
                                                              .weak_links = limit_weights(K, name(method, asked))} {
    K_.swap(K); // Eigen 3.4 copies what is moved
    std::iota(order_.begin(), order_.end(), Index{0});
  }

  static const char* name(Method method, Method asked) {
    if (asked == Method::automatic) return "multigrid, all that the memory budget allows,";
    return method == Method::multigrid ? "multigrid" : "the method of least squares";
  }
  virtual void set_up(const Mask& mask) = 0;
  [[nodiscard]] const SparseMatrix& stiffness() const { return K_; }
  [[nodiscard]] const Mask& mask() const { return mask_; } ///< set up for; empty if for none

 private:
  SparseMatrix K_;
  std::vector<Index> order_;
  Mask mask_;
  SolverStatistics statistics_;
};

} // namespace dirichlet
