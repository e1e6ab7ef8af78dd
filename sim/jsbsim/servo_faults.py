# SPDX-License-Identifier: Apache-2.0
"""Faults of the servos in a flight of plant.py."""

import math
from typing import NamedTuple

DEG = math.degrees(1.0)

# A surface with a broken linkage trails in the local wind, at this fraction of
# the wind's angle to the wing or the fin: a usual value for plain surfaces.
# The ailerons' wind includes the roll rate.
TRAILS = 0.3
AILERON_ARM_FT = 5.6
# A lever's spring closes the throttle and releases the brake; a wheel castors;
# a flap cannot go up and hangs at its stop.
LOOSE = {
    "left_aileron": lambda wind: -TRAILS * (wind.alpha - wind.rolling),
    "right_aileron": lambda wind: TRAILS * (wind.alpha + wind.rolling),
    "left_elevator": lambda wind: TRAILS * wind.alpha,
    "right_elevator": lambda wind: TRAILS * wind.alpha,
    "left_rudder": lambda wind: -TRAILS * wind.beta,
    "right_rudder": lambda wind: -TRAILS * wind.beta,
}


class Wind(NamedTuple):
    """The wind's angles to the aircraft, in degrees."""

    alpha: float
    beta: float
    rolling: float      # more alpha at the right aileron, from rolling


class Servo:
    """A servo and its fault."""

    def __init__(self, tree, name, path):
        stem = path.rsplit("-", 1)[0]
        self.command = tree.get_node(path)
        self.place = tree.get_node(path.replace("servo/", "surface/"))
        self.speed = [tree.get_node(f"{stem}-{each}")
                      for each in ("lag", "rate")]
        self.whole = [each.get_double_value() for each in self.speed]
        self.loose = LOOSE.get(name, lambda wind: 0.0)
        self.goal = None

    def begin(self, kind, value=None):
        """Applies the fault from now on, instead of an earlier one."""
        part = float(value) / 100 if kind == "slow" else 1.0
        for node, whole in zip(self.speed, self.whole):
            node.set_double_value(part * whole)
        if kind == "slow":
            self.goal = None
        elif kind == "float":
            self.goal = self.loose
        else:
            at = (self.place.get_double_value() if value is None
                  else float(value))
            self.goal = lambda wind: at

    def move(self, wind):
        """Overwrites the command of a faulty servo."""
        if self.goal:
            self.command.set_double_value(self.goal(wind))


class Faults:
    """The faults of the servos in a flight, from (NAME, "TICK FAULT")."""

    def __init__(self, tree, lines, paths):
        self.coming = [(int(tick), name, fault)
                       for name, text in lines
                       for tick, *fault in [text.split()]]
        self.servos = {name: Servo(tree, name, paths[name])
                       for _, name, _ in self.coming}
        self.alpha = tree.get_node("aero/alpha-deg")
        self.beta = tree.get_node("aero/beta-deg")
        self.roll_rate = tree.get_node("velocities/p-rad_sec")
        self.airspeed = tree.get_node("velocities/vt-fps")
        self.now = 0

    def wind(self):
        speed = max(self.airspeed.get_double_value(), 1.0)
        rolling = self.roll_rate.get_double_value() * AILERON_ARM_FT / speed
        return Wind(self.alpha.get_double_value(),
                    self.beta.get_double_value(), DEG * math.atan(rolling))

    def act(self, ticks):
        """To be called before the next ticks of the flight, with their
        number."""
        while self.coming and self.coming[0][0] <= self.now:
            _, name, fault = self.coming.pop(0)
            self.servos[name].begin(*fault)
        wind = self.wind()
        for servo in self.servos.values():
            servo.move(wind)
        self.now += ticks
