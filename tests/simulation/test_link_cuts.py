# SPDX-License-Identifier: Apache-2.0
"""EXT-5: scripts/link_cuts.py, and a sample of the flights that it flies."""

import link_cuts
import pytest
from test_flight import has_jsbsim

WELL = {"second": 17, "bank": 20.0, "low": 990.0, "high": 1010.0, "drift": 9.0,
        "end_bank": 1.0, "end_altitude": 1000.0, "linked": 1.0}


@pytest.mark.skipif(
    not has_jsbsim(), reason="JSBSim is not installed: make fly installs it")
@pytest.mark.parametrize("second", [1, 17, 46, 77, 113, 149])
def test_ext5_a_minute_without_link_is_survived(second):
    """A sample of scripts/link_cuts.py, which flies them all."""
    flown = link_cuts.fly(second, 60)
    assert link_cuts.is_well(flown), flown


@pytest.mark.parametrize("wrong", [
    {"bank": 45.1}, {"linked": 0.0}, {"end_bank": 31.0},
    {"end_altitude": 799.0}, {"end_altitude": 1501.0}])
def test_ext5_what_is_not_well_is_told(wrong):
    assert link_cuts.is_well(WELL)
    assert not link_cuts.is_well(WELL | wrong)
