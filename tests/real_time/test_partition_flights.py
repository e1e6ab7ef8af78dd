"""RTP-1, D-9: both partitions fly together, and do what the simulation does."""

from conftest import (
    COMMANDS, SENSORS, SERVOS, different_rows, in_turn, script,
    script_seconds,
)

STICKS = different_rows(24, len(COMMANDS), 1)
MEASURED = different_rows(24, len(SENSORS), 2)


def fly_scripts(start_both, write, links=None):
    sticks = write("sticks.csv", script(COMMANDS, STICKS))
    sensors = write("sensors.csv", script(SENSORS, MEASURED))
    seconds = script_seconds(STICKS)
    runs = start_both(
        links,
        mcs=("--seconds", seconds, "--sensors", sensors),
        gsc=("--seconds", seconds, "--sticks", sticks),
    )
    mcs, gsc = (run.end() for run in runs)
    return mcs, gsc, ("--seconds", seconds, "--sticks", sticks,
                      "--sensors", sensors)


def assert_same_contents(mcs, gsc, simulated):
    for node, group, names in (
        (gsc, "console", COMMANDS),
        (gsc, "gsc.uplink", COMMANDS),
        (mcs, "mcs.uplink", COMMANDS),
        (mcs, "pwm", SERVOS),
        (mcs, "mcs.downlink", SENSORS),
        (gsc, "gsc.downlink", SENSORS),
    ):
        flown = in_turn(node.words(group, names))
        expected = in_turn(simulated.words(group, names))

        # What the first and last frames show hangs on when the nodes began.
        middle = expected[3:-1]
        assert len(middle) >= 20
        assert flown[flown.index(middle[0]):][:len(middle)] == middle, group


def test_lnk1_a_flight_over_udp_has_the_contents_of_the_simulations(
    start_both, write, simulate
):
    mcs, gsc, options = fly_scripts(start_both, write)
    assert_same_contents(mcs, gsc, simulate(*options))


def test_lnk1_a_flight_over_a_serial_line_has_them_too(
    start_both, write, simulate, terminals
):
    links = [f"serial:{device}" for device in terminals.devices]
    mcs, gsc, options = fly_scripts(start_both, write, links)
    assert_same_contents(mcs, gsc, simulate(*options))


def test_rtp1_a_node_without_a_script_moves_its_surfaces(start_both, write):
    """The bench: surfaces follow the servos."""
    sticks = write("sticks.csv", "time_ms,roll\n300,4000\n")
    mcs, gsc = (
        run.end() for run in start_both(
            mcs=("--seconds", 2),
            gsc=("--seconds", 2, "--sticks", sticks),
        )
    )
    ailerons = [words for words, in gsc.words("gsc.downlink",
                                              ("left_aileron",))]
    assert ailerons[-1] > 3900
    assert sorted(ailerons[10:]) == ailerons[10:]


def test_frm1_each_frame_has_its_row(start_both):
    mcs, gsc = (
        run.end() for run in start_both(
            mcs=("--seconds", 1.5), gsc=("--seconds", 1.5)
        )
    )
    for node, name in ((mcs, "mcs"), (gsc, "gsc")):
        frames = [row["frame"] for row in node.rows]
        assert frames == sorted(set(frames))
        assert frames[-1] == 74
        assert all(
            row["time_ms"] == 20 * (row["frame"] + 1) for row in node.rows
        )
        assert node.summary["frames"] == 75
        assert node.summary["seconds"] == 1.5
        assert node.summary["rows_left_out"] == 0
        assert f"link.{name}_resets" in node.rows[0]
