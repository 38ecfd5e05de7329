"""The Markdown: a table of times with ratios to symspline, what was asked of each peer, and the largest errors."""

from pathlib import Path

from measure import Result
from questions import QUESTIONS

BEGIN, END = "<!-- python peers -->", "<!-- end of python peers -->"
Key = tuple[str, int, str]


def fastest(results: list[Result]) -> dict[Key, Result]:
    """The fastest right way of each peer; without one, a wrong one. What is wrong once is wrong."""
    wrong = {(r.question, r.size, r.peer, r.how) for r in results if r.reason}
    best: dict[Key, Result] = {}
    for result in results:
        if result.figure is not None and (result.question, result.size, result.peer, result.how) in wrong:
            continue
        key = (result.question, result.size, result.peer)
        if key not in best or _rank(result) < _rank(best[key]):
            best[key] = result
    return best


def _rank(result: Result) -> float:
    return float("inf") if result.figure is None else result.figure


def number(x: float) -> str:
    """Three digits, thousands apart."""
    if x >= 100:
        return f"{x:,.0f}".replace(",", " ")
    return f"{x:.3g}"


def ratio(x: float) -> str:
    return number(x) if x >= 10 else f"{x:.2g}"


def _cell(result: Result | None, ours: Result | None) -> str:
    if result is None:
        return ""
    if result.figure is None:
        return result.reason
    if ours is None or ours.figure is None or result is ours:
        return number(result.figure)
    return f"{number(result.figure)} ({ratio(result.figure / ours.figure)})"


def _line(cells: list[str]) -> str:
    return "| " + " | ".join(cells) + " |"


def times(results: list[Result], peers: list[str]) -> list[str]:
    best = fastest(results)
    lines = [_line(["question", "unit", *peers]), _line(["---", "---", *["---:"] * len(peers)])]
    for question in QUESTIONS.values():
        for size in question.sizes:
            found = [best.get((question.name, size, peer)) for peer in peers]
            if not any(found):
                continue
            ours = best.get((question.name, size, "symspline"))
            name = f"{question.name}, {size} spans" if len(question.sizes) > 1 else question.name
            lines.append(_line([name, question.unit, *(_cell(result, ours) for result in found)]))
    return lines


def ways(results: list[Result], peers: list[str]) -> list[str]:
    """Which calls were timed, a line for each peer."""
    best = fastest(results)

    def calls(peer: str) -> list[str]:
        in_order = [r.how for name in QUESTIONS for r in best.values() if (r.question, r.peer) == (name, peer)]
        return list(dict.fromkeys(how for how in in_order if how))

    return [f"- {peer}: {'; '.join(calls(peer))}." for peer in peers if calls(peer)]


def errors(results: list[Result], peers: list[str]) -> str:
    """The largest error of answers that count as right."""
    best = fastest(results).values()
    worst = [
        (peer, max((r.error for r in best if r.peer == peer and r.error is not None and not r.reason), default=None))
        for peer in peers
    ]
    return ", ".join(f"{peer} {error:.1g}" for peer, error in worst if error is not None)


def markdown(results: list[Result], versions: dict[str, str], machine: str) -> str:
    peers = [peer for peer in versions if any(result.peer == peer for result in results)]
    shown = ", ".join(f"{peer} {versions[peer]}".strip() for peer in peers)
    brackets = ["In brackets: the time in units of that of symspline."] if "symspline" in peers else []
    text = [
        f"{machine}. {shown}.",
        *brackets,
        "",
        *times(results, peers),
        "",
        f"Largest errors against exact values, of answers that are right: {errors(results, peers)}.",
        "",
        "What was called, the fastest that is right, where there are several:",
        "",
        *ways(results, peers),
    ]
    return "\n".join(text)


def write(file: Path, text: str) -> None:
    """Replaces the part of `file` between the two marks."""
    old = file.read_text()
    if BEGIN not in old or END not in old:
        raise SystemExit(f"{file} has no part between {BEGIN} and {END}")
    before, after = old.split(BEGIN, 1)[0], old.split(END, 1)[1]
    file.write_text(f"{before}{BEGIN}\n\n{text}\n\n{END}{after}")
