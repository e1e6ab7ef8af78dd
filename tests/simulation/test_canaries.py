# SPDX-License-Identifier: Apache-2.0
"""EVI-2: what scripts/proof_canaries.py says of what GNATprove found."""

import json
import os
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
def test_a_canary_that_does_not_fail_is_told(check, complaint):
    told = list(proof_canaries.judge(WANTED, [check]))
    assert len(told) == 1 and told[0].endswith(complaint)
    assert told[0].startswith("a.ads:3: VC_POSTCONDITION")


@pytest.mark.parametrize("check", [
    found(3, rule="VC_OVERFLOW_CHECK"),
    found(4),
    found(4, rule="UNINITIALIZED", severity="high"),
    found(4, rule="INEFFECTIVE", severity="warning"),
])
def test_another_reason_is_told(check):
    told = list(proof_canaries.judge(WANTED, [found(3), check]))
    assert len(told) == 1 and "no canary's own reason" in told[0]


def test_a_unit_that_was_left_out_is_told():
    analysed = [{"spark": [{"spark": "all", "sloc": [{"file": "a.adb"}]}]}]
    names = ["a.ads", "a.adb", "b.ads"]
    told = list(proof_canaries.not_analysed(names, analysed))
    assert told == ["b: nothing of this canary was analysed"]


def test_every_kind_of_check_has_a_canary():
    record = (ROOT / "proofs" / "record.json").read_text(encoding="utf-8")
    units = json.loads(record)["units"].values()
    kinds = {FLOW.get(kind, kind) for unit in units for kind in unit["checks"]}
    marked = {rule for _, _, rule in proof_canaries.expected(ROOT)}
    assert kinds - marked == set()


# --- a second run ------------------------------------------------------------

GNATPROVE = """\
#!/usr/bin/env python3
import json, pathlib
folder = pathlib.Path("obj/canaries/gnatprove")
folder.mkdir(parents=True, exist_ok=True)
result = folder / "a.spark"
assert not result.exists()
result.write_text({result!r})
pathlib.Path("ran").touch()
"""

RESULT = {"spark": [{"spark": "all", "sloc": [{"file": "a.ads"}]}],
          "proof": [found(3)]}


@pytest.fixture
def nest(tmp_path, monkeypatch):
    """A tree with one canary, about one source; and what stands for
    GNATprove."""
    tools = tmp_path / "tools" / "bin"
    root = tmp_path / "root"
    for path, text in {
            tools / "gnatprove": GNATPROVE.format(
                result=json.dumps(RESULT)),
            root / "src" / "shop.ads": "package Shop is end Shop;",
            root / proof_canaries.FOLDER / "a.ads":
                "\n\nWrong  --  VC_POSTCONDITION\n",
            root / proof_canaries.FOLDER / "canaries.gpr": "project C is"
    }.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    (tools / "gnatprove").chmod(0o755)
    path = f"{tools}:{os.environ['PATH']}"
    monkeypatch.setenv("PATH", path)
    # They are many files, and no test here changes them.
    monkeypatch.setattr(proof_canaries.proof_stamp, "compiler_files", set)
    monkeypatch.setitem(proof_canaries.ENVIRONMENT, "PATH", path)
    return root


def look(root):
    """What is said, and whether GNATprove ran."""
    ran = root / "ran"
    ran.unlink(missing_ok=True)
    said = proof_canaries.failures(
        root, lambda: sorted((root / "src").iterdir()))
    return said, ran.exists()


def test_canaries_are_looked_at_again_when_anything_has_changed(nest):
    assert look(nest) == ([], True)
    assert look(nest) == ([], False)
    for path in (nest / "src" / "shop.ads",
                 nest / proof_canaries.FOLDER / "a.ads",
                 nest / proof_canaries.FOLDER / "canaries.gpr",
                 nest / "src" / "more.ads",
                 nest / "../tools/bin/gnatprove",
                 nest / "../tools/libexec/spark/bin/z3"):
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("a", encoding="utf-8") as file:
            file.write("\n# more\n")
        assert look(nest) == ([], True), path
        assert look(nest) == ([], False), path


def test_canaries_that_do_not_fail_are_looked_at_again(nest):
    assert look(nest) == ([], True)
    canary = nest / proof_canaries.FOLDER / "a.ads"
    text = canary.read_text(encoding="utf-8")
    canary.write_text(text + "More  --  VC_ASSERT\n", encoding="utf-8")
    for _ in range(2):
        said, ran = look(nest)
        assert said and ran
