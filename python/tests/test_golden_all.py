"""Every golden case is run, over fractions and over floats, but for those named here."""

import test_golden  # noqa: F401
import test_golden_bodies  # noqa: F401
import test_golden_fine_tune  # noqa: F401
import test_golden_form  # noqa: F401
import test_golden_shape  # noqa: F401
from golden_cases import CASES, NUMBERS, RUN

#: Categories that are run over one field alone, and why.
ONE_FIELD = {
    "closed_spring": (("float",), "springs come to rest by steps over floats"),
}


def test_every_case_is_run():
    counts = {name: len(cases) for name, cases in CASES.items()}
    assert {name: count for name, (count, _) in RUN.items()} == counts
    assert len(counts) == 64 and sum(counts.values()) == 286


def test_every_case_is_run_over_both_fields():
    single = {name: fields for name, (_, fields) in RUN.items() if set(fields) != set(NUMBERS)}
    assert single == {name: fields for name, (fields, _) in ONE_FIELD.items()}
