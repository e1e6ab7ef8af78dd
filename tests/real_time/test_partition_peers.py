"""LNK-2: the partitions beside another implementation of the other end."""

from conftest import (
    COMMANDS, SENSORS, SERVOS, different_rows, free_ports, in_turn, script,
    script_seconds, udp,
)
from peer import AircraftPeer, GroundPeer


def follows(sequence, expected):
    """The expected words come one after another in the sequence."""
    rest = iter(in_turn(sequence))
    return all(words in rest for words in expected)


def test_lnk2_the_aircraft_answers_another_ground(start, write):
    sent = different_rows(20, len(COMMANDS), 3)
    measured = different_rows(16, len(SENSORS), 4)
    sensors = write("sensors.csv", script(SENSORS, measured))
    own, other = free_ports(2)
    run = start(
        "mcs", udp(own, other), "--sensors", sensors,
        "--seconds", script_seconds(measured),
    )
    # Each block several times: a frame of the aircraft may be late.
    blocks = [(*row, 0) for row in sent for _ in range(5)]
    with GroundPeer(other, own, blocks) as ground:
        mcs = run.end()

    uplinks = mcs.words("mcs.uplink", COMMANDS)
    assert follows(uplinks, sent[2:])
    downlinks = [words[:-1] for words in ground.received]
    assert follows(downlinks, measured[1:-1])
    assert ground.answered > 50
    assert ground.bad == 0
    pwm = in_turn(mcs.words("pwm", SERVOS))
    assert [words[7] for words in pwm][-1] == sent[-1][3]


def test_lnk2_the_ground_commands_another_aircraft(start, write):
    moved = different_rows(16, len(COMMANDS), 5)
    measured = different_rows(20, len(SENSORS), 6)
    sticks = write("sticks.csv", script(COMMANDS, moved))
    own, other = free_ports(2)
    blocks = [(*row, 0) for row in measured for _ in range(5)]
    with AircraftPeer(other, own, blocks) as aircraft:
        gsc = start(
            "gsc", udp(own, other), "--sticks", sticks,
            "--seconds", script_seconds(moved),
        ).end()

    assert follows(gsc.words("gsc.downlink", SENSORS), measured[:-1])
    uplinks = [words[:-1] for words in aircraft.received]
    assert follows(uplinks, moved[1:-1])
    assert aircraft.answered > 50
    assert aircraft.bad == 0


def test_lnk9_a_node_alone_waits_and_is_there_when_the_other_comes(start):
    own, other = free_ports(2)
    run = start("gsc", udp(own, other))
    words = tuple(range(100, 127)) + (0,)
    with AircraftPeer(other, own) as deaf:
        # Nobody answers: it has no words to send and hears nothing.
        deaf.words = [words]
        while len(deaf.received) < 20:
            deaf._ended.wait(0.01)
    gsc = run.stop()
    assert gsc.words("gsc.downlink", SENSORS)[-1] == words[:-1]
