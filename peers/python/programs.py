"""The programs beside: C++ peers, which are compiled here, and the Rust program with the figures of symspline.

The C++ programs print a line of JSON for each way: its time, and its answer, which is checked here.
"""

import json
import re
import subprocess
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from shutil import which
from typing import Any

from measure import Budget, Result, figure, judged
from questions import QUESTIONS, Answer, Interpolant, Pieces, Points, Spline

ROOT = Path(__file__).resolve().parents[2]
BUILT = ROOT / "target" / "peers"
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


# The rows of the Rust program: group, name, how many things the program counts, and for how many the question asks.
CURVE, SURFACE, OPERATORS, PRODUCTS = "Curve", "Surface", "Operators", "Products"
RUST_ROWS = {
    "curve point, single, sorted": (CURVE, "point, one at a time, sorted", None),
    "curve point, single, random": (CURVE, "point, one at a time, random", None),
    "curve point, batch, sorted": (CURVE, "points, batch, sorted", None),
    "curve point, batch, random": (CURVE, "points, batch, random", None),
    "curve point and 2 derivatives, single, random": (CURVE, "two derivatives, one at a time, random", None),
    "curve point and 2 derivatives, batch, sorted": (CURVE, "two derivatives, batch, sorted", None),
    "surface point, single, random": (SURFACE, "point, one at a time, random", None),
    "surface point, batch, random": (SURFACE, "points, batch, random", None),
    "surface grid": (SURFACE, "points, grid 1000 x 100", None),
    "surface point and first derivatives, random": (SURFACE, "first derivatives, random", None),
    "refine every span": (OPERATORS, "a knot in the middle of each span", 1000),
    "elevate by one": (OPERATORS, "elevation by one", 1000),
    "remove inserted knots": (OPERATORS, "the inserted knots taken out", 1000),
    "reduce an elevated curve": (OPERATORS, "the elevated degree lowered", 1000),
    "product 3x3": (PRODUCTS, "product 3 x 3", 0),
    "product 2x2": (PRODUCTS, "product 2 x 2", 0),
    "derivative": (OPERATORS, "derivative", 1000),
    "antiderivative": (OPERATORS, "antiderivative", 1000),
    "interpolate 1000 points": (OPERATORS, "interpolation at chord lengths", 1000),
    "Bezier pieces": (OPERATORS, "all Bezier pieces", 1000),
}


def symspline(file: Path) -> list[Result]:
    """The figures of symspline in `file`, in the units of the questions here, as it is and prepared.

    The Rust program counts seconds a thing, a point or a span; operators are asked for a curve of 997 spans or so.
    """
    rows = json.loads(file.read_text())["rows"]
    results = []
    for question in QUESTIONS.values():
        group, name, count = RUST_ROWS[question.name]
        for row in (row for row in rows if (row["group"], row["name"]) == (group, name)):
            if count and row["count"] != count:
                continue
            size = row["count"] if count == 0 else question.sizes[0]
            things = 1 if count is None else row["count"]
            for column, how in (("symspline", "by its operators"), ("symspline, prepared", "by an evaluator")):
                found = row["seconds"].get(column)
                if size in question.sizes and isinstance(found, dict) and "least" in found:
                    results.append(
                        Result(question.name, size, "symspline", how, figure(question, found["least"] * things, 1))
                    )
    return results
