# SPDX-License-Identifier: Apache-2.0
"""Traits of the servos in a flight of plant.py (SIM-4)."""

# From stop to stop, in the servo's unit: deg, or per cent.
TRAVEL = {"aileron": 40.0, "elevator": 50.0, "rudder": 50.0, "steering": 20.0,
          "throttle": 100.0, "brake": 100.0, "flap": 15.0}


def travel(path):
    return next(value for name, value in TRAVEL.items() if name in path)


class Traits:
    """The servos of these property paths, with another lag and rate limit, in
    per cent of their own, and a dead band, in per cent of their travel."""

    def __init__(self, tree, paths, lag, rate, dead_band):
        self.places = [tree.get_node(path.replace("servo/", "surface/"))
                       for path in paths]
        self.bands = [dead_band / 100 * travel(path) for path in paths]
        for path in paths:
            stem = path.rsplit("-", 1)[0]
            # JSBSim has the reciprocal of the lag.
            for name, part in (("lag", 100 / lag), ("rate", rate / 100)):
                node = tree.get_node(f"{stem}-{name}")
                node.set_double_value(part * node.get_double_value())

    def obeyed(self, commands):
        """The positions that the servos move to: within its dead band a servo
        rests."""
        found = []
        for command, place, band in zip(commands, self.places, self.bands):
            at = place.get_double_value()
            found.append(at if abs(command - at) <= band else command)
        return found
