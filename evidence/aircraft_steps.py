#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""SIM-3: which step of JSBSim's the aircraft needs.

    evidence/aircraft_steps.py            prints the table
    evidence/aircraft_steps.py --renew    and writes it into docs/aircraft.md

The same 16 s with servos moving at once are flown with steps of 1 to 10 ms and
of half a millisecond. The table has the largest
difference of the sensors' readings, in last bits of the converter's word.
"""

import csv
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "sim" / "jsbsim"))

import plant  # noqa: E402

PAGE = ROOT / "docs" / "aircraft.md"
HEAD = "| sensor |"

TICK_US = 500
FRAME = 20_000 // TICK_US
STEPS_US = (1000, 2000, 4000, 5000, 10_000)

# Pairs of servos that move in turn, with their travel: out, back beyond the
# centre, and to rest, with the frames of each.
PULSES = ((("left_aileron", "right_aileron"), 6.0),
          (("left_elevator", "right_elevator"), 3.0),
          (("left_rudder", "right_rudder"), 5.0),
          (("throttle", ), 20.0),
          (("left_flap_1", "right_flap_1"), 5.0))
OUT, BACK, TURN = 8, 16, 40
FRAMES = 800

TRIM = dict.fromkeys(plant.SERVOS, 0.0) | {"throttle": 50.0}

SHOWN = ("left_aileron", "left_elevator", "roll_rate", "pitch_rate",
         "roll_attitude", "pitch_attitude", "vertical_acceleration", "rpm",
         "airspeed", "altitude")


def last_bits():
    """The last bit of each sensor's word, in its unit."""
    text = subprocess.run([ROOT / "bin" / "urv_sim", "items"], check=True,
                          capture_output=True, text=True).stdout
    return {row["name"]: float(row["per_word"])
            for row in csv.DictReader(text.splitlines())
            if row["buffer"] == "downlink" and row["name"] in plant.SENSORS}


def commands(frame):
    names, size = PULSES[frame // TURN % len(PULSES)]
    place = frame % TURN
    moved = size if place < OUT else -size if place < BACK else 0.0
    return TRIM | {name: TRIM[name] + moved for name in names}


def flown(step_us):
    """The sensors, frame by frame."""
    plant.LONGEST_STEP_US = step_us
    times = plant.Times(tick=TICK_US, frame=FRAME, scan=FRAME, shown=FRAME)
    assert times.step * TICK_US == step_us
    aircraft = plant.Aircraft(
        [(name, unit) for name, (unit, _) in plant.SERVOS.items()],
        [(name, plant.SENSORS[name][0]) for name in SHOWN], (), (), times)
    return [aircraft.fly(list(commands(frame).values()))[0]
            for frame in range(FRAMES)]


def apart(rows, others):
    """The most that each sensor's readings are apart, in last bits."""
    bits = last_bits()
    return [max(abs(row[place] - other[place])
                for row, other in zip(rows, others)) / bits[name]
            for place, name in enumerate(SHOWN)]


def table():
    best = flown(TICK_US)
    found = {step: apart(flown(step), best) for step in STEPS_US}
    rows = [HEAD + " " + " | ".join(f"{step // 1000} ms" for step in STEPS_US)
            + " |", "|---" * (len(STEPS_US) + 1) + "|"]
    rows += [f"| {name} | " + " | ".join(
        f"{found[step][place]:.1f}" for step in STEPS_US) + " |"
        for place, name in enumerate(SHOWN)]
    return "\n".join(rows) + "\n"


def main(arguments):
    text = table()
    print(text, end="")
    if arguments == ["--renew"]:
        before, _, rest = PAGE.read_text("utf-8").partition(HEAD)
        after = rest.partition("\n\n")[2]
        PAGE.write_text(f"{before}{text}\n{after}", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
