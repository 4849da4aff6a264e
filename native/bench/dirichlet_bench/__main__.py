# SPDX-License-Identifier: GPL-3.0-or-later
"""Ours beside other libraries: same meshes, same paint, one run.

Into the output folder go report.md, report.json and the pictures.
"""

import argparse
import json
import re
import subprocess
import sys
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from . import machine, report
from .contest import PEER_PYTHON, PEERS, ROOT, Contestant, Effort, Result, compete, every_contestant
from .scene import load
from .scene_maker import prepare

DRAGON = ROOT.parent / "shared/meshes/derived__dragon_28k.obj"
SCENE = re.compile("[1-9][0-9]*[kM]( shuffled| tube| pieces)?")
ODD = ("125k shuffled", "125k tube", "125k pieces")
QUICK = ("14k", "125k")
USUAL = ("14k", *ODD, "125k", "1M")
FULL = (*USUAL, "1M shuffled", "2M", "4M")


def parse(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./run bench", description=__doc__.splitlines()[0])
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--quick", action="store_true", help=f"{' and '.join(QUICK)} vertices, few runs: two minutes")
    how.add_argument("--full", action="store_true", help=f"all meshes: {', '.join(FULL)}")
    how.add_argument("--scenes", nargs="+", metavar="SCENE", help='others, such as 10M or "1M tube"')
    parser.add_argument("--only", nargs="+", metavar="WORD", help="contestants with one of these words in their title")
    parser.add_argument("--runs", type=int, help="medians over so many runs (default 7, quick 5)")
    parser.add_argument("--seconds", type=float, help="begin no run after so many of one stage (default 10, quick 0.5)")
    parser.add_argument("--limit", type=float, help="seconds of one contestant on one mesh (default 600, quick 20)")
    parser.add_argument(
        "--base", type=Path, default=DRAGON, metavar="MESH", help="refined to the sizes; a torus if missing"
    )
    parser.add_argument("--output", type=Path, default=ROOT / "build/bench/report", metavar="FOLDER")
    options = parser.parse_args(words)
    options.names = options.scenes or (QUICK if options.quick else FULL if options.full else USUAL)
    for name in options.names:
        if not SCENE.fullmatch(name):
            parser.error(f"no scene {name!r}: a size such as 14k or 2M, then nothing or shuffled, tube or pieces")
    usual = Effort(5, 0.5, 20.0) if options.quick else Effort(7, 10.0, 600.0)
    asked = {name: getattr(options, name) for name in ("runs", "seconds", "limit")}
    options.effort = replace(usual, **{name: value for name, value in asked.items() if value is not None})
    return options


def chosen(words: list[str] | None) -> list[Contestant]:
    everyone = every_contestant()
    return [one for one in everyone if not words or any(word.lower() in one.title.lower() for word in words)]


def measure(name: str, options: argparse.Namespace) -> dict[str, Any]:
    """All contestants on one scene."""
    folder = prepare(name, options.base, ROOT / "build/bench/scenes", PEERS)
    scene = load(folder)
    results: list[Result] = []
    for contestant in chosen(options.only):
        print(f"{name}: {contestant.title}", end="", flush=True)
        results.append(compete(contestant, scene, folder, options.effort))
        print(f" {results[-1].trouble}".rstrip(), flush=True)
    painted = int((scene.first == scene.first).sum())
    size = {"vertices": len(scene.positions), "faces": len(scene.faces), "painted": painted}
    return {"scene": name, **size, "results": [asdict(result) for result in results]}


def main(words: list[str]) -> int:
    options = parse(words)
    options.output.mkdir(parents=True, exist_ok=True)
    data: dict[str, Any] = {"machine": machine.describe(), "effort": asdict(options.effort), "scenes": []}
    for name in options.names:
        data["scenes"].append(measure(name, options))
        file = options.output / "report.json"  # after every scene: a long run that is stopped has its part
        file.write_text(json.dumps(data, indent=1), encoding="utf-8")
        (options.output / "report.md").write_text(report.write(data), encoding="utf-8")
    print(report.write(data))
    drawn = (
        PEER_PYTHON.exists()
        and not subprocess.run([PEER_PYTHON, "-m", f"{__package__}.pictures", file], check=False).returncode
    )
    print(f"All of it is in {options.output}{'' if drawn else ', but for the pictures, which need matplotlib'}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
