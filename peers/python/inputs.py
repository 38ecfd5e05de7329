"""What every peer is asked about: the knots, coefficients and parameters of the Rust benches (benches/numbers/mod.rs).

Plain floats from the C library's sine and cosine, so that Rust, C++ and Python get the same bits.
"""

import math
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import pairwise
from typing import TypeVar

Number = TypeVar("Number")

DEGREE = 3
SPANS = 997
CONTROLS = SPANS + DEGREE
COUNT = 100_000
SURFACE_SPANS = 47
SURFACE_CONTROLS = SURFACE_SPANS + DEGREE
GRID = (1000, 100)
PRODUCT_SPANS = (100, 1000, 10_000)

_MULTIPLIER, _INCREMENT, _WORD = 6_364_136_223_846_793_005, 1_442_695_040_888_963_407, 1 << 64


def break_at(i: int) -> float:
    """Break `i`, about `i`."""
    return i + 0.3 * math.sin(i)


def wave(i: int) -> float:
    """Coefficient `i`, at most 1 in magnitude."""
    return math.cos(0.7 * i)


def random_numbers(count: int) -> Iterator[float]:
    """Numbers in [0, 1) from a congruential generator."""
    state = 1
    for _ in range(count):
        state = (state * _MULTIPLIER + _INCREMENT) % _WORD
        yield (state >> 11) / (1 << 53)


def breaks(spans: int) -> list[float]:
    return [break_at(i) for i in range(spans + 1)]


def clamped(degree: int, spans: int) -> list[float]:
    """The knots with multiplicity `degree + 1` at the ends."""
    inner = breaks(spans)
    return inner[:1] * degree + inner + inner[-1:] * degree


def points(count: int, dimension: int = 3) -> list[list[float]]:
    return [[wave(dimension * k + axis) for axis in range(dimension)] for k in range(count)]


def middles(spans: int = SPANS) -> list[float]:
    """The knots of "refine every span"."""
    ends = breaks(spans)
    return [(a + b) / 2 for a, b in pairwise(ends)]


def refined_knots() -> list[float]:
    return sorted(clamped(DEGREE, SPANS) + middles())


def elevated_knots() -> list[float]:
    """The knots of "reduce an elevated curve": every multiplicity is one more."""
    return sorted(clamped(DEGREE, SPANS) + breaks(SPANS))


def even(end: float, count: int) -> list[float]:
    return [end * i / (count - 1) for i in range(count)]


def part(xs: Sequence[Number], count: int) -> list[Number]:
    """`count` parameters in a row from the middle, for slow peers."""
    start = (len(xs) - count) // 2
    return list(xs[start : start + count])


@cache
def sorted_parameters() -> list[float]:
    return even(break_at(SPANS), COUNT)


@cache
def random_parameters() -> list[float]:
    end = break_at(SPANS)
    return [end * x for x in random_numbers(COUNT)]


@cache
def random_pairs() -> list[tuple[float, float]]:
    end = break_at(SURFACE_SPANS)
    numbers = [end * x for x in random_numbers(2 * COUNT)]
    return list(zip(numbers[::2], numbers[1::2], strict=True))


@cache
def grid() -> tuple[list[float], list[float]]:
    end = break_at(SURFACE_SPANS)
    return even(end, GRID[0]), even(end, GRID[1])


def product_knots(degree: int, spans: int) -> list[float]:
    """The knots of the square of a spline of `degree` with simple inner knots: `degree + 1` times inside."""
    ends = breaks(spans)
    inner = [x for x in ends[1:-1] for _ in range(degree + 1)]
    return ends[:1] * (2 * degree + 1) + inner + ends[-1:] * (2 * degree + 1)


def interpolation_parameters() -> list[float]:
    return [break_at(i) for i in range(CONTROLS)]


def interpolation_knots() -> list[float]:
    """Inner knots are means of three consecutive parameters [NURBS, 9.8]."""
    xs = interpolation_parameters()
    inner = [(xs[i] + xs[i + 1] + xs[i + 2]) / 3 for i in range(1, len(xs) - DEGREE)]
    return xs[:1] * (DEGREE + 1) + inner + xs[-1:] * (DEGREE + 1)
