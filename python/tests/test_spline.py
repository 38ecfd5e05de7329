"""Functions and curves: values, operators as laws, other packages as witnesses."""

import copy
import pickle
from fractions import Fraction

import numpy as np
import oracle
import pytest
import scipy.interpolate
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import fractions, places, splines
from symspline import Rational, Space, Spline, SymsplineError

HALF = Fraction(1, 2)


def parabola():
    return Spline(Space.bezier(2), [[0, 0], [1, 2], [2, 0]])


def rows(array):
    return array.tolist()


def exactly(f, x):
    """The value by the definition, as a list of coordinates."""
    coeffs, knots = np.asarray(f.coeffs).reshape(f.space.dim, -1), f.space.knots.tolist()
    unrolled = [coeffs[f.space.slot(i)] for i in range(len(knots) - f.degree - 1)]
    return [oracle.value(knots, f.degree, column, x) for column in zip(*unrolled)]


def coordinates(value):
    return np.atleast_1d(value).tolist()


@given(splines(periodic=True), places)
def test_values_are_those_of_the_definition(f, x):
    assert coordinates(f(x)) == exactly(f, x)
    assert coordinates(f.derivatives_at(x, 0)[0]) == exactly(f, x)


@given(splines(dim=1, least=1, jumps=False), places)
def test_derivatives_are_those_of_the_definition(f, x):
    knots, coeffs = oracle.derivative(f.space.knots.tolist(), f.degree, f.coeffs.tolist())
    assume(x != 1)
    assert f.derivatives_at(x, 1)[1] == oracle.value(knots, f.degree - 1, coeffs, x)


@given(splines(dim=2), st.lists(st.floats(0, 1), min_size=1, max_size=20))
def test_scipy_has_the_same_values_derivatives_and_integrals(f, xs):
    f = f.to_float()
    other = f.to_scipy()
    size = 1 + abs(f.coeffs).max()
    assert np.allclose(f(xs), other(xs), rtol=0, atol=1e-12 * size)
    assert np.allclose(f.integral(0.2, 0.7), other.integrate(0.2, 0.7), rtol=0, atol=1e-12 * size)
    assert np.allclose(f.antiderivative()(xs), other.antiderivative()(xs), rtol=0, atol=1e-12 * size)
    assert Spline.from_scipy(other) == f
    assume(f.degree > 0 and max(f.space.multiplicities[1:-1], default=1) <= f.degree)
    assert np.allclose(f.derivative()(xs), other.derivative()(xs), rtol=0, atol=1e-10 * size * 1000)


@given(splines(dim=2, least=1, jumps=False), places)
def test_scipy_inserts_the_same_knot(f, x):
    f, x = f.to_float(), float(x)
    assume(0 < x < 1 and f.space.knots.tolist().count(x) < f.degree)
    again = Spline.from_scipy(f.to_scipy().insert_knot(x))
    assert again.space == f.inserted([x]).space
    assert np.allclose(again.coeffs, f.inserted([x]).coeffs, atol=1e-13 * (1 + abs(f.coeffs).max()))


def test_splipy_raises_the_order_and_splits_alike():
    splipy = oracle.splipy()
    f = Spline(Space.clamped(2, [0.0, 1.0, 1.0, 3.0]), np.random.default_rng(2).normal(size=(5, 2)))

    def curve(f):
        return splipy.Curve(splipy.BSplineBasis(f.degree + 1, f.space.knots), f.coeffs)

    other = curve(f)
    other.raise_order(2)
    raised = f.elevate(2)
    assert np.allclose(other.controlpoints, raised.coeffs, atol=1e-13)
    assert np.allclose(other.bases[0].knots, raised.space.knots)
    other = curve(f)
    other.insert_knot(0.5)
    assert np.allclose(other.controlpoints, f.inserted([0.5]).coeffs, atol=1e-13)
    for part, half in zip(curve(f).split(2.0), f.split(2.0)):
        assert np.allclose(part.controlpoints, half.coeffs, atol=1e-13)


def test_periodic_splines_go_to_scipy_and_back():
    ring = Spline(Space(3, [0.0, 0.1, 0.4, 0.7], end=1.0), np.random.default_rng(3).normal(size=(4, 2)))
    other = ring.to_scipy()
    xs = np.linspace(0, 1, 50)
    assert np.allclose(ring(xs), other(xs), atol=1e-14)
    assert Spline.from_scipy(other) == ring
    xs = np.linspace(0, 2 * np.pi, 9)
    ys = np.c_[np.cos(xs), np.sin(xs)]
    ys[-1] = ys[0]
    fit = scipy.interpolate.make_interp_spline(xs, ys, bc_type="periodic")
    mine = Spline.from_scipy(fit, periodic=True)
    assert mine.space.is_periodic
    at = np.linspace(0, 2 * np.pi, 40)
    assert np.allclose(mine(at), fit(at), atol=1e-12)
    double = Spline(Space(3, [0.0, 0.0, 0.4, 0.7], end=1.0), np.random.default_rng(4).normal(size=(4, 2)))
    assert Spline.from_scipy(double.to_scipy()) == double
    knots = other.t.copy()
    knots[0] -= 0.05
    with pytest.raises(SymsplineError, match="knots"):
        Spline.from_scipy(scipy.interpolate.BSpline(knots, other.c, 3, extrapolate="periodic"))
    torn = scipy.interpolate.BSpline(other.t, np.arange(7.0), 3, extrapolate="periodic")
    with pytest.raises(SymsplineError) as caught:
        Spline.from_scipy(torn)
    assert caught.value.kind == "NotPeriodic"
    assert not Spline.from_scipy(torn, periodic=False).space.is_periodic


@given(splines(dim=2, most=2), splines(dim=2, most=2), splines(dim=1, most=2), fractions, places)
def test_signs_are_those_of_the_values(f, g, h, k, x):
    a, b, c = f(x), g(x), h(x)
    assert rows((f + g)(x)) == rows(a + b) and rows((f - g)(x)) == rows(a - b)
    assert rows((k * f)(x)) == rows((f * k)(x)) == rows(a * k) and rows((-f)(x)) == rows(-a)
    assert rows((h * f)(x)) == rows((f * h)(x)) == rows(c * a)
    assert (f @ g)(x) == f.dot(g)(x) == a @ b and f.cross(g)(x) == a[0] * b[1] - a[1] * b[0]
    assert rows((f + (k, 1))(x)) == rows(((k, 1) + f)(x)) == [a[0] + k, a[1] + 1]
    assert rows(((k, 1) - f)(x)) == [k - a[0], 1 - a[1]]
    assert (f @ (k, 2))(x) == ((k, 2) @ f)(x) == a @ np.array([k, 2], dtype=object)
    assert rows((h * (k, 2))(x)) == rows(([k, 2] * h)(x)) == [c * k, c * 2]
    assert (h**3)(x) == c**3 and (h**0)(x) == 1 and h**1 == h
    assert rows((np.array([[0, 1], [k, 2]], dtype=object) @ f)(x)) == [a[1], k * a[0] + 2 * a[1]]
    assert rows(f.transformed([[1, 0], [0, 1], [k, 1]])(x)) == [a[0], a[1], k * a[0] + a[1]]
    assert f.plus_scaled(k, g).same_function(f + k * g)
    assert f.coordinate(1)(x) == a[1]
    if k:
        assert rows((f / k)(x)) == [a[0] / k, a[1] / k]
    square = h * h + 1
    assert rows((f / square)(x)) == [a[0] / square(x), a[1] / square(x)]
    assert (1 / square)(x) == 1 / square(x) and isinstance(1 / square, Rational)


def test_arrays_leave_the_signs_to_splines():
    f = parabola()
    for number in (np.float64(2), np.int64(2), np.array(2.0), np.float32(2)):
        assert isinstance(number * f, Spline) and (number * f).same_function(f * 2)
    assert isinstance(np.array([1.0, 2.0]) + f, Spline)
    assert (np.int64(2) * f).is_exact and not (np.float64(2) * f).is_exact


def test_a_float_anywhere_makes_floats():
    f = parabola()
    assert f.is_exact and not (f + 0.5 * f).is_exact and not (f + (0.5, 0)).is_exact
    assert not f.inserted([0.5]).is_exact and f.inserted([HALF]).is_exact
    assert not f.restricted(0, 0.5).is_exact and not f.embedded(f.space.to_float()).is_exact
    assert not Spline(Space.bezier(1), [0, 0.5]).is_exact and not Spline(Space.bezier(1, 0.0), [0, 1]).is_exact
    assert not Spline.monomial(2, 0, 1.0).is_exact and not Spline.monomial(2, 0.0, 1).is_exact
    # A tolerance is no data.
    assert f.simplified_within(1e-9)[0].is_exact and isinstance(Spline.monomial(2).range(1e-3)[1].value, Fraction)


def test_an_exact_spline_at_a_float_is_rounded_once():
    f = Spline(Space.bezier(2), [0, 0, 1])
    assert f(0.1) == float(Fraction(0.1) ** 2) and isinstance(f(0.1), float)
    assert isinstance(f(1), Fraction) and f(np.array([0.1]))[0] == f(0.1)


@given(splines(), places)
def test_operators_keep_values(f, x):
    value = coordinates(f(x))
    target = f.space.elevate().bisected()
    for same in (f.elevate(2), f.embedded(target), f.elevate().simplified(), f.clamped_ends(), f.inserted(f.space.bisected().breaks[1:2])):
        assert coordinates(same(x)) == value and f.same_function(same)
    assert coordinates(f.reparametrised(2, 4)(2 + 2 * x)) == value
    assert f.reversed().reversed() == f
    assert f.antiderivative().derivative().same_function(f)
    assert coordinates(f.antiderivative()(x)) == coordinates(f.integral(0, x))
    breaks, pieces = f.to_power_form()
    assert Spline.from_power_form(breaks, pieces).same_function(f)
    if 0 < x < 1:
        left, right = f.split(x)
        assert left.join(right).same_function(f)
        assert left.same_function(f.restricted(0, x)) and right.same_function(f.restricted(x, 1))
    assert len(f.bezier_pieces()) == len(f.space.breaks) - 1


def test_power_forms_in_a_space():
    # A roof: x, then 2 - x.
    breaks, pieces = [0, 1, 2], [[0, 1], [1, -1]]
    target = Space.clamped(2, [0, 1, 1, 2])
    roof = Spline.from_power_form(breaks, pieces, target)
    assert roof.space == target and [roof(Fraction(k, 4)) for k in range(9)] == [Fraction(min(k, 8 - k), 4) for k in range(9)]
    assert Spline.from_power_form(breaks, [[0.0, 1.0], [1.0, -1.0]], target, 1e-9).space == target.to_float()
    for space, tolerance, kind in [
        (Space.clamped(2, [0, 1, 2]), 0, "TooSmooth"),
        (Space.clamped(2, [0, 1, 1, 3]), 0, "DomainMismatch"),
        (target, -1, "BadTolerance"),
    ]:
        with pytest.raises(SymsplineError) as caught:
            Spline.from_power_form(breaks, pieces, space, tolerance)
        assert caught.value.kind == kind


def test_chord_lengths():
    for points in ([[0, 0], [3, 4], [3, 5], [0, 9]], np.random.default_rng(4).normal(size=(7, 3))):
        legs = np.linalg.norm(np.diff(np.array(points, float), axis=0), axis=1)
        found = Spline.chord_length(points)
        assert np.allclose(found, np.cumsum([0, *legs]) / sum(legs), atol=1e-15) and found.dtype == np.float64
    for points, kind in [([[0, 0]], "TooFewPoints"), ([[1, 1], [1, 1]], "NoLength"), ([0, 1, 2], "Dimension"), ([[[0]]], "Shape")]:
        with pytest.raises(SymsplineError) as caught:
            Spline.chord_length(points)
        assert caught.value.kind == kind


@given(splines(dim=2, least=1), st.integers(1, 2))
def test_reductions_undo_elevations(f, by):
    higher = f.elevate(by)
    assert higher.degree_reduced_exactly(by) == f and higher.degree_lowered(by) == (f, 0)
    assert higher.degree_reduced(by)[0] == f and higher.degree_reduced_within(by, 0)[0].same_function(f)
    finer = f.embedded(f.space.bisected())
    assert finer.without_spare_knots(0)[0].same_function(f) and finer.projected(finer.space)[0] == finer
    assert finer.quasi_interpolated(finer.space)[0] == finer


@given(splines(dim=1, least=1, most=3), splines(dim=1, least=1, most=3))
def test_bounds_hold(f, g):
    bound, size = f.distance_bound(g), f.size_bound()
    for x in (Fraction(k, 17) for k in range(18)):
        assert abs(f(x) - g(x)) <= bound and abs(f(x)) <= size
    assert f.distance_bound(g, 2) <= bound
    least, greatest = f.range(Fraction(1, 100))
    assert least.bound <= least.value <= greatest.value <= greatest.bound
    low, high = f.coefficient_range()
    assert low <= least.value and greatest.value <= high


def test_removal_and_compositions():
    f = parabola().inserted([HALF])
    assert f.removed(HALF) == (parabola(), 0)
    dropped, bound, (start, end) = f.without_knot(3, "left")
    assert dropped.space == parabola().space and bound >= f.distance_bound(dropped) and (start, end) == (0, 1)
    square = Spline.monomial(2)
    assert parabola().composed(square)(HALF).tolist() == parabola()(Fraction(1, 4)).tolist()
    assert parabola().reparametrised_by(square).degree == 4
    assert f.without_spare_knots_on(0, 1, 0)[0] == parabola()
    assert parabola().approximated_within(Space.bezier(1), 0.5)[1] <= HALF
    assert sorted(parabola().control_hull()) == [0, 1, 2]
    low, high = parabola().control_box()
    assert low.tolist() == [0, 0] and high.tolist() == [2, 2]
    (_, top) = parabola().bounding_box(Fraction(1, 1000))[1]
    assert top.bound >= 1 >= top.value and abs(top.parameter - HALF) < Fraction(1, 10)
    assert Spline.monomial(2, 1, 2).positive_bound() > 0
    assert parabola().inner(parabola()) == parabola().dot(parabola()).integral()
    assert parabola().weighted_integral(square).tolist() == parabola().moment(2).tolist()


def test_derivatives_of_any_order():
    cube = Spline.monomial(3)
    assert cube.derivative(0) == cube and cube.derivative(2).same_function(6 * Spline.monomial(1))
    assert cube.derivative(3).coeffs.tolist() == [6] and cube.derivative(2**62).coeffs.tolist() == [0]
    broken = Spline(Space(1, [0, 0, HALF, HALF, 1, 1]), [0, 1, 2, 3])
    with pytest.raises(SymsplineError):
        broken.derivative(2)


def test_integrals_are_those_of_antiderivatives():
    f = Spline.monomial(2, -1, 2)
    whole = f.antiderivative()
    assert f.integral() == 3 and f.integral(0, 1) == Fraction(1, 3) and f.integral(1, 0) == -Fraction(1, 3)
    assert f.integral(a=1) == whole(2) - whole(1) and f.integral(b=1) == whole(1) and whole(-1) == 0
    assert isinstance(f.integral(0, 0.5), float)


def test_rings():
    ring = Spline.closed(2, [[0, 0], [12, 0], [0, 12]])
    assert ring(Fraction(1, 3)).tolist() == [6, 6]
    moved = ring.with_seam_at(HALF)
    assert moved.domain[0] == HALF and moved(HALF).tolist() == ring(HALF).tolist()
    assert not ring.unclamped_ends().space.is_periodic
    with pytest.raises(SymsplineError) as caught:
        ring.antiderivative()
    assert caught.value.kind == "NonZeroMean"


def test_data():
    xs = [Fraction(k, 4) for k in range(5)]
    f = Spline.interpolating(Space.for_interpolation(3, xs), xs, [[x, x * x] for x in xs])
    assert f(xs).tolist() == [[x, x * x] for x in xs] and f.largest_squared_residual(xs, [[x, x * x] for x in xs]) == 0
    g = Spline.least_squares(Space.bezier(1), xs, [x * x for x in xs], ends="held")
    assert g.coeffs.tolist() == [0, 1]
    assert Spline.least_squares(Space.bezier(1), xs, xs).same_function(Spline.monomial(1))
    ease = Spline.osculating(Space.bezier(3), [0, 0, 1, 1], [0, 0, 1, 0])
    assert ease.coeffs.tolist() == [0, 0, 1, 1]
    assert Spline.segment((1, 2), (3, 4))(HALF).tolist() == [2, 3]
    assert Spline.constant(Space.bezier(2), (1, 2))(HALF).tolist() == [1, 2] and Spline.constant(Space.bezier(1), 7)(0) == 7


def test_quasi_interpolants_of_python_functions():
    space = Space.uniform(3, 10).to_float()
    sine = Spline.quasi_interpolant(space, np.sin)
    xs = np.linspace(0, 1, 30)
    assert abs(sine(xs) - np.sin(xs)).max() < 1e-6
    assert Spline.quasi_interpolant(Space.bezier(2), lambda x: [x, x * x])(HALF).tolist() == [HALF, HALF**2]
    with pytest.raises(ZeroDivisionError):
        Spline.quasi_interpolant(space, lambda x: 1 / (x - x))
    with pytest.raises(SymsplineError):
        Spline.quasi_interpolant(space, lambda x: [0] * (1 + int(x > 0.5)))
    with pytest.raises(TypeError):
        Spline.quasi_interpolant(space, 3)


@given(splines(periodic=True))
def test_pickling_loses_nothing(f):
    for g in (f, f.to_float()):
        assert pickle.loads(pickle.dumps(g)) == g and copy.copy(g) is g and copy.deepcopy([g]) == [g]
    assert "Spline" in repr(f)


@given(st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=3, max_size=3))
def test_pickled_floats_keep_every_bit(numbers):
    f = Spline(Space.bezier(2), numbers)
    assert pickle.loads(pickle.dumps(f)).coeffs.tobytes() == np.array(numbers, float).tobytes()
    assert f.to_exact().to_float() == f


def test_long_arrays_agree_with_single_values():
    space = Space.uniform(3, 50).to_float()
    xs = np.random.default_rng(4).random(40_000)
    for shape in ((53,), (53, 2), (53, 3)):
        f = Spline(space, np.random.default_rng(5).normal(size=shape))
        many = f(xs)
        assert many.shape == xs.shape + shape[1:] and many.flags.c_contiguous
        few = np.array([f(x) for x in xs[:500]])
        assert np.allclose(many[:500], few, atol=1e-12)
        assert np.allclose(many, f.to_scipy()(xs), atol=1e-12)
    with pytest.raises(SymsplineError):
        f(np.append(xs, 1.5))


@pytest.mark.parametrize(
    ("make", "kind", "data"),
    [
        (lambda: parabola()(2), "OutsideDomain", {"parameter": "2", "start": "0", "end": "1"}),
        (lambda: parabola()(float("nan")), None, None),
        (lambda: Spline(Space.bezier(2), [1, 2]), "CoefficientCount", {"expected": 3, "found": 2}),
        (lambda: Spline(Space.bezier(1), [[1] * 4] * 2), "Dimension", {"found": 4, "least": 1}),
        (lambda: Spline(Space.bezier(1), [0.0, float("inf")]), "NotFinite", {"what": "coefficient", "index": 1}),
        (lambda: parabola() + Spline.monomial(1), "Dimensions", {"left": 2, "right": 1}),
        (lambda: parabola() * parabola(), "NoSuch", None),
        (lambda: parabola() / 0, "DivisionByZero", {}),
        (lambda: parabola() / Spline.monomial(1), "Pole", None),
        (lambda: parabola() + parabola().reparametrised(0, 2), "DomainMismatch", None),
        (lambda: parabola().elevate(10**6), "DegreeTooHigh", None),
        (lambda: parabola().degree_reduced_exactly(), "NotReducible", {"degree": 1}),
        (lambda: parabola().removed(HALF), "NotRemovable", None),
        (lambda: parabola().coordinate(2), "IndexOutOfRange", {"index": 2, "length": 2}),
        (lambda: parabola().range(0.1), "Dimensions", {"left": 1, "right": 2}),
        (lambda: parabola().simplified_within(-1), "BadTolerance", None),
        (lambda: parabola().derivatives_at([0.5] * 1000, 10**6), "TooLarge", None),
        (lambda: parabola().transformed([[1, 2, 3]]), "Shape", {}),
        (lambda: parabola().transformed([[1, 2]] * 4), "Dimension", {"found": 4, "least": 1}),
        (lambda: parabola() ** 2, "NoSuch", None),
        (lambda: Spline(Space.bezier(1), [[1, 2], [3]]), "Ragged", {}),
        (lambda: Spline.monomial(1) ** 10**5, "DegreeTooHigh", None),
    ],
)
def test_errors(make, kind, data):
    with pytest.raises(SymsplineError) as caught:
        make()
    if kind:
        assert caught.value.kind == kind
    if data is not None:
        assert caught.value.data == data
    assert isinstance(caught.value, ValueError) and str(caught.value)
    again = pickle.loads(pickle.dumps(caught.value))
    assert (again.kind, again.data, str(again)) == (caught.value.kind, caught.value.data, str(caught.value))
