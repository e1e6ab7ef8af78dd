# SPDX-License-Identifier: Apache-2.0
"""EVI-2: what scripts/proof_canaries.py says of what GNATprove found."""

import json
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import proof_canaries  # noqa: E402

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


def test_a_canary_that_fails_for_its_reason_is_well():
    checks = [found(3), found(4, severity="info")]
    assert list(proof_canaries.judge(WANTED, checks)) == []


def test_a_part_of_its_line_may_be_proved():
    checks = [found(3), found(3, severity="info")]
    assert list(proof_canaries.judge(WANTED, checks)) == []


@pytest.mark.parametrize("check, complaint", [
    (found(3, severity="info"), "was proved"),
    (found(3, suppressed="justified"), "was proved"),
    (found(3, rule="VC_RANGE_CHECK", severity="info"), "was not looked at"),
    (found(4, severity="info"), "was not looked at"),
])
def test_a_canary_that_does_not_fail_is_reported(check, complaint):
    reported = list(proof_canaries.judge(WANTED, [check]))
    assert len(reported) == 1 and reported[0].endswith(complaint)
    assert reported[0].startswith("a.ads:3: VC_POSTCONDITION")


@pytest.mark.parametrize("check", [
    found(3, rule="VC_OVERFLOW_CHECK"),
    found(4),
    found(4, rule="UNINITIALIZED", severity="high"),
    found(4, rule="INEFFECTIVE", severity="warning"),
])
def test_another_reason_is_reported(check):
    reported = list(proof_canaries.judge(WANTED, [found(3), check]))
    assert len(reported) == 1 and "no canary's own reason" in reported[0]


def test_a_unit_that_was_left_out_is_reported():
    analysed = [{"spark": [{"spark": "all", "sloc": [{"file": "a.adb"}]}]}]
    names = ["a.ads", "a.adb", "b.ads"]
    reported = list(proof_canaries.not_analysed(names, analysed))
    assert reported == ["b: nothing of this canary was analysed"]


def test_every_kind_of_check_has_a_canary():
    record = (ROOT / "proofs" / "record.json").read_text(encoding="utf-8")
    kinds = {FLOW.get(kind, kind)
             for kind in json.loads(record)["checks_by_kind"]}
    marked = {rule for _, _, rule in proof_canaries.expected(ROOT)}
    assert kinds - marked == set()
