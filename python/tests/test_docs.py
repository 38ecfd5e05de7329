"""Everything public is described, what is described is so, and nothing is left out of the stubs."""

import doctest
import importlib
import inspect
from pathlib import Path

import pytest
import symspline
from symspline import _symspline

MODULES = ["analysis", "deform", "files", "fine_tune", "mesh", "shape"]
CLASSES = [value for value in vars(_symspline).values() if inspect.isclass(value)]
FUNCTIONS = [value for value in vars(_symspline).values() if inspect.isbuiltin(value)]
MEMBERS = [
    (of, name)
    for of in CLASSES
    for name in vars(of)
    if not name.startswith("_") and of is not symspline.SymsplineError
]


@pytest.mark.parametrize("thing", CLASSES + FUNCTIONS, ids=lambda thing: thing.__name__)
def test_classes_and_functions_are_described(thing):
    assert (thing.__doc__ or "").strip()


@pytest.mark.parametrize(("of", "name"), MEMBERS, ids=lambda x: x if isinstance(x, str) else x.__name__)
def test_members_are_described(of, name):
    assert (inspect.getattr_static(of, name).__doc__ or "").strip()


def test_there_is_something_to_describe():
    assert len(CLASSES) > 35 and len(FUNCTIONS) > 50 and len(MEMBERS) > 300


def test_every_name_has_a_place():
    placed = set(vars(symspline))
    for name in MODULES:
        placed |= set(vars(importlib.import_module(f"symspline.{name}")))
    assert {thing.__name__ for thing in CLASSES + FUNCTIONS} <= placed


@pytest.mark.parametrize("of", [of for of in CLASSES if of is not symspline.SymsplineError], ids=lambda of: of.__name__)
def test_classes_are_found_where_they_say(of):
    assert getattr(importlib.import_module(of.__module__), of.__name__) is of


def test_examples_in_docs():
    finder, runner = doctest.DocTestFinder(), doctest.DocTestRunner()
    tests = [test for of in CLASSES for test in finder.find(of, of.__name__) if test.examples]
    for test in tests:
        runner.run(test)
    assert len(tests) >= 4 and runner.summarize().failed == 0


def test_examples_in_the_guide():
    guide = Path(__file__).resolve().parents[1] / "README.md"
    result = doctest.testfile(str(guide), module_relative=False)
    assert result.attempted > 20 and result.failed == 0
