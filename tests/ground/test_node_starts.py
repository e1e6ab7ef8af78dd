# SPDX-License-Identifier: Apache-2.0
"""GND-45, GND-46: every start of a node is found, errors that repeat are
reported less and less often, and frames have an order that no clock spoils."""

import random

import pytest

import conftest  # noqa: F401 - finds the packages
from fake_node import NO_LOG, laws_row
from urv import items, packets, view
from urv.packets import (
    ConsoleState, FramePacket, LinkState, LogRow, Pilot)
from urv.repeats import LONGEST_S, Repeats
from urv.runs import ALIVE_S, SILENT_S, STRAYS, Runs
from urv.starts import COLD, ROUND, Flying, Start, Starts

FLIES = {"gsc.downlink.airspeed": 70, "gsc.downlink.altitude": 1000}


def log(**rows):
    """A log of those rows: count, first frame, last frame."""
    made = list(NO_LOG)
    for kind, row in rows.items():
        made[packets.KINDS.index(kind)] = LogRow(*row, 0)
    return tuple(made)


def frame_of(sequence, mcs=NO_LOG, gsc=NO_LOG, run=1, values=FLIES, **more):
    words = tuple(
        items.COLUMNS[name].word(values[name]) if name in values
        else items.COLUMNS[name].zero_word or 0 for name in packets.COLUMNS)
    return FramePacket(**{
        "run": run, "sequence": sequence, "time_us": sequence * 20_000,
        "downlink_age": 0, "console_state": ConsoleState.NONE,
        "link_state": LinkState.HEARD, "console_sequence": 0,
        "counts": (0,) * len(packets.LINK_COUNTS), "words": words,
        "logs": (gsc, mcs), "status": (0,) * len(packets.STATUS),
        "pilot": Pilot.NONE, **more})


class Clock:
    def __init__(self):
        self.now = 100.0

    def __call__(self):
        return self.now


# Starts

LATER = {"no_input": (4, 100, 130)}
RESTARTED = {"processor_restart": (1, 300, 300)}


@pytest.mark.parametrize("before, after, found", [
    # A restart, and two of them between two looks.
    ({}, RESTARTED, [("processor_restart", 1)]),
    (RESTARTED, {"processor_restart": (3, 300, 900)},
     [("processor_restart", 2)]),
    ({}, {"warm_reset": (2, 300, 310)}, [("warm_reset", 2)]),
    # A count at its last value: the frame number decides.
    ({"warm_reset": (2**31 - 1, 5, 70)}, {"warm_reset": (2**31 - 1, 5, 90)},
     [("warm_reset", 1)]),
    # A cold start clears the log, and the same restart comes again.
    (RESTARTED, {"processor_restart": (1, 80, 80)},
     [(COLD, 1), ("processor_restart", 1)]),
    (RESTARTED, {"processor_restart": (1, 450, 450)},
     [(COLD, 1), ("processor_restart", 1)]),
    # A restart that brings the count to more than it was.
    (RESTARTED, {"processor_restart": (5, 20, 90)},
     [(COLD, 1), ("processor_restart", 5)]),
    # Another kind shows it: fewer, earlier, or another first frame.
    (LATER, {"no_input": (3, 100, 130)}, [(COLD, 1)]),
    (LATER, {"no_input": (5, 100, 120)}, [(COLD, 1)]),
    (LATER, {"no_input": (9, 2, 900)}, [(COLD, 1)]),
    # No start.
    (LATER, {"no_input": (9, 100, 400)}, []),
    (LATER, LATER, []),
])
def test_gnd45_a_start_is_found_by_counts_and_frame_numbers(
        before, after, found):
    starts = Starts()
    assert starts.look(frame_of(0, log(**before))) == []
    assert [(each.kind, each.count) for each
            in starts.look(frame_of(1, log(**before | after)))] == found
    assert starts.look(frame_of(2, log(**before | after))) == []


def test_gnd45_a_cold_start_is_found_once_whatever_rows_come_after():
    """Rows of the life before stay until they come again."""
    rows = {"no_input": (4, 100, 130), "link_reset": (7, 50, 800),
            "processor_restart": (2, 60, 300)}
    again = {"no_input": (1, 3, 3), "link_reset": (8, 4, 9),
             "processor_restart": (1, 200, 200)}
    starts, found = Starts(), []
    starts.look(frame_of(0, log(**rows)))
    for sequence, kind in enumerate(again, 1):
        rows[kind] = again[kind]
        found += starts.look(frame_of(sequence, log(**rows)))
    assert found == [Start("mcs", COLD),
                     Start("mcs", "processor_restart", 1, 200)]
    # And the next one.
    rows["link_reset"] = (1, 2, 2)
    assert starts.look(frame_of(9, log(**rows))) == [Start("mcs", COLD)]


def test_gnd45_an_old_kind_that_is_new_again_means_a_cold_start():
    """The aircraft's frame is known: what is new cannot be older by far."""
    starts, known = Starts(), {"no_input": (1, 1000, 1000)}
    for sequence in range(ROUND + 1):
        assert starts.look(frame_of(sequence, log(**known))) == []
    assert starts.look(frame_of(
        ROUND + 1, log(**known, link_reset=(1, 12, 12)))) == [
            Start("mcs", COLD)]


def test_gnd45_what_happened_while_the_link_was_lost_is_no_start():
    starts, known = Starts(), {"no_input": (1, 1000, 1000)}
    for sequence in range(ROUND + 1):
        starts.look(frame_of(sequence, log(**known)))
    for sequence in range(ROUND + 1, 5 * ROUND):
        starts.look(frame_of(sequence, log(**known), downlink_age=9))
    assert starts.look(frame_of(
        5 * ROUND, log(**known, link_reset=(900, 1700, 3900)))) == []


def test_gnd45_a_ground_that_starts_again_is_found_and_hides_no_other():
    starts = Starts()
    mcs = log(**RESTARTED)
    assert starts.look(frame_of(900, mcs, run=7)) == []
    assert starts.look(frame_of(0, run=3)) == [Start("gsc", COLD)]
    # The aircraft's rows come down once more: nothing has happened there.
    assert starts.look(frame_of(9, mcs, run=3)) == []
    assert starts.look(frame_of(10, mcs, run=3,
                                gsc=log(warm_reset=(1, 9, 9)))) == [
        Start("gsc", "warm_reset", 1, 9)]


def test_gnd45_starts_by_chance_are_all_found():
    """An aircraft that restarts at random, seen through rows that come round
    one by one. Each cold start is found once, each restart is counted."""
    chance = random.Random(45)
    for _ in range(50):
        rows, shown, starts = {}, {}, Starts()
        told = {COLD: 0, "warm_reset": 0, "processor_restart": 0}
        made = dict(told)
        at, sequence = 0, 0
        starts.look(frame_of(0))
        for _ in range(40):
            at += chance.randrange(50, 400)
            kind = chance.choice(("no_input", "link_reset", "warm_reset",
                                  "processor_restart", COLD))
            if kind == COLD:
                made[COLD] += 1
                # The effects of a start, in frames of its own.
                at = 10 * made[COLD] + chance.randrange(10)
                rows = {"telin_no_block": (1, at, at)}
            else:
                count, first, _ = rows.get(kind, (0, at, at))
                rows[kind] = (count + 1, first, at)
                made[kind] = made.get(kind, 0) + 1
            for each in rows:
                shown[each] = rows[each]
                sequence += 15
                for found in starts.look(frame_of(sequence, log(**shown))):
                    told[found.kind] += found.count
        assert all(told[kind] == made[kind] for kind in told
                   if kind != COLD)
        # The first one has nothing to differ from.
        assert made[COLD] - 1 <= told[COLD] <= made[COLD]


def aged(sequence, age, rows=NO_LOG, **more):
    """With the laws' row, in which the aircraft reports its age in frames."""
    return frame_of(sequence, (*rows[:-1], laws_row(
        0x1000, 0, 0, 0, 0, age // 16 % 65536)), **more)


def test_gnd45_a_cold_start_without_a_trace_is_found_by_the_age():
    """Also after a count of the age that has begun again."""
    starts, at = Starts(), 16 * 65530
    for sequence in range(0, 400, 10):
        assert starts.look(aged(sequence, at + sequence)) == []
    assert starts.look(aged(1200, 32)) == [Start("mcs", COLD)]
    assert starts.look(aged(1210, 42)) == []
    # With rows that show it, too, it is one start: whichever comes first.
    rows = log(no_input=(4, 900, 930))
    assert starts.look(aged(2700, 1532, rows)) == []
    again = log(no_input=(1, 3, 3))
    assert starts.look(aged(2710, 1532, again)) == [Start("mcs", COLD)]
    assert starts.look(aged(2720, 32, again)) == []
    assert starts.look(aged(5720, 3032, again)) == []
    assert starts.look(aged(5730, 16, again)) == [Start("mcs", COLD)]
    assert starts.look(aged(5740, 32, log(no_input=(2, 1, 2)))) == []
    assert starts.look(aged(5900, 192, log(no_input=(9, 1, 11)))) == []


def test_gnd45_an_age_that_waits_for_the_link_is_no_start():
    starts = Starts()
    assert starts.look(aged(0, 5000)) == []
    for sequence in range(1, 3000):
        assert starts.look(aged(sequence, 5000, downlink_age=9)) == []
    # The row of before, then one that was 2 s on its way.
    assert starts.look(aged(3000, 5000)) == []
    assert starts.look(aged(3100, 8000)) == []


@pytest.mark.parametrize("values, level, text", [
    (FLIES, "warning", "it has started again in flight"),
    ({"gsc.downlink.airspeed": 0, "gsc.downlink.altitude": 0}, "caution",
     "it has started again")])
def test_gnd45_a_cold_start_in_flight_is_a_warning(values, level, text):
    seen = view.View(now=Clock())
    seen.datagram(frame_of(0, log(**LATER), values=values).encode())
    seen.datagram(frame_of(1, log(no_input=(1, 2, 2)), values=values)
                  .encode())
    [alert] = [each for each in seen.alerts.shown()
               if each["name"] == "COLD START MCS"]
    assert (alert["level"], alert["text"]) == (level, text)


def test_gnd26_a_station_that_starts_before_its_node_has_no_alert():
    """Each flight of make ground began with the warning NO FRAMES."""
    clock = Clock()
    seen = view.View(now=clock)
    for waited, is_alert in ((0.6, False), (9.9, False), (10.0, True)):
        clock.now = 100.0 + waited
        seen.look(clock.now)
        assert seen.alerts.active("silent") == is_alert, waited
    seen = view.View(now=clock)
    seen.datagram(frame_of(0).encode())
    clock.now += 0.6
    seen.look(clock.now)
    assert seen.alerts.active("silent")


def test_gnd45_what_is_not_known_of_flying_is_as_it_was():
    flying = Flying()
    assert flying.look(frame_of(0))
    slow = {"gsc.downlink.airspeed": 0, "gsc.downlink.altitude": 0}
    assert flying.look(frame_of(1, values=slow, downlink_age=1))
    assert not flying.look(frame_of(2, values=slow))


# Repeats

def test_gnd45_each_kind_is_reported_once_a_second_at_most():
    repeats, told = Repeats(), []
    for frame in range(50 * 100):
        new = repeats.take(("gsc", "no_input"), frame + 1, frame / 50)
        if new is not None:
            told.append((frame / 50, new))
    times = [at for at, _ in told]
    assert times[:5] == [0.0, 1.0, 3.0, 7.0, 15.0]
    assert max(b - a for a, b in zip(times, times[1:], strict=False)
               ) <= LONGEST_S
    assert sum(new for _, new in told) == round(times[-1] * 50) + 1
    # Another kind is not held up, and a quiet one begins again.
    assert repeats.take(("mcs", "no_input"), 1, 100.0) == 1
    assert repeats.take(("gsc", "no_input"), 6000, 300.0) > 0
    assert repeats.take(("gsc", "no_input"), 6001, 301.0) == 1


def test_gnd45_scans_that_a_lost_console_leaves_out_are_no_error():
    clock = Clock()
    seen = view.View(now=clock)
    for sequence in range(200):
        clock.now += 0.02
        held = 50 <= sequence < 150
        count = max(0, min(sequence, 150) - 50)
        seen.datagram(frame_of(
            sequence, gsc=log(ad_no_scan=(count, 50, sequence))
            if count else NO_LOG,
            console_state=ConsoleState.HELD if held or sequence == 150
            else ConsoleState.LIVE).encode())
    assert not [line.text for line in seen.log if "ad_no_scan" in line.text]
    seen.datagram(frame_of(
        200, gsc=log(ad_no_scan=(101, 50, 200))).encode())
    assert [line.text for line in seen.log][-1].startswith("gsc ad_no_scan")


def test_gnd45_a_lost_link_is_not_buried_by_what_it_causes():
    clock = Clock()
    seen = view.View(now=clock)
    for sequence in range(50 * 60):
        clock.now += 0.02
        lost = sequence > 100
        count = max(0, sequence - 50)
        seen.datagram(frame_of(
            sequence, gsc=log(
                no_input=(count, 50, sequence),
                telin_no_block=(count, 50, sequence),
                core_no_downlink=(count, 50, sequence),
                link_reset=(count, 50, sequence)) if count else NO_LOG,
            downlink_age=count,
            link_state=LinkState.LOST if lost else LinkState.HEARD).encode())
    texts = [line.text for line in seen.log]
    at = next(place for place, text in enumerate(texts)
              if "LINK LOST" in text)
    assert not [text for text in texts[at:] if text.startswith("gsc ")]
    assert len([text for text in texts if text.startswith("gsc ")]) <= 8
    seen.datagram(frame_of(3000, gsc=log(no_input=(2950, 50, 2999))).encode())
    assert [line.text for line in seen.log][-1].endswith("left out")


# Runs

def test_gnd46_a_ground_whose_clock_is_earlier_is_taken():
    clock = Clock()
    seen = view.View(now=clock)
    hour_us = 3_600_000_000
    assert seen.datagram(frame_of(5000, run=9, time_us=2 * hour_us).encode())
    assert seen.datagram(frame_of(0, run=4, time_us=hour_us).encode())
    assert seen.datagram(frame_of(1, run=4, time_us=hour_us + 9).encode())
    assert seen.frame.sequence == 1
    assert "COLD START GSC" in {
        alert["name"] for alert in seen.alerts.shown()}


def test_gnd46_within_a_run_the_sequence_number_is_the_order():
    """Whatever the clock does meanwhile."""
    seen = view.View(now=Clock())
    for sequence, time_us, taken in (
            (1, 500, True), (2, 100, True), (2, 900, False), (1, 999, False),
            (4, 50, True)):
        assert seen.datagram(frame_of(
            sequence, time_us=time_us).encode()) == taken
    assert (seen.missing, seen.late) == (1, 2)


def test_gnd46_late_packets_of_a_former_run_change_nothing():
    """D-37: it is taken up again when nothing else has come for a while."""
    runs = Runs()

    def take(run, at_s, now=None):
        """A packet that the run makes at that time."""
        return runs.take(frame_of(round(at_s / packets.FRAME_S), run=run),
                         at_s if now is None else now)
    assert take(1, 2.0) and take(1, 2.02)
    # Another ground: taken when the first has fallen silent.
    assert not take(2, 2.04)
    assert take(2, 2.04 + ALIVE_S) and runs.began
    assert not take(1, 2.04, 2.2)
    assert take(2, 2.22) and not runs.has_rival(2.22)
    # Both go on to send: the present one is shown, the other reported.
    for step in range(STRAYS):
        now = 2.22 + (step + 1) * packets.FRAME_S
        assert not take(1, now)
        assert take(2, now) and not runs.began
    assert runs.has_rival(now)
    # It is taken up when the present one has ended.
    assert not take(1, now + SILENT_S - 0.1)
    assert take(1, now + SILENT_S + 0.02)
    assert runs.began and not runs.has_rival(now + SILENT_S)
    assert not take(2, now + 1.0)


# A link whose blocks are refused, sensors that are old

def test_gnd47_a_link_that_carries_refused_blocks_alone_says_so():
    clock = Clock()
    seen = view.View(now=clock)
    counts = list((0,) * len(packets.LINK_COUNTS))
    for sequence in range(100):
        clock.now += 0.02
        counts[packets.LINK_COUNTS.index("downlink_received")] = sequence
        rows = list(NO_LOG)
        if sequence:
            rows[packets.KINDS.index("block_refused")] = LogRow(
                sequence, 1, sequence, 2)
        seen.datagram(frame_of(
            sequence, gsc=tuple(rows), counts=tuple(counts),
            downlink_age=packets.NEVER,
            link_state=LinkState.NEVER_HEARD).encode())
    shown = seen.shown()
    assert (shown["link"], shown["refused"], shown["refusing"]) == (
        "never_heard", 99, True)
    [alert] = [each for each in seen.alerts.shown()
               if each["name"] == "LINK REFUSED"]
    assert alert["level"] == "warning" and "another key" in alert["text"]


@pytest.mark.parametrize("answers, name", [
    (True, "SENSORS OLD"), (False, "LINK LOST")])
def test_gnd47_old_sensors_are_no_lost_link(answers, name):
    """Either is reported within a second (GND-25)."""
    clock = Clock()
    seen = view.View(now=clock)
    counts = [0] * len(packets.LINK_COUNTS)
    for sequence in range(100):
        clock.now += 0.02
        counts[packets.LINK_COUNTS.index("downlink_received")] = (
            sequence if answers or sequence < 20 else 20)
        seen.datagram(frame_of(
            sequence, counts=tuple(counts),
            downlink_age=max(0, sequence - 20)).encode())
        active = {each["name"] for each in seen.alerts.shown()
                  if each["active"]}
        old_s = (sequence - 20) * packets.FRAME_S
        assert name not in active or old_s >= view.LOST_S - 1e-6, "too early"
        assert name in active or old_s < 1.0, "too late"
    assert not active & ({"SENSORS OLD", "LINK LOST"} - {name})
