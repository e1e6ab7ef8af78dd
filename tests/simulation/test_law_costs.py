# SPDX-License-Identifier: Apache-2.0
"""EVI-16: the page of what the control laws cost is of the code that is
there."""

import shutil
import sys

import pytest

from conftest import ROOT

sys.path.insert(0, str(ROOT / "evidence" / "laws"))

import costs  # noqa: E402 - found by the line above

needs_valgrind = pytest.mark.skipif(
    not shutil.which("valgrind"), reason="there is no valgrind")


def test_evi16_the_page_has_each_flight_and_each_part():
    _, found = costs.told()
    assert list(found) == [flight.name for flight in costs.FLIGHTS]
    for name, parts in found.items():
        assert list(parts) == [*costs.PARTS, costs.TOTAL]
        # What is in the LAW task is not more than it; nor that than all.
        assert parts["laws"] + parts["surface monitor"] <= parts["LAW task"]
        assert (parts["LAW task"] + parts["PWM task"]
                < parts["all tasks"] < parts[costs.TOTAL]), name


@needs_valgrind
@pytest.mark.parametrize("flight", [costs.FLIGHTS[0], costs.FLIGHTS[4]],
                         ids=lambda flight: flight.name)
def test_evi16_a_mode_costs_what_the_page_says(flight):
    compiler, agreed = costs.told()
    if compiler != costs.instructions.compiler():
        pytest.skip(f"the page is of {compiler}")
    for part, count in costs.per_frame(flight).items():
        assert count == pytest.approx(
            agreed[flight.name][part], rel=costs.MOST_MORE), part


@needs_valgrind
def test_evi16_a_flight_that_is_not_in_its_mode_is_no_flight_of_it():
    wrong = costs.Flight("attitude hold", (2, 2, 0, 1), sticks="switch1")
    with pytest.raises(ValueError, match=r"attitude hold: .* are \(1, 1, 0"):
        costs.counted(wrong, costs.SHORT_S)


def test_evi16_more_than_is_agreed_fails(monkeypatch, capsys):
    compiler, agreed = costs.told()
    monkeypatch.setattr(costs.instructions, "compiler", lambda: compiler)
    for more, status in ((1.0, 0), (1.04, 1)):
        monkeypatch.setattr(costs, "per_frame", lambda flight, more=more: {
            part: round(count * more)
            for part, count in agreed[flight.name].items()})
        assert costs.main([]) == status
    assert "costs: direct, LAW task: " in capsys.readouterr().out


@pytest.mark.parametrize("place", [costs.SHORT_S * costs.FRAMES_PER_S - 1, -1])
def test_evi16_the_mode_is_that_of_the_last_frame_of_either_flight(
        tmp_path, place):
    codes = (2, 1, 0, 1)
    flight = costs.Flight("one", codes)
    rows = [[*codes, flight.failed] for _ in range(
        costs.LONG_S * costs.FRAMES_PER_S)]
    names = ("lateral", "vertical", "power", "link", "failed")

    def written():
        record = tmp_path / "record.csv"
        record.write_text("".join(
            ",".join(map(str, row)) + "\n"
            for row in [[f"laws.{name}" for name in names], *rows]))
        return record
    costs.check_flown(flight, written())
    rows[place][0] = 1
    with pytest.raises(ValueError, match=r"one: .* are \(1, 1, 0, 1"):
        costs.check_flown(flight, written())
