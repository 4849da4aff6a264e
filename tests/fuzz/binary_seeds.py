# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the seeds of corpus/mesh_files that are not text: tetrahedra in the binary forms of PLY and STL."""

import struct
from pathlib import Path

FOLDER = Path(__file__).parent / "corpus" / "mesh_files"
POSITIONS = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]


def ply(order: str, sign: str, number: str, count: str, index: str) -> bytes:
    """`sign` is the order as `struct` writes it; `number`, `count` and `index` are names of PLY's types."""
    letters = {"float": "f", "double": "d", "uchar": "B", "ushort": "H", "int": "i", "short": "h"}
    header = [
        "ply",
        f"format binary_{order}_endian 1.0",
        f"element vertex {len(POSITIONS)}",
        *(f"property {number} {axis}" for axis in "xyz"),
        f"element face {len(FACES)}",
        f"property list {count} {index} vertex_indices",
        "end_header\n",
    ]
    vertices = b"".join(struct.pack(sign + 3 * letters[number], *position) for position in POSITIONS)
    faces = b"".join(struct.pack(sign + letters[count] + 3 * letters[index], 3, *face) for face in FACES)
    return "\n".join(header).encode() + vertices + faces


def stl() -> bytes:
    triangles = (struct.pack("<12fH", 0, 0, 0, *(x for v in face for x in POSITIONS[v]), 0) for face in FACES)
    return b"made by a script".ljust(80) + struct.pack("<I", len(FACES)) + b"".join(triangles)


def main() -> None:
    FOLDER.joinpath("little_endian.ply").write_bytes(ply("little", "<", "float", "uchar", "int"))
    FOLDER.joinpath("big_endian.ply").write_bytes(ply("big", ">", "double", "ushort", "short"))
    FOLDER.joinpath("binary.stl").write_bytes(stl())


if __name__ == "__main__":
    main()
