# SPDX-License-Identifier: Apache-2.0
"""BRD-5: the cost on the bare machines, beside the baseline."""

import json

import pytest

import bare
import cost
import emulated

needs_mc68000 = bare.needs(emulated.MC68000_BOARD,
                           emulated.MC68000_BOARD.archive)
needs_cortex_m = bare.needs(emulated.CORTEX_M)


@pytest.mark.parametrize("machine", [
    pytest.param(emulated.MC68000_BOARD, marks=needs_mc68000),
    pytest.param(emulated.CORTEX_M, marks=needs_cortex_m)],
    ids=["mc68000", "cortex_m"])
def test_brd5_nothing_costs_more_than_its_baseline(machine):
    for node in cost.NODES:
        machine.build(node)
    baseline = json.loads(cost.BASELINE.read_text())
    found = cost.measured(machine)
    assert cost.too_large(found, baseline) == []
    # No figure of the baseline is missing.
    assert {name for name in baseline if name.startswith(machine.name)} \
        == set(found)


def test_brd5_an_emulator_that_fails_is_reported(monkeypatch):
    def measured(machine):
        raise emulated.Failed("no end after 300 s")
    monkeypatch.setattr(cost, "measured", measured)
    monkeypatch.setattr(emulated, "check_tools", lambda machine: None)
    monkeypatch.setattr(cost.sys, "argv", ["cost.py"])
    with pytest.raises(SystemExit, match="emulator failed: no end after 300"):
        cost.main()


def test_brd5_a_figure_over_its_limit_is_found():
    baseline = {"a": 10_000, "b": 1000}
    assert cost.too_large({"a": 10_300, "b": 1100}, baseline) == []
    assert cost.too_large({"a": 10_301, "b": 1101}, baseline) == [
        "a: 10,301, baseline 10000", "b: 1,101, baseline 1000"]
    assert cost.too_large({"c": 1}, baseline) == ["c: 1, baseline none"]


def test_brd5_no_task_needs_more_than_4_kib_of_stack():
    baseline = json.loads(cost.BASELINE.read_text())
    stacks = {name: value for name, value in baseline.items()
              if " stack of " in name}
    assert len(stacks) >= 36
    assert {name: value for name, value in stacks.items()
            if value > 4_096} == {}


def test_brd5_the_deepest_stack_is_that_of_all_calls():
    sizes = {"a": 10, "b": 20, "c": 100}
    calls = {"a": {"b", "c"}, "b": {"c"}}
    assert cost.deepest("a", sizes, calls, {}) == 10 + 4 + 20 + 4 + 100
    with pytest.raises(ValueError, match="a calls itself"):
        cost.deepest("a", sizes, {"a": {"b"}, "b": {"a"}}, {})
