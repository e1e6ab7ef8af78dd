# SPDX-License-Identifier: Apache-2.0
"""EVI-10: every mistake in tests/planted can be planted, and scripts/planted.py
says of each whether it is noticed."""

import sys
import subprocess

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "scripts"))

import planted  # noqa: E402

# Fewer would mean that some went away.
AT_LEAST = 24

PATCHES = planted.patches(ROOT)


def test_there_are_as_many_as_promised():
    assert len(PATCHES) >= AT_LEAST


@pytest.mark.parametrize("patch", PATCHES, ids=lambda patch: patch.name)
def test_a_planted_mistake_applies_and_names_tests_that_are_there(patch):
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
                       "tests/planted/one.patch": PATCH}.items():
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
    patch = root / "tests/planted/one.patch"
    patch.write_text(PATCH.replace(*change) if change else PATCH)
    failures = planted.judge(
        root, root / "obj" / "copy", planted.patches(root))
    assert (root / "one.py").read_text() == "ONE = 1\n"
    return failures, capsys.readouterr().out


def test_a_mistake_that_is_noticed_is_well(tree, capsys):
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
    (("test_one.py", "test_two.py"), "there is no test"),
    (("tests/simulation/test_one.py::test_one", "MBX-1 no test"),
     "there is no test MBX-1 no test"),
    (("-ONE = 1\n", "-ONE = 3\n"), "one: no longer applies"),
    (("# notices:", "# seen by:"), "one: names no test that notices it"),
    (("+ONE = 2", "+ONE ="), "did not run"),
    # Each that is named must notice.
    (("# notices:", "# notices: tests/simulation/test_one.py::"
                    "test_that_cannot_fail\n# notices:"),
     "MISSED  one"),
])
def test_a_mistake_that_is_not_noticed_is_told(tree, capsys, change, reason):
    failures, said = judged(tree, capsys, *change)
    assert failures == 1
    assert reason in said


def test_a_test_that_fails_without_a_mistake_is_told(tree, capsys):
    path = tree / "tests/simulation/test_one.py"
    path.write_text(TEST.replace("assert ONE == 1", "assert ONE == 2"))
    failures, said = judged(tree, capsys)
    assert failures == 1
    assert "without any mistake: tests/simulation/test_one.py::test_one" \
        " failed" in said


def test_the_copy_is_of_the_tree_as_it_is(tree, capsys):
    assert judged(tree, capsys)[0] == 0
    (tree / "new.py").write_text("NEW = 1\n")
    path = tree / "tests/simulation/test_one.py"
    path.write_text(TEST.replace("import pytest",
                                 "import pytest\nfrom new import NEW"))
    assert judged(tree, capsys)[0] == 0
    (tree / "new.py").unlink()
    failures, said = judged(tree, capsys)
    assert (failures, "did not run" in said) == (1, True)


def test_results_of_unit_tests_are_read():
    assert planted.results_of(
        "ok   MBX-1 it is so\nFAIL LNK-2 it is not\n     a.adb:3: why\n"
        "1 passed, 1 failed, 0 skipped\n") == {
            "MBX-1 it is so": "passed", "LNK-2 it is not": "failed"}


def test_a_unit_test_is_found_by_its_name(tmp_path):
    name = "MBX-2 a message is overwritten"
    file = tmp_path / planted.UNIT / "boxes_tests.adb"
    file.parent.mkdir(parents=True)
    for text, is_there in ((f'Add (Suite, "{name}",', True),
                           ('"MBX-2 a message"\n   & " is overwritten"', True),
                           (f'"{name} twice"', False)):
        file.write_text(text)
        assert planted.test_exists(tmp_path, name) == is_there


def test_each_mistake_is_told_as_soon_as_it_is_tried(tree, monkeypatch):
    """Also where what is said goes into a file."""
    patch = tree / "tests/planted/other.patch"
    patch.write_text(PATCH)
    said, seen = [], []
    monkeypatch.setattr(planted, "print", lambda text, flush=False: (
        said.append((text, flush))), raising=False)
    monkeypatch.setattr(planted, "renew_copy", lambda *_: None)
    monkeypatch.setattr(planted, "run_tests", lambda *_: {})
    monkeypatch.setattr(planted, "try_patch", lambda *_: (
        seen.append([flush for _, flush in said]) or ""))
    assert planted.judge(
        tree, tree / "obj" / "copy", planted.patches(tree)) == 0
    assert [len(flushed) for flushed in seen] == [1, 2]
    assert all(flush for _, flush in said[:-1])
