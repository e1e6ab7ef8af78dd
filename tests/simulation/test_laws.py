# SPDX-License-Identifier: Apache-2.0
"""EXT-3, EXT-5: the aircraft's control laws in flight."""

import re

import pytest
from conftest import ROOT, fly_in
from test_flight import has_jsbsim

PILOT = ("--plant", "jsbsim", "--pilot", "standard")
FLOWN = ("laws.lateral", "laws.vertical", "laws.power")
LINKED, HOLDING, ORBITING, TERMINATED = 1, 2, 3, 4


@pytest.fixture(autouse=True, scope="module")
def _jsbsim_is_there():
    if not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")


def stick_rows(*rows):
    """A sticks file: time, then what differs from level flight."""
    names = ["roll", "pitch", "throttle",
             *(f"switch{number}" for number in range(1, 9))]
    lines = [",".join(["time_ms", *names])]
    for time, changed in rows:
        words = {"roll": 2048, "pitch": 2048, "throttle": 2048} | changed
        lines.append(",".join([str(time),
                               *(str(words.get(name, 0)) for name in names)]))
    return "\n".join(lines) + "\n"


def between(flight, name, first, last):
    """The values of a column from a second to a second."""
    return flight.record[name][first * 50:last * 50]


def test_ext3_with_the_switches_off_the_laws_change_nothing(tmp_path):
    on, off = (fly_in(tmp_path, *PILOT, "--seconds", "30", "--laws", laws,
                      outputs_in=(tmp_path / laws)) for laws in ("on", "off")
               if not (tmp_path / laws).mkdir())
    assert not [name for name in off.record if name.startswith("laws.")]
    assert {name: column for name, column in on.record.items()
            if not name.startswith("laws.")} == off.record
    assert {word for name in FLOWN for word in on.record[name]} == {0}


def test_ext3_sticks_command_bank_and_an_altitude_is_held(tmp_path):
    (tmp_path / "sticks.csv").write_text(stick_rows(
        (0, {}), (3000, {"switch3": 4095}),
        (8000, {"switch3": 4095, "roll": 2048 + 910}),
        (28000, {"switch3": 4095}), (40000, {"switch4": 4095})))
    flight = fly_in(tmp_path, "--plant", "jsbsim", "--seconds", "45",
                    "--sticks", "sticks.csv")
    bank = between(flight, "truth.bank_deg", 12, 28)
    assert min(bank) > 17 and max(bank) < 23
    assert max(map(abs, between(flight, "truth.bank_deg", 34, 45))) < 2
    altitude = between(flight, "truth.altitude_ft", 3, 40)
    assert max(altitude) - min(altitude) < 15
    airspeed = between(flight, "truth.airspeed_kt", 3, 40)
    assert max(airspeed) - min(airspeed) < 3


def test_ext3_rate_damping_leaves_the_pilot_his_aircraft(tmp_path):
    (tmp_path / "sticks.csv").write_text(stick_rows(
        (0, {"switch1": 4095}),
        (5000, {"switch1": 4095, "roll": 2348}),
        (6000, {"switch1": 4095})))
    flight = fly_in(tmp_path, "--plant", "jsbsim", "--seconds", "10",
                    "--sticks", "sticks.csv")
    assert max(between(flight, "truth.bank_deg", 5, 8)) > 5
    assert {word for word in between(flight, "laws.lateral", 3, 10)} == {1}


def test_ext3_disconnect_is_figure_13_in_one_frame(tmp_path):
    engaged = {"switch2": 4095, "switch3": 4095}
    (tmp_path / "sticks.csv").write_text(stick_rows(
        (0, {}), (3000, engaged | {"roll": 2500}),
        (8000, engaged | {"roll": 2600, "switch7": 4095})))
    flight = fly_in(tmp_path, "--plant", "jsbsim", "--seconds", "9",
                    "--sticks", "sticks.csv")
    switched = next(place for place, word in enumerate(
        flight.record["pwm.discretes"]) if word & 0x40)
    assert flight.record["pwm.left_aileron"][switched - 1] != 2500
    for name, word in (("left_aileron", 2600), ("left_elevator", 2048),
                       ("left_rudder", 2048), ("throttle", 2048)):
        assert set(flight.record[f"pwm.{name}"][switched:]) == {word}, name


def test_ext5_a_cut_of_10_s_at_17_s_is_that_of_the_page(tmp_path):
    page = (ROOT / "docs/control-laws.md").read_text("utf-8")
    bank, feet = map(int, re.search(
        r"cut at 17 s for 10 s, the bank\s+stays below (\d+) degrees and the"
        r"\s+altitude\s+within (\d+) ft", page).groups())
    assert bank <= 35 and feet <= 60
    (tmp_path / "faults.txt").write_text("17000 cut 10000\n")
    flight = fly_in(tmp_path, *PILOT, "--seconds", "60",
                    "--faults", "faults.txt")
    lost = slice(17 * 50, 28 * 50)
    assert max(map(abs, flight.record["truth.bank_deg"][lost])) < bank
    altitude = flight.record["truth.altitude_ft"]
    assert max(abs(each - altitude[17 * 50])
               for each in altitude[lost]) < feet

    # The states follow each other, half a second and five after the last
    # uplink; a second after the first one the pilot flies again.
    link = flight.record["laws.link"]
    begins = [(state, place) for place, state in enumerate(link)
              if place and link[place - 1] != state]
    states = [state for state, _ in begins]
    assert states == [LINKED, HOLDING, ORBITING, LINKED]
    holding, orbiting, linked = (place for _, place in begins[1:])
    assert orbiting - holding == 225
    assert 25 <= holding - 17 * 50 <= 27
    assert 50 <= linked - 27 * 50 <= 54
    assert flight.events["mcs", "link_loss_state"]["count"] == 3

    # The ground is told, within two rows of the log.
    told = flight.record["laws.told"]
    assert {word >> 12 for word in told[linked + 40:]} == {LINKED}
    assert {word >> 12 for word in told[28 * 50:linked]} <= {LINKED, ORBITING,
                                                             HOLDING}


@pytest.mark.parametrize("plant", ["bench", "jsbsim"])
def test_d35_a_link_with_gaps_returns_and_one_with_too_many_does_not(
        tmp_path, plant):
    """After an outage of 0.6 s the link loses 2 of 45 frames: it returns
    within 62 frames and is not lost again. One that loses 20 of 45 does
    not."""
    for gap, returns in ((40, True), (400, False)):
        folder = tmp_path / str(gap)
        folder.mkdir()
        (folder / "faults.txt").write_text("10000 cut 600\n" + "".join(
            f"{time} cut {gap}\n" for time in range(11500, 50000, 900)))
        flight = fly_in(folder, "--plant", plant, "--laws", "on",
                        "--seconds", "50", "--faults", "faults.txt")
        link = flight.record["laws.link"]
        lost = link.index(HOLDING)
        assert 10 * 50 + 24 <= lost <= 10 * 50 + 28
        if returns:
            back = link.index(LINKED, lost)
            assert back - lost <= 62 + 8
            assert set(link[back:]) == {LINKED}
        else:
            # A second without a gap still brings it back.
            link = link[12 * 50:]
            assert LINKED not in link[-25 * 50:]


def test_ext5_times_are_those_of_the_command_line_until_the_ground_sets_others(
        tmp_path):
    """From the last uplink on, to a frame."""
    for name, orders, orbit, end in (("usual", "# none", 75, 210),
                                     ("set", "500 configure 0 2000 9000",
                                      100, 450)):
        folder = tmp_path / name
        folder.mkdir()
        (folder / "faults.txt").write_text("2000 cut 60000\n")
        (folder / "orders.txt").write_text(orders + "\n")
        flight = fly_in(folder, "--laws", "on", "--seconds", "14",
                        "--orbit-after", "1.5", "--terminate-after=4.2",
                        "--orders", "orders.txt", "--faults", "faults.txt")
        link = flight.record["laws.link"]
        assert link.count(HOLDING) == orbit - 25
        assert link.count(ORBITING) == end - orbit
        assert link[-1] == TERMINATED


def test_ext5_after_its_time_it_glides_and_the_link_alone_is_no_way_out(
        tmp_path):
    (tmp_path / "faults.txt").write_text("5000 cut 122000\n")
    flight = fly_in(tmp_path, "--plant", "jsbsim", "--seconds", "140",
                    "--faults", "faults.txt", "--pilot", "standard")
    link = flight.record["laws.link"]
    first = link.index(TERMINATED)
    assert 5 * 50 + 6000 <= first <= 5 * 50 + 6003
    assert set(link[first:]) == {TERMINATED}
    assert set(between(flight, "pwm.throttle", 128, 140)) == {0}
    assert max(map(abs, between(flight, "truth.bank_deg", 130, 140))) < 3
    assert min(between(flight, "truth.airspeed_kt", 127, 140)) > 55
