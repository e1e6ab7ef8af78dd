# SPDX-License-Identifier: Apache-2.0
"""How a mutant of what judges the flight software is tried: by the tests that
look at the changed file, the quick ones first."""

import hashlib
import marshal
import os
import re
import subprocess
import sys
from fnmatch import fnmatch
from pathlib import Path

import mutants
import python_mutants
from copies import RELAXED, Copy, set_limits
from fates import EQUIVALENT, INVALID, ROOT, SURVIVED

PROGRAMS = {
    "sim/": [("sim/urv_sim.gpr", "host")],
    "real_time/": [("real_time/urv_real_time.gpr", "flight")],
    "host/": [("sim/urv_sim.gpr", "host"),
              ("real_time/urv_real_time.gpr", "flight")],
    "": [],
}

FLYING = ["data_path", "items", "wire", "events", "latency", "determinism",
          "line_faults", "input", "command_line", "urv_sim_page", "numbers",
          "starts", "faults"]
AIRCRAFT = ["aircraft", "truth", "pilot", "flight"]
IN_REAL_TIME = ["partition_arguments", "partition_peers", "partition_safety",
                "partition_signals", "partition_reports", "partition_flights",
                "partition_input", "partition_plant", "partition_station",
                "partition_flood", "partition_lock", "partition_seal",
                "gates"]

# The tests for a changed file: those of the first pattern that it matches.
TESTS = {
    "sim/jsbsim/servo_faults.py": ["surface_faults", *AIRCRAFT],
    "sim/jsbsim/*": AIRCRAFT + ["conditions", "surface_faults"],
    "host/host-pilot*": AIRCRAFT[::-1] + ["circuit", *FLYING],
    "host/host-bench*": ["bench", *FLYING],
    "host/host-key_files*": ["seal", "partition_seal", *FLYING],
    "host/host-plant*": AIRCRAFT + FLYING,
    "sim/sim-jsbsim*": AIRCRAFT + FLYING,
    "sim/sim-flight_quality*": AIRCRAFT[::-1] + FLYING,
    "sim/sim-circuit_quality*": ["circuit", *FLYING],
    "sim/sim-conditions*": ["conditions", *FLYING],
    "host/host-surface_faults*": ["surface_faults", *FLYING],
    "sim/sim-console_faults*": ["lost_console", *FLYING],
    "sim/*": FLYING + AIRCRAFT,
    "host/*": FLYING + ["truth", "aircraft"] + IN_REAL_TIME,
    "real_time/*": IN_REAL_TIME,
    "scripts/ada_source.py": ["claims", "contracts", "mutants",
                              "proof_record", "traceability"],
    "scripts/aircraft_steps.py": ["aircraft"],
    "scripts/bench.py": ["benchmarks"],
    "scripts/bench/*": ["benchmarks"],
    "scripts/campaign/*": ["campaign_checker", "campaign", "link_theory",
                           "safety_mixes"],
    "scripts/console_losses.py": ["lost_console"],
    "scripts/flight_numbers.py": ["campaign_checker", "link_theory"],
    "scripts/floods.py": ["partition_flood"],
    "scripts/laws/costs.py": ["law_costs"],
    "scripts/laws/*": ["margins", "surfaces"],
    "scripts/machine_pauses.py": ["timing"],
    "scripts/mutation/*": ["mutants"],
    "scripts/proof_canaries.py": ["canaries", "proof_record"],
    "scripts/proof_stamp.py": ["proof_record", "canaries"],
    "scripts/attack.py": ["seal"],
    "scripts/hashes.py": ["supply_chain"],
    "scripts/seal_tags.py": ["seal"],
    "scripts/safety/*": ["safety_monitor", "lost_console", "safety_mixes"],
    "scripts/test_lines.py": ["run_tests"],
    "scripts/trace/*": ["traceability"],
    # The others have a file of tests of their name.
    "scripts/*": ["{}"],
}

# They try mutants. No test does that with them, it would take too long.
TRY_MUTANTS = {f"scripts/mutation/{name}.py" for name in (
    "copies", "flight_trials", "judge_trials", "run")}

PYTEST = [sys.executable, "-B", "-m", "pytest", "-x", "-q", "--tb=no",
          "-p", "no:cacheprovider", "-k", "not thousand"]
FAILED = re.compile(r"^(?:FAILED|ERROR) (\S+)", re.M)

BUILD_LIMIT_S = 900
TEST_LIMIT_S = 1500


def is_python(path):
    return path.endswith(".py")


def of(table, path):
    return next(value for pattern, value in table.items()
                if fnmatch(path, pattern))


def tests_for(path):
    names = (name.format(Path(path).stem) for name in of(TESTS, path))
    return [f"tests/{folder}/test_{name}.py" for name in names
            for folder in [
                "real_time" if name in IN_REAL_TIME else "simulation"]]


def programs_for(path):
    return next(programs for folder, programs in PROGRAMS.items()
                if path.startswith(folder))


def judges():
    """What judges, in Python: the names of its files."""
    names = [path.relative_to(ROOT).as_posix()
             for folder in ("scripts", "sim")
             for path in sorted((ROOT / folder).rglob("*.py"))]
    return [name for name in names if name not in TRY_MUTANTS]


def every_mutant():
    """Of what judges, in Ada; and every place for one in Python."""
    found = mutants.Code(ROOT).mutants(mutants.JUDGES)
    for name in judges():
        found += python_mutants.places(
            name, (ROOT / name).read_text(encoding="utf-8"))
    return found


class JudgeTrial(Copy):
    """Tries mutants in a copy of the whole repository."""

    place = "judge"
    # Tests that fail without any change; the first worker finds them for all.
    unfit = None

    def __init__(self, number):
        names = subprocess.run(
            ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True,
            check=True).stdout.splitlines()
        self.copied = sorted({name.split("/")[0] for name in names})
        self.changing = [name for name in self.copied
                         if name in ("scripts", "sim", "host", "real_time")]
        super().__init__(number)
        self.objects = {}

    def prepare(self, _stage, wanted):
        """Why what judges does not build, or nothing. A test that fails
        without any change tells nothing, and is left out."""
        self.renew()
        # Flights with JSBSim look for their Python here.
        installed = self.root / ".venv"
        if not installed.exists():
            installed.symlink_to(ROOT / ".venv")
        self.edit("urv.gpr", RELAXED)
        for programs in PROGRAMS.values():
            for program in programs:
                status, output = self.build(program)
                if status != 0:
                    return output
        self.objects = self.object_code()
        if JudgeTrial.unfit is None:
            JudgeTrial.unfit = self.unfit_of(dict.fromkeys(
                file for mutant in wanted for file in tests_for(mutant.path)))
            for test in sorted(self.unfit):
                print(f"mutation: fails without any change, left out: {test}")
        return None

    def unfit_of(self, files):
        """Tests that fail in this copy, and files that no test comes from."""
        found = set()
        for file in files:
            status, output = self.pytest([file], "--maxfail=1000")
            found |= set(FAILED.findall(output))
            if status not in (0, 1):
                found.add(file)
        return found

    def build(self, program):
        project, mode = program
        return self.run(["gprbuild", "-q", "-p", "-j1", "-P", project,
                         f"-XURV_Mode={mode}"], BUILD_LIMIT_S)

    def object_code(self):
        """Of all that is built, without debugging aids."""
        found = {}
        for path in sorted((self.root / "obj").rglob("*.o")):
            built = path.stat().st_mtime_ns
            if self.objects.get(path, (0,))[0] == built:
                found[path] = self.objects[path]
                continue
            copy = self.root / "obj" / "stripped"
            subprocess.run(["objcopy", "--strip-debug", path, copy],
                           check=True)
            found[path] = (built, hashlib.sha256(
                copy.read_bytes()).hexdigest())
        return found

    def same_object_code(self):
        now = self.object_code()
        return all(now[path][1] == self.objects[path][1]
                   for path in now if path in self.objects)

    def pytest(self, tests, *more):
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith("URV_")}
        return self.run([*PYTEST, *more, *tests], TEST_LIMIT_S,
                        preexec_fn=set_limits, env=environment)

    def seen(self, mutant):
        if isinstance(mutant, python_mutants.Place):
            source = self.source(mutant.path).decode()
            return python_mutants.mutant_at(mutant, source)
        return mutant

    def test(self, mutant):
        """What becomes of a mutant, and who said so."""
        source = self.source(mutant.path)
        self.put(mutant)
        changed = (self.root / mutant.path).read_bytes()
        if is_python(mutant.path):
            if compiled(changed) is None:
                return INVALID, ""
            if compiled(changed) == compiled(source):
                return EQUIVALENT, ""
        for program in programs_for(mutant.path):
            status, _ = self.build(program)
            if status != 0:
                return INVALID, ""
        if not is_python(mutant.path) and self.same_object_code():
            return EQUIVALENT, ""
        for file in tests_for(mutant.path):
            if file in self.unfit:
                continue
            left_out = [f"--deselect={test}" for test in self.unfit
                        if test.startswith(f"{file}::")]
            status, output = self.pytest([file], *left_out)
            # 5: every test of the file is left out.
            if status not in (0, 5):
                failed = FAILED.search(output)
                return "tests", (failed[1] if failed else
                                 f"{file}: pytest ended with {status}")
        return SURVIVED, ""


def compiled(source):
    """Its code; nothing if it is no Python."""
    try:
        return marshal.dumps(compile(source, "judge", "exec"))
    except (SyntaxError, ValueError):
        return None
