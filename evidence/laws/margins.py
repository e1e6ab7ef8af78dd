#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Poles and margins of the control laws' loops (EXT-7).

    evidence/laws/margins.py [--renew]
    evidence/laws/margins.py --model FILE [--renew]

Linear models of the aircraft, at each speed and weight, and the laws with the
gains of URV.Law_Gains: poles of the aircraft alone and with the laws, gain and
phase margin of each loop, with the delay that frames, scan and servos have. Then
a step as bin/urv_sim flies it, whole numbers, limits and all, beside the linear
one. --renew writes docs/evidence/margins.md. It fails when a loop has less
than 6 dB or 45 degrees.

With --model the margins of the laws with an identified model, the file of
`bin/urv identify --model`, are beside those with JSBSim's model at the same
airspeed and weight. --renew writes this table into docs/flight-test.md.
"""

import argparse
import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import identify  # noqa: E402
import law_gains  # noqa: E402
import loops  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "evidence" / "margins.md"
MODEL_PAGE = ROOT / "docs" / "flight-test.md"
BEGIN, END = "<!-- margins.py --model --renew writes this -->", (
    "<!-- margins to here -->")
PROGRAM = Path(os.environ.get("URV_SIM", ROOT / "bin" / "urv_sim"))

SPEEDS = (60, 70, 80, 90)
BALLASTS = (-10, 0, 30)
LEAST_DB, LEAST_DEG = 6.0, 45.0
OMEGA = numpy.geomspace(0.003, numpy.pi / loops.FRAME_S * 0.999, 4000)


class Row(NamedTuple):
    """A loop at a condition."""

    loop: str
    condition: identify.Condition
    margins: loops.Margins


class Result(NamedTuple):
    rows: list
    poles: list
    misfits: list


def loops_of(model, of):
    """Each loop's response by its name."""
    yield from lateral_loops(model.lateral, of)
    yield from longitudinal_loops(model.longitudinal, of)


def lateral_loops(lateral, of):
    for name, law in (("damping", loops.lateral(of, False)),
                      ("attitude", loops.lateral(of, True))):
        yield f"roll, {name}", loops.broken(lateral, law, "roll", OMEGA)
        yield f"yaw damper, roll in {name}", loops.broken(
            lateral, law, "yaw", OMEGA)


def longitudinal_loops(longitudinal, of):
    upward = loops.with_altitude(longitudinal)
    for mode in ("damping", "attitude", "hold"):
        law = loops.longitudinal(of, mode)
        yield f"pitch, {mode}", loops.broken(upward, law, "pitch", OMEGA)
    yield "altitude", loops.broken(
        upward, law, "wanted", OMEGA, own="wanted_pitch")
    yield "airspeed", loops.broken(upward, law, "throttle", OMEGA)


def measured(of):
    """Everything, condition by condition."""
    found = Result([], [], [])
    for speed in SPEEDS:
        for ballast in BALLASTS:
            condition = identify.Condition(speed, ballast)
            print(f"margins: {speed} kt, {condition.weight} lb",
                  file=sys.stderr)
            model, misfit = identify.models(condition)
            found.misfits.append(max(misfit.values()))
            for name, response in loops_of(model, of):
                found.rows.append(Row(
                    name, condition, loops.margins(response, OMEGA)))
            for name, response in loops_of(model, law_gains.gains(table=1)):
                if "damping" not in name:
                    found.rows.append(Row(
                        f"{name}, table 1", condition,
                        loops.margins(response, OMEGA)))
            upward = loops.with_altitude(model.longitudinal)
            found.poles.append((condition, {
                "lateral alone": numpy.log(
                    model.lateral.poles() + 0j) / loops.FRAME_S,
                "lateral, attitude": loops.closed_poles(
                    model.lateral, loops.lateral(of, True)),
                "longitudinal alone": numpy.log(
                    model.longitudinal.poles() + 0j) / loops.FRAME_S,
                "longitudinal, altitude and airspeed": loops.closed_poles(
                    upward, loops.longitudinal(of, "hold"))}))
    return found


# --- fixed point beside the design ------------------------------------------

class Step(NamedTuple):
    """A step of a stick, and what follows it."""

    name: str
    stick: str
    word: int
    column: str
    wanted: float
    slew: float


def steps(of):
    """5 degrees of bank, 2 of pitch, in attitude hold; the reference goes
    there at its own speed."""
    roll = round(5 * 1000 * 256 / (of.Most_Bank // 8))
    pitch = round(2 * 1000 * 128 / (of.Stick_Pitch // 16))
    return (Step("bank", "roll", 2048 + roll, "truth.bank_deg",
                 roll * (of.Most_Bank // 8) // 256 / 1000,
                 of.Bank_Slew / 1000),
            Step("pitch", "pitch", 2048 + pitch, "truth.pitch_deg",
                 pitch * (of.Stick_Pitch // 16) // 128 / 1000,
                 of.Pitch_Slew / 1000))


def fly(step, folder):
    """The step's column over time, in bin/urv_sim; 20 s before, 10 after."""
    def sticks(word):
        return (f"time_ms,throttle,switch2,{step.stick}\n"
                f"0,2048,4095,2048\n20000,2048,4095,{word}\n"
                f"30000,2048,4095,{word}\n")

    (folder / "sticks.csv").write_text(sticks(step.word), encoding="ascii")
    subprocess.run(
        [PROGRAM, "fly", "--plant", "jsbsim", "--laws", "on", "--quiet",
         "--sticks", "sticks.csv", "--record", "record.csv"],
        cwd=folder, check=True, stdin=subprocess.DEVNULL)
    with (folder / "record.csv").open(encoding="ascii", newline="") as lines:
        rows = list(csv.DictReader(lines))
    first = 20_000 // 20
    # In the frame when the servos first have it the wanted angle moves.
    servo = {"roll": "pwm.left_aileron", "pitch": "pwm.left_elevator"}
    was = rows[first - 1][servo[step.stick]]
    begins = next(place for place in range(first, len(rows))
                  if rows[place][servo[step.stick]] != was)
    values = numpy.array([float(row[step.column])
                          for row in rows[begins:begins + 400]])
    return values - float(rows[begins - 1][step.column])


def designed(step, model, of, frames):
    """The same of the linear law and aircraft."""
    if step.stick == "roll":
        aircraft, law = model.lateral, loops.lateral(of, True)
        wanted = law.inputs.index("wanted_bank")
    else:
        aircraft = loops.with_altitude(model.longitudinal)
        law = loops.longitudinal(of, "attitude")
        wanted = law.inputs.index("wanted_pitch")
    K, count = law.system(), aircraft.C.shape[0]
    state, memory = numpy.zeros(aircraft.A.shape[0]), numpy.zeros(len(K.A))
    # The altitude's units do not matter: attitude hold does not look.
    inputs, found, reference = numpy.zeros(len(law.inputs)), [], 0.0
    for _ in range(frames):
        reference = min(reference + step.slew, step.wanted)
        inputs[wanted] = reference
        out = K.C @ memory + K.D @ inputs
        moved = out[:2]
        inputs[:count] = aircraft.C @ state + aircraft.D @ moved
        memory = K.A @ memory + K.B @ inputs
        state = aircraft.A @ state + aircraft.B @ moved
        found.append(inputs[0])
    return numpy.array(found)


def compared(of):
    """For each step: its name and size; the time of nine tenths and the
    overshoot, of flight and design; the largest difference."""
    model, _ = identify.models(identify.Condition(70, 0))
    found = []
    for step in steps(of):
        with tempfile.TemporaryDirectory() as folder:
            real = fly(step, Path(folder))
        design = designed(step, model, of, len(real))

        def figures(values, wanted=step.wanted):
            reached = int(numpy.argmax(values >= 0.9 * wanted))
            return reached * loops.FRAME_S, float(values.max() / wanted - 1)

        found.append((step, figures(real), figures(design),
                      float(numpy.abs(real - design).max())))
    return found


# --- the page ----------------------------------------------------------------

def decibels(value):
    return "none" if numpy.isinf(value) else f"{value:.1f}"


def complaints(result):
    return [f"{row.loop} at {row.condition.speed} kt, {row.condition.weight}"
            f" lb: {row.margins.gain_db:.1f} dB,"
            f" {row.margins.phase_deg:.0f} degrees"
            for row in result.rows
            if row.margins.gain_db < LEAST_DB
            or row.margins.phase_deg < LEAST_DEG]


def table_of_loops(result):
    """The least over all weights and speeds, and where."""
    lines = ["| loop | gain margin, dB | at | phase margin, degrees | at |",
             "|---|---|---|---|---|"]
    for name in dict.fromkeys(row.loop for row in result.rows):
        rows = [row for row in result.rows if row.loop == name]
        gain = min(rows, key=lambda row: row.margins.gain_db)
        phase = min(rows, key=lambda row: row.margins.phase_deg)

        def place(row, value):
            return ("" if numpy.isinf(value) else
                    f"{row.condition.speed} kt, {row.condition.weight} lb")

        lines.append(
            f"| {name} | {decibels(gain.margins.gain_db)}"
            f" | {place(gain, gain.margins.gain_db)}"
            f" | {decibels(phase.margins.phase_deg)}"
            f" | {place(phase, phase.margins.phase_deg)} |")
    return "\n".join(lines)


def table_by_speed(result):
    """The loops with the least margins, at each speed, 200 lb."""
    names = [name for name in dict.fromkeys(row.loop for row in result.rows)]
    lines = ["| loop | " + " | ".join(f"{speed} kt" for speed in SPEEDS)
             + " |", "|---" * (len(SPEEDS) + 1) + "|"]
    for name in names:
        cells = [f"{decibels(row.margins.gain_db)} /"
                 f" {decibels(row.margins.phase_deg)}"
                 for row in result.rows
                 if row.loop == name and row.condition.ballast == 0]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def pole(value):
    if abs(value.imag) < 5e-4:
        return f"{value.real:.3g}"
    return f"{value.real:.3g} ± {value.imag:.3g}i"


def table_of_poles(result):
    """At 200 lb, slower than the frames' own."""
    lines = ["| | " + " | ".join(f"{speed} kt" for speed in SPEEDS) + " |",
             "|---" * (len(SPEEDS) + 1) + "|"]
    alone = [(condition, poles) for condition, poles in result.poles
             if condition.ballast == 0]
    for name in alone[0][1]:
        cells = []
        for _, poles in alone:
            shown = sorted((each for each in poles[name]
                            if each.imag >= 0 and 5e-4 < abs(each) < 60),
                           key=abs)
            cells.append(", ".join(map(pole, shown)))
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def table_of_steps(found):
    lines = ["| step | nine tenths after, s: flown, designed | overshoot, %:"
             " flown, designed | largest difference, degrees |",
             "|---|---|---|---|"]
    for step, real, design, difference in found:
        lines.append(
            f"| {step.wanted:.2f} degrees of {step.name}"
            f" | {real[0]:.2f}, {design[0]:.2f}"
            f" | {100 * real[1]:.0f}, {100 * design[1]:.0f}"
            f" | {difference:.2f} |")
    return "\n".join(lines)


def page(result, flown):
    few = complaints(result)
    return f"""# Margins of the control laws

`make -C evidence margins RENEW=--renew` writes this page. It needs `control`, of
`evidence/laws/requirements.txt`.

Each loop is cut at the law's output to the servo, the altitude loop at its output
to the pitch attitude; the other loops stay closed. The gains are those of
`URV.Law_Gains`. Table 1 is the softer one, which the ground may choose. The page
is of gains and aircraft `{law_gains.mark()}`; a test fails when they differ.

Linear models come from JSBSim (`evidence/laws/identify.py`). The aircraft settles,
and a pair of servos is given a pulse of one frame. The difference that the pulse
makes to the sensors is realised as a state-space model. The model includes the
servos, the engine, the words' hold of 20 ms and the scan 16 ms later. The law
includes the two frames from a scan to the next servo words. Links carry no loop:
the laws are aboard. The models are within {100 * max(result.misfits):.1f} % of
JSBSim's largest response.

## Margins

The least over {", ".join(map(str, SPEEDS))} kt and
{", ".join(str(200 + each) for each in BALLASTS)} lb. At least
{LEAST_DB:.0f} dB and {LEAST_DEG:.0f} degrees are wanted:
{"all loops have them" if not few else "short of it are " + "; ".join(few)}.
A loop that is nowhere above one has no phase margin to name.

{table_of_loops(result)}

At 200 lb, dB / degrees:

{table_by_speed(result)}

## Poles

Poles slower than 60/s, in 1/s, at 200 lb. The laws add the poles of the altitude
and of the integrators.

{table_of_poles(result)}

## Fixed point beside the design

A step of the stick in attitude hold at 70 kt: `bin/urv_sim`, with whole numbers and
all limits, beside the linear law on the linear model.

{table_of_steps(flown)}
"""


# --- an identified model -----------------------------------------------------

def beside(given, of):
    """Each loop's margins with JSBSim's model and with the identified one."""
    true, _ = identify.models(given.condition)
    found = []
    for name, of_axis in (("lateral", lateral_loops),
                          ("longitudinal", longitudinal_loops)):
        own = getattr(given.models, name)
        if own is None:
            continue
        for (loop, one), (_, other) in zip(
                of_axis(getattr(true, name), of), of_axis(own, of),
                strict=True):
            # The identified model has no engine.
            if loop != "airspeed":
                found.append((loop, loops.margins(one, OMEGA),
                              loops.margins(other, OMEGA)))
    return found


def table_beside(given, found):
    speed, weight = given.condition.speed, given.condition.weight
    lines = [f"| loop, at {speed:.1f} kt, {weight} lb | gain margin, dB:"
             " JSBSim | identified | phase margin, degrees: JSBSim |"
             " identified |", "|---|---|---|---|---|"]
    lines += [f"| {loop} | {decibels(true.gain_db)}"
              f" | {decibels(own.gain_db)} | {decibels(true.phase_deg)}"
              f" | {decibels(own.phase_deg)} |"
              for loop, true, own in found]
    return "\n".join(lines)


def compare(path, is_renewed):
    """The table of an identified model."""
    import identified
    given = identified.read(path)
    if given.not_determined:
        print("margins: the flights do not determine"
              f" {', '.join(given.not_determined)}", file=sys.stderr)
    text = table_beside(given, beside(given, law_gains.gains()))
    print(text)
    if is_renewed:
        before, _, rest = MODEL_PAGE.read_text("utf-8").partition(BEGIN)
        _, _, after = rest.partition(END)
        MODEL_PAGE.write_text(
            f"{before}{BEGIN}\n{text}\n{END}{after}", "utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--renew", action="store_true",
                        help="write docs/evidence/margins.md, or the table of"
                        " --model into docs/flight-test.md")
    parser.add_argument("--model", type=Path, metavar="FILE",
                        help="an identified model, to compare")
    chosen = parser.parse_args()
    if chosen.model:
        compare(chosen.model, chosen.renew)
        return
    of = law_gains.gains()
    result = measured(of)
    text = page(result, compared(of))
    print(text)
    if chosen.renew:
        PAGE.write_text(text, encoding="utf-8")
    few = complaints(result)
    if few:
        sys.exit("margins: too little: " + "; ".join(few))


if __name__ == "__main__":
    main()
