# SPDX-License-Identifier: Apache-2.0
"""FTI-7: test cards at the ground."""

import re
import socket
import subprocess
import sys
from pathlib import Path

import numpy
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "ground"))

from urv import card_page, card_signals, cards, faults  # noqa: E402

GOOD = """
[[card]]
name = "elevator doublet"
kind = "doublet"
moves = ["pitch"]
amplitude_deg = 2
pulse_s = 0.4
bank_deg = 30

[[card]]
kind = "multisine"
moves = ["roll", "pitch", "yaw"]
amplitude_deg = 2
length_s = 10
base_hz = 0.1
first_harmonic = 2
harmonics = 6
"""


def written(folder, text):
    path = folder / "cards.toml"
    path.write_text(text, encoding="utf-8")
    return path


def run(*arguments):
    return subprocess.run(
        [ROOT / "bin" / "urv", "card", *map(str, arguments)],
        capture_output=True, text=True, timeout=120, check=False)


def test_fti7_a_byte_order_mark_is_no_mistake(tmp_path):
    """The page took such a file, and the command did not."""
    assert (cards.read(written(tmp_path, "\ufeff" + GOOD))
            == cards.read(written(tmp_path, GOOD)))


def test_fti7_a_file_becomes_words(tmp_path):
    first, second = cards.read(written(tmp_path, GOOD))
    assert first.words()[:11] == (
        258, 12, 160, 40, 0, 0, 30 + 64 * 63, 63 + 64 * 63, 0, 4095, 0)
    assert (first.slot, second.slot) == (1, 2)
    assert second.words()[:6] == (518, 63, 160, 1000, 10, 2 * 16 + 6)


@pytest.mark.parametrize("before, after, message", [
    ('"doublet"', '"wiggle"', "card 1: kind is one of step, doublet"),
    ('["pitch"]', '["pitch", "left_rudder"]',
     "card 1: moves has axes or surfaces, not both"),
    ('["pitch"]', '["tail"]', "card 1: moves is a list of roll, pitch"),
    ("amplitude_deg = 2\npulse", "amplitude_deg = 11\npulse",
     "card 1: amplitude_deg is a number from 0.0125 to 10"),
    ("pulse_s = 0.4", "", "card 1: pulse_s is a number from 0.02 to 40.95"),
    ("bank_deg", "bank", 'card 1: unknown "bank"; there are'),
    ("base_hz = 0.1", "base_hz = 2",
     "card 2: its highest harmonic is 38 Hz, not 10 Hz or less"),
    ("[[card]]\nname", "[[map]]\nname", "a card begins with"),
    ('["pitch"]', '["pitch"]\nadded_to = ["stick"]',
     "card 1: added_to is one of servo, stick, command"),
    ('["pitch"]', '[["pitch"]]\nadded_to = "stick"',
     "card 1: moves is a list of roll, pitch, yaw, for inputs"),
    ('["pitch"]', '[{axis = "pitch"}]', "card 1: moves is a list of roll"),
    ('"doublet"', '["doublet"]', "card 1: kind is one of step, doublet"),
    ('"elevator doublet"', "0x" + 4_000 * "f", "card 1: name is a text"),
    ("pulse_s = 0.4", "pulse_s = " + 5_000 * "4", "no TOML: "),
    ('["pitch"]', 3_000 * "[" + 3_000 * "]", "nested too deeply"),
    ("[[card]]\nname", "[[card]]\nslot = 2\nname",
     "card 2: slot 2 is taken")])
def test_fti7_bad_cards_are_refused_in_one_line(
        tmp_path, before, after, message):
    assert before in GOOD
    path = written(tmp_path, GOOD.replace(before, after, 1))
    with pytest.raises(faults.Refused) as refused:
        cards.read(path)
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("moves", ['[["pitch"]]', 3_000 * "["])
def test_fti7_the_command_refuses_a_bad_file_in_one_line(tmp_path, moves):
    result = run("check", written(tmp_path, GOOD.replace(
        '["pitch"]', moves + '\nadded_to = "stick"', 1)))
    assert (result.returncode, len(result.stderr.splitlines())) == (2, 1)


def test_fti7_a_name_of_a_card_moves_no_cursor(tmp_path):
    result = run("check", written(tmp_path, GOOD.replace(
        "elevator doublet", r"a\u001b[2Jb", 1)))
    assert r'slot 1: "a\x1b[2Jb": 0.8 s' in result.stdout
    result = run("programme", tmp_path / "cards.toml", "--sticks",
                 tmp_path / "a\x1b.csv", "--orders", tmp_path / "b c")
    assert result.returncode == 0 and "\x1b" not in result.stdout
    assert f"--orders '{tmp_path / 'b c'}'" in result.stdout


PLACED = """
[[card]]
kind = "step"
added_to = "stick"
moves = ["pitch", "yaw"]
amplitude_percent = 10
pulse_s = 1

[[card]]
name = "bank step"
kind = "step"
added_to = "command"
moves = ["bank"]
amplitude_deg = 10
pulse_s = 4

[[card]]
kind = "multisine"
added_to = "command"
moves = ["bank", "pitch"]
amplitude_deg = 2
length_s = 10
base_hz = 0.1
first_harmonic = 1
harmonics = 4

[[card]]
kind = "doublet"
added_to = "command"
moves = ["airspeed"]
amplitude_kt = 5
pulse_s = 10
"""


def test_fti7_d100_inputs_to_sticks_and_commands_become_words(tmp_path):
    deck = cards.read(written(tmp_path, PLACED))
    assert [card.words()[:3] for card in deck] == [
        (257, 64 + 4 + 16, 205), (513, 128 + 1, 500),
        (768 + 16 + 6, 128 + 5, 100), (1_026, 128 + 32, 160)]
    for card in deck:
        assert cards.Card.of_words(card.words()[:11]) == card
    assert deck[0].signals()["yaw"].max() == pytest.approx(10, abs=0.02)
    assert deck[1].signals()["bank"].max() == 10
    assert deck[2].harmonics("pitch") == [2, 4, 6, 8]
    assert deck[3].signals()["airspeed"].max() == 5
    result = run("check", tmp_path / "cards.toml", "--plot",
                 tmp_path / "plot.html")
    assert 'slot 2: "bank step": 4 s, bank command 10.00 deg' in result.stdout
    assert "pitch stick 10.01 %" in result.stdout
    assert "airspeed command 5.00 kt" in result.stdout
    assert "pitch stick" in (tmp_path / "plot.html").read_text("utf-8")


@pytest.mark.parametrize("before, after, message", [
    ('"stick"', '"tail"', "card 1: added_to is one of servo, stick, command"),
    ('"pitch", "yaw"', '"left_rudder"', "card 1: moves is a list of roll,"
     " pitch, yaw, for inputs that are added to a stick"),
    ('["bank"]', '["yaw"]', "card 2: moves is a list of bank, pitch,"
     " altitude, airspeed, for inputs that are added to a command"),
    ("amplitude_percent", "amplitude_deg",
     "card 1: amplitude_deg is not for pitch, yaw, amplitude_percent is"),
    ("amplitude_percent = 10", "amplitude_percent = 50",
     "card 1: amplitude_percent is a number from 0.0488281 to 39.0625"),
    ('["bank"]', '["bank", "altitude"]',
     "card 2: bank, altitude have different units")])
def test_fti7_d100_bad_places_are_refused(tmp_path, before, after, message):
    assert before in PLACED
    path = written(tmp_path, PLACED.replace(before, after, 1))
    with pytest.raises(faults.Refused) as refused:
        cards.read(path)
    assert message in str(refused.value)


def test_fti7_cards_are_sent_over_ipv6_and_to_no_unknown_host(urv, tmp_path):
    (tmp_path / "cards.toml").write_text(GOOD, "utf-8")
    with socket.socket(socket.AF_INET6, socket.SOCK_DGRAM) as node:
        node.bind(("::1", 0))
        node.settimeout(30)
        result = urv("card", "send", "cards.toml", "--console",
                     f"udp:[::1]:{node.getsockname()[1]}")
        assert (result.returncode, result.stderr) == (0, "")
        assert node.recv(256)
    result = urv("card", "send", "cards.toml", "--console",
                 "udp:no-such.invalid:1")
    assert (result.returncode, result.stderr) == (
        2, 'urv: --console: there is no host "no-such.invalid"\n')


def test_fti7_the_commands_print_and_plot(tmp_path):
    path = written(tmp_path, GOOD)
    plot = tmp_path / "plot.html"
    result = run("check", path, "--plot", plot)
    assert result.returncode == 0, result.stderr
    assert 'slot 1: "elevator doublet": 0.8 s' in result.stdout
    assert "left rudder: 0.4, 0.7, 1, 1.3, 1.6, 1.9 Hz" in result.stdout
    assert plot.read_text("utf-8").count("<svg") == 4
    result = run("orders", path, "--begin-ms", 1000)
    lines = result.stdout.splitlines()
    assert [line.split()[:3] for line in lines] == [
        [str(at), "block", "500"] for at in (1000, 1200, 1400)]
    assert run("orders", path, "--choose", 5).returncode == 2


def test_fti7_a_spectrum_has_the_amplitudes_of_the_input():
    """None is twice the input's mean, as that of 0 Hz was."""
    times = numpy.arange(500) / 50
    hertz, sizes = card_page.spectrum(3 * numpy.sin(2 * numpy.pi * times))
    assert hertz[sizes.argmax()] == 1
    assert sizes.max() == pytest.approx(3)
    hertz, sizes = card_page.spectrum(numpy.full(200, 10.0))
    assert hertz[0] >= 0.25
    assert sizes.max() < 10
    assert len(card_page.spectrum(numpy.ones(1))[0]) > 0


def test_fti7_the_plot_is_dark_where_all_else_is(tmp_path, browser):
    """It stayed white, unlike all other pages of bin/urv."""
    plot = tmp_path / "cards.html"
    assert run("check", written(tmp_path, GOOD), "--plot", plot
               ).returncode == 0
    filters = {}
    for scheme in ("light", "dark"):
        page = browser.new_page(color_scheme=scheme)
        page.goto(plot.as_uri())
        filters[scheme] = page.evaluate(
            "[getComputedStyle(document.querySelector('svg')).filter,"
            " getComputedStyle(document.body).color]")
        page.close()
    assert filters["light"] == ["none", "rgb(0, 0, 0)"]
    assert filters["dark"] == ["invert(1) hue-rotate(180deg)",
                               "rgb(255, 255, 255)"]


def test_fti7_harmonics_are_disjoint_and_within_the_amplitude(tmp_path):
    card = cards.read(written(tmp_path, GOOD))[1]
    found = [each for surface in ("left_aileron", "left_elevator",
                                  "left_rudder")
             for each in card.harmonics(surface)]
    assert sorted(found) == list(range(2, 20))
    for values in card_signals.targets(card).values():
        assert 0.8 * card.amplitude < abs(values).max() <= card.amplitude
        sizes = abs(numpy.fft.rfft(values))
        assert set(numpy.argsort(sizes)[-6:]) <= set(found)


def test_fti7_tables_are_those_of_the_aircraft():
    text = (ROOT / "src/laws/urv-signal_tables.ads").read_text("utf-8")
    shares = re.search(r"Shares : .*?\((.*?)\);", text, re.DOTALL)[1]
    assert tuple(map(int, shares.split(","))) == card_signals.SHARES
    assert subprocess.run([ROOT / "scripts/laws/sines.py", "check"],
                          check=False).returncode == 0
