// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files written by tests, whole or damaged.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "dirichlet/mesh_io.h"
#include "refusal.h"

namespace dirichlet {

namespace fs = std::filesystem;
using Doubles = std::vector<double>;
using Indices = std::vector<Index>;

/// Files of the test's own, in a folder of its own.
class MeshFile : public testing::Test {
 protected:
  MeshFile() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("dirichlet_") + test->test_suite_name() + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~MeshFile() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& bytes) const {
    fs::remove(folder_ / name); // to truncate a file instead waits for the disk
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  MeshArrays read(const std::string& name, const std::string& bytes) const {
    return read_mesh_file(write(name, bytes));
  }

  fs::path folder_;
};

inline std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::string with_line_ends(const std::string& text, const char* end) {
  std::string out;
  for (const char c : text) out += c == '\n' ? std::string(end) : std::string(1, c);
  return out;
}

/// The bytes of numbers, lowest first; highest first when `big`.
template <class... Numbers>
std::string binary(bool big, Numbers... numbers) {
  std::string out;
  const auto append = [&](auto number) {
    auto raw = std::bit_cast<std::array<char, sizeof number>>(number);
    if (big == (std::endian::native == std::endian::little)) std::reverse(raw.begin(), raw.end());
    out.append(raw.data(), raw.size());
  };
  (append(numbers), ...);
  return out;
}

/// The vertices of a triangle, in OBJ.
inline const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

} // namespace dirichlet
