# SPDX-License-Identifier: Apache-2.0
"""EVI-11: the messages of set-up. apt-get, dpkg-query, id and pip are
stand-ins here: nothing is installed."""

import platform
import re
import shutil
import subprocess

import pytest
from conftest import ROOT

NO_NETWORK = "Err:1 http://deb.debian.org Could not resolve 'deb.debian.org'"


def debian():
    try:
        release = platform.freedesktop_os_release()
    except OSError:
        return None
    return release["ID"], release.get("VERSION_ID")


@pytest.fixture
def set_up(tmp_path):
    """Runs a copy of the script with commands of the test's on the PATH."""
    (tmp_path / "scripts").mkdir()
    for name in ("setup.sh", "patiently.sh"):
        shutil.copy(ROOT / "scripts" / name, tmp_path / "scripts")
    for name in ("sim/jsbsim/requirements.txt", "tests/requirements.txt",
                 "scripts/trace/requirements.txt",
                 "ground/report-requirements.txt",
                 "ground/requirements.txt",
                 "ground/campaign-requirements.txt",
                 "ground/identify-requirements.txt"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    commands = tmp_path / "commands"
    commands.mkdir()

    # The user may have no right to real-time priorities.
    def run(target, alire=False, path="/usr/bin:/bin", chrt="exit 0",
            LC_ALL="", **scripts):
        scripts["chrt"] = chrt
        for name, script in scripts.items():
            command = commands / name.replace("_", "-")
            command.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
            command.chmod(0o755)
        return subprocess.run(
            ["scripts/setup.sh", target], cwd=tmp_path, text=True,
            capture_output=True, check=False, timeout=60,
            env={"PATH": f"{commands}:{path}", "HOME": str(tmp_path),
                 "LC_ALL": LC_ALL,
                 **({"ALIRE": "True"} if alire else {})})
    return run


on_debian = pytest.mark.skipif(
    debian() not in (("debian", "12"), ("debian", "13")),
    reason="packages are Debian's")

MISSING = {"dpkg_query": "exit 1"}


@on_debian
def test_a_user_gets_the_one_command(set_up):
    result = set_up("test", **MISSING, id="echo 1000")
    assert result.returncode == 1
    commands = [line.strip() for line in result.stderr.splitlines()
                if line.startswith("    ")]
    assert len(commands) == 1
    begin = ("apt-get update && apt-get install -y --no-install-recommends"
             " gnat-")
    assert commands[0].startswith(begin)
    assert {"gprbuild", "afl++", "python3-venv"} <= set(commands[0].split())


@on_debian
def test_what_test_needs_is_enough_to_fly(set_up):
    told = {target: set_up(target, **MISSING, id="echo 1000").stderr
            for target in ("fly", "test", "check")}
    needed = {target: set(text.split("recommends ")[1].split())
              for target, text in told.items()}
    assert needed["fly"] < needed["check"] < needed["test"]


@on_debian
def test_evi11_the_station_without_yamcs_needs_no_java(set_up):
    told = {target: set_up(target, **MISSING, id="echo 1000").stderr
            for target in ("fly", "page", "ground")}
    needed = {target: set(text.split("recommends ")[1].split())
              for target, text in told.items()}
    assert needed["fly"] < needed["page"] < needed["ground"]
    assert needed["ground"] - needed["page"] == {
        "default-jre-headless", "maven"}


@on_debian
def test_what_test_names_is_enough_for_each_command_of_readme(set_up):
    told = {target: set_up(target, **MISSING, id="echo 1000").stderr
            for target in ("fly", "test", "check", "ground")}
    needed = {target: set(text.split("recommends ")[1].split())
              for target, text in told.items()}
    assert needed["fly"] | needed["check"] | needed["ground"] \
        < needed["test"]
    # As root a target installs what it wants itself.
    result = set_up("test", **MISSING, id="echo 0", apt_get="exit 1")
    assert "maven" not in result.stdout + result.stderr


@on_debian
def test_root_without_real_time_rights_gets_a_message_before_the_installation(
        set_up):
    result = set_up("test", **MISSING, id="echo 0", chrt="exit 1",
                    apt_get="echo called")
    assert (result.returncode, result.stdout) == (1, "")
    assert result.stderr.startswith(
        "setup: root may not give threads real-time priorities here")
    assert len(result.stderr.splitlines()) == 1


@on_debian
@pytest.mark.parametrize("apt_get", [
    # Debian's apt-get update ends well then.
    f'echo "{NO_NETWORK}"; exit 0',
    f'echo "{NO_NETWORK}"; exit 100',
    # It had been reached, but not any more.
    'if [ "$1" = update ]; then echo "Get:1 http://deb.debian.org";'
    f' else echo "{NO_NETWORK}"; exit 100; fi',
])
def test_no_network_is_called_that(set_up, apt_get):
    result = set_up("real_time", **MISSING, id="echo 0", apt_get=apt_get)
    assert result.returncode == 1
    assert result.stdout.startswith("real_time: installing gnat-")
    assert len(result.stderr.splitlines()) == 1
    assert result.stderr.startswith("setup: no network: apt-get ")


@on_debian
def test_evi11_apt_get_is_understood_in_each_language(set_up):
    """It translates the lines that show that it reached something."""
    apt_get = ('case $LC_ALL in C*) get=Get no="Could not resolve" ;;'
               ' *) get=Holen no="Konnte nicht" ;; esac;'
               ' echo "$get:1 http://deb.debian.org";'
               ' [ "$1" = update ] || { echo "$no"; exit 100; }')
    result = set_up("real_time", **MISSING, id="echo 0", apt_get=apt_get,
                    LC_ALL="de_DE.UTF-8")
    assert result.stderr.startswith(
        "setup: no network: apt-get install reached nothing.")


@on_debian
def test_another_failure_is_shown(set_up):
    result = set_up(
        "real_time", **MISSING, id="echo 0",
        apt_get='echo "Get:1 http://deb.debian.org";'
                ' [ "$1" = update ] || { echo "No space left"; exit 100; }')
    assert result.returncode == 1
    assert "No space left" in result.stderr
    assert "setup: apt-get install failed" in result.stderr
    assert "no network" not in result.stderr


@on_debian
def test_what_is_there_is_not_installed(set_up):
    result = set_up("real_time", dpkg_query="echo install ok installed",
                    apt_get="echo called; exit 1")
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")


def test_pip_without_a_network_is_called_that(set_up, tmp_path):
    # An environment with a pip that reaches nothing.
    python = tmp_path / ".venv" / "bin" / "python"
    python.parent.mkdir(parents=True)
    python.write_text(
        '#!/bin/sh\n[ "$1" = -c ] && exit 0\n'
        'echo "WARNING: NewConnectionError: Name or service not known" >&2\n'
        "exit 1\n", encoding="utf-8")
    python.chmod(0o755)
    result = set_up("fly", alire=True, gprbuild="", gcc="")
    assert result.returncode == 1
    assert result.stderr == (
        "setup: no network: pip reached nothing. Needed are: the packages of"
        " sim/jsbsim/requirements.txt\n")


def test_where_gnatprove_comes_from(set_up):
    result = set_up("prove", alire=True, gprbuild="", gcc="")
    assert result.returncode == 1
    assert "https://alire.ada.dev" in result.stderr
    assert "cd proofs && alr exec -- make -C .. prove" in result.stderr
    result = set_up("prove", alire=True, gprbuild="", gcc="", gnatprove="")
    assert (result.returncode, result.stderr) == (0, "")


def test_elsewhere_a_missing_command_is_named(set_up, tmp_path):
    tools = tmp_path / "tools"
    tools.mkdir()
    for name in ("dirname", "mktemp", "rm"):
        (tools / name).symlink_to(shutil.which(name))
    result = set_up("fly", alire=True, path=str(tools), gprbuild="")
    assert result.returncode == 1
    assert result.stderr.startswith("setup: gcc is missing.")
    assert "alr exec -- make fly" in result.stderr


def test_an_unknown_target_is_refused(set_up):
    result = set_up("flie")
    assert result.returncode == 2
    assert result.stderr.startswith(
        "setup: no such target: flie; usage: scripts/setup.sh TARGET, one of"
        " fly ground page test ")
    assert len(result.stderr.splitlines()) == 1
    # Each that it names is one, and each target of the Makefiles is named.
    named = result.stderr.split("one of ")[1].split()
    called = set(re.findall(
        r"setup\.sh (\w+)", (ROOT / "Makefile").read_text("utf-8")
        + (ROOT / "evidence" / "Makefile").read_text("utf-8")))
    assert called <= set(named)
    script = (ROOT / "scripts" / "setup.sh").read_text("utf-8")
    cases = script.partition("case $target in")[2].partition("esac")[0]
    assert sorted(named) == sorted(re.findall(
        r"\w+", " ".join(re.findall(r"^   ([\w| ]+)\)", cases, re.M))))


def test_evi11_without_a_target_the_choices_are_listed(set_up):
    """The shell's own line was "scripts/setup.sh: 22: 1: usage: ..."."""
    result = set_up("")
    assert result.returncode == 2
    assert result.stderr.startswith(
        "setup: usage: scripts/setup.sh TARGET, one of fly ")


@on_debian
def test_evi11_a_missing_gnatprove_is_named_before_debians_packages(set_up):
    """Root was asked for a compiler that Alire replaces."""
    result = set_up("prove", **MISSING, id="echo 1000")
    assert result.returncode == 1
    assert result.stderr.startswith("setup: gnatprove is not on the PATH.")
    assert "apt-get" not in result.stderr
