// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/SparseCholesky>

#include "direct_peer.h"

namespace peers {

namespace {

class EigenPeer final : public DirectPeer {
 public:
  void analyze(const SparseMatrix& lower) override { cholesky_.analyzePattern(lower); }

  void factor(const System& system) override {
    cholesky_.factorize(system.lower);
    if (cholesky_.info() != Eigen::Success) throw std::runtime_error("Eigen finds the matrix not definite");
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) override { return cholesky_.solve(rhs); }

 private:
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> cholesky_;
};

} // namespace

std::unique_ptr<DirectPeer> make_eigen_peer() {
  return std::make_unique<EigenPeer>();
}

} // namespace peers
