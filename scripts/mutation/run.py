#!/usr/bin/env python3
"""Change the flight software in small ways; see who notices.

Each mutant is built, then given to the unit tests with contracts executed.
One that passes and has the same object code as the original is the original
in other words, and is set aside. The others go to the simulation's tests.
When all mutants have been there, those that are left go to the proof of the
units that the change can concern: of a body its own, of a specification all
that depend on it. The first to notice is recorded.

Results are appended to a file as they come. A run goes on where the last one
stopped; a mutant is tried again when the file it changes has changed.

Exit status: 0 done; 1 the unchanged software does not pass its own tests.
"""

import argparse
import hashlib
import json
import os
import queue
import re
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import mutants

ROOT = Path(__file__).resolve().parents[2]
RESULTS = ROOT / "tests" / "mutation" / "results.jsonl"
WORKPLACE = ROOT / "obj" / "mutation"

SEED = 1991
SHARE, LEAST, MOST = 0.15, 4, 10

COPIED = ("src", "proofs", "sim", "tests", "real_time", "scripts",
          "urv.gpr", "ravenscar.adc")
UNIT_TESTS = ["gprbuild", "-q", "-p", "-j1", "-P", "tests/urv_tests.gpr",
              "-XURV_Mode=test"]
SIMULATOR = ["gprbuild", "-q", "-p", "-j1", "-P", "sim/urv_sim.gpr",
             "-XURV_Mode=host"]
SIMULATOR_OBJECTS = ("obj/host", "obj/sim-host")
TEST_OBJECTS = ("obj/test", "obj/test/unit")
PROVER = ["gnatprove", "-P", "urv.gpr", "-XURV_Mode=flight", "-j1"]

# The unit tests after this one take more than half of the time. They spoil
# the line in every way: for mutants of the telemetry board only.
LAST_QUICK_TEST = "LNK-10 the board counts the messages received"

# The quick ones of the simulation's tests that look at the data's path; of
# the telemetry board also those that spoil the line.
SIMULATION_TESTS = ["test_data_path.py", "test_wire.py"]
TELEMETRY_TESTS = ["test_faults.py"]

BUILD_LIMIT_S = 900
TEST_LIMIT_S = 600
PROOF_LIMIT_S = 1200
# Of one program under test; without a change none needs half of it.
CPU_LIMIT_S = 240
MEMORY_LIMIT = 4 * 2 ** 30

# What became of a mutant.
INVALID = "does not build"
EQUIVALENT = "same object code"
PASSED = "passes the tests"
SURVIVED = "survived"
KILLED = ("tests", "simulation", "proof")


def needs_every_test(mutant):
    return mutant.path.startswith("src/telemetry/")


def set_limits():
    """A mutant that goes on for ever is ended, however slow the machine."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_LIMIT_S, CPU_LIMIT_S))


class Worker:
    """A copy of the repository in which one mutant at a time lives."""

    def __init__(self, number):
        self.root = WORKPLACE / f"worker-{number}"
        self.original = WORKPLACE / f"original-{number}"
        self.changed = None
        self.in_simulator = None
        self.hashes = {}
        self.objects = None
        self.proved = {}
        self.process = None

    def start(self, command, **more):
        """Start a command in a process group of its own."""
        self.process = subprocess.Popen(
            command, cwd=self.root, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, errors="replace",
            start_new_session=True, **more
        )
        return self.process

    def stop(self):
        """End what the worker is running, with all that it started."""
        if self.process and self.process.returncode is None:
            try:
                os.killpg(self.process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def run(self, command, limit, **more):
        """Run a command to its end; status None: it took too long."""
        process = self.start(command, **more)
        try:
            output, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            self.stop()
            process.communicate()
            return None, ""
        return process.returncode, output

    def prepare(self, tests, every):
        """The copy as the repository is now; if it is for tests, built, and
        it passes them, every one if wanted."""
        for name in COPIED:
            source, target = ROOT / name, self.root / name
            if source.is_dir():
                self.synchronise(source, target)
            else:
                target.parent.mkdir(parents=True, exist_ok=True)
                if not same(source, target):
                    shutil.copy(source, target)
        for name in ("src", "proofs"):
            self.synchronise(ROOT / name, self.original / name)
        # A mutant may have a condition that is always true. What only helps
        # to debug, and the tests' own speed, would cost building time.
        self.edit("urv.gpr", [
            (r'Strict_Switches := \(.*?\);', 'Strict_Switches := ("-gnatws");'),
            (r'Debug_Switches  := \("-g"\);', 'Debug_Switches  := ("-g0");'),
        ])
        self.edit("tests/urv_tests.gpr", [
            (r'use URV.Ada_Switches;', 'use URV.Ada_Switches & ("-O0");'),
        ])
        if not tests:
            return None
        for command in (UNIT_TESTS, SIMULATOR):
            status, output = self.run(command, BUILD_LIMIT_S)
            if status != 0:
                return output
        self.in_simulator = self.units_in_simulator()
        self.objects = {every: self.object_code(every)
                        for every in (False, True)}
        return self.unit_tests(every) or self.simulation(every)

    def edit(self, name, changes):
        """The repository's file with some changes, built anew only if it is
        not as it was."""
        text = (ROOT / name).read_text(encoding="utf-8")
        for old, new in changes:
            text, number = re.subn(old, new, text, flags=re.S)
            assert number == 1, f"{name}: {old}"
        project = self.root / name
        if not project.exists() or project.read_text("utf-8") != text:
            project.write_text(text, encoding="utf-8")

    def synchronise(self, source, target):
        """Copy what differs, remove what is gone; keep what is the same as
        old as it was, so that it is not built again."""
        wanted = {path.relative_to(source) for path in source.rglob("*")
                  if path.is_file() and "__pycache__" not in path.parts}
        if target.exists():
            for path in target.rglob("*"):
                if path.is_file() and path.relative_to(target) not in wanted:
                    path.unlink()
        for name in wanted:
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            if not same(source / name, target / name):
                shutil.copy(source / name, target / name)

    def put(self, mutant):
        """Undo the last change, make this one."""
        if self.changed and (not mutant or mutant.path != self.changed):
            (self.root / self.changed).write_bytes(self.source(self.changed))
            self.changed = None
        if mutant:
            source = self.source(mutant.path)
            (self.root / mutant.path).write_bytes(mutant.applied(source))
            self.changed = mutant.path

    def source(self, path):
        """A file as it was when the worker began."""
        return (self.original / path).read_bytes()

    def units_in_simulator(self):
        """The files of src that the simulator is made of, generics too."""
        found = set()
        for folder in SIMULATOR_OBJECTS:
            for path in (self.root / folder).glob("*.ali"):
                text = path.read_text(encoding="utf-8", errors="replace")
                found |= set(re.findall(r"^D (\S+)", text, re.M))
        return found

    def object_code(self, tests_too):
        """The code of the simulator, without debugging aids; if wanted, that
        of the unit tests, too."""
        folders = SIMULATOR_OBJECTS + (TEST_OBJECTS if tests_too else ())
        return {path: self.hash_of(path) for folder in folders
                for path in sorted((self.root / folder).glob("*.o"))}

    def hash_of(self, path):
        """Of an object file without debugging aids; known, if it was not
        built since it was last asked for."""
        built = path.stat().st_mtime_ns
        if self.hashes.get(path, (0, ""))[0] != built:
            copy = self.root / "obj" / "stripped.o"
            subprocess.run(["objcopy", "--strip-debug", path, copy],
                           check=True)
            found = hashlib.sha256(copy.read_bytes()).hexdigest()
            self.hashes[path] = (built, found)
        return self.hashes[path][1]

    def same_object_code(self, mutant):
        """Whether the mutant is the original in other words. What the
        simulator does not have is looked for in the unit tests."""
        every = Path(mutant.path).name not in self.in_simulator
        return self.object_code(every) == self.objects[every]

    def unit_tests(self, every):
        """Why the unit tests fail, or nothing. The first failure ends
        them."""
        process = self.start(["bin/urv_tests_test"], preexec_fn=set_limits)
        alarm = threading.Timer(TEST_LIMIT_S, self.stop)
        alarm.start()
        failure, last, enough = None, "", False
        for line in process.stdout:
            last = line.strip()
            enough = enough or last.endswith(LAST_QUICK_TEST)
            if line.startswith("FAIL"):
                failure = line[len("FAIL"):].strip()
            if failure or (enough and not every):
                self.stop()
                break
        process.stdout.close()
        status = process.wait()
        alarm.cancel()
        if failure or (enough and (status == 0 or not every)):
            return failure
        return f"ended with {status} after: {last[:100]}"

    def simulation(self, every):
        """Why the simulation's tests fail, or nothing."""
        tests = [f"tests/simulation/{name}" for name in
                 SIMULATION_TESTS + (TELEMETRY_TESTS if every else [])]
        status, output = self.run(
            [sys.executable, "-B", "-m", "pytest", "-x", "-q", "--tb=no",
             "-p", "no:cacheprovider", *tests], TEST_LIMIT_S,
            preexec_fn=set_limits,
            env={**os.environ, "URV_SIM": str(self.root / "bin/urv_sim")},
        )
        if status == 0:
            return None
        failed = re.search(r"^FAILED (\S+)", output, re.M)
        return failed[1] if failed else f"pytest ended with {status}"

    def failed_checks(self, units):
        """What GNATprove finds that does not hold in some units."""
        if not units:
            return set()
        kept = "proofs/sessions"
        self.synchronise(self.original / kept, self.root / kept)
        names = [file for unit in units for file in self.main_file(unit)]
        status, output = self.run([*PROVER, "-u", *names], PROOF_LIMIT_S)
        if status is None:
            return set()
        found = set()
        results = self.root / "obj" / "flight" / "gnatprove"
        for unit in units:
            path = results / f"{unit}.spark"
            if not path.exists():
                continue
            data = json.loads(path.read_text(encoding="utf-8"))
            for part in ("flow", "proof"):
                for check in data.get(part, []):
                    if check["severity"] not in ("info", "warning"):
                        found.add((check["file"], check["line"],
                                   check["rule"]))
        if status != 0 and not found:
            complaint = re.search(r"^\S+: error: .*$", output, re.M)
            found.add(("", "", complaint[0] if complaint
                       else f"gnatprove ended with {status}"))
        return found

    def main_file(self, unit):
        for folder in ("src", "proofs"):
            for ending in ("adb", "ads"):
                path = next((self.root / folder).rglob(f"{unit}.{ending}"), 0)
                if path:
                    return [path.name]
        return []

    def proof(self, mutant):
        """Which check fails that holds without the change, or nothing."""
        for units in concerned(mutant.path):
            key = tuple(units)
            if key not in self.proved:
                # Without the change: also warms up the sessions.
                self.put(None)
                self.proved[key] = self.failed_checks(units)
                self.put(mutant)
            new = self.failed_checks(units) - self.proved[key]
            if new:
                return "{}:{}: {}".format(*min(new, key=str))
        return None

    def test(self, mutant):
        """What becomes of a mutant short of the proof, and who said so."""
        self.put(mutant)
        every = needs_every_test(mutant)
        status, _ = self.run(UNIT_TESTS, BUILD_LIMIT_S)
        if status != 0:
            return INVALID, ""
        failure = self.unit_tests(every)
        if failure:
            return "tests", failure
        status, _ = self.run(SIMULATOR, BUILD_LIMIT_S)
        if status != 0:
            return INVALID, ""
        if self.same_object_code(mutant):
            return EQUIVALENT, ""
        failure = self.simulation(every)
        if failure:
            return "simulation", failure
        return PASSED, ""

    def prove(self, mutant):
        """Whether a mutant that passes the tests fails the proof."""
        self.put(mutant)
        failure = self.proof(mutant)
        return ("proof", failure) if failure else (SURVIVED, "")


def turn(path):
    """Folder by folder."""
    return mutants.FOLDERS.index(Path(path).parent.name), path


def same(one, other):
    return other.exists() and one.read_bytes() == other.read_bytes()


def concerned(path):
    """The units whose proof a change can concern: first its own, then, of a
    specification or a generic, those that name it, and so on."""
    own = Path(path).stem
    texts = {}
    for folder in ("src", "proofs"):
        for file in (ROOT / folder).rglob("*.ad[sb]"):
            if "canaries" not in file.parts:
                text = texts.setdefault(file.stem, "")
                texts[file.stem] = text + file.read_text(encoding="utf-8")
    uses = {
        unit: {name.lower().replace(".", "-") for name in re.findall(
            r"^\s*(?:limited |private )*with ([\w.]+)", text, re.M)}
        | ({unit.rsplit("-", 1)[0]} if "-" in unit else set())
        for unit, text in texts.items()
    }
    generic = re.search(r"^generic$", texts[own], re.M)
    yield [own]
    if path.endswith(".adb") and not generic:
        return
    reached, edge = {own}, {own}
    while edge:
        edge = {unit for unit, used in uses.items() if used & edge} - reached
        reached |= edge
        if edge:
            yield sorted(edge)


def digest(path):
    return hashlib.sha256((ROOT / path).read_bytes()).hexdigest()[:16]


def sources():
    return [path.relative_to(ROOT).as_posix()
            for path in (ROOT / "src").rglob("*.ad[sb]")]


def read_results(file=RESULTS):
    """By name, the last result of each mutant."""
    if not file.exists():
        return {}
    lines = file.read_text(encoding="utf-8").splitlines()
    return {result["name"]: result for result in map(json.loads, lines)}


class Progress:
    """How far it has come, on one line of a terminal."""

    def __init__(self, total):
        self.total = total
        self.done = 0
        self.alive = 0
        self.begun = time.monotonic()
        self.lock = threading.Lock()

    def step(self, mutant, fate):
        with self.lock:
            self.done += 1
            self.alive += fate in (PASSED, SURVIVED)
            seconds = time.monotonic() - self.begun
            left = seconds / self.done * (self.total - self.done)
            filled = 30 * self.done // self.total
            bar = "#" * filled + "." * (30 - filled)
            line = (f"[{bar}] {self.done}/{self.total}, {self.alive} "
                    f"alive, {left / 60:.0f} min left")
            if sys.stdout.isatty():
                print(f"\r{line} ", end="", flush=True)
            else:
                print(f"{line}; {Path(mutant.path).name}:{mutant.line} "
                      f"{fate}", flush=True)


def work(worker, stage, tasks, digests, progress, lock):
    while True:
        try:
            group = tasks.get_nowait()
        except queue.Empty:
            worker.put(None)
            return
        for mutant in group:
            begun = time.monotonic()
            fate, by = stage(worker, mutant)
            result = {
                "name": mutant.name, "path": mutant.path,
                "line": mutant.line, "subprogram": mutant.subprogram,
                "operator": mutant.operator, "change": mutant.change[:300],
                "fate": fate, "by": by,
                "seconds": round(time.monotonic() - begun, 1),
                "source": digests[mutant.path],
            }
            with lock, RESULTS.open("a", encoding="utf-8") as file:
                file.write(json.dumps(result) + "\n")
            progress.step(mutant, fate)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", default="", metavar="TEXT",
                        help="only files whose path contains this")
    parser.add_argument("--again", metavar="FATE",
                        help="also mutants of this result, once more")
    parser.add_argument("--no-proof", action="store_true",
                        help="leave the proof for another run")
    parser.add_argument("--list", action="store_true",
                        help="list the mutants, try none")
    arguments = parser.parse_args()

    digests = {path: digest(path) for path in sources()}
    every = mutants.Code(ROOT).mutants()
    results = read_results()
    picked = mutants.chosen(every, SEED, SHARE, LEAST, MOST, results)
    picked = [m for m in picked if arguments.only in m.path]
    if arguments.list:
        for m in picked:
            print(f"{m.name} {m.path}:{m.line} {m.operator}: {m.change}")
        return 0
    fresh = {
        name: result for name, result in results.items()
        if digests.get(result["path"]) == result["source"]
        and result["fate"] != arguments.again
    }
    untested = [m for m in picked if m.name not in fresh]
    print(f"mutation: {len(every)} mutants, {len(picked)} chosen, "
          f"{len(picked) - len(untested)} tested before")
    status = run_stage(Worker.test, untested, digests, arguments.jobs)
    if status != 0 or arguments.no_proof:
        return status
    results = read_results()
    unproved = [m for m in picked if results[m.name]["fate"] == PASSED]
    print(f"mutation: {len(unproved)} pass the tests and go to the proof")
    return run_stage(Worker.prove, unproved, digests, arguments.jobs)


def run_stage(stage, wanted, digests, jobs):
    """Take some mutants through one stage. Exit status."""
    if not wanted:
        return 0
    RESULTS.parent.mkdir(parents=True, exist_ok=True)
    groups = {}
    for mutant in wanted:
        groups.setdefault(mutant.path, []).append(mutant)
    tasks = queue.Queue()
    for path in sorted(groups, key=turn):
        tasks.put(groups[path])
    workers = [Worker(n) for n in range(min(jobs, len(groups)))]

    def leave(*_):
        for worker in workers:
            worker.stop()
        print("\nmutation: stopped; it goes on from here next time")
        os._exit(130)

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, leave)
    for worker in workers:
        problem = worker.prepare(
            stage is Worker.test, any(map(needs_every_test, wanted)))
        if problem:
            print(f"mutation: without any change: {problem}")
            return 1
    progress, lock = Progress(len(wanted)), threading.Lock()
    threads = [
        threading.Thread(
            target=work,
            args=(worker, stage, tasks, digests, progress, lock),
        )
        for worker in workers
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main())
