# SPDX-License-Identifier: Apache-2.0
"""SAF-10, D-33: a lost console does not cost the aircraft. In flight it has the
same effect as a lost link; on the ground the safe words go up."""

import pytest
from conftest import COMMANDS, SERVOS, fly_in, script
from monitor import check
from safe_words import SAFE_COMMANDS
from test_flight import has_jsbsim

jsbsim = pytest.mark.skipif(
    not has_jsbsim(), reason="JSBSim is not installed: make fly installs it")

# A console that moves each 20 ms, so that fresh commands can be told apart.
MOVES = [(0x700 + n, 0x650 - n, 0x555 + n, 0x111 + n, 0x222 + n,
          *((0xFFF if n % 2 else 0) for _ in range(8))) for n in range(300)]

# In the bench both sensors are in the middle, 1024 ft and 64 kt: it flies.
ON_GROUND = "time_ms,airspeed,altitude\n0,0,0\n"
LAWS = ("--plant", "jsbsim", "--laws", "on", "--pilot")


def fresh(flight):
    """The rows in which the aircraft has fresh commands."""
    return [row for row in flight.rows if not row["mcs.uplink.error"] & 1]


def within(rows, first_ms, last_ms):
    return [row for row in rows if first_ms <= row["time_ms"] < last_ms]


def changes(flight, column):
    """When the column changes, and to what."""
    found, before = [], None
    for row in flight.rows:
        if row[column] != before:
            found.append((row["time_ms"], before := row[column]))
    return found


@pytest.fixture
def bench(fly, write):
    def run(fault, sensors=None, *options):
        write("sticks.csv", script(COMMANDS, MOVES, 0))
        write("faults.txt", fault + "\n")
        if sensors:
            write("sensors.csv", sensors)
            options += ("--sensors", "sensors.csv")
        return fly("--sticks", "sticks.csv", "--faults", "faults.txt",
                   "--seconds", "7", *options)
    return run


@pytest.mark.parametrize("schedule", ["report", "fast"])
def test_saf10_in_flight_nothing_fresh_goes_up(bench, schedule):
    flight = bench("1000 gsc console 4000", None, "--schedule", schedule)
    assert within(fresh(flight), 900, 1500)
    assert not within(fresh(flight), 1_600, 5_000)
    # The words of the last packet stay for half a second.
    assert len({tuple(row[f"mcs.uplink.{name}"] for name in COMMANDS)
                for row in within(flight.rows, 1_100, 5_000)}) == 1
    # With the laws off the servos hold, as without a link.
    assert len({tuple(row[f"pwm.{name}"] for name in SERVOS)
                for row in within(flight.rows, 1_100, 5_000)}) == 1
    # It is back with its first packet.
    assert len(within(fresh(flight), 5_100, 7_000)) == 95


def test_saf10_a_short_silence_is_none(bench):
    """For 0.5 s the last words go on."""
    flight = bench("1000 gsc console 480")
    assert len(within(fresh(flight), 500, 3_000)) == 125


@pytest.mark.parametrize("laws", ["off", "on"])
def test_saf10_on_the_ground_the_safe_words_go_up(bench, laws):
    flight = bench("2000 gsc console 4000", ON_GROUND, "--laws", laws)
    assert not within(fresh(flight), 2_600, 4_000)
    safe = within(fresh(flight), 4_100, 6_000)
    assert len(safe) == 95
    assert {tuple(row[f"mcs.uplink.{name}"] for name in COMMANDS)
            for row in safe} == {SAFE_COMMANDS}
    assert {(row["pwm.throttle"], row["pwm.brake"])
            for row in within(flight.rows, 5_200, 6_000)} == {(0, 0xFFF)}


def test_saf10_every_other_downlink_is_enough_to_know_the_place(bench):
    """On a line this slow every other downlink is left out."""
    flight = bench("4000 gsc console 2500", ON_GROUND, "--line-delay", "1.1")
    stale = [row["gsc.downlink.error"] & 1
             for row in within(flight.rows, 1_000, 4_000)]
    assert 0.4 < sum(stale) / len(stale) < 0.6
    safe = within(fresh(flight), 6_100, 6_400)
    assert len(safe) >= 7
    assert {tuple(row[f"mcs.uplink.{name}"] for name in COMMANDS)
            for row in safe} == {SAFE_COMMANDS}


@pytest.mark.parametrize("sensors", [
    "time_ms,airspeed,altitude\n0,0,100\n",
    "time_ms,airspeed,altitude\n0,1344,0\n"])
def test_saf10_one_of_speed_and_height_is_flight_enough(bench, sensors):
    flight = bench("1500 gsc console 5500", sensors)
    assert not within(fresh(flight), 2_100, 7_000)


@pytest.mark.parametrize("fault", [
    "1500 gsc console 4500\n1000 down ber 1 6000",     # no downlink comes
    "1500 gsc console 4500\n1000 mcs stall adc 6000",  # no scan of sensors
])
def test_saf10_what_is_not_known_is_flight(bench, fault):
    """On the ground, and the ground's node does not know it."""
    assert not within(fresh(bench(fault, ON_GROUND)), 2_100, 6_000)


def test_saf10_a_sensor_that_is_not_believed_says_nothing(bench):
    """Speed and height jump to 0 in flight, as from broken wires: for a
    second they are not believed."""
    flight = bench("1500 gsc console 5500",
                   "time_ms,airspeed,altitude\n0,2240,2000\n4000,0,0\n")
    assert not within(fresh(flight), 2_100, 4_900)


def test_saf10_a_console_that_never_came(bench):
    """The aircraft waits with its safe words of power up; on the ground they
    come from the ground, once it knows."""
    flight = bench("0 gsc console 5000", None, "--laws", "on")
    # In the first rows CORE is still cleared.
    assert not within(fresh(flight), 100, 5_000)
    assert {row["laws.link"] for row in within(flight.rows, 0, 5_000)} == {0}
    flight = bench("0 gsc console 5000", ON_GROUND, "--laws", "on")
    assert not within(fresh(flight), 100, 1_000)
    assert {tuple(row[f"mcs.uplink.{name}"] for name in COMMANDS)
            for row in within(fresh(flight), 100, 5_000)} == {SAFE_COMMANDS}


@pytest.mark.parametrize("reset", ["warm", "processor"])
def test_saf10_a_start_of_the_ground_brings_nothing_back(bench, reset):
    flight = bench(f"1500 gsc console 5500\n3000 gsc reset {reset}")
    assert not within(fresh(flight), 2_100, 7_000)


@jsbsim
def test_saf10_d33_a_lost_console_is_a_lost_link(tmp_path):
    """The same states of the link in the same frames, the same modes, and the
    same way through the air, as of a link that is cut half a second later."""
    flights = []
    for name, fault in (("console", "17000 gsc console 9000"),
                        ("link", "17500 cut 8500")):
        folder = tmp_path / name
        folder.mkdir()
        (folder / "faults.txt").write_text(fault + "\n")
        # The pilot rests his hands from the loss on.
        (folder / "sticks.csv").write_text(
            "time_ms,roll,throttle,switch1,switch2\n"
            "0,2048,1800,4095,4095\n15000,2400,1800,4095,4095\n")
        flights.append(fly_in(
            folder, "--plant", "jsbsim", "--laws", "on", "--seconds", "30",
            "--sticks", "sticks.csv", "--faults", "faults.txt"))
    one, other = flights
    states = [changes(flight, "laws.link") for flight in flights]
    assert [state for _, state in states[0]] == [0, 1, 2, 3, 1]
    for mine, its in zip(*states, strict=True):
        assert mine[1] == its[1] and abs(mine[0] - its[0]) <= 40
    for name, most in (("truth.bank_deg", 1.5), ("truth.altitude_ft", 1.5)):
        assert max(abs(mine[name] - its[name]) for mine, its in zip(
            one.rows, other.rows, strict=True)) < most


@jsbsim
@pytest.mark.parametrize("second", [4, 8])
def test_saf10_a_take_off_run_ends_with_brakes_and_idle(fly, write, second):
    write("faults.txt", f"{second}000 gsc console 40000\n")
    flight = fly(*LAWS, "circuit", "--seconds", "30",
                 "--faults", "faults.txt")
    after = within(flight.rows, second * 1000 + 3_500, 30_000)
    assert {(row["pwm.throttle"], row["pwm.brake"])
            for row in after} == {(0, 0xFFF)}
    assert after[-1]["truth.airspeed_kt"] < 1


@jsbsim
def test_saf10_a_landing_without_a_console_ends_with_brakes(fly, write):
    """The console is lost in the roll-out, above 42 kt; the laws are off, the
    throttle is at idle. Once slow, the aircraft is braked."""
    write("sticks.csv", "time_ms,throttle,brake\n0,0,0\n")
    write("faults.txt", "1000 gsc console 100000\n")
    write("conditions.txt", "start runway\nwind 360 0\n")
    flight = fly("--plant", "jsbsim", "--sticks", "sticks.csv",
                 "--conditions", "conditions.txt",
                 "--seconds", "10", "--faults", "faults.txt")
    assert {row["pwm.brake"] for row in within(
        flight.rows, 1_100, 2_900)} == {0}
    assert {row["pwm.brake"] for row in within(
        flight.rows, 3_200, 10_000)} == {0xFFF}


@jsbsim
@pytest.mark.parametrize("pilot, at_ms", [
    ("standard", 9_340), ("standard", 61_500), ("standard", 148_120),
    ("circuit", 17_700), ("circuit", 96_060), ("circuit", 189_300),
    ("circuit", 201_280)])
def test_saf10_a_minute_without_console_is_survived(fly, write, pilot, at_ms):
    """`bin/urv monte-carlo --console-losses 100` flies random losses."""
    write("faults.txt", f"{at_ms} gsc console 60000\n")
    flight = fly(*LAWS, pilot, "--seconds", str(at_ms / 1000 + 65),
                 "--faults", "faults.txt")
    lost = within(flight.rows, at_ms, at_ms + 60_000)
    heights = [row["truth.altitude_ft"] for row in lost]
    assert max(abs(row["truth.bank_deg"]) for row in lost) <= 45
    assert min(heights) >= (
        200 if heights[0] >= 250 else heights[0] - 50)
    assert not [row for row in fresh(flight) if row in lost[100:]]
    assert {row["laws.link"] for row in within(
        flight.rows, at_ms + 61_500, at_ms + 65_000)} == {1}


# The safety monitor's findings (SAF-9) in the altered record.

def altered(flight, column, word, first_ms, last_ms):
    path = flight.path("record.csv")
    titles, *lines = path.read_text().splitlines()
    place = titles.split(",").index(column)
    rows = [line.split(",") for line in lines]
    for row in rows:
        if first_ms <= float(row[1]) < last_ms:
            row[place] = str(word)
    path.write_text("\n".join([titles, *map(",".join, rows)]) + "\n")
    sensors = flight.path("sensors.csv")
    return check(path, flight.path("sticks.csv"),
                 sensors if sensors.exists() else None,
                 flight.path("faults.txt")).violations


def test_saf10_the_monitor_sees_a_fresh_command_in_flight(bench):
    flight = bench("1000 gsc console 4000")
    assert not altered(flight, "mcs.uplink.roll", 0, 0, 0)
    assert any("the console is lost, and mcs.uplink has fresh commands" in said
               for said in altered(
                   flight, "mcs.uplink.error", 0, 3_000, 3_100))


def test_saf10_the_monitor_sees_the_safe_words_in_flight(bench):
    """The old behaviour: 2 s, then idle and brakes."""
    flight = bench("1000 gsc console 4000")
    said = []
    for name, word in zip((*COMMANDS, "error"), (*SAFE_COMMANDS, 0),
                          strict=True):
        said = altered(flight, f"mcs.uplink.{name}", word, 3_060, 5_000)
    assert any("the console is lost in flight, and the safe words reach the"
               " aircraft" in line for line in said)


@pytest.mark.parametrize(("column", "word"), [
    ("mcs.uplink.error", 1), ("pwm.brake", 0), ("pwm.throttle", 7)])
def test_saf10_the_monitor_misses_the_safe_words_on_the_ground(
        bench, column, word):
    flight = bench("500 gsc console 6500", ON_GROUND)
    assert any("on the ground, and the safe words have not come" in said
               for said in altered(flight, column, word, 6_000, 7_000))
