# SPDX-License-Identifier: Apache-2.0
"""EXT-6: a surface that fails is named, the others make up for it, and figure
13 is what the servos get when no law flies. A small sample of the grid of
evidence/laws/surfaces.py."""

import subprocess
import sys

import pytest
from conftest import (
    COMMANDS,
    FRAME_MS,
    PROGRAM,
    ROOT,
    SERVOS,
    TIME_LIMIT_S,
    Flight,
    columns,
    transformed,
)
from test_flight import has_jsbsim

sys.path[:0] = [str(ROOT / "evidence" / "laws"),
                str(ROOT / "scripts" / "laws")]

import allocation  # noqa: E402
import surfaces  # noqa: E402

pytestmark = pytest.mark.skipif(
    not has_jsbsim(), reason="make fly installs JSBSim")

FAULT = surfaces.FAULT_MS // FRAME_MS


def test_the_table_is_of_this_aircraft():
    assert allocation.TABLE.read_text(encoding="utf-8") == allocation.text()


def test_gains_give_back_what_is_missing():
    """The helpers' moments of each surface are its own."""
    of = allocation.moments()
    for failed in allocation.SURFACES:
        step = allocation.PER_WORD[allocation.family(failed)]
        for axis in range(3):
            given = sum(
                gain * allocation.PER_WORD[allocation.family(name)]
                * of[name][axis]
                for name, gain in allocation.gains(failed, of).items())
            assert given == pytest.approx(step * of[failed][axis], abs=1e-9)


@pytest.mark.parametrize("surface, where, condition", [
    ("left_aileron", 2000, "calm"), ("right_elevator", -1500, "turbulence"),
    ("left_rudder", surfaces.FLOATS, "heavy"), ("right_flap_1", 2047, "calm"),
])
def test_a_case_of_the_grid_is_flown(surface, where, condition):
    case = surfaces.Case(surface, where, condition, laws=True)
    outcome = surfaces.flown(case)
    assert outcome.is_flown, outcome
    if where != surfaces.FLOATS:
        assert outcome.failed == 1 << allocation.SURFACES.index(surface)
        assert outcome.named <= outcome.told_from + surfaces.NAMED_MS


def test_the_ground_gets_a_report_and_disconnect_is_figure_13(tmp_path, write):
    """Named, told, and made up for until the pilot disconnects."""
    write("faults.txt", "10000 surface left_elevator stuck 3500\n")
    write("sticks.csv", "time_ms,throttle,switch3,switch7\n"
          "0,2048,4095,0\n15000,2048,4095,4095\n16000,2048,4095,4095\n")
    # Without the safety monitor: it asks what figure 13 made of the sticks.
    result = subprocess.run(
        [PROGRAM, "fly", "--plant", "jsbsim", "--laws", "on", "--sticks",
         "sticks.csv", "--faults", "faults.txt", "--quiet", "--record",
         "record.csv", "--events", "events.jsonl", "--summary",
         "summary.json"],
        cwd=tmp_path, capture_output=True, text=True,
        timeout=TIME_LIMIT_S, check=True)
    flight = Flight(tmp_path, result)
    assert flight.events["mcs", "surface_failed"]["count"] == 1
    assert flight.events["mcs", "surface_failed"]["last_detail"] == 8
    assert flight.summary["failed_surfaces"] == ["left_elevator"]
    bit = 1 << allocation.SURFACES.index("left_elevator")
    assert flight.record["laws.failed"][-1] == bit
    assert flight.record["laws.told_failed"][-1] == bit
    held = 14_000 // FRAME_MS
    assert flight.record["pwm.right_elevator"][held] < 1000
    commands = columns(flight, "mcs.uplink", COMMANDS)
    servos = columns(flight, "pwm", SERVOS)
    disconnected = 15_200 // FRAME_MS
    for place in range(disconnected, len(servos)):
        assert servos[place] == transformed(commands[place])


def test_direct_is_figure_13_with_a_failed_surface(fly, write):
    write("faults.txt", "1000 surface right_aileron stuck 100\n")
    write("sticks.csv", "time_ms,roll,pitch\n0,2048,2048\n"
          "1500,2300,1900\n3000,2048,2048\n5000,2048,2048\n")
    flight = fly("--plant", "jsbsim", "--laws", "on", "--sticks",
                 "sticks.csv", "--faults", "faults.txt")
    assert flight.record["laws.failed"][-1] == 2
    commands = columns(flight, "mcs.uplink", COMMANDS)
    servos = columns(flight, "pwm", SERVOS)
    assert all(servos[place] == transformed(commands[place])
               for place in range(10, len(servos)))


@pytest.mark.parametrize("word, slowest, lowest", [
    (0, 49, 330), (1500, 57, 990), (4095, 69, 990)])
def test_a_stuck_throttle_is_reported_and_airspeed_comes_first(
        fly, write, word, slowest, lowest):
    """It is not measured: the engine's speed shows it."""
    write("faults.txt", f"10000 surface throttle stuck {word}\n")
    write("sticks.csv", "time_ms,throttle,switch3\n0,2048,4095\n"
          "90000,2048,4095\n")
    flight = fly("--plant", "jsbsim", "--laws", "on", "--sticks",
                 "sticks.csv", "--faults", "faults.txt", "--quiet")
    event = flight.events["mcs", "surface_failed"]
    assert (event["count"], event["last_detail"]) == (1, 17)
    assert 10_000 < event["first_ms"] < 13_000
    assert flight.summary["failed_surfaces"] == ["throttle"]
    assert flight.record["laws.told_failed"][-1] == 1 << 10
    airspeed = flight.record["mcs.downlink.airspeed"][FAULT:]
    assert min(airspeed) > 32 * slowest
    assert min(flight.record["truth.altitude_ft"][FAULT:]) > lowest


def test_an_engine_that_follows_is_not_reported(fly, write):
    """From stop to stop and back, in a climb and in a glide."""
    write("sticks.csv", "time_ms,throttle,switch2\n0,2048,4095\n"
          "12000,0,4095\n24000,4095,4095\n36000,1000,4095\n"
          "40000,4095,4095\n41000,0,4095\n60000,3000,4095\n"
          "70000,3000,4095\n")
    flight = fly("--plant", "jsbsim", "--laws", "on", "--sticks",
                 "sticks.csv", "--quiet")
    assert flight.record["laws.failed"][-1] == 0
    assert "failed_surfaces" not in flight.summary


@pytest.mark.parametrize("there, is_well", [
    ("one\n", True), ("one\nmore\n", False), ("on\n", False)])
def test_the_table_of_another_aircraft_is_reported(
        monkeypatch, tmp_path, there, is_well):
    table = tmp_path / "table.ads"
    table.write_text(there, encoding="utf-8")
    monkeypatch.setattr(allocation, "TABLE", table)
    monkeypatch.setattr(allocation, "text", lambda: "one\n")
    if not is_well:
        with pytest.raises(SystemExit, match="is of another aircraft"):
            allocation.main(["check"])
        allocation.main(["renew"])
    allocation.main(["check"])


# --- the page ----------------------------------------------------------------

def case(surface, condition="calm", laws=True):
    return surfaces.Case(surface, 0, condition, laws)


def outcome(is_flown, bank=3.0):
    """A flight's result: its worst bank alone decides whether it was flown."""
    made = surfaces.Outcome(bank if is_flown else 90.0, 4.0, None, None, 0)
    assert made.is_flown == is_flown
    return made


def test_the_page_has_a_row_of_each_surface_s_own_cases():
    found = {
        # A surface's name as the command line gives it, no word of ours.
        case("".join(["left_", "aileron"])): outcome(True, 7.0),
        case("left_aileron", "heavy"): outcome(False),
        case("left_aileron", laws=False): outcome(True),
        case("left_rudder"): outcome(True, 2.0)}
    rows = {cells[1].strip(): [cell.strip() for cell in cells[2:-1]]
            for cells in (line.split("|")
                          for line in surfaces.table(found).splitlines()[2:])}
    assert list(rows) == list(allocation.SURFACES)
    assert rows["left_aileron"] == [
        "1 of 2 (50 %)", "7 degrees, 4 ft", "0.0 heavy", "1 of 1 (100 %)"]
    assert rows["left_rudder"] == [
        "1 of 1 (100 %)", "2 degrees, 4 ft", "none", "none flown"]
    assert rows["right_rudder"][0] == "none flown"


def test_ext6_a_new_page_keeps_the_section_of_the_larger_campaign():
    """--only-sound --renew writes that section alone."""
    sound = surfaces.SOUND + "\nIn 10,000 flights none was reported.\n"
    assert surfaces.renewed(
        f"# Old\n\n{sound}", f"# New\n\n{surfaces.SOUND}\nIn 100.\n"
    ) == f"# New\n\n{sound}"
    assert surfaces.renewed("", f"# New\n{sound}") == f"# New\n{sound}"
