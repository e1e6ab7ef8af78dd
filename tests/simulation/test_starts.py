# SPDX-License-Identifier: Apache-2.0
"""Starts in flight (INI-1, INI-3, INI-6): either node is reset, or its
processor restarted, at any time. The servos are never disturbed, CORE keeps
what it has, and soon all is as in a flight without faults.

Each frame has words of its own, so that the words of a node identify their
frame.
"""

import re
from collections import defaultdict

import pytest
from conftest import (
    COMMANDS,
    FRAMES_PER_S,
    FRAME_MS,
    FRAME_US,
    ROOT,
    SENSORS,
    SERVOS,
    TICK_US,
    columns,
    different_rows,
    fly_in,
    script,
    transformed,
)
from safe_words import unattended

# The words of a frame, without the error word: when a node starts just
# before its frame begins, the first words it sends are old, and say so.
GROUPS = {
    "gsc.uplink": COMMANDS,
    "mcs.uplink": COMMANDS,
    "pwm": SERVOS,
    "mcs.downlink": SENSORS,
    "gsc.downlink": SENSORS,
}

# From the frame of the start on, the frames in which something is old that
# would not be without it: the most there are, at whatever time and phase.
# docs/starts.md has them, too.
RECOVERY_FRAMES = {
    ("gsc", "warm"): {"commands": 3, "sensors": 3},
    ("gsc", "processor"): {"commands": 3, "sensors": 3},
    ("mcs", "warm"): {"commands": 3, "sensors": 4},
    ("mcs", "processor"): {"commands": 3, "sensors": 4},
}
PROMISED_FRAMES = 5
SHOWN_BY = {"pwm": "commands", "gsc.downlink": "sensors"}

# Every tick of a frame, just before and after some, and between. A node that
# starts scans its converter for 0.5 ms; the words do not change meanwhile.
TIMES_US = sorted([
    *range(0, FRAME_US, TICK_US),
    *(tick + more for tick in range(TICK_US, FRAME_US + TICK_US, 2 * TICK_US)
      for more in (-1, 1, 37, 450, 1_001)),
])
CHANGE_MS = 11

START_FRAMES = 8
APART = 10


class Course:
    """Scripts of a number of frames, and their flight without faults."""

    def __init__(self, folder, frames, phase=3):
        self.folder = folder
        self.frames = frames
        self.phase = phase
        sticks = different_rows(frames, len(COMMANDS), seed=17)
        sensors = different_rows(frames, len(SENSORS), seed=18)
        (folder / "sticks.csv").write_text(script(COMMANDS, sticks, CHANGE_MS))
        (folder / "sensors.csv").write_text(
            script(SENSORS, sensors, CHANGE_MS + 2 * phase))
        ages = {
            COMMANDS: {tuple(row): n for n, row in enumerate(sticks)},
            SERVOS: {transformed(row): n for n, row in enumerate(sticks)},
            SENSORS: {tuple(row): n for n, row in enumerate(sensors)},
        }
        self.origin = {group: ages[names] for group, names in GROUPS.items()}
        self.perfect = self.ages(self.fly("perfect"))

    def fly(self, name, faults=(), *options):
        into = self.folder / name
        into.mkdir(exist_ok=True)
        (self.folder / f"{name}.txt").write_text(
            "\n".join(["# none", *faults]) + "\n")
        return fly_in(self.folder, "--sticks", "sticks.csv",
                      "--sensors", "sensors.csv", "--phase", self.phase,
                      "--seconds", self.frames / FRAMES_PER_S,
                      "--faults", f"{name}.txt", *options, outputs_in=into)

    def ages(self, flight):
        """For each group and frame, the frame of the words it holds; None
        for words that nobody ever gave."""
        return {
            group: [self.origin[group].get(words)
                    for words in columns(flight, group, names)]
            for group, names in GROUPS.items()
        }


def disturbances(course, flight):
    """Forbidden events, as text."""
    found = []
    for group, ages in course.ages(flight).items():
        newest = -1
        for frame in range(START_FRAMES, course.frames):
            age = ages[frame]
            if age is None:
                found.append(f"{group}, frame {frame}: words nobody gave")
            elif age < newest:
                found.append(f"{group}, frame {frame}: words of {age}"
                             f" after those of {newest}")
            # The first scan after a start comes at another time of its
            # frame, and a block put just before a later exchange need not
            # wait a frame for the next: so words may be two frames newer.
            elif age > course.perfect[group][frame] + 2:
                found.append(f"{group}, frame {frame}: words of {age}"
                             " too soon")
            newest = newest if age is None else age
    if flight.summary["overruns"]:
        found.append(f"{flight.summary['overruns']} overruns")
    return found


def recovery(course, flight, first, stop):
    """For commands and for sensors, the frames from the first on until all
    is, and stays, as without faults."""
    took = {}
    for group, what in SHOWN_BY.items():
        ages = course.ages(flight)[group]
        late = [frame for frame in range(first, stop)
                if ages[frame] != course.perfect[group][frame]]
        took[what] = late[-1] + 1 - first if late else 0
    return took


def starts(node, how):
    """A start at each time, one after the other, and in which frames."""
    lines, frames = [], []
    for number, time_us in enumerate(TIMES_US):
        frame = START_FRAMES + APART * number
        frames.append(frame)
        lines.append(f"{FRAME_MS * frame + time_us / 1000:.3f} {node} reset"
                     f" {how}")
    return lines, frames


@pytest.fixture(scope="module")
def courses(tmp_path_factory):
    made = {}

    def course(phase, frames=START_FRAMES + APART * (len(TIMES_US) + 1)):
        if (phase, frames) not in made:
            made[phase, frames] = Course(
                tmp_path_factory.mktemp("starts"), frames, phase)
        return made[phase, frames]

    return course


# --- at any time -----------------------------------------------------------

def status_of(node, flight):
    return flight.summary["core_status"][node]


@pytest.mark.parametrize("node, how", RECOVERY_FRAMES)
def test_ini1_ini3_ini6_a_start_at_any_time_disturbs_nothing(courses, node,
                                                             how):
    worst = defaultdict(int)
    for phase in range(10):
        course = courses(phase)
        lines, frames = starts(node, how)
        flight = course.fly(f"{node} {how}", lines)
        wrong = disturbances(course, flight)
        assert not wrong, f"phase {phase}: " + "\n".join(wrong[:20])
        for first in frames:
            took = recovery(course, flight, first, first + APART)
            for what, count in took.items():
                assert count <= PROMISED_FRAMES, (phase, lines[0], took)
                worst[what] = max(worst[what], count)

        # CORE's status has counted them, and the log.
        status = status_of(node, flight)
        count, kind = {"warm": ("warm_resets", "warm_reset"),
                       "processor": ("processor_restarts",
                                     "processor_restart")}[how]
        assert status["cold_starts"] == 1
        assert status[count] == len(frames)
        assert status["start_condition"] == (2 if how == "warm" else 3)
        assert flight.events[node, kind]["count"] == len(frames)
    assert dict(worst) == RECOVERY_FRAMES[node, how]


def test_ini1_the_documented_recovery_is_the_measured_one():
    text = (ROOT / "docs" / "starts.md").read_text(encoding="utf-8")
    rows = re.findall(
        r"^\| `(gsc|mcs) reset (warm|processor)` \| (\d) \| (\d) \|$", text,
        re.M)
    assert {(node, how): {"commands": int(commands), "sensors": int(sensors)}
            for node, how, commands, sensors in rows} == RECOVERY_FRAMES


def test_ini1_starts_of_both_nodes_at_once(courses):
    course = courses(3)
    lines, frames = starts("gsc", "warm")
    others = [line.replace("gsc", "mcs") for line in lines]
    flight = course.fly("both", lines + others)
    assert not disturbances(course, flight)
    for first in frames:
        took = recovery(course, flight, first, first + APART)
        assert max(took.values()) <= PROMISED_FRAMES, (first, took)


@pytest.mark.parametrize("node", ["gsc", "mcs"])
@pytest.mark.parametrize("apart_ms", [0.016, 1, 2.5, 7, 9.999])
def test_ini1_a_start_during_a_start_repeats_it(courses, node, apart_ms):
    # The last one says what it is.
    course = courses(3, 60)
    flight = course.fly(f"{node} {apart_ms}", [
        f"{400 + apart_ms * number:.3f} {node} reset"
        f" {'warm' if number % 2 else 'processor'}" for number in range(9)])
    assert not disturbances(course, flight)
    status = status_of(node, flight)
    assert (status["warm_resets"], status["processor_restarts"]) == (0, 1)
    last = int((400 + apart_ms * 8) // FRAME_MS)
    took = recovery(course, flight, last, 60)
    assert max(took.values()) <= PROMISED_FRAMES, took


@pytest.mark.parametrize("node", ["gsc", "mcs"])
@pytest.mark.parametrize("apart_ms", [10, 10.001, 12, 20, 31])
def test_ini1_starts_in_a_row(courses, node, apart_ms):
    # Each is through before the next comes: each is counted.
    course = courses(3, 100)
    flight = course.fly(f"{node} row {apart_ms}", [
        f"{400 + apart_ms * number:.3f} {node} reset"
        f" {'warm' if number % 2 else 'processor'}" for number in range(20)])
    assert not disturbances(course, flight)
    status = status_of(node, flight)
    counted = status["warm_resets"], status["processor_restarts"]
    # At the same instant the switch comes first.
    assert counted == ((1, 0) if apart_ms == 10 else (10, 10))
    last = int((400 + apart_ms * 19) // FRAME_MS)
    took = recovery(course, flight, last, 100)
    assert max(took.values()) <= PROMISED_FRAMES, took


def test_ini1_before_power_up_a_reset_does_nothing(courses):
    course = courses(9, 60)
    plain = course.fly("plain")
    flight = course.fly("early", [
        "0 gsc reset warm", "0 mcs reset processor", "5 mcs reset warm",
        "17.999 mcs reset telemetry", "18 mcs reset warm"])
    for name in ("record.csv", "wire.csv", "events.jsonl"):
        assert flight.path(name).read_bytes() == \
            plain.path(name).read_bytes(), name


# Throttle idle, brake full on, switches off, all else in the middle (SAF-1).
SAFE = [0x800] * 7 + [0, 0xFFF] + [0x800] * 4 + [0]


def test_saf1_a_late_first_scan_turns_nothing_on(courses):
    # The first scan comes a frame late; before it there are no words of the
    # sticks, and nothing at the servos may look as if there were.
    course = courses(3, 60)
    flight = course.fly("late", ["0 gsc stall adc 21"])
    ages = course.ages(flight)["pwm"]
    for row, age in zip(flight.rows, ages, strict=True):
        servos = [row[f"pwm.{name}"] for name in SERVOS]
        assert age is not None or servos == SAFE, row["time_ms"]
        if age is None:
            assert {row[f"mcs.uplink.switch{n}"] for n in range(1, 9)} == {0}
    assert None in ages and ages[-1] is not None


@pytest.mark.parametrize("node", ["gsc", "mcs"])
def test_ini1_ini3_power_up_is_a_cold_start(courses, node):
    # Servos neutral, CORE cleared, until something has come; then commands.
    course = courses(3, 60)
    flight = course.fly("plain")
    assert status_of(node, flight)["start_condition"] == 1
    assert status_of(node, flight)["cold_starts"] == 1
    first = flight.rows[0]
    assert [first[f"pwm.{name}"] for name in SERVOS] == SAFE
    assert {first[f"{group}.{name}"] for group in
            ("gsc.uplink", "gsc.downlink", "mcs.uplink", "mcs.downlink")
            for name in GROUPS[group]} == {0}
    # A reset does not make CORE or servos look like that again: see
    # disturbances.
    reset = course.fly("reset", [f"400 {node} reset warm"])
    assert None not in course.ages(reset)["pwm"][START_FRAMES:]


# --- exceptions ------------------------------------------------------------

@pytest.mark.parametrize("node", ["gsc", "mcs"])
@pytest.mark.parametrize("processors", [1, 2, 4])
def test_krn6_an_exception_restarts_the_processor(courses, node, processors):
    # Nothing answers a read of the ROM, in minor frame 6.
    course = courses(3, 100)
    times = (400, 403.5, 800, 1200)
    flight = course.fly(
        f"exception {node} {processors}",
        [f"{time} {node} bus_error" for time in times],
        "--processors", processors)
    # The second hits the self-test of the restart that the first made, or
    # comes before it and is the same.
    assert not disturbances(course, flight)
    status = status_of(node, flight)
    assert status["start_condition"] == 3
    assert status["processor_restarts"] == 3
    assert flight.events[node, "processor_restart"]["count"] == 3
    took = recovery(course, flight, 60, 100)
    assert 0 < max(took.values()) <= PROMISED_FRAMES + 1, took


def test_krn6_after_an_exception_at_power_up_the_start_is_a_cold_one(courses):
    flight = courses(3, 60).fly(
        "cold", ["0 gsc bus_error", "5 mcs bus_error"])
    for node in ("gsc", "mcs"):
        status = status_of(node, flight)
        assert status["start_condition"] == 1
        assert status["cold_starts"] == 1
        assert status["processor_restarts"] == 0
    assert recovery(courses(3, 60), flight, 12, 60) == {
        "commands": 0, "sensors": 0}


# --- self-test -------------------------------------------------------------

def test_tst1_a_thousand_starts_without_a_false_alarm(fly, write):
    lines = []
    for number in range(250):
        time = 200 + 45.123 * number
        lines += [f"{time:.3f} gsc reset warm",
                  f"{time + 3:.3f} mcs reset processor",
                  f"{time + 22:.3f} mcs reset warm",
                  f"{time + 23:.3f} gsc reset processor"]
    write("faults.txt", "\n".join(lines))
    flight = fly("--seconds", "12", "--faults", "faults.txt")
    for node in ("gsc", "mcs"):
        status = status_of(node, flight)
        assert status["warm_resets"] == 250
        assert status["processor_restarts"] == 250
        assert status["self_test_result"] == 0
        assert (node, "self_test_failed") not in flight.events
        assert (node, "rom_check_failed") not in flight.events
    assert flight.summary["overruns"] == 0


# The result in CORE: the test's number, and for the RAM the block of 16 words.
HARM = {
    "rom 0 1": 0x1000,
    "rom ffff 80": 0x1000,
    "ram 0 1": 0x2000,
    "ram 1234 8000": 0x2123,
    "ram 1fff ffff": 0x21FF,
}


@pytest.mark.parametrize("node", ["gsc", "mcs"])
@pytest.mark.parametrize("harm", HARM)
def test_ini2_tst1_tst4_a_failed_self_test_ends_in_silence(
        courses, harm, node):
    course = courses(3, 100)
    flight = course.fly(f"{node} {harm}", [
        f"600 {node} {harm}", f"806 {node} reset warm"])
    status = status_of(node, flight)
    assert status["self_test_result"] == HARM[harm]
    assert status["start_condition"] == 2
    failed = flight.events[node, "self_test_failed"]
    assert (failed["count"], failed["last_detail"]) == (1, HARM[harm])

    # The node's own CORE stays as it is for ever. The servos of a silent
    # ground do so, too; those of an aircraft are safe half a second later.
    held = [f"{node}.uplink", f"{node}.downlink"]
    if node == "mcs":
        rows = columns(flight, "pwm", GROUPS["pwm"])
        assert len(set(rows[45:63])) == 1 and rows[45] in course.origin["pwm"]
        assert set(rows[67:]) == {unattended(rows[45])}
    else:
        held.append("pwm")
    for group in held:
        rows = columns(flight, group, GROUPS[group])
        assert len(set(rows[45:])) == 1, group
        assert rows[-1] in course.origin[group]

    if node == "mcs":
        # One last downlink, which says so; then nothing more.
        errors = flight.record["gsc.downlink.error"]
        assert set(errors[START_FRAMES:40]) == {0}
        assert errors[44:] == [5] * (100 - 44)
        sent = flight.record["link.downlink_sent"]
        assert sent[44] == sent[-1]
    else:
        # The aircraft is asked for nothing more.
        for count in ("link.uplink_sent", "link.downlink_sent"):
            sent = flight.record[count]
            assert sent[44] == sent[-1]


# A fault after the present place of the check, and one before it.
@pytest.mark.parametrize("node, other, way", [
    ("mcs", "gsc", "downlink"), ("gsc", "mcs", "uplink")])
@pytest.mark.parametrize("byte, frame", [("1234", 1024), ("0", 2048)])
def test_tst3_tst4_a_rom_that_fails_in_flight_is_seen_at_both_ends(
        fly, write, node, other, way, byte, frame):
    write("faults.txt", f"1000 {node} rom {byte} 10\n")
    flight = fly("--seconds", "42", "--faults", "faults.txt")
    found = flight.events[node, "rom_check_failed"]
    assert found["first_frame"] == frame
    passes = 2100 // 1024
    status = status_of(node, flight)
    assert status["rom_failures"] == found["count"]
    assert status["rom_passes"] + status["rom_failures"] == passes
    assert status_of(other, flight)["rom_failures"] == 0

    # In the error word from the next frame on, and soon at the other end.
    for where, later in ((node, 1), (other, 4)):
        errors = flight.record[f"{where}.{way}.error"]
        assert set(errors[START_FRAMES:frame]) == {0}
        assert set(errors[frame + later:]) == {2}
    # Nothing else is different.
    assert flight.summary["link"]["uplink_sent"] == 2099
    assert flight.summary["link"]["downlink_received"] >= 2097
    assert flight.summary["overruns"] == 0


# --- the converter ---------------------------------------------------------

@pytest.mark.parametrize("node, lag_ms, way", [
    ("gsc", 0, "uplink"), ("mcs", 6, "downlink")])
def test_ad1_a_converter_that_stalls_is_reported(courses, node, lag_ms, way):
    course = courses(3, 60)
    flight = course.fly(f"stall {node}",
                        [f"{400 + lag_ms} {node} stall adc 200"])
    # The node's frames 20 to 29 have no scan.
    errors = flight.record[f"{node}.{way}.error"]
    stale = [frame for frame, word in enumerate(errors)
             if word and frame >= START_FRAMES]
    assert stale == list(range(21, 31))
    assert flight.events[node, "ad_no_scan"]["count"] == 10
    ages = course.ages(flight)[f"{node}.{way}"]
    assert len({ages[frame] for frame in stale}) == 1
    assert not disturbances(course, flight)
    for group, perfect in course.perfect.items():
        assert course.ages(flight)[group][36:] == perfect[36:], group


@pytest.mark.parametrize("node, lag_ms", [("gsc", 0), ("mcs", 6)])
def test_ad1_a_short_stall_of_the_converter_costs_nothing(courses, node,
                                                          lag_ms):
    # The scan goes on after it and ends within its frame.
    course = courses(3, 60)
    flight = course.fly(f"short {node}", [
        f"{400 + 20 * number + lag_ms + 0.1} {node} stall adc {length}"
        for number, length in enumerate((0.001, 0.016, 1, 5, 9))])
    assert (node, "ad_no_scan") not in flight.events
    assert not disturbances(course, flight)


@pytest.mark.parametrize("late_us, frame", [(0, 21), (1, 22)])
@pytest.mark.parametrize("channel, name", [*enumerate(COMMANDS)])
def test_ad1_after_a_stall_the_conversion_is_repeated(
        fly, write, channel, name, late_us, frame):
    """It was under way when the board stood still, and takes 16 us from the
    end of the stall on; each channel is held as the one before it ends."""
    held_us = 400_000 if channel == 0 else 400_500 + 16 * channel
    write("faults.txt", "400.001 gsc stall adc 0.499\n")
    write("sticks.csv", f"time_ms,{name}\n0,77\n"
                        f"{(held_us + late_us) / 1000:.3f},99\n")
    uplink = fly("--seconds", "0.5", "--sticks", "sticks.csv",
                 "--faults", "faults.txt").record[f"gsc.uplink.{name}"]
    assert uplink.index(99) == frame


# --- several processors ----------------------------------------------------

TROUBLE = [
    "300 mcs reset warm", "425.1 gsc reset processor",
    "500 up ber 0.001 300", "600 down ber 0.001 300",
    "900 mcs stall adc 70", "1000 cut 100", "1200 mcs bus_error",
    "1300 mcs rom 7 1", "1500 mcs stall telemetry 30",
    "1600.5 mcs reset telemetry",
]


@pytest.mark.parametrize("schedule", ["report", "fast"])
@pytest.mark.parametrize("faults", [(), TROUBLE], ids=["calm", "trouble"])
def test_krn5_ext4_any_number_of_processors_flies_the_same_flight(
        courses, faults, schedule):
    course = courses(3, 100)
    flights = [course.fly(f"{schedule} {number} processors", faults,
                          "--processors", number, "--schedule", schedule)
               for number in (1, 2, 3, 4)]
    for name in ("record.csv", "wire.csv", "events.jsonl"):
        first, *others = (flight.path(name).read_bytes()
                          for flight in flights)
        assert others == 3 * [first], name
    for flight in flights:
        del flight.summary["speed"]
        assert flight.summary == flights[0].summary
