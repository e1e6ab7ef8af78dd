# SPDX-License-Identifier: Apache-2.0
"""EVI-6: what each prover proves alone, told from what GNATprove says."""

import json
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import provers  # noqa: E402

UNITS = {"shop.adb": "src/shop"}
WELL = [("VC_RANGE_CHECK", "info")] * 2 + [("VC_POSTCONDITION", "info")] * 998


def result(*checks):
    return provers.result_of([{"proof": [
        {"file": "shop.adb", "line": line, "col": 7, "rule": rule,
         "severity": severity, "entity": {"name": "Shop.Sell"}}
        for line, (rule, severity) in enumerate(checks, 1)]}], UNITS)


def test_one_prover_and_no_sessions():
    text = (ROOT / "urv.gpr").read_text(encoding="utf-8")
    changed = provers.project_for("cvc4", text)
    assert '"--prover=cvc4", "--timeout=10"' in changed
    assert "Proof_Dir" in text and "Proof_Dir" not in changed
    assert "z3" not in changed.partition("package Prove")[2].lower()
    assert changed.partition("package Prove")[0] == text.partition(
        "package Prove")[0]


def test_without_its_place_the_project_is_refused():
    with pytest.raises(SystemExit):
        provers.project_for("z3", "project URV is end URV;")


@pytest.mark.parametrize("checks, well", [
    (WELL, True),
    ([*WELL, ("VC_POSTCONDITION", "medium")], True),
    ([*WELL, *[("VC_POSTCONDITION", "medium")] * 4], False),
    ([*WELL, ("VC_RANGE_CHECK", "medium")], False),
    ([*WELL, ("VC_OVERFLOW_CHECK", "low")], False)])
def test_each_run_time_check_and_99_7_percent_are_wanted(checks, well):
    assert provers.is_well(result(*checks)) is well


def test_checks_of_flow_analysis_count():
    found = [{"flow": [
        {"file": "shop.adb", "line": line, "col": 7, "rule": "INITIALIZED",
         "severity": severity, "entity": {"name": "Shop.Sell"}}
        for line, severity in enumerate(("info", "info", "high"), 1)]}]
    assert provers.figures(provers.result_of(found, UNITS)) == (3, 1, 0, 0)


def test_of_a_copy_that_has_all_a_unit_alone_is_told(tmp_path, monkeypatch):
    results = tmp_path / provers.proof_record.RESULTS
    results.mkdir(parents=True)
    for name in ("shop", "stall"):
        (results / f"{name}.spark").write_text(json.dumps(
            {"proof": [{"file": f"{name}.adb", "line": 1, "col": 7,
                        "rule": "VC_ASSERT", "severity": "medium",
                        "entity": {"name": name}}]}))
    (tmp_path / "src").mkdir()
    (tmp_path / "proofs").mkdir()
    monkeypatch.setattr(provers, "prepare", lambda prover: tmp_path)
    monkeypatch.setattr(provers, "ended_in_time", lambda *of: "")

    def told(units):
        return [check.subprogram
                for check in provers.prove("z3", 1, units).left]

    assert told(["shop.adb"]) == ["shop"]
    assert told([]) == ["shop", "stall"]


def test_what_only_one_proves_is_told():
    one = result(("VC_ASSERT", "info"), ("VC_RANGE_CHECK", "medium"))
    other = result(("VC_ASSERT", "medium"), ("VC_RANGE_CHECK", "info"))
    text = provers.tables({"CVC4": one, "Z3": other})
    assert "| CVC4 | 2 | 1 | 50.0 % | 1 | 0 |" in text
    assert "| Z3 | 2 | 1 | 50.0 % | 1 | 1 |" in text
    assert ("| `src/shop` | 1 | `Shop.Sell` | assert | proved | not |\n"
            "| `src/shop` | 2 | `Shop.Sell` | range check | not | proved |\n"
            ) in text


def test_instances_count_each():
    twice = result(("VC_ASSERT", "medium"))
    twice.left.update(result(("VC_ASSERT", "medium")).left)
    assert twice.left.total() == 2 and len(twice.left) == 1


def test_the_page_gets_the_tables_and_keeps_the_rest(tmp_path, monkeypatch):
    page = tmp_path / "provers.md"
    page.write_text(provers.PAGE.read_text(encoding="utf-8"))
    monkeypatch.setattr(provers, "PAGE", page)
    provers.renew("new\n")
    provers.renew("newer\n")
    text = page.read_text(encoding="utf-8")
    assert "newer\n" in text and "new\n" not in text
    assert text.startswith("# Each prover alone")


def test_a_copy_goes_on_and_has_the_sources_as_they_are(
        tmp_path, monkeypatch):
    root = tmp_path / "root"
    for name in ("src", "proofs"):
        (root / name).mkdir(parents=True)
    shop, stall = root / "src/shop.ads", root / "proofs/stall.ads"
    shop.write_text("package Shop is end Shop;\n")
    stall.write_text("package Stall is end Stall;\n")
    (root / "urv.gpr").write_text((ROOT / "urv.gpr").read_text("utf-8"))
    (root / "ravenscar.adc").write_text("")
    monkeypatch.setattr(provers, "ROOT", root)
    monkeypatch.setattr(provers, "COPY", tmp_path / "copy")
    copy = provers.prepare("z3")
    results = copy / provers.proof_record.RESULTS
    results.mkdir(parents=True)
    for name in ("shop", "stall"):
        (results / f"{name}.spark").write_text("")
    at = (copy / "src/shop.ads").stat().st_mtime_ns

    stall.unlink()
    provers.prepare("z3")
    assert (copy / "src/shop.ads").stat().st_mtime_ns == at
    assert [path.name for path in results.iterdir()] == ["shop.spark"]
    assert not (copy / "proofs/stall.ads").exists()

    shop.write_text("package Shop is end;\n")
    provers.prepare("z3")
    assert (copy / "src/shop.ads").read_text() == shop.read_text()
    assert results.exists()


def test_another_way_to_prove_begins_anew(tmp_path, monkeypatch):
    copy = tmp_path / "copy"
    monkeypatch.setattr(provers, "COPY", copy)
    (copy / "z3").mkdir(parents=True)
    (copy / "z3" / "urv.gpr").write_text("project Other is end Other;")
    (copy / "z3" / "proved").write_text("")
    provers.prepare("z3")
    assert not (copy / "z3" / "proved").exists()


def test_what_takes_longer_is_ended(tmp_path):
    assert provers.ended_in_time(["echo", "done"], tmp_path, 1) == "done\n"
    assert provers.ended_in_time(["sleep", "600"], tmp_path, 0.001) is None


@pytest.mark.parametrize("checks, renewed, status", [
    (WELL, True, 0), ([*WELL, ("VC_OVERFLOW_CHECK", "low")], True, 1),
    (None, False, 1)])
def test_what_is_not_well_or_not_done_fails(
        monkeypatch, capsys, checks, renewed, status):
    pages = []
    monkeypatch.setattr(provers, "renew", pages.append)
    monkeypatch.setattr(provers.shutil, "which", lambda _: "gnatprove")
    monkeypatch.setattr(provers, "prove", lambda *_: checks and result(*checks))
    monkeypatch.setattr(sys, "argv", ["provers.py", "--renew", "--minutes", "5"])
    assert provers.main() == status
    assert bool(pages) == renewed
    assert ("not done in 5 minutes" in capsys.readouterr().out) != renewed


def test_the_page_has_the_result_of_one_before_the_other_is_done(monkeypatch):
    pages = []
    monkeypatch.setattr(provers, "renew", pages.append)
    monkeypatch.setattr(provers.shutil, "which", lambda _: "gnatprove")
    monkeypatch.setattr(
        provers, "prove",
        lambda prover, *_: result(*WELL) if prover == "cvc4" else None)
    monkeypatch.setattr(sys, "argv", ["provers.py", "--renew", "--minutes", "5"])
    assert provers.main() == 1
    assert "| CVC4 | 1000 | 1000 | 100.0 % | 2 | 2 |" in pages[0]
    assert "\nZ3: not yet run over everything.\n" in pages[0]
