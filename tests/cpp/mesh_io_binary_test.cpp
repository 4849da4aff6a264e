// SPDX-License-Identifier: GPL-3.0-or-later
// The formats that come in text and binary, PLY and STL.
#include "dirichlet/mesh_io.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <limits>
#include <sstream>

#include "mesh_file.h"

namespace dirichlet {
namespace {

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

TEST_F(PlyFile, bytes_that_are_no_text_stay_out_of_the_sentence) {
  EXPECT_REFUSED(read("a.ply", "ply\nformat ascii 1.0\nelement \xff\xfe x\nend_header\n"), InputError, "'?\?'");
}

TEST_F(PlyFile, a_header_that_promises_more_than_the_file_holds_is_refused_before_memory_is_asked_for) {
  for (const std::string format : {"ascii", "binary_little_endian"}) {
    EXPECT_REFUSED(read("a.ply", header(format, "100000000000") + points()), InputError, "100000000000 'vertex'");
    EXPECT_REFUSED(read("a.ply", header(format, "3", "100000000000") + points()), InputError, "100000000000 'face'");
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

TEST_F(MeshFile, stl_triangles_as_small_as_the_least_float_are_dropped_like_points) {
  const std::array<float, 9> good{0, 0, 0, 1, 0, 0, 0, 1, 0}, tiny{0, 0, 0, 1e-38F, 0, 0, 0, 1e-38F, 0};
  EXPECT_EQ(read("a.stl", binary_stl("", {good, tiny})).offsets.size(), 2U);
  EXPECT_REFUSED(read("a.stl", binary_stl("", {tiny})), InputError, "a.stl has no faces");
}

TEST_F(MeshFile, stl_is_not_written_of_triangles_that_its_precision_shrinks_to_points) {
  const Indices offsets{0, 3}, corners{0, 1, 2};
  for (const Doubles& positions :
       {Doubles{0, 0, 0, 1e-100, 0, 0, 0, 1e-100, 0}, Doubles{1e9, 0, 0, 1e9 + 1, 0, 0, 1e9, 1, 0}}) {
    write("a.stl", "precious");
    EXPECT_REFUSED(write_mesh_file(folder_ / "a.stl", positions, offsets, corners), InputError, "single precision");
    EXPECT_EQ(content(folder_ / "a.stl"), "precious");
  }
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

} // namespace
} // namespace dirichlet
