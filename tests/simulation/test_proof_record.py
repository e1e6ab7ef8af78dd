# SPDX-License-Identifier: Apache-2.0
"""EVI-8: only a complete proof of the present sources passes as a proof. EVI-2:
a canary that is proved, or fails for another reason, is reported.

A program of the tests replaces GNATprove: it leaves the results that it is
given, in GNATprove's form, of a project with one package.
"""

import json
import os
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import ada_source  # noqa: E402
import proof_canaries  # noqa: E402
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
def test_only_a_null_procedure_or_a_bus_cycle_needs_no_body(
        text, imported, whole):
    assert ada_source.is_whole_declaration(text, imported) is whole


GNATPROVE = """\
#!/usr/bin/env python3
import pathlib, shutil, sys
if sys.argv[1:] == ["--version"]:
    print("FSF 12.1")
    raise SystemExit
folder = pathlib.Path("obj/flight/gnatprove")
folder.mkdir(parents=True, exist_ok=True)
shutil.copy({results!r}, folder / "shop.spark")
raise SystemExit({status})
"""

SLOC = [{"file": "shop.ads", "line": 1}]
PLACE = {"file": "shop.adb", "line": 3, "col": 7, "severity": "info"}


def all_proved():
    return {
        "spark": [{"name": "Shop", "spark": "all", "sloc": SLOC}],
        "pragma_assume": [],
        "flow": [{**PLACE, "rule": "INITIALIZED"}],
        "proof": [{**PLACE, "rule": "VC_POSTCONDITION",
                   "stats": {"Z3": {"count": 2}}},
                  {**PLACE, "rule": "VC_RANGE_CHECK"}],
    }


class Project:
    """A project of one package, and the results of GNATprove for it."""

    def __init__(self, folder):
        self.root = folder / "project"
        self.results = folder / "results"
        self.tool = folder / "tools" / "gnatprove"
        self.tool.parent.mkdir()
        for name in ("src/shop.ads", "src/shop.adb", "src/kernel/ravenscar.adc",
                     "proofs/canaries/bird.ads", "urv.gpr"):
            self.write(name, f"--  {name}\n")
        self.finds()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def finds(self, change=lambda found: None, status=0):
        found = all_proved()
        change(found)
        self.results.write_text(json.dumps(found), encoding="utf-8")
        self.tool.write_text(GNATPROVE.format(
            results=str(self.results), status=status), encoding="utf-8")
        self.tool.chmod(0o755)

    def reasons(self, command):
        return proof_record.differences(self.root, command)

    def record(self):
        text = (self.root / proof_record.RECORD).read_text(encoding="utf-8")
        return json.loads(text)


@pytest.fixture
def project(tmp_path, monkeypatch):
    monkeypatch.setattr(proof_record.proof_canaries, "failures",
                        lambda root, environment: [])
    made = Project(tmp_path)
    monkeypatch.setenv("PATH", f"{made.tool.parent}:{os.environ['PATH']}")
    return made


def test_a_complete_proof_is_recorded(project):
    assert project.reasons("prove") == []
    record = project.record()
    assert record["checks"] == 3
    assert record["checks_by_kind"] == {
        "INITIALIZED": 1, "VC_POSTCONDITION": 1, "VC_RANGE_CHECK": 1}
    assert record["goals_by_prover"] == {"Z3": 2}
    assert project.reasons("check") == []
    assert project.reasons("sources") == []


def unproved(part, severity):
    return lambda found: found[part][-1].update(severity=severity)


INCOMPLETE = {
    "an unproved check": (unproved("proof", "medium"), 0,
                          "shop.adb:3:7: VC_RANGE_CHECK medium"),
    "a warning of flow analysis": (unproved("flow", "warning"), 0,
                                   "shop.adb:3:7: INITIALIZED warning"),
    "a justified check": (
        lambda found: found["proof"][0].update(suppressed="it is so"), 0,
        "shop.adb:3:7: VC_POSTCONDITION justified, not proved"),
    "an assumption": (
        lambda found: found["pragma_assume"].append(
            {"file": "shop.adb", "line": 2, "col": 1}), 0,
        "shop.adb:2: pragma Assume"),
    "a body out of SPARK": (
        lambda found: found["spark"].append(
            {"name": "Shop.Till", "spark": "spec", "sloc": SLOC}), 0,
        "Shop.Till: not all in SPARK"),
    "a unit without results": (
        lambda found: found["spark"].clear(), 0, "shop: not analysed"),
    "an error of GNATprove": (
        lambda found: None, 1, "gnatprove ended with 1"),
}


@pytest.mark.parametrize("case", INCOMPLETE)
def test_an_incomplete_proof_is_reported_and_not_recorded(project, case):
    change, status, reason = INCOMPLETE[case]
    project.finds(change, status)
    assert project.reasons("prove") == [reason]
    assert not (project.root / proof_record.RECORD).exists()


def test_a_proved_canary_fails_the_proof(project, monkeypatch):
    monkeypatch.setattr(proof_record.proof_canaries, "failures",
                        lambda root, environment: ["bird.ads:1: was proved"])
    assert project.reasons("prove") == ["bird.ads:1: was proved"]
    assert not (project.root / proof_record.RECORD).exists()


@pytest.mark.parametrize("name", [
    "src/shop.adb", "src/new.ads", "proofs/new.adb", "src/kernel/ravenscar.adc",
    "urv.gpr", "proofs/canaries/bird.ads"])
def test_a_changed_or_added_source_is_reported(project, name):
    assert project.reasons("prove") == []
    project.write(name, "--  New.\n")
    for command in ("sources", "check"):
        reason, = project.reasons(command)
        assert reason.startswith("the sources have changed")


def test_a_removed_source_is_reported(project):
    assert project.reasons("prove") == []
    (project.root / "src/shop.adb").unlink()
    assert len(project.reasons("sources")) == 1


def test_a_missing_record_is_reported(project):
    reason, = project.reasons("check")
    assert reason.startswith("proofs/record.json is missing")


def test_other_checks_than_the_recorded_ones_are_reported(project):
    assert project.reasons("prove") == []
    project.finds(lambda found: found["proof"].pop())
    reason, = project.reasons("check")
    assert reason.startswith("other checks than in proofs/record.json")


# --- canaries ----------------------------------------------------------------

WANTED = {("a.ads", 3, "VC_POSTCONDITION")}

# Reported for what they miss or for what they have too much, so that the
# record's name of the check when it holds is another.
FLOW = {
    "GLOBAL_WRONG": "GLOBAL_MISSING",
    "DEPENDS_WRONG": "DEPENDS_WRONG",
}


def found(line, rule="VC_POSTCONDITION", severity="medium", **more):
    check = {"file": "a.ads", "line": line, "rule": rule}
    return {**check, "severity": severity, **more}


def test_evi2_a_canary_that_fails_for_its_reason_is_well():
    checks = [found(3), found(4, severity="info")]
    assert list(proof_canaries.judge(WANTED, checks)) == []


def test_evi2_a_part_of_its_line_may_be_proved():
    checks = [found(3), found(3, severity="info")]
    assert list(proof_canaries.judge(WANTED, checks)) == []


@pytest.mark.parametrize("check, complaint", [
    (found(3, severity="info"), "was proved"),
    (found(3, suppressed="justified"), "was proved"),
    (found(3, rule="VC_RANGE_CHECK", severity="info"), "was not looked at"),
    (found(4, severity="info"), "was not looked at"),
])
def test_evi2_a_canary_that_does_not_fail_is_reported(check, complaint):
    reported = list(proof_canaries.judge(WANTED, [check]))
    assert len(reported) == 1 and reported[0].endswith(complaint)
    assert reported[0].startswith("a.ads:3: VC_POSTCONDITION")


@pytest.mark.parametrize("check", [
    found(3, rule="VC_OVERFLOW_CHECK"),
    found(4),
    found(4, rule="UNINITIALIZED", severity="high"),
    found(4, rule="INEFFECTIVE", severity="warning"),
])
def test_evi2_another_reason_is_reported(check):
    reported = list(proof_canaries.judge(WANTED, [found(3), check]))
    assert len(reported) == 1 and "no canary's own reason" in reported[0]


def test_evi2_a_unit_that_was_left_out_is_reported():
    analysed = [{"spark": [{"spark": "all", "sloc": [{"file": "a.adb"}]}]}]
    names = ["a.ads", "a.adb", "b.ads"]
    reported = list(proof_canaries.not_analysed(names, analysed))
    assert reported == ["b: nothing of this canary was analysed"]


def test_evi2_every_kind_of_check_has_a_canary():
    record = (ROOT / "proofs" / "record.json").read_text(encoding="utf-8")
    kinds = {FLOW.get(kind, kind)
             for kind in json.loads(record)["checks_by_kind"]}
    marked = {rule for _, _, rule in proof_canaries.expected(ROOT)}
    assert kinds - marked == set()
