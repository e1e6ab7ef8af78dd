# SPDX-License-Identifier: Apache-2.0
"""The plots of a report: a panel for each subject, all on one time axis, and
their numbers, packed (GND-14).

A series is sent as its words, with the scale of their values, without loss.
For the displayed time the browser draws the least and the most of the values
on each pixel, so that no peak is lost, however long the flight.
"""

from __future__ import annotations

import base64
import tempfile
import zlib
from typing import NamedTuple

import numpy

from urv import items, packets, verdicts

# Roles, for which the page has a colour and a dash. Cyan is for requested
# values; amber and red are for limits alone.
ASKED, TRUTH = "asked", "truth"
COLOURS = ("first", "second", "third", "fourth", "fifth")


class Trace(NamedTuple):
    """A series in a panel."""

    column: str
    label: str
    role: str
    is_step: bool = False


class Panel(NamedTuple):
    """A plot."""

    title: str
    unit: str
    traces: tuple
    note: str = ""
    limits: tuple = ()
    """Instead of those of the items: from warning low to warning high."""


def sensors(*names, roles=COLOURS):
    """Traces of words of the downlink; the flight gives the group."""
    return tuple(Trace(f"DOWNLINK.{name}", label_of("gsc.downlink", name),
                       role)
                 for name, role in zip(names, roles, strict=False))


def label_of(group, name):
    return items.COLUMNS[f"{group}.{name}"].label


def surface(title, *names):
    """Commands of the servos and the reported positions."""
    traces = [Trace(f"pwm.{name}", f"{label_of('pwm', name)}, command",
                    ASKED, is_step=True) for name in names[:1]]
    traces += [Trace(f"DOWNLINK.{name}", f"{label_of('pwm', name)}, position",
                     role)
               for name, role in zip(names, COLOURS, strict=False)
               if name != "steering"]
    if "steering" in names:
        traces.append(Trace("pwm.steering", "steering, command", "third",
                            is_step=True))
    return Panel(title, "deg", tuple(traces))


SWITCHES = "Switches"

BYTES_AT_ONCE = 3 << 18
"""A multiple of 3, so that the base64 texts of the parts can be joined."""

PANELS = (
    Panel("Sticks", "%", tuple(
        Trace(f"console.{name}", name, role, is_step=True)
        for name, role in zip(("roll", "pitch", "yaw", "throttle", "brake"),
                              COLOURS, strict=True))),
    Panel(SWITCHES, "", tuple(
        Trace(f"console.{each.name}", each.label, COLOURS[n % 5],
              is_step=True) for n, each in enumerate(items.SWITCHES, 1)),
        note="those that were thrown"),
    surface("Ailerons", "left_aileron", "right_aileron"),
    surface("Elevators", "left_elevator", "right_elevator"),
    surface("Rudders and nose wheel", "left_rudder", "right_rudder",
            "steering"),
    surface("Flaps", "left_flap_1", "right_flap_1", "left_flap_2",
            "right_flap_2"),
    Panel("Roll attitude", "deg", (
        *sensors("roll_attitude"),
        Trace("truth.bank_deg", "bank, true", TRUTH))),
    Panel("Pitch attitude", "deg", (
        *sensors("pitch_attitude"),
        Trace("truth.pitch_deg", "pitch, true", TRUTH))),
    Panel("Roll rate", "deg/s", sensors("roll_rate")),
    Panel("Pitch rate", "deg/s", sensors("pitch_rate")),
    Panel("Yaw rate", "deg/s", sensors("yaw_rate")),
    Panel("Altitude above the field", "ft", (
        *sensors("altitude"),
        Trace("truth.altitude_ft", "altitude, true", TRUTH))),
    Panel("Airspeed, calibrated", "kt", (
        *sensors("airspeed"),
        Trace("truth.airspeed_kt", "airspeed, true state", TRUTH))),
    Panel("Angle of attack", "deg", (
        *sensors("alpha"), Trace("truth.alpha_deg", "alpha, true", TRUTH))),
    Panel("Sideslip", "deg", (
        *sensors("beta"), Trace("truth.beta_deg", "beta, true", TRUTH))),
    Panel("Load factor", "g", sensors("vertical_acceleration")),
    Panel("Lateral acceleration", "g", sensors("lateral_acceleration")),
    Panel("Longitudinal acceleration", "g",
          sensors("longitudinal_acceleration")),
    Panel("Engine", "rev/min", sensors("rpm")),
    Panel("Throttle and brake at the servos", "%", (
        Trace("pwm.throttle", "throttle", "first", is_step=True),
        Trace("pwm.brake", "brake", "second", is_step=True))),
    Panel("Battery", "V", sensors("battery_volts")),
    Panel("Alternator", "V", sensors("alternator_volts")),
    Panel("Uplink signal at the aircraft", "dBm",
          sensors("uplink_signal_strength")),
    Panel("Messages in the last second", "1/s", (
        Trace("RATE.link.uplink_received", "up, received", "first"),
        Trace("RATE.link.downlink_received", "down, received", "second"),
        Trace("RATE.link.uplink_bad", "up, damaged", "third"),
        Trace("RATE.link.downlink_bad", "down, damaged", "fourth")),
        note="50 are sent each way"),
    Panel("Link, since the start", "messages", (
        Trace("link.uplink_scrapped", "up, given up", "first"),
        Trace("link.downlink_scrapped", "down, given up", "second"),
        Trace("link.gsc_resets", "resets, ground", "third"),
        Trace("link.mcs_resets", "resets, aircraft", "fourth"))),
    Panel("Age of the downlink", "ms", (
        Trace("AGE", "since fresh words came", "first"),),
        limits=(None, None, None, 1000.0 * verdicts.LONGEST_SILENCE_S)),
    Panel("Stick to servo", "ms", (
        Trace("LATENCY", "of each change that got there", "first"),),
        note="in whole frames of 20 ms",
        limits=(None, None, verdicts.LONGEST_LATENCY_MS, None)),
)


def column_of(trace, flight):
    """The trace's column in the flight."""
    return trace.column.replace("DOWNLINK", flight.downlink or "none")


def rate(flight, column):
    """The increase of a count in the last second, at each row; NaN where the row
    before that second is missing, or where the count began again."""
    seconds, count = flight.seconds, flight.columns[column]
    before = numpy.searchsorted(seconds, seconds - 1.0 + 1e-6) - 1
    first = numpy.maximum(before, 0)
    risen = count - count[first]
    is_known = (before >= 0) & (risen >= 0) & (
        seconds - seconds[first] <= 1.0 + 1.5 * packets.FRAME_S)
    return numpy.where(is_known, risen, numpy.nan)


class Pack:
    """Numbers of flights for the page, in one piece: compressed, in a nameless
    file, because they may exceed the memory."""

    def __init__(self, folder=None):
        self.file = tempfile.TemporaryFile(dir=folder)
        self.packer = zlib.compressobj(6)
        self.length = 0

    def add(self, values, kind):
        """Adds numbers; returns their begin, count and type."""
        kind_of = numpy.dtype(f"<{kind}")
        if kind_of.kind in "iu":
            # A record may have an age of months, which exceeds this type.
            room = numpy.iinfo(kind_of)
            values = numpy.clip(values, room.min, room.max)
        data = numpy.ascontiguousarray(values, dtype=kind_of).tobytes()
        # A typed array begins at a multiple of its numbers' size.
        data += bytes(-len(data) % 8)
        place = {"at": self.length, "many": len(values), "type": kind}
        self.file.write(self.packer.compress(data))
        self.length += len(data)
        return place

    def texts(self):
        """The text for the page, in parts."""
        self.file.write(self.packer.flush())
        self.file.seek(0)
        while part := self.file.read(BYTES_AT_ONCE):
            yield base64.b64encode(part).decode("ascii")


def series(flight, trace, pack, shift=0):
    """A series of a flight in the page's form; None when there is none.

    `at`, `many`, `type` locate the numbers, `per` and `zero` give their
    values: per * (number - zero). `gaps`: stale rows are gaps of it.
    """
    if trace.column == "AGE":
        if flight.downlink is None:
            return None
        age = flight.downlink_age_ms
        milliseconds = numpy.where(numpy.isnan(age), -1, numpy.rint(age))
        return {**pack.add(milliseconds, "i4"), "per": 1, "zero": 0,
                "missing": -1, "decimals": 0}
    if trace.column == "LATENCY":
        seconds, milliseconds = flight.latencies
        if not len(seconds):
            return None
        return {**pack.add(numpy.rint(milliseconds), "i4"), "per": 1,
                "zero": 0, "decimals": 0,
                "times": pack.add(seconds, "f8")}
    if trace.column.startswith("RATE."):
        column = trace.column[len("RATE."):]
        if column not in flight:
            return None
        per_second = rate(flight, column)
        return {**pack.add(numpy.nan_to_num(per_second, nan=-1), "i4"),
                "per": 1, "zero": 0, "missing": -1, "decimals": 0}
    column = column_of(trace, flight)
    if column not in flight:
        return None
    numbers = flight.columns[column]
    item = items.COLUMNS.get(column)
    if item is not None and item.is_scaled:
        fits = numpy.clip(numbers, 0, 0xFFFF)
        # Switches are above each other, with room between.
        per = item.per_word * (0.7 if item.unit == "on" else 1.0)
        return {**pack.add(fits, "u2"), "per": per,
                "zero": item.zero_word - shift / per,
                "gaps": column.startswith(f"{flight.downlink}."),
                "decimals": item.decimals + 1}
    if not column.startswith("truth."):
        return {**pack.add(numbers, "i4"), "per": 1, "zero": 0, "decimals": 0}
    # The truth has two or three decimals.
    return {**pack.add(numpy.rint(numbers * 1000), "i4"), "per": 0.001,
            "zero": 0, "decimals": 2}


def moved(flight, trace):
    """True if a switch was ever moved."""
    column = trace.column
    return column in flight and numpy.ptp(flight.columns[column]) > 0


def has_laws(flight):
    """True if the aircraft's laws were on, according to the record."""
    return any(column in flight and flight.columns[column].any()
               for column in ("laws.link", "laws.told"))


def note_of(panel, flights):
    """The note beside a panel's title."""
    if panel.title == SWITCHES and not any(map(has_laws, flights)):
        return (f"{panel.note}; laws off, or not recorded: switches of the"
                " laws are discretes only")
    return panel.note


def drawn(flights, pack):
    """The panels with contents, in the page's form."""
    found = []
    for panel in PANELS:
        traces, levels = [], []
        for trace in panel.traces:
            if panel.title == SWITCHES:
                if not any(moved(flight, trace) for flight in flights):
                    continue
                levels.append(trace.label)
            of_flights = [
                series(flight, trace, pack, max(len(levels) - 1, 0))
                for flight in flights]
            if any(of_flights):
                traces.append({
                    "label": trace.label, "role": trace.role,
                    "step": trace.is_step, "series": of_flights})
        if traces:
            found.append({
                "title": panel.title, "unit": panel.unit,
                "note": note_of(panel, flights),
                "levels": levels, "traces": traces,
                "limits": list(panel.limits or limits(panel))})
    return found


def limits(panel):
    """The limits of a panel whose items share them: they become bands."""
    found = set()
    for trace in panel.traces:
        item = items.COLUMNS.get(
            trace.column.replace("DOWNLINK", "gsc.downlink"))
        if item is not None and trace.role != ASKED:
            found.add((item.warning_low, item.caution_low, item.caution_high,
                       item.warning_high))
    only = found.pop() if len(found) == 1 else (None,) * 4
    return () if only == (None,) * 4 else only


def track(flights, pack):
    """East and north of each flight, dead reckoning and true, in ft."""
    found = []
    for flight in flights:
        one = {}
        if flight.reckoned_track is not None:
            one["reckoned"] = [
                {**pack.add(numpy.nan_to_num(axis, nan=-1e9), "f4"),
                 "missing": -1e9} for axis in flight.reckoned_track]
        if flight.has_all("truth.east_ft", "truth.north_ft"):
            one["truth"] = [
                pack.add(flight.columns[name], "f4")
                for name in ("truth.east_ft", "truth.north_ft")]
        found.append(one)
    return found


def timing(flight, pack):
    """Times of the rows, the stale rows, and the rows after missing ones."""
    return {"times": pack.add(flight.seconds, "f8"),
            "stale": pack.add(flight.is_stale, "u1"),
            "breaks": pack.add(flight.breaks, "u4")}
