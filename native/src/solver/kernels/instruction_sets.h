// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/dense_kernels.h"

namespace dirichlet {

template <class Real>
const DenseKernels<Real>& baseline_kernels();
// These two where the build defines DIRICHLET_X86_KERNELS: it has to give their files flags of their own.
template <class Real>
const DenseKernels<Real>& avx2_kernels();
template <class Real>
const DenseKernels<Real>& avx512_kernels();

} // namespace dirichlet
