# SPDX-License-Identifier: Apache-2.0
"""EVI-11: what scripts/work_times.py makes of what it measured."""

import os
import sys

from conftest import ROOT

sys.path.insert(0, str(ROOT / "scripts"))

import work_times  # noqa: E402


def test_the_largest_parts_come_first():
    parts = [("a", 1), ("b", 130), ("c", 59.6), ("d", 3)]
    assert work_times.largest(parts) == "b 2 min 10 s, c 1 min 0 s, d 3 s"


def test_parts_of_the_tests_are_read():
    said = ("simulation: 7 passed, 1 failed, 0 skipped, in 3 min 7 s,"
            " 22 s of it building\nstatic data: 1 passed, 0 failed, 0 skipped,"
            " in 0 s\n8 passed, 1 failed, 0 skipped\n")
    assert [(name, work_times.seconds_of(text))
            for name, _, text in work_times.PART.findall(said)] == [
        ("simulation", 187), ("static data", 0)]


def test_a_work_that_was_not_done_keeps_its_row(tmp_path, monkeypatch):
    page = tmp_path / "page.md"
    page.write_text(f"before\n\n{work_times.HEAD}| a | 1 s | x |\n"
                    "| b | 2 s | y |\n\nafter | work |\n")
    monkeypatch.setattr(work_times, "PAGE", page)
    work_times.renew(["| b | 3 s | z |", "| c | 4 s | w |"])
    assert page.read_text() == (
        f"before\n\n{work_times.HEAD}| a | 1 s | x |\n| b | 3 s | z |\n"
        "| c | 4 s | w |\n\nafter | work |\n")


def test_the_tests_are_timed_without_gnatprove(tmp_path, monkeypatch):
    prover, other = tmp_path / "prover", tmp_path / "other"
    for folder in (prover, other):
        folder.mkdir()
    (prover / "gnatprove").touch()
    monkeypatch.setenv("PATH", f"{other}{os.pathsep}{prover}")
    ran = []

    def run(clone, *command, env):
        ran.append((clone, command, env["PATH"]))
        return 61, "static data: 1 passed, 0 failed, 0 skipped, in 2 s\n"
    monkeypatch.setattr(work_times, "run", run)
    assert work_times.test(tmp_path) == [(
        "`make test`, without GNATprove", "1 min 1 s", "static data 2 s")]
    assert ran == [(tmp_path, ("make", "test"), str(other))]
