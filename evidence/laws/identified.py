# SPDX-License-Identifier: Apache-2.0
"""Linear models from the file of `bin/urv identify --model` (GND-65), in
the form of identify.Models.

The file has the aircraft alone, continuous, without servos. Servos with a lag of
0.1 s are put before it. Words are held for a frame of 20 ms, and what the sensors
measure 16 ms later is the output, as in identify.py. The file knows no engine and
no change of the airspeed: the throttle does nothing, and the airspeed is constant.
"""

import json
import sys
from typing import NamedTuple

import control
import identify
import numpy
from law_gains import FRAME_S
from scipy.linalg import expm

SERVO_LAG_S = 0.1
SCAN_S = 0.016

# Altitude is measured with the other sensors: a frame's mean climb is that of
# the frame's middle.
CLIMB_S = SCAN_S - FRAME_S / 2

OUTPUTS = {"roll_attitude": "roll_attitude_deg", "roll_rate": "roll_rate_deg_s",
           "yaw_rate": "yaw_rate_deg_s",
           "pitch_attitude": "pitch_attitude_deg",
           "pitch_rate": "pitch_rate_deg_s", "climb": "climb_ft_s"}
INPUTS = {"roll": "aileron_deg", "yaw": "rudder_deg",
          "pitch": "elevator_deg"}

AXES = {"lateral": (("roll", "yaw"), identify.LATERAL),
        "longitudinal": (("pitch", "throttle"), identify.LONGITUDINAL)}


class Identified(NamedTuple):
    """An axis that the flights did not move is None."""

    condition: identify.Condition
    models: identify.Models
    not_determined: list


def read(path):
    """The models of a file. Ends the program with one line if it is none."""
    try:
        given = json.loads(path.read_text("utf-8"))
        if given["aircraft"] != "lambda":
            sys.exit(f"margins: {path}: the laws are those of the aircraft"
                     f" lambda, not of {given['aircraft']}")
        models = [None if given[axis] is None
                  else sampled(given[axis], *items)
                  for axis, items in AXES.items()]
        return Identified(
            identify.Condition(float(given["airspeed_kt"]),
                               round(float(given["weight_lb"]) - 200.0)),
            identify.Models(*models), list(given["not_determined"]))
    except (OSError, ValueError, KeyError, TypeError) as fault:
        sys.exit(f"margins: {path}: no model of bin/urv identify:"
                 f" {type(fault).__name__}: {fault}")


def sampled(given, inputs, outputs):
    """From held words of servos to what the sensors measure."""
    A, B, C = (numpy.array(given[name], float) for name in "ABC")
    places = [given["inputs"].index(INPUTS[name]) for name in inputs
              if name in INPUTS]
    count, moved = len(A), len(places)
    # The states of the servos follow those of the aircraft, then the words.
    whole = numpy.zeros((count + 2 * moved, count + 2 * moved))
    whole[:count, :count] = A
    whole[:count, count:count + moved] = B[:, places]
    whole[count:count + moved, count:] = numpy.hstack(
        [-numpy.eye(moved), numpy.eye(moved)]) / SERVO_LAG_S

    def after(seconds):
        """States after that time, by states and words before it."""
        found = expm(whole * seconds)[:count + moved]
        held = numpy.zeros((count + moved, len(inputs)))
        held[:, :moved] = found[:, count + moved:]
        return found[:, :count + moved], held

    Ad, Bd = after(FRAME_S)
    Cd, Dd = [], []
    for name in outputs:
        row = numpy.zeros(count + moved)
        if name in OUTPUTS:
            row[:count] = C[given["outputs"].index(OUTPUTS[name])]
        state, held = after(CLIMB_S if name == "climb" else SCAN_S)
        Cd.append(row @ state)
        Dd.append(row @ held)
    return control.ss(Ad, Bd, numpy.array(Cd), numpy.array(Dd), FRAME_S,
                      inputs=list(inputs), outputs=list(outputs))
