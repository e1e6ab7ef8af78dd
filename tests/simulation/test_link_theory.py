# SPDX-License-Identifier: Apache-2.0
"""LNK-6, SIM-2: delivery, retries and latency under bit errors are what
theory says."""

import math
import re
import sys

import pytest
from conftest import CHARACTER_US, PROGRAM, ROOT, UPLINK_CHARACTERS

sys.path.insert(0, str(ROOT / "evidence" / "campaign"))

import run  # noqa: E402
import theory  # noqa: E402

FRAMES = 8_000

# The seed is fixed, so a test that passes once passes always. By chance one
# of the 20 comparisons would be beyond 3.5 standard errors once in a hundred.
LIMIT = 3.5


@pytest.fixture(autouse=True)
def _same_program(monkeypatch):
    monkeypatch.setattr(run, "PROGRAM", PROGRAM)


@pytest.mark.parametrize("rate", ["1e-5", "1e-4", "3e-4", "1e-3"])
def test_measurement_agrees_with_theory(rate):
    expected = theory.theory(float(rate))
    measured = theory.measure(rate, FRAMES)
    far = {name: (expected[name], measured[name])
           for name in theory.QUANTITIES
           if theory.z_score(measured[name], expected[name], FRAMES) > LIMIT}
    assert far == {}


def test_another_rate_is_told_apart():
    # The comparison is sharp: a fifth more errors would not pass.
    frames = 12_000
    expected = theory.theory(1.2e-3)
    measured = theory.measure("1e-3", frames)
    for name in theory.QUANTITIES:
        assert theory.z_score(measured[name], expected[name], frames) > LIMIT


def test_theory_without_errors():
    assert theory.theory(0.0) == {
        "up_delivered": 1, "up_sent": 1, "up_ms": pytest.approx(
            UPLINK_CHARACTERS * CHARACTER_US / 1000),
        "down_delivered": 1, "down_sent": 1}


def test_theory_where_nothing_gets_through():
    nearly = theory.theory(0.5)
    assert nearly["up_delivered"] < 1e-60
    assert math.isclose(nearly["up_sent"], 2, abs_tol=1e-9)


def test_theory_is_what_the_page_has():
    """To the last digit, at every rate; the measurement beside it is not
    flown anew."""
    page = (ROOT / "docs" / "evidence" / "link.md").read_text("utf-8")
    rows = page.partition("<!-- make -C evidence theory -->")[2].partition("<!--")[0]
    found = {cells[1].strip(): [cell.partition("/")[0].strip()
                                for cell in cells[2:-1]]
             for cells in (line.split("|") for line in rows.splitlines()
                           if re.match(r"\| \de-", line))}
    assert len(found) == 8
    for rate, there in found.items():
        expected = theory.theory(float(rate))
        assert there == [f"{expected[name]:.4f}"
                         for name in theory.QUANTITIES], rate
