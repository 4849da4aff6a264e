// SPDX-License-Identifier: GPL-3.0-or-later
// dirichlet_peers PEER SCENE FIELD RUNS SECONDS: what the C++ libraries, ours among them, take for the tasks of the
// benchmark, in lines of JSON. The driver is dirichlet_bench/, which also says what the files of a scene hold.
#include <cstdlib>
#include <exception>
#include <map>
#include <string>

#include "courses.h"

namespace {

using namespace peers;

std::map<std::string, MakePeer> direct_peers() {
  std::map<std::string, MakePeer> result{{"ours", make_ours_peer},
                                         {"eigen", [](const SparseMatrix&) { return make_eigen_peer(); }}};
#ifdef DIRICHLET_HAS_CHOLMOD
  result["cholmod-amd"] = [](const SparseMatrix&) { return make_cholmod_peer(CholmodOrdering::amd); };
  result["cholmod-metis"] = [](const SparseMatrix&) { return make_cholmod_peer(CholmodOrdering::metis); };
#endif
  return result;
}

int run(char** words) {
  const std::string name = words[1];
  const std::filesystem::path scene = words[2];
  const std::filesystem::path field = words[3];
  const Recorder recorder(std::stoi(words[4]), std::stod(words[5]));
  const auto peers = direct_peers();
  if (name == "openmesh") {
    run_openmesh_course(scene, recorder);
  } else if (name == "reference") {
    const auto best = peers.find("cholmod-amd");
    run_reference_course(best == peers.end() ? peers.at("eigen") : best->second, scene, field);
  } else if (const auto peer = peers.find(name); peer != peers.end()) {
    run_direct_course(peer->second, scene, field, recorder);
  } else {
    Recorder::state("missing", "this library was not found when the program was built");
  }
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 6) return run(argv);
    std::fprintf(stderr, "dirichlet_peers PEER SCENE FIELD RUNS SECONDS\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "dirichlet_peers: %s\n", error.what());
  }
  return EXIT_FAILURE;
}
