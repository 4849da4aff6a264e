# SPDX-License-Identifier: GPL-3.0-or-later
"""One triangle in every format that is read: whole, and so that it can be damaged."""

import struct

OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
OFF = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
STL = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"
PLY = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
"""


def binary_ply(order: str = "little", corners: bytes | None = None) -> bytes:
    """The same triangle, `corners` in place of the bytes of its face."""
    mark = "<" if order == "little" else ">"
    header = PLY[: PLY.index("0 0 0")].replace("ascii", f"binary_{order}_endian").replace("uchar", "uint")
    places = struct.pack(mark + "9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    return header.encode() + places + (struct.pack(mark + "I3i", 3, 0, 1, 2) if corners is None else corners)


def binary_stl(promised: int = 1) -> bytes:
    return b" " * 80 + struct.pack("<I12fH", promised, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)


WHOLE = {
    "obj": OBJ, "off": OFF, "stl": STL, "ply": PLY,
    "little.ply": binary_ply(), "big.ply": binary_ply("big"), "binary.stl": binary_stl(),
}  # fmt: skip
