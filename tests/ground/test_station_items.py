# SPDX-License-Identifier: Apache-2.0
"""GND-11: the station's table of items is the simulation's."""

import json
import subprocess

import pytest
from conftest import SIMULATION

from urv import items, packets


def test_gnd11_the_table_is_what_the_simulation_prints():
    printed = subprocess.run(
        [SIMULATION, "items"], capture_output=True, check=True).stdout
    assert items.TABLE.read_bytes() == printed, (
        "bin/urv_sim items > ground/urv/items.csv renews it")


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
                                     "laws."))]
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
    assert labels[5] == "switch 1"
    assert items.COLUMNS["pwm.left_flap_2"].label == "left flap 2"
