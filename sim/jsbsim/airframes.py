# SPDX-License-Identifier: Apache-2.0
"""Aircraft that come with JSBSim, flown by plant.py in place of URV's own
(SIM-10).

JSBSim's own trim finds their level flight. Around it they have the servos of
URV's aircraft for ailerons, elevators, rudders and throttle: with the same lag,
rate limit and stops, and in the pilot's sense. Zero of a surface is its
position at the trim (D-91). Steering, brakes and flaps do not move.
"""

import math
from typing import NamedTuple

# JSBSim's trim in level flight.
FULL = 1

# JSBSim's mixture lever: best power of these engines at 1800 ft.
MIXTURE = 0.9

# A surface reaches the end of JSBSim's own lever within these steps.
END_STEPS = 5

# Lever of JSBSim beyond both ends, whatever its trim.
BEYOND = 2.0

BATTERY_V, ALTERNATOR_V = 25.0, 28.0


class Surface(NamedTuple):
    """A control of JSBSim. A positive lever rolls right, or pitches down or
    yaws left where sense is -1."""

    lever: str
    position: str
    sense: int
    servos: tuple[str, str]
    stop: float


SURFACES = (
    Surface("fcs/aileron-cmd-norm", "fcs/left-aileron-pos-rad", 1,
            ("left-aileron", "right-aileron"), 20.0),
    Surface("fcs/elevator-cmd-norm", "fcs/elevator-pos-rad", -1,
            ("left-elevator", "right-elevator"), 25.0),
    Surface("fcs/rudder-cmd-norm", "fcs/rudder-pos-rad", -1,
            ("left-rudder", "right-rudder"), 25.0),
)

THROTTLE = "fcs/throttle-cmd-norm"

# Reciprocal of the lag, and rate limit: as in aircraft/lambda/lambda.xml.
LAG = 10.0
SURFACE_RATE, THROTTLE_RATE = 100.0, 200.0

# At its neutral word the throttle is at the trim, in per cent.
HALF = 50.0

FIXED = ("steering-deg", "brake-pct", "left-flap-1-deg", "right-flap-1-deg",
         "left-flap-2-deg", "right-flap-2-deg")


# Airspeed of level flight, kt. In level flight at these speeds the aircraft
# are stable with fixed controls, and alpha is far from the stall.
AIRFRAMES = {"c172p": 90.0, "c182": 100.0, "J3Cub": 60.0}


class Servo:
    """A servo with a command and a position, both properties."""

    def __init__(self, fdm, tree, name, rate, neutral, stops):
        stem, unit = name.rsplit("-", 1)
        for path, value in (
                (f"servo/{name}", neutral), (f"surface/{name}", neutral),
                (f"servo/{stem}-lag", LAG), (f"servo/{stem}-rate", rate)):
            fdm[path] = value
        self.command, self.place, self.lag, self.rate = (
            tree.get_node(path) for path in (
                f"servo/{name}", f"surface/{name}",
                f"servo/{stem}-lag", f"servo/{stem}-rate"))
        self.stops = stops
        self.position = neutral

    def move(self, seconds):
        """A step: an exact first-order lag within the rate limit."""
        least, most = self.stops
        goal = min(max(self.command.get_double_value(), least), most)
        way = (goal - self.position) * -math.expm1(
            -seconds * self.lag.get_double_value())
        limit = seconds * self.rate.get_double_value()
        self.position += min(max(way, -limit), limit)
        self.place.set_double_value(self.position)
        return self.position


class Control:
    """JSBSim's lever for a surface, and both servos that move it."""

    def __init__(self, fdm, tree, surface, ends):
        self.surface = surface
        self.ends = ends
        self.lever = tree.get_node(surface.lever)
        self.trim_lever = self.lever.get_double_value()
        self.trim = math.degrees(fdm[surface.position])
        self.trim_part = self.part(self.trim)
        reach = sorted(surface.sense * (end - self.trim) for end in ends)
        stops = max(-surface.stop, reach[0]), min(surface.stop, reach[1])
        self.servos = [Servo(fdm, tree, f"{name}-deg", SURFACE_RATE, 0.0,
                             stops) for name in surface.servos]

    def part(self, degrees):
        """The lever for a position: linear on each side of JSBSim's zero."""
        least, most = self.ends
        return degrees / most if degrees > 0.0 else -degrees / least

    def move(self, seconds):
        one, other = (servo.move(seconds) for servo in self.servos)
        degrees = self.trim + self.surface.sense * 0.5 * (one + other)
        self.lever.set_double_value(
            self.trim_lever + self.part(degrees) - self.trim_part)


class Airframe:
    """An aircraft of JSBSim's in trimmed level flight."""

    def __init__(self, fdm, step_s):
        self.fdm = fdm
        self.step_s = step_s

    def trim(self):
        """Trims the initial condition. Raises RuntimeError when JSBSim cannot.
        """
        fdm = self.fdm
        tree = fdm.get_property_manager()
        fdm["fcs/mixture-cmd-norm"] = MIXTURE
        fdm.get_propulsion().init_running(-1)
        ends = [self.ends_of(surface) for surface in SURFACES]
        fdm.do_trim(FULL)
        self.controls = [Control(fdm, tree, surface, each)
                         for surface, each in zip(SURFACES, ends)]
        self.throttle_lever = tree.get_node(THROTTLE)
        self.throttle_trim = fdm[THROTTLE]
        self.throttle = Servo(fdm, tree, "throttle-pct", THROTTLE_RATE, HALF,
                              (0.0, 100.0))
        for each in FIXED:
            fdm[f"servo/{each}"] = fdm[f"surface/{each}"] = 0.0
            stem = each.rsplit("-", 1)[0]
            fdm[f"servo/{stem}-lag"] = fdm[f"servo/{stem}-rate"] = 1.0
        fdm["electric/battery-volts"] = BATTERY_V
        fdm["electric/alternator-volts"] = ALTERNATOR_V

    def ends_of(self, surface):
        """The least and greatest position, in degrees of JSBSim's sense."""
        fdm = self.fdm
        found = []
        fdm.suspend_integration()
        for lever in (-BEYOND, BEYOND, 0.0):
            fdm[surface.lever] = lever
            for _ in range(END_STEPS):
                fdm.run()
            found.append(math.degrees(fdm[surface.position]))
        fdm.resume_integration()
        return found[:2]

    def step(self):
        """A step of the servos, then of JSBSim."""
        for control in self.controls:
            control.move(self.step_s)
        percent = self.throttle.move(self.step_s)
        self.throttle_lever.set_double_value(
            self.throttle_trim * percent / HALF if percent < HALF else
            self.throttle_trim
            + (1.0 - self.throttle_trim) * (percent / HALF - 1.0))
        self.fdm.run()
