#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the latency from stick to servo and from sensor to the ground's CORE
with frames in step (FRM-5, FRM-6), and counts missing downlinks.

    evidence/in_step.py                         every phase, drifts from -200
                                               to 200 ppm, on 1 and 2 processors
    evidence/in_step.py --frames 100000         as long for the downlinks
    evidence/in_step.py --schedule report

It flies bin/urv_sim --lock, prints what was measured beside the bounds of
docs/design.md, and fails where one is exceeded.
"""

import argparse
import csv
import json
import random
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

from whole_numbers import whole

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = ROOT / "bin" / "urv_sim"

FRAME_MS = 20
# By when the frames are in step, whatever the phase.
IN_STEP_MS = 20_000

# From the beginning of a scan to the servo, and to the ground's CORE, at most.
BOUNDS_MS = {"report": {"servo": 35.475, "core": 59.428},
             "fast": {"servo": 7.987, "core": 9.892}}
# For the fast schedule, from the change.
MEDIAN_MS = 20
# When in the ground's frame CORE has what TELIN took.
CORE_MS = {"report": 8, "fast": 10}

DRIFTS = (-200, -100, -37, 0, 37, 100, 200)
# The first to be sampled in a scan, so the oldest when it arrives.
SENSOR = "right_flap_1"


class Measured(NamedTuple):
    since_ms: float
    servo_ms: list
    core_ms: list
    left_out: int


def changes(random_, count):
    """Times in us, so far apart that each has arrived before the next. One
    comes in each so-maniest part of a frame, so that how long they wait for a
    scan is spread evenly."""
    parts = [(part + random_.random()) / count for part in range(count)]
    random_.shuffle(parts)
    for number, part in enumerate(parts, 1):
        yield IN_STEP_MS * 1000 + number * 140_000 + int(part * 20_000)


def script(path, column, times):
    """Each change has a word of its own until 2,000 are through."""
    path.write_text(f"time_ms,{column}\n" + "".join(
        f"{time / 1000:.3f},{1_000 + place % 2_000}\n"
        for place, time in enumerate(times)), encoding="utf-8")


def core_latencies(record, times):
    """Latency of sensors to the ground's CORE, in ms, from the rows that show
    them first."""
    with record.open(encoding="utf-8") as file:
        rows = [(int(row["time_ms"]), int(row[f"gsc.downlink.{SENSOR}"]))
                for row in csv.DictReader(file)]
    place, found = 0, []
    for number, time in enumerate(times):
        word = 1_000 + number % 2_000
        while rows[place][0] * 1000 < time or rows[place][1] != word:
            place += 1
        found.append((rows[place][0], time))
    return found


def fly(phase, drift, schedule, processors, changed=300, program=PROGRAM,
        options=()):
    """A flight in step; the sensors change while the sticks do."""
    random_ = random.Random(f"{phase} {drift}")
    sticks, sensors = (list(changes(random_, changed)) for _ in range(2))
    seconds = max(sticks[-1], sensors[-1]) / 1e6 + 0.5
    options = [*options, "--lock", f"--drift={drift}", "--schedule", schedule,
               "--phase", str(phase), "--processors", str(processors)]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder)
        script(path / "sticks.csv", "roll", sticks)
        script(path / "sensors.csv", SENSOR, sensors)
        summary = summary_of(
            program, *options, "--seconds", f"{seconds:.6f}",
            "--sticks", path / "sticks.csv", "--sensors",
            path / "sensors.csv", "--record", path / "record.csv")
        core = core_latencies(path / "record.csv", sensors)
    latency = summary["latency_ms"]
    assert (latency["measured"], latency["expired"]) == (changed, 0), latency
    after = FRAME_MS - CORE_MS[schedule]
    return Measured(
        summary["lock"]["in_step_since_s"] * 1000,
        [latency[name] for name in ("min", "median", "max")],
        sorted(row - after - time / 1000 for row, time in core),
        left_out_in_step(summary, program, *options))


def summary_of(program, *options):
    return json.loads(subprocess.run(
        [program, "fly", *options, "--summary", "-", "--quiet"], check=True,
        capture_output=True).stdout)


def left_out(summary):
    """Frames without a downlink; the first two have none by design."""
    return summary["frames"] - summary["link"]["downlink_received"]


def left_out_in_step(summary, program, *options):
    """Besides those of the first two seconds, when it is not in step yet."""
    return left_out(summary) - left_out(
        summary_of(program, *options, "--seconds", "2"))


def fly_long(phase, drift, schedule, frames, program=PROGRAM):
    options = ["--lock", f"--drift={drift}", "--schedule", schedule,
               "--phase", str(phase)]
    summary = summary_of(
        program, *options, "--seconds", str(frames * FRAME_MS / 1000))
    return left_out_in_step(summary, program, *options)


def wrongs(found, schedule):
    """Values above their bound."""
    bounds = BOUNDS_MS[schedule]
    if found.since_ms > IN_STEP_MS:
        yield f"in step since {found.since_ms / 1000} s"
    for name, worst in (("servo", found.servo_ms[-1]),
                        ("core", found.core_ms[-1])):
        if worst > bounds[name] + FRAME_MS:
            yield f"{name} after {worst:.3f} ms"
    if schedule == "fast":
        for name, times in (("servo", [found.servo_ms[1]]),
                            ("core", found.core_ms)):
            if times[len(times) // 2] > MEDIAN_MS:
                yield f"{name} median {times[len(times) // 2]} ms"
    if found.left_out:
        yield f"{found.left_out} downlinks left out"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--schedule", choices=sorted(BOUNDS_MS),
                        default="fast")
    parser.add_argument("--frames", type=whole(1),
                        help="of a longer flight for each drift, too")
    given = parser.parse_args()
    failed = False
    print("phase drift processors | servo least median most"
          " | CORE least median most | in step since, left out")
    for drift in DRIFTS:
        for phase in range(10):
            processors = 1 + (phase + drift) % 2
            found = fly(phase, drift, given.schedule, processors)
            core = found.core_ms
            wrong = list(wrongs(found, given.schedule))
            failed = failed or bool(wrong)
            print(f"{phase:5} {drift:5} {processors:10} | "
                  + " ".join(f"{time:7.3f}" for time in found.servo_ms)
                  + " | " + " ".join(f"{time:7.3f}" for time in (
                      core[0], core[len(core) // 2], core[-1]))
                  + f" | {found.since_ms / 1000:.2f} s {found.left_out}"
                  + "".join(f"; WRONG: {one}" for one in wrong), flush=True)
    for drift in DRIFTS if given.frames else ():
        missed = fly_long(drift % 10, drift, given.schedule, given.frames)
        failed = failed or missed > 0
        print(f"{given.frames} frames, drift {drift}: {missed} without a"
              " downlink", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
