# SPDX-License-Identifier: Apache-2.0
"""EXT-5: evidence/link_cuts.py, and a sample of the flights that it flies."""

import link_cuts
import pytest
from test_flight import has_jsbsim

WELL = {"second": 17, "bank": 20.0, "low": 990.0, "high": 1010.0, "drift": 9.0,
        "end_bank": 1.0, "end_altitude": 1000.0, "linked": 1.0}


@pytest.mark.skipif(
    not has_jsbsim(), reason="JSBSim is not installed: make fly installs it")
@pytest.mark.parametrize("second", [1, 17, 46, 77, 113, 149])
def test_ext5_a_minute_without_link_is_survived(second):
    """A sample of evidence/link_cuts.py, which flies them all."""
    flown = link_cuts.fly(second, 60)
    assert link_cuts.is_well(flown), flown


@pytest.mark.parametrize("wrong", [
    {"bank": 45.1}, {"linked": 0.0}, {"end_bank": 31.0},
    {"end_altitude": 799.0}, {"end_altitude": 1501.0}])
def test_ext5_what_is_not_well_is_reported(wrong):
    assert link_cuts.is_well(WELL)
    assert not link_cuts.is_well(WELL | wrong)


def test_ext5_the_drift_of_a_cut_is_that_until_it_ends(monkeypatch):
    """The worst of everything else counts to the end of the flight."""
    rows = [(4, 90, 0, 0), (5, 10, 1000, 0), (6, -12, 1030, 2),
            (7, 5, 1010, 2), (8, 30, 900, 1)]

    def flown(command, check):
        (record,) = (after for name, after in zip(command, command[1:])
                     if name == "--record")
        record.write_text("\n".join(
            ["time_ms,truth.bank_deg,truth.altitude_ft,laws.link"]
            + [f"{second * 1000},{bank},{altitude},{link}"
               for second, bank, altitude, link in rows]) + "\n")
    monkeypatch.setattr(link_cuts.subprocess, "run", flown)
    assert link_cuts.fly(5, 2) == {
        "second": 5, "bank": 30, "low": 900, "high": 1030, "drift": 30,
        "end_bank": 30, "end_altitude": 900, "linked": 1}


@pytest.mark.parametrize("linked", [1.0, 0.0])
def test_ext5_a_link_that_stays_lost_is_reported(monkeypatch, capsys, linked):
    flown = {"bank": 20, "low": 900, "high": 1100, "drift": 50,
             "end_bank": 1, "end_altitude": 1000, "linked": linked}
    monkeypatch.setattr(link_cuts, "fly", lambda second, _: {
        **flown, "second": second})
    monkeypatch.setattr(
        link_cuts.sys, "argv", "link_cuts.py --every 90 --all".split())
    assert link_cuts.main() == (0 if linked else 1)
    *lines, last = capsys.readouterr().out.splitlines()
    assert len(lines) == 2
    assert all(line.endswith(", link lost") == (not linked) for line in lines)
    assert last.startswith(
        f"2 flights with a cut of 60 s, {0 if linked else 2} not well")
