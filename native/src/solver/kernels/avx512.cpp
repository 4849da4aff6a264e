// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/kernels/instruction_sets.h"
#include "solver/kernels/make_kernels.h"

namespace dirichlet {

template <>
const DenseKernels<float>& avx512_kernels() {
  return Kernels<float, 64>::kTable;
}

template <>
const DenseKernels<double>& avx512_kernels() {
  return Kernels<double, 64>::kTable;
}

} // namespace dirichlet
