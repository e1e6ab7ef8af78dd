# SPDX-License-Identifier: Apache-2.0
"""`urv_sim items` and the tables in docs/items.md say the same (BUF-1, BUF-2,
PWM-2, GND-11)."""

import re

from conftest import COMMANDS, ROOT, SENSORS, SERVOS, fly_in

COLUMNS = ["name", "buffer", "position", "unit", "at_0", "at_4095"]
LIMITS = ["warning_low", "caution_low", "caution_high", "warning_high"]


def tables():
    """The rows of the page's tables."""
    page = (ROOT / "docs" / "items.md").read_text(encoding="utf-8")
    for line in page.splitlines():
        if line.startswith("|"):
            yield [cell.strip() for cell in line[1:].split("|")]


def documented():
    """Those of items, without what a column is about."""
    return [cells[:6] for cells in tables()
            if cells[1] in ("uplink", "downlink", "pwm", "laws")]


def documented_limits():
    """Name and unit of each item that has limits, and those."""
    rows = iter(tables())
    for cells in rows:
        if cells[2:6] == LIMITS:
            next(rows)
            break
    for cells in rows:
        if cells[1] == "word":
            return
        yield [*cells[:2], *cells[2:6]]


def printed(urv_sim):
    result = urv_sim("items")
    assert (result.returncode, result.stderr) == (0, "")
    return [line.split(",") for line in result.stdout.splitlines()]


def test_items_are_those_of_the_page(urv_sim):
    header, *rows = printed(urv_sim)
    assert header == [*COLUMNS, *LIMITS, "per_word", "zero_word",
                      "label", "works"]
    for got, wanted in zip(rows, documented(), strict=True):
        assert got[:6] == wanted


def test_gnd11_limits_are_those_of_the_page(urv_sim):
    limited = [[row[0], row[3], *row[6:10]] for row in printed(urv_sim)[1:]
               if any(row[6:10])]
    assert len(limited) > 10
    assert limited == list(documented_limits())


def test_gnd11_limits_of_an_item_rise_within_its_scale(urv_sim):
    for row in printed(urv_sim)[1:]:
        limits = [float(cell) for cell in row[6:10] if cell]
        assert limits == sorted(set(limits)), row
        assert all(float(row[4]) < limit < float(row[5])
                   for limit in limits), row


def test_gnd11_both_ways_to_write_a_scale_are_the_same_line(urv_sim):
    scaled = [row for row in printed(urv_sim)[1:] if row[3]]
    assert len(scaled) > 50
    for row in scaled:
        per_word, zero_word = float(row[10]), int(row[11])
        for word, wanted in ((0, row[4]), (4095, row[5])):
            value = per_word * (word - zero_word)
            assert abs(value - float(wanted)) <= 0.5001E-4, row


def test_items_stand_in_the_order_of_figure_4(urv_sim):
    names = {"uplink": [], "downlink": [], "pwm": []}
    for name, buffer, position, *_ in printed(urv_sim)[1:]:
        if buffer == "laws":
            continue
        names[buffer].append(name)
        assert int(position) == len(names[buffer]), name
    assert names == {
        "uplink": [*COMMANDS, "error"],
        "downlink": [*SENSORS, "error"],
        "pwm": [*SERVOS],
    }


def test_gnd11_the_laws_words_are_those_of_their_page_and_the_record(
        urv_sim, tmp_path):
    """The first is in the record in its parts."""
    words = [(row[0], row[2]) for row in printed(urv_sim)[1:]
             if row[1] == "laws"]
    page = (ROOT / "docs/control-laws.md").read_text("utf-8")
    table = re.findall(r"^\| ([\d, ]+) \| (`[a-z_`, ]+`) \|", page, re.M)
    assert words == [
        (name, place) for places, names in table for place, name in zip(
            places.split(", "), re.findall(r"[a-z_]+", names), strict=True)]
    (tmp_path / "orders.txt").write_text("# nothing\n")
    flight = fly_in(tmp_path, "--seconds", "1", "--laws", "on", "--orders",
                    "orders.txt")
    for name, _ in words[1:]:
        assert f"laws.{name}" in flight.record


def test_the_record_has_these_columns(fly):
    record = list(fly("--seconds", "0.02").record)
    uplink, downlink = [*COMMANDS, "error"], [*SENSORS, "error"]
    link = [
        f"{way}_{count}" for way in ("uplink", "downlink")
        for count in ("sent", "received", "bad", "scrapped")
    ]
    frame = ["number", "card", "phase", "left_aileron", "right_aileron",
             "left_elevator", "right_elevator", "left_rudder",
             "right_rudder", "throttle"]
    wanted = ["frame", "time_ms"]
    for group, names in (
        ("console", COMMANDS), ("gsc.uplink", uplink),
        ("mcs.uplink", uplink), ("pwm", SERVOS),
        ("mcs.downlink", downlink), ("gsc.downlink", downlink),
        ("link", [*link, "gsc_resets", "mcs_resets"]),
        ("mcs.frame", frame), ("gsc.frame", frame),
    ):
        wanted += [f"{group}.{name}" for name in names]
    assert record == wanted


def test_gnd50_the_page_says_what_each_switch_does(urv_sim):
    uses = {row[0]: row[12] for row in printed(urv_sim)[1:] if row[12]}
    told = {cells[0]: cells[6] for cells in tables()
            if cells[0] in uses and cells[1] == "uplink"}
    assert len(uses) == 8 and told.keys() == uses.keys()
    for name, use in uses.items():
        assert told[name].startswith(use), name
