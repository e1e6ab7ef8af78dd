# SPDX-License-Identifier: Apache-2.0
"""From a Debian with nothing but git and make to a live display (GND-31)."""

import json
import os
import shutil
import subprocess
import sys
import time
import urllib.error
import urllib.request

import pytest
from ports import free_ports
from station_rig import ROOT

sys.path.insert(0, str(ROOT / "evidence"))

LIMIT_S = 360
GIVES_UP_S = 3600
FLIES_S = 30
VALUE = ("api/processors/urv/realtime/parameters/URV/gsc/downlink/airspeed")


def value_of(port):
    """Yamcs's value of the airspeed, None while there is none."""
    try:
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/{VALUE}",
                                    timeout=5.0) as answer:
            return json.load(answer).get("engValue")
    except (urllib.error.URLError, OSError, ValueError):
        return None


@pytest.mark.skipif(
    os.geteuid() != 0 or shutil.which("debootstrap") is None,
    reason="a bare Debian needs root and debootstrap")
def test_gnd31_a_bare_machine_has_a_live_display(tmp_path, found):
    """The time has no bound here: it is the network's and the machine's."""
    import independence
    folder = tmp_path / "debian"
    folder.mkdir()
    system = independence.fresh(folder, "12")
    first = free_ports(7)[0]
    options = (f"--ports {first} --page-port {first + 5}"
               f" --yamcs-port {first + 6}")
    log = tmp_path / "ground.log"
    try:
        independence.check_out(system / "root" / "urv")
        began = time.monotonic()
        with log.open("w", encoding="utf-8") as out:
            running = subprocess.Popen(
                ["chroot", system, "/usr/bin/env", "-i", "HOME=/root",
                 "LC_ALL=C.UTF-8", "PATH=/usr/sbin:/usr/bin:/sbin:/bin",
                 "sh", "-c", f"cd && cd urv && make ground GROUND_SECONDS="
                 f"{FLIES_S} OPTIONS='{options}'"], stdout=out, stderr=out,
                stdin=subprocess.DEVNULL)
        told = []
        while running.poll() is None and value_of(first + 6) is None:
            assert time.monotonic() - began < GIVES_UP_S
            lines = log.read_text("utf-8").splitlines()
            for line in lines[len(told):]:
                print(f"{time.monotonic() - began:.0f} s: {line}", flush=True)
            told = lines
            time.sleep(0.5)
        took_s = time.monotonic() - began
        assert running.poll() is None, log.read_text("utf-8")
        running.wait(GIVES_UP_S)
        assert running.returncode == 0, log.read_text("utf-8")
    finally:
        independence.left(system)
    found("`make ground` on a bare Debian 12, all downloads, to a live value"
          " in Yamcs", f"{LIMIT_S} s", f"{took_s:.0f} s")
