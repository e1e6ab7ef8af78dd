# SPDX-License-Identifier: Apache-2.0
"""Measured signals of a manoeuvre, in ft, s and rad, at the frames (GND-61).

A frame without fresh words is a gap: its outputs count for nothing, and its
inputs are interpolated if the gap is short.
"""

from __future__ import annotations

import statistics
from dataclasses import dataclass, replace

import numpy
from scipy import interpolate, signal

from urv import faults, flights, packets

GRAVITY = 32.174
"""ft/s2, that of the accelerometers' g."""

FPS_PER_KT = 1.0 / 0.592484
SEA_LEVEL_DENSITY = 0.0023769
"""slug/ft3"""

LONGEST_GAP_S = 0.1

SMOOTH_FRAMES, SMOOTH_ORDER = 51, 3
"""Savitzky and Golay's filter of the airspeed: about 1 s."""

SENSORS = {
    "p": "roll_rate", "q": "pitch_rate", "r": "yaw_rate",
    "ax": "longitudinal_acceleration", "ay": "lateral_acceleration",
    "az": "vertical_acceleration",
    "alpha": "alpha", "beta": "beta", "phi": "roll_attitude",
    "theta": "pitch_attitude", "airspeed": "airspeed", "altitude": "altitude"}
"""Signals, each with its word of the downlink."""

SURFACES = {"aileron": ("left_aileron", "right_aileron"),
            "elevator": ("left_elevator", "right_elevator"),
            "rudder": ("left_rudder", "right_rudder")}

FACTORS = {"deg": numpy.radians(1.0), "deg/s": numpy.radians(1.0),
           "g": GRAVITY, "kt": FPS_PER_KT, "ft": 1.0}

ATTITUDE, RATES, ACCELERATIONS, AIRFLOW = (
    ("phi", "theta", "altitude"), ("p", "q", "r"), ("ax", "ay", "az"),
    ("alpha", "beta", "airspeed"))
"""Groups of sensors that share a delay."""

GROUPS = {"attitude": ATTITUDE, "rates": RATES,
          "accelerations": ACCELERATIONS, "airflow": AIRFLOW}


CHANNELS_LATE = {
    name: -statistics.mean(
        flights.sample_offset(f"gsc.downlink.{word}") for word in words)
    for name, words in (
        *((name, (word,)) for name, word in SENSORS.items()),
        *SURFACES.items())}
"""The delays with which `shifted` brings each signal to the beginning of its
scan. Delays that all signals share do not matter."""


@dataclass
class Segment:
    """The signals of one manoeuvre, or of a part of a flight, at equal steps.

    ax, ay and az are specific forces. airspeed is calibrated; density_ratio is
    the air's density over that at sea level.
    """

    times: numpy.ndarray
    signals: dict[str, numpy.ndarray]
    is_fresh: numpy.ndarray
    density_ratio: numpy.ndarray
    record: int = 0
    """Number of the record, from 0: sensors' errors are the record's."""

    def __getitem__(self, name: str) -> numpy.ndarray:
        return self.signals[name]

    @property
    def step(self) -> float:
        return packets.FRAME_S

    def splines(self, *names: str):
        """The spline through these signals, as rows, by time."""
        return interpolate.CubicSpline(
            self.times, numpy.array([self.signals[name] for name in names]),
            axis=1)

    def with_signals(self, **changed: numpy.ndarray) -> Segment:
        return replace(self, signals=self.signals | changed)


class Unusable(Exception):
    """A part of a record cannot be used; the text is the reason."""


def segment(flight: flights.Flight, begin: float, end: float,
            record: int = 0) -> Segment:
    """The signals from begin to end, in s of the record. Raises Unusable."""
    rows = numpy.flatnonzero(
        (flight.seconds >= begin - 1e-6) & (flight.seconds <= end + 1e-6))
    if len(rows) < 50:
        raise Unusable("shorter than 1 s")
    raw = {name: _sensor(flight, sensor)[rows]
           for name, sensor in SENSORS.items()}
    for name, sides in SURFACES.items():
        raw[name] = sum(_sensor(flight, side)[rows] for side in sides) / 2.0
    offset = _sensor(flight, "altitude_offset")[rows]
    has_words = ~numpy.isnan(sum(raw.values()) + offset)
    frames, is_exact = _frames(flight, rows, has_words)
    if (numpy.diff(frames) < 1).any():
        raise Unusable("its times do not rise by whole frames")
    if is_exact:
        # Rows without words have no frame of the aircraft.
        raw = {name: values[has_words] for name, values in raw.items()}
        offset, rows = offset[has_words], rows[has_words]
        has_words = has_words[has_words]
    times = (flight.seconds[rows[0]]
             + packets.FRAME_S * numpy.arange(frames[-1] + 1))
    is_fresh = numpy.zeros(len(times), bool)
    is_fresh[frames] = has_words
    known = times[is_fresh]
    if len(known) < 50 or max(
            known[0] - times[0], times[-1] - known[-1],
            numpy.diff(known).max()) > LONGEST_GAP_S + 1e-6:
        raise Unusable(f"a gap of more than {LONGEST_GAP_S} s")
    fresh_rows = is_fresh[frames]
    signals = {name: numpy.interp(times, known, values[fresh_rows])
               for name, values in raw.items()}
    # The vertical word is positive up.
    signals["az"] = -signals["az"]
    height = signals["altitude"] + numpy.interp(
        times, known, offset[fresh_rows])
    ratio = numpy.maximum(1.0 - 6.8756e-6 * height, 0.1) ** 4.2559
    found = Segment(times, signals, is_fresh, ratio, record)
    return shifted(found, CHANNELS_LATE) if is_exact else found


def _frames(flight, rows, has_words):
    """The frames of rows from the first one, and whether they are exact: those
    of the aircraft, of the rows with words, when the record has them."""
    exact = flight.aircraft_frames
    if exact is not None and has_words.any():
        frames = exact[rows][has_words]
        if not numpy.isnan(frames).any():
            return (frames - frames[0]).astype(int), True
    found = flight.seconds[rows]
    return numpy.rint(
        (found - found[0]) / packets.FRAME_S).astype(int), False


def _sensor(flight, name):
    values = flight.sensor(name)
    if values is None:
        raise faults.Refused(f"{faults.quoted(flight.path)}: the record has"
                             f" no column of {name}")
    unit = flights.records.item_of(f"{flight.downlink}.{name}").unit
    return values * FACTORS[unit]


def noise_of(values) -> float:
    """The standard deviation of white noise in a smooth signal, from its fourth
    differences. Their median takes no step of the signal for noise."""
    found = numpy.diff(values, 4)
    return float(numpy.median(abs(found)) / 0.6745 / numpy.sqrt(70.0))


def smooth_airspeed(part: Segment) -> Segment:
    """The segment with an airspeed that changes as slowly as that of an aircraft:
    the noise of a probe would be noise of all forces and moments."""
    return part.with_signals(airspeed=signal.savgol_filter(
        part["airspeed"], min(SMOOTH_FRAMES, (len(part.times) - 1) | 1),
        SMOOTH_ORDER))


def without_delays(part: Segment, known: dict[str, float]) -> Segment:
    """The segment without the known delays of groups of sensors."""
    return shifted(part, {name: delay for group, delay in known.items()
                          for name in GROUPS.get(group, ())})


def shifted(part: Segment, delays: dict[str, float]) -> Segment:
    """The segment with signals moved back by their delays, in s: a signal that
    came late shows its value at the right time."""
    changed = {}
    for name, delay in delays.items():
        if delay:
            changed[name] = part.splines(name)(part.times + delay)[0]
    return part.with_signals(**changed)
