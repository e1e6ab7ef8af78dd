# SPDX-License-Identifier: Apache-2.0
"""EVI-14: what evidence/bench.py measures, and makes of it."""

import json
import statistics
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from conftest import NUMBERS, ROOT

sys.path[:0] = [str(ROOT / "evidence"), str(ROOT / "evidence" / "bench")]

import bench  # noqa: E402


def test_evi14_each_peer_is_measured_and_has_a_name():
    """What the C and C++ programs print is what is looked for."""
    texts = "".join((ROOT / "evidence" / "bench" / name).read_text("utf-8")
                    for name in ("peers.c", "queues.cpp"))
    for what, peers in bench.PEERS.items():
        for name in (what, *peers):
            assert bench.name_of(name), name
        for peer in peers:
            if peer != "ada_queue 66":
                assert f'"{peer.split()[0]}"' in texts, peer


def test_lines_are_a_thing_and_its_cost_but_for_remarks(tmp_path):
    program = tmp_path / "calls"
    program.write_text("#!/bin/sh\necho '# of no matter'\n"
                       "echo 'mailbox 66 12.5 ns'\necho '!odd 1 2'\n")
    program.chmod(0o755)
    tmp_path.chmod(0o755)
    caller = bench.Caller()
    caller.options = {}
    assert caller.lines_of(program) == {"mailbox 66": 12.5, "!odd 1": 2.0}


@pytest.fixture
def by_hand(monkeypatch):
    """Commands take as many seconds as their flights last, by 1,000."""
    taken = []

    def seconds_of(command):
        taken.append([str(word) for word in command])
        return float(command[-1]) / 1000

    monkeypatch.setattr(bench, "seconds_of", seconds_of)
    monkeypatch.setattr(bench, "said_by", lambda command: (
        (80.0 if "--bare" in command else 70.0)
        if "evidence/bench/jsbsim_alone.py" in command
        else 50.0 if command[0] == bench.SIMULATION else 20.0, 3.0))
    monkeypatch.setattr(bench, "two_at_once", lambda: 900.0)
    return taken


@pytest.mark.parametrize("then", [None, Path("then/urv_sim")])
def test_flights_are_told_in_times_real_time_and_milliseconds(by_hand, then):
    found = bench.flights(then, Path("workload"))
    expected = {
        "simulation": 1000.0, "two at once": 900.0, "start": 0.02,
        "workload": 25_000.0, "10 s": 10.0, "100 s": 100.0, "1000 s": 1000.0,
        "jsbsim alone": 70.0, "jsbsim": 50.0, "whole": 3000.0,
        "jsbsim bare": 80.0}
    if then:
        expected |= {"simulation then": 1000.0, "jsbsim then": 20.0,
                     "whole then": 3000.0}
    assert found == pytest.approx(expected)
    programs = {command[0] for command in by_hand}
    assert programs == {str(bench.SIMULATION), "workload",
                        *([str(then)] if then else [])}


def test_latencies_are_of_every_phase(monkeypatch, tmp_path):
    phases = []

    def seconds_of(command):
        phase = int(command[command.index("--phase") + 1])
        phases.append(phase)
        rows = Path(command[command.index("--sticks") + 1]).read_text("utf-8")
        assert len(rows.splitlines()) == 81
        command[command.index("--summary") + 1].write_text(json.dumps(
            {"latency_ms": {"min": 20 + phase, "max": 60 + phase}}), "utf-8")

    monkeypatch.setattr(bench, "seconds_of", seconds_of)
    assert bench.latencies(tmp_path) == (20, 60 + NUMBERS.frame_ticks - 1)
    assert phases == list(range(NUMBERS.frame_ticks))


def test_a_ratio_is_the_median_of_each_turn_s():
    assert bench.beside([2.0, 30.0, 8.0], [1.0, 10.0, 2.0]) == 3.0
    with pytest.raises(ValueError):
        bench.beside([1.0], [1.0, 2.0])
    values = [5.0, 1.0, 4.0, 2.0, 3.0]
    low, middle, high = statistics.quantiles(values, n=4)
    assert bench.summary(values) == {
        "median": 3.0, "low": low, "high": high}
    assert middle == 3.0
    assert bench.spread({"median": 4.0, "low": 3.0, "high": 5.0}) == "50 %"


def test_each_peer_stands_beside_its_own():
    cost = {"median": 2.0, "low": 1.0, "high": 3.0, "beside": 1.5}
    found = dict.fromkeys([*bench.PEERS, *bench.OWN, *bench.SPEEDS,
                           *bench.SPANS], cost)
    text = bench.page(found, (22, 30), "abc", 15)
    assert "| **SEND and RECV, 66 bytes** | 2.0 | 100 % | 1 |" in text
    assert "| C: memcpy behind a pthread mutex | 2.0 | 100 % | 1.50 |" in text
    assert "| the same at abc | 2 | 100 % | 1.50 |" in text
    assert "| of 1,000 s | 2.0 | 100 % |" in text
    assert "22 to 30 ms" in text
    for peer, own in bench.OWN.items():
        assert own in {*bench.PEERS, *bench.SPEEDS}, peer
    without = {what: cost for what in found if not what.endswith(" then")}
    assert "abc" not in bench.page(without, (22, 30), "abc", 15)


def test_jsbsim_alone_takes_the_steps_of_the_simulation(monkeypatch, capfd):
    pytest.importorskip("jsbsim", reason="make fly installs JSBSim")
    import jsbsim_alone
    times = jsbsim_alone.TIMES
    assert (times.tick, times.frame) == (NUMBERS.tick_us, NUMBERS.frame_ticks)
    assert times.scan == NUMBERS.frame_ticks - NUMBERS.servo_tick
    assert times.shown == NUMBERS.frame_ticks
    count = {"run": 0, "read": 0, "set": 0}

    def counted(what, value=None):
        def call(*_):
            count[what] += 1
            return value
        return call

    node = SimpleNamespace(get_double_value=counted("read", 0.0),
                           set_double_value=counted("set"))
    aircraft = SimpleNamespace(
        fdm=SimpleNamespace(run=counted("run")),
        tree=SimpleNamespace(get_node=lambda path: node))
    monkeypatch.setattr(jsbsim_alone.plant, "Aircraft",
                        lambda *given: aircraft)
    jsbsim_alone.main(2.0, bare=True)
    assert "times real time" in capfd.readouterr().out
    steps = times.frame // times.step
    assert count == {"run": 100 * steps, "read": 0, "set": 0}
    jsbsim_alone.main(2.0, bare=False)
    servos = len(jsbsim_alone.plant.SERVOS)
    assert count["run"] == 200 * steps
    assert count["set"] == 100 * servos
    assert count["read"] > 100 * servos


def test_a_picture_has_ours_in_blue(tmp_path):
    pytest.importorskip("matplotlib", reason="make -C evidence bench installs it")
    import plots
    rows = [("URV", 10.0, True), ("another", 20.0, False)]
    figure = plots.pyplot.figure()
    axes = figure.subplots()
    plots.bars(axes, "one", rows)
    blue, gray = (plots.matplotlib.colors.to_rgba(f"tab:{name}")
                  for name in ("blue", "gray"))
    assert [bar.get_facecolor() for bar in axes.patches] == [gray, blue]
    plots.pyplot.close(figure)
    plots.draw(tmp_path / "picture.svg", rows, rows)
    assert "another" in (tmp_path / "picture.svg").read_text("utf-8")
