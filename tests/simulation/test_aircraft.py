# SPDX-License-Identifier: Apache-2.0
"""SIM-3: what sim/jsbsim/plant.py measures and says. Its readings are compared
with each other and with what a textbook makes of them, and with the true
state; no bit of the flight software is in between."""

import math
import socket
import struct
import sys
import threading
from types import SimpleNamespace

import pytest
from conftest import FRAME_US, NUMBERS, ROOT, TICK_US

sys.path[:0] = [str(ROOT / "sim" / "jsbsim")]

import flight_numbers  # noqa: E402
import plant  # noqa: E402

pytest.importorskip("jsbsim", reason="make fly installs JSBSim")

FRAME_S = FRAME_US / 1e6
STEP_S = 0.004
TIMES = plant.Times(
    tick=TICK_US, frame=NUMBERS.frame_ticks,
    scan=NUMBERS.frame_ticks - NUMBERS.servo_tick,
    shown=NUMBERS.frame_ticks)
TRUTH = {name: unit for name, (unit, *_) in plant.TRUTH.items()}
SENSORS = {name: unit for name, (unit, *_) in plant.SENSORS.items()}
SERVOS = {name: unit for name, (unit, *_) in plant.SERVOS.items()}


class Flown:
    """An aircraft, its commands by name, what it says by name."""

    def __init__(self):
        self.aircraft = plant.Aircraft(
            SERVOS.items(), SENSORS.items(), TRUTH.items(), (), TIMES)
        self.commands = dict.fromkeys(SERVOS, 0.0)
        self.commands["throttle"] = self.aircraft.fdm["servo/throttle-pct"]
        self.take(self.aircraft.last)

    def take(self, said):
        sensors, truth, _ = said
        self.sensors = dict(zip(SENSORS, sensors, strict=True))
        self.truth = dict(zip(TRUTH, truth, strict=True))

    def fly(self, frames=1, **commands):
        self.commands |= commands
        for _ in range(frames):
            self.take(self.aircraft.fly(list(self.commands.values())))
        return self


@pytest.fixture
def flown():
    return Flown()


def test_it_begins_settled(flown):
    truth = flown.truth
    assert truth["altitude"] == pytest.approx(1000, abs=1)
    assert truth["airspeed"] == pytest.approx(70, abs=0.1)
    assert truth["heading"] == pytest.approx(90, abs=0.1)
    for name in ("bank", "climb", "crashed"):
        assert truth[name] == pytest.approx(0, abs=0.1), name
    for name in ("roll_rate", "pitch_rate", "yaw_rate", "roll_attitude",
                 "beta", "lateral_acceleration"):
        assert flown.sensors[name] == pytest.approx(0, abs=0.1), name
    assert flown.sensors["vertical_acceleration"] == pytest.approx(
        1, abs=0.02)


def same(value):
    return pytest.approx(value, rel=1e-5, abs=1e-7)


def test_a_frame_is_20_ms_and_its_sensors_are_of_16(flown):
    """Beside another aircraft that is stepped by hand."""
    other = Flown()
    for name in ("left_aileron", "right_aileron"):
        node = other.aircraft.tree.get_node(plant.SERVOS[name][1])
        node.set_double_value(9)
    began = flown.aircraft.fdm.get_sim_time()
    for frame in range(1, 11):
        flown.fly(left_aileron=9, right_aileron=9)
        for place in range(1, round(FRAME_S / STEP_S) + 1):
            other.aircraft.fdm.run()
            bank = other.aircraft.fdm["attitude/phi-deg"]
            if place * STEP_S == pytest.approx(0.8 * FRAME_S):
                assert flown.sensors["roll_attitude"] == same(bank)
                assert flown.sensors["roll_rate"] == same(math.degrees(
                    other.aircraft.fdm["velocities/p-rad_sec"]))
        assert flown.truth["bank"] == same(bank)
        assert flown.aircraft.fdm.get_sim_time() - began == pytest.approx(
            FRAME_S * frame, abs=1e-6)


@pytest.mark.parametrize("tick, frame, scan, step", [
    (2000, 10, 8, 2), (1000, 10, 8, 2), (1000, 20, 16, 4), (5000, 4, 3, 1)])
def test_a_step_ends_with_the_frame_and_the_scan_and_is_at_most_4_ms(
        tick, frame, scan, step):
    assert plant.Times(tick, frame, scan, frame).step == step


def flown_in_steps(step_us, monkeypatch):
    """The sensors in each frame of 4 s in which pairs of servos move at once,
    in steps of this length. A tick of 500 us has room for all of them."""
    monkeypatch.setattr(plant, "LONGEST_STEP_US", step_us)
    frame = FRAME_US // 500
    aircraft = plant.Aircraft(
        SERVOS.items(), SENSORS.items(), (), (),
        plant.Times(tick=500, frame=frame, scan=frame, shown=frame))
    rest = dict.fromkeys(SERVOS, 0.0) | {"throttle": 50.0}
    rows = []
    for moved, degrees in (("aileron", 6.0), ("elevator", 3.0),
                           ("rudder", 5.0), ("flap_1", 5.0), ("", 0.0)):
        names = [name for name in SERVOS if moved and moved in name]
        for size, frames in ((degrees, 8), (-degrees, 8), (0.0, 24)):
            commands = rest | {name: size for name in names}
            rows += [dict(zip(SENSORS, aircraft.fly(
                list(commands.values()))[0])) for _ in range(frames)]
    return rows


def test_where_it_is_stays_within_a_bit_of_what_half_the_step_gives(
        monkeypatch):
    longest = plant.LONGEST_STEP_US
    whole, half = (flown_in_steps(step, monkeypatch)
                   for step in (longest, longest // 2))
    bits = {item["name"]: float(item["per_word"])
            for item in flight_numbers.ITEMS
            if item["buffer"] == "downlink" and item["unit"]}

    def apart(name):
        return max(abs(row[name] - other[name])
                   for row, other in zip(whole, half)) / bits[name]

    for name in ("roll_attitude", "pitch_attitude", "airspeed", "altitude"):
        assert apart(name) < 1, name
    # The servos answer a millisecond later; 6 degrees are 300 bits.
    assert 3 < apart("left_aileron") < 30


def test_what_is_shown_may_be_of_a_moment_within_a_step():
    """Half way between what is shown of the steps around it."""
    said = []
    for shown in (6, 7, 8):
        aircraft = plant.Aircraft(
            SERVOS.items(), (), (), [("bank", "deg"), ("heading", "deg")],
            TIMES._replace(shown=shown))
        commands = {**dict.fromkeys(SERVOS, 0.0), "throttle": 50.0,
                    "left_aileron": 20.0, "right_aileron": 20.0}
        said.append([aircraft.fly(list(commands.values()))[2]
                     for _ in range(100)])
    for before, between, after in zip(*said):
        assert between == pytest.approx(
            [(one + other) / 2 for one, other in zip(before, after)])
    assert said[0][-1][0] > said[0][0][0] + 20


@pytest.mark.parametrize("first, last, between", [
    (359.0, 1.0, 0.0), (1.0, 358.0, 359.5), (90.0, 91.0, 90.5)])
def test_a_heading_goes_the_short_way_round(first, last, between):
    aircraft = object.__new__(plant.Aircraft)
    aircraft.headings = [0]
    assert aircraft.between([first], [last], 0.5) == [
        pytest.approx(between)]


def test_sensors_say_what_is_so(flown):
    """In a turn with everything moving, half a second after half a second."""
    flown.fly(20, left_aileron=6, right_aileron=6, left_elevator=2,
              right_elevator=2, left_rudder=3, right_rudder=3)
    for _ in range(10):
        before, was = dict(flown.sensors), dict(flown.truth)
        flown.fly()
        now, truth = flown.sensors, flown.truth
        for sensor, true in (("roll_attitude", "bank"),
                             ("pitch_attitude", "pitch"),
                             ("airspeed", "airspeed"),
                             ("altitude", "altitude")):
            # Between the frame's beginning and its end, nearer to the end.
            span = truth[true] - was[true]
            assert now[sensor] == pytest.approx(
                was[true] + 0.8 * span, abs=0.05 * abs(span) + 1e-4), sensor
        bank, pitch = (math.radians(now[f"{each}_attitude"])
                       for each in ("roll", "pitch"))
        p, q, r = (now[f"{each}_rate"] for each in ("roll", "pitch", "yaw"))
        # Euler's angles, from the rates.
        rolled = (now["roll_attitude"] - before["roll_attitude"]) / FRAME_S
        assert rolled == pytest.approx(
            p + math.tan(pitch) * (q * math.sin(bank) + r * math.cos(bank)),
            abs=0.5)
        pitched = (now["pitch_attitude"] - before["pitch_attitude"]) / FRAME_S
        assert pitched == pytest.approx(
            q * math.cos(bank) - r * math.sin(bank), abs=0.5)
        turned = (truth["heading"] - was["heading"]) / FRAME_S
        assert turned == pytest.approx(
            (q * math.sin(bank) + r * math.cos(bank)) / math.cos(pitch),
            abs=0.5)
        assert truth["climb"] == pytest.approx(
            (truth["altitude"] - was["altitude"]) / FRAME_S, abs=0.1)
        # The path is alpha below the nose, and beta to its side.
        alpha, beta = (math.radians(now[each]) for each in ("alpha", "beta"))
        path = (math.cos(alpha) * math.cos(beta) * math.sin(pitch)
                - math.sin(beta) * math.sin(bank) * math.cos(pitch)
                - math.sin(alpha) * math.cos(beta) * math.cos(bank)
                * math.cos(pitch))
        knot = 1.68781 * math.sqrt(1.05)    # True airspeed at 1800 ft.
        assert truth["climb"] == pytest.approx(
            truth["airspeed"] * knot * path, abs=0.6)
        assert now["altitude_offset"] == plant.FIELD_FT
    assert abs(flown.truth["bank"]) > 10


SURFACES = [name for name in SENSORS if name.endswith(
    ("aileron", "elevator", "rudder", "flap_1", "flap_2"))]


# The stops of each kind, in degrees.
ENDS = {"aileron": (-20, 20), "elevator": (-25, 25), "rudder": (-25, 25),
        "flap_1": (0, 15), "flap_2": (0, 15)}


@pytest.mark.parametrize("kind", ENDS)
def test_each_servo_moves_its_surface_alone_and_as_fast_as_it_can(
        flown, kind):
    # A lag of 0.1 s; flaps take three seconds for 15 degrees.
    flown.fly(20)
    for surface in [name for name in SURFACES if name.endswith(kind)]:
        others = {name: flown.sensors[name] for name in SURFACES
                  if name != surface}
        before = flown.sensors[surface]
        for frames in range(1, 31):
            flown.fly(**{surface: 3})
            passed = frames * FRAME_S - 0.004
            now = flown.sensors[surface]
            if "flap" in kind:
                assert min(3, 5 * passed) - 0.6 <= now <= 5 * passed + 0.02
            else:
                # JSBSim's servos answer half a step later.
                lag = math.exp(-(passed - STEP_S / 2) / 0.1)
                assert now == pytest.approx(3 - (3 - before) * lag, abs=0.05)
        flown.fly(60)
        assert flown.sensors[surface] == pytest.approx(3, abs=0.01)
        for name, at in others.items():
            # From its settled position it goes to its command, 0.
            assert flown.sensors[name] == pytest.approx(at, abs=0.01), name
        flown.fly(90, **{surface: 0})
    least, most = ENDS[kind]
    for command, end in ((1.3 * most, most), (1.3 * least - 1, least)):
        flown.fly(250, **{surface: command})
        assert flown.sensors[surface] == pytest.approx(end, abs=0.01)


def test_the_throttle_moves_the_engine_and_the_alternator_charges(flown):
    rpm, speed = flown.sensors["rpm"], flown.truth["airspeed"]
    flown.fly(150, throttle=100)
    assert flown.sensors["rpm"] > rpm + 200
    assert flown.truth["airspeed"] > speed + 3
    assert flown.sensors["alternator_volts"] == pytest.approx(28, abs=0.5)
    assert flown.sensors["battery_volts"] == pytest.approx(27.6, abs=0.5)


def dbm(distance_ft):
    """1 W at 450 MHz through free space: Friis' formula."""
    wavelength = 299_792_458 / 450e6
    loss = 4 * math.pi * distance_ft * 0.3048 / wavelength
    return 30 - 20 * math.log10(loss)


def test_the_signal_is_that_of_free_space(flown):
    assert flown.sensors["uplink_signal_strength"] == pytest.approx(
        dbm(1000), abs=0.02)
    ground = 0.0
    for _ in range(1500):
        flown.fly()
        ground += (flown.truth["airspeed"] * 1.68781 * math.sqrt(1.054)
                   * FRAME_S)
    assert ground > 3_000
    assert flown.sensors["uplink_signal_strength"] == pytest.approx(
        dbm(math.hypot(ground, flown.truth["altitude"])), abs=0.1)


def test_the_signal_is_that_of_the_way_from_the_station(flown):
    """North, too: a flight straight on does not show it."""
    aircraft = flown.aircraft
    place = SimpleNamespace(get_double_value=lambda: 5_000.0)
    aircraft.north = aircraft.east = aircraft.altitude = place
    for station, way in (((2_000.0, 5_000.0), (3_000, 0, 5_000)),
                         ((5_000.0, 1_000.0), (0, 4_000, 5_000))):
        aircraft.station = station
        aircraft.measure_signal()
        assert aircraft.signal.get_double_value() == pytest.approx(
            dbm(math.hypot(*way)), abs=0.02)


@pytest.mark.parametrize("altitude, bank, crashed", [
    (0.7, 0, True), (0.8, 0, True), (0.9, 0, False), (1.6, 0, False),
    # The other side ends the flight.
    (float("nan"), 0, False),
    # A wing tip is 7 ft from the middle.
    (3.4, 30, True), (3.6, 30, False), (3.4, -30, True), (3.6, -30, False),
    (6.9, 90, True), (7.1, 90, False), (6.8, 179, False), (1.2, 9, False),
    (1.2, 11, True), (1.2, -11, True), (1000, 60, False)])
def test_it_has_crashed_when_belly_or_wing_tip_touch(
        altitude, bank, crashed):
    class Node:
        def __init__(self, value):
            self.value = value

        def get_double_value(self):
            return self.value

    aircraft = object.__new__(plant.Aircraft)
    aircraft.altitude, aircraft.bank = Node(altitude), Node(bank)
    aircraft.half_span = plant.HALF_SPAN_FT
    assert aircraft.has_crashed() == crashed


def test_after_a_crash_nothing_changes_any_more(flown):
    flown.commands |= {"throttle": 100, "left_elevator": -10,
                       "right_elevator": -10}
    for _ in range(3000):
        last = dict(flown.truth)
        sensors = dict(flown.sensors)
        flown.fly()
        if flown.truth["crashed"]:
            break
    assert flown.truth == {**last, "crashed": 1.0}
    assert flown.sensors == sensors
    # It was about to touch.
    assert -10 < last["altitude"] + last["climb"] * FRAME_S < 8
    final = dict(flown.truth)
    flown.fly(50, throttle=0, left_elevator=10, right_elevator=10)
    assert (flown.truth, flown.sensors) == (final, sensors)


def test_level_flight_does_not_crash(flown):
    flown.fly(500)
    assert flown.truth["crashed"] == 0
    assert flown.truth["altitude"] == pytest.approx(1000, abs=15)


# --- the connection ----------------------------------------------------------

def serve(introduction, *messages):
    """The answer of plant.py to data from its socket."""
    ours, theirs = socket.socketpair()
    ours.settimeout(60)
    serving = threading.Thread(target=plant.serve, args=(theirs,))
    serving.start()
    ours.sendall(introduction)
    answer = b""
    for message in messages:
        # It answers before it is asked again. A message may come in parts.
        answer += ours.recv(65536)
        ours.sendall(message[:5])
        ours.sendall(message[5:])
    ours.shutdown(socket.SHUT_WR)
    serving.join(60)
    assert not serving.is_alive()
    theirs.close()
    while more := ours.recv(65536):
        answer += more
    ours.close()
    return answer


ITEMS = (b"servo,throttle,%\nservo,left_aileron,deg\nsensor,rpm,rev/min\n"
         b"truth,altitude,ft\ntruth,crashed,yes\n"
         b"time,tick,2000 us\ntime,frame,10 ticks\n"
         b"time,scan,8 ticks\ntime,shown,5 ticks\n")


def test_it_answers_each_frame_with_what_was_asked_for():
    frame = struct.pack(">2d", 40.0, 1.0)
    answer = serve(ITEMS + b"\n", frame, frame)
    assert answer.startswith(b"ready\n")
    states = list(struct.iter_unpack(">3d", answer[6:]))
    assert len(states) == 3
    for rpm, altitude, crashed in states:
        assert 1_000 < rpm < 10_000
        assert altitude == pytest.approx(1000, abs=1)
        assert crashed == 0


@pytest.mark.parametrize("item, answer", [
    (b"servo,hook,deg\n", b"the plant has no hook\n"),
    (b"sensor,rpm,Hz\n", b"the plant has rpm in rev/min, not in Hz\n"),
    (b"truth,rpm,rev/min\n", b"the plant has no rpm\n"),
    (None, b"the connection ended before the flight began\n"),
])
def test_what_it_does_not_have_it_refuses(item, answer):
    assert serve(ITEMS + item + b"\n" if item else ITEMS) == answer
