# SPDX-License-Identifier: Apache-2.0
"""The trials of a mutant of the flight software: by the unit tests with
contracts executed, by its object code, by simulated flights, by the proof."""

import hashlib
import json
import os
import re
import subprocess
import sys
import threading
from pathlib import Path

from copies import RELAXED, Copy, set_limits
from fates import EQUIVALENT, INVALID, PASSED, ROOT, SURVIVED

from ada_source import WITHED, sources

UNIT_TESTS = ["gprbuild", "-q", "-p", "-j1", "-P", "tests/urv_tests.gpr",
              "-XURV_Mode=test"]
SIMULATOR = ["gprbuild", "-q", "-p", "-j1", "-P", "sim/urv_sim.gpr",
             "-XURV_Mode=host"]
SIMULATOR_OBJECTS = ("obj/host", "obj/host-host", "obj/sim-host")
TEST_OBJECTS = ("obj/test", "obj/test/unit")
PROVER = ["gnatprove", "-P", "urv.gpr", "-XURV_Mode=flight", "-j1"]

# The quick ones of the simulation's tests that look at the data's path; of
# some folders also those that spoil the line, fly by the laws, seal the link.
SIMULATION_TESTS = ["test_data_path.py", "test_wire.py"]
FOLDER_TESTS = {"telemetry": ["test_faults.py"], "laws": ["test_laws.py"],
                "seal": ["test_seal.py"]}

BUILD_LIMIT_S = 900
TEST_LIMIT_S = 600
PROOF_LIMIT_S = 1200


def simulation_tests(wanted):
    """The files of tests that some mutants go to."""
    folders = sorted({mutant.path.split("/")[1] for mutant in wanted})
    return [*SIMULATION_TESTS, *(name for folder in folders
                                 for name in FOLDER_TESTS.get(folder, ()))]


class FlightTrial(Copy):
    """Tries mutants in a copy."""

    def __init__(self, number):
        super().__init__(number)
        self.in_simulator = None
        self.hashes = {}
        self.objects = None
        self.proved = {}

    def prepare(self, stage, wanted):
        """Why the software without a change does not do, or nothing. If it is
        for tests it is built, and passes those that are wanted."""
        self.renew()
        self.edit("urv.gpr", RELAXED)
        self.edit("tests/urv_tests.gpr", [
            (r'use URV.Ada_Switches;', 'use URV.Ada_Switches & ("-O0");'),
        ])
        if stage is not FlightTrial.test:
            return None
        for command in (UNIT_TESTS, SIMULATOR):
            status, output = self.run(command, BUILD_LIMIT_S)
            if status != 0:
                return output
        self.in_simulator = self.units_in_simulator()
        self.objects = {tests_too: self.object_code(tests_too)
                        for tests_too in (False, True)}
        return (self.unit_tests()
                or self.simulation(simulation_tests(wanted)))

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
        """A digest of an object file without debugging aids; known, if it was
        not built since it was last asked for."""
        built = path.stat().st_mtime_ns
        if self.hashes.get(path, (0, ""))[0] != built:
            copy = self.root / "obj" / "stripped.o"
            subprocess.run(["objcopy", "--strip-debug", path, copy],
                           check=True)
            found = hashlib.sha256(copy.read_bytes()).hexdigest()
            self.hashes[path] = (built, found)
        return self.hashes[path][1]

    def same_object_code(self, mutant):
        """True if the mutant is the original in other words. Units that the
        simulator does not have are looked for in the unit tests."""
        every = Path(mutant.path).name not in self.in_simulator
        return self.object_code(every) == self.objects[every]

    def unit_tests(self):
        """Why the unit tests fail, or nothing. The first failure ends
        them."""
        process = self.start(["bin/urv_tests_test"], preexec_fn=set_limits)
        alarm = threading.Timer(TEST_LIMIT_S, self.stop)
        alarm.start()
        failure, last = None, ""
        for line in process.stdout:
            last = line.strip()
            if line.startswith("FAIL"):
                failure = line[len("FAIL"):].strip()
                self.stop()
                break
        process.stdout.close()
        status = process.wait()
        alarm.cancel()
        if failure or status == 0:
            return failure
        return f"ended with {status} after: {last[:100]}"

    def simulation(self, names):
        """Why these tests of the simulation fail, or nothing."""
        tests = [f"tests/simulation/{name}" for name in names]
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
        """The checks that GNATprove does not prove in some units."""
        if not units:
            return set()
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
                # Without the change.
                self.put(None)
                self.proved[key] = self.failed_checks(units)
                self.put(mutant)
            new = self.failed_checks(units) - self.proved[key]
            if new:
                return "{}:{}: {}".format(*min(new, key=str))
        return None

    def test(self, mutant):
        """The result of a mutant before the proof, and the test that gave
        it."""
        self.put(mutant)
        status, _ = self.run(UNIT_TESTS, BUILD_LIMIT_S)
        if status != 0:
            return INVALID, ""
        failure = self.unit_tests()
        if failure:
            return "tests", failure
        status, _ = self.run(SIMULATOR, BUILD_LIMIT_S)
        if status != 0:
            return INVALID, ""
        if self.same_object_code(mutant):
            return EQUIVALENT, ""
        failure = self.simulation(simulation_tests([mutant]))
        if failure:
            return "simulation", failure
        return PASSED, ""

    def prove(self, mutant):
        """True if a mutant that passes the tests fails the proof."""
        self.put(mutant)
        failure = self.proof(mutant)
        return ("proof", failure) if failure else (SURVIVED, "")


def concerned(path):
    """The units whose proof a change can concern: first its own, then, of a
    specification or a generic, those that name it, and so on."""
    own = Path(path).stem
    texts = {}
    for file in sources(ROOT, "src", "proofs"):
        text = texts.setdefault(file.stem, "")
        texts[file.stem] = text + file.read_text(encoding="utf-8")
    uses = {
        unit: {name.lower().replace(".", "-")
               for name in WITHED.findall(text)}
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
