// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/kernels/instruction_sets.h"
#include "solver/kernels/make_kernels.h"

namespace dirichlet {

template <>
const DenseKernels<float>& baseline_kernels() {
  return Kernels<float, 16>::kTable;
}

template <>
const DenseKernels<double>& baseline_kernels() {
  return Kernels<double, 16>::kTable;
}

} // namespace dirichlet
