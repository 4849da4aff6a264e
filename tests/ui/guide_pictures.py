# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes the pictures of docs/guide.md anew: python3 tests/ui/guide_pictures.py, after ./run package."""

import subprocess

from window import BLENDER, OUT, ROOT, archives, run_inside

IMAGES = ROOT / "docs" / "images"
VIEWPORT = ("-crop", "1322x786+0+27", "-resize", "720x")
PALETTE = ("+dither", "-colors", "96", "-define", "png:compression-level=9")  # noise, dithered too, does not compress
CUTS = {  # in the docs: what was taken, and how it is cut
    "install": (["01-install.png"], ("-crop", "687x130+457+179")),
    "first-field": (["03-first-field.png"], VIEWPORT),
    "preview": (["04-preview-and-window.png"], VIEWPORT),
    "live": (["05-live-painting.png"], VIEWPORT),
    "result": (["06-result.png"], VIEWPORT),
    "animation": (["frame-01.png", "frame-09.png", "frame-17.png"], ("+append", "-resize", "1000x")),
    "stripes": (["stripes.png"], ()),
    "uneven-faces": (["uneven-graph.png", "uneven-intrinsic_delaunay.png"], ("-append",)),
}


def main() -> None:
    run_inside("guide", archive=archives.archive_for(BLENDER, OUT), limit=900)
    reduce_pictures()


def reduce_pictures() -> None:
    """Cut, and with fewer colours."""
    IMAGES.mkdir(parents=True, exist_ok=True)
    for name, (taken, cut) in CUTS.items():
        target = IMAGES / f"{name}.png"
        files = [str(OUT / "guide" / file) for file in taken]
        subprocess.run(["convert", *files, *cut, "-strip", *PALETTE, "+repage", str(target)], check=True)
        print(f"{target.relative_to(ROOT)}: {target.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
