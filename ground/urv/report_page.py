# SPDX-License-Identifier: Apache-2.0
"""The page of a report: one self-contained file (GND-14).

Drawn by plotly.js, from the wheel of PyPI's plotly: vector graphics, so that
it prints well, and zoom by mouse and touch. Compressed it is 1.5 MB, which the
browser unpacks. The page's policy forbids any address: it needs no network and
can send nothing.
"""

from __future__ import annotations

import base64
import importlib.util
import json
import zlib
from html import escape
from pathlib import Path

from urv import faults, flown_laws, panels, verdicts

FOLDER = Path(__file__).parent

POLICY = ("default-src 'none'; script-src 'unsafe-inline'; style-src"
          " 'unsafe-inline'; img-src data: blob:; base-uri 'none';"
          " form-action 'none'")

MARKS = {verdicts.WELL: ("\N{CHECK MARK}", "within limits"),
         verdicts.CAUTION: ("\N{BLACK UP-POINTING TRIANGLE}", "caution"),
         verdicts.WARNING: ("\N{BLACK SQUARE}", "warning")}

MOST_EXCEEDANCES = 100
"""In the table; a flight with more of them has another problem."""


def page(flights, events, summary, folder=None):
    """The text of the page, in parts."""
    flight = flights[0]
    pack = panels.Pack(folder)
    data = {
        "names": [shown_name(each) for each in flights],
        "timing": [panels.timing(each, pack) for each in flights],
        "panels": panels.drawn(flights, pack),
        "track": panels.track(flights, pack),
        "happened": happened(flight, events),
        "headings": [each.first_heading for each in flights],
    }
    quality = (summary or {}).get("flight_quality")
    answers = [
        verdicts.flown(flight, quality if isinstance(quality, dict) else None),
        verdicts.link(flight, summary, events), verdicts.limits(flight)]
    laws = [flown_laws.of(each) for each in flights]
    answers += [each.answer() for each in laws[:1] if each]
    other = None
    if len(flights) > 1:
        other = [verdicts.flown(flights[1], None),
                 verdicts.link(flights[1], None), verdicts.limits(flights[1])]
        # Beside those of the first flight, if it has any.
        other += [each.answer() if each else None
                  for each in laws[1:] if laws[0]]
    yield "".join((
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n"
        "<meta charset=\"utf-8\">\n"
        f"<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n"
        "<meta name=\"viewport\" content=\"width=device-width,"
        " initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        f"<title>Flight report: {named(flight)}</title>\n"
        "<style>\n", (FOLDER / "report.css").read_text("utf-8"),
        "</style>\n</head>\n<body>\n",
        head(flights, summary), summary_of(answers, other),
        exceedances(flight, events), PLOTS, foot(flights),
        f"<script type=\"application/json\" id=\"data\">{script(data)}"
        "</script>\n"))
    yield "<script type=\"text/plain\" id=\"numbers\">"
    yield from pack.texts()
    yield "</script>\n"
    yield (f"<script type=\"text/plain\" id=\"plotly\">{library()}"
           "</script>\n")
    yield "".join((
        "<script>\n", (FOLDER / "report.js").read_text("utf-8"),
        "</script>\n</body>\n</html>\n"))


def named(flight):
    """The name of its file, also one that is not UTF-8."""
    return escape(shown_name(flight))


def shown_name(flight):
    return flight.path.name.encode("utf-8", "backslashreplace").decode("utf-8")


def library():
    """plotly.js, compressed."""
    found = importlib.util.find_spec("plotly")
    if found is None:
        raise faults.Failed("the package plotly is missing:"
                            " scripts/setup.sh fly installs it")
    path = Path(found.origin).parent / "package_data" / "plotly.min.js"
    return base64.b64encode(
        zlib.compress(path.read_bytes(), 6)).decode("ascii")


def script(data):
    """JSON that cannot end the script, whatever names are in it."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False,
                      default=float)
    return text.replace("<", "\\u003c").replace("&", "\\u0026")


def seconds(value):
    return verdicts.number(value, 2, "s")


def head(flights, summary=None):
    """The title, the flights, and their missing parts."""
    missing = missing_frames(flights[0], summary)
    rows = []
    for letter, flight in zip("AB", flights, strict=False):
        mark = f"{letter}: " if len(flights) > 1 else ""
        cut = (f"; it was cut short: {escape(flight.cut_short)}"
               if flight.cut_short else "")
        if flight.rows < flight.frames:
            lacking = flight.frames - flight.rows
            cut += f"; {verdicts.counted(lacking, 'frame')} without a row"
        if flight is flights[0]:
            cut += "".join(f"; {escape(each)}" for each in missing)
        begin, end = flight.seconds[0], flight.seconds[-1]
        rows.append(
            f"<p>{mark}<b>{named(flight)}</b>: {flight.rows}"
            f" frames, {seconds(begin)} to {seconds(end)},"
            f" {len(flight.columns)} columns{cut}</p>\n")
    return f"<header>\n<h1>Flight report</h1>\n{''.join(rows)}</header>\n"


def missing_frames(flight, summary):
    """Frames missing in the record, and an early end, from the summary."""
    if not summary:
        return
    frames = summary.get("frames")
    if verdicts.is_number(frames) and frames > flight.frames:
        yield f"the summary has {frames} frames, the record {flight.frames}"
    if summary.get("unfinished"):
        yield ("the program was ended in flight: its summary is not that of"
               " the whole flight")


def mark(level):
    """A shape and a word: never colour alone."""
    shape, word = MARKS[level]
    return (f"<span class=\"mark {level}\" title=\"{word}\">{shape}"
            f"<span class=\"word\"> {word}</span></span>")


def summary_of(answers, other):
    """The answers, then the numbers below them."""
    parts = ["<main>\n<section id=\"summary\">\n"]
    for place, answer in enumerate(answers):
        compared = other[place] if other else None
        parts.append(
            f"<article class=\"{answer.level}\">\n"
            f"<h2>{escape(answer.question)}</h2>\n"
            f"<p class=\"answer\">{'A: ' if compared else ''}"
            f"{mark(answer.level)} {escape(answer.text)}</p>\n")
        if compared:
            parts.append(
                f"<p class=\"answer\">B: {mark(compared.level)}"
                f" {escape(compared.text)}</p>\n")
        parts.append("</article>\n")
    parts.append("</section>\n<section id=\"numbers-of-it\">\n")
    for place, answer in enumerate(answers):
        parts.append(table(answer, other[place] if other else None))
    parts.append("</section>\n")
    return "".join(parts)


def table(answer, compared):
    """Each number with its unit and its limit."""
    if not answer.lines and not (compared and compared.lines):
        return ""
    of_b = {line.name: line for line in compared.lines} if compared else {}
    names = list(dict.fromkeys(
        [line.name for line in answer.lines] + list(of_b)))
    of_a = {line.name: line for line in answer.lines}
    columns = ("<th scope=\"col\">A</th><th scope=\"col\">B</th>" if compared
               else "<th scope=\"col\">value</th>")
    rows = []
    for name in names:
        limit = (of_a.get(name) or of_b[name]).limit
        cells = cell(of_a.get(name))
        if compared:
            cells += cell(of_b.get(name))
        rows.append(f"<tr><th scope=\"row\">{escape(name)}</th>{cells}"
                    f"<td class=\"limit\">{escape(limit)}</td></tr>\n")
    return (f"<div class=\"wide\"><table>\n<caption>{escape(answer.title)}"
            "</caption>\n<thead><tr><th scope=\"col\">what</th>"
            f"{columns}<th scope=\"col\">limit</th></tr></thead>\n"
            f"<tbody>\n{''.join(rows)}</tbody>\n</table></div>\n")


def cell(line):
    if line is None:
        return "<td></td>"
    shown = f"{mark(line.level)} " if line.level != verdicts.WELL else ""
    return f"<td class=\"{line.level}\">{shown}{escape(line.value)}</td>"


def exceedances(flight, events):
    """The time of each exceedance, and the events around it."""
    found = flight.excursions
    if not found:
        return ""
    rows = []
    for each in found[:MOST_EXCEEDANCES]:
        decimals = each.item.decimals + 1
        near = verdicts.around(flight, events, each)
        rows.append(
            f"<tr data-begin=\"{each.span.begin:.3f}\""
            f" data-end=\"{each.span.end:.3f}\">"
            f"<td>{mark(each.level)}</td>"
            f"<th scope=\"row\">{escape(each.item.label)}</th>"
            f"<td><button type=\"button\">{seconds(each.span.begin)} to"
            f" {seconds(each.span.end)}</button></td>"
            "<td data-name=\"worst\">"
            + verdicts.number(each.worst, decimals, each.item.unit)
            + "</td><td data-name=\"limit\">"
            + verdicts.number(each.limit, decimals, each.item.unit)
            + f"</td><td class=\"around\">{escape('; '.join(near))}</td>"
            "</tr>\n")
    more = len(found) - MOST_EXCEEDANCES
    note = (f"<p>And {more} more, which the plots show.</p>\n"
            if more > 0 else "")
    return (
        "<section id=\"exceedances\">\n<h2>Times, and events around"
        " them</h2>\n<div class=\"wide\"><table>\n<thead><tr>"
        "<th scope=\"col\">level</th><th scope=\"col\">what</th>"
        "<th scope=\"col\">when</th><th scope=\"col\">worst</th>"
        "<th scope=\"col\">limit</th><th scope=\"col\">within 2 s of it</th>"
        f"</tr></thead>\n<tbody>\n{''.join(rows)}</tbody>\n</table></div>\n"
        f"{note}</section>\n")


def happened(flight, events):
    """The lines of the plot of events, one for each kind."""
    laws = flown_laws.of(flight)
    found = list(laws.happened()) if laws else []
    for event in events:
        found.append({
            "label": f"{event.node} {event.kind}", "level": "event",
            "spans": [[event.span.begin, event.span.end]],
            "text": f"{event.count} times"})
    gaps = [[each.begin, each.end] for each in flight.silences]
    if gaps:
        found.append({"label": "no fresh data", "level": "gap",
                      "spans": gaps, "text": ""})
    for level in (verdicts.CAUTION, verdicts.WARNING):
        by_item = {}
        for each in flight.exceedances:
            if each.level == level:
                by_item.setdefault(each.item.label, []).append(
                    [each.span.begin, each.span.end])
        found += [{"label": f"{label}, {level}", "level": level,
                   "spans": spans, "text": ""}
                  for label, spans in by_item.items()]
    return found


PLOTS = """\
<section id="plots">
<div id="bar">
<h2>The flight</h2>
<button type="button" id="whole">Whole flight</button>
<span id="range" role="status"></span>
<span class="hint">Drag across a plot: all of them zoom.</span>
</div>
<noscript><p>The plots need JavaScript.</p></noscript>
<p id="trouble" hidden></p>
<div id="panels"></div>
</section>
"""


def foot(flights):
    """An explanation of the report."""
    compared = ("<p>A is drawn with full lines, B with dashed ones.</p>\n"
                if len(flights) > 1 else "")
    stale = ("<p>Words of the downlink that are marked stale, and rows that"
             " are missing, are gaps: nothing is drawn over them. Bands are"
             " limits: amber where the pilot should look, red where the pilot"
             " must act.</p>\n")
    return f"<footer>\n{compared}{stale}</footer>\n</main>\n"
