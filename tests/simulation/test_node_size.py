# SPDX-License-Identifier: Apache-2.0
"""EVI-17: the data that scripts/node_size.py counts, and the limit of each
node."""

import subprocess
import sys

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "scripts"))

import node_size  # noqa: E402

LIMIT = 64 * 1024


@pytest.fixture
def judged(monkeypatch, capsys):
    """The exit status for nodes with so much data and bss, and what is
    said."""

    def judge(recorder=0, **sizes):
        monkeypatch.setattr(
            node_size, "recorder_size",
            lambda objects: recorder if objects[0].stem == "mcs" else 0)
        monkeypatch.setattr(node_size, "build", lambda node: None)
        monkeypatch.setattr(
            node_size, "closure", lambda node: [node_size.OBJECTS / node])
        monkeypatch.setattr(
            node_size, "section_sizes", lambda objects: dict(zip(
                ("data", "bss", "rodata"),
                (*sizes[objects[0].stem], 10**6), strict=True)))
        return node_size.main(), capsys.readouterr().out

    return judge


def test_the_recorder_s_rows_are_the_target_s_choice(judged):
    result, said = judged(recorder=2 * LIMIT, mcs=(10, 20 + 2 * LIMIT),
                          gsc=(30, 40))
    assert result == 0
    assert f"30 bytes of static data (10 data, 20 bss) of {LIMIT}," in said


@pytest.mark.parametrize("mcs, gsc, status", [
    ((10, 20), (30, 40), 0),
    ((LIMIT // 2, LIMIT // 2 - 1), (LIMIT - 1, 0), 0),
    ((LIMIT, 0), (30, 40), 1),
    ((10, 20), (LIMIT, 0), 1),
    ((10, 20), (0, LIMIT), 1),
    ((LIMIT // 2, LIMIT // 2), (30, 40), 1),
    ((LIMIT, LIMIT), (LIMIT, LIMIT), 1),
])
def test_the_limit_is_each_node_s(judged, mcs, gsc, status):
    result, said = judged(mcs=mcs, gsc=gsc)
    assert result == status
    assert ("not below the limit" in said) == (status == 1)
    for node, (data, bss) in (("mcs", mcs), ("gsc", gsc)):
        assert (f"{node}: {data + bss} bytes of static data ({data} data,"
                f" {bss} bss) of 65536") in said


def test_every_kind_of_data_is_counted(tmp_path):
    (tmp_path / "a.c").write_text(
        "char set[96] = {1}; char zero[200]; const char text[32] = {1};\n"
        "__thread char own[16] = {1}; __thread char none[48];\n"
        "extern char set[]; char *const at[4] = {set, set, set, set};\n"
        "int code (void) { return set[0] + own[0] + none[0]; }\n")
    objects = []
    for name, more in (("a", ["-fno-pic"]), ("b", ["-fPIC"])):
        objects.append(tmp_path / f"{name}.o")
        subprocess.run(
            ["gcc", "-c", *more, "-fdata-sections", "-fno-common",
             tmp_path / "a.c", "-o", objects[-1]], check=True)
    alone = node_size.section_sizes(objects[:1])
    # Pointers are read-only here, and data where a loader must set them.
    assert alone == {"data": 96 + 16, "bss": 200 + 48, "rodata": 32 + 32}
    both = node_size.section_sizes(objects)
    assert both == {"data": 2 * (96 + 16) + 32, "bss": 2 * (200 + 48),
                    "rodata": 32 + 64}
