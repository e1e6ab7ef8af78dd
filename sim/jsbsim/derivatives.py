#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The derivatives of JSBSim's own model, by small differences at the trim
(GND-64).

    derivatives.py [--ballast LB INCHES_AFT] [-o FILE]
    derivatives.py --airframe NAME [-o FILE]

Settles the aircraft as plant.py does, or trims one that comes with JSBSim, then changes one angle, rate or
surface at a time by a little, up and down, while JSBSim's integration is
suspended, and reads the aerodynamic forces and moments. The result is the aircraft file of
`bin/urv identify`, as JSON: mass properties, and derivatives for comparison.

Derivatives are per radian. Forces are along the body axes, x forward, y right,
z down; CZ_alpha is about minus the slope of the lift. Moments are about the
body axes. Rates are p b/2V, q c/2V and r b/2V. Surfaces are in the pilot's
sense, as in the flight record: both sides together, positive to the right or
nose up. Coefficients use the dynamic pressure.

The rate of alpha is not held: it follows from the forces, as in flight. The
pitching moment by the rate of alpha is therefore in Cm_alpha, Cm_q and
Cm_elevator, and flight data show it only there.
"""

import argparse
import json
import math
import sys

import plant
from airframes import AIRFRAMES, Airframe

TIMES = plant.Times(tick=2000, frame=10, scan=8, shown=10)

STEP_MS = TIMES.step * TIMES.tick / 1e3
DELAYS_DEVIATION_MS = 0.5
"""Standard deviation of the delays that come from integration in steps. The
delays are those of straight lines."""

# Steps until servos have reached their commands: 4 s.
SERVO_STEPS = 1000

# The g in which the accelerometers' readings are given.
G_FT_S2 = 32.174

STEP_RAD = math.radians(0.5)
STEP_RATE = 0.05

PAIRS = {"aileron": ("left_aileron", "right_aileron"),
         "elevator": ("left_elevator", "right_elevator"),
         "rudder": ("left_rudder", "right_rudder")}

FORCES = {"CX": "forces/fbx-aero-lbs", "CY": "forces/fby-aero-lbs",
          "CZ": "forces/fbz-aero-lbs"}
MOMENTS = {"Cl": "moments/l-aero-lbsft", "Cm": "moments/m-aero-lbsft",
           "Cn": "moments/n-aero-lbsft"}

LONGITUDINAL = ("CX", "CZ", "Cm"), ("alpha", "q", "elevator")
LATERAL = ("CY", "Cl", "Cn"), ("beta", "p", "r", "aileron", "rudder")


OWN = "lambda"


def trim(ballast, airframe=OWN):
    """The settled aircraft's state and mass properties."""
    conditions = {"ballast": ballast} if ballast else {}
    if airframe != OWN:
        conditions["airframe"] = airframe
    aircraft = plant.Aircraft([], [("alpha", "deg")], [], [], TIMES,
                              conditions)
    fdm = aircraft.fdm
    state = {name: fdm[name] for name in (
        "position/h-sl-ft", "accelerations/Nx", "accelerations/Nz",
        "velocities/vt-fps", "aero/alpha-rad",
        "attitude/theta-rad", "aero/qbar-psf", "velocities/vc-kts")}
    state["surfaces"] = {name: fdm[plant.SERVOS[name][1]]
                         for pair in PAIRS.values() for name in pair}
    mass = {
        "mass_slug": fdm["inertia/mass-slugs"],
        **{f"{axes}_slug_ft2": fdm[f"inertia/{axes}-slugs_ft2"]
           for axes in ("ixx", "iyy", "izz")},
        # JSBSim's is an element of the matrix of inertia, with the other sign.
        "ixz_slug_ft2": 0.0 - fdm["inertia/ixz-slugs_ft2"],
        "wing_area_ft2": fdm["metrics/Sw-sqft"],
        "span_ft": fdm["metrics/bw-ft"],
        "chord_ft": fdm["metrics/cbarw-ft"]}
    return state, mass


class Model:
    """The aerodynamic coefficients at states near the trim."""

    def __init__(self, state, mass, ballast, airframe=OWN):
        self.state = state
        self.mass = mass
        step_s = TIMES.step * TIMES.tick / 1e6
        self.fdm = plant.load_jsbsim(step_s, airframe)
        self.ballast = ballast
        self.step = self.fdm.run
        if airframe != OWN:
            # The engine keeps the trim's speed, and the tail its slipstream.
            self.place({})
            other = Airframe(self.fdm, step_s)
            other.trim()
            self.step = other.step

    def place(self, change):
        """The state, with this change, as the initial condition."""
        fdm, state = self.fdm, self.state
        for name, value in (
                ("ic/terrain-elevation-ft", plant.FIELD_FT),
                ("ic/h-sl-ft", state["position/h-sl-ft"]),
                ("ic/vt-fps", state["velocities/vt-fps"]),
                ("ic/psi-true-deg", plant.START_HEADING_DEG),
                ("ic/phi-rad", 0.0),
                ("ic/theta-rad", state["attitude/theta-rad"]),
                ("ic/alpha-rad", state["aero/alpha-rad"]
                 + change.get("alpha", 0.0)),
                ("ic/beta-rad", change.get("beta", 0.0)),
                ("ic/p-rad_sec", change.get("p", 0.0)),
                ("ic/q-rad_sec", change.get("q", 0.0)),
                ("ic/r-rad_sec", change.get("r", 0.0))):
            fdm[name] = value
        # Alpha may not move theta along.
        fdm["ic/theta-rad"] = state["attitude/theta-rad"]
        if self.ballast:
            weight, aft = self.ballast
            fdm["inertia/pointmass-weight-lbs"] = weight
            fdm["inertia/pointmass-location-X-inches"] = plant.CG_IN + aft
        if not fdm.run_ic():
            raise plant.Refused("JSBSim does not accept the state")

    def coefficients(self, **change):
        """Every coefficient, with angles in rad and rates in rad/s changed by
        that much from the trim."""
        fdm, state = self.fdm, self.state
        self.place(change)
        fdm.suspend_integration()
        for surface, sides in PAIRS.items():
            for side in sides:
                fdm[plant.SERVOS[side][1]] = (
                    state["surfaces"][side]
                    + math.degrees(change.get(surface, 0.0)))
        for _ in range(SERVO_STEPS):
            self.step()
        area = fdm["aero/qbar-psf"] * self.mass["wing_area_ft2"]
        arms = {"Cl": self.mass["span_ft"], "Cm": self.mass["chord_ft"],
                "Cn": self.mass["span_ft"]}
        found = {name: fdm[path] / area for name, path in FORCES.items()}
        found |= {name: fdm[path] / (area * arms[name])
                  for name, path in MOMENTS.items()}
        fdm.resume_integration()
        return found

    def derivatives(self):
        """Each derivative by the difference of two states."""
        speed = self.state["velocities/vt-fps"]
        per = {"p": self.mass["span_ft"] / (2.0 * speed),
               "q": self.mass["chord_ft"] / (2.0 * speed),
               "r": self.mass["span_ft"] / (2.0 * speed)}
        found = {}
        for coefficients, variables in (LONGITUDINAL, LATERAL):
            for variable in variables:
                step = STEP_RATE if variable in per else STEP_RAD
                more, less = (self.coefficients(**{variable: change})
                              for change in (step, -step))
                for name in coefficients:
                    found[f"{name}_{variable}"] = (more[name] - less[name]) / (
                        2.0 * step * per.get(variable, 1.0))
        return found


def aircraft_file(ballast=None, airframe=OWN):
    """The content of the file."""
    state, mass = trim(ballast, airframe)
    derivatives = Model(state, mass, ballast, airframe).derivatives()
    return {
        "aircraft": airframe,
        "source": "sim/jsbsim/derivatives.py: small differences at the trim",
        "trim": {
            "airspeed_kt": round(state["velocities/vc-kts"], 2),
            "altitude_ft": round(state["position/h-sl-ft"], 1),
            "alpha_deg": round(math.degrees(state["aero/alpha-rad"]), 3)},
        # The reading of level accelerometers at the field.
        "gravity_ft_s2": round(G_FT_S2 * math.hypot(
            state["accelerations/Nx"], state["accelerations/Nz"]), 3),
        **{name: round(value, 5) for name, value in mass.items()},
        # JSBSim integrates attitudes and rates by Euler's method, which is half a
        # step late: attitudes and airflow, which contain the attitude, are late
        # beside the rates, and so are the moments. They have the airflow that
        # the sensors show. Accelerometers show the forces of the step before.
        "delays_ms": {
            "attitude": STEP_MS / 2.0, "airflow": STEP_MS / 2.0,
            "accelerations": STEP_MS * 1.5, "moments": STEP_MS / 2.0,
            "moments_by_airflow": STEP_MS},
        "delays_deviation_ms": DELAYS_DEVIATION_MS,
        "derivatives": {name: round(value, 5) + 0.0
                        for name, value in derivatives.items()}}


def main():
    arguments = argparse.ArgumentParser(
        description="The derivatives of JSBSim's own model at the trim.")
    arguments.add_argument("--ballast", nargs=2, type=float,
                           metavar=("LB", "INCHES_AFT"))
    arguments.add_argument("--airframe", default=OWN,
                           choices=(OWN, *AIRFRAMES))
    arguments.add_argument("-o", "--output", metavar="FILE")
    given = arguments.parse_args()
    try:
        text = json.dumps(aircraft_file(given.ballast, given.airframe),
                          indent=2) + "\n"
    except plant.Refused as refusal:
        print(f"derivatives: {refusal}", file=sys.stderr)
        return 2
    if given.output:
        with open(given.output, "w", encoding="utf-8") as file:
            file.write(text)
    else:
        print(text, end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
