"""Threads run beside long work, and values go to other processes."""

import multiprocessing
import threading
import time
from fractions import Fraction

import numpy as np
import pytest
from symspline import Mesh, Rational, Space, Spline, Surface, SymsplineError
from symspline.mesh import CatmullClark, DooSabin


def long_work():
    """An operand and how long its square takes, half a second or more."""
    spans = 50
    while True:
        space = Space.uniform(4, spans)
        f = Spline(space, [Fraction(k * k % 97, k % 13 + 3) for k in range(space.dim)])
        start = time.perf_counter()
        f * f
        taken = time.perf_counter() - start
        if taken > 0.5:
            return f, taken
        spans *= 2


def test_long_work_leaves_the_lock():
    f, taken = long_work()
    worker = threading.Thread(target=lambda: f * f)
    turns = 0
    worker.start()
    # With the lock held until the square is there, this loop would come to its turn once or twice.
    while worker.is_alive():
        time.sleep(taken / 100)
        turns += 1
    assert turns > 20, "the interpreter stood still"


def watched_work():
    """Springs that are watched for four steps, and how long that takes, a quarter of a second or more."""
    corners = [[k & 1, k >> 1 & 1, k >> 2] for k in range(8)]
    cube = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]]
    surface = CatmullClark(Mesh(corners, cube).to_float())
    while True:
        surface, calls = surface.refined(), []
        springs = DooSabin(surface.mesh)
        alpha = np.random.default_rng(2).uniform(0.8, 1.25, surface.mesh.edge_count)

        def work(springs=springs, alpha=alpha, calls=calls):
            springs.fine_tuned(alpha, watch=lambda *progress: calls.append(progress), iterations=4)

        start = time.perf_counter()
        work()
        taken = time.perf_counter() - start
        if taken > 0.25:
            return work, calls, taken


def test_work_that_is_watched_leaves_the_lock_between_calls():
    work, calls, taken = watched_work()
    calls.clear()
    worker = threading.Thread(target=work)
    turns = 0
    worker.start()
    # With the lock held between calls, this loop would come to its turn as often as there are calls.
    while worker.is_alive():
        time.sleep(taken / 100)
        turns += 1
    assert 1 <= len(calls) <= 5 and turns > 20, "the interpreter stood still"


def test_threads_share_splines():
    f = Spline(Space.uniform(3, 50), [[Fraction(k), Fraction(1, k + 1)] for k in range(53)])
    x = Fraction(1, 3)
    expected = f(x).tolist()
    found = []
    threads = [threading.Thread(target=lambda: found.append(f(x).tolist())) for _ in range(16)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected] * 16


def derived(f):
    return f.derivative() if not isinstance(f, Surface) else f.derivative("u")


def failing(f):
    return f(7)


def test_values_and_errors_cross_processes():
    f = Spline(Space(2, [0, Fraction(1, 3)], end=1), [[Fraction(1, 7), 2], [3, 4]])
    s = Surface(Space.bezier(1), Space.bezier(1), np.random.default_rng(1).normal(size=(2, 2, 3)))
    values = [f, f.to_float(), Rational.circle((0, 0), 1), s]
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.map(derived, values) == [derived(value) for value in values]
        with pytest.raises(SymsplineError) as caught:
            pool.apply(failing, (f,))
    assert caught.value.kind == "OutsideDomain" and caught.value.data["parameter"] == "7"
