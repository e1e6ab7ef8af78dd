# SPDX-License-Identifier: Apache-2.0
"""FTI-1 to FTI-7: test cards from the ground to the servos."""

import json
import sys

import pytest
from conftest import ROOT, fly_in
from test_flight import has_jsbsim

sys.path.insert(0, str(ROOT / "ground"))

import card_flights  # noqa: E402
from urv import card_programme, cards, flights  # noqa: E402
from urv.identification import manoeuvres  # noqa: E402

LIMITS = {"bank": 30, "pitch": 25, "alpha": 12, "load": 15,
          "slowest": 55 * 32, "fastest": 100 * 32, "lowest": 800}
DOUBLET = cards.Card(
    slot=1, kind="doublet", surfaces=cards.AXES["pitch"], amplitude=100,
    time=100, **LIMITS)
MULTISINE = cards.Card(
    slot=2, kind="multisine", surfaces=cards.SURFACES, amplitude=160,
    time=500, first=20, last=1 * 16 + 6, **LIMITS)
SWEEP = cards.Card(
    slot=8, kind="exponential sweep", surfaces=("left_rudder",),
    amplitude=200, time=400, first=20, last=200)
STICK = cards.Card(
    slot=1, kind="doublet", place="stick", surfaces=("roll", "pitch", "yaw"),
    amplitude=150, time=100, **LIMITS)
BANK = cards.Card(
    slot=1, kind="step", place="command", surfaces=("bank",),
    amplitude=500, time=200, **LIMITS)
SPEED = cards.Card(
    slot=1, kind="step", place="command", surfaces=("altitude", "airspeed"),
    amplitude=40, time=200)
NEUTRAL = 2_048
COMPLETE, SWITCHED_OFF, DISCONNECTED, LINK_LOST, STICK_MOVED = range(1, 6)
SENSOR_INVALID, ENVELOPE_LEFT, SURFACE_FAILED, RESTARTED = range(6, 10)
NOT_FOLLOWED = 11
STARTS_MS = 4_000
ON, OFF = 4_095, 0


def fly_cards(folder, deck, sticks, *options, faults="", sensors="",
              orders=""):
    """A flight in which the cards go up from 2 s on."""
    folder.mkdir(exist_ok=True)
    lines = [card.order(2_000 + 200 * place)
             for place, card in enumerate(deck)]
    files = {"orders": "\n".join(lines) + "\n" + orders, "sticks": sticks,
             "faults": faults, "sensors": sensors}
    options = ["--laws", "on", *options]
    for name, text in files.items():
        if text:
            (folder / name).write_text(text, encoding="ascii")
            options += [f"--{name}", name]
    return fly_in(folder, *options)


def switched(*times, names="switch5", rest=""):
    """Sticks with switch 5 on and off, in turn."""
    begin = "" if times[0] == 0 else f"0,2048,0{rest}\n"
    return f"time_ms,throttle,{names}\n{begin}" + "".join(
        f"{time},2048,{OFF if place % 2 else ON}{rest}\n"
        for place, time in enumerate(times))


def inputs(flight, surface):
    return [word - NEUTRAL for word in flight.record[f"laws.added.{surface}"]]


def event(flight, name):
    for line in flight.path("events.jsonl").read_text("utf-8").splitlines():
        found = json.loads(line)
        if (found["node"], found["kind"]) == ("mcs", name):
            return found["count"], found["last_detail"]
    return None


def test_fti1_fti3_fti4_cards_run_in_order_as_the_ground_computes(tmp_path):
    flight = fly_cards(
        tmp_path / "f", (DOUBLET, MULTISINE, SWEEP),
        switched(4_000, 7_000, 8_000, 14_000, 15_000), "--seconds", "20")
    assert event(flight, "card_refused") is None
    assert event(flight, "card_ended") == (3, 8 * 16 + COMPLETE)
    running = flight.record["laws.card"]
    for card in (DOUBLET, MULTISINE, SWEEP):
        rows = [row for row, slot in enumerate(running) if slot == card.slot]
        assert len(rows) == card.length
        for surface in cards.SURFACES:
            flown = inputs(flight, surface)[rows[0]:]
            wanted = card.words_added().get(surface)
            if wanted is None:
                assert not any(flown[:len(rows)])
                continue
            assert flown[:len(wanted)] == wanted.tolist()
            servo = flight.record[f"pwm.{surface}"][rows[0]:]
            assert servo[:len(wanted)] == [
                NEUTRAL + word for word in wanted.tolist()]
    for name in ("steering", "throttle", "brake", "left_flap_1"):
        assert len(set(flight.record[f"pwm.{name}"][250:])) == 1


def test_fti3_d100_an_input_to_the_sticks_moves_what_they_move(tmp_path):
    """Both sides and the steering, by the words of a scan and the input."""
    flight = fly_cards(tmp_path / "f", (STICK,), switched(STARTS_MS),
                       "--seconds", "8")
    assert event(flight, "card_ended") == (1, 16 + COMPLETE)
    first = flight.record["laws.card"].index(1)
    assert flight.record["laws.card_place"][first] == 1
    for stick, servos in (
            ("roll", ("left_aileron", "right_aileron")),
            ("pitch", ("left_elevator", "right_elevator")),
            ("yaw", ("left_rudder", "right_rudder", "steering"))):
        wanted = [NEUTRAL + word for word in STICK.words_added()[stick]]
        for servo in servos:
            assert flight.record[f"pwm.{servo}"][
                first:first + len(wanted)] == wanted, servo
    for name in ("throttle", "brake", "left_flap_1"):
        assert len(set(flight.record[f"pwm.{name}"][250:])) == 1
    # The pilot's sticks are the pilot's.
    assert set(flight.record["mcs.uplink.roll"][first:]) == {NEUTRAL}


def test_fti3_d100_a_step_of_the_bank_command_is_flown(tmp_path):
    rest = {"names": "switch5,switch2", "rest": f",{ON}"}
    flight = fly_cards(
        tmp_path / "f", (BANK,), switched(STARTS_MS, **rest), "--seconds",
        "9")
    still = fly_cards(
        tmp_path / "g", (BANK,), switched(10_000_000, **rest), "--seconds",
        "9")
    assert event(flight, "card_ended") == (1, 16 + COMPLETE)
    first = flight.record["laws.card"].index(1)
    ailerons, before = (each.record["pwm.left_aileron"]
                        for each in (flight, still))
    assert ailerons[:first] == before[:first]
    # On the bench the bank never comes: the law asks for right aileron.
    assert max(ailerons[first:first + 100]) > max(before) + 150
    assert ailerons[-1] < max(ailerons[first:first + 100]) - 150
    assert flight.record["pwm.left_elevator"] == still.record[
        "pwm.left_elevator"]


def test_fti3_d100_steps_of_altitude_and_airspeed_are_flown(tmp_path):
    rest = {"names": "switch5,switch3", "rest": f",{ON}"}
    flights_of = {
        when: fly_cards(
            tmp_path / str(when), (SPEED,), switched(when, **rest),
            "--seconds", "9", sensors="time_ms,airspeed,altitude\n"
            "0,2240,2000\n") for when in (STARTS_MS, 10_000_000)}
    flight, still = flights_of.values()
    assert event(flight, "card_ended") == (1, 16 + COMPLETE)
    last = flight.record["laws.card"].index(1) + SPEED.length
    for servo in ("left_elevator", "throttle"):
        assert flight.record[f"pwm.{servo}"][last] > still.record[
            f"pwm.{servo}"][last], servo


@pytest.mark.parametrize("card, names, before, after", [
    (BANK, "switch5,switch2", ON, OFF),
    (STICK, "switch5,switch4", OFF, ON)])
def test_fti5_d100_a_card_ends_when_nothing_follows_it(
        tmp_path, card, names, before, after):
    flight = fly_cards(
        tmp_path / "f", (card,),
        switched(STARTS_MS, names=names, rest=f",{before}")
        + f"5000,2048,{ON},{after}\n", "--seconds", "7")
    assert event(flight, "card_ended") == (1, 16 + NOT_FOLLOWED)
    running = flight.record["laws.card"]
    first, last = running.index(1), len(running) - 1 - running[::-1].index(1)
    assert flight.record["time_ms"][last] <= 5_200
    assert not any(inputs(flight, "left_aileron")[last + 12:])
    # It does not start either.
    flight = fly_cards(
        tmp_path / "g", (card,),
        switched(STARTS_MS, names=names, rest=f",{after}"), "--seconds", "7")
    assert event(flight, "card_ended") == (1, 16 + NOT_FOLLOWED)
    assert not any(flight.record["laws.card"])


def test_fti5_d100_a_stick_against_its_own_input_ends_the_card(tmp_path):
    """The pilot's stick counts, not the sum."""
    flight = fly_cards(
        tmp_path / "f", (cards.Card(**{**STICK.__dict__, "amplitude": 250}),),
        switched(STARTS_MS, names="switch5,roll", rest=",2048")
        + f"4500,2048,{ON},1840\n", "--seconds", "7")
    assert event(flight, "card_ended") == (1, 16 + STICK_MOVED)


def test_fti7_identify_finds_the_cards_of_a_flight(tmp_path):
    """The finder sees switch 5 and the surfaces, as the ground's record."""
    fly_cards(tmp_path / "f", (DOUBLET, MULTISINE),
              switched(4_000, 7_000, 12_000, 19_000), "--seconds", "25")
    flight = flights.read(tmp_path / "f" / "record.csv", lambda _: None)
    found = manoeuvres.found(flight)
    assert [each.mark for each in found] == ["card"] * 2
    assert [each.axes for each in found] == [
        ("longitudinal",), ("longitudinal", "lateral")]
    assert 3.4 < found[0].begin < 3.7 and 9.5 < found[0].end < 10.8
    assert 11.4 < found[1].begin < 11.7 and 20 < found[1].end < 22


def test_fti2_each_card_is_read_back_word_for_word(tmp_path):
    flight = fly_cards(
        tmp_path / "f", (DOUBLET, MULTISINE, SWEEP), switched(10_000_000),
        "--seconds", "40")
    columns = [flight.record[f"laws.told_card.{place}"]
               for place in range(2, 8)]
    told = {}
    for _, where, *words in set(zip(*columns, strict=True)):
        if where:
            told[where] = words
    for card in (DOUBLET, MULTISINE, SWEEP):
        found = [word for part in range(3)
                 for word in told[card.slot * 16 + part]]
        assert found == [*card.words()[:11], 0]
    assert flight.record["laws.told_card"][-1] == 1


@pytest.mark.parametrize("change, reason", [
    ({"sticks": switched(4_000, 5_000)}, SWITCHED_OFF),
    ({"sticks": switched(4_000, names="switch5,switch7", rest=",0")
      + "5000,2048,4095,4095\n"}, DISCONNECTED),
    ({"sticks": switched(4_000, names="switch5,pitch", rest=",2048")
      + "5000,2048,4095,2300\n"}, STICK_MOVED),
    ({"faults": "5000 cut 3000\n"}, LINK_LOST),
    ({"faults": "5000 mcs reset warm\n"}, RESTARTED),
    ({"faults": "5000 surface left_elevator stuck 0x5dc\n"}, SURFACE_FAILED),
    ({"sensors": "time_ms,alpha\n0,2048\n5000,4095\n"}, SENSOR_INVALID),
    ({"sensors": "time_ms,airspeed\n0,2100\n5000,1750\n"}, ENVELOPE_LEFT),
    ({"sensors": "time_ms,altitude\n0,1000\n5000,900\n5100,790\n"}, ENVELOPE_LEFT),
    ({"sensors": "time_ms,roll_attitude\n0,2048\n5000,2100\n5020,2160\n"
      "5040,2220\n5060,2280\n5080,2340\n5100,2400\n"}, ENVELOPE_LEFT),
])
def test_fti5_a_card_ends_by(tmp_path, change, reason):
    card = cards.Card(**{**DOUBLET.__dict__, "time": 400})
    sticks = change.pop("sticks", switched(STARTS_MS))
    flight = fly_cards(tmp_path / "f", (card,), sticks, "--seconds", "8",
                       **change)
    if reason != RESTARTED:
        assert event(flight, "card_ended") == (1, 16 + reason)
    running = flight.record["laws.card"]
    assert flight.record["laws.card_ended"][-1] == reason
    first, last = running.index(1), len(running) - 1 - running[::-1].index(1)
    assert set(running[first:last + 1]) == {1}
    times = flight.record["time_ms"]
    assert 4_000 <= times[first] <= 4_100
    assert 4_980 <= times[last] <= 5_000 + (
        620 if reason in (LINK_LOST, SURFACE_FAILED) else 200)
    assert not any(inputs(flight, "left_elevator")[last + 12:])


def test_fti5_d86_a_short_gap_of_the_link_ends_no_card(tmp_path):
    flight = fly_cards(
        tmp_path / "f", (DOUBLET,), switched(STARTS_MS), "--seconds", "8",
        faults="4500 cut 300\n")
    assert event(flight, "card_ended") == (1, 16 + COMPLETE)
    first = flight.record["laws.card"].index(1)
    wanted = DOUBLET.words_added()["left_elevator"].tolist()
    assert [word - NEUTRAL for word in flight.record[
        "pwm.left_elevator"][first:first + len(wanted)]] == wanted


def test_fti1_a_wrong_card_is_refused_and_changes_nothing(tmp_path):
    words = list(DOUBLET.words())
    words[2] += 1
    text = " ".join(map(str, words))
    flight = fly_cards(
        tmp_path / "f", (), switched(STARTS_MS), "--seconds", "6",
        orders=f"2000 block 500 {text}\n")
    assert event(flight, "card_refused") == (1, 1)
    assert event(flight, "card_ended") is None
    assert not any(flight.record["laws.card"])


def test_fti4_a_switch_that_was_left_on_starts_nothing(tmp_path):
    flight = fly_cards(tmp_path / "f", (DOUBLET,), switched(0),
                       "--seconds", "6")
    assert event(flight, "card_refused") == (1, 3)
    assert not any(flight.record["laws.card"])


@pytest.mark.skipif(not has_jsbsim(), reason="make fly installs JSBSim")
def test_fti7_d97_a_programme_runs_each_card_once_in_flight(tmp_path):
    """Trimmed, card, recovery, next; each is a manoeuvre for identify."""
    deck = [cards.Card(**{**DOUBLET.__dict__, "time": 50}),
            cards.Card(**{**MULTISINE.__dict__, "amplitude": 100}),
            cards.Card(**{**STICK.__dict__, "slot": 3, "time": 50}),
            cards.Card(**{**BANK.__dict__, "slot": 4})]
    made = card_programme.of(deck)
    for name, text in (("sticks", made.sticks), ("orders", made.orders)):
        (tmp_path / name).write_text(text, encoding="ascii")
    flight = fly_in(tmp_path, "--plant", "jsbsim", "--sticks", "sticks",
                    "--orders", "orders", "--seconds", made.seconds)
    assert event(flight, "card_refused") is None
    assert event(flight, "card_ended") == (4, 4 * 16 + COMPLETE)
    found = manoeuvres.found(
        flights.read(tmp_path / "record.csv", lambda _: None))
    assert [each.mark for each in found] == ["card"] * 4
    assert found[3].axes[-1] == "lateral"
    # It has recovered.
    altitude = flight.record["mcs.downlink.altitude"]
    assert abs(altitude[-1] - altitude[250]) < 2 * 60
    assert abs(flight.record["mcs.downlink.roll_attitude"][-1] - NEUTRAL) < 60


FLIGHTS = 60
SPAN = 10


@pytest.mark.parametrize("first", range(0, FLIGHTS, SPAN))
def test_fti5_fti6_random_cards_with_random_faults(tmp_path, first):
    """The first flights of those of evidence/safety/card_flights.py."""
    runs = 0
    for number in range(first, first + SPAN):
        flight = card_flights.of_number(number)
        folder = tmp_path / str(number)
        folder.mkdir()
        done = card_flights.fly(flight, folder)
        assert done.returncode == 0, done.stderr
        outcome = card_flights.judged(flight, folder)
        assert outcome.findings == [], number
        runs += outcome.runs
    assert runs


def test_fti1_the_checks_know_valid_cards():
    """As the aircraft does: docs/design.md."""
    for card in (DOUBLET, MULTISINE, SWEEP):
        assert card_flights.is_valid(card.words())
        assert not card_flights.is_valid((*card.words()[:11], 0))
    for change in ({"amplitude": 801}, {"time": 1}, {"surfaces": ()},
                   {"slot": 9}, {"bank": 0}, {"slowest": 3_300}):
        wrong = cards.Card(**{**DOUBLET.__dict__, **change})
        assert not card_flights.is_valid(wrong.words()), change
    for card in (STICK, BANK, SPEED):
        words = list(card.words())
        assert card_flights.is_valid(words)
        # The bit of a right surface, which no stick or command has.
        words[1] |= 0b000010
        words[11] = card_flights.sum_of(words)
        assert not card_flights.is_valid(words)
