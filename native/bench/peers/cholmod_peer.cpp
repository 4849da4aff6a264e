// SPDX-License-Identifier: GPL-3.0-or-later
#include <cholmod.h>

#include "direct_peer.h"

namespace peers {

namespace {

/// The other half of CHOLMOD's interface: a view of Eigen's arrays, which are not written to.
cholmod_sparse view(const SparseMatrix& lower) {
  cholmod_sparse result{};
  result.nrow = result.ncol = static_cast<std::size_t>(lower.cols());
  result.nzmax = static_cast<std::size_t>(lower.nonZeros());
  result.p = const_cast<int*>(lower.outerIndexPtr());
  result.i = const_cast<int*>(lower.innerIndexPtr());
  result.x = const_cast<double*>(lower.valuePtr());
  result.stype = -1;
  result.itype = CHOLMOD_INT;
  result.xtype = CHOLMOD_REAL;
  result.dtype = CHOLMOD_DOUBLE;
  result.sorted = result.packed = 1;
  return result;
}

class CholmodPeer final : public DirectPeer {
 public:
  explicit CholmodPeer(CholmodOrdering ordering) {
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.nmethods = 1;
    common_.method[0].ordering = ordering == CholmodOrdering::amd ? CHOLMOD_AMD : CHOLMOD_METIS;
    common_.postorder = 1;
  }

  ~CholmodPeer() override {
    for (cholmod_dense** work : {&solution_, &work_y_, &work_e_}) cholmod_free_dense(work, &common_);
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }

  CholmodPeer(const CholmodPeer&) = delete;
  CholmodPeer& operator=(const CholmodPeer&) = delete;

  void analyze(const SparseMatrix& lower) override {
    cholmod_sparse matrix = view(lower);
    factor_ = cholmod_analyze(&matrix, &common_);
    check();
  }

  void factor(const System& system) override {
    cholmod_sparse matrix = view(system.lower);
    cholmod_factorize(&matrix, factor_, &common_);
    check();
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) override {
    cholmod_dense right{};
    right.nrow = right.d = static_cast<std::size_t>(rhs.rows());
    right.ncol = static_cast<std::size_t>(rhs.cols());
    right.nzmax = right.nrow * right.ncol;
    right.x = const_cast<double*>(rhs.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    // cholmod_solve2 keeps its work space from solve to solve, as a program that solves again and again would.
    cholmod_solve2(CHOLMOD_A, factor_, &right, nullptr, &solution_, nullptr, &work_y_, &work_e_, &common_);
    check();
    return Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(solution_->x), rhs.rows(), rhs.cols());
  }

 private:
  void check() const {
    if (common_.status != CHOLMOD_OK)
      throw std::runtime_error("CHOLMOD ended with status " + std::to_string(common_.status));
  }

  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense* solution_ = nullptr;
  cholmod_dense* work_y_ = nullptr;
  cholmod_dense* work_e_ = nullptr;
};

} // namespace

std::unique_ptr<DirectPeer> make_cholmod_peer(CholmodOrdering ordering) {
  return std::make_unique<CholmodPeer>(ordering);
}

} // namespace peers
