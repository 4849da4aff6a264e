// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/solver.h"

#include "direct_peer.h"

namespace peers {

namespace {

class OursPeer final : public DirectPeer {
 public:
  explicit OursPeer(const SparseMatrix& lower) : K_(lower.selfadjointView<Eigen::Lower>()) {}

  void analyze(const SparseMatrix&) override {
    dirichlet::SolverOptions options;
    options.method = dirichlet::Method::direct;
    solver_ = make_solver(std::move(K_), options);
  }

  void start_from(const System& system) override { factor(system); }

  void factor(const System& system) override {
    const auto order = solver_->order();
    dirichlet::Mask mask(order.size());
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = system.painted[static_cast<std::size_t>(order[i])];
    solver_->inject(mask);
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) override {
    const auto order = solver_->order();
    dirichlet::Block own(rhs.rows(), rhs.cols());
    for (Eigen::Index i = 0; i < rhs.rows(); ++i) own.row(i) = rhs.row(order[static_cast<std::size_t>(i)]);
    dirichlet::Block x = dirichlet::Block::Zero(rhs.rows(), rhs.cols());
    solver_->solve(own, x);
    Eigen::MatrixXd result(rhs.rows(), rhs.cols());
    for (Eigen::Index i = 0; i < rhs.rows(); ++i) result.row(order[static_cast<std::size_t>(i)]) = x.row(i);
    return result;
  }

 private:
  dirichlet::SparseMatrix K_; ///< both triangles, until the solver has it
  std::unique_ptr<dirichlet::Solver> solver_;
};

} // namespace

std::unique_ptr<DirectPeer> make_ours_peer(const SparseMatrix& lower) {
  return std::make_unique<OursPeer>(lower);
}

} // namespace peers
