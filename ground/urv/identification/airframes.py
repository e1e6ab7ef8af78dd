# SPDX-License-Identifier: Apache-2.0
"""Longitudinal and lateral motion with linear aerodynamics (GND-62).

Each axis has a model for output error, and the same coefficients for equation
error. Coefficients are of the dynamic pressure; rates are p b/2V, q c/2V and
r b/2V. The other axis, the airspeed and the accelerations across are taken from
the measurements: no drag and no thrust is needed.

Constants (CZ_0, Cm_0, ...) are of each manoeuvre. They take up the trim, a
constant error of alpha and beta, and the engine's torque.
"""

from __future__ import annotations

import numpy

from urv.identification import manoeuvres, measurements
from urv.identification.aircraft import (
    MOMENTS,
    MOMENTS_BY_AIRFLOW,
    Aircraft,
)
from urv.identification.measurements import GRAVITY, Segment
from urv.identification.output_error import (
    ALL,
    RECORD,
    SEGMENT,
    Parameter,
)

DEG = numpy.radians(1.0)

SPIN = "propellers' spin"
SPIN_PER_S = 0.5
"""Angular momentum of all propellers, over the inertia in pitch: a parameter, and
its standard deviation before the flight. It turns pitch into yaw and yaw into
pitch."""

AIRSPEED_ERROR = "airspeed's constant error"
"""A parameter, in standard deviations of each record's constant error."""

DRAG = "drag along the wind"
"""The share of the drag's changes that acts along the wind, so that a sideslip turns
it to the side: a parameter. Wind tunnels and JSBSim assume 1; 0 is drag that stays along
the body."""
DRAG_DEVIATION = 0.5

LEAST_ERROR = {"airspeed": 1e-3, "alpha": 1e-5}
"""Least deviations of constant errors, ft/s and rad."""

LEAST_DELAY_S = 1e-8
"""A shorter one is none."""


def along_wind(segment: Segment):
    """The specific force along the wind without sideslip, less the mean along the
    wind. Its changes are those of the drag: thrust hardly changes in a manoeuvre."""
    alpha, beta = segment["alpha"], segment["beta"]
    found = (segment["ax"] * numpy.cos(alpha)
             + segment["az"] * numpy.sin(alpha))
    return found - (found * numpy.cos(beta)
                    + segment["ay"] * numpy.sin(beta)).mean()


class Airframe:
    """What both axes share."""

    axis: str
    coefficients: tuple[str, ...]
    variables: tuple[str, ...]
    """The last one is the airspeed, as a share of its mean: thrust and torque do
    not grow with the dynamic pressure."""
    surfaces: tuple[str, ...]
    kinematic: tuple[str, ...]
    """Measured signals that the equations of motion take."""
    turning: tuple[int, ...]
    """Rows of the states whose rates come from moments."""
    sizes_of: dict[str, float]
    """The effect of a variable that matters, as a coefficient."""
    errors: tuple[Parameter, ...]
    known: tuple[Parameter, ...] = ()
    """Further parameters that are considered, and not estimated."""

    def __init__(self, aircraft: Aircraft,
                 deviations: dict[str, dict[int, float]]):
        """deviations: of the constant errors that remain of "airspeed" and
        "alpha", for each record."""
        self.aircraft = aircraft
        self.deviations = deviations
        self.moments_delay = aircraft.delays.get(MOMENTS, 0.0)
        self.airflow_more = aircraft.delays.get(
            MOMENTS_BY_AIRFLOW, self.moments_delay) - self.moments_delay
        # Flight data cannot separate delays well from what a model lacks.
        none = 0.0, aircraft.delays_deviation
        self.parameters = (
            *(Parameter(f"{name}_{variable}", ALL, 0.0,
                        0.01 * self.sizes_of[name]
                        / self.sizes_of[variable])
              for name in self.coefficients for variable in self.variables),
            *(Parameter(f"{name}_0", SEGMENT, 0.0, 0.01 * self.sizes_of[name])
              for name in self.coefficients),
            *self.errors,
            *self.known,
            Parameter(SPIN, RECORD, 0.0, 0.01, prior=(0.0, SPIN_PER_S)),
            # One probe and one aircraft fly all records: more records make
            # these no smaller.
            Parameter(AIRSPEED_ERROR, ALL, 0.0, 1.0, is_input=True,
                      prior=(0.0, 1.0), is_considered=True),
            Parameter("surfaces' delay", ALL, 0.0, 0.002, is_input=True,
                      prior=none, is_considered=True),
            Parameter("moments' delay", ALL, 0.0, 0.002, is_input=True,
                      prior=(self.moments_delay, aircraft.delays_deviation),
                      is_considered=True),
            Parameter("airflow's delay", ALL, 0.0, 0.002,
                      prior=none, is_considered=True),
            Parameter("accelerations' delay", ALL, 0.0, 0.002,
                      prior=none, is_considered=True))
        self.place = {each.name: number
                      for number, each in enumerate(self.parameters)}
        self.late_columns = None, None, None

    @property
    def noisy(self):
        return self.kinematic

    @property
    def derivatives(self) -> list[str]:
        return [f"{name}_{variable}" for name in self.coefficients
                for variable in self.variables]

    def prior(self, parameter, record):
        name, _, kind = parameter.name.partition(" ")
        if kind == "error":
            return 0.0, self.deviation(name, record)
        return parameter.prior

    def deviation(self, name, record):
        """Standard deviation of a sensor's constant error in a record."""
        return max(self.deviations[name][record], LEAST_ERROR[name])

    def measured(self, segment: Segment):
        return numpy.array([segment[name] for name in self.outputs])

    def first_states(self, segment: Segment):
        return numpy.array([segment[name][:5].mean() for name in self.states])

    def inputs(self, segment, times, values):
        """Signals, then true airspeed and dynamic pressure, then surfaces,
        then the share by which the airspeed exceeds its mean."""
        error = (values[self.place[AIRSPEED_ERROR]]
                 * self.deviation("airspeed", segment.record))
        delay = (values[self.place["surfaces' delay"]]
                 - values[self.place["moments' delay"]])
        calibrated = numpy.interp(
            times, segment.times, segment["airspeed"]) - error
        ratio = numpy.interp(times, segment.times, segment.density_ratio)
        return numpy.concatenate([
            segment.splines(*self.kinematic)(times),
            [calibrated / numpy.sqrt(ratio),
             0.5 * measurements.SEA_LEVEL_DENSITY * calibrated ** 2],
            segment.splines(*self.surfaces)(times + delay),
            [calibrated / (segment["airspeed"].mean() - error) - 1.0]])

    def sums(self, variables, values):
        """The coefficients: of each the sum of its parts. Their parameters are
        the first ones."""
        shape = len(self.coefficients), len(self.variables)
        count = shape[0] * shape[1]
        slopes = values[:count].reshape(*shape, *values.shape[1:])
        return values[count:count + shape[0]] + numpy.einsum(
            "nv...,v...->n...", slopes, variables)

    def rates(self, states, inputs, values):
        found = self.motion(states, inputs, values)
        delay = values[self.place["moments' delay"]]
        # The same values come for each time of an integration.
        known, late, late_values = self.late_columns
        if known is not values:
            late = numpy.flatnonzero(
                abs(delay) + abs(self.airflow_more) > LEAST_DELAY_S)
            late_values = values[:, late]
            self.late_columns = values, late, late_values
        if len(late):
            delays = numpy.tile(delay[late], (len(self.states), 1))
            delays[0] += self.airflow_more
            before = self.motion(
                states[:, late] - delays * found[:, late],
                inputs[:, late], late_values)
            for row in self.turning:
                found[row, late] = before[row]
        return found

    def late(self, states, inputs, values):
        """Alpha or beta as a late sensor shows it."""
        delay = values[self.place["airflow's delay"]]
        if (abs(delay) < LEAST_DELAY_S).all():
            return states[0]
        return states[0] - delay * self.motion(states, inputs, values)[0]

    def late_force(self, states, inputs, values):
        """The specific force as a late accelerometer shows it. The surfaces'
        share is that of their own delay."""
        delay = values[self.place["accelerations' delay"]]
        if (abs(delay) < LEAST_DELAY_S).all():
            return self.forces(states, inputs, values)[0]
        before = states - delay * self.motion(states, inputs, values)
        return self.forces(before, inputs, values)[0]

    def as_moments_see(self, segment: Segment):
        """The segment with the causes of moments as late as they act."""
        turning = (self.states[row] for row in self.turning)
        return measurements.shifted(segment, {
            self.states[0]: -self.moments_delay - self.airflow_more,
            **dict.fromkeys((*turning, *self.surfaces), -self.moments_delay)})

    def pressure_and_speed(self, segment: Segment):
        calibrated = segment["airspeed"]
        return (0.5 * measurements.SEA_LEVEL_DENSITY * calibrated ** 2,
                calibrated / numpy.sqrt(segment.density_ratio))


class Longitudinal(Airframe):
    """Short period: alpha, pitch rate and pitch attitude."""

    axis = manoeuvres.LONGITUDINAL
    states = ("alpha", "q", "theta")
    outputs = ("alpha", "q", "theta", "az")
    turning = (1,)
    sizes = (0.2 * DEG, 0.5 * DEG, 0.2 * DEG)
    coefficients = ("CZ", "Cm")
    variables = ("alpha", "q", "elevator", "speed")
    surfaces = ("elevator",)
    kinematic = ("p", "r", "phi", "beta", "ax")
    sizes_of = {"CZ": 0.1, "Cm": 0.03, "alpha": 2.0 * DEG, "q": 0.002,
                "elevator": 2.0 * DEG, "speed": 0.5}
    errors = (Parameter("error of q", RECORD, 0.0, 0.1 * DEG,
                        prior=(0.0, 2.0 * DEG)),
              Parameter("error of az", RECORD, 0.0, 0.005 * GRAVITY,
                        prior=(0.0, 0.1 * GRAVITY)))

    def forces(self, states, inputs, values):
        """Specific force along z, and the pitching moment over the inertia."""
        own = self.aircraft
        alpha, q = states[0], states[1]
        speed, pressure, elevator, change = inputs[5:9]
        force, moment = self.sums(numpy.array([
            alpha, q * own.chord / (2.0 * speed), elevator, change]), values)
        area = pressure * own.wing_area
        return (area / own.mass * force, area * own.chord / own.iyy * moment)

    def motion(self, states, inputs, values):
        own = self.aircraft
        alpha, q, theta = states
        p, r, phi, beta, ax, speed = inputs[:6]
        force, moment = self.forces(states, inputs, values)
        sin, cos = numpy.sin(alpha), numpy.cos(alpha)
        return numpy.array([
            q - numpy.tan(beta) * (p * cos + r * sin)
            + (force * cos - ax * sin + own.gravity * (
                numpy.cos(phi) * numpy.cos(theta) * cos
                + numpy.sin(theta) * sin)) / (speed * numpy.cos(beta)),
            moment + ((own.izz - own.ixx) * p * r
                      + own.ixz * (r * r - p * p)) / own.iyy
            - values[self.place[SPIN]] * r,
            q * numpy.cos(phi) - r * numpy.sin(phi)])

    def outputs_of(self, states, inputs, values):
        alpha, q, theta = states
        force = self.late_force(states, inputs, values)
        alpha = self.late(states, inputs, values)
        return numpy.array([alpha, q + values[self.place["error of q"]],
                            theta,
                            force + values[self.place["error of az"]]])

    def regressors(self, segment: Segment, smooth):
        _, speed = self.pressure_and_speed(segment)
        return numpy.array([
            smooth(segment["alpha"]),
            smooth(segment["q"]) * self.aircraft.chord / (2.0 * speed),
            smooth(segment["elevator"]),
            smooth(segment["airspeed"]) / segment["airspeed"].mean() - 1.0])

    def equations(self, segment: Segment, smooth, slope):
        """By coefficient: left sides, regressors, and that of the propellers'
        spin."""
        own = self.aircraft
        pressure, _ = self.pressure_and_speed(segment)
        p, r = (smooth(segment[name]) for name in "pr")
        area = pressure * own.wing_area
        return {
            "CZ": own.mass * smooth(segment["az"]) / area,
            "Cm": (own.iyy * slope(segment["q"])
                   - (own.izz - own.ixx) * p * r
                   - own.ixz * (r * r - p * p)) / (area * own.chord),
        }, {
            "CZ": self.regressors(segment, smooth),
            "Cm": self.regressors(self.as_moments_see(segment), smooth),
        }, {"Cm": -own.iyy * r / (area * own.chord)}


class Lateral(Airframe):
    """Roll, spiral and Dutch roll: beta, roll and yaw rate, bank."""

    axis = manoeuvres.LATERAL
    states = ("beta", "p", "r", "phi")
    outputs = ("beta", "p", "r", "phi", "ay")
    turning = (1, 2)
    sizes = (0.2 * DEG, 1.0 * DEG, 0.5 * DEG, 0.5 * DEG)
    coefficients = ("CY", "Cl", "Cn")
    variables = ("beta", "p", "r", "aileron", "rudder", "speed")
    surfaces = ("aileron", "rudder")
    kinematic = ("q", "alpha", "theta", "ax", "az")
    sizes_of = {"CY": 0.03, "Cl": 0.01, "Cn": 0.005, "beta": 3.0 * DEG,
                "p": 0.02, "r": 0.01, "aileron": 3.0 * DEG,
                "rudder": 3.0 * DEG, "speed": 0.5}
    errors = (Parameter("error of p", RECORD, 0.0, 0.2 * DEG,
                        prior=(0.0, 2.0 * DEG)),
              Parameter("error of r", RECORD, 0.0, 0.1 * DEG,
                        prior=(0.0, 2.0 * DEG)),
              # Alpha tilts the axis of the roll rate: rolls show its error.
              Parameter("alpha error", RECORD, 0.0, 0.1 * DEG, is_input=True))
    known = (Parameter(DRAG, ALL, 1.0, 0.1, prior=(1.0, DRAG_DEVIATION),
                       is_considered=True),)

    def inputs(self, segment, times, values):
        """Those of all airframes, then the changes of the force along the wind."""
        found = super().inputs(segment, times, values)
        found[self.kinematic.index("alpha")] -= values[
            self.place["alpha error"]]
        return numpy.concatenate([
            found, [numpy.interp(times, segment.times, along_wind(segment))]])

    def forces(self, states, inputs, values):
        """Specific force along y, and the moments in roll and yaw.

        Drag acts along the wind. A sideslip turns it to the side: at a constant
        drag a part of CY_beta. The drag changes with lift and sideslip, and in a
        roll the lift changes: CY_p would show it."""
        own = self.aircraft
        beta, p, r = states[:3]
        speed, pressure, aileron, rudder, change, along = inputs[5:11]
        per = own.span / (2.0 * speed)
        force, roll, yaw = self.sums(numpy.array([
            beta, p * per, r * per, aileron, rudder, change]), values)
        area = pressure * own.wing_area
        return (area / own.mass * force / numpy.cos(beta)
                + values[self.place[DRAG]] * numpy.tan(beta) * along,
                area * own.span * roll, area * own.span * yaw)

    def motion(self, states, inputs, values):
        own = self.aircraft
        beta, p, r, phi = states
        q, alpha, theta, ax, az, speed = inputs[:6]
        force, roll, yaw = self.forces(states, inputs, values)
        sin_beta, cos_beta = numpy.sin(beta), numpy.cos(beta)
        sin, cos = numpy.sin(alpha), numpy.cos(alpha)
        cos_theta = numpy.cos(theta)
        roll = roll + (own.iyy - own.izz) * q * r + own.ixz * p * q
        yaw = (yaw + (own.ixx - own.iyy) * p * q - own.ixz * q * r
               + values[self.place[SPIN]] * own.iyy * q)
        both = own.ixx * own.izz - own.ixz ** 2
        return numpy.array([
            p * sin - r * cos + (
                force * cos_beta - sin_beta * (ax * cos + az * sin)
                + own.gravity * (numpy.sin(phi) * cos_theta * cos_beta
                             + sin_beta * (cos * numpy.sin(theta)
                                           - sin * numpy.cos(phi)
                                           * cos_theta))) / speed,
            (own.izz * roll + own.ixz * yaw) / both,
            (own.ixz * roll + own.ixx * yaw) / both,
            p + (q * numpy.sin(phi) + r * numpy.cos(phi))
            * numpy.sin(theta) / cos_theta])

    def outputs_of(self, states, inputs, values):
        beta, p, r, phi = states
        force = self.late_force(states, inputs, values)
        beta = self.late(states, inputs, values)
        return numpy.array([
            beta, p + values[self.place["error of p"]],
            r + values[self.place["error of r"]], phi, force])

    def regressors(self, segment: Segment, smooth):
        _, speed = self.pressure_and_speed(segment)
        per = self.aircraft.span / (2.0 * speed)
        return numpy.array([
            smooth(segment["beta"]),
            *(smooth(segment[name]) * per for name in "pr"),
            *(smooth(segment[name]) for name in self.surfaces),
            smooth(segment["airspeed"]) / segment["airspeed"].mean() - 1.0])

    def equations(self, segment: Segment, smooth, slope):
        """By coefficient: left sides, regressors, and that of the propellers'
        spin."""
        own = self.aircraft
        pressure, _ = self.pressure_and_speed(segment)
        p, q, r = (smooth(segment[name]) for name in "pqr")
        dp, dr = slope(segment["p"]), slope(segment["r"])
        area = pressure * own.wing_area
        late = self.regressors(self.as_moments_see(segment), smooth)
        beta = smooth(segment["beta"])
        side = smooth(segment["ay"]) - numpy.tan(beta) * smooth(
            along_wind(segment))
        return {
            "CY": own.mass * side * numpy.cos(beta) / area,
            "Cl": (own.ixx * dp - own.ixz * (dr + p * q)
                   - (own.iyy - own.izz) * q * r) / (area * own.span),
            "Cn": (own.izz * dr - own.ixz * (dp - q * r)
                   - (own.ixx - own.iyy) * p * q) / (area * own.span),
        }, {
            "CY": self.regressors(segment, smooth), "Cl": late, "Cn": late,
        }, {"Cn": own.iyy * q / (area * own.span)}


AXES = (Longitudinal, Lateral)
