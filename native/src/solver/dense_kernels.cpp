// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/dense_kernels.h"

#include <cstdlib>
#include <string_view>

#include "dirichlet/error.h"
#include "message.h"
#include "solver/kernels/instruction_sets.h"

namespace dirichlet {
namespace {

constexpr InstructionSet kSets[] = {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512};
constexpr std::string_view kNames[] = {"baseline", "avx2", "avx512"};
constexpr const char* kVariable = "DIRICHLET_INSTRUCTION_SET";

/// What the environment allows: all, unless it says something.
InstructionSet allowed_instruction_set() {
  const char* const wanted = std::getenv(kVariable);
  if (wanted == nullptr || *wanted == 0) return InstructionSet::avx512;
  for (const InstructionSet set : kSets)
    if (kNames[static_cast<std::size_t>(set)] == wanted) return set;
  throw InputError(message(kVariable, " is '", wanted, "', but has to be baseline, avx2 or avx512"));
}

} // namespace

bool is_supported([[maybe_unused]] InstructionSet set) {
#ifdef DIRICHLET_X86_KERNELS
  if (set == InstructionSet::avx512)
    return is_supported(InstructionSet::avx2) && __builtin_cpu_supports("avx512f") &&
           __builtin_cpu_supports("avx512vl");
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
  return set == InstructionSet::baseline;
}

InstructionSet best_instruction_set() {
  const InstructionSet allowed = allowed_instruction_set();
  InstructionSet best = InstructionSet::baseline;
  for (const InstructionSet set : kSets)
    if (set <= allowed && is_supported(set)) best = set;
  return best;
}

template <class Real>
const DenseKernels<Real>& dense_kernels([[maybe_unused]] InstructionSet set) {
#ifdef DIRICHLET_X86_KERNELS
  if (set == InstructionSet::avx512) return avx512_kernels<Real>();
  if (set == InstructionSet::avx2) return avx2_kernels<Real>();
#endif
  return baseline_kernels<Real>();
}

template const DenseKernels<float>& dense_kernels(InstructionSet);
template const DenseKernels<double>& dense_kernels(InstructionSet);

} // namespace dirichlet
