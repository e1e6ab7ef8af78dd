#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Flies random test cards, valid and not, at random times with random faults,
cut links and switches (FTI-4 to FTI-6).

    .venv/bin/python -B evidence/safety/card_flights.py [--first N] [--flights N]
            [--keep FOLDER]

A flight's number is all that is needed to make it again. The safety monitor
judges each flight. Two more checks know the cards that the flight was given:
the aircraft takes the valid ones only, and no card is longer than its length or
goes on outside its envelope. Exit status: 0 when no flight has a finding.
"""

import argparse
import collections
import csv
import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / each) for each in (
    "ground", "evidence", "evidence/campaign", "evidence/safety")]

import mixes  # noqa: E402
import monitor  # noqa: E402
from urv import cards  # noqa: E402
from whole_numbers import whole  # noqa: E402

PROGRAM = Path(os.environ.get("URV_SIM", ROOT / "bin" / "urv_sim")).resolve()
SECONDS = 10
CARDS_FROM_MS, STARTS_FROM_MS = 2_000, 4_500
BETWEEN_ORDERS_MS = 200
MIDDLE, ON, OFF = 2_048, 4_095, 0
FIELD = 4_095

VERDICTS = ("none", "complete", "switched off", "disconnected", "link lost",
            "stick moved", "sensor invalid", "envelope left",
            "surface failed", "restarted", "not loaded", "not followed",
            "inputs remain")

SLACK_ROWS = monitor.CARD_ROWS
"""A card may run for this number of rows after its envelope was left."""

ALPHA_WORDS = 80
PITCH_WORDS = ROLL_WORDS = 22.75
"""Words in a degree."""


class Flight(NamedTuple):
    number: int
    options: tuple
    files: dict
    blocks: tuple


def of_number(number):
    """A random flight: options, files, and the words of each card's block."""
    chance = random.Random(f"card flight {number}")
    blocks = tuple(some_block(chance) for _ in range(chance.randrange(1, 11)))
    lines = [(CARDS_FROM_MS + BETWEEN_ORDERS_MS * place, words)
             for place, words in enumerate(blocks)]
    # Some come while a card runs.
    late = [(at, some_block(chance)) for at in range(
        STARTS_FROM_MS + 500, SECONDS * 1_000, 1_700)
        if chance.random() < 0.2]
    files = {
        "orders": "".join(
            f"{at} block {cards.KIND:x} {' '.join(map(str, words))}\n"
            for at, words in [*lines, *late]),
        "sticks": sticks(chance), "sensors": sensors(chance)}
    faults = "".join(f"{line}\n" for line in some_faults(chance))
    if faults:
        files["faults"] = faults
    options = ["--seconds", str(SECONDS), "--seed", str(number), "--laws",
               "on", "--phase", str(chance.randrange(10))]
    if chance.random() < 0.25:
        options += ["--schedule", "fast"]
    if chance.random() < 0.25:
        options += ["--lock"]
    if chance.random() < 0.2:
        options += ["--format", "2"]
        files["key"] = mixes.KEY
    return Flight(number, tuple(options), files,
                  (*blocks, *(words for _, words in late)))


def some_block(chance):
    """The words of a card's block after the kind: mostly of a valid card."""
    kind = chance.random()
    if kind < 0.05:
        return tuple(chance.randrange(FIELD + 1) for _ in range(12))
    words = list(some_card(chance).words())
    if kind < 0.15:
        # A value that may be wrong, with the right sum.
        words[chance.randrange(11)] = chance.randrange(FIELD + 1)
        words[11] = sum_of(words)
    elif kind < 0.2:
        words[chance.randrange(12)] ^= 1 << chance.randrange(12)
    return tuple(words)


def sum_of(words):
    return sum((2 * place + 1) * word
               for place, word in enumerate(words[:11])) % (FIELD + 1)


def some_card(chance):
    slot = chance.choice((1, 1, 2, 3, 8))
    kind = chance.choice((*cards.KINDS[1:7], *cards.KINDS[1:7],
                          "empty", "choose"))
    if kind in ("empty", "choose"):
        return cards.Card(slot=slot, kind=kind)
    pairs = [pair for pair in cards.AXES.values() if chance.random() < 0.6]
    surfaces = tuple(each for pair in pairs for each in pair)
    is_single = kind == "multisine" and chance.random() < 0.3
    if is_single or kind != "multisine" and chance.random() < 0.3:
        surfaces = chance.sample(cards.SURFACES, chance.randrange(1, 5))
        surfaces = tuple(sorted(surfaces, key=cards.SURFACES.index))
    first = last = 0
    if kind == "multisine":
        first = chance.randrange(1, 40)
        last = chance.randrange(1, 4) * 16 + chance.randrange(1, 9)
    elif kind == "linear sweep":
        first, last = (chance.randrange(10, 1_001) for _ in range(2))
    elif kind == "exponential sweep":
        first, last = chance.randrange(10, 300), chance.randrange(1, 449)
    surfaces = surfaces or cards.AXES["pitch"]
    place = chance.choice(("servo", "servo", "stick", "command"))
    if place != "servo":
        inputs = [*cards.PLACES[place]]
        surfaces = tuple(each for each in inputs if chance.random() < 0.4) or (
            chance.choice(inputs),)
        is_single = kind == "multisine"
    return cards.Card(
        slot=slot, kind=kind, surfaces=surfaces, place=place,
        is_single=is_single,
        amplitude=chance.choice((1, 50, 300, 800)),
        time=chance.randrange(2, 300 if kind in cards.PULSES else 500),
        first=first, last=last,
        bank=chance.choice((20, 63)), pitch=chance.choice((20, 63)),
        alpha=chance.choice((6, 63)), load=chance.choice((15, 63)),
        slowest=chance.choice((0, 1_500)),
        fastest=chance.choice((2_500, FIELD)),
        lowest=chance.choice((0, 900)))


def sticks(chance):
    """Switch 5 goes on and off; sticks, laws and disconnect now and then."""
    names = ("throttle,switch5,switch7,switch1,switch2,switch3,switch4,roll,"
             "pitch,yaw")
    rows, at = [(0, MIDDLE, *(OFF,) * 6, *(MIDDLE,) * 3)], STARTS_FROM_MS
    while at < SECONDS * 1_000:
        stick = [MIDDLE + chance.choice((0, 0, 0, 0, 150, -199, 202, 900))
                 for _ in range(3)]
        if chance.random() < 0.6:
            stick = [MIDDLE] * 3
        rows.append((at, MIDDLE, chance.choice((ON, ON, OFF)),
                     chance.choice((OFF,) * 7 + (ON,)),
                     chance.choice((OFF, ON)), chance.choice((OFF, ON)),
                     chance.choice((OFF, ON)),
                     chance.choice((OFF, OFF, OFF, ON)), *stick))
        at += chance.randrange(60, 1_800)
    return f"time_ms,{names}\n" + "".join(
        f"{','.join(map(str, row))}\n" for row in rows)


SENSORS = {"roll_attitude": 2_048, "pitch_attitude": 2_048, "alpha": 2_048,
           "vertical_acceleration": 2_298, "airspeed": 2_000,
           "altitude": 1_000}


def sensors(chance):
    """In flight; some leave the envelope, or fail."""
    words = dict(SENSORS)
    rows = [(0, *words.values())]
    at = STARTS_FROM_MS + 500
    while at < SECONDS * 1_000:
        name = chance.choice([*SENSORS])
        if chance.random() < 0.5:
            begin, goal = words[name], (
                4_095 if chance.random() < 0.3 else
                SENSORS[name] + chance.choice((-600, -200, 0, 0, 200, 600)))
            steps = 1 if goal == 4_095 else 20
            for step in range(1, steps + 1):
                words[name] = begin + (goal - begin) * step // steps
                rows.append((at, *words.values()))
                at += 20
        at += chance.randrange(100, 2_000)
    return f"time_ms,{','.join(SENSORS)}\n" + "".join(
        f"{','.join(map(str, row))}\n" for row in rows)


def some_faults(chance):
    """Faults of the kinds of the random mixes, of the console and of surfaces."""
    lines = []
    for _ in range(chance.choice((0, 0, 1, 2, 4))):
        at = chance.uniform(STARTS_FROM_MS, SECONDS * 1_000)
        lines += mixes.fault(chance, at, chance.choice(mixes.NODES))
    for line, share in (
            ("cut {}", 0.2), ("gsc console {}", 0.2),
            ("surface left_elevator stuck 0x5dc", 0.1),
            ("surface right_aileron float", 0.05),
            ("mcs reset warm", 0.1)):
        if chance.random() < share:
            at = chance.randrange(STARTS_FROM_MS, SECONDS * 1_000)
            lines.append(f"{at} " + line.format(chance.randrange(20, 2_000)))
    return lines


def fly(flight, folder):
    """Leaves the flight's files, record and events in the folder."""
    command = [str(PROGRAM), "fly", "--quiet", *flight.options]
    for option, text in flight.files.items():
        path = folder / option
        path.touch(mode=0o600)
        path.write_text(text, encoding="ascii")
        command += [f"--{option}", option]
    return subprocess.run(
        [*command, "--record", "record.csv", "--events", "events.jsonl"],
        cwd=folder, capture_output=True, text=True, check=False)


#  The checks


NO_INPUT = (0, 0b101010, 0b001010)
"""Bits of a card that are none of its inputs, by the place."""


def is_valid(words):
    """The aircraft may take this block: docs/design.md, test cards."""
    if words[11] != sum_of(words):
        return False
    head, bits, amplitude, time, first, last, attitude, airflow, slow, fast = (
        words[:10])
    kind, grouping, slot = head % 16, head // 16 % 16, head // 256
    if kind >= len(cards.KINDS) or not 1 <= slot <= 8:
        return False
    name = cards.KINDS[kind]
    if name in ("empty", "choose"):
        return grouping == 0 and not any(words[1:11])
    moved = [bit for bit in range(6) if bits >> bit & 1]
    pairs = [bits >> bit & 3 for bit in (0, 2, 4)]
    is_sines = name == "multisine"
    signals = len(moved) if grouping else sum(map(bool, pairs))
    harmonic, count = last // 16, last % 16
    return (grouping <= is_sines
            and bits >> cards.PLACE_BITS < len(cards.PLACES) and moved
            and not bits & NO_INPUT[bits >> cards.PLACE_BITS]
            and 1 <= amplitude <= cards.MOST_AMPLITUDE
            and time >= 2
            and (first == last == 0 if name in cards.PULSES
                 else 10 <= first <= 1_000 and 10 <= last <= 1_000
                 if name == "linear sweep"
                 else 10 <= first <= 1_000
                 and 1 <= last <= cards.MOST_OCTAVES
                 if name == "exponential sweep"
                 else 1 <= first <= cards.MOST_BASE and harmonic >= 1
                 and 1 <= count <= cards.MOST_SINES
                 and signals <= cards.MOST_SIGNALS
                 and first * (harmonic + signals * count - 1)
                 <= cards.MOST_FREQUENCY
                 and (grouping == 1 or all(each in (0, 3) for each in pairs)))
            and all(0 < limit for word in (attitude, airflow)
                    for limit in (word % 64, word // 64))
            and slow <= fast)


def length_of(words):
    """The frames of a card."""
    return (words[3] * cards.FRAMES_PER_S // 100
            * cards.PULSES.get(cards.KINDS[words[0] % 16], 1))


def is_outside(words, row):
    """These sensors are beyond a limit of the card."""
    attitude, airflow, slow, fast, low = words[6:11]

    def beyond(limit, column, factor):
        return limit != cards.NO_LIMIT and (
            abs(int(row[f"mcs.downlink.{column}"]) - MIDDLE) > factor * limit)

    return (beyond(attitude % 64, "roll_attitude", ROLL_WORDS)
            or beyond(attitude // 64, "pitch_attitude", PITCH_WORDS)
            or beyond(airflow % 64, "alpha", ALPHA_WORDS)
            or int(row["mcs.downlink.airspeed"]) < slow
            or fast != FIELD and int(row["mcs.downlink.airspeed"]) > fast
            or int(row["mcs.downlink.altitude"]) < low)


#  The places of modes among their names: tables.json.
LATERAL_STICK, LATERAL_COMMAND = (0, 1, 2), (2, 3, 4)
VERTICAL_STICK, VERTICAL_COMMAND = (0, 1, 2), (2, 3, 4)
ALTITUDE, AIRSPEED = 3, 1


def is_followed(words, row):
    """The laws' modes are those in which each input reaches the aircraft."""
    bits = words[1]
    lateral, vertical, power = (
        int(row[f"laws.{axis}"]) for axis in ("lateral", "vertical", "power"))
    needed = {
        "servo": (),
        "stick": ((0, lateral in LATERAL_STICK),
                  (2, vertical in VERTICAL_STICK)),
        "command": ((0, lateral in LATERAL_COMMAND),
                    (2, vertical in VERTICAL_COMMAND),
                    (4, vertical == ALTITUDE), (5, power == AIRSPEED))}
    return all(is_met or not bits >> bit & 1 for bit, is_met in needed[
        [*cards.PLACES][bits >> cards.PLACE_BITS]])


def runs_of(rows):
    """Rows of each run of a card, in order."""
    run = []
    for row in rows:
        if run and (row["laws.card"] != run[-1]["laws.card"]
                    or int(row["laws.card_frame"])
                    < int(run[-1]["laws.card_frame"])):
            yield run
            run = []
        if row["laws.card"] != "0":
            run.append(row)
    if run:
        yield run


class Outcome(NamedTuple):
    findings: list
    valid: int
    blocks: int
    runs: int
    ends: collections.Counter
    rows: int


def judged(flight, folder):
    """The faults found in a flight, and its figures."""
    files = {name: folder / name for name in ("sticks", "sensors", "faults")
             if name in flight.files}
    found = monitor.check(
        folder / "record.csv", **files, lock="--lock" in flight.options,
        schedule="fast" if "fast" in flight.options else "report")
    findings = list(found.violations)
    with (folder / "record.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    valid = [words for words in flight.blocks if is_valid(words)]
    signals = [words for words in valid if words[0] % 16 in range(1, 7)]
    runs = list(runs_of(rows))
    for run in runs:
        slot = int(run[0]["laws.card"])
        own = [words for words in signals if words[0] // 256 == slot]
        first = run[0]["time_ms"]
        where = f"{first}: card {slot}"
        if not own:
            findings.append(f"{where} runs, and no such card is valid")
            continue
        longest = max(map(length_of, own))
        if max(len(run) - 1, int(run[-1]["laws.card_frame"])) >= longest:
            findings.append(f"{where} runs for more than {longest} frames")
        for place in range(len(run) - SLACK_ROWS):
            if all(is_outside(words, row) for words in own
                   for row in run[place:place + SLACK_ROWS + 1]):
                findings.append(f"{where} goes on outside its envelope")
                break
            if not any(is_followed(words, row) for words in own
                       for row in run[place:place + SLACK_ROWS + 1]):
                findings.append(f"{where} goes on, and nothing follows it")
                break
    events = [json.loads(line) for line in (
        folder / "events.jsonl").read_text("utf-8").splitlines()]
    refused = sum(each["count"] for each in events
                  if (each["node"], each["kind"]) == ("mcs", "card_refused"))
    if not flight.files.get("faults") and len(valid) == len(
            flight.blocks) == len(signals) and refused:
        # Without a fault the aircraft refuses no valid card on the ground of
        # its words; switch 5 may be on when the late ones come.
        early = [each for each in events if each["kind"] == "card_refused"
                 and each["first_ms"] < STARTS_FROM_MS]
        if early:
            findings.append("a valid card is refused")
    ends = collections.Counter()
    before = None
    for row in rows:
        now = (row["laws.card"], row["laws.card_ended"],
               row["laws.card_last"])
        if before and before[0] != "0" and now[0] == "0":
            ends[VERDICTS[int(now[1])]] += 1
        before = now
    return Outcome(findings, len(valid), len(flight.blocks), len(runs), ends,
                   len(rows))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--first", type=whole(0), default=0)
    parser.add_argument("--flights", type=whole(1), default=1_000)
    parser.add_argument("--keep", type=Path, help="a folder for the files of"
                        " flights with findings")
    given = parser.parse_args()
    bad = blocks = valid = runs = rows = 0
    ends = collections.Counter()
    for number in range(given.first, given.first + given.flights):
        flight = of_number(number)
        with tempfile.TemporaryDirectory() as folder:
            if given.keep:
                folder = given.keep / str(number)
                folder.mkdir(parents=True, exist_ok=True)
            folder = Path(folder)
            done = fly(flight, folder)
            if done.returncode:
                print(f"flight {number}: {done.stderr.strip()}")
                bad += 1
                continue
            outcome = judged(flight, folder)
        for each in outcome.findings:
            print(f"flight {number}: {each}", flush=True)
        bad += bool(outcome.findings)
        blocks += outcome.blocks
        valid += outcome.valid
        runs += outcome.runs
        rows += outcome.rows
        ends += outcome.ends
    print(f"{given.flights} flights, {rows} rows, {blocks} blocks, {valid}"
          f" valid, {runs} runs, {bad} flights with findings")
    print("ends: " + ", ".join(f"{name} {count}"
                               for name, count in ends.most_common()))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
