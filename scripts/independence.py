#!/usr/bin/env python3
"""Whether the tests' results hang on how the software is built (EVI-6).

    scripts/independence.py [--renew] switches
        Unit tests and the tests that fly, built with and without contracts
        executed, without optimisation and with, validity checked wherever it
        may be. Some flights must leave the same bytes whatever the build.
    scripts/independence.py [--renew] chroot FOLDER
        All tests but the proof's in Debian 13, trixie, with its GNAT;
        debootstrap puts it in FOLDER unless it is there. Needs root.

--renew writes the result into docs/independence.md. All warnings are errors,
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
from pathlib import Path

import coverage

ROOT = Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "docs" / "independence.md"

SUITE = "trixie"
PACKAGES = ("ca-certificates gnat-14 gprbuild gcc libc6-dev make git binutils"
            " libaunit-dev libgnatcoll-dev afl++ python3 python3-venv").split()

# What of the tests hangs on the compiler.
PARTS = "every unit simulation 'real time' 'static data'"

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

# What is flown for its bytes.
FAULTS = """\
300 up flip 3 1
500 cut 95.5
1000 down drop 17
1500 mcs reset processor
2500 gsc reset warm
3000 gsc stall adc 200
4000 up dup 1
"""
FLIGHTS = (
    ("--seconds", "6"),
    ("--seconds", "6", "--pilot", "standard", "--phase", "7"),
    ("--seconds", "6", "--pilot", "standard", "--faults", "faults.txt"),
    ("--seconds", "6", "--pilot", "standard", "--processors", "2"),
)

TOTALS = re.compile(r"^(\d+) passed, (\d+) failed, (\d+) skipped$", re.M)
PYTEST = re.compile(r"^(?:(\d+) failed, )?(\d+) passed.* in ", re.M)


def run(*command, **more):
    result = subprocess.run(command, cwd=ROOT, check=False, text=True, **more)
    return result.returncode, result.stdout


# --- switches --------------------------------------------------------------

def build(project, name, switches):
    """Where the programs are."""
    place = "independence-" + re.sub(r"\W+", "-", name).strip("-").lower()
    status, _ = run("gprbuild", "-q", "-p", "-j0", "-P", project,
                    "-XURV_Mode=host", f"--subdirs={place}",
                    "-cargs:Ada", *switches)
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


# --- another compiler ------------------------------------------------------

def in_chroot(folder, command, **more):
    return run("chroot", folder, "/usr/bin/env", "-i", "HOME=/root",
               "LC_ALL=C.UTF-8", "PATH=/usr/sbin:/usr/bin:/sbin:/bin",
               "sh", "-c", command, **more)


def must(result, what):
    status, said = result
    if status != 0:
        sys.exit(f"independence: {what} failed\n{said or ''}")
    return said


def prepare(folder):
    """The chroot with what `make test` needs, and this repository in it."""
    quiet = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    if not (folder / "usr").exists():
        must(run("debootstrap", "--variant=minbase", SUITE, folder, **quiet),
             "debootstrap")
    for name in ("resolv.conf", "hosts", "ssl/certs/ca-certificates.crt"):
        if Path("/etc", name).exists():
            (folder / "etc" / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(Path("/etc", name), folder / "etc" / name)
    must(in_chroot(folder, "apt-get update && DEBIAN_FRONTEND=noninteractive"
                   " apt-get install -y --no-install-recommends "
                   + " ".join(PACKAGES), **quiet), "apt-get")
    home = folder / "root" / "urv"
    shutil.rmtree(home, ignore_errors=True)
    names = must(run("git", "ls-files", "-z", stdout=subprocess.PIPE), "git")
    for name in names.split("\0")[:-1]:
        if (ROOT / name).exists():
            (home / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, home / name)


def try_chroot(folder):
    if os.geteuid() != 0:
        sys.exit("independence: a chroot needs root")
    prepare(folder)
    must(run("mount", "-t", "proc", "proc", folder / "proc"), "mount")
    try:
        must(in_chroot(folder, "mountpoint -q /dev/pts ||"
                       " { mkdir -p /dev/pts /dev/shm &&"
                       " mount -t devpts devpts /dev/pts -o newinstance,"
                       "ptmxmode=0666 && ln -sf pts/ptmx /dev/ptmx; }"),
             "mount")
        version = must(in_chroot(folder, "gnatls --version",
                                 stdout=subprocess.PIPE), "gnatls")
        in_chroot(folder, "cd /root/urv && scripts/setup.sh test &&"
                  f" .venv/bin/python scripts/run_tests.py {PARTS}")
    finally:
        run("umount", folder / "dev" / "pts")
        run("umount", folder / "proc")
    file = folder / "root" / "urv" / "obj" / "tests" / "totals"
    totals = TOTALS.match(file.read_text("utf-8")) if file.exists() else None
    number = version.split(maxsplit=2)[1]
    rows = [[f"GNAT {number}, Debian 13",
             totals[0] if totals else "did not come to its end"]]
    return (table(("compiler", "tests"), rows),
            bool(totals) and totals[2] == "0")


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
    chosen = options.parse_args()
    if (chosen.part == "chroot") != bool(chosen.folder):
        options.error("a folder for chroot, and for nothing else")
    text, well = (try_switches() if chosen.part == "switches"
                  else try_chroot(chosen.folder.resolve()))
    print(text, end="")
    if chosen.renew:
        page = DOCUMENT.read_text(encoding="utf-8")
        DOCUMENT.write_text(renewed(page, chosen.part, text),
                            encoding="utf-8")
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())
