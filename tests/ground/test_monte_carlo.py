# SPDX-License-Identifier: Apache-2.0
"""SIM-6: flights by the thousand. The same flight whoever flies it; a worker
that is killed loses none; what the page and the table say is so."""

import errno
import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import pytest
from conftest import ROOT, TIME_LIMIT_S, URV

from urv import (
    cargo, dispersions, faults, monte_carlo, monte_carlo_page, monte_carlo_results,
    success, workers)

pytest.importorskip("jsbsim", reason="make fly installs JSBSim")
distributed = pytest.importorskip("distributed")
parquet = pytest.importorskip("pyarrow.parquet")

PATIENCE_S = workers.PATIENCE_S

SHORT = SimpleNamespace(pilot="level", seconds=10, output="out",
                        surface_percent=0, console_percent=0)
FILES = ("conditions.txt", "faults.txt", "record.csv", "summary.json",
         "events.jsonl")


def jobs(count):
    return [monte_carlo.job(SHORT, seed) for seed in range(1, count + 1)]


@pytest.fixture(scope="module")
def sent():
    return cargo.Cargo(cargo.packed(ROOT, monte_carlo.CARGO), cargo.fly)


def steady(result):
    """A result without what the clock on the wall measured."""
    return {**result, "summary": {**result["summary"], "speed": None}}


@pytest.fixture(scope="module")
def flown(sent, tmp_path_factory):
    """The results of eight flights, flown here one by one."""
    here = cargo.Cargo(sent.archive, cargo.fly)
    here.unpack(tmp_path_factory.mktemp("cargo"))
    return {job["seed"]: steady(here.do(job)) for job in jobs(8)}


# --- what is drawn ----------------------------------------------------------

def test_a_seed_is_a_flight_and_nothing_else_is():
    drawn = [dispersions.draw(seed, "standard", 180) for seed in (7, 8, 7)]
    assert drawn[0] == drawn[2]
    assert drawn[0].conditions != drawn[1].conditions
    assert drawn[0].faults != drawn[1].faults


def test_what_is_drawn_is_within_its_bounds_and_uses_them():
    drawn = [dispersions.draw(seed, "standard", 180).values
             for seed in range(400)]
    for name, (least, most) in (("wind_kt", dispersions.USUAL_WIND_KT),
                                ("turbulence_kt", dispersions.TURBULENCE_KT),
                                ("ballast_lb", dispersions.BALLAST_LB),
                                ("servo_lag_percent",
                                 dispersions.SERVO_LAG_PERCENT),
                                ("servo_dead_band_percent",
                                 dispersions.SERVO_DEAD_BAND_PERCENT),
                                ("bit_error_rate", dispersions.BIT_ERRORS)):
        values = [each[name] for each in drawn]
        assert least <= min(values) < max(values) <= most
        assert max(values) - min(values) > 0.9 * (most - least)
    assert {each["cuts"] for each in drawn} == {0, 1, 2}


def test_servos_are_drawn_without_changing_what_else_is(monkeypatch):
    drawn = dispersions.draw(7, "standard", 180)
    lines = drawn.conditions.splitlines()
    assert lines[-1] == " ".join(["servos", *(
        str(drawn.values[f"servo_{name}_percent"])
        for name in ("lag", "rate", "dead_band"))])
    monkeypatch.setattr(dispersions, "servo_traits", lambda chance: {})
    other = dispersions.draw(7, "standard", 180)
    assert other.conditions.splitlines()[:-1] == lines[:-1]
    assert other.faults == drawn.faults


def test_a_surface_fails_as_often_as_is_asked_for():
    never, some, always = (
        [dispersions.draw(seed, "standard", 180, percent)
         for seed in range(400)] for percent in (0, 10, 100))
    assert not any("surface" in drawn.faults for drawn in never)
    assert 20 <= sum("surface" in drawn.faults for drawn in some) <= 60
    assert all(drawn.faults.count(" surface ") == 1 for drawn in always)
    assert {line.split()[2] for drawn in always
            for line in drawn.faults.splitlines() if " surface " in line
            } == set(dispersions.SURFACES)
    # All else stays as it is.
    for left, right in zip(never, always, strict=True):
        assert left.conditions == right.conditions
        assert right.faults.startswith(left.faults)


def test_a_surface_fault_is_one_that_the_simulation_knows(sent, tmp_path):
    here = cargo.Cargo(sent.archive, cargo.fly)
    here.unpack(tmp_path)
    for seed in range(6):
        job = monte_carlo.job(
            SimpleNamespace(**{**vars(SHORT), "surface_percent": 100}), seed)
        job["options"][job["options"].index("--seconds") + 1] = "0.1"
        assert "fault" not in here.do(job)


def test_saf10_a_lost_console_is_drawn_apart_from_all_else(sent, tmp_path):
    here = cargo.Cargo(sent.archive, cargo.fly)
    here.unpack(tmp_path)
    found = 0
    for seed in range(1, 40):
        never = dispersions.draw(seed, "level", 60)
        some = dispersions.draw(seed, "level", 60, console_percent=30)
        assert some.conditions == never.conditions
        more = some.faults.removeprefix(never.faults)
        assert bool(more) == bool(some.values["console_lost_ms"])
        if more:
            at_ms, *words, length = more.split()
            assert words == ["gsc", "console"]
            assert 1_000 <= int(at_ms) < 60_000
            assert int(length) == some.values["console_lost_ms"]
            found += 1
    assert 5 <= found <= 20
    job = monte_carlo.job(
        SimpleNamespace(**{**vars(SHORT), "console_percent": 100}), 1)
    job["options"][job["options"].index("--seconds") + 1] = "0.1"
    assert "fault" not in here.do(job)


# --- how sure a rate is -----------------------------------------------------

@pytest.mark.parametrize(("well", "trials", "least", "most"), [
    # Tables of Clopper and Pearson (1934) and of R's binom.test.
    (0, 10, 0.0, 0.30850), (10, 10, 0.69150, 1.0), (5, 10, 0.18709, 0.81291),
    (95, 100, 0.88717, 0.98357), (1999, 2000, 0.99722, 0.99999)])
def test_bounds_are_those_of_clopper_and_pearson(well, trials, least, most):
    assert success.clopper_pearson(well, trials) == pytest.approx(
        (least, most), abs=1e-5)


def test_a_flight_that_says_nothing_is_no_success():
    for limit in success.limits("standard"):
        assert limit.used({}) > 1.0
    whole, bank, *_ = success.limits("standard")
    assert whole.used({"flight_quality": {"crashed": True}}) > 1.0
    assert whole.used({"flight_quality": {"crashed": False}}) == 0.0
    assert bank.used({"flight_quality": {
        "bank_left_deg": 30.0, "bank_right_deg": -90.0}}) == 1.5


@pytest.mark.parametrize("fails, named, said", [
    (None, [], "1 of 1"), (0.0, [], "1 of 1"),
    (0.0, ["left_aileron"], "0 of 1"), (1.0, ["left_aileron"], None)])
def test_a_surface_is_named_wrongly_only_where_none_fails(
        fails, named, said):
    drawn = {} if fails is None else {"surface_fault": fails}
    flight = monte_carlo_results.flight(
        "level", {"seed": 1, "values": drawn},
        {"summary": {"frames": 1} | ({"failed_surfaces": named} if named
                                     else {})})
    assert flight.measured["surfaces_named"] == len(named)
    assert flight.has_false_failure == (said == "0 of 1")
    assert not flight.has_false_failure or not flight.is_success
    page = monte_carlo_page.rates(
        SimpleNamespace(pilot="level"), [flight])
    row = re.search(r"no surface named.*?</tr>", page, re.S)
    assert (said in row[0]) if said else row is None


# --- whoever flies it -------------------------------------------------------

def test_one_and_two_workers_find_the_same(urv, tmp_path, flown):
    for count in ("1", "2"):
        result = urv("monte-carlo", "--flights", 4, "--pilot", "level",
                     "--seconds", 10, "--workers", count, "-o", count)
        assert (result.returncode, result.stderr) == (0, "")
        assert "4 of 4 flights within all limits" in result.stdout
    files = [tmp_path / count / "results.parquet" for count in ("1", "2")]
    assert files[0].read_bytes() == files[1].read_bytes()

    table = parquet.read_table(files[0]).to_pylist()
    assert [row["seed"] for row in table] == [1, 2, 3, 4]
    for row in table:
        quality = flown[row["seed"]]["summary"]["flight_quality"]
        assert {name: row[name] for name in quality} == quality
        assert row["success"]
    page = (tmp_path / "1" / "report.html").read_text("utf-8")
    assert "4 of 4" in page
    # One minus the fourth root of 0.025.
    assert "39.76 % to 100.00 %" in page
    assert len(re.findall("bin/urv monte-carlo --again", page)) == 4
    assert "<script" not in page


def test_a_flight_is_flown_again_alone(urv, tmp_path, flown):
    result = urv("monte-carlo", "--again", 3, "--pilot", "level",
                 "--seconds", 10, "-o", "again")
    assert result.returncode == 0, result.stderr
    folder = tmp_path / "again" / "3"
    assert sorted(path.name for path in folder.iterdir()) == sorted(FILES)
    summary = json.loads((folder / "summary.json").read_text("utf-8"))
    assert {**summary, "speed": None} == flown[3]["summary"]

    # The printed command does it once more.
    before = (folder / "record.csv").read_bytes()
    (folder / "record.csv").unlink()
    command = result.stdout.splitlines()[0]
    subprocess.run(["sh", "-c", command], check=True, cwd=tmp_path,
                   capture_output=True, timeout=TIME_LIMIT_S)
    assert (folder / "record.csv").read_bytes() == before


def test_ext6_a_sound_engine_in_turbulence_is_not_named(urv, tmp_path):
    """Throttled back bit by bit, it slows down later than its bounds did."""
    result = urv("monte-carlo", "--again", 577, "-o", "again")
    assert result.returncode == 0, result.stderr
    summary = json.loads(
        (tmp_path / "again" / "577" / "summary.json").read_text("utf-8"))
    assert "failed_surfaces" not in summary


class Dask:
    """A scheduler and workers as they are anywhere: Python with packages, an
    empty folder, and no word of this repository."""

    def __init__(self, folder):
        self.folder = folder
        self.running = []
        self.environment = {
            name: value for name, value in os.environ.items()
            if name not in ("PYTHONPATH", "URV_PYTHON", "URV_SIM")}

    def start(self, name, *arguments):
        place = self.folder / name
        place.mkdir()
        process = subprocess.Popen(
            [sys.executable, "-m", "distributed.cli.dask_" + name.split(
                "-")[0], *arguments], cwd=place, env=self.environment,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.running.append(process)
        return process

    def scheduler(self):
        file = self.folder / "scheduler.json"
        self.start("scheduler", "--host", "127.0.0.1", "--port", "0",
                   "--no-dashboard", "--scheduler-file", str(file))
        for _ in range(600):
            try:
                return json.loads(file.read_text("utf-8"))["address"]
            except (OSError, ValueError):
                time.sleep(0.1)
        raise AssertionError("the scheduler did not start")

    def stop(self):
        for process in self.running:
            process.kill()
            process.wait()


@pytest.fixture
def dask(tmp_path):
    running = Dask(tmp_path)
    yield running
    running.stop()


def kill_in_flight(worker, folder):
    """Kill it while a flight's files are there."""
    for _ in range(600):
        worker.send_signal(signal.SIGSTOP)
        if any(folder.rglob("cargo-*/tmp*")):
            worker.send_signal(signal.SIGKILL)
            return
        worker.send_signal(signal.SIGCONT)
        time.sleep(0.1)
    raise AssertionError("the worker flew nothing")


def test_a_killed_worker_costs_its_flights_a_second_try(
        dask, sent, flown, tmp_path):
    address = dask.scheduler()
    team = [dask.start(f"worker-{n}", address, "--nthreads", "1",
                       "--no-nanny", "--no-dashboard",
                       "--local-directory", ".") for n in range(2)]
    found = {}
    for job, result in workers.done(sent, jobs(8), address):
        assert job["seed"] not in found
        found[job["seed"]] = steady(result)
        if len(found) == 3:
            kill_in_flight(team[0], tmp_path / "worker-0")
    assert team[0].wait() == -signal.SIGKILL
    assert found == flown


def test_a_flight_that_cannot_be_flown_is_reported(dask, sent, urv):
    """And is no success; the next one flies."""
    wrong, right = jobs(2)
    wrong["files"]["conditions.txt"] = "wind 3\n"
    address = dask.scheduler()
    dask.start("worker-0", address, "--nthreads", "1", "--no-nanny",
               "--no-dashboard", "--local-directory", ".")
    found = {job["seed"]: result for job, result in workers.done(
        sent, [wrong, right], address)}
    assert found[1]["fault"].startswith(
        "conditions.txt:1: the form of this condition is")
    assert found[2]["summary"]["flight_quality"]["crashed"] is False


def test_cargo_that_changed_on_its_way_is_refused(sent, tmp_path):
    spoilt = cargo.Cargo(sent.archive, cargo.fly)
    spoilt.archive = sent.archive[:-1] + b"?"
    with pytest.raises(RuntimeError, match="differs from the sent one"):
        spoilt.setup(SimpleNamespace(local_directory=str(tmp_path)))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("options", "complaint"), [
    ((), "either --flights or --again is needed, and not both"),
    (("--flights", 2, "--again", 3),
     "either --flights or --again is needed, and not both"),
    (("--flights", 2, "--pilot", "ace"),
     "--pilot: \"ace\" is not a pilot; there are standard, level, circuit,"
     " damped-circuit"),
    (("--flights", 2, "--workers", 2, "--scheduler", "tcp://127.0.0.1:1"),
     "--workers are workers here, and do not go together with --scheduler"),
])
def test_what_is_asked_wrongly_is_said(urv, options, complaint):
    result = urv("monte-carlo", *options)
    assert result.returncode == 2
    assert complaint in result.stderr


WORKER = ("--nthreads", "1", "--no-nanny", "--no-dashboard",
          "--local-directory", ".")


def test_a_scheduler_without_workers_is_reported(dask, sent, monkeypatch):
    monkeypatch.setattr(workers, "PATIENCE_S", 2)
    address = dask.scheduler()
    with pytest.raises(faults.Failed, match="no worker of .* for 2 s"):
        list(workers.done(sent, jobs(2), address))
    assert 10 <= PATIENCE_S < 30


def test_workers_that_end_are_reported_and_what_was_flown_has_come(
        dask, sent, monkeypatch):
    address = dask.scheduler()
    worker = dask.start("worker-0", address, *WORKER)
    found = []
    with pytest.raises(faults.Failed, match="no worker of .* for 2 s"):
        for job, _ in workers.done(sent, jobs(8), address):
            found.append(job["seed"])
            if len(found) == 2:
                monkeypatch.setattr(workers, "PATIENCE_S", 2)
                worker.kill()
    assert 2 <= len(found) < 8


def test_a_scheduler_that_dies_is_reported_and_what_was_flown_is_kept(
        dask, tmp_path):
    """kill -9 of it in the middle."""
    address = dask.scheduler()
    dask.start("worker-0", address, *WORKER)
    running = subprocess.Popen(
        [URV, "monte-carlo", "--flights", "500", "--pilot", "level",
         "--seconds", "10", "--scheduler", address, "--insecure",
         "-o", "kept"],
        cwd=tmp_path, text=True, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE)
    wait_for_flights(tmp_path / "worker-0")
    dask.running[0].kill()
    began = time.monotonic()
    _, said = running.communicate(timeout=TIME_LIMIT_S)
    # Its own patience, and room for a slow machine.
    assert time.monotonic() - began < 120
    assert running.returncode == 1
    lines = said.splitlines()
    assert lines[-1].startswith(f"urv: the scheduler of {address} has ended")
    flown_before = re.search(r"urv: (\d+) of 500 flights were flown", said)
    table = tmp_path / "kept" / "results.parquet"
    assert table.exists() == bool(flown_before)
    if flown_before:
        assert parquet.read_table(table).num_rows == int(flown_before[1])


def wait_for_flights(folder):
    """Until a worker has flown some, each in a folder of its own."""
    seen = set()
    ends = time.monotonic() + TIME_LIMIT_S
    while len(seen) < 5:
        assert time.monotonic() < ends, "the worker flew nothing"
        # A worker removes folders meanwhile; rglob would fail.
        seen |= {name for parent, names, _ in os.walk(folder)
                 if Path(parent).name.startswith("cargo-")
                 for name in names if name.startswith("tmp")}
        time.sleep(0.01)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_d39_what_was_flown_before_it_was_ended_is_kept(
        tmp_path, number):
    running = subprocess.Popen(
        [URV, "monte-carlo", "--flights", "5000", "--pilot", "level",
         "--seconds", "10", "--workers", "1", "-o", "kept"], cwd=tmp_path,
        text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        env={**os.environ, "TMPDIR": str(tmp_path)})
    wait_for_flights(tmp_path)
    running.send_signal(number)
    _, said = running.communicate(timeout=TIME_LIMIT_S)
    assert running.returncode == 130
    flown_before = re.search(r"urv: (\d+) of 5000 flights were flown", said)
    assert said.splitlines()[-1] == "urv: interrupted"
    table = parquet.read_table(tmp_path / "kept" / "results.parquet")
    assert table.num_rows == int(flown_before[1]) > 0


@pytest.mark.parametrize("lacks", ["program", "module"])
def test_a_worker_without_what_it_needs_is_reported(dask, sent, lacks):
    lame = cargo.Cargo(
        sent.archive, cargo.fly, **(
            {"program": "sim/jsbsim/plant.py"} if lacks == "program"
            else {"modules": ("no_such_module",)}))
    address = dask.scheduler()
    dask.start("worker-0", address, *WORKER)
    with pytest.raises(faults.Failed, match="lacks what it needs: "
                       + ("sim/jsbsim/plant.py" if lacks == "program"
                          else "the Python module no_such_module")):
        list(workers.done(lame, jobs(2), address))


def test_another_version_is_reported():
    here = {"host": {"python": "3.11.2.final.0"},
            "packages": {"dask": "1", "distributed": "1", "cloudpickle": "3"}}

    def of(scheduler, worker):
        return SimpleNamespace(get_versions=lambda: {
            "client": here, "scheduler": scheduler,
            "workers": {"tcp://a": worker}})

    workers.must_be_the_same(of(here, here), "here")
    patched = {**here, "host": {"python": "3.11.9.final.0"}}
    workers.must_be_the_same(of(patched, patched), "here")
    for other, what in (
            ({**here, "host": {"python": "3.13.1.final.0"}},
             "python 3.13, here is 3.11"),
            ({**here, "packages": {**here["packages"], "distributed": "2"}},
             "distributed 2, here is 1")):
        with pytest.raises(faults.Failed, match=f"the worker tcp://a .*{what}"):
            workers.must_be_the_same(of(here, other), "here")
        with pytest.raises(faults.Failed, match=f"the scheduler .*{what}"):
            workers.must_be_the_same(of(other, here), "here")


def test_workers_that_can_do_nothing_are_stopped(dask, sent):
    """Not each of a thousand flights is tried."""
    wrong = jobs(1)[0]
    wrong["files"]["conditions.txt"] = "wind 3\n"
    address = dask.scheduler()
    dask.start("worker-0", address, *WORKER)
    found = []
    with pytest.raises(faults.Failed, match="the last 20 could not be done"):
        for _, result in workers.done(sent, [wrong] * 1000, address):
            found.append(result)
    assert len(found) == workers.MOST_FAULTS


def test_flights_that_could_not_be_flown_are_no_success(
        monkeypatch, tmp_path):
    """The command's exit status is that of a failure, and the table is
    there."""
    monkeypatch.setattr(workers, "done", lambda sent, wanted, *_: (
        (job, {"fault": "no such library"}) for job in wanted))
    with pytest.raises(faults.Failed, match="2 of 2 flights could not be"
                       " flown; seed 1: no such library"):
        monte_carlo.fly_all(SimpleNamespace(
            pilot="level", seconds=10, first=1, count=2,
            output=tmp_path / "a:b", scheduler=None, workers=1,
            security=None, surface_percent=0, console_percent=0))
    assert parquet.read_table(
        (tmp_path / "a:b" / "results.parquet").open("rb")).num_rows == 2


def test_a_scheduler_that_is_not_there_is_said(urv):
    result = urv("monte-carlo", "--flights", 1, "--scheduler",
                 "tcp://127.0.0.1:1", "--insecure")
    assert result.returncode == 1
    assert result.stderr.splitlines()[-1].startswith(
        "urv: no scheduler at \"tcp://127.0.0.1:1\"")


def test_gnd53_a_table_that_is_lost_costs_no_page(
        flown, tmp_path, monkeypatch):
    """The disk is full for the table alone."""
    def write(*_):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(monte_carlo_results, "write", write)
    campaign = SimpleNamespace(**{**vars(SHORT), "output": tmp_path,
                                  "first": 1, "count": 8,
                                  "scheduler": None, "workers": None})
    found = [monte_carlo_results.flight("level", asked, flown[asked["seed"]])
             for asked in jobs(8)]
    with pytest.raises(faults.Failed, match="results.parquet.*No space left"):
        monte_carlo.keep(campaign, "hash", found)
    assert "</html>" in (tmp_path / "report.html").read_text("utf-8")


@pytest.mark.parametrize("pilot, text", [
    ("standard", "</b>, 150 s each"), ("histories", "</b>, up to 150 s each")])
def test_the_page_has_the_length_of_its_flights(pilot, text):
    head = monte_carlo_page.head(
        SimpleNamespace(pilot=pilot, seconds=150), "0a",
        [SimpleNamespace(seed=1)])
    assert text in head
