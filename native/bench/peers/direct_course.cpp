// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <string>

#include "array_file.h"
#include "courses.h"

namespace peers {

namespace {

constexpr int kColumns = 16;
constexpr int kStrokes = 8; // in a scene's file of them
constexpr double kStrokeValue = 0.5;
constexpr int kRefinements = 5;

/// Order, factor and solve the smallest system, from nothing.
void cold(const MakePeer& make, const System& system, const Recorder& recorder) {
  recorder.repeat([&](int) {
    const auto peer = make(system.lower);
    const Times start = Times::now();
    recorder.time("order", [&] { peer->analyze(system.lower); });
    recorder.time("factor", [&] { peer->factor(system); });
    recorder.time("solve", [&] { return peer->solve(system.rhs); });
    Recorder::record("cold solve", Times::now() - start);
  });
}

/// One analysis for every painting of the mesh.
void later(DirectPeer& peer, const SparseMatrix& K, const std::filesystem::path& scene, const Recorder& recorder) {
  const std::array paintings{inject(K, read_painting(scene, "second")), inject(K, read_painting(scene, "first"))};
  recorder.repeat([&](int run) {
    const System& system = paintings[static_cast<std::size_t>(run % 2)];
    const Times start = Times::now();
    recorder.time("later factor", [&] { peer.factor(system); });
    recorder.time("values", [&] { return peer.solve(system.rhs); });
    Recorder::record("later", Times::now() - start);
  });
  const Eigen::MatrixXd columns = paintings[1].rhs.replicate(1, kColumns);
  recorder.repeat([&](int) { recorder.time("16 columns", [&] { return peer.solve(columns); }); });
}

/// Strokes on top of each other; a stroke is a row of vertices in the file of that name.
void paint(DirectPeer& peer, const SparseMatrix& K, const std::filesystem::path& scene, const std::string& stage,
           const Recorder& recorder) {
  Eigen::VectorXd painting = read_painting(scene, "first");
  const auto vertices = read_indices(scene / (stage + ".npy"));
  const std::size_t length = vertices.size() / kStrokes;
  peer.start_from(inject(K, painting));
  recorder.repeat([&](int run) {
    if (run >= kStrokes) return;
    const std::size_t first = static_cast<std::size_t>(run) * length;
    for (std::size_t i = first; i < first + length; ++i) painting[vertices[i]] = kStrokeValue;
    const System system = inject(K, painting);
    recorder.time(stage.c_str(), [&] {
      peer.factor(system);
      return peer.solve(system.rhs);
    });
  });
}

void write_field(const std::filesystem::path& path, const Eigen::VectorXd& field) {
  write_reals(path, {field.data(), static_cast<std::size_t>(field.size())});
}

} // namespace

void run_direct_course(const MakePeer& make, const std::filesystem::path& scene, const std::filesystem::path& field,
                       const Recorder& recorder) {
  const SparseMatrix K = read_stiffness(scene);
  const Eigen::VectorXd painting = read_painting(scene, "first");
  {
    const Recorder::Memory memory; // the painted matrix counts, as the one that ours makes itself
    const System system = inject(K, painting);
    const auto peer = make(K);
    peer->analyze(K);
    peer->factor(system);
    const Eigen::VectorXd solution = peer->solve(system.rhs);
    Recorder::state("memory", memory.peak());
    write_field(field, solution);
    later(*peer, K, scene, recorder);
    for (const char* stage : {"stroke", "dab"}) paint(*peer, K, scene, stage, recorder);
  }
  cold(make, reduce(K, painting), recorder);
}

void run_reference_course(const MakePeer& make, const std::filesystem::path& scene,
                          const std::filesystem::path& field) {
  const System system = inject(read_stiffness(scene), read_painting(scene, "first"));
  const auto peer = make(system.lower);
  peer->analyze(system.lower);
  peer->factor(system);
  using Extended = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  const auto matrix = system.lower.cast<long double>().eval();
  const Extended rhs = system.rhs.cast<long double>();
  Extended solution = Extended::Zero(rhs.size());
  for (int i = 0; i < kRefinements; ++i) {
    const Extended residual = rhs - matrix.selfadjointView<Eigen::Lower>() * solution;
    solution += peer->solve(residual.cast<double>()).cast<long double>();
  }
  write_field(field, solution.cast<double>());
}

} // namespace peers
