# SPDX-License-Identifier: Apache-2.0
"""`urv_sim numbers` and the table in docs/urv_sim.md say the same (SIM-1)."""

import json

from conftest import (
    COMMANDS,
    DOWNLINK_CHARACTERS,
    EXCHANGE,
    ROOT,
    SENSORS,
    SERVOS,
    UPLINK_CHARACTERS,
)


def printed(urv_sim):
    result = urv_sim("numbers")
    assert (result.returncode, result.stderr) == (0, "")
    return json.loads(result.stdout)


def test_numbers_are_those_of_the_page(urv_sim):
    page = (ROOT / "docs" / "urv_sim.md").read_text(encoding="utf-8")
    rows = [[cell.strip(" `") for cell in line.strip("|").split("|")]
            for line in page.partition("## Numbers")[2].partition("\n## ")[0]
            .splitlines() if line.startswith("| `")]
    assert printed(urv_sim) == {name: int(value) for name, value, _ in rows}


def test_numbers_fit_the_words(urv_sim):
    """The tests' knowledge of the buffers (BUF-1, BUF-2, D-5)."""
    said = printed(urv_sim)
    assert said["uplink_words"] == len(COMMANDS) + 1
    assert said["downlink_words"] == len(SENSORS) + 1
    assert said["pwm_words"] == len(SERVOS)
    assert said["uplink_characters"] == UPLINK_CHARACTERS
    assert said["downlink_characters"] == DOWNLINK_CHARACTERS
    assert said["exchange_up_characters"] == EXCHANGE["up"]
    assert said["exchange_down_characters"] == EXCHANGE["down"]


def test_numbers_are_those_of_a_flight(urv_sim, fly):
    """How far apart rows are, and characters of one message."""
    said = printed(urv_sim)
    flight = fly("--seconds", "1")
    times_ms = flight.record["time_ms"]
    assert {1000 * (after - before) for before, after in zip(
        times_ms, times_ms[1:], strict=False)} == {said["frame_us"]}
    assert min(after.time_us - before.time_us for before, after in zip(
        flight.wire, flight.wire[1:], strict=False)) == said["character_us"]
    assert said["frame_us"] == said["frame_ticks"] * said["tick_us"]
