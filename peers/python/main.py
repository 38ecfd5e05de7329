"""Asks all peers that are there; `run` starts this in the virtual environment."""

import argparse
import json
import platform
import sys
from dataclasses import asdict
from importlib import import_module, metadata
from pathlib import Path

import programs
import table
from measure import Budget, Result, measured_all
from questions import Way

MODULES = {
    "peer_scipy": "scipy",
    "peer_splipy": "splipy",
    "peer_splinepy": "splinepy",
    "peer_geomdl": "geomdl",
    "peer_occt": "cadquery-ocp",
}


RUN_OPTIONS = "And of run: --apt installs the Debian packages of the C++ peers, --offline installs nothing."


def say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def python_peers() -> tuple[dict[str, list[Way]], dict[str, str]]:
    """The ways and the version of every peer that can be imported."""
    ways, versions = {}, {}
    for module, package in MODULES.items():
        try:
            peer = import_module(module)
            ways[peer.NAME] = peer.ways()
            versions[peer.NAME] = metadata.version(package)
        except ImportError as failure:
            say(f"{package} is skipped: {failure}")
        except Exception as failure:
            say(f"{package} is skipped, another version is needed: {type(failure).__name__}: {failure}")
    return ways, versions


def machine() -> str:
    lines = Path("/proc/cpuinfo").read_text().splitlines() if Path("/proc/cpuinfo").exists() else []
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return f"{names[0] if names else platform.processor() or platform.machine()}, Python {platform.python_version()}"


def cpp_results(budget: Budget, passes: int) -> tuple[list[Result], dict[str, str]]:
    """The programs take turns; of all passes the least time counts."""
    built = [(program, programs.compiled(program, say)) for program in programs.PROGRAMS]
    present = [(program, path) for program, path in built if path is not None]
    results = []
    for number in range(passes):
        for program, path in present:
            say(f"{program.peer}, pass {number + 1}")
            results += programs.results_of(program.peer, path, budget, say)
    return results, {program.peer: programs.version(program) for program, _ in present}


def symspline_results(file: Path | None, wanted: bool) -> list[Result]:
    if file is not None:
        return programs.symspline(file)
    own = programs.BUILT / "symspline.json"
    return programs.symspline(own) if wanted and programs.rust_figures(own, say) else []


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser("peers/python/run", description=__doc__, epilog=RUN_OPTIONS)
    parser.add_argument("--symspline", type=Path, metavar="FILE", help="figures of the Rust program, instead of a run")
    parser.add_argument("--no-rust", action="store_true", help="don't run the Rust program")
    parser.add_argument("--no-cpp", action="store_true", help="don't compile and run the C++ peers")
    parser.add_argument("--write", type=Path, metavar="FILE", help="put the table between the marks in FILE")
    parser.add_argument("--json", type=Path, metavar="FILE", help="all results, the slower ways too")
    parser.add_argument("--rounds", type=int, default=200, help="runs of one way at most")
    parser.add_argument("--seconds", type=float, default=1.0, help="time for one way, after three runs")
    parser.add_argument("--limit", type=float, default=20.0, help="seconds a single run may take")
    parser.add_argument("--passes", type=int, default=2, help="how often the C++ programs are run")
    return parser.parse_args()


def main() -> None:
    chosen = arguments()
    budget = Budget(chosen.rounds, chosen.seconds, chosen.limit)
    ours = symspline_results(chosen.symspline, not chosen.no_rust)
    compiled, compiled_versions = ([], {}) if chosen.no_cpp else cpp_results(budget, chosen.passes)
    ways, versions = python_peers()
    if not ways and not compiled:
        raise SystemExit("no peer is there")
    results = ours + compiled + measured_all(ways, budget, say)
    text = table.markdown(results, {"symspline": ""} | compiled_versions | versions, machine())
    print(text)
    if chosen.json:
        chosen.json.write_text(json.dumps([asdict(result) for result in results], indent=1))
    if chosen.write:
        table.write(chosen.write, text)


if __name__ == "__main__":
    main()
