// SPDX-License-Identifier: GPL-3.0-or-later
#include "system.h"

#include <cmath>
#include <vector>

#include "array_file.h"

namespace peers {

SparseMatrix read_stiffness(const std::filesystem::path& scene) {
  const auto offsets = read_indices(scene / "stiffness_offsets.npy");
  const auto rows = read_indices(scene / "stiffness_rows.npy");
  const auto values = read_reals(scene / "stiffness_values.npy");
  const auto n = static_cast<Eigen::Index>(offsets.size()) - 1;
  return Eigen::Map<const SparseMatrix>(n, n, static_cast<Eigen::Index>(rows.size()), offsets.data(), rows.data(),
                                        values.data());
}

Eigen::VectorXd read_painting(const std::filesystem::path& scene, const char* name) {
  const auto numbers = read_reals(scene / (std::string(name) + ".npy"));
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

System reduce(const SparseMatrix& K, const Eigen::VectorXd& prescribed) {
  std::vector<int> number(static_cast<std::size_t>(K.cols()), -1);
  int free = 0;
  for (int v = 0; v < K.cols(); ++v)
    if (std::isnan(prescribed[v])) number[static_cast<std::size_t>(v)] = free++;
  const auto place = [&](Eigen::Index v) { return number[static_cast<std::size_t>(v)]; };
  System result{SparseMatrix(free, free), Eigen::VectorXd::Zero(free), {}};
  result.painted.resize(static_cast<std::size_t>(free));
  result.lower.reserve(K.nonZeros());
  for (int j = 0; j < K.cols(); ++j) {
    if (place(j) >= 0) result.lower.startVec(place(j));
    for (SparseMatrix::InnerIterator entry(K, j); entry; ++entry) {
      const int row = place(entry.row());
      const int column = place(j);
      if (row >= 0 && column >= 0) result.lower.insertBack(row, column) = entry.value();
      if (row >= 0 && column < 0) result.rhs[row] -= entry.value() * prescribed[j];
      if (row < 0 && column >= 0) result.rhs[column] -= entry.value() * prescribed[entry.row()];
    }
  }
  result.lower.finalize();
  return result;
}

System inject(const SparseMatrix& K, const Eigen::VectorXd& prescribed) {
  System result{K, prescribed.unaryExpr([](double value) { return std::isnan(value) ? 0.0 : value; }), {}};
  const auto is_free = [&](Eigen::Index v) { return std::isnan(prescribed[v]); };
  for (Eigen::Index v = 0; v < K.cols(); ++v) result.painted.push_back(is_free(v) ? 0 : 1);
  for (int j = 0; j < K.cols(); ++j)
    for (SparseMatrix::InnerIterator entry(result.lower, j); entry; ++entry) {
      const Eigen::Index i = entry.row();
      if (is_free(i) && is_free(j)) continue;
      if (is_free(i)) result.rhs[i] -= entry.value() * prescribed[j];
      if (is_free(j)) result.rhs[j] -= entry.value() * prescribed[i];
      entry.valueRef() = i == j ? 1.0 : 0.0;
    }
  return result;
}

} // namespace peers
