# SPDX-License-Identifier: Apache-2.0
"""The repository as a whole: links between pages (EVI-1), ports of the tests
(EVI-11), licences of the sources (EVI-13), and the profile of the flight
software: all of Ravenscar but the count that detects blocking (D-29), without
entries (D-30), without floating point (TST-2)."""

import ast
import re
import subprocess
import sys

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "tests"))

from ports import PLACES, free_ports  # noqa: E402

PAGES = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"),
         ROOT / "proofs" / "README.md"]
LINK = re.compile(r"\]\(([^)#]+)")


@pytest.mark.parametrize(
    "page", PAGES, ids=[path.relative_to(ROOT).as_posix() for path in PAGES])
def test_evi1_links_lead_somewhere(page):
    assert [link for link in LINK.findall(page.read_text(encoding="utf-8"))
            if not link.startswith("http")
            and not (page.parent / link).exists()] == []


def test_evi11_no_port_is_given_twice_before_many_others():
    # A test takes some for each of its programs, which open them later.
    given = [free_ports(2)[0] for _ in range(len(PLACES) // 2)]
    assert len(set(given)) == len(given)


# --- commands of the pages ----------------------------------------------------

SCRIPT = re.compile(r"^(?: {4}|\$ )?((?:evidence|scripts|sim|targets)/\S+\.py)",
                    re.M)


def needs_a_package(script):
    """True if it imports something at its top that Debian's Python lacks."""
    tree = ast.parse((ROOT / script).read_text("utf-8"))
    imported = {name.split(".")[0] for node in tree.body
                for name in ([each.name for each in node.names]
                             if isinstance(node, ast.Import) else
                             [node.module]
                             if isinstance(node, ast.ImportFrom) else [])}
    return bool(imported & {"control", "jsbsim", "nacl", "numpy", "pyarrow",
                            "scipy"})


@pytest.mark.parametrize(
    "page", PAGES, ids=[path.relative_to(ROOT).as_posix() for path in PAGES])
def test_evi11_a_command_of_a_page_has_its_packages(page):
    """evidence/derivatives.py had a traceback: the packages of set-up are in
    .venv, which the script's first line does not name."""
    alone = SCRIPT.findall(page.read_text("utf-8"))
    assert [script for script in alone if needs_a_package(script)] == []


# --- licences ----------------------------------------------------------------

LICENCE = "SPDX-License-Identifier: Apache-2.0"
FOLDERS = ("evidence", "examples", "ground", "host", "proofs",
           "real_time", "scripts", "sim", "src", "targets", "tests")

# By the ending of the name, or the name.
LINES = {
    **dict.fromkeys((".ads", ".adb", ".gpr", ".adc"), f"--  {LICENCE}"),
    **dict.fromkeys((".py", ".sh", "Makefile", "run"), f"# {LICENCE}"),
    ".c": f"/* {LICENCE} */",
}


def line_for(path):
    return LINES.get(path.suffix or path.name)


def sources(root):
    """Every source, but what was built."""
    paths = [*root.glob("*"), *(root / ".ci").glob("*"),
             *(path for folder in FOLDERS
               for path in (root / folder).rglob("*"))]
    return [path for path in paths if path.is_file() and line_for(path)]


def says_it(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    first = 1 if lines and lines[0].startswith("#!") else 0
    return lines[first:first + 1] == [line_for(path)]


def test_evi13_each_source_says_its_licence():
    found = sources(ROOT)
    assert {line_for(path) for path in found} == set(LINES.values())
    assert [path.relative_to(ROOT).as_posix() for path in found
            if not says_it(path)] == []


# --- the profile -------------------------------------------------------------

UNIT = "package Anything is\nend Anything;\n"


@pytest.fixture
def asked(tmp_path):
    """The entries of a unit's library file that the pragmas of a file cause:
    policies and detections, and each restriction."""
    def asked(pragmas):
        folder = tmp_path / pragmas
        folder.mkdir(parents=True)
        (folder / "anything.ads").write_text(UNIT)
        subprocess.run(["gcc", "-c", "-gnat2022",
                        f"-gnatec={ROOT / pragmas}", "anything.ads"],
                       cwd=folder, check=True)
        lines = (folder / "anything.ali").read_text().splitlines()
        return ({word for line in lines if line.startswith("P ")
                 for word in line.split()[1:]},
                {line for line in lines if line.startswith("RR ")})
    return asked


def test_d29_partitions_have_the_profile_but_its_detection(asked):
    profile, restrictions = asked("src/kernel/ravenscar.adc")
    flies, flying_restrictions = asked("partitions.adc")
    assert profile - flies == {"DB"} and flies <= profile
    assert len(restrictions) >= 25
    # GNAT 14 has one more for Restricted than for Ravenscar.
    assert flying_restrictions >= restrictions


def test_d30_a_partition_with_an_entry_is_not_built(tmp_path):
    (tmp_path / "anything.ads").write_text(
        UNIT.replace("\nend", """
   protected Door is
      entry Wait;
   private
      Is_Open : Boolean := False;
   end Door;
end"""))
    (tmp_path / "anything.adb").write_text("""package body Anything is
   protected body Door is
      entry Wait when Is_Open is
      begin
         null;
      end Wait;
   end Door;
end Anything;
""")
    built = subprocess.run(
        ["gcc", "-c", "-gnat2022", f"-gnatec={ROOT / 'partitions.adc'}",
         "anything.adb"], cwd=tmp_path, capture_output=True, text=True)
    assert "Max_Protected_Entries" in built.stderr


# --- floating point ----------------------------------------------------------

# A type or a literal of floating or fixed point.
REAL = re.compile(r"\b(?:Long_|Short_)?Float\b|\bdigits\b|\bdelta\s+\d"
                  r"|\b\d[\d_]*\.\d", re.I)


def code(source):
    """The text without its comments and strings."""
    text = source.read_text(encoding="utf-8")
    return re.sub(r'"[^"\n]*"|--.*', "", text)


def test_tst2_the_flight_software_has_no_floating_point():
    """TST-2: floating point is tested where it is used."""
    used = {
        str(source.relative_to(ROOT)): REAL.findall(code(source))
        for source in (ROOT / "src").rglob("*.ad?")
        if REAL.search(code(source))
    }
    assert used == {}
