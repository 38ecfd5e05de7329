"""The questions, the shapes of answers, and the check of an answer against exact values."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

import exact
import inputs

SAMPLES = 20
LIMIT = 1e-9
"""Answers with a larger error are wrong. Errors are relative to the largest value, if that is above 1."""


class WrongAnswer(Exception):
    """The answer has the wrong shape; the text says how."""


@dataclass(frozen=True)
class Points:
    """Values at parameters: `values[k][i]` is derivative `k` at parameter `i`, in the order of the question."""

    parameters: Sequence[Any]
    values: Sequence[Any]


@dataclass(frozen=True)
class Spline:
    degree: int
    knots: Sequence[float]
    coeffs: Sequence[Sequence[float]]


@dataclass(frozen=True)
class Pieces:
    """The control points of Bezier pieces, in order."""

    controls: Sequence[Sequence[Sequence[float]]]


@dataclass(frozen=True)
class Interpolant:
    """A spline through the points, and the parameters at which it is meant to meet them."""

    spline: Spline
    parameters: Sequence[float]


Answer = Points | Spline | Pieces | Interpolant


@dataclass(frozen=True)
class Question:
    name: str
    sizes: tuple[int, ...]
    unit: str
    check: Callable[[Any, int], float]


@dataclass(frozen=True)
class Way:
    """One way in which a peer answers a question: `run` is timed, `answer` turns what it returns into an answer."""

    question: str
    how: str
    run: Callable[[], Any]
    answer: Callable[[Any], Answer]
    count: int = 1
    """How many points a run computes."""
    size: int | None = None
    """One of the sizes of the question; may be left out if there is one."""


def sample(count: int) -> list[int]:
    """Indices from the first to the last."""
    return [i * (count - 1) // (SAMPLES - 1) for i in range(SAMPLES)]


def error(pairs: Iterable[tuple[Sequence[float], exact.Point]]) -> float:
    """The largest difference of found and true values."""
    worst, scale = Fraction(0), Fraction(1)
    for found, truth in pairs:
        numbers = [float(x) for x in found]
        if len(numbers) != len(truth):
            raise WrongAnswer(f"{len(numbers)} components")
        if not all(abs(x) < float("inf") for x in numbers):
            raise WrongAnswer("not finite")
        worst = max([worst, *(abs(Fraction(x) - y) for x, y in zip(numbers, truth, strict=True))])
        scale = max([scale, *map(abs, truth)])
    return float(worst / scale)


@cache
def curve() -> exact.Spline:
    return exact.Spline.of(inputs.DEGREE, inputs.clamped(inputs.DEGREE, inputs.SPANS), inputs.points(inputs.CONTROLS))


def _rounded(spline: exact.Spline) -> Spline:
    return Spline(spline.degree, [float(t) for t in spline.knots], [[float(x) for x in c] for c in spline.coeffs])


@cache
def refined_curve() -> Spline:
    """What "remove inserted knots" starts from, rounded once."""
    return _rounded(curve().embedded(0, exact.fractions(inputs.refined_knots())))


@cache
def elevated_curve() -> Spline:
    """What "reduce an elevated curve" starts from, rounded once."""
    return _rounded(curve().embedded(1, exact.fractions(inputs.elevated_knots())))


@cache
def surface() -> exact.Surface:
    knots = inputs.clamped(inputs.DEGREE, inputs.SURFACE_SPANS)
    return exact.Surface.of(inputs.DEGREE, knots, inputs.points(inputs.SURFACE_CONTROLS**2))


@cache
def function(degree: int, spans: int) -> exact.Spline:
    return exact.Spline.of(degree, inputs.clamped(degree, spans), inputs.points(spans + degree, 1))


def inner_parameters(spans: int) -> list[float]:
    """Both ends and parameters inside of spans."""
    ends = [inputs.break_at(0), inputs.break_at(spans)]
    thirds = [i * (spans - 1) // (SAMPLES - 3) for i in range(SAMPLES - 2)]
    return ends + [(2 * inputs.break_at(i) + inputs.break_at(i + 1)) / 3 for i in thirds]


def check_points(answer: Points, orders: Sequence[Any], truth: Callable[[Any, Any], exact.Point]) -> float:
    if len(answer.values) != len(orders) or len(answer.values[0]) != len(answer.parameters):
        raise WrongAnswer("not as many values as parameters")
    chosen = [(i, answer.parameters[i]) for i in sample(len(answer.parameters))]
    return max(
        error((values[i], truth(x, order)) for i, x in chosen)
        for values, order in zip(answer.values, orders, strict=True)
    )


def check_curve_points(orders: int) -> Callable[[Points, int], float]:
    return lambda answer, _: check_points(answer, range(orders), lambda x, k: curve().at(x, k))


def check_surface_points(*orders: tuple[int, int]) -> Callable[[Points, int], float]:
    return lambda answer, _: check_points(answer, orders, lambda x, k: surface().at(*x, k))


def check_spline(
    degree: int,
    controls: int | None,
    truth: Callable[[float, int], exact.Point],
    spans: Callable[[int], int] = lambda _: inputs.SPANS,
) -> Callable[[Spline, int], float]:
    """The degree, the number of coefficients if there is only one right one, and values."""

    def check(answer: Spline, size: int) -> float:
        if answer.degree != degree:
            raise WrongAnswer(f"degree {answer.degree}")
        if controls not in (None, len(answer.coeffs)):
            raise WrongAnswer(f"{len(answer.coeffs)} coefficients instead of {controls}")
        found = exact.Spline.of(answer.degree, answer.knots, answer.coeffs)
        xs = inner_parameters(spans(size))
        values = [(found.at(x), truth(x, size)) for x in xs]
        scale = max(1, *(abs(c) for _, t in values for c in t))
        return float(max(abs(a - b) for f, t in values for a, b in zip(f, t, strict=True)) / scale)

    return check


def check_product(degree: int) -> Callable[[Spline, int], float]:
    def square(x: float, spans: int) -> exact.Point:
        return [c * c for c in function(degree, spans).at(x)]

    return check_spline(2 * degree, None, square, lambda spans: spans)


def check_antiderivative(answer: Spline, size: int) -> float:
    """Up to a constant."""
    start = exact.Spline.of(answer.degree, answer.knots, answer.coeffs).at(inputs.break_at(0))
    moved = [[Fraction(c) - s for c, s in zip(row, start, strict=True)] for row in answer.coeffs]
    truth = curve().antiderivative
    return check_spline(4, None, lambda x, _: truth.at(x))(Spline(answer.degree, answer.knots, moved), size)


def check_pieces(answer: Pieces, _: int) -> float:
    if len(answer.controls) != inputs.SPANS:
        raise WrongAnswer(f"{len(answer.controls)} pieces")
    part = Fraction(1, 3)

    def pair(i: int) -> tuple[exact.Point, exact.Point]:
        a, b = exact.fractions([inputs.break_at(i), inputs.break_at(i + 1)])
        return exact.bezier(answer.controls[i], part), curve().at(a + part * (b - a))

    return error(pair(i) for i in sample(inputs.SPANS))


def check_interpolant(answer: Interpolant, _: int) -> float:
    spline = exact.Spline.of(answer.spline.degree, answer.spline.knots, answer.spline.coeffs)
    data = inputs.points(inputs.CONTROLS)
    if spline.degree != inputs.DEGREE or len(answer.parameters) != len(data):
        raise WrongAnswer(f"degree {spline.degree}, {len(answer.parameters)} parameters")
    return error((spline.at(answer.parameters[i]), exact.fractions(data[i])) for i in sample(len(data)))


def _questions() -> list[Question]:
    curve_size, surface_size = (inputs.CONTROLS,), (inputs.SURFACE_CONTROLS,)
    point, two = check_curve_points(1), check_curve_points(3)
    patch, tangents = check_surface_points((0, 0)), check_surface_points((0, 0), (1, 0), (0, 1))

    def same(x: float, _: int) -> exact.Point:
        return curve().at(x)

    def slope(x: float, _: int) -> exact.Point:
        return curve().at(x, 1)

    n, p = inputs.CONTROLS, inputs.DEGREE
    return [
        Question("curve point, single, sorted", curve_size, "ns/point", point),
        Question("curve point, single, random", curve_size, "ns/point", point),
        Question("curve point, batch, sorted", curve_size, "ns/point", point),
        Question("curve point, batch, random", curve_size, "ns/point", point),
        Question("curve point and 2 derivatives, single, random", curve_size, "ns/point", two),
        Question("curve point and 2 derivatives, batch, sorted", curve_size, "ns/point", two),
        Question("surface point, single, random", surface_size, "ns/point", patch),
        Question("surface point, batch, random", surface_size, "ns/point", patch),
        Question("surface grid", surface_size, "ns/point", patch),
        Question("surface point and first derivatives, random", surface_size, "ns/point", tangents),
        Question("refine every span", curve_size, "µs", check_spline(p, n + inputs.SPANS, same)),
        Question("elevate by one", curve_size, "µs", check_spline(p + 1, None, same)),
        Question("remove inserted knots", curve_size, "µs", check_spline(p, n, same)),
        Question("reduce an elevated curve", curve_size, "µs", check_spline(p, n, same)),
        Question("product 3x3", inputs.PRODUCT_SPANS, "µs", check_product(3)),
        Question("product 2x2", inputs.PRODUCT_SPANS, "µs", check_product(2)),
        Question("derivative", curve_size, "µs", check_spline(p - 1, None, slope)),
        Question("antiderivative", curve_size, "µs", check_antiderivative),
        Question("interpolate 1000 points", curve_size, "µs", check_interpolant),
        Question("Bezier pieces", curve_size, "µs", check_pieces),
    ]


QUESTIONS = {question.name: question for question in _questions()}
