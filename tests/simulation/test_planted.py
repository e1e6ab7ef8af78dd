# SPDX-License-Identifier: Apache-2.0
"""EVI-10: every defect in evidence/planted can be planted, and the tests exist
that must notice it."""

import sys

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "evidence"))

import planted  # noqa: E402


@pytest.mark.parametrize("patch", planted.patches(ROOT),
                         ids=lambda patch: patch.name)
def test_a_planted_defect_applies_and_names_existing_tests(patch):
    assert list(planted.faults_of(ROOT, patch)) == []


def test_a_patch_that_no_longer_fits_is_reported(tmp_path):
    """Its text and its test are gone."""
    path = tmp_path / "old.patch"
    path.write_text("--- a/urv.gpr\n+++ b/urv.gpr\n@@ -1 +1 @@\n-No.\n+Yes.\n")
    patch = planted.Planted("old", path, ("MBX-1 no test",))
    faults = list(planted.faults_of(ROOT, patch))
    assert faults[0].startswith("old: no longer applies")
    assert faults[1] == "old: there is no test MBX-1 no test"
