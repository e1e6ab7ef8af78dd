#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs every test and ends with one line: N passed, N failed, N skipped.

    scripts/run_tests.py [PART ...]    those parts whose names begin so
    scripts/run_tests.py --quick       the quick ones, for daily work

The parts: that every source of src and proofs builds without a warning; unit
tests in Ada, with and without their contracts executed; the tests in Python of
the simulation, of the real-time partitions and of the ground station; likely
changes, built, tested and flown in a copy; the links of the requirements, the
static data of each node, the proof record; both nodes on bare machines.
All is built first. Then most parts run in three lanes beside each other, so
that every processor has work. The live tests of the ground station and of the
partitions are a lane: they wait more than they work, and the others give way
to them. Tests that measure times run alone. Each test is a line, once; after
15 s without one, lines name what goes on. A part's other output comes at its
end. A part that cannot be built or run counts as one failed test, and the other
parts run all the same. Before the last line come the slowest tests, the failed
ones, and each part with its result and time (EVI-11).
Exit status: 0 when none failed and at least one passed.
"""

import concurrent.futures
import contextlib
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
import xml.etree.ElementTree
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
RESULTS = ROOT / "obj" / "tests"
GPRBUILD = ["gprbuild", "-q", "-p", "-j0"]
TOTALS = re.compile(r"^(\d+) passed, (\d+) failed, (\d+) skipped$")
UNIT_TEST = re.compile(r"^(ok  |FAIL) (.+)$")
SLOWEST = 10

# The line of a test in Python, from its worker.
PYTHON_TEST = re.compile(r"^\[gw\d+\] \[ *\d+%\] [A-Z]+ ")

# The longest time without a line.
SILENCE_S = 15.0

# The files of tests of the simulation that `make check` leaves out: they take
# longest.
SLOW = ("aircraft", "campaign", "campaign_checker", "circuit", "conditions",
        "exploration", "faults", "flight", "fuzz", "link_cuts",
        "lost_console", "mutants", "planted", "safety_mixes", "starts",
        "surfaces", "traceability", "truth")

# The live tests of the ground station: they run in real time.
LIVE = ("arrivals", "console_losses", "door", "gamepads", "ground", "mavlink",
        "page", "station")

# The tests of the partitions that measure times.
MEASURING = ("partition_flights", "partition_lock", "partition_recorder",
             "partition_safety", "partition_slow_line")

# This many live tests run at once, of any file. They wait more than they work:
# two processors have time for more of them, and a test that is kept waiting
# counts frames, not time. Those of the ground station have a browser.
LIVE_AT_ONCE = {"real_time": "6", "ground": "6"}

# A test that hangs fails after this time: the longest builds three programs and
# flies them, in 3 min on an idle machine.
LIMIT_S = "1200"

# A command gives way to others. Linux gives each session, too, a priority, which
# one without rights may lower.
GIVE_WAY = ["nice", "-n", "5", "sh", "-c",
            "{ echo 5 >/proc/self/autogroup; } 2>/dev/null; exec \"$@\"", "sh"]

# The other tests run one more than there are processors: some of them wait.
ONE_MORE = str(len(os.sched_getaffinity(0)) + 1)

BROKEN = (0, 1, 0)


class Test(NamedTuple):
    seconds: float
    failed: bool
    name: str


# The tests that ended.
tests = []


class Screen:
    """The output, a line at a time. After each SILENCE_S without one it says
    what goes on, and for how long."""

    def __init__(self):
        self.lock = threading.Lock()
        self.last = time.monotonic()

    def put(self, text):
        with self.lock:
            sys.stdout.write(text)
            sys.stdout.flush()
            self.last = time.monotonic()

    @contextlib.contextmanager
    def working(self, what):
        """While this goes on."""
        began = time.monotonic()
        is_over = threading.Event()

        def watch():
            while not is_over.wait(SILENCE_S / 10):
                if time.monotonic() - self.last >= SILENCE_S:
                    seconds = duration(time.monotonic() - began)
                    self.put(f"... {what}, {seconds} so far\n")

        watcher = threading.Thread(target=watch, daemon=True)
        self.last = began
        watcher.start()
        try:
            yield
        finally:
            is_over.set()
            watcher.join()


screen = Screen()


def run(*command, what=None, env=None, at_once=None, gives_way=False):
    """Run a command with its output on ours, return its exit status. If a
    pattern is given, lines that it matches come at once, the others at the
    end."""
    held = []
    with screen.working(what or " ".join(map(str, command[:3]))), \
            subprocess.Popen(
                [*(GIVE_WAY if gives_way else []), *map(str, command)],
                cwd=ROOT, stdout=subprocess.PIPE, env=env,
                stderr=subprocess.STDOUT, text=True, errors="replace",
                start_new_session=gives_way
            ) as running:
        try:
            for line in running.stdout:
                if at_once and not at_once.match(line):
                    held.append(line)
                else:
                    screen.put(line)
        except KeyboardInterrupt:
            if gives_way:
                # The terminal does not interrupt another session.
                os.killpg(running.pid, signal.SIGINT)
            raise
    screen.put("".join(held))
    return running.returncode


# The projects that were built, each with its mode, and whether they could be.
built = {}


def build(project, mode):
    """True if it was built. Warnings are errors. It is built once."""
    if (project, mode) not in built:
        screen.put(f"building {project}, {mode}\n")
        status = run(*GPRBUILD, "-P", project, f"-XURV_Mode={mode}",
                     what=f"building {project}")
        built[project, mode] = status == 0
        if status != 0:
            tests.append(Test(0, True, f"building {project}, {mode}"))
    return built[project, mode]


def every_source():
    """Theorems too, which no program needs, and programs that no test runs."""
    return (1, 0, 0) if all([
        build("urv.gpr", "flight"),
        build("sim/urv_sim.gpr", "test")]) else BROKEN


def unit_tests(mode):
    """Every so-maniest test in a process of its own, for each processor one."""
    if not build(UNIT_TESTS, mode):
        return BROKEN
    shares = len(os.sched_getaffinity(0))
    with screen.working("unit tests"), \
            concurrent.futures.ThreadPoolExecutor(shares) as pool:
        totals = list(pool.map(
            lambda number: unit_share(mode, number, shares),
            range(1, shares + 1)))
    return tuple(map(sum, zip(*totals)))


def unit_share(mode, number, shares):
    totals = None
    program = f"bin/urv_tests_{mode}"
    command = ["nice", "-n", "5", program, str(number), str(shares)]
    began = time.monotonic()
    with subprocess.Popen(
        command, cwd=ROOT, stdout=subprocess.PIPE, text=True
    ) as running:
        for line in running.stdout:
            screen.put(line)
            totals = TOTALS.match(line)
            if ended := UNIT_TEST.match(line):
                now = time.monotonic()
                tests.append(
                    Test(now - began, ended[1] == "FAIL", ended[2]))
                began = now
    # Its last line is its totals, and its status says whether a test failed;
    # or it did not get to its end.
    if not totals or running.returncode != (totals[2] != "0"):
        early = f"{program} {number} {shares} ended early, status {running.returncode}"
        screen.put(f"{early}\n")
        tests.append(Test(0, True, early))
        return BROKEN
    return tuple(map(int, totals.groups()))


def python_tests(projects, name, without=(), at_once=ONE_MORE,
                 spread="loadfile", told=None, live=False):
    """Build what the tests of a folder fly, then run them: as many at once as
    are named. Those of one file or group run one after another, unless they
    are spread otherwise. They give way to other programs, unless they are
    live."""
    if not all([build(project, mode) for project, mode in projects]):
        return BROKEN
    report = RESULTS / f"{told or name}.xml"
    report.unlink(missing_ok=True)
    pytest = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider"]
    pytest += ["-p", "test_lines"]
    pytest += ["--timeout", LIMIT_S]
    pytest += ["-v", "-rs", "--tb=short", f"--junitxml={report}"]
    pytest += ["-n", at_once, "--dist", spread, "--no-loadscope-reorder"]
    # Folders of tests that passed go; they are 400 MB.
    pytest += ["-o", "tmp_path_retention_policy=failed"]
    pytest += [f"--ignore=tests/{name}/test_{each}.py" for each in without]
    # The plug-in test_lines is beside this script. Each process would compile
    # the tests.
    path = os.pathsep.join(filter(
        None, [str(Path(__file__).parent), os.environ.get("PYTHONPATH")]))
    given = {**os.environ, "PYTHONPATH": path,
             "PYTHONPYCACHEPREFIX": str(ROOT / "obj" / "python")}
    status = run(*pytest, f"tests/{name}", what=f"tests of {told or name}",
                 at_once=PYTHON_TEST, gives_way=not live, env=given)
    # 0: all passed; 1: some failed. Otherwise pytest itself went wrong, or
    # found no test.
    if status not in (0, 1) or not report.exists():
        tests.append(Test(0, True, f"pytest tests/{name}, status {status}"))
        return BROKEN
    passed = failed = skipped = 0
    for suite in xml.etree.ElementTree.parse(report).iter("testsuite"):
        names = ("tests", "failures", "errors", "skipped")
        count, failures, errors, left_out = (int(suite.get(n)) for n in names)
        failed += failures + errors
        skipped += left_out
        passed += count - failures - errors - left_out
        tests.extend(map(python_test, suite.iter("testcase")))
    return passed, failed, skipped


def python_test(case):
    place = case.get("classname").rpartition(".")[2]
    failed = any(case.find(how) is not None for how in ("failure", "error"))
    return Test(float(case.get("time")), failed,
                f"{place}.py::{case.get('name')}")


UNIT_TESTS = "tests/urv_tests.gpr"
SIMULATION = ("sim/urv_sim.gpr", "host")
PARTITIONS = ("real_time/urv_real_time.gpr", "flight")


def simulation_tests():
    return python_tests([SIMULATION], "simulation")


def quick_simulation_tests():
    return python_tests([SIMULATION], "simulation", SLOW)


def all_but(chosen, folder):
    names = [path.stem.removeprefix("test_")
             for path in (ROOT / "tests" / folder).glob("test_*.py")]
    return [name for name in names if name not in chosen]


def real_time_tests():
    return python_tests([PARTITIONS], "real_time", MEASURING,
                        spread="worksteal", live=True,
                        at_once=LIVE_AT_ONCE["real_time"])


def measuring_tests():
    return python_tests([PARTITIONS], "real_time",
                        all_but(MEASURING, "real_time"),
                        told="real_time-measuring", spread="worksteal",
                        live=True, at_once=LIVE_AT_ONCE["real_time"])


def live_ground_tests():
    return python_tests([SIMULATION, PARTITIONS], "ground",
                        all_but(LIVE, "ground"),
                        told="ground-live", spread="worksteal", live=True,
                        at_once=LIVE_AT_ONCE["ground"])


def ground_tests():
    return python_tests([SIMULATION, PARTITIONS], "ground", without=LIVE,
                        spread="worksteal")


def target_tests():
    return python_tests([SIMULATION], "targets", at_once="auto")


def change_tests():
    """One after another: those of one copy must not meet."""
    return python_tests([], "changes", at_once="1")


def one_test(*command, program=sys.executable):
    began = time.monotonic()
    status = run(program, *command)
    tests.append(Test(time.monotonic() - began, status != 0,
                      " ".join(command)))
    return (1, 0, 0) if status == 0 else BROKEN


def links():
    """Also when the file of tests is gone that would find it gone."""
    return one_test("scripts/trace/run.py", "check")


def node_size():
    return one_test("scripts/node_size.py")


def record_is_current():
    return one_test("scripts/proof_record.py", "sources")


def proof():
    """The flight software as recorded, and the bare boards' drivers (BRD-6)."""
    if not shutil.which("gnatprove"):
        screen.put("skipped: gnatprove is not on the PATH\n")
        return 0, 0, 1
    return tuple(map(sum, zip(
        one_test("scripts/proof_record.py", "check"),
        one_test("-P", "targets/drivers.gpr", "--no-subprojects",
                 "--checks-as-errors", "--warnings=error", "-k",
                 program="gnatprove"))))


PARTS = {
    "every source builds without a warning": every_source,
    "unit tests, contracts executed": lambda: unit_tests("test"),
    "unit tests, contracts not executed": lambda: unit_tests("host"),
    "simulation": simulation_tests,
    "ground station, live": live_ground_tests,
    "real time": real_time_tests,
    "real time, measured": measuring_tests,
    "ground station": ground_tests,
    "bare machines": target_tests,
    "likely changes": change_tests,
    "links of the requirements": links,
    "static data": node_size,
    "proof record is of these sources": record_is_current,
    "proof shows the recorded checks": proof,
}

# Each of these lanes runs beside the other parts, its own in this order.
LANES = (("ground station, live", "real time", "simulation"),
         ("likely changes",))

QUICK_PARTS = {
    **{name: PARTS[name] for name in PARTS
       if name.startswith(("every", "links", "static", "proof record"))
       or name == "unit tests, contracts not executed"},
    "simulation, the quick tests": quick_simulation_tests,
}


def totals_line(counts):
    return "{} passed, {} failed, {} skipped".format(*counts)


def duration(seconds):
    minutes, seconds = divmod(round(seconds), 60)
    return f"{minutes} min {seconds} s" if minutes else f"{seconds} s"


def chosen(arguments):
    """The parts whose names begin so; all if nothing is asked for."""
    if arguments == ["--quick"]:
        return QUICK_PARTS
    for each in arguments:
        if not any(name.startswith(each) for name in PARTS):
            sys.exit(f"no part begins with {each}: {', '.join(PARTS)}")
    return {name: part for name, part in PARTS.items()
            if not arguments or name.startswith(tuple(arguments))}


def run_part(part, name):
    """Run a part; return its counts and its time."""
    screen.put(f"== {name}\n")
    began = time.monotonic()
    try:
        counts = part()
    except Exception as fault:  # pylint: disable=broad-except
        # The last line must come, whatever happens.
        screen.put(f"{name}: {fault!r}\n")
        tests.append(Test(0, True, name))
        counts = BROKEN
    took = time.monotonic() - began
    screen.put(f"== {name}: {totals_line(counts)}, in {duration(took)}\n\n")
    return counts, took


def run_parts(parts):
    """The results of the parts, in their order. All is built first, for a
    program must not change while it runs. Then come the lanes and, beside them,
    the other parts, but for those that measure times and the proof: these run
    alone, at the end."""
    names = list(parts)
    lanes = [[name for name in lane if name in parts] for lane in LANES]
    others = [name for name in names if not any(name in lane for lane in LANES)]
    results = {}

    def run_all(some):
        for name in some:
            results[name] = run_part(parts[name], name)

    if not any(lanes) or not others:
        for lane in [*lanes, others]:
            run_all(lane)
    else:
        before = [name for name in others if parts[name] is every_source]
        after = [name for name in others
                 if parts[name] in (measuring_tests, proof)]
        run_all(before)
        modes = [mode for mode in ("test", "host")
                 if any(name.startswith("unit tests") for name in others)]
        for project, mode in (SIMULATION, PARTITIONS,
                              *((UNIT_TESTS, mode) for mode in modes)):
            build(project, mode)
        beside = [threading.Thread(target=run_all, args=(lane,), daemon=True)
                  for lane in lanes]
        for lane in beside:
            lane.start()
        run_all([name for name in others if name not in before + after])
        for lane in beside:
            lane.join()
        run_all(after)
    return {name: results[name] for name in names}


def main():
    # A shell that starts this in the background makes it ignore interrupts,
    # and so would each program that a test interrupts.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    RESULTS.mkdir(parents=True, exist_ok=True)
    parts = chosen(sys.argv[1:])
    results = run_parts(parts)
    counts = {name: results[name][0] for name in parts}
    print("== slowest tests")
    for test in sorted(tests, reverse=True)[:SLOWEST]:
        print(f"{test.seconds:6.1f} s  {test.name}")
    failed = [test.name for test in tests if test.failed]
    if failed:
        print("\n== failed", *failed, sep="\n")
    print("\n== all")
    for name, of_part in counts.items():
        print(f"{name}: {totals_line(of_part)},"
              f" in {duration(results[name][1])}")
    total = [sum(column) for column in zip(*counts.values())]
    last_line = totals_line(total)
    (RESULTS / "totals").write_text(f"{last_line}\n", encoding="utf-8")
    print(last_line)
    return 0 if total[1] == 0 and total[0] > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
