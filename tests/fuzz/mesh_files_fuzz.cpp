// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a mesh file of each format: a mesh that can be walked, written and read again, or a clear refusal.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <gtest/gtest.h>

#include "dirichlet/mesh.h"
#include "dirichlet/mesh_io.h"
#include "index.h"
#include "laws.h"

namespace dirichlet::fuzz {
namespace {

namespace fs = std::filesystem;

/// A folder of this process, in memory where the system has such.
class Folder {
 public:
  Folder() { fs::create_directories(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }

  [[nodiscard]] fs::path file(const std::string& name) const { return path_ / name; }

 private:
  static fs::path parent() { return fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path(); }

  fs::path path_ = parent() / ("dirichlet_fuzz_" + std::to_string(getpid()));
};

void walk(const Mesh& mesh) {
  EXPECT_EQ(mesh.components().label.size(), at(mesh.vertex_count()));
  EXPECT_FALSE(mesh.border_loops().offsets.empty());
  const std::span<const Index> opposite = mesh.connectivity().opposite;
  for (std::size_t c = 0; c < opposite.size(); ++c)
    if (opposite[c] >= 0) EXPECT_EQ(opposite[at(opposite[c])], static_cast<Index>(c));
}

/// All but STL, whose coordinates are floats and whose vertices are joined by them.
void write_and_read_again(const Mesh& mesh, const fs::path& path) {
  write_mesh_file(path, mesh.positions(), mesh.offsets(), mesh.corners());
  const MeshArrays again = read_mesh_file(path);
  EXPECT_TRUE(std::ranges::equal(again.positions, mesh.positions()));
  EXPECT_TRUE(std::ranges::equal(again.offsets, mesh.offsets()));
  EXPECT_TRUE(std::ranges::equal(again.corners, mesh.corners()));
}

void read(const fs::path& path) {
  MeshArrays arrays = read_mesh_file(path);
  const Mesh mesh(std::move(arrays.positions), arrays.offsets, arrays.corners);
  walk(mesh);
  for (const char* ending : {".obj", ".ply", ".off"})
    write_and_read_again(mesh, path.parent_path() / (std::string("again") + ending));
  EXPECT_TRUE(mesh.triangulated().is_triangular()); // or refused
}

} // namespace
} // namespace dirichlet::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dirichlet::fuzz;
  static const Folder folder;
  for (const char* ending : {".obj", ".ply", ".off", ".stl"}) {
    const fs::path path = folder.file(std::string("mesh") + ending);
    fs::remove(path); // to truncate a file instead waits for the disk
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    expect_result_or_refusal([&] { read(path); });
  }
  return 0;
}
