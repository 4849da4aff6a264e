// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/build_information.h"

#include <OpenMesh/Core/System/config.h>

#include <thread>

#include <Eigen/Core>

#include "message.h"
#include "parallel.h"
#include "solver/dense_kernels.h"

namespace dirichlet {
namespace {

std::string compiler() {
#if defined(__clang__)
  return message("Clang ", __clang_version__);
#elif defined(__GNUC__)
  return message("GCC ", __VERSION__);
#elif defined(_MSC_VER)
  return message("MSVC ", _MSC_VER);
#else
  return "unknown";
#endif
}

std::string instruction_set() {
  switch (best_instruction_set()) {
  case InstructionSet::avx512:
    return "AVX-512";
  case InstructionSet::avx2:
    return "AVX2";
  default:
    return "baseline";
  }
}

} // namespace

std::vector<std::pair<std::string, std::string>> build_information() {
  return {
      {"version", DIRICHLET_VERSION},
      {"compiler", compiler()},
      {"eigen", message(EIGEN_WORLD_VERSION, '.', EIGEN_MAJOR_VERSION, '.', EIGEN_MINOR_VERSION)},
      {"openmesh", message(OM_GET_VER, '.', OM_GET_MAJ)},
      {"instruction_set", instruction_set()},
      {"cores", message(std::thread::hardware_concurrency())},
  };
}

void set_thread_limit(unsigned count) {
  thread_limit = count;
}

} // namespace dirichlet
