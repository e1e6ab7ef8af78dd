# SPDX-License-Identifier: Apache-2.0
"""SAF-9: what the safety monitor sees in a record, and what it must let
pass."""

import re
import subprocess
import sys

import disturbances
import monitor
import pytest
import timelines
from conftest import COMMANDS, ROOT, SENSORS, SERVOS, script
from safe_words import SAFE_ROW

MONITOR = ROOT / "evidence" / "safety" / "monitor.py"

# Three rows of sticks, each its own; switches off in the first and last.
STICKS = [(0x700 + n, 0x650 - n, 0x555 + n, 0x111 * n, 0x222 + n,
           *((0xFFF if n == 2 and s in (1, 8) else 0) for s in range(1, 9)))
          for n in (1, 2, 3)]
SENSOR_ROWS = [tuple(100 * n + place for place in range(27))
               for n in (1, 2, 3)]


@pytest.fixture
def flown(fly, write):
    """A flight of these sticks, each standing for 400 ms, with its record
    altered; what the monitor finds."""

    def run(alter=None, faults="", *options):
        write("sticks.csv", script(COMMANDS, STICKS, 100).replace(
            "\n120,", "\n500,").replace("\n140,", "\n900,"))
        write("sensors.csv", script(SENSORS, SENSOR_ROWS, 110).replace(
            "\n130,", "\n510,").replace("\n150,", "\n910,"))
        write("faults.txt", faults or "# none\n")
        flight = fly("--sticks", "sticks.csv", "--sensors", "sensors.csv",
                     "--faults", "faults.txt", "--seconds", "1.4", *options)
        path = flight.path("record.csv")
        if alter:
            lines = path.read_text().splitlines()
            rows = [line.split(",") for line in lines]
            alter(Cells(rows))
            path.write_text("\n".join(map(",".join, rows)) + "\n")
        return monitor.check(path, flight.path("sticks.csv"),
                             flight.path("sensors.csv"),
                             flight.path("faults.txt"))

    return run


class Cells:
    """A record's cells, by time and column."""

    def __init__(self, rows):
        self.titles, self.table = rows[0], rows
        self.rows = {float(row[1]): row for row in rows[1:]}

    def put(self, first_ms, last_ms, column, word):
        place = self.titles.index(column)
        for time, row in self.rows.items():
            if first_ms <= time <= last_ms:
                row[place] = str(word)

    def copy(self, group, names, source_ms, first_ms, last_ms, of=None):
        """One row's words of a group, in others; of another group if so."""
        for name in names:
            word = self.rows[source_ms][
                self.titles.index(f"{of or group}.{name}")]
            self.put(first_ms, last_ms, f"{group}.{name}", word)


def said(findings):
    return "\n".join(findings.violations)


def test_a_flight_as_it_should_be_has_no_violation(flown):
    assert flown() == ([], [], 70)


def test_saf9_words_that_the_console_never_held_are_seen(flown):
    findings = flown(lambda cells: cells.put(
        700, 800, "pwm.throttle", 0x345))
    assert "the console never said so: throttle" in said(findings)


def test_saf9_a_word_that_does_not_fit_the_others_is_seen(flown):
    findings = flown(lambda cells: cells.put(
        700, 800, "pwm.steering", 0x556))
    assert "no commands give these outputs" in said(findings)


def test_saf9_saf2_words_of_two_scans_are_seen(flown):
    """The throttle as before the change, the rest as after it."""
    findings = flown(lambda cells: cells.copy(
        "pwm", ("throttle",), 500, 540, 700))
    assert "of no one scan of the console" in said(findings)


def test_saf3_a_switch_that_no_scan_turned_on_is_seen(flown):
    def alter(cells):
        cells.put(300, 400, "pwm.discretes", 4)

    assert "never said so: switch3" in said(flown(alter))


def test_saf4_an_old_command_is_seen(flown):
    """Old positions of the servos come back."""
    def alter(cells):
        cells.copy("pwm", SERVOS, 300, 800, 840)

    assert "the console said so until 500 ms" in said(flown(alter))


def test_saf9_saf6_servos_that_go_back_to_the_safe_words_are_seen(flown):
    def alter(cells):
        cells.copy("pwm", SERVOS, 20, 800, 840)

    assert "back to the safe words" in said(flown(alter))


def test_saf1_the_monitors_safe_words_are_the_programs(fly):
    record = fly("--seconds", "0.02").record
    assert tuple(record[f"pwm.{name}"][0] for name in SERVOS) == SAFE_ROW


def test_saf1_outputs_that_are_not_safe_at_power_up_are_seen(flown):
    def alter(cells):
        cells.put(0, 80, "pwm.brake", 0)

    assert "20 ms: pwm: brake 4095 to 0" in said(flown(alter))


def test_saf3_a_marked_message_that_moves_something_is_seen(flown):
    """The words are good and young, but the message says that they are old."""
    def alter(cells):
        cells.put(560, 600, "mcs.uplink.error", 1)

    assert re.search("5[46]0 ms: pwm: .*no message in mcs.uplink that is not"
                     " marked as old", said(flown(alter)))


@pytest.mark.parametrize("group, names, row_ms, expected", [
    ("gsc.uplink", COMMANDS, 500,
     "gsc.uplink, shown as fresh: .* until 500 ms"),
    ("mcs.uplink", COMMANDS, 500, "mcs.uplink is shown as fresh, unchanged"),
    ("mcs.downlink", SENSORS, 500, "mcs.downlink, shown as fresh"),
    ("gsc.downlink", SENSORS, 500, "gsc.downlink is shown as fresh"),
])
def test_saf5_old_words_shown_as_fresh_are_seen(
        flown, group, names, row_ms, expected):
    """A node's CORE stops while everything else continues."""
    def alter(cells):
        cells.copy(group, names, row_ms, row_ms, 1000)

    assert re.search(expected, said(flown(alter)))


@pytest.mark.parametrize("group, names", [
    ("gsc.uplink", COMMANDS), ("mcs.uplink", COMMANDS),
    ("mcs.downlink", SENSORS), ("gsc.downlink", SENSORS)])
def test_saf5_old_words_that_say_so_are_let_pass(flown, group, names):
    def alter(cells):
        if group == "mcs.uplink":
            cells.copy("pwm", SERVOS, 500, 500, 1000)
        cells.copy(group, names, 500, 500, 1000)
        cells.put(500, 1000, f"{group}.error", 1)

    found = said(flown(alter))
    assert f"{group}, shown" not in found and f"{group} is" not in found


LEFT_RUDDER, THROTTLE = 1 << 4, 1 << 10


@pytest.mark.parametrize("bits, faults, conditions, seen", [
    (LEFT_RUDDER, "", "", ["left_rudder"]),
    (LEFT_RUDDER + 1, "", "", ["left_aileron", "left_rudder"]),
    (THROTTLE, "", "", ["throttle"]),
    # A fault of this servo is in force, of another one, or not yet.
    (LEFT_RUDDER, "600 surface left_rudder slow 50\n", "", []),
    (LEFT_RUDDER, "600 surface right_rudder stuck\n", "", ["left_rudder"]),
    (LEFT_RUDDER, "1200 surface left_rudder stuck\n", "", ["left_rudder"]),
    (THROTTLE, "600 surface throttle stuck 0\n", "", []),
    # A sensor that is known to be wrong.
    (LEFT_RUDDER, "", "bias left_rudder 9 # deg\n", []),
    (LEFT_RUDDER, "", "noise alpha 1\n", ["left_rudder"]),
    (THROTTLE, "", "noise rpm 900\n", []),
])
def test_saf9_ext6_a_false_surface_failure_is_seen(
        fly, write, bits, faults, conditions, seen):
    write("faults.txt", faults or "# none\n")
    flight = fly("--laws", "on", "--seconds", "1.4")
    path = flight.path("record.csv")
    rows = [line.split(",") for line in path.read_text().splitlines()]
    Cells(rows).put(900, 1400, "laws.failed", bits)
    path.write_text("\n".join(map(",".join, rows)) + "\n")
    found = monitor.check(
        path, faults=flight.folder / write("faults.txt", faults or "#\n"),
        conditions=flight.folder / write("conditions.txt",
                                         conditions or "#\n")).violations
    assert [line.split()[3] for line in found] == seen
    assert all(line.startswith("900 ms: laws.failed: ") for line in found)


def test_saf9_ext6_after_a_crash_no_failure_is_false(tmp_path):
    path = tmp_path / "record.csv"
    names = ["time_ms", "frame", "truth.altitude_ft", "laws.failed"]
    rows = [names, *([str(20 * n), str(n - 1), str(max(8, 10 - n)),
                      str(int(n > 5))] for n in range(1, 9))]
    record = monitor.Record.__new__(monitor.Record)
    record.times = [20_000 * n for n in range(1, 9)]
    record.failed = [int(row[3]) for row in rows[1:]]
    record.truth = [row[2:3] for row in rows[1:]]
    flight = monitor.Flight.__new__(monitor.Flight)
    flight.violations, flight.record = [], record
    flight.servo_faults, flight.measured_wrongly = {}, set()
    flight.check_failed_surfaces()
    assert flight.violations == []
    record.truth = [[str(n)] for n in range(8)]
    flight.check_failed_surfaces()
    assert len(flight.violations) == 1


def test_d7_a_wrong_block_is_named_where_the_line_was_faulty(flown):
    """And is a violation where it was not."""
    def alter(cells):
        cells.put(700, 700, "mcs.uplink.throttle", 0x345)
        cells.put(700, 700, "pwm.throttle", 0x345)

    findings = flown(alter, "640 up ber 0.0000001 60\n")
    assert findings.violations == []
    assert len(findings.wrong_blocks) == 1
    assert "wrong block passed: mcs.uplink: throttle" in str(
        findings.wrong_blocks)
    for faults in ("640 down ber 0.0000001 60\n", "300 up ber 0.01 60\n"):
        findings = flown(alter, faults)
        assert "the other node never had this" in said(findings)
        assert "the console never said so: throttle" in said(findings)
        assert findings.wrong_blocks == []


def test_ini6_a_cold_start_leaves_no_fresh_word(flown):
    """CORE is cleared and marked as old, the servos hold the safe words."""
    faults = "".join(f"{at} mcs reset cold\n" for at in range(300, 1300, 107))
    findings = flown(None, faults)
    assert findings.violations == []
    assert findings.wrong_blocks == []

    def alter(cells):
        cells.put(300, 340, "mcs.uplink.error", 0)

    assert flown(alter, faults).wrong_blocks != []


def test_a_flight_with_every_kind_of_fault_has_no_violation(flown):
    findings = flown(None, """
        200 gsc stall adc 50
        300 mcs reset warm
        400 gsc reset processor
        480 cut 45
        560 gsc stall telemetry 31
        620 mcs stall telemetry 22
        700 up ber 0.003 100
        860 mcs bus_error
        900 up drop 3
        930 down flip 7 3
        1000 gsc rom 10 1
        1100 gsc ram 10 1
        1150 gsc reset warm
        1160 mcs reset telemetry
    """)
    assert findings.violations == []


def test_saf11_a_controller_that_stops_leaves_safe_outputs(flown):
    for faults in ("600 mcs halt\n",
                   "500 mcs ram 10 1\n600 mcs reset warm\n"):
        assert flown(faults=faults).violations == []


def test_saf11_frozen_outputs_are_seen(flown):
    def alter(cells):
        cells.copy("pwm", SERVOS, 700, 1100, 1400)

    for faults in ("600 mcs halt\n",
                   "500 mcs ram 10 1\n600 mcs reset warm\n"):
        found = said(flown(alter, faults))
        assert "1120 ms: pwm: frozen outputs: no controller for 520 ms" in found


def test_saf11_a_brake_that_comes_on_is_seen(flown):
    def alter(cells):
        cells.put(1140, 1400, "pwm.brake", 0xFFF)

    assert "frozen outputs" in said(flown(alter, "600 mcs halt\n"))


def test_saf11_safe_outputs_of_a_controller_that_runs_are_seen(flown):
    """A timer that fires too early, or beside a controller."""
    def alter(cells):
        cells.put(1000, 1400, "pwm.throttle", 0)

    assert "pwm: throttle" in said(flown(alter, "600 mcs halt\n"))
    assert "pwm: throttle" in said(flown(alter))


@pytest.mark.parametrize("faults, dead", [
    ("100 mcs halt\n", [(100_000, disturbances.ENDLESS)]),
    ("100 mcs halt\n300 mcs reset warm\n", [(100_000, 300_000)]),
    ("5 mcs halt\n", []),
    ("100 mcs ram 1 1\n200 mcs reset processor\n", []),
    ("100 mcs ram 1 1\n200 mcs reset warm\n400 mcs reset warm\n"
     "500 mcs reset processor\n", [(200_000, 500_000)]),
    ("100 mcs rom 1 1\n200 mcs bus_error\n210 mcs reset warm\n", []),
    ("100 mcs rom 1 1\n200 mcs reset warm\n205 mcs bus_error\n",
     [(200_000, 200_000)]),
    ("100 mcs rom 1 1\n200 mcs halt\n300 mcs bus_error\n"
     "400 mcs reset warm\n", [(200_000, 400_000)]),
])
def test_saf11_a_script_says_when_no_controller_runs(faults, dead):
    assert [*disturbances.Disturbances(faults).dead["mcs"]] == dead


def test_a_bus_error_in_a_start_makes_it_longer():
    """The start that it breaks off was under way, and the next one reads the
    ROM before it ends."""
    down = disturbances.Disturbances(
        "100 gsc reset processor\n105 gsc bus_error\n").down["gsc"]
    assert [tuple(span) for span in down][-1] == (
        100_000,
        100_000 + 2 * disturbances.START_US + disturbances.ROM_READ_US)


def test_a_script_that_is_not_the_flights_is_refused(flown, write, fly):
    write("sticks.csv", script(COMMANDS, STICKS, 100))
    flight = fly("--sticks", "sticks.csv", "--seconds", "1")
    write("other.csv", script(COMMANDS, STICKS, 300))
    with pytest.raises(ValueError, match="has another console"):
        monitor.check(flight.path("record.csv"), flight.path("other.csv"))


FREE, ON_GRID = (timelines.Scan(100, 50, is_free)
                 for is_free in (True, False))


@pytest.mark.parametrize("seen, first, last, scan, begins", [
    # All of one row; the window cuts its beginning off.
    ((1, 1, 1), 0, 500, ON_GRID, 110),
    ((1, 1, 1), 150, 500, ON_GRID, 150),
    ((1, 1, 1), 0, 109, ON_GRID, None),
    ((1, 1, 1), 221, 500, ON_GRID, None),
    # Across a change, in the channels' order only.
    ((1, 1, 2), 0, 500, ON_GRID, 110),
    ((2, 1, 1), 0, 500, ON_GRID, None),
    # A scan begins at 200, sees the change at 220, and not the one at 300.
    ((1, 2, 3), 0, 500, ON_GRID, None),
    ((1, 1, 2), 201, 500, ON_GRID, None),
    # The change at 300 comes with the scan that begins then.
    ((2, 2, 3), 0, 500, timelines.Scan(101, 100), None),
    # One that begins at 210 is not over at 300.
    ((1, 2, 3), 0, 500, timelines.Scan(100, 200), None),
    ((1, 2, 3), 0, 500, timelines.Scan(100, 200, offsets_us=(0, 10)), 110),
    # Not on a grid, for this time.
    ((1, 2, 3), 0, 500, FREE, 110),
    ((1, 2, 3), 0, 299, FREE, None),
    ((1, 2, 3), 0, 500, timelines.Scan(80, 50, True), None),
    # The second channel of the last row is not known.
    ((4, 7, 4), 0, 500, ON_GRID, 400),
])
def test_scans_are_found_in_the_words_at_the_console(
        seen, first, last, scan, begins):
    line = timelines.Timeline(
        [0, 110, 220, 300, 400],
        [(0, 0, 0), (1, 1, 1), (2, 2, 2), (3, 3, 3), (4, None, 4)])
    assert line.earliest_scan(seen, first, last, scan) == begins


def test_the_command_line_says_what_it_found(fly, write):
    write("faults.txt", "# none\n")
    record = fly("--seconds", "0.5").path("record.csv")

    def run(*arguments):
        return subprocess.run(
            [sys.executable, MONITOR, *map(str, arguments)],
            capture_output=True, text=True, check=False)

    good = run(record)
    assert (good.returncode, good.stdout) == (
        0, "25 rows, 0 violations, 0 wrong blocks passed\n")
    lines = record.read_text().splitlines()
    titles, cells = lines[0].split(","), lines[20].split(",")
    cells[titles.index("pwm.brake")] = "77"
    lines[20] = ",".join(cells)
    record.write_text("\n".join(lines) + "\n")
    bad = run(record)
    assert bad.returncode == 1
    assert "400 ms: pwm: brake" in bad.stdout
    assert run(record, "--mcs", record).returncode == 2
    assert run(record.parent / "none.csv").returncode == 2


# --- the defects it was built for -------------------------------------------

@pytest.mark.parametrize("phase", range(10))
@pytest.mark.parametrize("stall_ms", [1, 20, 21, 45])
def test_saf3_a_late_first_scan_turns_nothing_on(fly, write, phase, stall_ms):
    """Every flight passes the monitor; here also what it must see."""
    write("faults.txt", f"0 gsc stall adc {stall_ms}\n")
    record = fly("--seconds", "0.4", "--phase", phase,
                 "--faults", "faults.txt").record
    assert set(record["pwm.discretes"]) == {0}
    for flap in ("left_flap_1", "right_flap_1", "left_flap_2",
                 "right_flap_2"):
        assert set(record[f"pwm.{flap}"]) == {0x800}
    assert record["pwm.brake"][0] == 0xFFF
    assert record["pwm.brake"][-1] == 0x800


def test_saf3_switches_that_a_late_first_scan_turns_on_are_seen(flown):
    """As the words stood in the record before it was mended."""
    def alter(cells):
        for n in range(1, 9):
            cells.put(60, 60, f"mcs.uplink.switch{n}", 0x800)
        cells.put(60, 60, "mcs.uplink.error", 1)
        cells.put(60, 60, "pwm.discretes", 0xFF)
        for flap in ("left_flap_1", "right_flap_1", "left_flap_2",
                     "right_flap_2"):
            cells.put(60, 60, f"pwm.{flap}", 0xFFF)

    found = said(flown(alter, "0 gsc stall adc 21\n"))
    assert "60 ms: pwm: left_flap_1 2048 to 4095" in found
    assert "the console never said so" in found


@pytest.mark.parametrize("phase", range(10))
def test_saf4_no_command_of_before_a_row_of_starts_flies(fly, write, phase):
    """The aircraft starts again and again, while the line is cut, from some
    moment of its frame on: what TELIN had received is of long before."""
    write("sticks.csv", script(COMMANDS, STICKS, 100).replace(
        "\n120,", "\n955,").replace("\n140,", "\n1000,"))
    for after in range(0, 20, 2):
        first = 1001 + after
        write("faults.txt", "\n".join([
            f"{first - 1} cut 400",
            *(f"{first + 9 * n} mcs reset processor" for n in range(21))]))
        record = fly("--sticks", "sticks.csv", "--faults", "faults.txt",
                     "--phase", phase, "--seconds", "1.5").record
        # While the line is cut, what moved the servos last stays.
        assert len(set(record["pwm.throttle"][52:69])) == 1


def test_saf9_ext6_a_sound_servo_reported_as_failed_is_seen(urv_sim, write,
                                                            tmp_path):
    """Every flight passes the monitor: it sees the bench's quick servos taken
    for failed ones."""
    write("sticks.csv", "time_ms,roll,switch1\n0,2048,4095\n"
          "2500,3500,4095\n4000,3500,4095\n")
    result = urv_sim("fly", "--schedule", "fast", "--laws", "on",
                     "--sticks", "sticks.csv",
                     "--record", "record.csv")
    assert result.returncode == 0, result.stderr
    assert monitor.check(tmp_path / "record.csv",
                         tmp_path / "sticks.csv").violations == []


# --- records of the partitions -----------------------------------------------

NODE_GROUPS = {"gsc": ("console", "gsc.uplink", "gsc.downlink"),
               "mcs": ("mcs.uplink", "pwm", "mcs.downlink")}
# When CORE has a frame's words, before the row of the simulation.
TAKEN_US = {"gsc": 12_000, "mcs": 6_000}


@pytest.fixture
def partitions(fly, write, tmp_path):
    """The two records of such a flight as the partitions leave them, made of
    the simulation's; what the monitor finds after they were altered."""

    def run(alter=None, late_us=0, **known):
        write("sticks.csv", script(COMMANDS, STICKS, 100).replace(
            "\n120,", "\n500,").replace("\n140,", "\n900,"))
        write("sensors.csv", script(SENSORS, SENSOR_ROWS, 110).replace(
            "\n130,", "\n510,").replace("\n150,", "\n910,"))
        flight = fly("--sticks", "sticks.csv", "--sensors", "sensors.csv",
                     "--seconds", "1.4")
        titles, *rows = [
            line.split(",")
            for line in flight.path("record.csv").read_text().splitlines()]
        paths = {}
        for node, groups in NODE_GROUPS.items():
            kept = [0, 1, *(
                place for place, title in enumerate(titles)
                if title.rsplit(".", 1)[0] in groups)]
            made = [[titles[place] for place in kept] + ["clock_us"]]
            # They begin with the first frame of tasks.
            for row in rows[2:]:
                time = float(row[1]) * 1000
                made.append([row[place] for place in kept] + [str(
                    round(7e9 + time - TAKEN_US[node]
                          + (late_us if time > 600_000 else 0)))])
            if alter:
                alter(node, Cells(made))
            paths[node] = tmp_path / f"{node}.csv"
            paths[node].write_text("\n".join(map(",".join, made)) + "\n")
        return monitor.check_partitions(**paths, **known)

    return run


def test_partitions_as_they_should_be_have_no_violation(partitions):
    assert partitions() == ([], [], 136)


def test_partitions_on_a_machine_that_is_late_have_none_either(partitions):
    assert partitions(late_us=300_000).violations == []


def test_in_the_fast_schedule_the_grounds_row_may_come_later(partitions):
    def told(late_ms, schedule):
        def alter(node, cells):
            column = cells.titles.index("clock_us")
            for row in cells.table[1:] if node == "gsc" else ():
                row[column] = str(int(row[column]) + 1000 * late_ms)

        return "never had this" in said(partitions(alter, schedule=schedule))

    first = {schedule: next(late_ms for late_ms in range(0, 60, 2)
                            if told(late_ms, schedule))
             for schedule in ("report", "fast")}
    assert first["fast"] - first["report"] == 8


def old_command(first_ms, last_ms, source_ms):
    """The aircraft obeys what the console said at another time."""
    def alter(node, cells):
        if node == "mcs":
            for group, names in (("mcs.uplink", COMMANDS), ("pwm", SERVOS)):
                cells.copy(group, names, source_ms, first_ms, last_ms)

    return alter


@pytest.mark.parametrize("first_ms, last_ms, source_ms, expected", [
    # Words that the ground has not had yet, as when they stood in the line
    # before it was switched on.
    (40, 80, 800, "mcs.uplink: roll"),
    (700, 720, 300, "which is too old"),
])
def test_saf4_an_old_command_that_flies_as_fresh_is_seen(
        partitions, first_ms, last_ms, source_ms, expected):
    alter = old_command(first_ms, last_ms, source_ms)
    assert expected in said(partitions(alter))
    findings = partitions(alter, late_us=300_000)
    assert expected in said(findings)


def test_partitions_servos_that_follow_a_marked_message_are_seen(partitions):
    def alter(node, cells):
        if node == "mcs":
            cells.put(500, 600, "mcs.uplink.error", 1)

    assert "not marked as old" in said(partitions(alter))


class Blurred:
    """In the row in which the servos first move the aircraft's machine was
    late, and CORE has a marked message."""

    def __init__(self, word=0, overruns=1, missing=0):
        self.word, self.overruns, self.missing = word, overruns, missing

    def __call__(self, node, cells):
        if node != "mcs":
            return
        column = cells.titles.index("pwm.throttle")
        at = next(place for place in range(2, len(cells.table))
                  if float(cells.table[place][1]) > 500
                  and cells.table[place][column]
                  != cells.table[place - 1][column])
        time = float(cells.table[at][1])
        cells.put(time, time, "mcs.uplink.error", 1)
        if self.word:
            cells.put(time, time, "mcs.uplink.roll", self.word)
        cells.titles.append("overruns")
        for place, row in enumerate(cells.table[1:], 1):
            row.append(str(self.overruns if place >= at else 0))
        del cells.table[at - self.missing:at]


@pytest.mark.parametrize("late, seen", [
    (Blurred(overruns=0), True), (Blurred(overruns=1), False),
    (Blurred(overruns=0, missing=1), False), (Blurred(7, overruns=0), True),
    (Blurred(7, overruns=1), False), (Blurred(7, 0, missing=1), False)])
def test_partitions_a_message_that_core_missed_on_a_late_machine_is_none(
        partitions, late, seen):
    assert ("not marked as old" in said(partitions(late))) == seen


def test_saf5_a_ground_that_shows_an_old_scan_as_fresh_is_seen(partitions):
    def alter(node, cells):
        if node == "gsc":
            cells.copy("gsc.uplink", COMMANDS, 300, 500, 620)

    assert "gsc.uplink, shown as fresh" in said(partitions(alter))


@pytest.mark.parametrize("missing, seen", [(0, True), (2, False)])
def test_partitions_what_stood_in_a_missing_row_is_not_judged(
        partitions, missing, seen):
    def alter(node, cells):
        if node == "gsc":
            cells.copy("gsc.uplink", COMMANDS, 300, 620, 620)
            at = next(place for place, row in enumerate(cells.table)
                      if place and float(row[1]) == 620)
            del cells.table[at - missing:at]

    findings = said(partitions(alter))
    assert ("gsc.uplink, shown as fresh" in findings) == seen


@pytest.mark.parametrize("missing, late_ms, seen", [
    (0, 0, True), (1, 0, False), (0, 580, False), (0, 300, True)])
def test_partitions_what_was_sent_where_the_machine_was_late_is_not_judged(
        partitions, missing, late_ms, seen):
    def alter(node, cells):
        if node == "gsc":
            cells.put(620, 620, "gsc.downlink.altitude", 77)
            return
        cells.titles.append("overruns")
        for row in cells.table[1:]:
            row.append(str(int(0 < late_ms <= float(row[1]))))
        at = next(place for place, row in enumerate(cells.table)
                  if place and float(row[1]) == 580)
        del cells.table[at - missing:at]

    findings = said(partitions(alter))
    assert ("the other node never had this" in findings) == seen


def test_partitions_what_a_test_disturbs_is_no_violation(partitions):
    def alter(node, cells):
        if node == "mcs":
            cells.put(300, 300, "mcs.uplink.yaw", 5)
            for servo in ("left_rudder", "right_rudder", "steering"):
                cells.put(300, 300, f"pwm.{servo}", 5)

    assert "mcs.uplink: yaw" in said(partitions(alter))
    at = 7_000_000_000 + 280_000
    findings = partitions(alter, disturbed=[(at, at + 20_000)])
    assert findings.violations == []
    assert len(findings.wrong_blocks) == 1


def test_partitions_words_stand_while_a_node_starts(partitions):
    def alter(node, cells):
        if node == "mcs":
            cells.copy("mcs.uplink", COMMANDS, 520, 540, 600)
            cells.copy("pwm", SERVOS, 520, 540, 600)

    assert "is shown as fresh, unchanged" in said(partitions(alter))
    assert partitions(alter, starts=[
        ("mcs", 7_000_000_000 + 530_000)]).violations == []
