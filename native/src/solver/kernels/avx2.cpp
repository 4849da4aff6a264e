// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/kernels/instruction_sets.h"
#include "solver/kernels/make_kernels.h"

namespace dirichlet {

template <>
const DenseKernels<float>& avx2_kernels() {
  return Kernels<float, 32>::kTable;
}

template <>
const DenseKernels<double>& avx2_kernels() {
  return Kernels<double, 32>::kTable;
}

} // namespace dirichlet
