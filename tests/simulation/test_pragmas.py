# SPDX-License-Identifier: Apache-2.0
"""D-29: what flies is built under all of the Ravenscar profile but the count
that detects blocking. D-30: it has no entries."""

import subprocess

import pytest
from conftest import ROOT

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
