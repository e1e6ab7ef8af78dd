# SPDX-License-Identifier: Apache-2.0
"""The link with lost or altered characters (SIM-2, LNK-5, LNK-6, LNK-9): no
wrong word ever arrives, old ones are held, and soon after the last fault
everything is as in a flight without faults.

Each frame has words of its own. The words of a node identify their frame; a
mixture of two frames, or anything else, is wrong.
"""

import json
import subprocess
import time
from collections import Counter

import pytest
from conftest import (
    CHARACTER_US,
    COMMANDS,
    EXCHANGE,
    FRAMES_PER_S,
    FRAME_MS,
    PROGRAM,
    SENSORS,
    SERVOS,
    TIME_LIMIT_S,
    columns,
    different_rows,
    fly_in,
    messages,
    script,
    transformed,
)

# When the exchange of a frame begins, in ms.
BEGINS_MS = 4

# From the frame of the last fault on, this many frames may hold old words,
# or have none: after that all is as if nothing had happened.
RECOVERY_FRAMES = 3

# Before the first message everything is as it was at the start.
START_FRAMES = 8

# A faulty exchange may end so late that the aircraft has a newer block to
# send than it had at the usual time. The ground's come at its beginning.
EARLY_FRAMES = {"mcs.uplink": 0, "pwm": 0, "gsc.downlink": 1}

GROUPS = {
    "mcs.uplink": (*COMMANDS, "error"),
    "pwm": SERVOS,
    "gsc.downlink": (*SENSORS, "error"),
}


# The error/status word: words that have just come, and words of before
# (SAF-5).
FRESH, OLD = 0, 1


class Course:
    """Scripts of a number of frames, and their flight without faults."""

    def __init__(self, folder, frames, phase=3):
        self.folder = folder
        self.frames = frames
        self.phase = phase
        sticks = different_rows(frames, 13, seed=7)
        sensors = different_rows(frames, 27, seed=8)
        (folder / "sticks.csv").write_text(script(COMMANDS, sticks, 10))
        (folder / "sensors.csv").write_text(
            script(SENSORS, sensors, 10 + 2 * phase)
        )
        self.origin = {
            "mcs.uplink": {(*row, mark): n for n, row in enumerate(sticks)
                           for mark in (FRESH, OLD)},
            "pwm": {transformed(row): n for n, row in enumerate(sticks)},
            "gsc.downlink": {(*row, mark): n for n, row in enumerate(sensors)
                             for mark in (FRESH, OLD)},
        }
        self.perfect = self.ages(self.fly("perfect"))

    def fly(self, name, faults=None):
        into = self.folder / name
        into.mkdir(exist_ok=True)
        options = ["--sticks", "sticks.csv", "--sensors", "sensors.csv",
                   "--phase", self.phase, "--seconds", self.frames / FRAMES_PER_S]
        if faults:
            (self.folder / f"{name}.txt").write_text("\n".join(faults) + "\n")
            options += ["--faults", f"{name}.txt"]
        return fly_in(self.folder, *options, outputs_in=into)

    def ages(self, flight):
        """For each group and frame, the frame of the words it holds; None
        for words that nobody ever sent."""
        return {
            group: [self.origin[group].get(words)
                    for words in columns(flight, group, names)]
            for group, names in GROUPS.items()
        }


def complaints(course, flight, faulty_frames):
    """All that is wrong with a flight with faults in these frames, as
    text."""
    found = []
    ages = course.ages(flight)
    recovering = {
        frame + after
        for frame in faulty_frames for after in range(RECOVERY_FRAMES)
    }
    for group, perfect in course.perfect.items():
        newest = None
        for frame in range(START_FRAMES, course.frames):
            age = ages[group][frame]
            if age is None:
                found.append(f"{group}, frame {frame}: words nobody sent")
            elif age > perfect[frame] + EARLY_FRAMES[group]:
                found.append(f"{group}, frame {frame}: words of {age}"
                             f" before those of {perfect[frame]}")
            elif newest is not None and age < newest:
                found.append(f"{group}, frame {frame}: words of {age}"
                             f" after those of {newest}")
            elif frame not in recovering and age != perfect[frame]:
                found.append(f"{group}, frame {frame}: words of {age}"
                             f" instead of {perfect[frame]}")
            elif newest is not None and newest < age < perfect[frame]:
                found.append(f"{group}, frame {frame}: words of {age}"
                             f" came fresh, but {perfect[frame]} were due")
            newest = age if age is not None else newest
    return found + wrongly_marked(flight, ages) + miscounts(flight)


def wrongly_marked(flight, ages):
    """Rows whose error word does not say whether words are old (SAF-5)."""
    wrong = []
    for group in ("mcs.uplink", "gsc.downlink"):
        marks = flight.record[f"{group}.error"]
        for frame in range(START_FRAMES, len(marks)):
            came = ages[group][frame] != ages[group][frame - 1]
            if marks[frame] != (FRESH if came else OLD):
                wrong.append(f"{group}, frame {frame}: error word"
                             f" {marks[frame]}, words {ages[group][frame]}"
                             f" after {ages[group][frame - 1]}")
    return wrong


def miscounts(flight):
    """Differences between the counters and the wire."""
    link = flight.summary["link"]
    sent = Counter(message.kind for message in messages(flight.wire))
    wrong = []
    for way in ("uplink", "downlink"):
        if link[f"{way}_sent"] != sent[way]:
            wrong.append(f"{way}: {link[f'{way}_sent']} counted as sent,"
                         f" {sent[way]} on the wire")
        if link[f"{way}_received"] > link[f"{way}_sent"]:
            wrong.append(f"{way}: {link[f'{way}_received']} received of"
                         f" {link[f'{way}_sent']} sent")
    if flight.summary["overruns"]:
        wrong.append(f"{flight.summary['overruns']} overruns")
    return wrong


# --- one character of an exchange ------------------------------------------

# Frames from one fault to the next.
APART = 8

SINGLE = {
    "drop": "drop {n}",
    **{f"flip {mask:x}": f"flip {{n}} {mask:x}" for mask in (
        0x001,      # one bit of the data: a parity error
        0x100,      # the parity bit itself
        0x003, # two bits: only the checksum or the code detects them
        0x181,      # a bit and the parity bit
        0x0FF, 0x1FF,
        # Changes that make one header of another: these look like good ones.
        0x055,      # data up <-> command
        0x0CC,      # data down <-> command
        0x01E,      # good <-> bad
        0x0E1,      # good <-> bad that wants to downlink
        0x066, 0x099, 0x0AA, 0x078, 0x087, 0x033, 0x0B4,
    )},
}


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    places = sum(EXCHANGE.values())
    return Course(tmp_path_factory.mktemp("single"),
                  START_FRAMES + APART * (places + 1))


def each_character(fault):
    """The fault at each character of an exchange, and in which frames."""
    lines, frames = [], []
    frame = START_FRAMES
    for way, count in EXCHANGE.items():
        for place in range(1, count + 1):
            lines.append(f"{FRAME_MS * frame + BEGINS_MS} {way} "
                         + fault.format(n=place))
            frames.append(frame)
            frame += APART
    return lines, frames


@pytest.mark.parametrize("fault", SINGLE.values(), ids=SINGLE.keys())
def test_lnk9_one_faulty_character_anywhere_is_overcome(course, fault,
                                                        request):
    lines, frames = each_character(fault)
    flight = course.fly(request.node.callspec.id, lines)
    wrong = complaints(course, flight, frames)
    assert not wrong, "\n".join(wrong[:20])


NORMAL = ["uplink", "good, wants", "command", "downlink", "good"]
UPLINK_AGAIN = ["uplink", "bad, wants", *NORMAL]
DOWNLINK_AGAIN = [*NORMAL[:4], "bad", "command", "downlink", "good"]

FRAME = 20


def exchange(flight, frame=FRAME):
    """The messages of a frame's exchange."""
    begins = 1000 * (FRAME_MS * frame + BEGINS_MS)
    return [message for message in messages(flight.wire)
            if begins <= message.time_us < begins + 1000 * FRAME_MS]


def cancelling(error):
    """An error in the next character that makes up for this one in the
    checksum."""
    for _ in range(8):
        error = (error >> 1) ^ (0x9C if error & 1 else 0)
    return error


@pytest.mark.parametrize("faults, order", [
    ([], NORMAL),
    # Found by both, by the checksum alone, by the parity alone.
    (["up flip 9 1"], UPLINK_AGAIN),
    (["up flip 9 3"], UPLINK_AGAIN),
    (["up flip 9 100"], UPLINK_AGAIN),
    (["up flip 30 100"], UPLINK_AGAIN),
    ([f"up flip 9 {0x10:x}", f"up flip 10 {cancelling(0x10):x}"],
     UPLINK_AGAIN),
    (["down flip 10 1"], DOWNLINK_AGAIN),
    (["down flip 10 3"], DOWNLINK_AGAIN),
    (["down flip 10 100"], DOWNLINK_AGAIN),
    (["down flip 59 100"], DOWNLINK_AGAIN),
    ([f"down flip 50 {0x75:x}", f"down flip 51 {cancelling(0x75):x}"],
     DOWNLINK_AGAIN),
], ids=lambda value: "; ".join(value))
def test_lnk6_what_comes_bad_is_sent_again_in_the_same_frame(
        course, faults, order):
    lines = [f"{FRAME_MS * FRAME + BEGINS_MS} {fault}" for fault in faults]
    flight = course.fly("again " + "; ".join(faults), lines)
    assert [message.kind for message in exchange(flight)] == order
    assert not complaints(course, flight, [FRAME])
    # Nothing is late for the next frame.
    for group, ages in course.ages(flight).items():
        late = [frame for frame in range(START_FRAMES, course.frames)
                if ages[frame] < course.perfect[group][frame]]
        assert not late, f"{group} is late in frames {late}"
    link = flight.summary["link"]
    assert [link[name] for name in (
        "uplink_bad", "uplink_scrapped", "downlink_bad", "downlink_scrapped",
        "gsc_resets", "mcs_resets")] == [
            order is UPLINK_AGAIN, 0, order is DOWNLINK_AGAIN, 0, 0, 0]


# In characters (docs/link.md). The board's timer runs on its own, so
# a wait is up to one character shorter.
DEAD_SPACE, IDLE_TIME = 20, 24


@pytest.mark.parametrize("fault, after, silence, kind", [
    # Nothing is heard: the dead space, then the idle time.
    ("down drop 1", "uplink", DEAD_SPACE + IDLE_TIME, "uplink"),
    # Something is heard that is no header: the idle time at once. It ends when
    # the aircraft has been silent for this time.
    ("down flip 2 1", "downlink", IDLE_TIME, "command"),
])
def test_lnk9_the_ground_outwaits_the_aircraft(course, fault, after, silence,
                                               kind):
    lines = [f"{FRAME_MS * FRAME + BEGINS_MS} {fault}"]
    flight = course.fly(fault, lines)
    sent = exchange(flight)
    spoke = next(item for item in sent if item.kind == after)
    spoke_until = spoke.time_us + CHARACTER_US * len(spoke.data)
    again = next(item for item in sent if item.direction == "up"
                 and item.time_us > spoke_until)
    assert again.kind == kind
    waited = (again.time_us - spoke_until) / CHARACTER_US
    assert silence - 1 < waited <= silence, waited


def test_lnk9_out_of_step_the_aircraft_listens_to_nothing(fly, write):
    # Data that is full of headers, after one that did not come as one.
    words = [0x44B, 0xB1E, 0x4D2, 0x487, 0x42D]
    write("sticks.csv", script(
        COMMANDS, [[words[n % 5] for n in range(13)]] * 40, 0))
    for fault in ("drop 1", "flip 1 1", "flip 1 3"):
        write("faults.txt", f"{FRAME_MS * FRAME + BEGINS_MS} up {fault}\n")
        flight = fly("--sticks", "sticks.csv", "--faults", "faults.txt",
                     name=fault)
        kinds = [message.kind for message in exchange(flight)]
        assert kinds == ["uplink", *NORMAL], fault


def test_lnk6_a_block_is_scrapped_after_two_bad_transmissions(course):
    # The same character of the block and of its second transmission.
    lines = [f"{FRAME_MS * 20 + BEGINS_MS} up flip {n} 1" for n in (9, 39)]
    flight = course.fly("scrapped", lines)
    assert not complaints(course, flight, [20])
    link = flight.summary["link"]
    assert (link["uplink_bad"], link["uplink_scrapped"]) == (2, 1)
    # The frame's commands are lost, those before are held, the next come.
    perfect = course.perfect["pwm"]
    held = [(frame, age) for frame, age in
            enumerate(course.ages(flight)["pwm"])
            if frame >= START_FRAMES and age != perfect[frame]]
    assert len(held) == 1
    frame, age = held[0]
    assert age == perfect[frame] - 1


# --- the link is cut -------------------------------------------------------

CUTS_MS = (1, 2, 5, 8.74, 10, 20, 40, 100, 333.3, 1000, 10_000)
CUT_AT = 400


@pytest.mark.parametrize("phase", (0, 3, 4, 9))
@pytest.mark.parametrize("length", CUTS_MS)
def test_lnk9_a_cut_link_recovers(tmp_path, length, phase):
    frames = int((CUT_AT + length) / FRAME_MS) + 20
    course = Course(tmp_path, frames, phase)
    offsets = (BEGINS_MS + 1,) if length > 1000 else (0, 4.5, 7, 9, 12.7)
    for offset in offsets:
        begins, ends = CUT_AT + offset, CUT_AT + offset + length
        first, last = int(begins // FRAME_MS), int(ends // FRAME_MS)
        flight = course.fly(f"cut at {offset}", [f"{begins} cut {length}"])
        wrong = complaints(course, flight, range(first, last + 1))
        assert not wrong, f"cut at {offset}: " + "\n".join(wrong[:20])


@pytest.mark.parametrize("phase", range(10))
def test_commands_are_held_while_the_link_is_cut(tmp_path, phase):
    course = Course(tmp_path, 60, phase)
    flight = course.fly("cut", [f"{CUT_AT} cut 500"])
    for group, perfect in course.perfect.items():
        held = course.ages(flight)[group][24:44]
        # The last words before the cut, or those in transit when it began.
        assert len(set(held)) == 1, (group, held)
        assert held[0] in range(perfect[20] - 1, perfect[22] + 1), group
    # While they are held, the error words say so (SAF-5).
    for group in ("mcs.uplink", "gsc.downlink"):
        errors = flight.record[f"{group}.error"]
        assert set(errors[5:20] + errors[46:]) == {FRESH}, group
        assert set(errors[23:45]) == {OLD}, group
    # Scrapped blocks are counted.
    link = flight.summary["link"]
    assert link["uplink_received"] + link["uplink_bad"] < \
        link["uplink_sent"]
    assert link["uplink_scrapped"] > 0


def test_sim2_faults_after_the_end_are_warned_of(urv_sim, write):
    """They were passed over in silence."""
    write("faults.txt", "500 cut 100\n1000 cut 100\n30000 cut 5\n")
    result = urv_sim("fly", "--seconds", "1", "--faults", "faults.txt")
    assert result.returncode == 0
    assert result.stderr == (
        "urv_sim: warning: --faults: 2 of 3 do not begin before the flight"
        " ends, at 1000 ms\n")
    result = urv_sim("fly", "--seconds", "40", "--faults", "faults.txt")
    assert (result.returncode, result.stderr) == (0, "")
    result = urv_sim("fly", "--quiet", "--seconds", "1",
                     "--faults", "faults.txt")
    assert (result.returncode, result.stderr) == (0, "")


def test_sim2_faults_of_characters_that_are_not_sent_are_warned_of(
        urv_sim, write):
    """So were these."""
    write("faults.txt", "0 up drop 3\n500 up flip 100000 1\n"
                        "500 down flip 90000 1\n")
    result = urv_sim("fly", "--seconds", "1", "--faults", "faults.txt")
    assert result.returncode == 0
    assert result.stderr == (
        "urv_sim: warning: --faults: the flight ended before 2 of the"
        " characters to disturb were sent\n")
    result = urv_sim("fly", "--quiet", "--seconds", "1",
                     "--faults", "faults.txt")
    assert (result.returncode, result.stderr) == (0, "")


def frames_so_far(folder):
    """The frames of a flight, by the summary that it has written last."""
    try:
        return json.loads((folder / "summary.json").read_text("utf-8"))[
            "frames"]
    except (OSError, ValueError):
        return 0


def test_sim1_a_killed_simulation_leaves_its_results(tmp_path):
    """kill -9: at most a second of the record is lost, and events and summary
    are there."""
    with subprocess.Popen(
            [PROGRAM, "fly", "--quiet", "--seconds", "60", "--pace",
             "realtime", "--record", "record.csv", "--summary",
             "summary.json", "--events", "events.jsonl"],
            cwd=tmp_path) as running:
        limit = time.monotonic() + TIME_LIMIT_S
        while frames_so_far(tmp_path) < 2 * FRAMES_PER_S:
            assert time.monotonic() < limit and running.poll() is None
            time.sleep(0.05)
        running.kill()
    rows = (tmp_path / "record.csv").read_text("utf-8").splitlines()
    summary = json.loads((tmp_path / "summary.json").read_text("utf-8"))
    assert summary["unfinished"] is True
    # The flight is in both, but for a second; a slow machine flies less.
    assert abs(len(rows) - 1 - summary["frames"]) <= 2 * FRAMES_PER_S
    assert len(rows) > 1
    for line in (tmp_path / "events.jsonl").read_text("utf-8").splitlines():
        assert json.loads(line)["node"] in ("mcs", "gsc")


def test_sim1_a_summary_that_was_written_often_is_whole(fly):
    """The last version is shorter than the one before: it has no
    "unfinished", and nothing of that one is left."""
    flight = fly("--seconds", "3", "--pace", "realtime")
    text = flight.path("summary.json").read_text("utf-8")
    assert text.endswith("\n}\n")
    assert "unfinished" not in text
    assert flight.summary["frames"] == 3 * FRAMES_PER_S
