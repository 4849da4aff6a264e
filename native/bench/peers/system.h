// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <Eigen/SparseCore>

namespace peers {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Symmetric; the lower triangle is stored. NaN in `prescribed` marks a free vertex.
struct System {
  SparseMatrix lower;
  Eigen::VectorXd rhs;
  std::vector<std::uint8_t> painted; ///< 1 where a row is an identity row
};

/// The stiffness matrix that the driver wrote: lower triangle in compressed columns.
SparseMatrix read_stiffness(const std::filesystem::path& scene);

/// One field prescribed on painted vertices, NaN where free: the painting of that name.
Eigen::VectorXd read_painting(const std::filesystem::path& scene, const char* name);

/// The free vertices alone, the smallest system: what a cold solve wants.
System reduce(const SparseMatrix& K, const Eigen::VectorXd& prescribed);

/// Painted vertices as identity rows, which keep the pattern of K: what a later factor wants, since one analysis then
/// serves every painting.
System inject(const SparseMatrix& K, const Eigen::VectorXd& prescribed);

} // namespace peers
