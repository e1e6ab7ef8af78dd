# SPDX-License-Identifier: Apache-2.0
"""The figures of evidence/bench.py as a picture."""

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "urv"
matplotlib.rcParams["svg.fonttype"] = "none"

from matplotlib import pyplot  # noqa: E402


def bars(axes, title, rows):
    """Rows of a name, a value and whether it is URV's."""
    names, values, own = zip(*reversed(rows))
    axes.barh(names, values, color=["tab:blue" if ours else "tab:gray"
                                    for ours in own])
    axes.set_xscale("log")
    axes.xaxis.set_minor_formatter("")
    axes.set_title(title, fontsize=10)
    axes.bar_label(axes.containers[0], fmt=" %.0f", fontsize=8)
    axes.margins(x=0.25)


def draw(path, messages, speeds):
    figure, (left, right) = pyplot.subplots(
        1, 2, figsize=(11, 4), layout="constrained")
    bars(left, "SEND and RECV of 66 bytes, ns", messages)
    bars(right, "flights, times real time", speeds)
    figure.savefig(path, metadata={"Date": None, "Creator": None})
