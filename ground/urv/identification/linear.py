# SPDX-License-Identifier: Apache-2.0
"""The linear model of an aircraft from its estimated derivatives (GND-65).

Longitudinal: alpha, pitch rate and pitch attitude at a constant airspeed.
Lateral: beta, roll and yaw rate, and bank. Inputs are the positions of the
surfaces. evidence/laws/margins.py --model reads the file.
"""

from __future__ import annotations

import json

import numpy

from urv.identification import airframes, measurements

DEG = numpy.radians(1.0)
STEP = 1e-5
LB_PER_SLUG = 32.174

STATES = {
    "alpha": "alpha_deg", "q": "pitch_rate_deg_s",
    "theta": "pitch_attitude_deg", "beta": "beta_deg",
    "p": "roll_rate_deg_s", "r": "yaw_rate_deg_s",
    "phi": "roll_attitude_deg"}
"""Names in the file. All angles have the same unit, so that the matrices are
those of rad."""


def model(result, aircraft) -> dict:
    """The content of the file. An axis without derivatives is null."""
    found = {}
    speeds, missing = [], []
    for kind in airframes.AXES:
        axis = result.axes[kind.axis]
        found[kind.axis] = None
        if axis.fit is None:
            continue
        segments = [each.segment for each in axis.flown
                    if each.segment is not None]
        middle = {name: float(numpy.mean(numpy.concatenate(
            [each[name] for each in segments])))
            for name in ("airspeed", "alpha", "theta")}
        ratio = float(numpy.mean(numpy.concatenate(
            [each.density_ratio for each in segments])))
        speeds.append(middle["airspeed"])
        missing += [name for name, each in axis.derivatives.items()
                    if not (each.is_determined or name.endswith("_speed"))]
        found[kind.axis] = linear(
            kind(aircraft, {}), axis.derivatives, middle, ratio)
    return {
        "aircraft": aircraft.name,
        "airspeed_kt": round(
            float(numpy.mean(speeds)) / measurements.FPS_PER_KT, 3),
        "weight_lb": round(aircraft.mass * LB_PER_SLUG, 3),
        "not_determined": missing, **found}


def as_json(result, aircraft) -> str:
    return json.dumps(model(result, aircraft), indent=2) + "\n"


def linear(airframe, derivatives, middle, ratio) -> dict:
    """A, B, C and D of an axis at level flight. A derivative without any value
    counts as 0."""
    own = airframe.aircraft
    speed = middle["airspeed"] / numpy.sqrt(ratio)
    pressure = 0.5 * measurements.SEA_LEVEL_DENSITY * middle["airspeed"] ** 2
    alpha = theta = middle["alpha"]
    ax, az = own.gravity * numpy.sin(theta), -own.gravity * numpy.cos(theta)
    values = numpy.zeros(len(airframe.parameters))
    for name, each in derivatives.items():
        values[airframe.place[name]] = numpy.nan_to_num(each.value)
    at = {"alpha": alpha, "theta": theta, "ax": ax, "az": az}
    states = numpy.array([at.get(name, 0.0) for name in airframe.states])
    signals = [at.get(name, 0.0) for name in airframe.kinematic]
    # Then the changes of the airspeed and of the drag.
    inputs = numpy.array([*signals, speed, pressure,
                          *(0.0 for _ in airframe.surfaces), 0.0, 0.0])
    if airframe.axis == "longitudinal":
        # Level flight: the weight is carried, and no moment is left.
        values[airframe.place["CZ_0"]] = (
            own.mass * az / (pressure * own.wing_area)
            - values[airframe.place["CZ_alpha"]] * alpha)
        values[airframe.place["Cm_0"]] = (
            -values[airframe.place["Cm_alpha"]] * alpha)

    def slopes(which, row):
        """Rates by a state or an input."""
        found = []
        for sign in (1.0, -1.0):
            changed = [states.copy(), inputs.copy()]
            changed[which][row] += sign * STEP
            found.append(airframe.motion(
                *(each[:, None] for each in changed), values[:, None])[:, 0])
        return (found[0] - found[1]) / (2.0 * STEP)

    first = len(signals) + 2
    A = numpy.array([slopes(0, row) for row in range(len(states))]).T
    B = numpy.array([slopes(1, row) for row in range(
        first, first + len(airframe.surfaces))]).T
    outputs = {STATES[name]: numpy.eye(len(states))[row]
               for row, name in enumerate(airframe.states)}
    if airframe.axis == "longitudinal":
        outputs["climb_ft_s"] = speed * DEG * (
            outputs["pitch_attitude_deg"] - outputs["alpha_deg"])
    C = numpy.array(list(outputs.values()))
    return {
        "states": [STATES[name] for name in airframe.states],
        "inputs": [f"{name}_deg" for name in airframe.surfaces],
        "outputs": list(outputs),
        "A": A.tolist(), "B": B.tolist(), "C": C.tolist(),
        "D": numpy.zeros((len(C), B.shape[1])).tolist()}
