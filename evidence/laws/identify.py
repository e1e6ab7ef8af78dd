# SPDX-License-Identifier: Apache-2.0
"""Linear models of the aircraft of sim/jsbsim, from its answers to small pulses.

An aircraft settles in level flight; the same flight is flown with and without a
pulse of one frame on a pair of servos. The difference is the impulse response
from a servo's command, held for a frame of 20 ms, to what the sensors measure
16 ms later: servos, engine and sensors' time are in it. From it a state-space
model is realised (eigensystem realisation).
"""

import sys
from pathlib import Path
from typing import NamedTuple

import control
import numpy

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "sim" / "jsbsim"))

import plant  # noqa: E402
from law_gains import FRAME_S  # noqa: E402

TIMES = plant.Times(tick=2000, frame=10, scan=8, shown=10)
SERVOS = [(name, unit) for name, (unit, _) in plant.SERVOS.items()]
NAMES = [name for name, _ in SERVOS]

# Servos that move together, with their pulse of one frame in degrees or per
# cent.
INPUTS = {
    "roll": (("left_aileron", "right_aileron"), 4.0),
    "pitch": (("left_elevator", "right_elevator"), 4.0),
    "yaw": (("left_rudder", "right_rudder"), 4.0),
    "throttle": (("throttle",), 10.0),
}

# Sensors of each model, and how many states it is given: those of the
# airframe, of the servos and of the engine.
LATERAL = ("roll_attitude", "roll_rate", "yaw_rate")
LONGITUDINAL = ("pitch_attitude", "pitch_rate", "airspeed", "climb")
SENSORS = ("roll_attitude", "roll_rate", "yaw_rate", "pitch_attitude",
           "pitch_rate", "airspeed", "altitude")
SECONDS = 60


class Condition(NamedTuple):
    """A flight condition: knots, and pounds more or less."""

    speed: float
    ballast: float

    @property
    def weight(self):
        return 200 + self.ballast


class Models(NamedTuple):
    """From roll, yaw to LATERAL; from pitch, throttle to LONGITUDINAL."""

    lateral: control.StateSpace
    longitudinal: control.StateSpace


def flown(condition, pulse=None):
    """The sensors over time, one row a frame."""
    plant.START_SPEED_KT = condition.speed
    conditions = ({"ballast": (condition.ballast, 0.0)}
                  if condition.ballast else {})
    aircraft = plant.Aircraft(
        SERVOS, [(name, plant.SENSORS[name][0]) for name in SENSORS], (), (),
        TIMES, conditions)
    trim = [aircraft.fdm[plant.SERVOS[name][1]] for name in NAMES]
    moved = list(trim)
    if pulse:
        names, size = INPUTS[pulse]
        for name in names:
            moved[NAMES.index(name)] += size
    rows = []
    for frame in range(round(SECONDS / FRAME_S)):
        sensors, _, _ = aircraft.fly(moved if frame == 0 else trim)
        rows.append(sensors)
    return numpy.array(rows)


def responses(condition):
    """For each input, the sensors' answer to a unit pulse, by name."""
    still = flown(condition)
    found = {}
    for name, (_, size) in INPUTS.items():
        difference = (flown(condition, name) - still) / size
        found[name] = dict(zip(SENSORS, difference.T, strict=True))
        altitude = found[name].pop("altitude")
        found[name]["climb"] = numpy.diff(altitude, prepend=0.0) / FRAME_S
    return found


def realised(answers, inputs, outputs, order):
    """A model of that order, outputs scaled to like sizes for it."""
    markov = numpy.array([[answers[name][output] for name in inputs]
                          for output in outputs])
    size = numpy.abs(markov).max(axis=(1, 2))
    # The first is what a pulse does within its own frame.
    count = markov.shape[2] // 2
    model, singular = control.eigensys_realization(
        markov[:, :, :2 * count - 1] / size[:, None, None], order,
        m=min(count, 150), n=min(count, 150), dt=FRAME_S)
    # It takes a pulse for one of unit area, but for its own frame.
    return control.ss(model.A, model.B / FRAME_S, size[:, None] * model.C,
                      size[:, None] * model.D, FRAME_S,
                      inputs=list(inputs), outputs=list(outputs)), singular


def misfit(model, answers, inputs, outputs):
    """The largest difference of model and flight, in parts of the largest
    response."""
    worst = 0.0
    steps = 1000
    for place, name in enumerate(inputs):
        pulse = numpy.zeros((len(inputs), steps))
        pulse[place, 0] = 1.0
        _, out = control.forced_response(
            model, numpy.arange(steps) * FRAME_S, pulse)
        for row, output in zip(out, outputs):
            real = answers[name][output][:steps]
            largest = max(numpy.abs(answers[each][output]).max()
                          for each in inputs)
            worst = max(worst, float(numpy.max(numpy.abs(
                numpy.asarray(row) - real))) / largest)
    return worst


def models(condition):
    answers = responses(condition)
    lateral, _ = realised(answers, ("roll", "yaw"), LATERAL, 6)
    longitudinal, _ = realised(
        answers, ("pitch", "throttle"), LONGITUDINAL, 6)
    return Models(lateral, longitudinal), {
        "lateral": misfit(lateral, answers, ("roll", "yaw"), LATERAL),
        "longitudinal": misfit(longitudinal, answers, ("pitch", "throttle"),
                               LONGITUDINAL)}
