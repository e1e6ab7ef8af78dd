# SPDX-License-Identifier: Apache-2.0
"""The aircraft of the simulation: JSBSim in lock-step with Sim.JSBSim.

    plant.py DESCRIPTOR

Serves one flight over the socket that it inherits as file DESCRIPTOR. The
other side is the Ada package Sim.JSBSim, which alone uses converter words; this
program uses engineering units only.

Start: the other side sends lines KIND,NAME,UNIT, where KIND is servo, sensor,
truth or shown, and an empty line. They name the numbers that it will send and
request, in that order. Lines time,NAME,VALUE UNIT give the length of a tick
(tick, in us) and, in ticks, the length of a frame (frame) and the times of the
sensors' measurement (scan) and of the shown values (shown). Lines
condition,NAME,VALUES give the conditions of the flight: see CONDITIONS, and
condition,airframe,NAME another aircraft: see airframes.py. Lines
fault,NAME,TICK FAULT give the fault of a servo from that tick of the flight on:
stuck, stuck AT, float, slow PERCENT; they come in the order of their ticks. The
answer is one line: "ready", or the error.

Then for every major frame: the servos' commands are received and held for the
frame, and the sensors, the truth at its beginning and the shown values are
sent. A number is a big-endian double.
The first message, the settled aircraft, is sent without a request.

The end of the connection ends the program.
"""

import math
import os
import signal
import socket
import struct
import sys
import types
from pathlib import Path
from typing import NamedTuple

from airframes import AIRFRAMES, Airframe
from servo_faults import Faults
from servo_traits import Traits

FIELD_FT = 800.0
START_ALTITUDE_FT = 1000.0
START_SPEED_KT = 70.0
START_HEADING_DEG = 90.0

# The altitude is that of the centre of gravity: 1.6 ft on the wheels.
BELLY_FT = 0.8
HALF_SPAN_FT = 7.0

# The longest step of JSBSim, in us. Half of it moves no attitude, airspeed or
# altitude by a bit (tests/simulation/test_aircraft.py).
LONGEST_STEP_US = 4000

# Best power of the engine at this height. The pilot has no such lever.
MIXTURE = 0.9

START_ENGINE_S = 2
SETTLE_S = 90

# On the runway: the wheels' springs carry it at this height.
STANDING_FT = 1.6
STAND_S = 6

# Ropes hold the parked aircraft, with this pull at 60 kt of wind; the pull
# grows with the square of the wind. They come off when less than half of the
# brake is commanded.
ROPES_LB = 300.0
ROPES_AT_KT = 60.0
ROPES = "external_reactions/ropes/magnitude"
PARKED_BRAKE_PCT = 50.0

# Polls for commands; after a failed poll, the largest number of waits without
# polling.
LOOKS = 100
MOST_SKIPS = 511

# Conditions of a flight, and the count of numbers of each. A start on the
# runway has none: the aircraft is parked there, brake on, pointing along it.
# turbulence is Dryden's (MIL-F-8785C), given by the wind 20 ft above the
# ground. ballast is a weight in lb and its distance aft of the centre of
# gravity in inches. servos are the lag and the rate limit of all servos in per
# cent of theirs, and their dead band in per cent of the travel. seed is that
# of the turbulence.
CONDITIONS = {"start": 0, "wind": 2, "turbulence": 1, "ballast": 2,
              "servos": 3, "seed": 1}

# The conditions in which another aircraft can fly.
FOR_AIRFRAMES = {"airframe", "turbulence", "servos", "seed"}
DRYDEN = 3
SEVERITY = 3
FPS_PER_KT = 1.0 / 0.592484
CG_IN = 40.0

DEG = math.degrees(1.0)
KM_PER_FT = 0.3048e-3

# Servo: unit, property.
SERVOS = {
    "left_aileron": ("deg", "servo/left-aileron-deg"),
    "right_aileron": ("deg", "servo/right-aileron-deg"),
    "left_elevator": ("deg", "servo/left-elevator-deg"),
    "right_elevator": ("deg", "servo/right-elevator-deg"),
    "left_rudder": ("deg", "servo/left-rudder-deg"),
    "right_rudder": ("deg", "servo/right-rudder-deg"),
    "steering": ("deg", "servo/steering-deg"),
    "throttle": ("%", "servo/throttle-pct"),
    "brake": ("%", "servo/brake-pct"),
    "left_flap_1": ("deg", "servo/left-flap-1-deg"),
    "right_flap_1": ("deg", "servo/right-flap-1-deg"),
    "left_flap_2": ("deg", "servo/left-flap-2-deg"),
    "right_flap_2": ("deg", "servo/right-flap-2-deg"),
}

# Sensor: unit, property, factor, offset. The reading is the property times
# the factor plus the offset.
SENSORS = {
    "right_flap_1": ("deg", "surface/right-flap-1-deg", 1.0, 0.0),
    "left_flap_1": ("deg", "surface/left-flap-1-deg", 1.0, 0.0),
    "right_flap_2": ("deg", "surface/right-flap-2-deg", 1.0, 0.0),
    "left_flap_2": ("deg", "surface/left-flap-2-deg", 1.0, 0.0),
    "right_aileron": ("deg", "surface/right-aileron-deg", 1.0, 0.0),
    "left_aileron": ("deg", "surface/left-aileron-deg", 1.0, 0.0),
    "right_elevator": ("deg", "surface/right-elevator-deg", 1.0, 0.0),
    "left_elevator": ("deg", "surface/left-elevator-deg", 1.0, 0.0),
    "right_rudder": ("deg", "surface/right-rudder-deg", 1.0, 0.0),
    "left_rudder": ("deg", "surface/left-rudder-deg", 1.0, 0.0),
    "alpha": ("deg", "aero/alpha-deg", 1.0, 0.0),
    "beta": ("deg", "aero/beta-deg", 1.0, 0.0),
    # The altitude at which Altitude reads zero: set to the field's height
    # before take-off.
    "altitude_offset": ("ft", "position/h-sl-ft", 0.0, FIELD_FT),
    "lateral_acceleration": ("g", "accelerations/Ny", 1.0, 0.0),
    "longitudinal_acceleration": ("g", "accelerations/Nx", 1.0, 0.0),
    "vertical_acceleration": ("g", "accelerations/Nz", 1.0, 0.0),
    "rpm": ("rev/min", "propulsion/engine[0]/engine-rpm", 1.0, 0.0),
    "battery_volts": ("V", "electric/battery-volts", 1.0, 0.0),
    "alternator_volts": ("V", "electric/alternator-volts", 1.0, 0.0),
    "roll_attitude": ("deg", "attitude/phi-deg", 1.0, 0.0),
    "pitch_attitude": ("deg", "attitude/theta-deg", 1.0, 0.0),
    "roll_rate": ("deg/s", "velocities/p-rad_sec", DEG, 0.0),
    "pitch_rate": ("deg/s", "velocities/q-rad_sec", DEG, 0.0),
    "yaw_rate": ("deg/s", "velocities/r-rad_sec", DEG, 0.0),
    "airspeed": ("kt", "velocities/vc-kts", 1.0, 0.0),
    "altitude": ("ft", "position/h-sl-ft", 1.0, -FIELD_FT),
    "uplink_signal_strength": ("dBm", "radio/uplink-dbm", 1.0, 0.0),
}

# The true state of the aircraft. "crashed" is 1 once other parts than the
# wheels have touched the ground; after that no value changes.
TRUTH = {
    "altitude": ("ft", "position/h-sl-ft", 1.0, -FIELD_FT),
    "airspeed": ("kt", "velocities/vc-kts", 1.0, 0.0),
    "bank": ("deg", "attitude/phi-deg", 1.0, 0.0),
    "pitch": ("deg", "attitude/theta-deg", 1.0, 0.0),
    "heading": ("deg", "attitude/psi-deg", 1.0, 0.0),
    "climb": ("ft/s", "velocities/h-dot-fps", 1.0, 0.0),
    "north": ("ft", "position/from-start-neu-n-ft", 1.0, 0.0),
    "east": ("ft", "position/from-start-neu-e-ft", 1.0, 0.0),
    "wheels": ("on ground", "plant/wheels", 1.0, 0.0),
    "crashed": ("yes", "plant/crashed", 1.0, 0.0),
}

# The same for the flight record. North and east are counted from the flight's
# beginning.
SHOWN = {
    "altitude": TRUTH["altitude"],
    "airspeed": TRUTH["airspeed"],
    "bank": TRUTH["bank"],
    "pitch": TRUTH["pitch"],
    "heading": TRUTH["heading"],
    "alpha": ("deg", "aero/alpha-deg", 1.0, 0.0),
    "beta": ("deg", "aero/beta-deg", 1.0, 0.0),
    "north": ("ft", "position/from-start-neu-n-ft", 1.0, 0.0),
    "east": ("ft", "position/from-start-neu-e-ft", 1.0, 0.0),
}


class Refused(Exception):
    """The flight cannot begin; the text goes to the other side."""


SET_UP = "`make fly` sets it up"


def load_jsbsim(step_s, model="lambda"):
    """Imports JSBSim of the version that the aircraft was tuned with, and
    loads its model: URV's own, or one that comes with JSBSim."""
    os.environ["JSBSIM_DEBUG"] = "0"
    here = Path(__file__).resolve().parent
    # JSBSim's module imports numpy for matrices, which this program does not
    # use; that import takes longer than settling the aircraft.
    spared = sys.modules.setdefault("numpy", types.ModuleType("numpy"))
    try:
        import jsbsim
    except ImportError as error:
        raise Refused(
            f"no Python module jsbsim ({error}); {SET_UP}") from error
    finally:
        if not hasattr(spared, "__version__"):
            del sys.modules["numpy"]
    for line in (here / "requirements.txt").read_text().splitlines():
        name, _, wanted = line.partition("==")
        # Hashes may follow the version.
        wanted = wanted.partition(" ")[0]
        if name == "jsbsim" and jsbsim.__version__ != wanted:
            raise Refused(
                f"jsbsim is {jsbsim.__version__}, must be {wanted};"
                f" {SET_UP}")
    fdm = jsbsim.FGFDMExec(
        jsbsim.get_default_root_dir() if model in AIRFRAMES else str(here))
    # To be set before the model is loaded, because loading fixes the servos'
    # lags and rates.
    fdm.set_dt(step_s)
    if not fdm.load_model(model):
        raise Refused("JSBSim does not load the aircraft")
    return fdm


class Times(NamedTuple):
    """The length of a tick, in us, and the other times in ticks."""

    tick: int
    frame: int
    scan: int
    shown: int

    @property
    def step(self):
        """Ticks in a step of JSBSim. One step ends with the frame, and one
        with the sensors' measurement."""
        whole = math.gcd(self.frame, self.scan)
        return max(ticks for ticks in range(1, whole + 1)
                   if whole % ticks == 0
                   and (ticks == 1 or ticks * self.tick <= LONGEST_STEP_US))


class Aircraft:
    """A settled aircraft, its servos' inputs and its sensors' outputs."""

    def __init__(self, servos, sensors, truth, shown, times, conditions=(),
                 faults=()):
        self.times = times
        # The record's values may be taken within a step. The further steps of
        # a frame are flown when both they and the sensors are known.
        self.ticks = times.step
        self.before, self.part = divmod(times.shown, self.ticks)
        self.first_steps = range(1, 1 + max(
            times.scan // self.ticks, self.before + (self.part > 0)))
        self.further_steps = range(
            len(self.first_steps), times.frame // self.ticks)
        self.conditions = dict(conditions)
        step_s = self.ticks * times.tick / 1e6
        model = conditions["airframe"] if "airframe" in conditions else None
        self.must_suit(model, faults)
        self.fdm = fdm = load_jsbsim(step_s, model or "lambda")
        self.tree = fdm.get_property_manager()
        self.airframe = Airframe(fdm, step_s) if model else None
        stands = "start" in conditions
        for name, value in (
                ("ic/terrain-elevation-ft", FIELD_FT),
                ("ic/h-sl-ft", FIELD_FT + (
                    STANDING_FT if stands else START_ALTITUDE_FT)),
                ("ic/vc-kts", 0.0 if stands else
                 AIRFRAMES.get(model, START_SPEED_KT)),
                ("ic/psi-true-deg", START_HEADING_DEG),
                ("fcs/mixture-cmd-norm", MIXTURE),
                ("plant/crashed", 0.0),
                ("plant/wheels", 0.0),
                ("radio/uplink-dbm", 0.0)):
            fdm[name] = value
        if not fdm.run_ic():
            raise Refused("JSBSim does not accept the initial condition")
        if self.airframe:
            self.trim(model)
        self.load_ballast()
        self.blow()

        self.servos = [self.node(SERVOS, *item)[0].set_double_value
                       for item in servos]
        self.sensors = self.readings(SENSORS, sensors)
        self.truth = self.readings(TRUTH, truth)
        self.shown = self.readings(SHOWN, shown)
        self.headings = [place for place, (name, _) in enumerate(shown)
                         if name == "heading"]
        self.bank = self.tree.get_node("attitude/phi-deg")
        self.altitude = self.tree.get_node("position/h-agl-ft")
        self.north = self.tree.get_node("position/from-start-neu-n-ft")
        self.east = self.tree.get_node("position/from-start-neu-e-ft")
        self.signal = self.tree.get_node("radio/uplink-dbm")
        self.crashed = self.tree.get_node("plant/crashed")
        self.brake = next((place for place, (name, _) in enumerate(servos)
                           if name == "brake"), None)
        self.is_tied = False
        self.wheels = [self.tree.get_node(f"gear/unit[{wheel}]/WOW")
                       for wheel in range(3)]
        self.standing = self.tree.get_node("plant/wheels")
        self.half_span = (fdm["metrics/bw-ft"] / 2.0 if self.airframe
                          else HALF_SPAN_FT)
        if stands:
            self.stand()
        elif not self.airframe:
            self.settle()
        self.must_be_sound()
        self.stir()
        paths = {name: path for name, (_, path) in SERVOS.items()}
        self.traits = Traits(
            self.tree, [paths[name] for name, _ in servos],
            *self.conditions["servos"]) if "servos" in conditions else None
        # The faults read the servos' speeds, which the traits above have set.
        self.faults = (Faults(self.tree, faults, paths) if faults else None)
        self.run_step = (self.broken_step if faults else
                         self.airframe.step if self.airframe else fdm.run)
        self.station = (self.north.get_double_value(),
                        self.east.get_double_value())
        self.count_from_here(truth, self.truth)
        self.count_from_here(shown, self.shown)
        self.measure_signal()
        self.last = (self.read(self.sensors), self.read_truth(),
                     self.read_shown())

    def must_suit(self, model, faults):
        """Another aircraft has fewer conditions, and no faults of servos."""
        if model is None:
            return
        if model not in AIRFRAMES:
            raise Refused(f"the plant has no airframe {model}; there are"
                          f" lambda, {', '.join(AIRFRAMES)}")
        unfit = [name for name in self.conditions if name not in FOR_AIRFRAMES]
        if unfit:
            raise Refused(f"airframe {model} and {unfit[0]} do not go"
                          " together")
        if faults:
            raise Refused(f"airframe {model} has no faults of servos")

    def trim(self, model):
        """Trims another aircraft in level flight."""
        try:
            self.airframe.trim()
        except RuntimeError as error:
            raise Refused(f"JSBSim finds no trim of {model}") from error

    def node(self, table, name, unit):
        """Property node, factor and offset of a requested item."""
        if name not in table:
            raise Refused(f"the plant has no {name}")
        has, path, *scale = table[name]
        if has != unit:
            raise Refused(f"the plant has {name} in {has}, not in {unit}")
        node = self.tree.get_node(path)
        if node is None:
            raise Refused(f"JSBSim has no property {path}")
        return (node, *scale)

    def readings(self, table, items):
        """The reader of each item, and the items with a factor or an
        offset."""
        nodes = [self.node(table, *item) for item in items]
        return ([node.get_double_value for node, *_ in nodes],
                [(place, *scale) for place, (_, *scale) in enumerate(nodes)
                 if scale != [1.0, 0.0]])

    @staticmethod
    def read(items):
        gets, scaled = items
        values = [get() for get in gets]
        for place, factor, offset in scaled:
            values[place] = values[place] * factor + offset
        return values

    def count_from_here(self, items, readings):
        """Counts north and east from the flight's beginning."""
        _, scaled = readings
        starts = dict(zip(("north", "east"), self.station))
        scaled += [(place, 1.0, -starts[name])
                   for place, (name, _) in enumerate(items) if name in starts]

    def read_shown(self):
        return self.read(self.shown)

    def between(self, earlier, later, part):
        """The shown values when that part of a step had passed."""
        between = [first + part * (last - first)
                   for first, last in zip(earlier, later)]
        for place in self.headings:
            first, last = earlier[place], later[place]
            turn = (last - first + 180.0) % 360.0 - 180.0
            between[place] = (first + part * turn) % 360.0
        return between

    def read_truth(self):
        self.standing.set_double_value(
            sum(wheel.get_double_value() for wheel in self.wheels))
        return self.read(self.truth)

    def load_ballast(self):
        if "ballast" in self.conditions:
            weight, aft = self.conditions["ballast"]
            self.fdm["inertia/pointmass-weight-lbs"] = weight
            self.fdm["inertia/pointmass-location-X-inches"] = CG_IN + aft

    def blow(self):
        """The wind blows from the beginning on."""
        if "wind" in self.conditions:
            heading, speed = self.conditions["wind"]
            for axis, share in (("north", math.cos), ("east", math.sin)):
                self.fdm[f"atmosphere/wind-{axis}-fps"] = (
                    -speed * FPS_PER_KT * share(math.radians(heading)))

    def stir(self):
        """Turbulence begins when the aircraft has settled. Without any wind
        there is none; JSBSim's own table would still make light one."""
        speed, = self.conditions.get("turbulence", (0.0,))
        if speed > 0.0:
            fdm = self.fdm
            for seed in self.conditions.get("seed", ()):
                fdm["atmosphere/randomseed"] = seed
            fdm["atmosphere/turb-type"] = DRYDEN
            fdm["atmosphere/turbulence/milspec/severity"] = SEVERITY
            fdm["atmosphere/turbulence/milspec/windspeed_at_20ft_AGL-fps"] = (
                speed * FPS_PER_KT)

    def tie(self):
        """Ropes hold the aircraft parked in a wind."""
        if "wind" in self.conditions:
            _, speed = self.conditions["wind"]
            self.fdm[ROPES] = ROPES_LB * (speed / ROPES_AT_KT) ** 2
            self.is_tied = self.brake is not None

    def untie(self):
        self.fdm[ROPES] = 0.0
        self.is_tied = False

    def must_be_sound(self):
        """The settled aircraft must have finite values, and must not have
        crashed."""
        if not math.isfinite(sum(
                sum(self.read(each))
                for each in (self.sensors, self.truth, self.shown))):
            raise Refused("the aircraft does not settle in these conditions:"
                          " JSBSim's numbers are not finite")
        if self.has_crashed():
            raise Refused("the aircraft does not settle in these conditions:"
                          " it touches the ground")

    def stand(self):
        """Starts the engine on the runway, with the brake on."""
        fdm = self.fdm
        self.tie()
        fdm["propulsion/magneto_cmd"] = 3
        fdm["propulsion/starter_cmd"] = 1
        fdm["servo/brake-pct"] = 100.0
        steps = 1e6 / (self.ticks * self.times.tick)
        for step in range(round(STAND_S * steps)):
            if step == round(START_ENGINE_S * steps):
                fdm["propulsion/starter_cmd"] = 0
            fdm.run()

    def settle(self):
        """Starts the engine and flies level until the state is steady.

        JSBSim's own trim does not converge with this engine. The aircraft is
        in trim with neutral servos, so the integrators end near zero and
        releasing them afterwards has no effect.
        """
        fdm = self.fdm
        servo = {name: self.tree.get_node(path)
                 for name, (_, path) in SERVOS.items()}
        fdm["propulsion/magneto_cmd"] = 3
        fdm["propulsion/starter_cmd"] = 1
        frame = self.times.frame * (self.times.tick / 1e6)
        aileron_trim = elevator_trim = throttle_trim = climb_trim = 0.0
        for count in range(round(SETTLE_S / frame)):
            if count == round(START_ENGINE_S / frame):
                fdm["propulsion/starter_cmd"] = 0
            height = START_ALTITUDE_FT + FIELD_FT - fdm["position/h-sl-ft"]
            speed = START_SPEED_KT - fdm["velocities/vc-kts"]

            turn = START_HEADING_DEG - fdm["attitude/psi-deg"]
            bank = max(-10.0, min(10.0, turn)) - fdm["attitude/phi-deg"]
            aileron_trim += 0.1 * bank * frame
            aileron = (0.25 * bank + aileron_trim
                       - 0.05 * DEG * fdm["velocities/p-rad_sec"])

            climb = max(-6.0, min(6.0, 0.2 * height))
            climb_trim += 0.02 * height * frame
            pitch = (2.4 + 0.5 * climb + climb_trim
                     - 0.3 * fdm["velocities/h-dot-fps"]
                     - fdm["attitude/theta-deg"])
            elevator_trim += 0.4 * pitch * frame
            elevator = (0.6 * pitch + elevator_trim
                        - 0.2 * DEG * fdm["velocities/q-rad_sec"])

            throttle_trim += 0.5 * speed * frame
            throttle = 50.0 + 3.0 * speed + throttle_trim

            for side in ("left", "right"):
                servo[side + "_aileron"].set_double_value(aileron)
                servo[side + "_elevator"].set_double_value(elevator)
            servo["throttle"].set_double_value(throttle)
            for _ in range(self.times.frame // self.ticks):
                fdm.run()

    def measure_signal(self):
        """Uplink at the aircraft's receiver: free space, 1 W, 450 MHz.

        The ground station is below the point where the flight begins.
        """
        north, east = self.station
        distance = KM_PER_FT * math.hypot(
            self.north.get_double_value() - north,
            self.east.get_double_value() - east,
            self.altitude.get_double_value())
        loss = 32.44 + 20.0 * math.log10(450.0 * max(distance, 0.01))
        self.signal.set_double_value(30.0 - loss)

    def has_crashed(self):
        """True if a wing tip or, with the gear broken, the belly touches."""
        altitude = self.altitude.get_double_value()
        # A value that is not finite is no crash: it is sent to the other side,
        # which ends the flight.
        if altitude <= BELLY_FT:
            return True
        if altitude > self.half_span:
            return False
        bank = math.radians(self.bank.get_double_value())
        return altitude < self.half_span * abs(math.sin(bank))

    def broken_step(self):
        self.faults.act(self.ticks)
        self.fdm.run()

    def begin(self, commands):
        """Holds the commands for a frame, and flies until the sensors are
        measured and the record's values are known: both are the result. The
        truth is that of the frame's beginning."""
        if self.crashed.get_double_value():
            return self.last
        if self.traits:
            commands = self.traits.obeyed(commands)
        for move, command in zip(self.servos, commands):
            move(command)
        if self.is_tied and commands[self.brake] < PARKED_BRAKE_PCT:
            self.untie()
        run, ticks = self.run_step, self.ticks
        before, part = self.before, self.part
        earlier = self.read_shown() if part and before == 0 else None
        for step in self.first_steps:
            run()
            if step * ticks == self.times.scan:
                self.measure_signal()
                sensors = self.read(self.sensors)
            if step == before:
                shown = earlier = self.read_shown()
            if part and step == before + 1:
                shown = self.between(earlier, self.read_shown(),
                                     part / ticks)
        if self.has_crashed():
            self.crashed.set_double_value(1.0)
            sensors, truth, shown = self.last
            self.last = (sensors, truth[:-1] + [1.0], shown)
        else:
            self.last = (sensors, self.last[1], shown)
        return self.last

    def end(self):
        """Flies to the frame's end, while the other side continues."""
        if not self.crashed.get_double_value():
            for _ in self.further_steps:
                self.run_step()
            sensors, _, shown = self.last
            self.last = (sensors, self.read_truth(), shown)

    def fly(self, commands):
        """Flies a whole frame; returns the same, with the truth at its end."""
        self.begin(commands)
        self.end()
        return self.last


class Commands:
    """Messages of fixed length from the connection.

    The connection is polled several times before this process sleeps: with two
    processors the other side's frame takes less time than a wake-up. Where the
    other side has no processor, polling fails and becomes rare.
    """

    def __init__(self, link, length):
        self.link = link
        self.length = length
        self.skips = self.to_skip = 0

    def look(self):
        """The available bytes, or None."""
        if self.to_skip:
            self.to_skip -= 1
            return None
        for _ in range(LOOKS):
            try:
                data = self.link.recv(self.length, socket.MSG_DONTWAIT)
            except BlockingIOError:
                continue
            self.skips //= 2
            return data
        self.to_skip = self.skips = min(2 * self.skips + 1, MOST_SKIPS)
        return None

    def __iter__(self):
        """Each message, up to the end of the connection."""
        while True:
            data = self.look()
            if data is None:
                data = self.link.recv(self.length)
            while data and len(data) < self.length:
                more = self.link.recv(self.length - len(data))
                if not more:
                    return
                data += more
            if not data:
                return
            yield data


def read_items(link):
    """The items that the other side sends and requests: {kind: [(name,
    unit)]}."""
    items = {"servo": [], "sensor": [], "truth": [], "shown": [], "time": [],
             "condition": [], "fault": []}
    with link.makefile("r", encoding="ascii", newline="\n") as lines:
        for line in lines:
            if line == "\n":
                return items
            kind, name, unit = line.rstrip("\n").split(",")
            items[kind].append((name, unit))
    raise Refused("the connection ended before the flight began")


def read_conditions(items):
    """The numbers of each condition by its name, and the airframe's name.
    """
    found = {}
    for name, values in items:
        if name == "airframe":
            if values != "lambda":
                found[name] = values
            continue
        if name not in CONDITIONS:
            raise Refused(f"the plant knows no condition {name}")
        found[name] = ([float(value) for value in values.split()]
                       if CONDITIONS[name] else [])
    return found


def serve(link):
    try:
        items = read_items(link)
        times = Times(**{name: int(value.split()[0])
                         for name, value in items["time"]})
        aircraft = Aircraft(items["servo"], items["sensor"], items["truth"],
                            items["shown"], times,
                            read_conditions(items["condition"]),
                            items["fault"])
    except Refused as refusal:
        link.sendall(f"{refusal}\n".encode())
        return
    link.sendall(b"ready\n")

    commands = struct.Struct(">%dd" % len(items["servo"]))
    state = struct.Struct(">%dd" % sum(
        len(items[kind]) for kind in ("sensor", "truth", "shown")))
    sensors, truth, shown = aircraft.last
    link.sendall(state.pack(*sensors, *truth, *shown))
    incoming = Commands(link, commands.size)
    for data in incoming:
        sensors, truth, shown = aircraft.begin(commands.unpack(data))
        if incoming.skips:
            # Sleeping at once leaves the processor to the other side.
            aircraft.end()
        link.sendall(state.pack(*sensors, *truth, *shown))
        if not incoming.skips:
            aircraft.end()


def main():
    # The other side handles an interrupt from the keyboard, or a request to
    # end that goes to both: this program ends when the connection does.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    # Standard output is reserved for the simulation's own report.
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    with socket.socket(fileno=int(sys.argv[1])) as link:
        try:
            serve(link)
        except ConnectionError:
            # The other side ended in the middle of a message.
            return


if __name__ == "__main__":
    main()
