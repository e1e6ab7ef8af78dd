# SPDX-License-Identifier: Apache-2.0
"""SEC-5: bin/urv keygen makes files of keys that the nodes take."""

import os
import re
import stat

from conftest import SIMULATION, run

KEYS = re.compile(r"^key (\d+) ([0-9a-f]{32})$", re.M)


def keys_of(path):
    return KEYS.findall(path.read_text("ascii"))


def fly(folder, name):
    return run(folder, SIMULATION, "fly", "--seconds", "1", "--quiet",
               "--format", "2", "--key", name)


def test_sec5_a_key_is_made_for_its_owner_alone(urv, tmp_path):
    found = urv("keygen", "link.key")
    assert found.returncode == 0, found.stderr
    path = tmp_path / "link.key"
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    ((number, digits),) = keys_of(path)
    assert number == "1"
    assert digits not in found.stdout + found.stderr
    assert fly(tmp_path, "link.key").returncode == 0

    other = urv("keygen", "other.key", "--number", "7")
    assert other.returncode == 0, other.stderr
    ((number, other_digits),) = keys_of(tmp_path / "other.key")
    assert number == "7"
    assert digits != other_digits


def test_sec5_a_second_key_precedes_the_first(urv, tmp_path):
    urv("keygen", "link.key")
    path = tmp_path / "link.key"
    (old,) = keys_of(path)
    assert urv("keygen", "--add", "link.key").returncode == 0
    new, kept = keys_of(path)
    assert (new[0], kept) == ("2", old)
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert fly(tmp_path, "link.key").returncode == 0

    # Two at most: the oldest goes, and is named.
    added = urv("keygen", "--add", "link.key")
    assert (added.returncode, added.stdout) == (
        0, '"link.key": key 3, and key 2 as before; key 1 is removed\n')
    assert [number for number, _ in keys_of(path)] == ["3", "2"]


def test_sec5_no_key_is_lost_or_made_readable(urv, tmp_path):
    urv("keygen", "link.key")
    path = tmp_path / "link.key"
    before = path.read_bytes()
    for arguments, said in (
            (("link.key",), "is there already"),
            (("--add", "link.key", "--number", "1"), "has the number 1"),
            (("--add", "nowhere.key"), "cannot be read"),
            (("--number", "256", "more.key"), "255")):
        found = urv("keygen", *arguments)
        assert found.returncode == 2, arguments
        assert said in found.stderr
        assert found.stderr.count("\n") == 1
    assert path.read_bytes() == before
    assert [each.name for each in tmp_path.iterdir()] == ["link.key"]

    path.chmod(0o640)
    assert urv("keygen", "--add", "link.key").returncode == 2
    found = fly(tmp_path, "link.key")
    assert found.returncode == 2
    assert "link.key:1: has mode 0640; keys must have 0600" in found.stderr


def test_sec14_no_file_of_keys_is_a_pipe_long_or_without_sense(
        urv, tmp_path):
    """A key that the nodes refuse is refused here, too."""
    key = f"key 1 {'0a' * 16}\n".encode()
    os.mkfifo(tmp_path / "pipe.key", 0o600)
    for name, data, said in (
            ("pipe.key", None, "is not a regular file"),
            ("long.key", b"#" * 4095 + b"\n" + key, "is not a file of keys"),
            ("big.key", key.replace(b"1", b"256", 1), "big.key:1: this is"),
            ("cr.key", b"# a\r" + key, "has no key"),
            ("vt.key", key.replace(b" ", b"\v"), "1: this is not a key")):
        path = tmp_path / name
        if data is not None:
            path.write_bytes(data)
            path.chmod(0o600)
        found = urv("keygen", "--add", name)
        assert (found.returncode, found.stderr.count("\n")) == (2, 1), name
        assert said in found.stderr
        if data is not None:
            assert path.read_bytes() == data


def test_sec15_an_added_key_follows_no_link(urv, tmp_path):
    urv("keygen", "link.key")
    before = (tmp_path / "link.key").read_bytes()
    (tmp_path / "other.key").symlink_to("link.key")
    assert urv("keygen", "--add", "other.key").returncode == 2
    assert (tmp_path / "link.key").read_bytes() == before
    # The name that it had for a moment.
    (tmp_path / ".link.key.new").symlink_to("precious")
    assert urv("keygen", "--add", "link.key").returncode == 0
    assert not (tmp_path / "precious").exists()


def test_sec5_the_name_of_a_key_moves_no_cursor(urv, tmp_path):
    found = urv("keygen", "a\x1b[2J.key")
    assert (found.returncode, found.stdout) == (
        0, '"a\\x1b[2J.key": key 1\n')
