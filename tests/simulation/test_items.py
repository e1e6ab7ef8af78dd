# SPDX-License-Identifier: Apache-2.0
"""`urv_sim items` and the table in docs/items.md say the same (BUF-1, BUF-2,
PWM-2)."""

from conftest import COMMANDS, ROOT, SENSORS, SERVOS

COLUMNS = ["name", "buffer", "position", "unit", "at_0", "at_4095"]


def documented():
    """The rows of the page's tables, without what a column is about."""
    rows = []
    page = (ROOT / "docs" / "items.md").read_text(encoding="utf-8")
    for line in page.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("|") and cells[2].isdecimal():
            rows.append(cells[:6])
    return rows


def printed(urv_sim):
    result = urv_sim("items")
    assert (result.returncode, result.stderr) == (0, "")
    return [line.split(",") for line in result.stdout.splitlines()]


def test_items_are_those_of_the_page(urv_sim):
    header, *rows = printed(urv_sim)
    assert header == COLUMNS
    for got, wanted in zip(rows, documented(), strict=True):
        assert got == wanted


def test_items_stand_in_the_order_of_figure_4(urv_sim):
    names = {"uplink": [], "downlink": [], "pwm": []}
    for name, buffer, position, *_ in printed(urv_sim)[1:]:
        names[buffer].append(name)
        assert int(position) == len(names[buffer]), name
    assert names == {
        "uplink": [*COMMANDS, "error"],
        "downlink": [*SENSORS, "error"],
        "pwm": [*SERVOS],
    }


def test_the_record_has_these_columns(fly):
    record = list(fly("--seconds", "0.02").record)
    uplink, downlink = [*COMMANDS, "error"], [*SENSORS, "error"]
    link = [
        f"{way}_{count}" for way in ("uplink", "downlink")
        for count in ("sent", "received", "bad", "scrapped")
    ]
    wanted = ["frame", "time_ms"]
    for group, names in (
        ("console", COMMANDS), ("gsc.uplink", uplink),
        ("mcs.uplink", uplink), ("pwm", SERVOS),
        ("mcs.downlink", downlink), ("gsc.downlink", downlink),
        ("link", [*link, "gsc_resets", "mcs_resets"]),
    ):
        wanted += [f"{group}.{name}" for name in names]
    assert record == wanted
