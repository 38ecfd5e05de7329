"""Splines over fractions: the truth that every answer is compared with before it gets a time.

Floats become fractions without loss, so the only error in a comparison is that of the peer. The algorithm is de Boor's
on the one span around the parameter; some steps take differences instead of means, which gives derivatives.
"""

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import perm

Number = float | Fraction
Point = list[Fraction]


def fractions(numbers: Sequence[Number]) -> Point:
    return [Fraction(x) for x in numbers]


def span_at(degree: int, knots: Sequence[Fraction], x: Fraction) -> int:
    """The index of the last knot at or before `x`, in a non-empty span of the domain."""
    last = len(knots) - degree - 1
    span = min(max(bisect_right(knots, x, degree, last), degree + 1), last) - 1
    while knots[span] == knots[span + 1] and span > degree:
        span -= 1
    return span


def polar(
    degree: int, knots: Sequence[Fraction], span: int, window: list[Point], arguments: Sequence[Fraction | None]
) -> Point:
    """The polar form on a span, from its `degree + 1` coefficients; `None` stands for the direction of the axis."""
    for step, x in enumerate(arguments, 1):
        following = []
        for k in range(degree + 1 - step):
            i = span - degree + step + k
            a, b = knots[i], knots[i + degree + 1 - step]
            wa, wb = (Fraction(-1), Fraction(1)) if x is None else (b - x, x - a)
            following.append([(wa * c + wb * d) / (b - a) for c, d in zip(window[k], window[k + 1], strict=True)])
        window = following
    return window[0]


def de_boor(
    degree: int, knots: Sequence[Fraction], span: int, window: list[Point], x: Fraction, order: int = 0
) -> Point:
    """The derivative of order `order` at `x`."""
    if order > degree:
        return [Fraction(0)] * len(window[0])
    arguments = [None] * order + [x] * (degree - order)
    return [perm(degree, order) * c for c in polar(degree, knots, span, window, arguments)]


@dataclass(frozen=True)
class Spline:
    """Knots count with their multiplicities: as many as coefficients, and `degree + 1`."""

    degree: int
    knots: Sequence[Fraction]
    coeffs: Sequence[Point]

    @classmethod
    def of(cls, degree: int, knots: Sequence[Number], coeffs: Sequence[Sequence[Number]]) -> "Spline":
        if len(knots) != len(coeffs) + degree + 1:
            raise ValueError(f"{len(coeffs)} coefficients with {len(knots)} knots of degree {degree}")
        return cls(degree, fractions(knots), [fractions(c) for c in coeffs])

    def at(self, x: Number, order: int = 0) -> Point:
        x = Fraction(x)
        span = span_at(self.degree, self.knots, x)
        window = list(self.coeffs[span - self.degree : span + 1])
        return de_boor(self.degree, self.knots, span, window, x, order)

    def polar(self, span: int, arguments: Sequence[Fraction | None]) -> Point:
        return polar(self.degree, self.knots, span, list(self.coeffs[span - self.degree : span + 1]), arguments)

    def embedded(self, elevation: int, knots: Sequence[Fraction]) -> "Spline":
        """The same spline over finer knots, with its degree raised by nothing or by one.

        Coefficient `j` is the polar form at the knots that follow knot `j`, on any span of its basis function; the
        polar form of higher degree is the mean of those without one argument.
        """
        degree = self.degree + elevation

        def coefficient(j: int) -> Point:
            place = next(i for i in range(j, j + degree + 1) if knots[i] < knots[i + 1])
            span = span_at(self.degree, self.knots, knots[place])
            arguments = list(knots[j + 1 : j + degree + 1])
            if elevation == 0:
                return self.polar(span, arguments)
            parts = [self.polar(span, arguments[:k] + arguments[k + 1 :]) for k in range(degree)]
            return [sum(cs) / degree for cs in zip(*parts, strict=True)]

        return Spline(degree, knots, [coefficient(j) for j in range(len(knots) - degree - 1)])

    @cached_property
    def antiderivative(self) -> "Spline":
        """The one that vanishes at the start."""
        p, t = self.degree, self.knots
        sums = [[Fraction(0)] * len(self.coeffs[0])]
        for j, c in enumerate(self.coeffs):
            width = (t[j + p + 1] - t[j]) / (p + 1)
            sums.append([s + width * x for s, x in zip(sums[-1], c, strict=True)])
        return Spline(p + 1, [t[0], *t, t[-1]], sums)


@dataclass(frozen=True)
class Surface:
    """Two lists of knots and a flat grid of coefficients, the second index running fastest."""

    degree: int
    u: Sequence[Fraction]
    v: Sequence[Fraction]
    coeffs: Sequence[Point]

    @classmethod
    def of(cls, degree: int, knots: Sequence[Number], coeffs: Sequence[Sequence[Number]]) -> "Surface":
        """With the same knots in both directions."""
        ts = fractions(knots)
        return cls(degree, ts, ts, [fractions(c) for c in coeffs])

    def at(self, u: Number, v: Number, orders: tuple[int, int] = (0, 0)) -> Point:
        p, (x, y) = self.degree, fractions([u, v])
        i, j = span_at(p, self.u, x), span_at(p, self.v, y)
        columns = len(self.v) - p - 1
        starts = [row * columns + j - p for row in range(i - p, i + 1)]
        rows = [de_boor(p, self.v, j, list(self.coeffs[k : k + p + 1]), y, orders[1]) for k in starts]
        return de_boor(p, self.u, i, rows, x, orders[0])


def bezier(controls: Sequence[Sequence[Number]], part: Fraction) -> Point:
    """The value of a Bezier piece where `part` of its interval is left behind, by de Casteljau's algorithm."""
    window = [fractions(c) for c in controls]
    while len(window) > 1:
        pairs = pairwise(window)
        window = [[c + part * (d - c) for c, d in zip(a, b, strict=True)] for a, b in pairs]
    return window[0]
