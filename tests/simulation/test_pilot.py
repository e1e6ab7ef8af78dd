# SPDX-License-Identifier: Apache-2.0
"""The simulated pilot's use of the downlink's error word (SIM-3, TST-4): bit 0
marks the words as old, and no other bit does."""

import pytest
from conftest import fly_in
from test_flight import DOCUMENTED, has_jsbsim, is_as_documented

ROM_DIFFERS = 2


@pytest.fixture(scope="module", autouse=True)
def _jsbsim_is_there():
    if not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")


def test_tst4_the_pilot_flies_on_after_a_rom_fault_of_the_aircraft(tmp_path):
    """The downlink is fresh, but its error word is never 0 again."""
    (tmp_path / "faults.txt").write_text("5000 mcs rom 1000 1\n")
    flight = fly_in(tmp_path, "--plant", "jsbsim", "--pilot", "standard",
                    "--faults", "faults.txt")
    marks = [word & 0xF for word in flight.record["gsc.downlink.error"]]
    first = marks.index(ROM_DIFFERS)
    # Found in two passes of 20.48 s (docs/self-test.md), before most turns.
    assert first < 50 * 46
    assert set(marks[first:]) == {ROM_DIFFERS}
    quality = flight.summary["flight_quality"]
    for name in DOCUMENTED:
        assert is_as_documented(quality, name), (name, quality[name])
    assert (quality["ended_level"], quality["crashed"]) == (True, False)
