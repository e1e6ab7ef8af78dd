# SPDX-License-Identifier: Apache-2.0
"""bin/urv ground: the whole station in real time (GND-30 to GND-32)."""

import json
import os
import random
import re
import signal
import socket
import time
import urllib.request
from pathlib import Path

import pytest
from fake_node import FakeNode
from flight_rig import Archive, Ground, needs_yamcs
from ports import free_ports
from station_rig import KEYS_COUNT, PATIENCE_S, Console, take_sticks, until

from urv import display, faults, ground as module, packets, programs
from urv.ground import NODES, PASSED_ON


def test_gnd31_a_flight_ends_by_itself_with_its_records(tmp_path):
    with Ground(tmp_path, "--no-yamcs", "--seconds", "4") as ground:
        ground.process.wait(3 * PATIENCE_S)
    assert ground.status == ground.good_status(), ground.said()
    # On a machine that is late the aircraft begins later, and frames are left
    # out, but not all of the last second.
    frames = [int(row["frame"]) for row in ground.record()]
    assert frames == sorted(frames) and frames[-1] > 150
    assert ground.record("aircraft")
    lines = [json.loads(line) for line in
             (ground.folder / "station.jsonl").read_text().splitlines()]
    assert "run" in {line["kind"] for line in lines}


def test_gnd31_what_the_station_showed_is_the_record(tmp_path):
    with Ground(tmp_path, "--no-yamcs") as ground:
        shown = {}
        for _ in range(20):
            state = ground.wait(
                lambda state: state.get("link") == "heard"
                and state["seq"] not in shown, "another frame")
            shown[state["seq"]] = state["words"]
        last = state["seq"]
        ground.wait(lambda state: state["seq"] > last + 5, "later frames")
    assert ground.status == 0, ground.said()
    rows = {int(row["frame"]): row for row in ground.record()}
    for frame, words in shown.items():
        assert [int(rows[frame][column]) for column in packets.COLUMNS
                ] == words


def test_gnd31_a_dead_station_is_reported_and_the_flight_goes_on(tmp_path):
    with Ground(tmp_path, "--no-yamcs") as ground:
        ground.wait(lambda state: state.get("link") == "heard", "the link")
        frames = len(ground.record())
        os.kill(ground.named("station"), signal.SIGKILL)
        until(lambda: "station has ended, SIGKILL; the flight goes on"
              in ground.said(), "a word of it")
        until(lambda: len(ground.record()) > frames + 100, "more frames",
              3 * PATIENCE_S)
        assert ground.process.poll() is None
    assert ground.status == 1
    assert "station ended during the flight" in ground.said()


def plant_of(ground):
    return ground.named("plant.py")


def shows_alert(ground, name, active=True):
    return ground.wait(lambda state: [
        alert for alert in state["alerts"]
        if alert["name"] == name and alert["active"] == active], name)


def test_gnd47_a_killed_plant_is_reported_at_terminal_and_page(tmp_path):
    with Ground(tmp_path, "--no-yamcs") as ground:
        ground.wait(lambda state: state.get("link") == "heard"
                    and state["down_ms"] < 100, "the link")
        os.kill(plant_of(ground), signal.SIGKILL)
        until(lambda: "ground: urv_mcs: plant has died at" in ground.said(),
              "a word of it")
        shows_alert(ground, "PLANT GONE")
        state = shows_alert(ground, "SENSORS OLD")
        # The link is well, and no surface has failed.
        later = ground.wait(lambda now: now["seq"] > state["seq"] + 50,
                            "a second more")
        assert not [alert for alert in later["alerts"]
                    if "FAILED" in alert["name"]]
        assert later["down_ms"] > 500
        assert not (later["laws"] or {}).get("failed")
    assert ground.status == 1
    assert ground.said().splitlines()[-1] == (
        "urv: urv_mcs: --plant jsbsim: JSBSim's process has ended")


def test_gnd47_a_stopped_plant_and_a_stopped_node_are_reported(tmp_path):
    """GND-54: and a fault, though they run again."""
    with Ground(tmp_path, "--no-yamcs") as ground:
        ground.wait(lambda state: state.get("link") == "heard", "the link")
        plant = plant_of(ground)
        os.kill(plant, signal.SIGSTOP)
        shows_alert(ground, "PLANT SILENT")
        os.kill(plant, signal.SIGCONT)
        shows_alert(ground, "PLANT SILENT", active=False)
        node = ground.named("urv_mcs")
        os.kill(node, signal.SIGSTOP)
        shows_alert(ground, "URV_MCS STOPPED")
        shows_alert(ground, "LINK LOST")
        os.kill(node, signal.SIGCONT)
        shows_alert(ground, "URV_MCS STOPPED", active=False)
        for said in ("plant does not answer", "plant in time again",
                     "urv_mcs is stopped", "urv_mcs runs again"):
            assert said in ground.said()
        for name in ("PLANT STOPPED", "URV_MCS STOPPED"):
            shows_alert(ground, name, active=False)
    assert ground.status == 1, ground.said()
    assert ground.said().splitlines()[-1] == (
        "urv: plant and urv_mcs stood still during the flight")


def test_gnd54_a_stopped_ground_node_is_reported_and_a_fault(tmp_path):
    with Ground(tmp_path, "--no-yamcs") as ground:
        ground.wait(lambda state: state.get("link") == "heard", "the link")
        os.kill(ground.named("urv_gsc"), signal.SIGSTOP)
        until(lambda: "ground: urv_gsc is stopped" in ground.said(),
              "a word of it")
        shows_alert(ground, "URV_GSC STOPPED")
    assert ground.status == 1, ground.said()


def test_gnd53_a_full_disk_ends_no_flight(tmp_path):
    """A limit of files: each may have this number of bytes. The flight goes
    on, the page and the terminal report each output, and the exit status does.
    The reports do not go through the logs, which are full as well (D-56)."""
    limit = 40_000
    with Ground(tmp_path, "--no-yamcs", most_bytes=limit) as ground:
        state = shows_alert(ground, "MCS RECORD LOST")
        shows_alert(ground, "GSC RECORD LOST")
        ground.wait(lambda now: now["seq"] > state["seq"] + 100
                    and now["link"] == "heard", "more frames")
        assert ground.process.poll() is None
    assert ground.status == 1
    for node in ("urv_mcs", "urv_gsc"):
        assert re.search(f"ground: {node}: --record: .* cannot be written:"
                         " File too large", ground.said())
    for name in ("aircraft", "ground"):
        assert (ground.folder / f"{name}.csv").stat().st_size == limit
        summary = json.loads((ground.folder / f"{name}.json").read_text())
        assert summary["lost_outputs"] == ["--record"]
        assert summary["frames"] > state["seq"]


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no /dev/full")
def test_gnd53_a_terminal_that_is_full_ends_no_flight(tmp_path):
    with open("/dev/full", "w", encoding="utf-8") as full:
        ground = Ground(tmp_path, "--no-yamcs", terminal=full)
        with ground:
            ground.wait(lambda state: state.get("seq", 0) > 100, "frames")
            shows_alert(ground, "OUTPUT LOST")
    assert ground.status == 1
    assert ground.said() == (
        "urv: standard output cannot be written: No space left on device\n")


def test_gnd47_a_stopped_station_is_reported_and_ends(tmp_path):
    with Ground(tmp_path, "--no-yamcs") as ground:
        ground.wait(lambda state: state.get("link") == "heard", "the link")
        os.kill(ground.named("station"), signal.SIGSTOP)
        until(lambda: "ground: station is stopped" in ground.said(),
              "a word of it")
    assert ground.status == 1, ground.said()
    assert "station stood still during the flight" in ground.said()


def test_gnd47_nodes_with_two_keys_end_with_a_status_of_their_own(
        tmp_path, urv, monkeypatch):
    """The aircraft is given another key after the ground has read its own:
    here by a node that is told another one."""
    keys = [tmp_path / name for name in ("one.key", "two.key")]
    for key in keys:
        assert urv("keygen", key).returncode == 0
    flight = module.Flight(
        tmp_path / "flight", free_ports(5)[0], *free_ports(2))
    flight.folder.mkdir()
    flight.given = {"--format": "2", "--key": keys[0]}
    passed_on = flight.passed_on
    monkeypatch.setattr(flight, "passed_on", lambda node: [
        keys[1] if node == "urv_mcs" and word == keys[0] else word
        for word in passed_on(node)])
    before = {number: signal.getsignal(number)
              for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        flight.start("none", False, None, 8)
        assert flight.watch() == 0
    finally:
        flight.end()
        for number, handler in before.items():
            signal.signal(number, handler)
    with pytest.raises(faults.Unheard, match="never heard"):
        flight.judge()
    told = [json.loads(line)["text"] for line in
            (flight.folder / "station.jsonl").read_text().splitlines()]
    assert any(text.startswith("LINK REFUSED") for text in told), told
    assert any(text.startswith("MCS REFUSES BLOCKS") for text in told), told


def test_gnd31_a_dead_node_ends_the_flight(tmp_path):
    with Ground(tmp_path, "--no-yamcs") as ground:
        os.kill(ground.named("urv_mcs"), signal.SIGKILL)
        ground.process.wait(PATIENCE_S)
    assert ground.status == 1
    assert "urv_mcs has ended, SIGKILL" in ground.said()


def test_gnd31_killed_itself_it_leaves_nobody(tmp_path):
    with Ground(tmp_path, "--no-yamcs") as ground:
        ground.process.kill()
        ground.process.wait(PATIENCE_S)
        until(lambda: ground.left() == [], "nobody left")


def test_gnd31_an_interrupt_ends_it_in_the_background_too(tmp_path):
    """A shell that is not interactive starts programs with SIGINT off. The end
    is deliberate: exit status 0 (D-39)."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        ground = Ground(tmp_path, "--no-yamcs").__enter__()
    finally:
        signal.signal(signal.SIGINT, before)
    until(ground.has_summaries, "a summary of each node")
    ground.__exit__()
    assert ground.status == ground.good_status()


def test_gnd31_a_port_that_is_taken_is_reported(tmp_path, urv):
    with Ground(tmp_path, "--no-yamcs") as ground:
        result = urv("ground", "--no-yamcs", "--folder", tmp_path / "other",
                     "--page-port", ground.page_port,
                     "--ports", free_ports(5)[0])
        assert result.returncode == 2
        assert result.stderr == (
            f'urv: --page-port "127.0.0.1", port {ground.page_port}:'
            " Address already in use\n")


def test_gnd31_a_bad_value_is_reported_with_the_option_of_ground(
        tmp_path, urv):
    """The option was --to, that of bin/urv mavlink, and the status was 1."""
    result = urv("ground", "--no-yamcs", "--folder", tmp_path / "flight",
                 "--page-port", free_ports(1)[0], "--ports", free_ports(5)[0],
                 "--mavlink", "nowhere")
    assert (result.returncode, result.stderr) == (
        2, 'urv: --mavlink "nowhere": not udp:HOST:PORT\n')


def command_line(ground, node):
    line = Path(f"/proc/{ground.named(node)}/cmdline").read_bytes()
    return line.decode().split("\0")


def test_gnd31_what_is_the_nodes_is_passed_on_to_them(tmp_path, urv):
    key = tmp_path / "link.key"
    assert urv("keygen", key).returncode == 0
    orders = tmp_path / "orders.txt"
    orders.write_text("60000000 configure 1 2000 9000\n")
    given = {"--format": "2", "--key": str(key), "--processors": "1",
             "--schedule": "fast", "--laws": "on", "--orbit-after": "10",
             "--terminate-after": "60.5", "--orders": str(orders),
             "--line-delay": "0.5"}
    with Ground(tmp_path, "--no-yamcs", "--lock",
                *(word for pair in given.items() for word in pair)) as ground:
        ground.wait(lambda state: state.get("link") == "heard", "the link")
        for node in NODES:
            words = command_line(ground, node)
            for option, value in given.items():
                if node in PASSED_ON[option]:
                    assert words[words.index(option) + 1] == value
                else:
                    assert option not in words
            assert "--lock" in words
        assert {*given, "--lock"} == set(PASSED_ON)
    assert ground.status == 0, ground.said()


@pytest.mark.parametrize("given, said", [
    (("--format", "3"), '--format: "3" is neither 1 nor 2'),
    (("--laws", "maybe"), '--laws: "maybe" is neither "on" nor "off"'),
    (("--laws", "off", "--orbit-after", "10"), "--orbit-after and"
     " --terminate-after are times of the control laws: add --laws on")])
def test_gnd31_what_a_node_refuses_is_reported_in_its_words(
        tmp_path, urv, given, said):
    result = urv("ground", "--no-yamcs", "--folder", tmp_path / "flight",
                 "--page-port", free_ports(1)[0], "--ports", free_ports(5)[0],
                 *given)
    assert result.returncode == 2, result.stderr
    # Both refuse: one is the first.
    assert result.stderr in [f"urv: {node}: {said}\n"
                             for node in ("urv_mcs", "urv_gsc")]


def test_gnd27_a_refused_flight_leaves_the_events_of_the_one_before(
        tmp_path, urv):
    """Marks and alerts of that flight were lost, or a line said that there is
    no file."""
    folder = tmp_path / "flight"
    folder.mkdir()
    (folder / "ground.jsonl").write_text("{}\n")
    (folder / "events.jsonl").write_text("earlier\n")
    result = urv("ground", "--no-yamcs", "--folder", folder,
                 "--page-port", free_ports(1)[0], "--ports", free_ports(5)[0],
                 "--format", "2")
    assert result.returncode == 2, result.stderr
    assert "events.jsonl" not in result.stdout
    assert (folder / "events.jsonl").read_text() == "earlier\n"


def test_gnd21_a_stick_moved_on_the_page_moves_the_servos(
        tmp_path, browser):
    with Ground(tmp_path, "--no-yamcs") as ground:
        ground.wait(lambda state: state.get("pilot") == "flies"
                    and state["link"] == "heard", "the pilot flies")
        page = browser.new_page()
        page.add_init_script(KEYS_COUNT)
        errors = []
        page.on("console", lambda message: errors.append(message.text)
                if message.type == "error" else None)
        page.set_default_timeout(PATIENCE_S * 1000)
        page.goto(f"http://127.0.0.1:{ground.page_port}/")
        page.locator("#holder", has_text="simulated pilot").wait_for()
        take_sticks(page)
        page.keyboard.down("Shift")
        page.keyboard.down("ArrowRight")
        ground.wait(lambda state: state["words"][
            packets.COLUMNS.index("gsc.uplink.roll")] == 4095, "full roll")
        until(lambda: any(row["pwm.left_aileron"] == "4095"
                          for row in ground.record("aircraft")[-500:]
                          if row["pwm.left_aileron"]), "it at the servo")
        page.keyboard.up("ArrowRight")
        page.keyboard.up("Shift")

        def is_given():
            for _ in range(20):
                if ground.state()["pilot"] == "flies":
                    return True
                page.wait_for_timeout(100)
            # A slow machine has dropped it as late.
            page.evaluate("document.querySelector('#pilot').click()")
            return False

        page.locator("#pilot").click()
        until(is_given, "the pilot flies again")
        page.close()
        assert errors == []
    assert ground.status == 0, ground.said()


def test_gnd24_garbage_at_every_port_loses_no_frame(tmp_path):
    chance = random.Random(3)
    with Ground(tmp_path, "--no-yamcs") as ground:
        ground.wait(lambda state: state.get("link") == "heard", "the link")
        first = ground.page_port - 5
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            for _ in range(400):
                for port in range(first, first + 5):
                    sender.sendto(chance.randbytes(chance.randrange(1500)),
                                  ("127.0.0.1", port))
                time.sleep(0.005)
        for _ in range(20):
            with socket.create_connection(
                    ("127.0.0.1", ground.page_port)) as client:
                client.sendall(chance.randbytes(1000))
        state = ground.wait(
            lambda state: state["packets"]["bad"] > 300
            and state["counts"]["console_bad"] > 300, "all counted")
        ground.wait(lambda now: now["seq"] > state["seq"] + 50
                    and now["link"] == "heard", "it flies on")
    assert ground.status == 0, ground.said()
    # A frame is left out only where the machine ran the node late.
    rows = [int(row["frame"]) for row in ground.record()]
    summary = json.loads((ground.folder / "ground.json").read_text())
    gaps = sum(after - before - 1
               for before, after in zip(rows, rows[1:], strict=False))
    assert gaps <= summary["overruns"]
    assert summary["exceptions"] == 0


def test_gnd27_marks_and_alerts_are_events_for_the_report(tmp_path, urv):
    with Ground(tmp_path, "--no-yamcs") as ground:
        ground.wait(lambda state: state.get("link") == "heard", "the link")
        console = Console(ground.page_port)
        console.say({"t": "mark", "text": "gear <b>up</b>"})
        ground.wait(lambda state: state["seq"] > 50, "some frames")
        console.close()
    events = [json.loads(line) for line in
              (ground.folder / "events.jsonl").read_text().splitlines()]
    [mark] = [event for event in events if "mark" in event["kind"]]
    assert mark["kind"] == "mark: gear \u2039b\u203aup\u2039/b\u203a"
    assert mark["first_ms"] == 20 * mark["first_frame"]
    made = urv("report", ground.folder / "ground.csv", "--events",
               ground.folder / "events.jsonl", "-o", "report.html")
    assert made.returncode == 0, made.stderr


# Yamcs

def test_gnd32_the_display_shows_what_there_is():
    text = display.flight()
    shown = set(re.findall(r"<pv(?:_name| trig=.true.)>(.*?)</pv", text))
    for name in ("roll_attitude", "pitch_attitude", "airspeed", "altitude",
                 "alpha", "rpm", "battery_volts", "alternator_volts",
                 *display.SURFACES):
        assert f"/URV/gsc/downlink/{name}" in shown
    assert {f"/URV/link/{name}" for name in packets.LINK_COUNTS} <= shown
    assert {"/URV/frames", "/URV/downlink_age", "/URV/laws/failed",
            "/URV/laws/not_valid_high"} <= shown
    from urv import xtce
    database = xtce.mission_database()
    for name in shown:
        assert f'name="{name.rpartition("/")[2]}"' in database, name


@needs_yamcs
def test_gnd46_yamcs_shows_a_ground_that_starts_with_an_earlier_clock(
        tmp_path, standard):
    """Its clock is an hour earlier than that of the run before. GND-56: Yamcs
    knows how old its frames are all the same."""
    folder = tmp_path / "flight"
    folder.mkdir()
    flight = module.Flight(folder, free_ports(5)[0], *free_ports(2))
    url = flight.yamcs

    def shown(name, kind):
        """The values that Yamcs shows."""
        try:
            with urllib.request.urlopen(
                    f"{url}/api/processors/urv/realtime/parameters/URV/"
                    f"{name}", timeout=PATIENCE_S) as answer:
                return json.load(answer)["engValue"][kind]
        except (OSError, KeyError):
            return None

    def sequence():
        return shown("sequence", "uint32Value")

    def frames():
        return shown("frames", "stringValue")

    before = {number: signal.getsignal(number)
              for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        flight.run("station", *programs.URV, "station",
                   "--port", flight.page_port,
                   "--frames", f"udp:127.0.0.1:{flight.frames}",
                   "--relay", f"tcp:127.0.0.1:{flight.relay}",
                   tells=True, yamcs=url)
        flight.await_station()
        flight.start_yamcs()
        with FakeNode(standard / "record.csv",
                      ("127.0.0.1", flight.frames)) as node:
            node.sequence = 1_000_000
            until(lambda: (sequence() or 0) >= 1_000_000, "frames",
                  5 * PATIENCE_S, pause=0.5)
            node.clock_us = -3_600_000_000
            node.run_number ^= 1 << 22
            node.sequence = 0
            until(lambda: (sequence() or 10**6) < 10**6, "the new run",
                  PATIENCE_S, pause=0.5)
            seen = sequence()
            until(lambda: seen < (sequence() or 0) < 10**6, "its frames",
                  PATIENCE_S, pause=0.5)
            until(lambda: frames() == "coming", "its clock", PATIENCE_S)
            # They come, but three seconds after they were made.
            node.late_s = 3.0
            until(lambda: frames() == "MISSING", "no frames", PATIENCE_S)
            seen = sequence()
            until(lambda: seen + 200 < (sequence() or 0) < 10**6, "old ones",
                  PATIENCE_S, pause=0.5)
            assert frames() == "MISSING"
            node.late_s = 0.0
            until(lambda: frames() == "coming", "new ones", PATIENCE_S)
    finally:
        flight.end()
        for number, handler in before.items():
            signal.signal(number, handler)


def assert_local(process):
    """It listens at no address that other machines reach."""
    sockets = {os.readlink(link) for link in
               Path(f"/proc/{process}/fd").iterdir() if link.is_symlink()}
    found = 0
    for table in ("tcp", "tcp6", "udp", "udp6"):
        lines = Path(f"/proc/{process}/net/{table}").read_text().splitlines()
        for line in lines[1:]:
            fields = line.split()
            listens = fields[3] in ("0A", "07")
            if listens and f"socket:[{fields[9]}]" in sockets:
                address = fields[1].partition(":")[0]
                assert address.endswith("0100007F"), (table, line)
                found += 1
    assert found > 0


@needs_yamcs
def test_gnd30_yamcs_has_every_frame_as_the_record_has_it(tmp_path):
    with Ground(tmp_path) as ground:
        until(lambda: "live after" in ground.said(), "Yamcs",
              5 * PATIENCE_S)
        console = Console(ground.page_port)
        console.say({"t": "mark", "text": "gear <up>"})
        ground.wait(lambda state: state["seq"] > 600, "600 frames")
        archive = Archive(ground)
        columns = ("gsc.downlink.airspeed", "gsc.downlink.battery_volts",
                   "gsc.downlink.roll_attitude", "gsc.uplink.throttle")
        archive.fetch(ground.state()["seq"], columns)
        until(lambda: [event for event in archive.events()
                       if event.message == "gear <up>"], "the mark",
              pause=0.5)
        kinds = {event.event_type for event in archive.events()}
        assert {"run", "mark", "error"} <= kinds

        assert_local(ground.named("YamcsServer"))

        # A killed Yamcs is told, and everything else flies on.
        os.kill(ground.named("YamcsServer"), signal.SIGKILL)
        until(lambda: "yamcs has ended, SIGKILL; the flight goes on"
              in ground.said(), "a word of it")
        state = ground.wait(lambda state: state["archive"]["lost"]
                            and state["alerts"], "a caution")
        assert "ARCHIVE" in {alert["name"] for alert in state["alerts"]}
        ground.wait(lambda now: now["seq"] > state["seq"] + 100, "frames")
        console.close()
    # Whoever has died, the flight was not what was asked for.
    assert ground.status == 1, ground.said()
    assert "yamcs ended during the flight" in ground.said()

    archive.compare(ground.record(), columns)
