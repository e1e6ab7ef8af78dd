# SPDX-License-Identifier: Apache-2.0
"""bin/urv pictures: the three pictures of README and docs (GND-33).

A flight in real time with Yamcs, captured in Chromium: the page and the
display in Yamcs. Then the report of the standard flight.
"""

from __future__ import annotations

import os
import signal
import subprocess
import tempfile
import time
from pathlib import Path

import typer

from urv import faults, programs, whole_files

ROOT = Path(__file__).resolve().parents[2]
SIZE = {"width": 1280, "height": 800}
WIDE = {"width": 1500, "height": 860}
PATIENCE_S = 180.0
# By then the simulated pilot is in the first turn.
TURNING_FRAME = 1000
ALTITUDE_HOLD = "3"
TURNS_MS = 5000


def pictures(
    folder: Path = typer.Option(
        Path("docs/pictures"), metavar="FOLDER",
        help="Folder of console.png, yamcs.png and report.png."),
):
    """Make the pictures of README: page, display in Yamcs, report."""
    chromium = os.environ.get("URV_CHROMIUM") or programs.found("chromium")
    if chromium is None:
        raise faults.Refused("there is no Chromium: scripts/setup.sh test"
                             " installs it")
    from playwright.sync_api import Error, sync_playwright

    if not (ROOT / "bin" / "urv_sim").exists():
        raise faults.Refused("bin/urv_sim is not built; make fly builds it")
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as work, sync_playwright() as tool:
        browser = tool.chromium.launch(executable_path=chromium,
                                       args=["--no-sandbox"])
        try:
            _fly(browser, Path(work), folder)
            _report(browser, Path(work), folder)
        except Error as error:
            raise faults.Failed(
                f"no picture: {str(error).splitlines()[0]}") from error
        finally:
            browser.close()
    print(f"pictures: {folder}/console.png, yamcs.png, report.png")


def _page(browser, size: dict[str, int], scheme: str):
    page = browser.new_page(viewport=size, color_scheme=scheme)
    page.set_default_timeout(PATIENCE_S * 1000)
    return page


def _keep(page, file: Path) -> None:
    """Saves a screenshot of the page."""
    with whole_files.replacing(file) as path:
        path.write_bytes(page.screenshot())


def _fly(browser, work: Path, folder: Path) -> None:
    """Takes the pictures of the page and of Yamcs during the flight."""
    log = work / "ground.log"
    with log.open("w", encoding="utf-8") as out:
        flight = subprocess.Popen(
            [*programs.URV, "ground", "--laws", "on", "--folder",
             work / "flight"], stdin=subprocess.DEVNULL, stdout=out,
            stderr=out)
    try:
        text = _wait_for(log, flight, "live after")
        page_at, yamcs_at = (
            next(word for line in text.splitlines() if mark in line
                 for word in line.split() if word.startswith("http://"))
            for mark in ("page to fly", "Yamcs: "))
        yamcs = _page(browser, WIDE, "light")
        yamcs.goto(yamcs_at)
        page = _page(browser, SIZE, "dark")
        page.goto(page_at)
        page.wait_for_function(
            "frame => +document.body.dataset.seq > frame"
            " && document.body.dataset.down === 'fresh'", arg=TURNING_FRAME)
        page.locator("#mark").fill("altitude hold")
        page.locator("#mark").press("Enter")
        page.locator("#lines", has_text="altitude hold").wait_for()
        # The simulated pilot yields; a law flies the requested turn.
        page.keyboard.press("t")
        page.wait_for_selector("#holder.mine")
        page.keyboard.press(ALTITUDE_HOLD)
        page.keyboard.down("ArrowRight")
        page.locator("#laws", has_text="bank alt spd").wait_for()
        page.wait_for_timeout(TURNS_MS)
        _keep(page, folder / "console.png")
        # Yamcs shows unconnected values in violet.
        time.sleep(5)
        _keep(yamcs, folder / "yamcs.png")
    finally:
        flight.send_signal(signal.SIGINT)
        flight.wait()


def _report(browser, work: Path, folder: Path) -> None:
    """Takes the picture of the report of the standard flight."""
    report = work / "report.html"
    for command in (
            [ROOT / "bin" / "urv_sim", "fly", "--plant", "jsbsim", "--pilot",
             "standard", "--quiet", "--record", work / "record.csv",
             "--summary", work / "summary.json", "--events",
             work / "events.jsonl"],
            [*programs.URV, "report", work / "record.csv",
             "--summary", work / "summary.json",
             "--events", work / "events.jsonl", "-o", report]):
        if subprocess.run(command, cwd=ROOT, check=False).returncode != 0:
            raise faults.Failed(f"{Path(command[0]).name} has failed")
    page = _page(browser, SIZE, "light")
    page.goto(report.as_uri())
    page.wait_for_load_state("networkidle")
    page.wait_for_timeout(2000)
    _keep(page, folder / "report.png")


def _wait_for(log: Path, process: subprocess.Popen, mark: str) -> str:
    """Waits for the mark in the log; returns the log's text."""
    ends = time.monotonic() + PATIENCE_S
    while True:
        text = log.read_text("utf-8")
        if mark in text:
            return text
        if process.poll() is not None or time.monotonic() > ends:
            raise faults.Failed(text.strip().splitlines()[-1]
                                if text.strip() else "nothing flies")
        time.sleep(0.2)
