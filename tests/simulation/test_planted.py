# SPDX-License-Identifier: Apache-2.0
"""EVI-10: every defect in evidence/planted can be planted, and evidence/planted.py
reports each that a named test does not notice."""

import sys
import subprocess

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "evidence"))

import planted  # noqa: E402

@pytest.mark.parametrize("patch", planted.patches(ROOT), ids=lambda patch: patch.name)
def test_a_planted_defect_applies_and_names_existing_tests(patch):
    assert list(planted.faults_of(ROOT, patch)) == []


# --- a tree of its own -------------------------------------------------------

PATCH = """\
One is two.
# notices: tests/simulation/test_one.py::test_one
--- a/one.py
+++ b/one.py
@@ -1 +1 @@
-ONE = 1
+ONE = 2
"""

TEST = """\
import pytest
from one import ONE

def test_one():
    assert ONE == 1

def test_that_cannot_fail():
    assert ONE

@pytest.mark.skip
def test_skipped():
    assert ONE == 1

@pytest.mark.parametrize("is_so", [True, ONE == 1])
def test_one_of_two(is_so):
    assert is_so
"""


@pytest.fixture
def tree(tmp_path, monkeypatch):
    """A tree with a source, its tests, and one patch."""
    root = tmp_path / "tree"
    for name, text in {"one.py": "ONE = 1\n", ".gitignore": "obj/\n.venv\n",
                       "tests/conftest.py": "",
                       "pytest.ini": "[pytest]\npythonpath = .\n",
                       "tests/simulation/test_one.py": TEST,
                       "evidence/planted/one.patch": PATCH}.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)
    (root / ".venv").mkdir()
    subprocess.run(["git", "init", "-q", root], check=True)
    monkeypatch.setattr(planted, "PROJECTS", {"tests/simulation": [],
                                              planted.UNIT: []})
    return root


def judged(root, capsys, *change):
    """How many failures there are with a patch so changed, and what is
    said."""
    patch = root / "evidence/planted/one.patch"
    patch.write_text(PATCH.replace(*change) if change else PATCH)
    failures = planted.judge(
        root, root / "obj" / "copy", planted.patches(root))
    assert (root / "one.py").read_text() == "ONE = 1\n"
    return failures, capsys.readouterr().out


def test_a_noticed_defect_passes(tree, capsys):
    for _ in range(2):
        failures, said = judged(tree, capsys)
        assert failures == 0
        assert "noticed one, " in said
        assert (tree / "obj/copy/one.py").read_text() == "ONE = 1\n"
    failures, said = judged(tree, capsys, "::test_one", "::test_one_of_two")
    assert failures == 0


@pytest.mark.parametrize("change, reason", [
    (("::test_one", "::test_that_cannot_fail"),
     "test_that_cannot_fail passed"),
    (("::test_one", "::test_skipped"), "test_skipped skipped"),
    (("::test_one", "::test_two"), "there is no test"),
    (("-ONE = 1\n", "-ONE = 3\n"), "one: no longer applies"),
    (("# notices:", "# seen by:"), "one: names no test that notices it"),
])
def test_a_defect_that_is_not_noticed_is_reported(tree, capsys, change, reason):
    failures, said = judged(tree, capsys, *change)
    assert failures == 1
    assert reason in said


def test_a_unit_test_is_found_by_its_name(tmp_path):
    name = "MBX-2 a message is overwritten"
    file = tmp_path / planted.UNIT / "boxes_tests.adb"
    file.parent.mkdir(parents=True)
    for text, is_there in ((f'Add (Suite, "{name}",', True),
                           ('"MBX-2 a message"\n   & " is overwritten"', True),
                           (f'"{name} twice"', False)):
        file.write_text(text)
        assert planted.test_exists(tmp_path, name) == is_there
