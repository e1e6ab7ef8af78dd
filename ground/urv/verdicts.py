# SPDX-License-Identifier: Apache-2.0
"""The answers at the head of a report: was it flown well, was the link well,
what was out of limits (GND-14).

Each number has its unit and its limit. A flight was flown well when
the pilot kept to the field's tolerances for such manoeuvres (FAA Airman
Certification Standards: 100 ft, 10 kt, 10 deg of heading, 5 deg of bank) and
nothing reached a warning's limit. A link was well that delivered nearly all,
was never silent for long, and as quick as the design says.
"""

from __future__ import annotations

import bisect
from dataclasses import dataclass

import numpy

from urv import flights, items

WELL, CAUTION, WARNING = "well", "caution", "warning"

# Beyond these it is a warning.
DELIVERED_AT_LEAST = 99.0
LONGEST_SILENCE_S = 0.5
# From the console's change to the servos without faults (docs/design.md).
LONGEST_LATENCY_MS = 70.0
FRAMES_ON_THE_WAY = 4

SHOWN_SILENCE_S = 0.05
MOST_AROUND = 8

# Rows of flight_quality: name, text, unit, limit on both sides.
QUALITY = (
    ("altitude_rms_ft", "altitude in holds, RMS off", "ft", 100.0),
    ("altitude_max_ft", "altitude in holds, most off", "ft", 100.0),
    ("airspeed_rms_kt", "airspeed in holds, RMS off", "kt", 10.0),
    ("airspeed_max_kt", "airspeed in holds, most off", "kt", 10.0),
    ("bank_rms_deg", "bank in holds, RMS off", "deg", 5.0),
    ("bank_max_deg", "bank in holds, most off", "deg", 5.0),
    ("turn_altitude_rms_ft", "altitude in turns, RMS off", "ft", 100.0),
    ("turn_altitude_max_ft", "altitude in turns, most off", "ft", 100.0),
    ("climb_ft", "climb", "ft", None),
    ("final_altitude_error_ft", "altitude at the end, off", "ft", 100.0),
    ("final_airspeed_error_kt", "airspeed at the end, off", "kt", 10.0),
    ("final_bank_error_deg", "bank at the end, off", "deg", 5.0),
    ("final_heading_error_deg", "heading at the end, off", "deg", 10.0),
)

# The aircraft's items for the quality of the flight.
FLOWN = ("altitude", "airspeed", "alpha", "beta", "vertical_acceleration",
         "roll_attitude", "pitch_attitude")

WAYS = (("uplink", "commands up"), ("downlink", "data down"))
TAKEN_BY = {"uplink": "mcs", "downlink": "gsc"}
"""The node that receives each direction."""
REFUSED = "block_refused"


@dataclass(frozen=True)
class Line:
    """A number with its unit and its limit, for people."""

    name: str
    value: str
    limit: str
    level: str = WELL


@dataclass(frozen=True)
class Answer:
    """The answer to one of the questions."""

    question: str
    title: str
    level: str
    text: str
    lines: list


def worst(levels):
    """The worst of some levels."""
    levels = set(levels)
    return next((level for level in (WARNING, CAUTION) if level in levels),
                WELL)


def number(value, decimals, unit=""):
    """A number with its unit; a zero has no sign."""
    text = f"{value:.{decimals}f}"
    if float(text) == 0:
        text = text.lstrip("-")
    text = text.replace("-", "\N{MINUS SIGN}")
    return f"{text}\N{NO-BREAK SPACE}{unit}" if unit else text


def limits_of(item):
    """In words: "55 to 110 kt, warning 48 to 120"."""

    def between(low, high):
        if low is None and high is None:
            return ""
        if low is None:
            return f"at most {number(high, places(high))}"
        if high is None:
            return f"at least {number(low, places(low))}"
        return f"{number(low, places(low))} to {number(high, places(high))}"

    def places(limit):
        return 0 if limit == int(limit) else 1

    caution = between(item.caution_low, item.caution_high)
    warning = between(item.warning_low, item.warning_high)
    if not caution and not warning:
        return "no limit"
    text = f"{caution or warning}\N{NO-BREAK SPACE}{item.unit}"
    return f"{text}; warning {warning}" if caution and warning else text


def flown(flight, quality):
    """Was it flown well?"""
    lines = []
    if quality:
        lines += quality_lines(quality)
    for name in FLOWN:
        values = flight.sensor(name)
        if values is None or numpy.all(numpy.isnan(values)):
            continue
        item = items.COLUMNS[f"{flight.downlink}.{name}"]
        low, high = numpy.nanmin(values), numpy.nanmax(values)
        level = worst([item.level(low) or WELL, item.level(high) or WELL])
        decimals = item.decimals
        lines.append(Line(
            item.label, f"{number(low, decimals)} to"
            f" {number(high, decimals, item.unit)}", limits_of(item), level))
    level = worst(line.level for line in lines)
    if not lines:
        text = "Unknown: the record has no words of the downlink."
        level = CAUTION
    elif level == WELL:
        text = "Yes: everything stayed within its limits."
    else:
        beyond = [line.name for line in lines if line.level == level]
        text = (f"{'With remarks' if level == CAUTION else 'No'}: "
                f"{'; '.join(beyond)}.")
    if lines and not quality:
        text += (" The pilot's targets are unknown (no flight_quality in a"
                 " summary): only limits are judged.")
    return Answer("Was it flown well?", "Flight quality", level, text, lines)


def quality_lines(quality):
    """The summary's values of the simulated pilot."""
    crashed = quality.get("crashed")
    if crashed is not None:
        at = quality.get("crashed_at_s")
        yield Line("crashed", "no" if not crashed else "yes" + (
            f", at {number(at, 2, 's')}" if is_number(at) else ""),
            "no", WARNING if crashed else WELL)
    level = quality.get("ended_level")
    if level is not None:
        yield Line("ended level, within 30 ft of the wanted altitude",
                   "yes" if level else "no", "yes",
                   WELL if level else WARNING)
    for name, label, unit, limit in QUALITY:
        value = quality.get(name)
        if is_number(value):
            yield Line(
                label, number(value, 2, unit),
                "no limit" if limit is None else
                f"at most {number(limit, 0, unit)}",
                WARNING if limit is not None and abs(value) > limit else WELL)
    for name, label in (("bank_left_deg", "steepest bank to the left"),
                        ("bank_right_deg", "steepest bank to the right")):
        value = quality.get(name)
        if is_number(value):
            roll = items.COLUMNS["gsc.downlink.roll_attitude"]
            yield Line(
                label, number(value, 1, "deg"),
                f"at most {number(roll.caution_high, 0)} deg;"
                f" warning {number(roll.warning_high, 0)}",
                roll.level(value) or WELL)


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def refused_blocks(events, summary):
    """The number of blocks that each node has refused: received, but not from
    its peer. From the events, or from the summary, which a partition has only
    of itself."""
    found = dict.fromkeys(TAKEN_BY.values(), 0)
    for event in events:
        if event.kind == REFUSED and event.node in found:
            found[event.node] += event.count
    if any(found.values()) or not summary:
        return found
    of_link, of_log = summary.get("link"), summary.get("events")
    for way, node in TAKEN_BY.items():
        if isinstance(of_log, dict):
            found[node] = of_log.get(f"{node}.{REFUSED}", 0)
        if isinstance(of_link, dict) and f"{way}_received" in of_link:
            found[node] = of_link.get("blocks_refused", found[node])
    return {node: many if is_number(many) else 0
            for node, many in found.items()}


def link(flight, summary, events=()):
    """Was the link well?"""
    lines = []
    refused = refused_blocks(events, summary)
    last = {name: int(flight.columns[f"link.{name}"][-1])
            for name in (f"{way}_{count}" for way, _ in WAYS
                         for count in ("sent", "received", "bad", "scrapped"))
            if f"link.{name}" in flight}
    for way, label in WAYS:
        sent, received = last.get(f"{way}_sent"), last.get(f"{way}_received")
        if received is not None:
            # One a frame; the first ones and the last are in transit.
            taken = max(0, received - refused[TAKEN_BY[way]])
            share = min(100.0, 100.0 * taken / max(
                flight.frames - FRAMES_ON_THE_WAY, 1))
            lines.append(Line(
                f"delivery of {label}",
                f"{number(share, 2, '%')} of {flight.frames} frames",
                f"at least {number(DELIVERED_AT_LEAST, 0, '%')}",
                WELL if share >= DELIVERED_AT_LEAST else WARNING))
        if refused[TAKEN_BY[way]]:
            lines.append(Line(
                f"{label}, refused: another key or format, or not the peer's",
                counted(refused[TAKEN_BY[way]], "block"), "none", WARNING))
        if sent is not None:
            lines.append(Line(f"{label}, sent, with repeats",
                              f"{sent} messages", "no limit"))
        for count, words in (("bad", "came damaged"),
                             ("scrapped", "given up")):
            many = last.get(f"{way}_{count}")
            if many is not None:
                lines.append(Line(
                    f"{label}, {words}", counted(many, "message"), "none",
                    CAUTION if many else WELL))
    for node, label in (("gsc", "ground"), ("mcs", "aircraft")):
        name = f"link.{node}_resets"
        if name in flight:
            many = int(flight.columns[name][-1])
            lines.append(Line(f"resets of the link, {label}", str(many),
                              "none", CAUTION if many else WELL))
    if flight.downlink:
        silence = max(flight.silences, key=lambda each: each.seconds,
                      default=None)
        seconds = silence.seconds if silence else 0.0
        lines.append(Line(
            "longest time without fresh data", number(seconds, 2, "s") + (
                f", at {number(silence.begin, 2, 's')}" if silence else ""),
            f"at most {number(LONGEST_SILENCE_S, 1, 's')}",
            WARNING if seconds > LONGEST_SILENCE_S
            else CAUTION if silence else WELL))
    if flight.lost_frames is not None:
        lines.append(Line(
            "frames of the aircraft that did not come, by their numbers",
            counted(flight.lost_frames, "frame"), "no limit"))
    lines += round_trip_lines(summary)
    lines += latency_lines(flight, summary)
    if not lines:
        return Answer("Was the link well?", "Link", CAUTION,
                      "Unknown: the record has no data of it.", [])
    level = worst(line.level for line in lines)
    beyond = [line.name for line in lines if line.level == level]
    text = {WELL: "Yes: nothing was lost and nothing came late.",
            CAUTION: "With remarks: " + "; ".join(beyond) + ".",
            WARNING: "No: " + "; ".join(beyond) + "."}[level]
    return Answer("Was the link well?", "Link", level, text, lines)


def round_trip_lines(summary):
    """A partition's measurements of the line."""
    counts = summary.get("link") if summary else None
    times = counts.get("round_trip_us") if isinstance(counts, dict) else None
    if not isinstance(times, dict) or not times.get("measured"):
        return
    for name, field in (("median", "median"), ("at most", "max")):
        if is_number(times.get(field)):
            yield Line(f"round trip of the line, {name}",
                       number(times[field] / 1000, 1, "ms"), "no limit")
    late = counts.get("late_answers")
    if is_number(late):
        yield Line("answers after the board had given up",
                   counted(late, "message"), "none",
                   CAUTION if late else WELL)


def latency_lines(flight, summary):
    """From the console to the servos: the exact one of the summary, or that of
    the record, in whole frames."""
    limit = f"at most {number(LONGEST_LATENCY_MS, 0, 'ms')}"
    latency = summary.get("latency_ms") if summary else None
    if isinstance(latency, dict):
        named = [(name, latency.get(field)) for name, field in (
            ("median", "median"), ("99th percentile", "p99"),
            ("at most", "max"))]
    else:
        _, milliseconds = flight.latencies
        if not len(milliseconds):
            return
        named = [("median, in whole frames", numpy.median(milliseconds)),
                 ("at most, in whole frames", numpy.max(milliseconds))]
    for name, value in named:
        if is_number(value):
            yield Line(f"stick to servo, {name}", number(value, 1, "ms"),
                       limit, CAUTION if value > LONGEST_LATENCY_MS else WELL)


def limits(flight):
    """The verdict on values out of limits."""
    found = flight.excursions
    warnings = sum(each.level == WARNING for each in found)
    cautions = len(found) - warnings
    if not found:
        text = ("Nothing: every value stayed within its limits."
                if flight.downlink else
                "Unknown: the record has no words of the downlink.")
        level = WELL if flight.downlink else CAUTION
    else:
        names = list(dict.fromkeys(each.item.label for each in found))
        text = (f"{counted(warnings, 'warning')},"
                f" {counted(cautions, 'caution')}: {', '.join(names)}.")
        level = WARNING if warnings else CAUTION
    return Answer("What was out of limits?", "Limits", level, text, [])


def counted(many, what):
    return f"{many} {what}{'' if many == 1 else 's'}"


def around(flight, events, exceedance):
    """The occurrences close to it, in words, in the order of time."""
    span = exceedance.span
    first, last = span.begin - flights.CLOSE_S, span.end + flights.CLOSE_S
    found = []

    def close(at):
        return first <= at <= last

    def near(ordered, time_of):
        """Those in the span; a hostile record may have a million."""
        return ordered[bisect.bisect_left(ordered, first, key=time_of):
                       bisect.bisect_right(ordered, last, key=time_of)]

    for event in events:
        times = dict.fromkeys([event.span.begin, event.span.end])
        found += [(at, f"{event.node} {event.kind}"
                   + (f" (one of {event.count})" if event.count > 1 else ""))
                  for at in times if close(at)][:1]
    silences = flight.silences[
        bisect.bisect_left(flight.silences, first, key=lambda each: each.end):
        bisect.bisect_right(flight.silences, last,
                            key=lambda each: each.begin)]
    for silence in silences:
        if silence.is_close_to(span) and silence.seconds > SHOWN_SILENCE_S:
            found.append((silence.begin, "no fresh data for "
                          + number(silence.seconds, 2, "s")))
    for other in near(flight.excursions, lambda each: each.span.begin):
        if other.item.name != exceedance.item.name:
            found.append((other.span.begin,
                          f"{other.item.label} {other.level}"))
    found += [(at, change) for at, change in near(
        flight.switch_changes, lambda each: each[0])]
    texts = [f"{number(at, 2, 's')} {what}"
             for at, what in dict.fromkeys(sorted(found))]
    if len(texts) > MOST_AROUND:
        texts[MOST_AROUND:] = [f"and {len(texts) - MOST_AROUND} more"]
    return texts
