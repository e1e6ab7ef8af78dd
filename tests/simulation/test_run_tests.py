# SPDX-License-Identifier: Apache-2.0
"""EVI-11: what scripts/run_tests.py makes of what ran."""

import os
import shutil
import subprocess
import sys
import threading

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "scripts"))

import run_tests  # noqa: E402


@pytest.fixture
def place(tmp_path, monkeypatch):
    """A folder of its own, where nothing has run and all builds, and one
    processor."""
    monkeypatch.setattr(run_tests, "ROOT", tmp_path)
    monkeypatch.setattr(run_tests, "RESULTS", tmp_path / "results")
    monkeypatch.setattr(run_tests, "tests", [])
    monkeypatch.setattr(run_tests, "build", lambda *_: True)
    monkeypatch.setattr(run_tests.os, "sched_getaffinity", lambda _: {0})
    (tmp_path / "bin").mkdir()
    (tmp_path / "results").mkdir()
    return tmp_path


def parts(monkeypatch, **results):
    """Parts that give these results."""
    monkeypatch.setattr(run_tests, "PARTS", {
        name: lambda result=result: result for name, result in results.items()
    })


@pytest.mark.parametrize(("results", "last_line", "status"), [
    ({"a": (3, 0, 0), "b": (2, 0, 1)}, "5 passed, 0 failed, 1 skipped", 0),
    ({"a": (3, 0, 0), "b": (2, 1, 0)}, "5 passed, 1 failed, 0 skipped", 1),
    ({"a": (0, 0, 2)}, "0 passed, 0 failed, 2 skipped", 1),
])
def test_the_last_line_is_the_sum(
        place, monkeypatch, capsys, results, last_line, status):
    parts(monkeypatch, **results)
    monkeypatch.setattr(sys, "argv", ["run_tests.py"])
    assert run_tests.main() == status
    assert capsys.readouterr().out.splitlines()[-1] == last_line
    totals = (place / "results" / "totals").read_text(encoding="utf-8")
    assert totals == f"{last_line}\n"


def test_what_is_slow_and_what_failed_is_named_at_the_end(
        place, monkeypatch, capsys):
    def part():
        run_tests.tests.extend(
            run_tests.Test(seconds, seconds == 5, f"takes {seconds}")
            for seconds in range(20))
        return 19, 1, 0
    monkeypatch.setattr(run_tests, "PARTS", {"only": part})
    monkeypatch.setattr(sys, "argv", ["run_tests.py"])
    run_tests.main()
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "== only"
    slowest = lines[lines.index("== slowest tests") + 1:]
    assert slowest[0] == "  19.0 s  takes 19"
    assert slowest[9] == "  10.0 s  takes 10"
    assert slowest[10] == ""
    failed = lines[lines.index("== failed") + 1:]
    assert failed[:2] == ["takes 5", ""]
    assert "only: 19 passed, 1 failed, 0 skipped, in 0 s" in lines


def test_lanes_run_beside_the_other_parts_and_the_proof_last(
        place, monkeypatch, capsys):
    """Each waits until another part beside it has begun."""
    begun = {name: threading.Event() for name in ("live", "long", "busy")}
    order = []

    def part(name, awaited=None):
        def run_it():
            order.append(name)
            if awaited:
                begun[name].set()
                assert begun[awaited].wait(60)
            return 1, 0, 0
        return run_it

    first, last = part("first"), part("last")
    monkeypatch.setattr(run_tests, "LANES", (("live",), ("long", "next")))
    monkeypatch.setattr(run_tests, "every_source", first)
    monkeypatch.setattr(run_tests, "proof", last)
    monkeypatch.setattr(run_tests, "PARTS", {
        "first": first, "next": part("next"), "live": part("live", "long"),
        "busy": part("busy", "live"), "long": part("long", "busy"),
        "last": last})
    monkeypatch.setattr(sys, "argv", ["run_tests.py"])
    assert run_tests.main() == 0
    assert (order[0], order[-1]) == ("first", "last")
    assert order.index("long") < order.index("next")
    assert capsys.readouterr().out.splitlines()[-1] == (
        "6 passed, 0 failed, 0 skipped")


def test_a_command_s_lines_of_tests_come_at_once_and_others_last(
        place, capsys):
    line = "[gw0] [ 50%] PASSED tests/a.py::test_b"
    status = run_tests.run(
        "sh", "-c", f"echo head; echo '{line}'; nice; exit 3",
        at_once=run_tests.PYTHON_TEST, gives_way=True)
    assert status == 3
    least = os.nice(0) + 5
    assert capsys.readouterr().out.splitlines() == [
        line, "head", str(min(least, 19))]


def test_a_part_that_raises_an_exception_has_failed(
        place, monkeypatch, capsys):
    monkeypatch.setattr(run_tests, "PARTS", {"real time": lambda: 1 / 0})
    monkeypatch.setattr(sys, "argv", ["run_tests.py"])
    assert run_tests.main() == 1
    assert "0 passed, 1 failed, 0 skipped" in capsys.readouterr().out


PROGRAM = """\
#!/bin/sh
echo 'ok   MBX-1 one'
echo 'FAIL MBX-2 other'
echo '     somewhere.adb:12: wrong'
"""


def unit_tests(place, end):
    program = place / "bin" / "urv_tests_host"
    program.write_text(PROGRAM + end, encoding="utf-8")
    program.chmod(0o755)
    return run_tests.unit_tests("host")


def test_unit_tests_are_counted_and_the_failed_one_is_named(place):
    assert unit_tests(
        place, "echo '1 passed, 1 failed, 0 skipped'\nexit 1") == (1, 1, 0)
    assert [(test.failed, test.name) for test in run_tests.tests] == [
        (False, "MBX-1 one"), (True, "MBX-2 other")]


@pytest.mark.parametrize("end", ["", "echo '1 passed'", "kill -9 $$",
                                 "echo '9 passed, 0 failed, 0 skipped'\n"
                                 "echo 'raised PROGRAM_ERROR'",
                                 "echo '9 passed, 0 failed, 0 skipped'\n"
                                 "exit 139"])
def test_unit_tests_that_end_early_have_failed(place, end, capsys):
    assert unit_tests(place, end) == run_tests.BROKEN
    assert run_tests.tests[-1].failed
    assert "ended early" in run_tests.tests[-1].name


PYTHON_TESTS = """\
import pytest
def test_good(): pass
def test_bad(): assert False
@pytest.mark.skip
def test_left_out(): pass
@pytest.fixture
def broken(): raise OSError
def test_error(broken): pass
"""


def python_tests(place, text, without=()):
    folder = place / "tests" / "some"
    folder.mkdir(parents=True)
    (folder / "test_one.py").write_text(text, encoding="utf-8")
    (folder / "test_other.py").write_text("def test_it(): pass\n",
                                          encoding="utf-8")
    return run_tests.python_tests(
        [("some.gpr", "host")], "some", without, at_once="1")


def test_python_tests_are_counted_and_failed_ones_named(place):
    assert python_tests(place, PYTHON_TESTS) == (2, 2, 1)
    assert [test.name for test in run_tests.tests if test.failed] == [
        "test_one.py::test_bad", "test_one.py::test_error"]


def test_python_tests_that_cannot_be_collected_have_failed(place):
    assert python_tests(place, "import nothing_of_this_name\n") in (
        run_tests.BROKEN, (1, 1, 0))
    assert any(test.failed for test in run_tests.tests)


def test_what_does_not_build_has_failed(place, monkeypatch):
    monkeypatch.setattr(run_tests, "build", lambda *_: False)
    assert run_tests.every_source() == run_tests.BROKEN
    assert run_tests.unit_tests("host") == run_tests.BROKEN
    assert run_tests.simulation_tests() == run_tests.BROKEN


def test_evi11_patience_says_that_a_command_goes_on(tmp_path):
    """Here its 10 s are none."""
    sleep = tmp_path / "sleep"
    sleep.write_text("#!/bin/sh\nexec /bin/sleep 0.2\n", encoding="utf-8")
    sleep.chmod(0o755)
    result = subprocess.run(
        [ROOT / "scripts" / "patiently.sh", "fly: building", "/bin/sh", "-c",
         "/bin/sleep 2; exit 3"], check=False, text=True, capture_output=True,
        env={**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"},
        timeout=60)
    assert (result.returncode, result.stderr) == (3, "")
    lines = result.stdout.splitlines()
    assert lines[:2] == ["fly: building: 10 s so far",
                         "fly: building: 20 s so far"]


@pytest.mark.parametrize("second, is_new", [
    ("found('other', '1', '2')", True),
    ("pytest.skip('there is no Chromium')", False), ("assert False", False)],
    ids=["all", "one skipped", "one failed"])
def test_evi11_a_page_of_trials_is_new_only_when_all_have_run(
        tmp_path, second, is_new):
    trials, pages = tmp_path / "evidence/trials", tmp_path / "docs/evidence"
    trials.mkdir(parents=True)
    pages.mkdir(parents=True)
    page = pages / "station.md"
    page.write_text("# Station\n\n| trial | old |\n")
    shutil.copy(ROOT / "evidence/trials/conftest.py", trials)
    (trials / "test_two.py").write_text(
        "import pytest\n\n\ndef test_one(found):\n"
        "    found('one', '1', '1')\n\n\ndef test_other(found):\n"
        f"    {second}\n")
    done = subprocess.run(
        [sys.executable, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider",
         trials], env={**os.environ, "URV_RENEW": "1"}, cwd=tmp_path,
        capture_output=True, text=True, check=False)
    assert ("| one | 1 | 1 |" in page.read_text()) == is_new, done.stdout
    assert ("station.md stays as it is" in done.stdout) != is_new
