# SPDX-License-Identifier: Apache-2.0
"""Trials of the whole station, which take minutes (make -C evidence trials).

    def test_something(found):
        found("frames in the archive", "all", "30,000 of 30,000")

`found` keeps a line for docs/evidence/station.md, which URV_RENEW=1 writes when each
trial has passed. A skipped one would be missing there.
"""

import os
import shutil
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "evidence" / "station.md"

sys.path[:0] = [str(ROOT / folder)
                for folder in ("tests", "tests/ground", "ground")]

LINES = []
SKIPPED = []


@pytest.fixture
def found():
    def keep(what, wanted, measured):
        LINES.append(f"| {what} | {wanted} | {measured} |")
        print(f"trials: {what}: {measured} (wanted: {wanted})")
    return keep


@pytest.fixture
def browser():
    """A headless Chromium of the system."""
    chromium = os.environ.get("URV_CHROMIUM") or shutil.which("chromium")
    if chromium is None:
        pytest.skip("there is no Chromium: chromium is a Debian package")
    from playwright.sync_api import sync_playwright
    with sync_playwright() as tool:
        browser = tool.chromium.launch(
            executable_path=chromium, args=["--no-sandbox"])
        yield browser
        browser.close()


def pytest_runtest_logreport(report):
    if report.skipped:
        SKIPPED.append(report.nodeid.partition("::")[2])


def pytest_sessionfinish(exitstatus):
    if os.environ.get("URV_RENEW") and (exitstatus != 0 or SKIPPED):
        print(f"\ntrials: {PAGE.name} stays as it is:",
              f"skipped: {', '.join(SKIPPED)}" if SKIPPED
              else "not all have passed")
    elif os.environ.get("URV_RENEW"):
        head = PAGE.read_text("utf-8").partition("| trial |")[0]
        PAGE.write_text(
            head + "| trial | required | measured |\n|---|---|---|\n"
            + "\n".join(LINES) + "\n", "utf-8")
