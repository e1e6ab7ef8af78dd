# SPDX-License-Identifier: Apache-2.0
"""The control laws as linear systems, from the gains of URV.Law_Gains.

Degrees, feet, knots and seconds; servos in degrees and per cent. A law sees what
was scanned after the words of two frames ago had been held for 16 ms: two
frames of delay in each loop, besides those of servos and sensors, which are in
the aircraft's model. Limits, rounding and what is not linear (turns, the
airspeed's guard) are left out.
"""

from typing import NamedTuple

import control
import numpy
from law_gains import FRAME_S

DELAY = 2

# Degrees, or per cent, of a servo's word.
AILERON, ELEVATOR, RUDDER, LEVER = 0.01, 0.0125, 0.0125, 100 / 4095


class Law(NamedTuple):
    """From what is measured, and from references, to the servos."""

    A: numpy.ndarray
    B: numpy.ndarray
    C: numpy.ndarray
    D: numpy.ndarray
    inputs: tuple
    outputs: tuple

    def system(self):
        return control.ss(self.A, self.B, self.C, self.D, FRAME_S,
                          inputs=list(self.inputs),
                          outputs=list(self.outputs))


class Maker:
    """A law as equations of names: states next, outputs now."""

    def __init__(self, inputs):
        self.inputs = tuple(inputs)
        self.states = []
        self.next = {}
        self.now = {}

    def delayed(self, name):
        """The input of that many frames ago."""
        for place in range(DELAY):
            state = f"{name}-{place + 1}"
            self.states.append(state)
            self.next[state] = {
                name if place == 0 else f"{name}-{place}": 1.0}
        return f"{name}-{DELAY}"

    def state(self, name, **change):
        self.states.append(name)
        self.next[name] = {name: 1.0, **change}

    def law(self, outputs):
        names = [*self.states, *self.inputs]

        def row(terms):
            return [terms.get(name, 0.0) for name in names]

        state = numpy.array([row(self.next[name]) for name in self.states])
        out = numpy.array([row(self.now[name]) for name in outputs])
        count = len(self.states)
        return Law(state[:, :count], state[:, count:], out[:, :count],
                   out[:, count:], self.inputs, tuple(outputs))


def times(factor, terms):
    return {name: factor * value for name, value in terms.items()}


def plus(*many):
    total = {}
    for terms in many:
        for name, value in terms.items():
            total[name] = total.get(name, 0.0) + value
    return total


def lateral(of, attitude):
    """From bank, roll rate, yaw rate, wanted bank to ailerons and rudders."""
    maker = Maker(("roll_attitude", "roll_rate", "yaw_rate", "wanted_bank"))
    bank, p, r = (maker.delayed(name) for name in maker.inputs[:3])
    words = {p: -of.Roll_Damping}
    if attitude:
        error = {"wanted_bank": 1.0, bank: -1.0}
        maker.state("trim")
        maker.next["trim"] |= times(of.Roll_Integral_Gain / of.Per_Angle, error)
        words = plus(words, times(of.Roll_Gain, error), {"trim": 1.0})
    maker.now["roll"] = times(AILERON, words)
    turn = of.Turn_For_Bank / of.Per_Ten / 1_000
    maker.now["yaw"] = times(RUDDER * of.Yaw_Damping, {r: -1.0, bank: turn})
    return maker.law(("roll", "yaw"))


def longitudinal(of, mode):
    """From pitch, pitch rate, airspeed, altitude and the references to the
    elevators, the throttle and the wanted pitch: damping, attitude, or hold
    of altitude and airspeed, whose wanted pitch comes in by itself."""
    maker = Maker(("pitch_attitude", "pitch_rate", "airspeed", "altitude",
                   "wanted_pitch", "wanted_altitude"))
    pitch, q, speed, height = (
        maker.delayed(name) for name in maker.inputs[:4])
    words = {q: -of.Pitch_Damping}
    maker.now["throttle"] = {}
    maker.now["wanted"] = {}
    if mode != "damping":
        error = {"wanted_pitch": 1.0, pitch: -1.0}
        maker.state("trim")
        maker.next["trim"] |= times(
            of.Pitch_Integral_Gain / of.Per_Angle, error)
        words = plus(words, times(of.Pitch_Gain, error), {"trim": 1.0})
    maker.now["pitch"] = times(ELEVATOR, words)
    if mode == "hold":
        below = {"wanted_altitude": 1.0, height: -1.0}
        climb = times(2 * of.Climb_Gain / 1000, below)
        maker.states.append("smooth")
        share = 1 / of.Filter_Frames
        maker.next["smooth"] = {"smooth": 1 - share, height: 2 * share}
        rising = {height: 2.0, "smooth": -1.0}
        maker.state("height_trim")
        maker.next["height_trim"] |= times(
            of.Height_Integral_Gain / of.Per_Ten / of.Per_Climb,
            plus(climb, times(-1.0, rising)))
        by_climb = of.Pitch_For_Climb / of.Per_Hundred
        by_lag = of.Pitch_For_Lag / of.Per_Hundred
        maker.now["wanted"] = plus(
            {"height_trim": 1.0}, times(by_climb + by_lag, climb),
            times(-by_lag, rising))
        maker.state("power")
        maker.next["power"][speed] = (
            -32 * of.Speed_Integral_Gain / of.Per_Speed / 1000)
        maker.now["throttle"] = times(LEVER, plus(
            {speed: -32 * of.Speed_Gain, "power": 1.0},
            times(of.Speed_For_Climb, climb)))
    return maker.law(("pitch", "throttle", "wanted"))


def with_altitude(model):
    """The longitudinal model with the altitude for its climb."""
    A, B, C, D = model.A, model.B, model.C, model.D
    count = A.shape[0]
    A2 = numpy.block([[A, numpy.zeros((count, 1))],
                      [FRAME_S * C[3:4], numpy.ones((1, 1))]])
    B2 = numpy.vstack([B, FRAME_S * D[3:4]])
    C2 = numpy.block([[C[:3], numpy.zeros((3, 1))],
                      [FRAME_S * C[3:4], numpy.ones((1, 1))]])
    D2 = numpy.vstack([D[:3], FRAME_S * D[3:4]])
    return control.ss(A2, B2, C2, D2, FRAME_S)


def response(system, omega):
    """At each frequency the matrix from inputs to outputs."""
    return numpy.moveaxis(
        system(numpy.exp(1j * omega * FRAME_S), squeeze=False), 2, 0)


def broken(aircraft, law, where, omega, own=None):
    """The loop's response when it is cut at an output of the law, everything
    else closed. With own the law's input of that name is its other end, else
    it is the aircraft's."""
    G = response(aircraft, omega)
    K = response(law.system(), omega)
    measured = G.shape[1]
    servos = [law.outputs.index(name) for name in law.outputs[:2]]
    found = []
    for g, k in zip(G, K):
        from_sensors = k[servos, :measured]
        if own is None:
            place = law.outputs.index(where)
            others = [each for each in servos if each != place]
            through = from_sensors @ g
            # With the wanted pitch of the law itself, where there is one.
            if "wanted" in law.outputs:
                wanted = law.outputs.index("wanted")
                inner = law.inputs.index("wanted_pitch")
                through = through + numpy.outer(
                    k[servos, inner], k[wanted, :measured] @ g)
            rest = through[numpy.ix_(others, others)]
            loop = through[place, place] + through[place, others] @ (
                numpy.linalg.solve(numpy.eye(len(others)) - rest,
                                   through[others, place]))
        else:
            inner = law.inputs.index(own)
            closed = numpy.linalg.solve(
                numpy.eye(measured) - g @ from_sensors, g)
            loop = (k[law.outputs.index(where), :measured]
                    @ closed @ k[servos, inner])
        found.append(-loop)
    return numpy.array(found)


def closed_poles(aircraft, law):
    """The poles of aircraft and law together, in the plane of s."""
    names = law.outputs
    K = law.system()
    measured = aircraft.C.shape[0]
    A, B, C, D = K.A, K.B, K.C, K.D
    if "wanted" in names:
        wanted, inner = names.index("wanted"), law.inputs.index("wanted_pitch")
        A = A + numpy.outer(B[:, inner], C[wanted])
        C = C + numpy.outer(D[:, inner], C[wanted])
    k = control.ss(A, B[:, :measured], C[:2], D[:2, :measured], FRAME_S)
    whole = control.feedback(aircraft, k, sign=1)
    # A pole at zero is a frame of delay and no motion.
    moving = [pole for pole in whole.poles() if abs(pole) > 1e-9]
    return numpy.log(numpy.array(moving) + 0j) / FRAME_S


class Margins(NamedTuple):
    gain_db: float
    phase_deg: float
    crossing: float


def margins(loop, omega):
    """The least gain margin, up or down, the least phase margin, and where
    that one is, in rad/s."""
    magnitude, phase = numpy.abs(loop), numpy.unwrap(numpy.angle(loop))
    # A loop that is open everywhere has magnitude 0.
    log = numpy.log(numpy.maximum(magnitude, 1e-300))
    gain, least, where = numpy.inf, numpy.inf, numpy.nan
    for place in range(len(omega) - 1):
        if (log[place] > 0) != (log[place + 1] > 0):
            part = log[place] / (log[place] - log[place + 1])
            angle = phase[place] + part * (phase[place + 1] - phase[place])
            turned = (angle + numpy.pi) % (2 * numpy.pi)
            margin = numpy.degrees(min(turned, 2 * numpy.pi - turned))
            if margin < least:
                least, where = margin, omega[place]
        here, there = ((each - numpy.pi) / (2 * numpy.pi)
                       for each in (phase[place], phase[place + 1]))
        if numpy.floor(here) != numpy.floor(there):
            gain = min(gain, abs(20 * numpy.log10(magnitude[place])))
    return Margins(gain, least, where)
