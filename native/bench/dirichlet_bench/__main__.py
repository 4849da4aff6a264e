# SPDX-License-Identifier: GPL-3.0-or-later
"""Ours beside other libraries: same meshes, same paint, one run.

Into the output folder go report.md, report.json and the pictures.
"""

import argparse
import json
import re
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from . import machine, report
from .contest import PEER_PYTHON, PEERS, ROOT, Effort, compete, taking_part
from .scene import load
from .scene_maker import folder_of, vertex_count

DRAGON = ROOT.parent / "shared/meshes/derived__dragon_28k.obj"
KINDS = ("shuffled", "tube", "pieces", "cotangent")
SCENE = re.compile(f"[1-9][0-9]*[kM]( {'| '.join(KINDS)})?")
QUICK = ("14k", "125k")
USUAL = ("14k", *(f"125k {kind}" for kind in KINDS), "125k", "1M")
FULL = (*USUAL, "2M", "4M", "10M")
STORE = ROOT / "build/bench/scenes"
EFFORTS = {  # up to so many vertices: what may take how long, so that all scenes take half an hour
    20_000: Effort(15, 1.0, 60.0),
    200_000: Effort(7, 3.0, 60.0),
    1_000_000: Effort(5, 2.0, 75.0),
    2_000_000: Effort(3, 2.0, 50.0),
    5_000_000: Effort(2, 2.0, 75.0),
}
LARGEST_EFFORT = Effort(2, 5.0, 300.0)
QUICK_EFFORT = Effort(5, 0.5, 20.0)
ODD_RUNS, ODD_SECONDS = 3, 1.0


def parse(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./run bench", description=__doc__.splitlines()[0])
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--quick", action="store_true", help=f"{' and '.join(QUICK)} vertices, few runs: two minutes")
    how.add_argument("--full", action="store_true", help=f"all meshes: {', '.join(FULL)}")
    how.add_argument("--scenes", nargs="+", metavar="SCENE", help='others, such as 10M or "1M tube"')
    parser.add_argument("--only", nargs="+", metavar="WORD", help="contestants with one of these words in their title")
    parser.add_argument("--add", action="store_true", help="keep the other scenes that the output folder's report has")
    parser.add_argument("--runs", type=int, help="medians over so many runs (default by size; so the next two)")
    parser.add_argument("--seconds", type=float, help="begin no run after so many of one stage")
    parser.add_argument("--limit", type=float, help="seconds of one contestant on one mesh")
    parser.add_argument(
        "--base", type=Path, default=DRAGON, metavar="MESH", help="refined to the sizes; a torus if missing"
    )
    parser.add_argument("--output", type=Path, default=ROOT / "build/bench/report", metavar="FOLDER")
    options = parser.parse_args(words)
    options.names = options.scenes or (QUICK if options.quick else FULL if options.full else USUAL)
    for name in options.names:
        if not SCENE.fullmatch(name):
            parser.error(f"no scene {name!r}: a size such as 14k or 2M, then nothing or one of {', '.join(KINDS)}")
    return options


def effort_for(name: str, options: argparse.Namespace) -> Effort:
    count = vertex_count(name)
    usual = next((effort for most, effort in EFFORTS.items() if count <= most), LARGEST_EFFORT)
    if options.quick:
        usual = QUICK_EFFORT
    elif " " in name:
        usual = replace(usual, runs=min(ODD_RUNS, usual.runs), seconds=min(ODD_SECONDS, usual.seconds))
    asked = {name: getattr(options, name) for name in ("runs", "seconds", "limit")}
    return replace(usual, **{name: value for name, value in asked.items() if value is not None})


def measure(name: str, options: argparse.Namespace) -> Iterator[dict[str, Any]]:
    """All contestants on one scene: what is known of it after each. Never fails."""
    effort = effort_for(name, options)
    known: dict[str, Any] = {"scene": name, "effort": asdict(effort), **machine.moment(), "results": []}
    folder = folder_of(name, options.base, STORE)
    if not folder.is_dir():  # in a process of its own, whose memory comes back
        print(f"{name}: making it", flush=True)
        subprocess.run([sys.executable, "-m", f"{__package__}.scene_maker", name, options.base, STORE, PEERS])
    if not folder.is_dir():
        yield known | {"trouble": "the scene could not be made"}
        return
    scene = load(folder)
    painted = int((scene.first == scene.first).sum())
    known |= {"vertices": len(scene.positions), "faces": len(scene.faces), "painted": painted}
    del scene
    for contestant in taking_part(name, known["vertices"], options.only):
        print(f"{name}: {contestant.title}", end="", flush=True)
        result = compete(contestant, folder, effort)
        print(f" {result.trouble}".rstrip(), flush=True)
        known["results"].append(asdict(result))
        yield known


def main(words: list[str]) -> int:
    options = parse(words)
    options.output.mkdir(parents=True, exist_ok=True)
    file = options.output / "report.json"
    data: dict[str, Any] = {"machine": machine.describe(), "scenes": []}
    if options.add and file.exists():
        data["scenes"] = json.loads(file.read_text(encoding="utf-8"))["scenes"]
    scenes = {scene["scene"]: scene for scene in data["scenes"]}
    for name in options.names:
        for scene in measure(name, options):  # written as it comes: a long run that is stopped has its part
            scenes[name] = scene
            data["scenes"] = sorted(scenes.values(), key=place)
            file.write_text(json.dumps(data, indent=1), encoding="utf-8")
            file.with_suffix(".md").write_text(report.write(data), encoding="utf-8")
    print(report.write(data))
    drawn = (
        PEER_PYTHON.exists()
        and not subprocess.run([PEER_PYTHON, "-m", f"{__package__}.pictures", file], check=False).returncode
    )
    print(f"All of it is in {options.output}{'' if drawn else ', but for the pictures, which need matplotlib'}")
    return 0


def place(scene: dict[str, Any]) -> tuple[int, str]:
    return vertex_count(scene["scene"]), scene["scene"]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
