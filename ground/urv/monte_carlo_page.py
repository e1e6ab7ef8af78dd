# SPDX-License-Identifier: Apache-2.0
"""The page of a campaign: the number of good flights, the confidence, and the
worst of them with the commands that fly them again. One file without any
script."""

import statistics
from html import escape
from pathlib import Path

from urv import monte_carlo_results, success
from urv.monte_carlo import HISTORIES

FOLDER = Path(__file__).parent
POLICY = ("default-src 'none'; style-src 'unsafe-inline'; base-uri 'none';"
          " form-action 'none'")

MOST_WORST = 20
BARS = 40

# A picture's size in its own units.
WIDTH, HEIGHT, FOOT = 480, 90, 16


def page(campaign, cargo_hash, flights, command):
    """The text of the page."""
    return "".join((
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n"
        "<meta charset=\"utf-8\">\n"
        f"<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n"
        "<meta name=\"viewport\" content=\"width=device-width,"
        " initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        f"<title>{len(flights)} flights: {escape(campaign.pilot)}</title>\n"
        "<style>\n", (FOLDER / "report.css").read_text("utf-8"),
        "</style>\n</head>\n<body>\n",
        head(campaign, cargo_hash, flights), "<main>\n",
        rates(campaign, flights), worst(flights, command),
        spreads(campaign, flights), measures(flights),
        "</main>\n</body>\n</html>\n"))


def head(campaign, cargo_hash, flights):
    # Flights with histories have drawn lengths; this is the longest.
    up_to = "up to " * (campaign.pilot == HISTORIES)
    return (
        f"<header>\n<h1>{len(flights)} flights by chance</h1>\n"
        f"<p>Pilot <b>{escape(campaign.pilot)}</b>,"
        f" {up_to}{campaign.seconds} s each, seeds {flights[0].seed} to"
        f" {flights[-1].seed}.</p>\n"
        f"<p>Simulation and aircraft: SHA-256 {cargo_hash}.</p>\n</header>\n")


def percent(rate):
    return f"{100.0 * rate:.2f} %"


def rows_of(cells):
    return "".join(
        "<tr>" + f"<th scope=\"row\">{row[0]}</th>"
        + "".join(f"<td>{cell}</td>" for cell in row[1:]) + "</tr>\n"
        for row in cells)


def table(caption, titles, cells):
    columns = "".join(f"<th scope=\"col\">{title}</th>" for title in titles)
    return (f"<div class=\"wide\"><table>\n<caption>{caption}</caption>\n"
            f"<thead><tr>{columns}</tr></thead>\n"
            f"<tbody>\n{rows_of(cells)}</tbody>\n</table></div>\n")


def rates(campaign, flights):
    """The numbers of good flights, with exact bounds."""
    def row(text, well, trials=len(flights)):
        least, most = success.clopper_pearson(well, trials)
        return (escape(text), f"{well} of {trials}", percent(well / trials),
                f"{percent(least)} to {percent(most)}")

    cells = [row(limit.text, sum(each.used[limit.name] <= 1.0
                                 for each in flights))
             for limit in success.limits(campaign.pilot)]
    cells.append(row("all of it", sum(each.is_success for each in flights)))
    sound = [each for each in flights
             if each.is_sound and "surfaces_named" in each.measured]
    if sound:
        cells.append(row(
            "no surface named as failed, of flights in which none fails",
            sum(not each.measured["surfaces_named"] for each in sound),
            len(sound)))
    return "<section id=\"rates\">\n" + table(
        "How many were well", ("what", "flights", "rate",
                               "95 % bounds, Clopper-Pearson"), cells
    ) + "</section>\n"


def worst(flights, command):
    """The flights nearest to a limit or beyond it."""
    chosen = sorted(flights, key=lambda each: (-each.worst, each.seed))
    cells = []
    for each in chosen[:MOST_WORST]:
        name = max(each.used, key=each.used.get)
        what = (escape(each.fault) if each.fault
                else f"{escape(name)}: {each.used[name]:.2f} of the limit")
        cells.append((str(each.seed), what,
                      f"<code>{escape(command(each.seed))}</code>"))
    return "<section id=\"worst\">\n" + table(
        "The worst flights, and the commands that fly them again",
        ("seed", "nearest to or beyond", "command"), cells) + "</section>\n"


def spreads(campaign, flights):
    """The share of each limit that the flights used."""
    parts = ["<section id=\"spreads\">\n<h2>How much of each limit was"
             " used</h2>\n"]
    for limit in success.limits(campaign.pilot):
        used = [each.used[limit.name] for each in flights]
        parts.append(f"<figure><figcaption>{escape(limit.text)}</figcaption>"
                     f"{histogram(used)}</figure>\n")
    return "".join(parts) + "</section>\n"


def histogram(values):
    """Bars from none to twice the limit; values beyond are in the last."""
    counts = [0] * BARS
    for value in values:
        counts[min(BARS - 1, int(value * BARS / 2.0))] += 1
    step, most = WIDTH / BARS, max(counts)
    bars = "".join(
        f"<rect x=\"{place * step:.1f}\" width=\"{step - 1:.1f}\""
        f" y=\"{HEIGHT * (1 - count / most):.1f}\""
        f" height=\"{HEIGHT * count / most:.1f}\"><title>{count}</title>"
        "</rect>" for place, count in enumerate(counts) if count)
    line = (f"<line x1=\"{WIDTH / 2}\" x2=\"{WIDTH / 2}\" y1=\"0\""
            f" y2=\"{HEIGHT}\" stroke=\"currentColor\"/>")
    words = "".join(
        f"<text x=\"{place}\" y=\"{HEIGHT + FOOT - 3}\" font-size=\"12\""
        f" text-anchor=\"{anchor}\" fill=\"currentColor\">{text}</text>"
        for place, anchor, text in (
            (0, "start", "0"), (WIDTH / 2, "middle", "limit"),
            (WIDTH, "end", "twice, or more")))
    return (f"<svg viewBox=\"0 0 {WIDTH} {HEIGHT + FOOT}\" width=\"{WIDTH}\""
            " role=\"img\" aria-label=\"histogram\" fill=\"currentColor\">"
            f"{bars}{line}{words}</svg>")


def measures(flights):
    """The least, middle and greatest of each measure."""
    cells = []
    for part in ("measured", "drawn"):
        for name in monte_carlo_results.names(flights, part):
            values = sorted(
                value for each in flights
                if (value := getattr(each, part).get(name)) is not None)
            if values:
                cells.append((
                    escape(name), *(f"{value:.6g}" for value in (
                        values[0], statistics.median(values),
                        values[min(len(values) - 1,
                                   len(values) * 95 // 100)], values[-1]))))
    return "<section id=\"measures\">\n" + table(
        "Measured and drawn values",
        ("what", "least", "median", "95 %", "most"), cells) + "</section>\n"
