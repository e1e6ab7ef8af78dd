# SPDX-License-Identifier: Apache-2.0
"""GND-11: the station's table of items is the simulation's."""

import json
import re
import subprocess

import pytest
from conftest import ROOT, SIMULATION

from urv import items, packets, tables


def test_gnd11_the_table_is_what_the_simulation_prints():
    printed = subprocess.run(
        [SIMULATION, "items"], capture_output=True, check=True).stdout
    assert items.TABLE.read_bytes() == printed, (
        "bin/urv_sim items > ground/urv/items.csv renews it")


def test_gnd11_the_lists_are_what_the_simulation_prints():
    printed = subprocess.run(
        [SIMULATION, "tables"], capture_output=True, check=True).stdout
    assert tables.TABLE.read_bytes() == printed, (
        "bin/urv_sim tables > ground/urv/tables.json renews it")


def test_gnd11_the_frame_is_that_of_the_nodes():
    numbers = json.loads(subprocess.run(
        [SIMULATION, "numbers"], capture_output=True, check=True).stdout)
    assert packets.FRAME_US == numbers["frame_us"]
    assert len(packets.COMMANDS) == numbers["uplink_words"] - 1


def test_gnd11_columns_are_those_of_the_record(standard):
    with (standard / "record.csv").open(encoding="utf-8") as record:
        columns = record.readline().strip().split(",")
    words = [name for name in columns
             if not name.startswith(("frame", "time", "link.", "truth.",
                                     "laws.", "mcs.frame.", "gsc.frame."))]
    assert list(items.COLUMNS) == words


@pytest.mark.parametrize("column, word, value", [
    ("console.roll", 2048, 0), ("console.throttle", 4095, 100),
    ("gsc.downlink.battery_volts", 2760, 27.6),
    ("gsc.downlink.uplink_signal_strength", 0, -120),
    ("gsc.downlink.roll_attitude", 0, -180),
    ("pwm.left_flap_1", 4095, 15)])
def test_gnd11_a_word_and_its_value(column, word, value):
    item = items.COLUMNS[column]
    assert item.value(word) == pytest.approx(value, abs=1e-8)
    assert item.word(value) == word
    assert item.word(1e9) == 4095 and item.word(-1e9) == 0


@pytest.mark.parametrize("value, level", [
    (27.6, ""), (25.0, ""), (24.99, "caution"), (23.5, "caution"),
    (23.49, "warning"), (29.0, ""), (30.0, "caution"), (31.1, "warning")])
def test_gnd11_a_value_is_judged_by_its_limits(value, level):
    battery = items.COLUMNS["gsc.downlink.battery_volts"]
    assert battery.level(value) == level


def test_gnd11_what_has_no_limits_is_never_out_of_them():
    roll = items.COLUMNS["console.roll"]
    assert roll.limits == {}
    assert roll.level(-100.0) == roll.level(100.0) == ""


def test_gnd11_labels_are_for_people():
    labels = [item.label for item in items.of_group("console")]
    assert labels[:2] == ["roll", "pitch"]
    assert labels[5] == "switch 1, rate damping"
    assert items.COLUMNS["pwm.left_flap_2"].label == "left flap 2"


# Switches

USES = ["rate damping", "attitude hold", "altitude and airspeed",
        "wings level", "test card", "discrete 6", "laws disconnect",
        "half flaps"]


def test_gnd50_each_switch_has_the_name_of_what_it_does():
    assert [item.use for item in items.SWITCHES] == USES
    assert [item.name for item in items.SWITCHES] == [
        f"switch{number}" for number in range(1, 9)]
    assert {item.use for item in items.SWITCHES if item.works == "laws"} == {
        *USES[:5], USES[6]}
    assert not any(item.use for item in items.ITEMS
                   if not item.name.startswith("switch"))


def test_gnd50_the_modes_of_the_laws_page_are_named_so():
    page = (ROOT / "docs" / "control-laws.md").read_text("utf-8")
    named = re.findall(r"^\| ([1-8]) \| ([^|]+) \|", page.partition(
        "## Modes")[2].partition("## ")[0], re.M)
    assert [number for number, _ in named] == list("1234578")
    for number, name in named:
        assert name == USES[int(number) - 1]


def test_gnd50_one_place_has_the_names():
    """Nobody repeats what the dictionary says."""
    own = ("rate damping", "discrete 6", "laws disconnect")
    for file in sorted((ROOT / "ground" / "urv").rglob("*")):
        if file.suffix in (".py", ".js", ".html"):
            text = file.read_text("utf-8")
            assert not [use for use in own if use in text], file


def test_gnd50_yamcs_shows_each_switch_by_its_name():
    from urv import display, xtce
    database, flight = xtce.mission_database(), display.flight()
    for number, use in enumerate(USES, 1):
        assert f"switch {number}, {use}" in database
        assert f">{number} {use}<" in flight
        assert f"/URV/gsc/uplink/switch{number}<" in flight
    assert "LAWS OFF" in flight


def test_gnd50_the_laws_disconnect_is_no_word_of_the_sticks():
    """The pilot lets go of the sticks by "release"."""
    page = "".join(file.read_text("utf-8") for file in sorted(
        (ROOT / "ground" / "urv" / "page").iterdir()))
    assert "release sticks" in page
    assert not re.search("disconnect", page, re.I)
    for name in ("controls.py", "sticks.py", "web.py"):
        assert "disconnect" not in (
            ROOT / "ground" / "urv" / name).read_text("utf-8")
