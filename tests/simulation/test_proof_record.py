# SPDX-License-Identifier: Apache-2.0
"""EVI-8: what the proof record takes for proved, and what for unchanged.

A program of the tests stands for GNATprove: it leaves the results it is told
to leave, in GNATprove's own form, of a project with one package.
"""

import json
import os
import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import ada_source  # noqa: E402
import proof_record  # noqa: E402

NULL = "procedure Refuse (Why : Word; How : Kind)\n  is null;\nprocedure Other;"
IMPORTED = "procedure Read (Data : out Byte)\nwith\n  Import,\n  Pre => True;"


@pytest.mark.parametrize(("text", "imported", "whole"), [
    (NULL, False, True),
    (IMPORTED, True, True),
    (IMPORTED, False, False),
    ("procedure Hide with SPARK_Mode => Off;\nprocedure Next is null;", True,
     False),
    ("procedure Work is  --  is null\nbegin\n  null;\nend Work;", True, False),
])
def test_only_what_is_null_or_on_the_bus_needs_no_body(
        text, imported, whole):
    assert ada_source.is_whole_declaration(text, imported) is whole


# --- what is proved, and what is not ----------------------------------------

GNATPROVE = """\
#!/usr/bin/env python3
import json, pathlib, shutil, sys
if sys.argv[1:] == ["--version"]:
    print("{version}")
    raise SystemExit
told = json.loads(pathlib.Path({told!r}).read_text())
pathlib.Path({runs!r}).open("a").write(" ".join(sys.argv[1:]) + "\\n")
folder = pathlib.Path("obj/flight/gnatprove")
folder.mkdir(parents=True)
folder.joinpath("shop.spark").write_text(json.dumps(told["results"]))
folder.joinpath("gnatprove.out").write_text(told["report"])
print(told["output"])
raise SystemExit(told["status"])
"""

SLOC = [{"file": "shop.ads", "line": 1}]
PLACE = {"file": "shop.adb", "line": 3, "col": 7, "severity": "info",
         "entity": {"name": "Shop", "sloc": SLOC}}
REPORT = """\
Analyzed 1 unit
in unit shop, 1 subprograms and packages out of 1 analyzed
  Shop at shop.ads:1 flow analyzed (0 errors, 0 checks, 0 warnings and \
0 pragma Assume statements) and proved (2 checks)
"""


def results():
    return {
        "spark": [{"name": "Shop", "spark": "all", "sloc": SLOC}],
        "pragma_assume": [],
        "flow": [{**PLACE, "rule": "INITIALIZED"}],
        "proof": [{**PLACE, "rule": "VC_POSTCONDITION",
                   "stats": {"Z3": {"count": 2}}},
                  {**PLACE, "rule": "VC_RANGE_CHECK"}],
        "session_map": {},
    }


class Prover:
    """A project of one package, and what GNATprove will find in it."""

    def __init__(self, folder, monkeypatch):
        self.root = folder / "project"
        self.told = folder / "told.json"
        self.runs = folder / "runs"
        self.tools = folder / "tools"
        self.tools.mkdir()
        for name, text in {
            "src/shop.ads": "package Shop is\nend Shop;\n",
            "src/shop.adb": "package body Shop is\nend Shop;\n",
            "proofs/canaries/bird.ads": "package Bird is end Bird;\n",
            "proofs/canaries/canaries.gpr": "project Canaries is\n",
            "ravenscar.adc": "pragma Profile (Ravenscar);\n",
            "urv.gpr": "package Prove is\n for Proof_Switches (\"Ada\")"
                       " use (\"--steps=9\");\nend Prove;\n",
        }.items():
            self.write(name, text)
        monkeypatch.setattr(proof_record, "ROOT", self.root)
        monkeypatch.setattr(
            proof_record, "RECORD", self.root / "proofs" / "record.json")
        monkeypatch.setattr(
            proof_record, "STAMP", self.root / "obj" / "proved.sha256")
        monkeypatch.setattr(proof_record, "canaries_alive", self.canaries)
        # They are many files, and the same in each of these tests.
        monkeypatch.setattr(proof_record.proof_stamp, "compiler_files", set)
        path = f"{self.tools}:{os.environ['PATH']}"
        monkeypatch.setenv("PATH", path)
        monkeypatch.setitem(
            proof_record.proof_canaries.ENVIRONMENT, "PATH", path)
        self.sung = []
        self.is_version("FSF 12.1")
        self.finds()
        self.runs.touch()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def canaries(self, _):
        return list(self.sung)

    def is_version(self, version):
        program = self.tools / "gnatprove"
        program.write_text(GNATPROVE.format(
            version=version, told=str(self.told),
            runs=str(self.runs)))
        program.chmod(0o755)

    def finds(self, change=lambda found: None, **more):
        found = results()
        change(found)
        self.told.write_text(json.dumps({
            "results": found, "report": REPORT, "output": "", "status": 0,
            **more}))

    def number_of_runs(self):
        return len(self.runs.read_text().splitlines())

    def runs_of(self, proofs):
        """How often GNATprove runs for some proofs, each all well or not."""
        before = self.number_of_runs()
        for is_well in proofs:
            assert (proof_record.prove() == []) is is_well
        return self.number_of_runs() - before


@pytest.fixture
def prover(tmp_path, monkeypatch):
    return Prover(tmp_path, monkeypatch)


def test_what_is_all_proved_is_recorded(prover):
    assert proof_record.prove() == []
    record = json.loads(proof_record.RECORD.read_text())
    assert record["checks"] == 3
    assert record["goals_by_prover"] == {"Z3": 2}
    unit = record["units"]["src/shop"]
    assert unit["files"].keys() == {"src/shop.ads", "src/shop.adb"}
    assert unit["checks"] == {
        "INITIALIZED": {"flow": 1}, "VC_POSTCONDITION": {"prover": 1},
        "VC_RANGE_CHECK": {"prover": 1}}
    assert proof_record.check(anew=True) == []


def severity(part, grade):
    def change(found):
        found[part][-1]["severity"] = grade
    return change


def justified(found):
    found["proof"][0]["suppressed"] = "it is so"


def assumed(found):
    found["pragma_assume"].append({"file": "shop.adb", "line": 2, "col": 1})


def partly_in_spark(found):
    found["spark"].append(
        {"name": "Shop.Till", "spark": "spec", "sloc": SLOC})


def not_analysed(found):
    found["spark"].clear()


UNPROVED = [
    *[pytest.param({"change": severity(part, grade)}, f": [A-Z_]+ {grade}$",
                   id=f"{part} {grade}")
      for part in ("flow", "proof")
      for grade in ("low", "medium", "high", "warning", "error")],
    pytest.param({"change": justified}, "justified, not proved",
                 id="justified"),
    pytest.param({"change": assumed}, "shop.adb:2:1: pragma Assume",
                 id="assumed"),
    pytest.param({"change": partly_in_spark}, "Shop.Till: not all in SPARK",
                 id="specification only"),
    pytest.param({"change": not_analysed}, "nothing of it was analysed",
                 id="not analysed"),
    pytest.param({"status": 1}, "gnatprove ended with 1", id="status"),
    *[pytest.param({"output": f"shop.adb:4:2: {grade}: why not"},
                   f"shop.adb:4:2: {grade}", id=f"says {grade}")
      for grade in ("error", "warning", "low", "medium", "high")],
    *[pytest.param({"report": REPORT.replace(*change)}, "Shop at shop.ads:1",
                   id=f"report {change[1]}")
      for change in (("and proved (2", "and not proved, 1 check out of (2"),
                     ("(0 errors", "(1 errors"), ("0 checks,", "1 checks,"),
                     ("0 warnings", "1 warnings"),
                     ("0 pragma", "1 pragma"))],
    pytest.param({"report": REPORT.replace("flow analyzed (0 errors",
                                           "skipped; body is SPARK_Mode")},
                 "Shop at shop.ads:1 skipped", id="report skipped"),
]


@pytest.mark.parametrize("found, reason", UNPROVED)
def test_what_is_not_proved_is_told_and_not_recorded(prover, found, reason):
    prover.finds(**found)
    for judge in (proof_record.prove,
                  lambda: proof_record.Proof(prover.root).failures):
        failures = judge()
        assert any(re.search(reason, each) for each in failures), failures
        assert not proof_record.RECORD.exists()


def test_a_proved_canary_is_told_and_nothing_recorded(prover):
    prover.sung = ["bird.ads:1: VC_ASSERT of a canary was proved"]
    assert proof_record.prove() == prover.sung
    assert not proof_record.RECORD.exists()


# --- what is of the record ---------------------------------------------------

@pytest.mark.parametrize("name", [
    "src/shop.ads", "src/shop.adb", "ravenscar.adc",
    "proofs/canaries/bird.ads", "proofs/canaries/canaries.gpr"])
def test_a_source_that_is_not_the_record_s_is_told(prover, name):
    assert proof_record.prove() == []
    path = prover.root / name
    text = path.read_text()
    # As long as before: only its hash tells.
    path.write_text(text[:-2] + "?\n")
    assert proof_record.check(False)[0] == \
        f"{name}: changed since it was proved"
    path.write_text(text)
    assert proof_record.check(False) == []
    if name != "ravenscar.adc":
        path.unlink()
        assert proof_record.check(False)[0] == \
            f"{name}: removed since it was proved"


@pytest.mark.parametrize("name", [
    "src/kernel/till.ads", "proofs/till.adb", "proofs/canaries/tit.ads"])
def test_a_source_that_the_record_has_not_is_told(prover, name):
    assert proof_record.prove() == []
    prover.write(name, "--  New.\n")
    assert proof_record.check(False)[0] == f"{name}: added, not proved"


@pytest.mark.parametrize("change", [
    ("--steps=9", "--steps=8"),
    ("end Prove", 'for Proof_Switches ("a.adb") use ("-u");\nend Prove')])
def test_switches_that_are_not_the_record_s_are_told(prover, change):
    assert proof_record.prove() == []
    path = prover.root / "urv.gpr"
    path.write_text(path.read_text().replace(*change))
    assert proof_record.check(False)[0] == \
        "urv.gpr: not the proof switches of the record"


def test_without_a_record_nothing_is_proved(prover):
    assert proof_record.check(False) == ["proofs/record.json is missing"]


def one_check_less(found):
    del found["proof"][-1]


def by_flow(found):
    found["flow"].append(found["proof"].pop())


@pytest.mark.parametrize("change", [one_check_less, by_flow,
                                    severity("proof", "medium")])
def test_a_proof_anew_that_finds_other_checks_is_told(prover, change):
    assert proof_record.prove() == []
    prover.finds(change)
    for _ in range(2):
        assert proof_record.check(anew=True) != []
        assert not proof_record.STAMP.exists()


def test_a_proof_anew_is_done_again_for_another_tool(prover):
    assert proof_record.prove() == []
    assert proof_record.check(anew=True) == []
    runs = prover.number_of_runs()
    assert proof_record.check(anew=True) == []
    assert prover.number_of_runs() == runs
    prover.is_version("FSF 12.2")
    assert proof_record.check(anew=True) == []
    assert prover.number_of_runs() == runs + 1


# --- a second run ------------------------------------------------------------

def test_a_second_run_reads_the_results_of_the_first(prover):
    assert proof_record.prove() == []
    proof_record.RECORD.unlink()
    assert prover.runs_of([True, True]) == 0
    assert json.loads(proof_record.RECORD.read_text())["checks"] == 3


CHANGES = {
    "a source": lambda prover: prover.write("src/shop.adb", "--  New.\n"),
    "one source more": lambda prover: prover.write("src/shop-a.ads", "--\n"),
    "one source less": lambda prover: (prover.root / "src/shop.adb").unlink(),
    "the project": lambda prover: prover.write(
        "urv.gpr", (prover.root / "urv.gpr").read_text() + "--  New.\n"),
    "the profile": lambda prover: prover.write("ravenscar.adc", "--\n"),
    "a session": lambda prover: prover.write(
        "proofs/sessions/shop/why3session.xml", "<new/>"),
    "the tool": lambda prover: prover.is_version("FSF 12.2"),
    "a prover": lambda prover: prover.write(
        "../libexec/spark/bin/z3", "another"),
    "a result": lambda prover: prover.write(
        "obj/flight/gnatprove/shop.spark", json.dumps(results()) + " "),
    "the report": lambda prover: prover.write(
        "obj/flight/gnatprove/gnatprove.out", REPORT + "\n"),
    "a stamp that is gone": lambda prover: (
        prover.root / "obj/flight/gnatprove/holds.sha256").unlink(),
}


@pytest.mark.parametrize("what", CHANGES)
def test_gnatprove_runs_again_when_anything_has_changed(prover, what):
    assert proof_record.prove() == []
    CHANGES[what](prover)
    is_well = what != "one source more"
    assert prover.runs_of([is_well]) == 1
    assert prover.runs_of([is_well]) == (0 if is_well else 1)


def test_gnatprove_runs_again_with_other_switches_or_surroundings(
        prover, monkeypatch):
    assert proof_record.prove() == []
    monkeypatch.setattr(proof_record, "COMMAND",
                        [*proof_record.COMMAND, "--level=0"])
    assert prover.runs_of([True, True]) == 1
    monkeypatch.setenv("ADA_INCLUDE_PATH", "elsewhere")
    assert prover.runs_of([True, True]) == 1


def test_gnatprove_runs_again_after_a_run_that_was_not_all_well(prover):
    prover.finds(severity("proof", "medium"))
    assert prover.runs_of([False, False]) == 2
    prover.finds()
    prover.sung = ["a canary was proved"]
    assert prover.runs_of([False, False]) == 2


def test_what_is_changed_while_it_is_proved_is_proved_again(
        prover, monkeypatch):
    with monkeypatch.context() as changed:
        changed.setattr(proof_record, "tidy_sessions", lambda _: prover.write(
            "src/shop.adb", "--  New.\n"))
        assert proof_record.prove() == []
    assert prover.runs_of([True, True]) == 1


def test_the_compiler_and_its_packages_are_among_the_tools(tmp_path,
                                                           monkeypatch):
    prover = tmp_path / "bin" / "gnatprove"
    theory = tmp_path / "share" / "spark" / "theories" / "ada.mlw"
    for path in (prover, theory):
        path.parent.mkdir(parents=True)
        path.touch(mode=0o755)
    monkeypatch.setenv("PATH", f"{prover.parent}:{os.environ['PATH']}")
    files = proof_record.proof_stamp.tool_files()
    assert {prover, theory} <= set(files)
    assert {"system.ads", "a-textio.adb"} <= {path.name for path in files}
    assert any("gcc" in path.name for path in files)
