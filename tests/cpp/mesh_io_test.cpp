// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/mesh_io.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <locale>

#include "mesh_file.h"
#include "mesh_makers.h"

namespace dirichlet {
namespace {

TEST_F(MeshFile, files_that_are_no_mesh_are_refused_by_name) {
  EXPECT_REFUSED(read_mesh_file(folder_ / "missing.obj"), InputError, "missing.obj", "No such file");
  EXPECT_REFUSED(read_mesh_file(folder_), InputError, "the ending ''");
  fs::create_directory(folder_ / "folder.obj");
  EXPECT_REFUSED(read_mesh_file(folder_ / "folder.obj"), InputError, "folder.obj", "directory");
  EXPECT_REFUSED(read("a.glb", "glTF"), InputError, "a.glb", "'.glb'", ".obj");
  for (const std::string ending : {"obj", "ply", "off", "stl"})
    EXPECT_REFUSED(read("a." + ending, ""), InputError, ("a." + ending).c_str(), "empty");
  EXPECT_REFUSED(read("a.obj", kTriangle + "l 1 2\n"), InputError, "a.obj has no faces");
  EXPECT_REFUSED(read("a.off", "OFF\n1 0 0\n0 0 0\n"), InputError, "a.off has no faces");
  EXPECT_REFUSED(read("a.stl", "solid a\nendsolid a\n"), InputError, "a.stl has no faces");
}

TEST_F(MeshFile, arrays_that_are_no_mesh_are_not_written) {
  const std::vector<double> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const auto write = [&](const std::string& ending, const std::vector<Index>& offsets,
                         const std::vector<Index>& corners) {
    write_mesh_file(folder_ / ("a." + ending), positions, offsets, corners);
  };
  for (const std::string ending : {"obj", "ply", "off", "stl"}) {
    EXPECT_REFUSED(write(ending, {0, 3, 6}, {0, 1, 2, 0, 3, 7}), InputError, "face 1 names vertex 3", "1 more corner");
    EXPECT_REFUSED(write(ending, {0, 3}, {0, 1, -1}), InputError, "face 0 names vertex -1");
    EXPECT_REFUSED(write(ending, {0, 4, 3}, {0, 1, 2}), InputError, "descend at place 2");
    EXPECT_REFUSED(write(ending, {1, 3}, {0, 1, 2}), InputError, "run from 1");
    EXPECT_REFUSED(write(ending, {}, {}), InputError, "no faces");
    EXPECT_REFUSED(write(ending, {0, 3, 5}, {0, 1, 2, 0, 1}), InputError, "face 1 has fewer than three corners");
    EXPECT_REFUSED(write(ending, {0, 2, 5, 6}, {0, 1, 0, 1, 2, 0}), InputError, "face 0 has fewer", "1 more such face");
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

/// As of a host that writes 1.234 for a thousand and more.
struct Grouping : std::numpunct<char> {
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

TEST_F(MeshFile, are_read_and_refused_alike_whatever_the_locale_of_the_host) {
  const auto soup = makers::grid(40, 40, false);
  const auto mesh = makers::make_mesh(soup);
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Grouping));
  for (const char* name : {"a.obj", "a.ply", "a.off", "a.stl"}) {
    write_mesh_file(folder_ / name, mesh->positions(), mesh->offsets(), mesh->corners());
    const MeshArrays read = read_mesh_file(folder_ / name);
    EXPECT_EQ(read.offsets.size(), name == std::string("a.stl") ? 3201U : 1601U) << name;
  }
  EXPECT_REFUSED(read("b.obj", kTriangle + "f 1 2 12345\n"), InputError, "12345");
  std::locale::global(before);
}

TEST_F(MeshFile, non_manifold_faces_arrive_whole) {
  std::string text = "v 0 0 0\nv 1 0 0\n";
  for (int f = 0; f < 12; ++f) text += "v 0 1 " + std::to_string(f) + "\nf 1 2 " + std::to_string(f + 3) + "\n";
  EXPECT_EQ(read("a.obj", text + "f 1 2 3\n").offsets.size(), 14U);
}

TEST_F(MeshFile, a_polygon_of_five_thousand_corners_survives_every_polygon_format) {
  makers::PolygonSoup soup;
  soup.faces.emplace_back();
  for (Index i = 0; i < 5000; ++i) {
    soup.positions.insert(soup.positions.end(), {std::cos(i / 800.0), std::sin(i / 800.0), 0.0});
    soup.faces[0].push_back(i);
  }
  for (const char* name : {"a.obj", "a.ply", "a.off"}) {
    write_mesh_file(folder_ / name, soup.positions, Indices{0, 5000}, soup.faces[0]);
    EXPECT_EQ(read_mesh_file(folder_ / name).corners, soup.faces[0]) << name;
  }
}

TEST_F(MeshFile, every_prefix_and_every_flipped_byte_of_a_file_is_read_or_refused) {
  const auto soup = makers::tetrahedron();
  const auto mesh = makers::make_mesh(soup);
  for (const std::string name : {"a.obj", "a.ply", "a.off", "a.stl"}) {
    write_mesh_file(folder_ / name, mesh->positions(), mesh->offsets(), mesh->corners());
    const std::string good = content(folder_ / name);
    const auto attempt = [&](const std::string& bytes) {
      try {
        const auto arrays = read("damaged_" + name, bytes);
        EXPECT_EQ(arrays.corners.size(), static_cast<std::size_t>(arrays.offsets.back()));
        for (const Index v : arrays.corners) EXPECT_LT(static_cast<std::size_t>(v), arrays.positions.size() / 3);
      } catch (const InputError&) { // anything else fails the test
      }
    };
    for (std::size_t i = 0; i < good.size(); ++i) {
      attempt(good.substr(0, i));
      for (const char flip : {'\x04', '\xFF'}) {
        std::string damaged = good;
        damaged[i] = static_cast<char>(damaged[i] ^ flip);
        attempt(damaged);
      }
    }
  }
}

TEST_F(MeshFile, reading_and_inspecting_print_nothing) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  read("a.obj", "mtllib gone.mtl\nusemtl none\nvt 1\n" + kTriangle + "f 1 2 3\nf 1 2 3\n");
  EXPECT_THROW(read("a.ply", "ply\nformat ascii 1.0\nelement strip 1\nend_header\n"), InputError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST_F(MeshFile, meshes_of_the_shared_folder_have_the_counts_their_makers_state) {
  struct Known {
    const char* name;
    std::size_t vertices, faces;
  };
  const fs::path folder = fs::path(__FILE__).parent_path() / "../../../shared/meshes"; // beside the checkout
  if (!fs::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
  for (const Known& known : {Known{"derived__dragon_28k.obj", 14094, 28188},
                             {"trimesh__negative_indices.obj", 8, 6},
                             {"draco__non_manifold_wrap.obj", 10, 12},
                             {"polyLaplace__dual_hemisphere.off", 3600, 1741},
                             {"trimesh__whitespace.off", 8, 6},
                             {"potpourri3d__bunny_poly.ply", 1241, 1482},
                             {"trimesh__fixed_top.ply", 2374, 4772},
                             {"trimesh__multibody.stl", 20, 32},
                             {"trimesh__featuretype.STL", 2010, 3476},
                             {"trimesh__soup.stl", 300, 100}}) {
    const auto mesh = read_mesh_file(folder / known.name);
    EXPECT_EQ(mesh.positions.size(), 3 * known.vertices) << known.name;
    EXPECT_EQ(mesh.offsets.size(), known.faces + 1) << known.name;
  }
}

// --- writing

TEST_F(MeshFile, what_is_written_is_read_back_bit_for_bit) {
  const auto soup = makers::torus(7, 5, false);
  const auto mesh = makers::make_mesh(soup);
  Doubles positions(mesh->positions().begin(), mesh->positions().end());
  for (double& x : positions) x = 1e6 + x / 3;
  for (const char* name : {"a.obj", "a.ply", "a.off"}) {
    write_mesh_file(folder_ / name, positions, mesh->offsets(), mesh->corners());
    const auto arrays = read_mesh_file(folder_ / name);
    EXPECT_EQ(arrays.positions, positions) << name;
    EXPECT_TRUE(std::ranges::equal(arrays.corners, mesh->corners())) << name;
    EXPECT_TRUE(std::ranges::equal(arrays.offsets, mesh->offsets())) << name;
  }
}

TEST_F(MeshFile, stl_is_written_in_triangles_of_single_precision) {
  const auto mesh = makers::make_mesh(makers::grid(2, 2, false));
  write_mesh_file(folder_ / "a.stl", mesh->positions(), mesh->offsets(), mesh->corners());
  const auto arrays = read_mesh_file(folder_ / "a.stl");
  EXPECT_EQ(arrays.corners.size(), 24U);
  EXPECT_EQ(arrays.positions.size(), 27U);
  EXPECT_REFUSED(
      write_mesh_file(folder_ / "b.stl", Doubles{0, 0, 0, 1, 0, 0, 0, 1e39, 0}, Indices{0, 3}, Indices{0, 1, 2}),
      InputError, "vertex 2", "1e+39", "single precision");
  EXPECT_FALSE(fs::exists(folder_ / "b.stl"));
}

TEST_F(MeshFile, ply_carries_colours_in_bytes_and_no_other_format_does) {
  const Doubles positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<unsigned char> colors{255, 0, 1, 2, 3, 4, 5, 6, 7};
  const auto written = [&](const char* name) {
    write_mesh_file(folder_ / name, positions, Indices{0, 3}, Indices{0, 1, 2}, colors);
    return content(folder_ / name);
  };
  const std::string bytes = written("a.ply");
  EXPECT_NE(bytes.find("property uchar red\nproperty uchar green\nproperty uchar blue\n"), std::string::npos);
  std::string vertices;
  for (std::size_t v = 0; v < 3; ++v) {
    vertices += binary(false, positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
    vertices += binary(false, colors[3 * v], colors[3 * v + 1], colors[3 * v + 2]);
  }
  EXPECT_NE(bytes.find(vertices), std::string::npos);
  EXPECT_EQ(read_mesh_file(folder_ / "a.ply").positions, positions);
  EXPECT_REFUSED(written("a.obj"), InputError, "a.obj", "colours");
  EXPECT_REFUSED(
      write_mesh_file(folder_ / "a.ply", positions, Indices{0, 3}, Indices{0, 1, 2}, std::span(colors).first(6)),
      InputError, "2 colours", "3 vertices");
}

TEST_F(MeshFile, a_refused_write_leaves_what_was_there_and_nothing_else) {
  const Doubles positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const auto attempt = [&](const fs::path& path) { write_mesh_file(path, positions, Indices{0, 3}, Indices{0, 1, 2}); };
  fs::create_directories(folder_ / "taken.obj" / "inside");
  EXPECT_REFUSED(attempt(folder_ / "taken.obj"), InputError, "taken.obj", "cannot be written");
  EXPECT_REFUSED(attempt(folder_ / "gone" / "a.obj"), InputError, "a.obj", "cannot be written", "No such file");
  EXPECT_REFUSED(attempt(folder_ / "a.xyz"), InputError, "a.xyz", "'.xyz'");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
  attempt(write("old.obj", "old"));
  EXPECT_EQ(content(folder_ / "old.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 2);
}

} // namespace
} // namespace dirichlet
