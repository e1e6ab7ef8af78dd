# SPDX-License-Identifier: Apache-2.0
"""bin/urv monte-carlo: flights by the thousand, each from its seed (SIM-6,
SEC-12)."""

import shlex
import subprocess
import time
from pathlib import Path
from types import SimpleNamespace
from typing import Annotated, Optional

import typer

from urv import certificates as secured, faults

ROOT = Path(__file__).resolve().parents[2]

# The files sent to the workers.
CARGO = ("bin/urv_sim", "evidence/safety/holds.py", "sim/jsbsim")

# Flights with randomly drawn sticks, without the simulated pilot.
HISTORIES = "histories"

# The lengths of the flights, in s. A history's length is drawn; this is the
# longest.
LENGTHS = {"standard": 180, "level": 60, "circuit": 300,
           "damped-circuit": 300, HISTORIES: 150}
LONGEST_S = 3600

OUTPUTS = ("--record", "record.csv", "--summary", "summary.json",
           "--events", "events.jsonl")


def monte_carlo(
    count: Annotated[Optional[int], typer.Option(
        "--flights", min=1, max=1_000_000, metavar="N",
        help="Number of flights.")] = None,
    first: Annotated[int, typer.Option(
        "--seed", min=0, max=2 ** 63 - 1, metavar="N",
        help="Seed of the first; the others follow.")] = 1,
    again: Annotated[Optional[int], typer.Option(
        min=0, max=2 ** 63 - 1, metavar="SEED",
        help="Fly only the flight of that seed, here, and keep its"
        " files.")] = None,
    pilot: Annotated[str, typer.Option(
        metavar="NAME", help="The pilot: "
        + ", ".join(LENGTHS) + ".")] = "standard",
    seconds: Annotated[Optional[int], typer.Option(
        min=10, max=LONGEST_S, metavar="S",
        help="Length of each flight; else the pilot's.")] = None,
    surface_faults: Annotated[int, typer.Option(
        min=0, max=100, metavar="PERCENT",
        help="Percentage of flights with a failed surface.")] = 0,
    console_losses: Annotated[int, typer.Option(
        min=0, max=100, metavar="PERCENT",
        help="Percentage of flights with a lost console.")] = 0,
    scheduler: Annotated[Optional[str], typer.Option(
        metavar="ADDRESS", help="Dask's scheduler, tls://HOST:PORT; else"
        " workers here.")] = None,
    certificates: Annotated[Optional[Path], typer.Option(
        metavar="FOLDER", help="ca.pem, cert.pem and key.pem for"
        " --scheduler.")] = None,
    insecure: Annotated[bool, typer.Option(
        "--insecure", help="Use no certificates: any program that can reach"
        " the scheduler can run code here.")] = False,
    workers: Annotated[Optional[int], typer.Option(
        min=1, max=1024, metavar="N",
        help="Workers here; else one for each processor.")] = None,
    output: Annotated[Path, typer.Option(
        "-o", "--output", metavar="FOLDER",
        help="Folder of the results.")] = Path("flight/monte-carlo"),
):
    """Fly many flights in random conditions.

    Leaves results.parquet and report.html in the folder.
    """
    if pilot not in LENGTHS:
        raise faults.Refused(f"--pilot: {faults.quoted(pilot)} is not a pilot;"
                             f" there are {', '.join(LENGTHS)}")
    if scheduler is not None and workers is not None:
        raise faults.Refused("--workers are workers here, and do not go"
                             " together with --scheduler")
    security = secured.of(scheduler, certificates, insecure)
    if (count is None) == (again is None):
        raise faults.Refused("either --flights or --again is needed, and"
                             " not both")
    if not (ROOT / CARGO[0]).is_file():
        raise faults.Failed("bin/urv_sim is not built: make fly builds it")
    if pilot == HISTORIES and (seconds or surface_faults):
        raise faults.Refused("a history draws its own length and surface"
                             " faults: leave --seconds and --surface-faults"
                             " out")
    length = seconds or LENGTHS[pilot]
    campaign = SimpleNamespace(
        pilot=pilot, seconds=length, first=first, count=count,
        output=output, scheduler=scheduler, workers=workers,
        security=security,
        surface_percent=surface_faults, console_percent=console_losses)
    if again is not None:
        fly_alone(campaign, again)
    else:
        fly_all(campaign)


def job(campaign, seed):
    """The files and options of the flight of that seed."""
    from urv import dispersions

    if campaign.pilot == HISTORIES:
        return history_job(seed)
    drawn = dispersions.draw(seed, campaign.pilot, campaign.seconds,
                             campaign.surface_percent,
                             campaign.console_percent)
    return {
        "seed": seed, "values": drawn.values,
        "files": {"conditions.txt": drawn.conditions,
                  "faults.txt": drawn.faults},
        "options": ["--plant", "jsbsim", "--pilot", campaign.pilot,
                    "--seconds", str(campaign.seconds),
                    "--seed", str(seed), "--conditions", "conditions.txt",
                    "--faults", "faults.txt"]}


def history_job(seed):
    """The same of a random history and the calm after it."""
    from urv import histories

    drawn = histories.draw(seed)
    return {
        "seed": seed, "values": drawn.values,
        "files": {"sticks.csv": drawn.sticks, "faults.txt": drawn.faults,
                  "conditions.txt": drawn.conditions},
        "options": ["--plant", "jsbsim", "--laws", "on",
                    "--sticks", "sticks.csv",
                    "--seconds", str(drawn.seconds), "--seed", str(seed),
                    "--conditions", "conditions.txt",
                    "--faults", "faults.txt"]}


def command_again(campaign, seed):
    """The command that flies that flight again."""
    return shlex.join(
        ["bin/urv", "monte-carlo", "--again", str(seed), "--pilot",
         campaign.pilot,
         *([] if campaign.pilot == HISTORIES
           else ["--seconds", str(campaign.seconds)]),
         *(["--surface-faults", str(campaign.surface_percent)]
           if campaign.surface_percent else []),
         *(["--console-losses", str(campaign.console_percent)]
           if campaign.console_percent else []),
         "--output", str(campaign.output)])


def fly_alone(campaign, seed):
    """Fly one here; its files stay."""
    from urv import whole_files

    asked = job(campaign, seed)
    folder = made(campaign.output / str(seed))
    for name, text in asked["files"].items():
        with whole_files.replacing(folder / name) as path:
            path.write_text(text, encoding="utf-8")
    command = [str(ROOT / CARGO[0]), "fly", *asked["options"], *OUTPUTS]
    print(f"cd {shlex.quote(str(folder))} && {shlex.join(command)}",
          flush=True)
    status = subprocess.run(command, cwd=folder, check=False,
                            stdin=subprocess.DEVNULL).returncode
    if status:
        raise faults.Failed(f"urv_sim ended with status {status}")


def made(folder):
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise faults.Failed(f"{faults.quoted(folder)} cannot be made:"
                            f" {faults.reason(fault)}") from fault
    return folder


def fly_all(campaign):
    import os

    from urv import cargo, monte_carlo_results, progress
    from urv import workers as engine

    made(campaign.output)
    sent = cargo.Cargo(cargo.packed(ROOT, CARGO), cargo.fly,
                       program=CARGO[0], modules=("jsbsim",))
    jobs = (job(campaign, campaign.first + place)
            for place in range(campaign.count))
    count = campaign.workers or os.cpu_count() or 1
    found = []
    began = time.monotonic()
    ended = None
    try:
        with progress.bar("flying") as told:
            for asked, result in engine.done(
                    sent, jobs, campaign.scheduler, count,
                    campaign.security):
                found.append(monte_carlo_results.flight(
                    campaign.pilot, asked, result))
                told(SimpleNamespace(
                    size=campaign.count, position=len(found)))
    except (faults.Failed, KeyboardInterrupt) as fault:
        # Earlier flights are kept.
        ended = fault
    elapsed = time.monotonic() - began
    if found:
        keep(campaign, sent.hash, found)
    if ended is not None:
        if found:
            faults.note(f"{len(found)} of {campaign.count} flights were flown;"
                        f" they are in {faults.quoted(campaign.output)}")
        raise ended
    well = sum(flight.is_success for flight in found)
    print(f"{well} of {len(found)} flights within all limits,"
          f" {len(found) / elapsed:.2f} flights a second")
    in_vain = [flight for flight in found if flight.fault]
    if in_vain:
        raise faults.Failed(
            f"{len(in_vain)} of {len(found)} flights could not be flown; seed"
            f" {in_vain[0].seed}: {in_vain[0].fault}")


def keep(campaign, cargo_hash, found):
    """Writes the table and the page of these flights; a failure leaves the old
    ones."""
    from urv import monte_carlo_page, monte_carlo_results, whole_files

    found.sort(key=lambda flight: flight.seed)
    page = monte_carlo_page.page(
        campaign, cargo_hash, found,
        lambda seed: command_again(campaign, seed))
    # A file that cannot be written costs only that file (GND-53).
    lost = []
    for name, write in (
            ("results.parquet", lambda path: monte_carlo_results.write(
                path, campaign, cargo_hash, found)),
            ("report.html", lambda path: path.write_text(
                page, encoding="utf-8"))):
        try:
            with whole_files.replacing(campaign.output / name) as path:
                write(path)
        except faults.Failed as fault:
            lost.append(str(fault))
    if lost:
        raise faults.Failed("; ".join(lost))
