// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/mesh_io.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "dirichlet/mesh.h"
#include "mesh_makers.h"
#include "refusal.h"

namespace dirichlet {
namespace {

namespace fs = std::filesystem;
using Doubles = std::vector<double>;
using Indices = std::vector<Index>;

/// A file of the test's own, in a folder of its own.
class MeshFile : public testing::Test {
 protected:
  MeshFile() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("dirichlet_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~MeshFile() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  MeshArrays read(const std::string& name, const std::string& bytes) { return read_mesh_file(write(name, bytes)); }

  fs::path folder_;
};

std::string with_line_ends(const std::string& text, const char* end) {
  std::string out;
  for (const char c : text) out += c == '\n' ? std::string(end) : std::string(1, c);
  return out;
}

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Little-endian, as the machines that run these tests are; reversed for the other order.
template <class... Numbers>
std::string binary(bool big, Numbers... numbers) {
  static_assert(std::endian::native == std::endian::little);
  std::string out;
  const auto append = [&](auto number) {
    auto raw = std::bit_cast<std::array<char, sizeof number>>(number);
    if (big) std::reverse(raw.begin(), raw.end());
    out.append(raw.data(), raw.size());
  };
  (append(numbers), ...);
  return out;
}

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

// --- OBJ

TEST_F(MeshFile, obj_corners_are_read_in_every_notation) {
  const auto mesh = read("a.obj", kTriangle + "vt 0 0\nvt 0.5\nvn 0 0 1\nf 1 2 3\nf 1/1 2/2 3/1\nf 1//1 2//1 3//1\n"
                                              "f 1/1/1 2/2/1 3/1/1\nf -3 -2 -1\nf 1// 2// 3//\n");
  Indices expected;
  for (int face = 0; face < 6; ++face) expected.insert(expected.end(), {0, 1, 2});
  EXPECT_EQ(mesh.corners, expected);
  EXPECT_EQ(mesh.positions, (Doubles{0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

TEST_F(MeshFile, obj_faces_may_stand_before_their_vertices) {
  EXPECT_EQ(read("a.obj", "f 3 1 2\n" + kTriangle).corners, (Indices{2, 0, 1}));
}

TEST_F(MeshFile, obj_negative_indices_count_back_from_the_line_they_are_on) {
  EXPECT_EQ(read("a.obj", kTriangle + "f -3 -2 -1\nv 5 5 5\nf -3 -2 -1\n").corners, (Indices{0, 1, 2, 1, 2, 3}));
}

TEST_F(MeshFile, windows_and_old_mac_line_ends_and_a_byte_order_mark_are_legal) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const auto mesh = read("a.obj", "\xEF\xBB\xBF" + with_line_ends(kTriangle + "f 1 2 3 \t\n\n", end));
    EXPECT_EQ(mesh.corners, (Indices{0, 1, 2}));
    EXPECT_EQ(mesh.positions.size(), 9U);
  }
}

TEST_F(MeshFile, obj_comments_groups_materials_points_and_lines_are_passed_over) {
  const auto mesh = read("a.obj", "# head\nmtllib gone.mtl\no name\ng a b\n" + kTriangle +
                                      "usemtl none\ns off\np 1\nl 1 2\nf 1 2 3 # a face\n#f 9 9 9\n");
  EXPECT_EQ(mesh.corners, (Indices{0, 1, 2}));
}

TEST_F(MeshFile, obj_lines_may_be_continued) {
  EXPECT_EQ(read("a.obj", "v 0 \\\n0 0\n" + kTriangle + "f 1 \\\r\n 2 3 \\\n4\n").corners, (Indices{0, 1, 2, 3}));
}

TEST_F(MeshFile, obj_colours_and_weights_behind_a_coordinate_are_passed_over) {
  const auto mesh = read("a.obj", "v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nf 1 2 3");
  EXPECT_EQ(mesh.positions, (Doubles{0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

TEST_F(MeshFile, a_quad_with_a_corner_said_twice_in_succession_is_the_triangle) {
  const auto mesh = read("a.obj", kTriangle + "f 1 2 3 3\nf 1 2 3 1\n");
  EXPECT_EQ(mesh.offsets.size(), 3U);
  EXPECT_EQ(Mesh(Doubles(mesh.positions), mesh.offsets, mesh.corners).corners().size(), 6U);
}

TEST_F(MeshFile, obj_damage_is_refused_with_its_line) {
  EXPECT_REFUSED(read("a.obj", kTriangle + "f 1 2 4\n"), InputError, "a.obj, line 4", "vertex 4", "1 to 3");
  EXPECT_REFUSED(read("a.obj", kTriangle + "f 1 2 0\n"), InputError, "line 4", "vertex 0");
  EXPECT_REFUSED(read("a.obj", kTriangle + "f 1 2 -4\n"), InputError, "line 4", "vertex -4", "3 vertices");
  EXPECT_REFUSED(read("a.obj", kTriangle + "f 1 2 99999999999\n"), InputError, "line 4", "99999999999");
  EXPECT_REFUSED(read("a.obj", kTriangle + "f 1 2\n"), InputError, "line 4", "2 corners");
  EXPECT_REFUSED(read("a.obj", kTriangle + "f 1\n"), InputError, "line 4", "1 corner,");
  EXPECT_REFUSED(read("a.obj", kTriangle + "f 1 2 2\n"), InputError, "line 4", "three different");
  EXPECT_REFUSED(read("a.obj", kTriangle + "v 0 0 1\nf 1 2 3 2 4\n"), InputError, "line 5", "vertex 2 twice");
  EXPECT_REFUSED(read("a.obj", kTriangle + "f 1 2 3.5\n"), InputError, "line 4", "'3.5'");
  EXPECT_REFUSED(read("a.obj", kTriangle + "f 1 2 3/x\n"), InputError, "line 4", "'3/x'");
  EXPECT_REFUSED(read("a.obj", kTriangle + "f 1 2 3/1/1/1\n"), InputError, "line 4", "'3/1/1/1'");
  EXPECT_REFUSED(read("a.obj", "v 0 0 zero\nf 1 1 1\n"), InputError, "line 1", "'zero'");
  EXPECT_REFUSED(read("a.obj", "v 0 0\nf 1 1 1\n"), InputError, "line 1", "2 coordinates");
}

// --- numbers, in any text

TEST_F(MeshFile, coordinates_keep_their_double_precision) {
  const Doubles tiny{1e-160, -1e-160, 2e-160, 1e150, 0.1, -1e13, 10000000000000.002, 123456789.123456789, 5e-324};
  const std::string obj =
      "v 1e-160 -1e-160 +2e-160\nv 1e150 0.1 -1e13\nv 10000000000000.002 123456789.123456789 5e-324\n"
      "f 1 2 3\n";
  EXPECT_EQ(read("a.obj", obj).positions, tiny);
  EXPECT_EQ(read("a.off", "OFF\n3 1 0\n1e-160 -1e-160 2e-160\n1e150 .1 -1e13\n10000000000000.002 123456789.123456789 "
                          "5e-324\n3 0 1 2\n")
                .positions,
            tiny);
  EXPECT_EQ(read("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double "
                 "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n1e-160 -1e-160 "
                 "2e-160\n1e150 0.1 -1e13\n10000000000000.002 123456789.123456789 5e-324\n3 0 1 2\n")
                .positions,
            tiny);
}

TEST_F(MeshFile, a_number_too_small_for_a_double_is_zero_and_one_too_large_is_refused) {
  EXPECT_EQ(read("a.obj", "v 1e-999 0 0\n" + kTriangle + "f 1 2 3\n").positions[0], 0.0);
  EXPECT_EQ(read("a.obj", "v 0." + std::string(400, '0') + "1 0 0\n" + kTriangle + "f 1 2 3\n").positions[0], 0.0);
  EXPECT_REFUSED(read("a.obj", "v 1e999 0 0\n" + kTriangle + "f 1 2 3\n"), InputError, "line 1", "not finite");
  EXPECT_REFUSED(read("a.obj", "v 1" + std::string(400, '0') + " 0 0\nf 1 1 1\n"), InputError, "line 1", "not finite");
}

TEST_F(MeshFile, numbers_that_are_not_finite_are_refused_in_every_format) {
  for (const std::string bad : {"nan", "inf", "-inf", "NaN"}) {
    EXPECT_REFUSED(read("a.obj", kTriangle + "v 0 " + bad + " 0\nf 1 2 3\n"), InputError, "line 4", "not finite");
    EXPECT_REFUSED(read("a.off", "OFF\n3 1 0\n0 0 0\n1 0 " + bad + "\n0 1 0\n3 0 1 2\n"), InputError, "line 4",
                   "not finite");
    EXPECT_REFUSED(read("a.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 " + bad), InputError, "line 4",
                   "not finite");
  }
}

// --- OFF

TEST_F(MeshFile, off_comments_colours_normals_and_counts_on_the_first_line_are_legal) {
  const Doubles positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  for (const std::string text : {
           "OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
           "OFF 3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
           "OFF3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
           "# head\n\nOFF # magic\n# counts\n3 1 0\n\n0 0 0 # first\n1 0 0\n0 1 0\n\n# faces\n3 0 1 2\n# end\n",
           "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 0 0 255 255\n3 0 1 2 255 255 255\n",
           "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2 0.5 0.5 0.5 1\n",
           "STCNOFF\r\n3 1 0\r\n0 0 0 1 2\r\n1 0 0 1 2\r\n0 1 0 1 2\r\n3 0 1 2\r\n",
       }) {
    const auto mesh = read("a.off", text);
    EXPECT_EQ(mesh.positions, positions) << text;
    EXPECT_EQ(mesh.corners, (Indices{0, 1, 2})) << text;
  }
}

TEST_F(MeshFile, off_damage_is_refused_with_its_line) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_REFUSED(read("a.off", "PFF\n3 1 0\n" + points + "3 0 1 2\n"), InputError, "line 1", "'PFF'");
  EXPECT_REFUSED(read("a.off", "4OFF\n3 1 0\n" + points + "3 0 1 2\n"), InputError, "line 1", "'4OFF'");
  EXPECT_REFUSED(read("a.off", "OFF BINARY\n"), InputError, "line 1", "binary OFF");
  EXPECT_REFUSED(read("a.off", "OFF\n100000000000 1 0\n" + points), InputError, "line 2", "100000000000");
  EXPECT_REFUSED(read("a.off", "OFF\n3 100000000000 0\n" + points), InputError, "line 2", "100000000000");
  EXPECT_REFUSED(read("a.off", "OFF\n3 -1 0\n" + points), InputError, "line 2", "-1");
  EXPECT_REFUSED(read("a.off", "OFF\n3 1 0\n" + points + "3 0 1 3\n"), InputError, "line 6", "vertex 3", "0 to 2");
  EXPECT_REFUSED(read("a.off", "OFF\n3 1 0\n" + points + "3 0 1 -1\n"), InputError, "line 6", "vertex -1");
  EXPECT_REFUSED(read("a.off", "OFF\n3 1 0\n" + points + "2 0 1\n   "), InputError, "line 6", "is 2");
  EXPECT_REFUSED(read("a.off", "OFF\n3 1 0\n" + points + "90000 0 1 2\n"), InputError, "line 6", "90000");
  EXPECT_REFUSED(read("a.off", "OFF\n3 1 0\n" + points + "3 0 1 two\n"), InputError, "line 6", "'two'");
  EXPECT_REFUSED(read("a.off", "OFF\n3 1 0\n0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n"), InputError, "line 4", "'x'");
  EXPECT_REFUSED(read("a.off", "OFF\n3 2 0\n" + points + "3 0 1 2\n     "), InputError, "the file ends");
  EXPECT_REFUSED(read("a.off", "OFF\n3 1 0\n" + points + "3 0 1 2\n3 0 1 2\n"), InputError, "line 7", "after the last");
}

// --- PLY

/// A triangle with much around it that is not asked for, in any encoding and with lists counted in any type.
template <class Count, class Corner>
std::string rich_ply(const std::string& encoding, const std::string& count, const std::string& corner) {
  const bool text = encoding == "ascii", big = encoding == "binary_big_endian";
  const auto numbers = [&]<class... N>(N... n) {
    if (!text) return binary(big, n...);
    std::ostringstream out;
    ((out << +n << ' '), ...);
    return out.str() + '\n';
  };
  std::string file = "ply\nformat " + encoding +
                     " 1.0\ncomment made by hand \\\nobj_info of no use\n"
                     "element camera 1\nproperty list uchar short path\nproperty char zoom\n"
                     "element vertex 3\nproperty uchar red\nproperty float z\nproperty int x\nproperty float64 y\n"
                     "property list int8 float32 weights\n"
                     "element face 2\nproperty list uint float texcoord\nproperty list " +
                     count + " " + corner +
                     " vertex_index\nproperty uchar green\nelement edge 1\nproperty int vertex1\n"
                     "end_header\n";
  file += numbers(std::uint8_t{2}, std::int16_t{7}, std::int16_t{8}, std::int8_t{-1});
  file += numbers(std::uint8_t{255}, 0.5F, std::int32_t{0}, 0.0, std::int8_t{0});
  file += numbers(std::uint8_t{0}, 0.5F, std::int32_t{1}, 0.0, std::int8_t{1}, 0.25F);
  file += numbers(std::uint8_t{0}, 0.5F, std::int32_t{0}, 1.0, std::int8_t{0});
  file += numbers(std::uint32_t{1}, 0.5F, Count{3}, Corner{0}, Corner{1}, Corner{2}, std::uint8_t{9});
  file += numbers(std::uint32_t{0}, Count{3}, Corner{2}, Corner{1}, Corner{0}, std::uint8_t{9});
  return file + numbers(std::int32_t{0});
}

TEST_F(MeshFile, ply_is_read_in_every_encoding_and_type_past_properties_that_are_not_asked_for) {
  for (const std::string encoding : {"ascii", "binary_little_endian", "binary_big_endian"})
    for (const std::string& file : {rich_ply<std::uint8_t, std::int32_t>(encoding, "uchar", "int"),
                                    rich_ply<std::int8_t, std::uint8_t>(encoding, "char", "uint8"),
                                    rich_ply<std::uint16_t, std::int16_t>(encoding, "ushort", "int16"),
                                    rich_ply<std::int32_t, std::uint32_t>(encoding, "int32", "uint"),
                                    rich_ply<std::uint32_t, std::int8_t>(encoding, "uint32", "char")}) {
      const auto mesh = read("a.ply", file);
      EXPECT_EQ(mesh.positions, (Doubles{0, 0, 0.5, 1, 0, 0.5, 0, 1, 0.5})) << file;
      EXPECT_EQ(mesh.corners, (Indices{0, 1, 2, 2, 1, 0})) << file;
    }
}

TEST_F(MeshFile, ply_headers_may_end_their_lines_like_windows) {
  std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  file = with_line_ends(file, "\r\n");
  file += binary(false, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, std::uint8_t{3}, 0, 1, 2);
  EXPECT_EQ(read("a.ply", file).corners, (Indices{0, 1, 2}));
}

class PlyFile : public MeshFile {
 protected:
  static std::string header(const std::string& format, const std::string& vertices = "3",
                            const std::string& faces = "1") {
    return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  }
  static std::string points(bool big = false) { return binary(big, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F); }
};

TEST_F(PlyFile, damage_to_a_text_is_refused_with_its_line) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_REFUSED(read("a.ply", header("ascii") + points + "3 0 1 3\n"), InputError, "line 13", "vertex 3", "0 to 2");
  EXPECT_REFUSED(read("a.ply", header("ascii") + points + "3 0 1 -1\n"), InputError, "line 13", "vertex -1");
  EXPECT_REFUSED(read("a.ply", header("ascii") + points + "3 0 1 0.5\n"), InputError, "line 13", "'0.5'");
  EXPECT_REFUSED(read("a.ply", header("ascii") + points + "2 0 1\n"), InputError, "line 13", "2 corners");
  EXPECT_REFUSED(read("a.ply", header("ascii") + points + "1000 0 1 2\n"), InputError, "line 13", "1000");
  EXPECT_REFUSED(read("a.ply", header("ascii") + points + "3 0 1\n"), InputError, "the file ends");
  EXPECT_REFUSED(read("a.ply", header("ascii") + points + "3 0 1 2\n3 0 1 2\n"), InputError, "line 14", "goes on");
  EXPECT_REFUSED(read("a.ply", header("ascii") + "0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n"), InputError, "line 11", "'zero'");
  EXPECT_REFUSED(read("a.ply", header("ascii") + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), InputError, "line 11", "vertex 1",
                 "not finite");
}

TEST_F(PlyFile, damage_to_a_binary_is_refused_with_its_byte) {
  const std::string head = header("binary_little_endian"), start = head + points();
  EXPECT_EQ(read("a.ply", start + binary(false, std::uint8_t{3}, 0, 1, 2)).corners, (Indices{0, 1, 2}));
  const auto byte = [](std::size_t at) { return "byte " + std::to_string(at) + ":"; };

  EXPECT_REFUSED(read("a.ply", start + binary(false, std::uint8_t{3}, 0, 1, 3)), InputError,
                 byte(start.size() + 9).c_str(), "vertex 3", "0 to 2");
  EXPECT_REFUSED(read("a.ply", start + binary(false, std::uint8_t{3}, 0, 1)), InputError,
                 byte(start.size() + 9).c_str(), "the file ends");
  EXPECT_REFUSED(read("a.ply", start + binary(false, std::uint8_t{200}, 0, 1, 2)), InputError,
                 byte(start.size()).c_str(), "200");
  EXPECT_REFUSED(read("a.ply", start + binary(false, std::uint8_t{2}, 0, 1, 2)), InputError, "2 corners");
  EXPECT_REFUSED(read("a.ply", start + binary(false, std::uint8_t{3}, 0, 1, 2, 7)), InputError, "goes on");
  EXPECT_REFUSED(read("a.ply", head + binary(false, 0.F, 0.F, std::numeric_limits<float>::infinity()) + points()),
                 InputError, byte(head.size() + 8).c_str(), "vertex 0", "not finite");
}

TEST_F(PlyFile, a_header_that_names_the_wrong_byte_order_is_refused) {
  for (const bool big : {false, true})
    EXPECT_REFUSED(read("a.ply", header(big ? "binary_little_endian" : "binary_big_endian") + points(big) +
                                     binary(big, std::uint8_t{3}, 0, 1, 2)),
                   InputError, "byte", "vertex 16777216");
}

TEST_F(PlyFile, a_header_that_promises_more_than_the_file_holds_is_refused_before_memory_is_asked_for) {
  for (const std::string format : {"ascii", "binary_little_endian"}) {
    EXPECT_REFUSED(read("a.ply", header(format, "100000000000") + points()), InputError, "100000000000 vertex");
    EXPECT_REFUSED(read("a.ply", header(format, "3", "100000000000") + points()), InputError, "100000000000 face");
    EXPECT_REFUSED(read("a.ply", header(format, "-3") + points()), InputError, "line 3", "-3");
    EXPECT_REFUSED(read("a.ply", header(format, "99999999999999999999") + points()), InputError, "line 3");
  }
}

TEST_F(PlyFile, a_damaged_header_is_refused_with_its_line) {
  const auto without = [](std::string text, const std::string& part, const std::string& other = "") {
    return text.replace(text.find(part), part.size(), other);
  };
  const std::string good = header("ascii") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(read("a.ply", good).corners, (Indices{0, 1, 2}));
  EXPECT_REFUSED(read("a.ply", without(good, "ply\n", "plx\n")), InputError, "line 1", "'ply'");
  EXPECT_REFUSED(read("a.ply", without(good, "ascii", "ebcdic")), InputError, "line 2", "'ebcdic'");
  EXPECT_REFUSED(read("a.ply", without(good, "format ascii 1.0\n")), InputError, "no format");
  EXPECT_REFUSED(read("a.ply", without(good, "property float z\n")), InputError, "no z");
  EXPECT_REFUSED(read("a.ply", without(good, "float x", "real x")), InputError, "line 4", "'real'");
  EXPECT_REFUSED(read("a.ply", without(good, "list uchar", "list float")), InputError, "line 8", "fractions");
  EXPECT_REFUSED(read("a.ply", without(good, "vertex_indices", "corners")), InputError, "vertex indices");
  EXPECT_REFUSED(read("a.ply", without(good, "element face 1\n")), InputError, "no face");
  EXPECT_REFUSED(read("a.ply", good.substr(0, good.find("element face"))), InputError, "line 7", "no end");
}

// --- STL

const std::string kFacet = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\n"
                           "endfacet\n";
const std::string kBackFacet = "facet normal nan nan nan\n outer loop\n  vertex 0 1 0\n  vertex 1 0 0\n"
                               "  vertex 1 1 0\n endloop\nendfacet\n";

std::string binary_stl(const std::string& head, const std::vector<std::array<float, 9>>& triangles) {
  std::string file =
      head + std::string(80 - head.size(), ' ') + binary(false, static_cast<std::uint32_t>(triangles.size()));
  for (const auto& triangle : triangles) {
    file += binary(false, 0.F, 0.F, 1.F);
    for (const float x : triangle) file += binary(false, x);
    file += std::string(2, '\0');
  }
  return file;
}

TEST_F(MeshFile, stl_corners_of_equal_coordinates_are_joined) {
  const Doubles positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  for (const std::string& file :
       {"solid a\n" + kFacet + kBackFacet + "endsolid a\n",
        "solid outer loop\n" + kFacet + "endsolid\nsolid b\n\n" + kBackFacet + "endsolid b",
        binary_stl("made by hand", {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {-0.F, 1, 0, 1, 0, 0, 1, 1, 0}}),
        binary_stl("solid in name only", {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 0, 1, 0, 0, 1, 1, 0}})}) {
    const auto mesh = read("a.STL", file);
    EXPECT_EQ(mesh.positions, positions);
    EXPECT_EQ(mesh.corners, (Indices{0, 1, 2, 2, 1, 3}));
  }
}

TEST_F(MeshFile, stl_words_may_be_in_capitals_and_spread_over_lines) {
  std::string file = "solid a\n" + kFacet + "endsolid a\n";
  std::transform(file.begin(), file.end(), file.begin(), [](char c) { return static_cast<char>(std::toupper(c)); });
  std::replace(file.begin() + 8, file.end() - 12, ' ', '\n');
  EXPECT_EQ(read("a.stl", file).corners, (Indices{0, 1, 2}));
}

TEST_F(MeshFile, stl_triangles_that_joining_shrinks_to_an_edge_are_dropped) {
  EXPECT_EQ(read("a.stl", binary_stl("", {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 1, 0, 0, 1, 0, 0}})).offsets.size(),
            2U);
}

TEST_F(MeshFile, stl_damage_is_refused_with_its_line_or_byte) {
  EXPECT_REFUSED(read("a.stl", "solid a\n" + kFacet), InputError, "a.stl, line 9", "the file ends");
  EXPECT_REFUSED(read("a.stl", "solid a\n" + kFacet.substr(0, 46)), InputError, "line 5", "the file ends");
  EXPECT_REFUSED(read("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero"), InputError, "line 4",
                 "'zero'");
  EXPECT_REFUSED(read("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1e39"), InputError, "line 4",
                 "single precision");
  EXPECT_REFUSED(read("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop"), InputError, "line 5",
                 "'endloop'", "'vertex'");
  const std::string good = binary_stl("", {{0, 0, 0, 1, 0, 0, 0, 1, 0}});
  EXPECT_REFUSED(read("a.stl", good.substr(0, 120)), InputError, "byte 80", "1 triangles", "134", "120");
  EXPECT_REFUSED(read("a.stl", good + "more"), InputError, "byte 80", "138");
  EXPECT_REFUSED(read("a.stl", "neither"), InputError, "byte 80");
  std::string infinite = good;
  infinite.replace(96, 4, binary(false, std::numeric_limits<float>::infinity()));
  EXPECT_REFUSED(read("a.stl", infinite), InputError, "byte 96", "triangle 0", "not finite");
}

// --- any file

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
      for (const char flip : {'\x01', '\xFF'}) {
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
  EXPECT_NE(bytes.find(binary(false, 0., 0., 0.) + "\xFF" + std::string(1, '\0') + "\x01" + binary(false, 1.)),
            std::string::npos);
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
