"""Checks every way once, then times the right ones in rounds that alternate, and keeps the least time of each."""

import gc
import signal
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from time import perf_counter

from questions import LIMIT, QUESTIONS, Answer, Question, Way, WrongAnswer

NANO, MICRO = 1e9, 1e6


@dataclass(frozen=True)
class Result:
    """`figure` is in the unit of the question, and missing if there is a reason."""

    question: str
    size: int
    peer: str
    how: str
    figure: float | None = None
    error: float | None = None
    reason: str = ""


@dataclass(frozen=True)
class Budget:
    rounds: int
    """At most this many runs of a way."""
    seconds: float
    """And, after three runs, at most this long in all."""
    limit: float
    """One run, or the first three, may not take longer."""


class TooLong(Exception):
    """One run takes longer than its limit."""


@contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    def stop(*_: object) -> None:
        raise TooLong

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def figure(question: Question, seconds: float, count: int) -> float:
    return seconds / count * (NANO if question.unit == "ns/point" else MICRO)


def judged(question: Question, size: int, peer: str, how: str, answer: Callable[[], Answer]) -> Result:
    """A result without figure, with the error of the answer; a wrong answer has a reason."""
    try:
        error = question.check(answer(), size)
    except WrongAnswer as wrong:
        return Result(question.name, size, peer, how, reason=f"wrong ({wrong})")
    except Exception as failure:
        return Result(question.name, size, peer, how, reason=f"wrong ({type(failure).__name__}: {failure})")
    reason = "" if error <= LIMIT else f"wrong ({error:.1g})"
    return Result(question.name, size, peer, how, error=error, reason=reason)


def timed(run: Callable[[], object]) -> tuple[float, object]:
    start = perf_counter()
    found = run()
    return perf_counter() - start, found


def _first(peer: str, way: Way, limit: float) -> tuple[Result, float]:
    question = QUESTIONS[way.question]
    size = way.size or question.sizes[0]
    start = perf_counter()
    try:
        with time_limit(limit):
            found = way.run()
    except TooLong:
        return Result(question.name, size, peer, way.how, reason=f"> {limit:.0f} s"), 0.0
    except Exception as failure:
        return Result(question.name, size, peer, way.how, reason=f"fails ({type(failure).__name__})"), 0.0
    seconds = perf_counter() - start
    return judged(question, size, peer, way.how, lambda: way.answer(found)), seconds


def _rounds(
    runs: list[Callable[[], object]], first: list[float], budget: Budget
) -> tuple[list[float], list[dict[bool, object]]]:
    """The least times, and what the second and the last run returned."""
    best, spent, kept = list(first), list(first), [{} for _ in runs]
    for number in range(1, budget.rounds):
        allowed = budget.limit if number < 3 else budget.seconds
        for i, run in enumerate(runs):
            if spent[i] + best[i] > allowed:
                continue
            seconds, kept[i][number == 1] = timed(run)
            best[i], spent[i] = min(best[i], seconds), spent[i] + seconds
    return best, kept


def measured(question: Question, ways: list[tuple[str, Way]], budget: Budget) -> list[Result]:
    """All ways of all peers to answer one question. Later runs are checked as well: some errors come and go."""
    first = [(_first(peer, way, budget.limit), way) for peer, way in ways]
    failed = [result for (result, _), _ in first if result.reason]
    right = [(result, seconds, way) for (result, seconds), way in first if not result.reason]
    gc.collect()
    gc.disable()
    try:
        times, kept = _rounds([way.run for _, _, way in right], [seconds for _, seconds, _ in right], budget)
    finally:
        gc.enable()

    def complete(result: Result, seconds: float, way: Way, later: dict[bool, object]) -> Result:
        for found in later.values():
            again = judged(question, result.size, result.peer, way.how, lambda found=found: way.answer(found))
            if again.reason:
                return replace(again, reason=f"at times {again.reason}")
        return replace(result, figure=figure(question, seconds, way.count))

    together = zip(right, times, kept, strict=True)
    return failed + [complete(result, t, way, later) for (result, _, way), t, later in together]


def measured_all(peers: Mapping[str, list[Way]], budget: Budget, say: Callable[[str], None]) -> list[Result]:
    results = []
    for question in QUESTIONS.values():
        ways = [(peer, way) for peer, all_ways in peers.items() for way in all_ways if way.question == question.name]
        if ways:
            say(question.name)
            results += measured(question, ways, budget)
    return results
