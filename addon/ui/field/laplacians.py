# SPDX-License-Identifier: GPL-3.0-or-later
"""The Laplacians of the library, and when to take which: written here so that nothing is imported to register them."""

LAPLACIANS = (
    (
        "graph",
        "Graph",
        "Every neighbor counts alike, whatever the shape, as in the paper: for any mesh, and for lines that "
        "go by the mesh's density. Values stay between the painted ones",
    ),
    (
        "cotangent",
        "Cotangent",
        "By the shape, as most programs do it: for meshes of good triangles. Obtuse ones may push values "
        "beyond the painted ones",
    ),
    (
        "intrinsic_delaunay",
        "Intrinsic Delaunay",
        "By the shape, whatever the triangles: for scans, CAD exports and other uneven meshes. Values stay "
        "between the painted ones",
    ),
    (
        "polygon",
        "Polygon",
        "By the shape of quads and n-gons, none of whose diagonals is preferred: for modeled meshes. Uneven "
        "faces may push values beyond the painted ones",
    ),
    (
        "auto",
        "Automatic",
        "By the shape, with Cotangent or Polygon where values stay between the painted ones, else with "
        "Intrinsic Delaunay: for lines that do not depend on how the mesh is cut. The results say what was "
        "taken",
    ),
)
