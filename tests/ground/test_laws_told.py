# SPDX-License-Identifier: Apache-2.0
"""GND-7: the station reads the reports of the aircraft's laws."""

import re
from dataclasses import replace

import pytest
from conftest import ROOT
from fake_node import laws_row
from test_packets import some_frame

from urv import laws, packets, view
from urv.laws import Laws


def told(*words):
    """A frame whose laws' row has these words, and zeros after them."""
    frame = some_frame()
    rows = (packets.LogRow(),) * (packets.LAWS_ROW - 1)
    return replace(frame, logs=(frame.logs[0], (*rows, laws_row(*words))))


def literals(source, name):
    text = re.sub(r"--.*", "", (ROOT / source).read_text("utf-8"))
    found = re.search(rf"type {name} is\s*\((.*?)\);", text, re.S)[1]
    return re.findall(r"\w+", found)


@pytest.mark.parametrize("names, source, kind", [
    (laws.LATERAL, "src/laws/urv-laws.ads", "Lateral_Mode"),
    (laws.VERTICAL, "src/laws/urv-laws.ads", "Vertical_Mode"),
    (laws.POWER, "src/laws/urv-laws.ads", "Power_Mode"),
    (laws.LINK, "src/laws/urv-link_loss.ads", "Link_State")])
def test_gnd7_the_names_are_those_of_the_laws(names, source, kind):
    assert [name.replace(" ", "_") for name in names] == [
        word.lower().replace("hold_", "") for word in literals(source, kind)]


def test_gnd7_the_surfaces_are_those_of_the_monitor():
    assert list(laws.SURFACES) == [
        word.lower() for word in literals(
            "src/laws/urv-surfaces.ads", "Surface")]


def test_gnd7_no_report_is_no_knowledge():
    assert Laws.of(told()) is None
    assert Laws.of(some_frame(version=1)) is None


@pytest.mark.parametrize("lost_each, state", [
    (None, "off"), (90, "unknown"), (2, "unknown")])
def test_gnd7_laws_are_off_only_when_their_row_has_come_empty(
        lost_each, state):
    """On a bad link the page showed "laws off" for laws that were on: their row
    came never whole."""
    seen = view.View(now=lambda: 100.0)
    frame = replace(told(), run=1)
    for number in range(500):
        lost = lost_each and number % lost_each == 0
        seen.datagram(replace(
            frame, sequence=number, time_us=number * packets.FRAME_US,
            downlink_age=1 if lost else 0).encode())
    assert seen.laws_state == state
    seen.datagram(replace(
        told(0x1000), run=1, sequence=500,
        time_us=500 * packets.FRAME_US).encode())
    assert seen.laws_state == "on"


@pytest.mark.parametrize("word, mode, short, link", [
    (0x1000, "direct", "direct", "linked"),
    (0x1011, "damping", "damp", "linked"),
    (0x1022, "bank by stick/pitch by stick", "bank pitch", "linked"),
    (0x1133, "wings level/altitude/airspeed", "level alt spd", "linked"),
    (0x2133, "wings level/altitude/airspeed", "HOLDING", "holding"),
    (0x4243, "wings level/glide/idle", "TERMINATED", "terminated"),
    (0x10FF, "number 15", "number 15", "linked")])
def test_gnd7_the_first_word_says_what_flies(word, mode, short, link):
    found = Laws.of(told(word))
    assert (found.mode, found.short, found.link) == (mode, short, link)
    assert found.is_alone == (link in ("holding", "orbiting", "terminated"))


def test_gnd7_each_bit_is_a_sensor_or_a_surface():
    found = Laws.of(told(0x1000, 1 << 15 | 1, 1 << 3, 7, 3 << 9 | 1))
    assert found.not_valid == (
        "right_flap_1", "vertical_acceleration", "roll_attitude")
    assert found.failed == ("left_aileron", "right_flap_2", "throttle")
    assert found.silent == 7
