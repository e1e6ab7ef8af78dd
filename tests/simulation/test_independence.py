# SPDX-License-Identifier: Apache-2.0
"""EVI-6: what evidence/independence.py makes of what it sees."""

import sys

from conftest import PROGRAM, ROOT

sys.path.insert(0, str(ROOT / "evidence"))

import independence  # noqa: E402


def test_bytes_of_flights_are_those_of_the_flights(monkeypatch):
    first = independence.bytes_of_flights(PROGRAM)
    assert first == independence.bytes_of_flights(PROGRAM)
    monkeypatch.setattr(independence, "FLIGHTS",
                        (*independence.FLIGHTS[:-1], ("--seconds", "6")))
    assert first != independence.bytes_of_flights(PROGRAM)
