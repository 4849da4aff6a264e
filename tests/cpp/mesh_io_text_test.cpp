// SPDX-License-Identifier: GPL-3.0-or-later
// The text formats OBJ and OFF, and numbers in any text.
#include "dirichlet/mesh_io.h"

#include "dirichlet/mesh.h"
#include "mesh_file.h"

namespace dirichlet {
namespace {

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
  EXPECT_REFUSED(read("a.obj", kTriangle + "f 1 2 -4\nv 0 0 1\n"), InputError, "line 4", "only 3 vertices");
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

TEST_F(MeshFile, coordinates_too_large_for_squares_are_refused_by_line_in_every_format) {
  EXPECT_REFUSED(read("a.obj", kTriangle + "v 0 1e200 0\nf 1 2 3\n"), InputError, "a.obj, line 4", "beyond 1e150");
  EXPECT_REFUSED(read("a.off", "OFF\n3 1 0\n0 0 0\n1 -1e200 0\n0 1 0\n3 0 1 2\n"), InputError, "line 4", "1e150");
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

} // namespace
} // namespace dirichlet
