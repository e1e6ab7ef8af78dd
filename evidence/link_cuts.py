#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Cuts the link for a minute at seconds of the standard flight and sees what
the aircraft's control laws do about it (EXT-5).

    evidence/link_cuts.py [--every N] [--first S] [--cut S] [--jobs N] [--all]

A line for each flight that is not well, with --all for each one, and a last one
with the worst of all.
Well is: never more than 45 degrees of bank from the cut on, the link back, and
at the end, a minute after it is, level within 30 degrees and within 200 ft of
where the pilot wants it.
"""

import argparse
import csv
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from whole_numbers import whole

ROOT = Path(__file__).resolve().parent.parent
FLIGHT = 180
AFTER = 60
STEEPEST = 45.0
LINKED = "1"


def rows_from(first_ms: int, fault: str, end_s: int,
              pilot: str = "standard") -> list[dict[str, str]]:
    """The rows of the record from a time on, of a flight with a fault."""
    with tempfile.TemporaryDirectory() as folder:
        faults = Path(folder, "faults.txt")
        faults.write_text(f"{fault}\n", encoding="ascii")
        record = Path(folder, "record.csv")
        subprocess.run(
            [ROOT / "bin/urv_sim", "fly", "--plant", "jsbsim",
             "--pilot", pilot, "--laws", "on", "--seconds", str(end_s),
             "--faults", faults, "--record", record, "--quiet"], check=True)
        with record.open(encoding="ascii", newline="") as lines:
            return [row for row in csv.DictReader(lines)
                    if float(row["time_ms"]) >= first_ms]


def fly(second: int, length: int) -> dict[str, float]:
    """The worst of a flight with the link cut at that second."""
    rows = rows_from(second * 1000, f"{second * 1000} cut {length * 1000}",
                     max(FLIGHT, second + length + AFTER))
    altitudes = [float(row["truth.altitude_ft"]) for row in rows]
    return {
        "second": second,
        "bank": max(abs(float(row["truth.bank_deg"])) for row in rows),
        "low": min(altitudes),
        "high": max(altitudes),
        "drift": max(abs(altitude - altitudes[0]) for row, altitude
                     in zip(rows, altitudes)
                     if float(row["time_ms"]) <= (second + length) * 1000),
        "end_bank": abs(float(rows[-1]["truth.bank_deg"])),
        "end_altitude": altitudes[-1],
        "linked": float(rows[-1]["laws.link"] == LINKED),
    }


def is_well(flown: dict[str, float]) -> bool:
    return (flown["bank"] <= STEEPEST and flown["linked"] == 1
            and flown["end_bank"] <= 30
            and 800 <= flown["end_altitude"] <= 1500)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--every", type=whole(1), default=1, metavar="N",
                        help="each Nth second (1)")
    parser.add_argument("--first", type=whole(1, FLIGHT), default=1,
                        metavar="S",
                        help="from that second on (1)")
    parser.add_argument("--cut", type=whole(1), default=60, metavar="S",
                        help="how long the link is cut (60)")
    parser.add_argument("--jobs", type=whole(1), default=os.cpu_count(),
                        metavar="N", help="flights at once (one a processor)")
    parser.add_argument("--all", action="store_true",
                        help="a line for each flight")
    chosen = parser.parse_args()

    with ThreadPoolExecutor(chosen.jobs) as pool:
        flights = list(pool.map(lambda second: fly(second, chosen.cut),
                                range(chosen.first, FLIGHT + 1,
                                      chosen.every)))
    bad = [flown for flown in flights if not is_well(flown)]
    for flown in flights if chosen.all else bad:
        print(f"cut at {flown['second']} s: bank {flown['bank']:.1f} deg, "
              f"altitude {flown['low']:.0f} to {flown['high']:.0f} ft, "
              f"{flown['drift']:.0f} ft away while cut; at the end "
              f"{flown['end_bank']:.1f} deg, {flown['end_altitude']:.0f} ft"
              + ("" if flown["linked"] else ", link lost"))
    worst = max(flights, key=lambda flown: flown["bank"])
    away = max(flights, key=lambda flown: flown["drift"])
    print(f"{len(flights)} flights with a cut of {chosen.cut} s, "
          f"{len(bad)} not well; steepest {worst['bank']:.1f} deg (cut at "
          f"{worst['second']} s), furthest {away['drift']:.0f} ft from the "
          f"altitude at the cut (cut at {away['second']} s)")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
