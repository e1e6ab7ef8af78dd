# SPDX-License-Identifier: Apache-2.0
"""The page and the JSON of an identification (GND-63).

Like the report of a flight, one file that needs no network.
"""

from __future__ import annotations

import json
import math
from html import escape
from pathlib import Path

import numpy

from urv import report_page
from urv.identification import analysis, cautions, compatibility
from urv.identification.measurements import GRAVITY

OWN = Path(__file__).parent

DEG = 180.0 / math.pi
UNITS = {"alpha": ("deg", DEG), "beta": ("deg", DEG), "phi": ("deg", DEG),
         "theta": ("deg", DEG), "p": ("deg/s", DEG), "q": ("deg/s", DEG),
         "r": ("deg/s", DEG), "ay": ("g", 1.0 / GRAVITY),
         "az": ("g", 1.0 / GRAVITY), "aileron": ("deg", DEG),
         "elevator": ("deg", DEG), "rudder": ("deg", DEG)}

LABELS = {"alpha": "alpha", "beta": "beta", "phi": "bank",
          "theta": "pitch attitude", "p": "roll rate", "q": "pitch rate",
          "r": "yaw rate", "ay": "lateral acceleration",
          "az": "vertical acceleration, positive down",
          "aileron": "ailerons", "elevator": "elevators",
          "rudder": "rudders"}

SURFACES = {"longitudinal": ("elevator",), "lateral": ("aileron", "rudder")}


def as_json(result: analysis.Result, aircraft) -> str:
    """Everything but the signals. A number that is not known is null."""
    def number(value):
        return float(value) if math.isfinite(value) else None

    return json.dumps({
        "aircraft": aircraft.name,
        "level": analysis.LEVEL,
        "records": result.records,
        "cautions": cautions.of(result, aircraft),
        "rough_air": [known is not None and bool(known.is_rough)
                      for known in result.compatibility],
        "sensors": [
            None if known is None else {
                each.name: {
                    "unit": each.unit, "value": number(each.value),
                    "deviation": number(each.deviation),
                    "determined": bool(each.is_determined),
                    "applied": bool(each.is_applied),
                    "at_bound": bool(each.is_at_bound)}
                for each in known.found}
            for known in result.compatibility],
        "axes": {name: {
            "reason": axis.reason or None,
            "converged": axis.fit is not None and axis.fit.has_converged,
            "manoeuvres": [{
                "record": each.record,
                "begin_s": round(float(each.manoeuvre.begin), 3),
                "end_s": round(float(each.manoeuvre.end), 3),
                "found_by": each.manoeuvre.mark,
                "use": ("none" if each.segment is None else "validation"
                        if each.is_for_validation else "estimation"),
                "reason": each.reason or None,
                "inequality": each.inequality}
                for each in axis.flown],
            "derivatives": {each.name: {
                "value": number(each.value), "low": number(each.low),
                "high": number(each.high),
                "half_width_if_white": number(each.white_half_width),
                "equation_error": number(each.by_equation_error),
                "prior": each.prior, "determined": each.is_determined,
                "reason": each.reason or None}
                for each in axis.derivatives.values()}}
            for name, axis in result.axes.items()},
    }, indent=2, allow_nan=False) + "\n"


def page(result: analysis.Result, aircraft):
    """The text of the page, in parts."""
    names = ", ".join(escape(_shown(each)) for each in result.records)
    body = [
        "<header>\n<h1>Derivatives from flight</h1>\n"
        f"<p>Aircraft <b>{escape(aircraft.name)}</b>; records <b>{names}</b>"
        "</p>\n</header>\n<main>\n"]
    body.append(_cautions(cautions.of(result, aircraft)))
    body += [_axis_text(axis) for axis in result.axes.values()]
    body += [_sensors(known, record, len(result.compatibility))
             for record, known in enumerate(result.compatibility)]
    body.append(
        "<section id=\"plots\">\n<h2>Fits and residuals</h2>\n"
        "<noscript><p>The plots need JavaScript.</p></noscript>\n"
        "<p id=\"trouble\" hidden></p>\n<div id=\"panels\"></div>\n"
        "</section>\n" + EXPLANATION + "</main>\n")
    yield "".join((
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n"
        "<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\""
        f" content=\"{report_page.POLICY}\">\n"
        "<meta name=\"viewport\" content=\"width=device-width,"
        " initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        f"<title>Derivatives: {names}</title>\n<style>\n",
        (report_page.FOLDER / "report.css").read_text("utf-8"),
        "</style>\n</head>\n<body>\n", *body,
        "<script type=\"application/json\" id=\"data\">",
        report_page.script(_plots(result)), "</script>\n",
        "<script type=\"text/plain\" id=\"plotly\">", report_page.library(),
        "</script>\n<script>\n", (OWN / "page.js").read_text("utf-8"),
        "</script>\n</body>\n</html>\n"))


EXPLANATION = """\
<footer>
<p>Derivatives are per radian, of the body axes, with rates as p b/2V, q c/2V
and r b/2V; surfaces in the pilot's sense. Intervals are of 95 %, corrected for
coloured residuals; they contain the uncertainty of delays, of the airspeed and of the
drag's direction, and the difference of both methods. Prior values are for comparison
only. The fit of an output is Theil's inequality coefficient: 0 is exact, below 0.3 is
good.</p>
</footer>
"""


def _shown(path):
    return Path(path).name.encode("utf-8", "backslashreplace").decode("utf-8")


def _number(value, digits=4):
    return f"{value:.{digits}f}" if math.isfinite(value) else "\N{EN DASH}"


def _cautions(texts) -> str:
    if not texts:
        return ""
    rows = "".join(f"<p>{report_page.mark('caution')} {escape(each)}</p>\n"
                   for each in texts)
    return f"<section>\n<h2>Cautions</h2>\n{rows}</section>\n"


def _axis_text(axis: analysis.Axis) -> str:
    title = f"{axis.axis.capitalize()} derivatives"
    if axis.reason:
        return (f"<section class=\"axis\"><h2>{title}</h2>\n<p>"
                f"{report_page.mark('caution')} {escape(axis.reason)}</p>\n"
                "</section>\n")
    rows = []
    for each in axis.derivatives.values():
        level = "well" if each.is_determined else "caution"
        word = "determined" if each.is_determined else "not determined"
        prior = each.prior
        inside = ("" if prior is None or not math.isfinite(each.value) else
                  "yes" if each.low <= prior <= each.high else "no")
        shape = report_page.MARKS[level][0]
        rows.append(
            f"<tr><th scope=\"row\">{escape(each.name)}</th>"
            f"<td>{_number(each.value)}</td>"
            f"<td>{_number(each.low)} to {_number(each.high)}</td>"
            f"<td>{_number(each.by_equation_error)}</td>"
            f"<td>{'' if prior is None else _number(prior)}</td>"
            f"<td>{inside}</td>"
            f"<td><span class=\"mark {level}\">{shape}</span> {word}"
            f"{escape(': ' + each.reason if each.reason else '')}</td></tr>\n")
    converged = "" if axis.fit.has_converged else (
        f"<p>{report_page.mark('warning')} The estimate has not converged."
        "</p>\n")
    heads = "".join(f"<th scope=\"col\">{each}</th>" for each in (
        "derivative", "estimate", "95 % interval", "equation error", "prior",
        "prior inside", "data"))
    return (
        f"<section class=\"axis\">\n{converged}<div class=\"wide\"><table>\n"
        f"<caption>{title}</caption>\n<thead><tr>{heads}</tr></thead>\n"
        f"<tbody>\n{''.join(rows)}</tbody>\n</table></div>\n"
        f"{_manoeuvres(axis)}</section>\n")


def _manoeuvres(axis):
    rows = []
    for number, each in enumerate(axis.flown, 1):
        use = (f"not used: {each.reason}" if each.segment is None
               else "validation" if each.is_for_validation else "estimate")
        fits = "".join(
            f"<td>{_fit(each.inequality.get(name))}</td>"
            for name in axis.outputs)
        rows.append(
            f"<tr><th scope=\"row\">{number}</th><td>{each.record + 1}</td>"
            f"<td>{each.manoeuvre.begin:.2f} to {each.manoeuvre.end:.2f} s"
            f"</td><td>{escape(use)}</td>{fits}</tr>\n")
    heads = "".join(f"<th scope=\"col\">{each}</th>" for each in (
        "manoeuvre", "record", "time", "use",
        *(f"fit of {LABELS[name].split(',')[0]}" for name in axis.outputs)))
    return ("<div class=\"wide\"><table>\n<caption>Manoeuvres</caption>\n"
            f"<thead><tr>{heads}</tr></thead>\n<tbody>\n{''.join(rows)}"
            "</tbody>\n</table></div>\n")


def _fit(value):
    if value is None:
        return ""
    shown = f"{value:.3f}"
    return (shown if value < cautions.GOOD_INEQUALITY
            else f"{report_page.mark('caution')} {shown}")


def _sensors(known: compatibility.Compatibility | None, record, many) -> str:
    title = "Errors of the sensors" + (
        f", record {record + 1}" if many > 1 else "")
    if known is None:
        return (f"<section><h2>{title}</h2>\n<p>{report_page.mark('caution')}"
                " There is no usable manoeuvre.</p>\n</section>\n")
    rough = (
        f"<p>{report_page.mark('caution')} The air is rough: gusts hide scale"
        " factors and delays, and none is applied.</p>\n"
        if known.is_rough and not known.contradictions else "")
    rows = "".join(
        f"<tr><th scope=\"row\">{escape(each.name)}</th>"
        f"<td>{_bound(each)}{_number(each.value, 3)} {each.unit}</td>"
        f"<td>{_number(each.deviation, 3)} {each.unit}</td>"
        f"<td>{'yes' if each.is_determined else 'no'}</td>"
        f"<td>{'yes' if each.is_applied else 'no'}</td></tr>\n"
        for each in known.found)
    heads = "".join(f"<th scope=\"col\">{each}</th>" for each in (
        "error", "estimate", "standard deviation", "determined",
        "data corrected for it"))
    return (f"<section>\n{rough}<div class=\"wide\"><table>\n"
            f"<caption>{title}"
            f"</caption>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{rows}"
            "</tbody>\n</table></div>\n</section>\n")


def _bound(each):
    """The mark of an error that is beyond its bound."""
    if not each.is_at_bound:
        return ""
    sign = "&lt; " if each.value < 0.0 else "&gt; "
    return f"{report_page.mark('caution')} {sign}"


def _plots(result):
    """The signals of each plot. Manoeuvres follow each other, each at its own
    time; null is between them."""
    found = []
    for axis in result.axes.values():
        flown = [each for each in axis.flown if each.outputs is not None]
        if not flown:
            continue
        starts = _starts(flown)
        bands = [[start, start + float(
            each.segment.times[-1] - each.segment.times[0])]
            for each, start in zip(flown, starts, strict=True)
            if each.is_for_validation]
        for name in SURFACES[axis.axis]:
            found.append(_plot(
                f"{axis.axis}: {LABELS[name]}", name, bands, starts, flown,
                {"measured": ("first", [each.segment[name]
                                        for each in flown])}))
        for row, name in enumerate(axis.outputs):
            found.append(_plot(
                f"{axis.axis}: {LABELS[name]}", name, bands, starts, flown, {
                    "measured": ("faint", [
                        numpy.where(each.segment.is_fresh,
                                    each.segment[name], numpy.nan)
                        for each in flown]),
                    "computed": ("first", [each.outputs[row]
                                           for each in flown])}))
            found.append(_plot(
                f"residual of {LABELS[name]}", name, bands, starts, flown,
                {"measured less computed": ("second", [
                    each.residuals[row] for each in flown])}))
    return {"plots": found}


def _starts(flown):
    """The time at which each manoeuvre is drawn: that of its record, or after
    the manoeuvre before."""
    starts, end = [], 0.0
    for each in flown:
        times = each.segment.times
        start = max(float(times[0]), end)
        starts.append(start)
        end = start + float(times[-1] - times[0]) + 1.0
    return starts


def _plot(title, name, bands, starts, flown, traces):
    unit, factor = UNITS[name]
    x = []
    for each, start in zip(flown, starts, strict=True):
        x += [round(float(time - each.segment.times[0]) + start, 2)
              for time in each.segment.times] + [None]
    return {
        "title": title, "unit": unit, "bands": bands, "x": x,
        "traces": [{"label": label, "role": role, "y": [
            value for signal in signals
            for value in [*_rounded(signal * factor), None]]}
            for label, (role, signals) in traces.items()]}


def _rounded(values):
    return [round(float(value), 5) if math.isfinite(value) else None
            for value in values]
