#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the tests' results between builds and systems (EVI-6).

    evidence/independence.py [--renew] switches
        Unit tests and the tests that fly, built with and without contracts
        executed, without optimisation and with, validity checked wherever it
        may be. Some flights must leave the same bytes whatever the build.
    evidence/independence.py [--renew] chroot FOLDER [DEBIAN/WHO ...]
        The steps of a new user in a fresh Debian in FOLDER, with only git and
        make: `make fly`, `make test`. As root, and as a user who has root run
        the one command that `make test` names. DEBIAN/WHO is
        12/root, 12/user, 13/root, 13/user; all of them unless named. Needs
        root and debootstrap.

--renew writes the result into docs/evidence/independence.md. All warnings are errors,
so what builds has none. Exit status 1 when a test fails or bytes differ.
"""

import argparse
import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import coverage

ROOT = Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "docs" / "evidence" / "independence.md"

SUITES = {"12": "bookworm", "13": "trixie"}
NEWCOMERS = [f"{debian}/{who}" for debian in SUITES for who in ("root", "user")]

# How this machine reaches the packages, which a fresh system is told, too.
NETWORK = ("etc/resolv.conf", "etc/hosts", "etc/pip.conf",
           "etc/ssl/certs/ca-certificates.crt",
           "usr/local/share/ca-certificates")

# setup.sh names here the command that root runs for a user.
NAMED = re.compile(r"^    (apt-get update && apt-get install .+)$", re.M)

# The switches come after those of urv.gpr, so that these count.
BUILDS = {
    f"{level}{' -gnata' if contracts else ''} -gnatVa":
        [level, "-gnatVa", *(["-gnata"] if contracts else [])]
    for contracts in (False, True) for level in ("-O0", "-O2")
}
PLAIN = "as in urv.gpr"

# Contracts executed make a flight slower than real time: the tests with many
# flights are not flown then.
SHORT_FLIGHTS = ("data_path", "events", "wire")

# Flights that are compared byte by byte.
FAULTS = """\
300 up flip 3 1
500 cut 95.5
1000 down drop 17
1500 mcs reset processor
2500 gsc reset warm
3000 gsc stall adc 200
4000 up dup 1
"""
STICKS = "time_ms,roll,pitch,throttle,switch8\n" + "".join(
    f"{50 * row},{37 * row},{61 * row % 4096},{83 * row % 4096},"
    f"{4095 * (row // 10 % 2)}\n" for row in range(100))
FLIGHTS = (
    ("--seconds", "6"),
    ("--seconds", "6", "--sticks", "sticks.csv", "--phase", "7"),
    ("--seconds", "6", "--sticks", "sticks.csv", "--faults", "faults.txt"),
    ("--seconds", "6", "--sticks", "sticks.csv", "--processors", "2"),
)

TOTALS = re.compile(r"^(\d+) passed, (\d+) failed, (\d+) skipped$", re.M)
PYTEST = re.compile(r"^(?:(\d+) failed, )?(\d+) passed.* in ", re.M)


def run(*command, **more):
    result = subprocess.run(command, cwd=ROOT, check=False, text=True, **more)
    return result.returncode, result.stdout


# --- switches --------------------------------------------------------------

def build(project, name, switches):
    """The folder of the programs. With contracts they are built as the tests
    are."""
    place = "independence-" + re.sub(r"\W+", "-", name).strip("-").lower()
    pragmas = ([f"-gnatec={ROOT / 'tests' / 'urv_tests.adc'}"]
               if "-gnata" in switches else [])
    status, _ = run("gprbuild", "-q", "-p", "-j0", "-P", project,
                    "-XURV_Mode=host", f"--subdirs={place}",
                    "-cargs:Ada", *switches, *pragmas)
    if status != 0:
        sys.exit(f"independence: {project} does not build with"
                 f" {' '.join(switches)}")
    return ROOT / "bin" / place


def unit_tests(folder):
    """Passed and failed; one that ends early has failed."""
    status, said = run(folder / "urv_tests_host", stdout=subprocess.PIPE)
    totals = TOTALS.search(said)
    if not totals:
        print(said, f"ended early, status {status}", sep="\n")
        return 0, 1
    if totals[2] != "0":
        print(said)
    return int(totals[1]), int(totals[2])


def flying_tests(folder, names):
    status, said = run(
        sys.executable, "-B", "-m", "pytest", "-q", "--tb=short", "-p",
        "no:cacheprovider", *coverage.SHORT,
        *(f"tests/simulation/test_{name}.py" for name in names),
        stdout=subprocess.PIPE,
        env={**os.environ, "URV_SIM": str(folder / "urv_sim")})
    totals = PYTEST.search(said)
    if status not in (0, 1) or not totals:
        print(said, f"ended early, status {status}", sep="\n")
        return 0, 1
    if status != 0:
        print(said)
    return int(totals[2]), int(totals[1] or 0)


def bytes_of_flights(program):
    """One number of all that the flights leave."""
    found = hashlib.sha256()
    with tempfile.TemporaryDirectory(prefix="urv-independence-") as name:
        folder = Path(name)
        (folder / "faults.txt").write_text(FAULTS, encoding="utf-8")
        (folder / "sticks.csv").write_text(STICKS, encoding="utf-8")
        for options in FLIGHTS:
            outputs = ("record", "wire", "events")
            subprocess.run(
                [program, "fly", *options, "--quiet",
                 *(word for output in outputs
                   for word in (f"--{output}", output))],
                cwd=folder, check=True)
            for output in outputs:
                found.update((folder / output).read_bytes())
    return found.hexdigest()


def try_switches():
    """The table, and whether all is well."""
    rows = []
    plain = build("sim/urv_sim.gpr", PLAIN, [])
    expected = bytes_of_flights(plain / "urv_sim")
    well = True
    for name, switches in BUILDS.items():
        folder = build("tests/urv_tests.gpr", name, switches)
        build("sim/urv_sim.gpr", name, switches)
        flying = flying_tests(
            folder,
            SHORT_FLIGHTS if "-gnata" in switches else coverage.FLIGHTS)
        units = unit_tests(folder)
        same = bytes_of_flights(folder / "urv_sim") == expected
        well = well and units[1] == flying[1] == 0 and same
        rows.append([f"`{name}`", *map(passed, (units, flying)),
                     "the same" if same else "others"])
        print(*rows[-1], sep=", ", flush=True)
    return table(("switches", "unit tests", "tests that fly",
                  f"bytes of {len(FLIGHTS)} flights"), rows), well


def passed(counts):
    good, bad = counts
    return f"{good} passed" + (f", {bad} failed" if bad else "")


# --- another system and compiler -------------------------------------------

# A user with a home, as systems have.
USER = "pilot"

# Some have a space in the name of a folder.
CLONE = "my urv"


def must(result, what):
    status, said = result
    if status != 0:
        sys.exit(f"independence: {what} failed\n{said or ''}")
    return said


def fresh(folder, debian):
    """A bare Debian with git and make. The result of debootstrap is kept, and
    copied."""
    suite = SUITES[debian]
    base, system = folder / f"{suite}-base", folder / suite
    quiet = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    if not base.exists():
        unfinished = folder / f"{suite}-unfinished"
        shutil.rmtree(unfinished, ignore_errors=True)
        must(run("debootstrap", "--variant=minbase", suite, unfinished,
                 **quiet), "debootstrap")
        unfinished.rename(base)
    if system.exists():
        shutil.rmtree(system)
    must(run("cp", "-a", base, system), "cp")
    for name in NETWORK:
        source, place = Path("/", name), system / name
        place.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, place, dirs_exist_ok=True)
        elif source.exists():
            shutil.copyfile(source, place)
    must(run("mount", "-t", "proc", "proc", system / "proc"), "mount")
    must(in_system(system, "root", f"""
        mkdir -p /dev/pts /dev/shm && chmod 1777 /dev/shm &&
        mount -t devpts devpts /dev/pts -o newinstance,ptmxmode=0666 &&
        ln -sf pts/ptmx /dev/ptmx &&
        apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y \
           --no-install-recommends git make &&
        useradd --create-home {USER}""", **quiet), "preparing")
    return system


def left(system):
    for name in ("dev/pts", "proc"):
        subprocess.run(["umount", "-l", system / name], check=False,
                       stderr=subprocess.DEVNULL)


def in_system(system, who, command, **more):
    home = "/root" if who == "root" else f"/home/{USER}"
    return run("chroot", system, "/usr/bin/env", "-i", f"HOME={home}",
               "LC_ALL=C.UTF-8", "PATH=/usr/sbin:/usr/bin:/sbin:/bin",
               *([] if who == "root" else ["su", USER]),
               *(["sh"] if who == "root" else []), "-c", command, **more)


def check_out(home):
    """The present files of this repository."""
    names = must(run("git", "ls-files", "-z", stdout=subprocess.PIPE), "git")
    for name in names.split("\0")[:-1]:
        if (ROOT / name).exists():
            (home / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, home / name)


def command_for_root(said):
    """The one command that root is to run for a user; None if there is none or
    more."""
    commands = NAMED.findall(said)
    return commands[0] if len(commands) == 1 else None


def in_minutes(seconds):
    return f"{seconds / 60:.0f} min"


def used_mb(system):
    said = must(run("du", "-smx", system, stdout=subprocess.PIPE), "du")
    return int(said.split()[0])


def try_newcomer(folder, newcomer):
    """The row of the table, and whether all is well."""
    debian, who = newcomer.split("/")
    system = folder / SUITES[debian]
    left(system)
    fresh(folder, debian)
    try:
        home = system / ("root" if who == "root" else f"home/{USER}") / CLONE
        check_out(home)
        if who == "user":
            must(in_system(system, "root", f"chown -R {USER} /home/{USER}"),
                 "chown")
        must(in_system(system, who, f"git init -q ~/'{CLONE}'"), "git")
        return what_happens(system, home, debian, who)
    finally:
        left(system)


def what_happens(system, home, debian, who):
    first = used_mb(system)
    began = time.monotonic()
    if who == "user":
        status, said = in_system(system, who, f"cd ~/'{CLONE}' && make test",
                                 stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT)
        print(said, flush=True)
        command = command_for_root(said)
        if status == 0 or not command:
            sys.exit("independence: a user is not told the one command")
        must(in_system(system, "root",
                       f"export DEBIAN_FRONTEND=noninteractive; {command}",
                       stdout=subprocess.PIPE, stderr=subprocess.STDOUT),
             command)
    flown, _ = in_system(system, who, f"cd ~/'{CLONE}' && make fly")
    fly = in_minutes(time.monotonic() - began)
    fly_mb = used_mb(system) - first
    there = all((home / "flight" / name).exists()
                for name in ("record.csv", "summary.json"))
    began = time.monotonic()
    tested, _ = in_system(system, who, f"cd ~/'{CLONE}' && make test")
    test = in_minutes(time.monotonic() - began)
    version = must(in_system(system, who, "gnatls --version",
                             stdout=subprocess.PIPE), "gnatls")
    file = home / "obj" / "tests" / "totals"
    totals = TOTALS.match(file.read_text("utf-8")) if file.exists() else None
    well = (flown == tested == 0 and there and bool(totals)
            and totals[2] == "0")
    return [f"Debian {debian}", who, version.split(maxsplit=2)[1],
            f"{fly}, {fly_mb} MB" if flown == 0 and there else "failed",
            totals[0] if totals else "did not come to its end",
            f"{test}, {used_mb(system) - first} MB"], well


def try_newcomers(folder, newcomers):
    """The table's rows by newcomer, and whether all is well."""
    if os.geteuid() != 0:
        sys.exit("independence: a chroot needs root")
    folder.mkdir(parents=True, exist_ok=True)
    rows, all_well = [], True
    for newcomer in newcomers:
        row, well = try_newcomer(folder, newcomer)
        print(*row, sep=", ", flush=True)
        rows.append(row)
        all_well = all_well and well
    return rows, all_well


def newcomers_table(page, rows):
    """Rows that were not tried again stay as on the page."""
    found = dict.fromkeys(map(tuple, (n.split("/") for n in NEWCOMERS)))
    for line in page.splitlines():
        row = [cell.strip() for cell in line.strip("|").split("|")]
        key = (row[0].removeprefix("Debian "), *row[1:2])
        if len(row) == 6 and key in found:
            found[key] = row
    for row in rows:
        found[row[0].removeprefix("Debian "), row[1]] = row
    return table(("system", "as", "GNAT", "`make fly`, with what it installs",
                  "`make test`", "the same, with what both need"),
                 filter(None, found.values()))


# --- the page --------------------------------------------------------------

def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def renewed(page, part, text):
    """The page with another table in this part."""
    begin, end = f"<!-- {part} -->\n", "<!-- end -->\n"
    before, found, rest = page.partition(begin)
    _, ended, after = rest.partition(end)
    if not found or not ended:
        sys.exit(f"independence: {DOCUMENT.name} has no place for {part}")
    return before + begin + text + end + after


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--renew", action="store_true")
    options.add_argument("part", choices=("switches", "chroot"))
    options.add_argument("folder", nargs="?", type=Path)
    options.add_argument("newcomers", nargs="*", metavar="DEBIAN/WHO")
    chosen = options.parse_args()
    if (chosen.part == "chroot") != bool(chosen.folder):
        options.error("a folder for chroot, and for nothing else")
    if unknown := set(chosen.newcomers) - set(NEWCOMERS):
        options.error(f"{', '.join(unknown)}: not one of"
                      f" {', '.join(NEWCOMERS)}")
    if chosen.part == "switches":
        text, well = try_switches()
    else:
        rows, well = try_newcomers(chosen.folder.resolve(),
                                   chosen.newcomers or NEWCOMERS)
        text = newcomers_table(DOCUMENT.read_text(encoding="utf-8"), rows)
    print(text, end="")
    if chosen.renew:
        page = DOCUMENT.read_text(encoding="utf-8")
        DOCUMENT.write_text(renewed(page, chosen.part, text),
                            encoding="utf-8")
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())
