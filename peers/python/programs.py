"""The programs beside: C++ peers, which are compiled here, and the Rust program with the figures of symspline.

The C++ programs print a line of JSON for each way: its time, and its answer, which is checked here.
"""

import json
import re
import subprocess
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from shutil import which
from typing import Any

from measure import Budget, Result, figure, judged
from questions import QUESTIONS, Answer, Interpolant, Pieces, Points, Spline

ROOT = Path(__file__).resolve().parents[2]
BUILT = ROOT / "target" / "peers"
UNITS = {"ns": 1e-9, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ms": 1e-3, "s": 1.0}
OCCT_HEADERS = Path("/usr/include/opencascade")


@dataclass(frozen=True)
class Program:
    """A C++ peer: it is compiled if its header is there."""

    peer: str
    source: str
    header: Path
    packages: tuple[str, ...]
    flags: tuple[str, ...]


PROGRAMS = [
    Program(
        "OCCT (C++)",
        "occt.cpp",
        OCCT_HEADERS / "Geom_BSplineCurve.hxx",
        ("libocct-foundation-dev", "libocct-modeling-data-dev"),
        (f"-isystem{OCCT_HEADERS}", "-lTKGeomBase", "-lTKG3d", "-lTKG2d", "-lTKMath", "-lTKernel"),
    ),
    Program("SISL (C++)", "sisl.cpp", Path("/usr/include/sisl.h"), ("libsisl-dev",), ("-lsisl",)),
]


def version(program: Program) -> str:
    """The version of the Debian package, if it can be asked."""
    if which("dpkg-query") is None:
        return ""
    command = ["dpkg-query", "-W", "-f=${Version}", program.packages[-1]]
    found = subprocess.run(command, capture_output=True, text=True, check=False)
    return re.split(r"[+-]", found.stdout)[0]


def compiled(program: Program, say: Callable[[str], None]) -> Path | None:
    if which("g++") is None:
        say(f"{program.peer} is skipped: no g++")
        return None
    if not program.header.exists():
        say(f"{program.peer} is skipped: no {program.header} (Debian: {' '.join(program.packages)}, or --apt)")
        return None
    target = BUILT / program.source.removesuffix(".cpp")
    source = ROOT / "peers" / "cpp" / program.source
    command = ["g++", "-std=c++17", "-O3", "-Wno-deprecated", str(source), "-o", str(target), *program.flags]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode == 0:
        return target
    say(f"{program.peer} is skipped: {next(iter(result.stderr.splitlines()), 'g++ fails')}")
    return None


def _spline(data: dict[str, Any]) -> Spline:
    return Spline(data["degree"], data["knots"], data["coeffs"])


def _answer(line: dict[str, Any]) -> Answer:
    if "points" in line:
        return Points(line["points"]["parameters"], line["points"]["values"])
    if "pieces" in line:
        return Pieces(line["pieces"])
    if "interpolant" in line:
        return Interpolant(_spline(line["interpolant"]["spline"]), line["interpolant"]["parameters"])
    return _spline(line["spline"])


def _lines(program: Path, budget: Budget, say: Callable[[str], None]) -> list[dict[str, Any]]:
    command = [str(program), str(budget.rounds), str(budget.seconds)]
    try:
        result = subprocess.run(command, capture_output=True, text=True, check=True, timeout=600)
        return [json.loads(line) for line in result.stdout.splitlines()]
    except (subprocess.SubprocessError, json.JSONDecodeError) as failure:
        say(f"{program.name} fails: {failure}")
        return []


def _checked(peer: str, line: dict[str, Any]) -> Result:
    question = QUESTIONS[line["question"]]
    result = judged(question, line["size"], peer, line["how"], lambda: _answer(line))
    if result.reason:
        return result
    return replace(result, figure=figure(question, line["seconds"], line["count"]))


def results_of(peer: str, program: Path, budget: Budget, say: Callable[[str], None]) -> list[Result]:
    return [_checked(peer, line) for line in _lines(program, budget, say)]


def rust_figures(file: Path, say: Callable[[str], None]) -> bool:
    """Runs the Rust program, which writes its figures to `file`; false if there is none."""
    manifest = ROOT / "peers" / "Cargo.toml"
    if which("cargo") is None or not manifest.exists():
        say(f"symspline is skipped: no {'cargo' if manifest.exists() else manifest}")
        return False
    command = ["cargo", "run", "--release", "--quiet", "--manifest-path", str(manifest), "--", "--json", str(file)]
    try:
        subprocess.run(command, check=True, timeout=1800, stdout=subprocess.DEVNULL)
    except subprocess.SubprocessError as failure:
        say(f"symspline is skipped: {failure}")
        return False
    return file.exists()


def symspline(file: Path) -> list[Result]:
    """The figures of symspline in `file`, in the units of the questions here.

    A question of one size on both sides needs no agreement whether spans or control points are counted.
    """
    rows = [row for row in json.loads(file.read_text())["rows"] if row["question"] in QUESTIONS]
    times = Counter(row["question"] for row in rows)
    results = []
    for row in rows:
        question, found = QUESTIONS[row["question"]], row["figures"].get("symspline")
        only = times[question.name] == len(question.sizes) == 1
        size = question.sizes[0] if only else row["size"]
        if size in question.sizes and isinstance(found, int | float):
            seconds = found * UNITS[row["unit"].split("/")[0].strip()]
            results.append(Result(question.name, size, "symspline", "", figure(question, seconds, 1)))
    return results
