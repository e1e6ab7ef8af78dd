# SPDX-License-Identifier: Apache-2.0
"""The plot of test cards: each input over time, and its spectrum (FTI-7).

One file of HTML that needs no network and no script.
"""

from html import escape

import numpy

from urv import cards

WIDTH, HEIGHT, EDGE = 640, 170, 46
COLOURS = ("#1f6feb", "#d1242f", "#1a7f37", "#9a6700", "#8250df", "#57606a")
MOST_HZ = 12.0
SHORTEST = 500
"""Frames of a spectrum, with zeros after a shorter input."""
STYLE = ("body{font:15px sans-serif;max-width:46rem;margin:1rem auto;"
         "padding:0 1rem}svg{width:100%;height:auto}"
         "text{font-size:12px;fill:#57606a}:root{color-scheme:light dark}"
         # The same hues, light on dark.
         "@media(prefers-color-scheme:dark){svg,span{"
         "filter:invert(1) hue-rotate(180deg)}}")


def page(deck, name):
    """The text of the page."""
    return (
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        f"<title>Test cards: {escape(name)}</title><style>{STYLE}</style>"
        f"</head>\n<body><h1>Test cards: {escape(name)}</h1>\n"
        + "".join(_card(each) for each in deck) + "</body></html>\n")


def spectrum(values):
    """Amplitudes by frequency in Hz, from one period in the input's time or
    1 Hz: a slower sine is hardly told from a constant."""
    size = max(len(values), SHORTEST)
    hertz = numpy.fft.rfftfreq(size, 1 / cards.FRAMES_PER_S)
    sizes = 2 * abs(numpy.fft.rfft(values, size)) / len(values)
    shown = hertz >= min(1, cards.FRAMES_PER_S / len(values))
    return hertz[shown], sizes[shown]


def _card(card):
    signals = card.signals()
    shown = {}
    for surface, values in signals.items():
        place = "" if card.place == "servo" else f" {card.place}"
        shown.setdefault(values.tobytes(), (values, []))[1].append(
            surface.replace("_", " ") + place)
    groups = list(shown.values())
    key = ", ".join(
        f"<span style=\"color:{COLOURS[place]}\">{' and '.join(names)}</span>"
        for place, (_, names) in enumerate(groups))
    times = [(numpy.arange(len(values)) / cards.FRAMES_PER_S, values)
             for values, _ in groups]
    bands = []
    for values, _ in groups:
        hertz, sizes = spectrum(values)
        bands.append((hertz[hertz <= MOST_HZ], sizes[hertz <= MOST_HZ]))
    title = escape(card.name or card.kind)
    unit = card.unit(card.surfaces[0])
    return (f"<h2>Slot {card.slot}: {title}</h2>\n<p>{key}</p>\n"
            + _plot(times, "s", unit) + _plot(bands, "Hz", unit))


def _plot(lines, across, up):
    least = min(0.0, *(float(y.min()) for _, y in lines))
    most = max(0.0, *(float(y.max()) for _, y in lines)) or 1.0
    right = max(float(x[-1]) for x, _ in lines) or 1.0

    def place(x, y):
        return (EDGE + x / right * (WIDTH - EDGE - 30),
                10 + (most - y) / (most - least) * (HEIGHT - 40))

    parts = [f"<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\">"]
    for y in sorted({least, 0.0, most}):
        _, at = place(0, y)
        parts.append(
            f"<line x1=\"{EDGE}\" x2=\"{WIDTH - 30}\" y1=\"{at:.1f}\""
            f" y2=\"{at:.1f}\" stroke=\"#d0d7de\"/><text x=\"{EDGE - 4}\""
            f" y=\"{at + 4:.1f}\" text-anchor=\"end\">{y:.2f}</text>")
    parts.append(f"<text x=\"4\" y=\"{HEIGHT - 6}\">{up}</text>")
    for part in range(5):
        x = right * part / 4
        at, _ = place(x, 0)
        parts.append(f"<text x=\"{at:.1f}\" y=\"{HEIGHT - 6}\""
                     f" text-anchor=\"middle\">{x:.3g} {across}</text>")
    for colour, (xs, ys) in zip(COLOURS, lines, strict=False):
        points = " ".join("{:.1f},{:.1f}".format(*place(x, y))
                          for x, y in zip(xs.tolist(), ys.tolist(),
                                          strict=True))
        parts.append(f"<polyline points=\"{points}\" fill=\"none\""
                     f" stroke=\"{colour}\" stroke-width=\"1.5\"/>")
    return "".join(parts) + "</svg>\n"
