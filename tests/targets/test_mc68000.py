# SPDX-License-Identifier: Apache-2.0
"""BRD-1 to BRD-4, BRD-8, BRD-10, SAF-11, TST-5: both nodes on the report's processor, on
an emulated board beside the simulation of the same flight."""

import subprocess

import pytest

import alignments
import bare
import emulated
import image_sum

MACHINE = emulated.MC68000_BOARD
pytestmark = bare.needs(MACHINE, MACHINE.archive)

BUS_ERROR, ADDRESS_ERROR, ILLEGAL, WATCHDOG = 2, 3, 4, 31
UNUSED_VECTOR = 200

# Interrupts are masked for fewer cycles.
LATEST = 4_000

# The bytes of any object, which are never copied as a whole.
ALLOWED = {"memory_operations.adb Bytes"}


@pytest.fixture(scope="module", autouse=True)
def built():
    """The board and both images."""
    for node in ("mcs", "gsc"):
        MACHINE.build(node)


@pytest.mark.parametrize("laws", [False, True], ids=["direct", "laws"])
def test_brd4_each_frame_has_the_words_of_the_simulation(tmp_path, laws):
    """The board traps words at odd addresses, and none comes."""
    bare.flies_like_the_simulation(MACHINE, tmp_path, laws)


def test_brd4_a_sealed_flight_has_the_words_of_the_simulation(tmp_path):
    bare.flies_like_the_simulation(MACHINE, tmp_path, laws=True, sealed=True)


@pytest.mark.parametrize(
    "mhz, laws, sealed", [(10, False, False), (16, True, False),
                          (16, True, True)], ids=["direct", "laws", "sealed"])
def test_brd4_tasks_are_late_no_interrupt_is_and_all_words_are_the_same(
        tmp_path, monkeypatch, mhz, laws, sealed):
    monkeypatch.setattr(MACHINE, "mhz", mhz)
    rows, runs = MACHINE.fly_both(tmp_path, bare.SECONDS, laws, sealed)
    assert list(emulated.differences(rows, runs)) == []
    frames = bare.SECONDS * emulated.FRAMES_PER_S
    for run in runs.values():
        assert sorted(run.rows)[:frames - 1] == list(range(frames - 1))
        assert run.numbers["bad"] == run.numbers["resets"] == 0
        assert run.numbers["late_clock_worst"] < LATEST
        assert run.numbers["late_converter_worst"] < LATEST
    assert runs["mcs"].numbers["overruns"] > 0


@pytest.mark.parametrize("events", [
    [(emulated.ILLEGAL_INSTRUCTION, ILLEGAL),
     (emulated.UNEXPECTED_INTERRUPT, UNUSED_VECTOR)],
    [(emulated.ODD_ADDRESS, ADDRESS_ERROR),
     (emulated.NO_DEVICE, BUS_ERROR)]],
    ids=["illegal instruction, unused interrupt", "odd address, no device"])
def test_brd2_d81_a_fault_of_the_processor_restarts_it(tmp_path, events):
    bare.restarts(MACHINE, tmp_path, events)


@pytest.mark.parametrize("event", [emulated.ENDLESS_LOOP, emulated.LOST_TIMER],
                         ids=["endless loop", "lost timer"])
def test_brd7_the_watchdog_restarts_a_processor_that_serves_no_ticks(
        tmp_path, event):
    tape = emulated.Tape(2)
    tape.plant(500, event)
    run = MACHINE.fly({"mcs": tape}, tmp_path)["mcs"]
    assert run.has(f"restarts count 1 reason {WATCHDOG}")
    assert run.text.count("MCS processor restart\n") == 1
    # Ticks are lost until the restart, 100 ms and a self-test later.
    assert 60 < len(run.rows) < 97
    assert sorted(run.rows) == list(range(len(run.rows)))
    assert all(run.pwm(frame) == bare.SAFE for frame in run.rows)
    last = max(run.rows)
    assert run.status(last)[:bare.SELF_TEST + 1] == [3, 1, 0, 1, 0]
    assert run.downlink(last)[-1] & 1 == 0


def test_brd7_a_node_that_serves_its_ticks_is_not_restarted(tmp_path):
    run = MACHINE.fly({"mcs": emulated.Tape(2)}, tmp_path)["mcs"]
    assert "restart" not in run.text


@pytest.mark.parametrize("place", ["program", "filling", -5, -1],
                         ids=["program", "filling", "one sum", "the other"])
def test_brd3_tst1_a_changed_bit_of_the_image_is_refused(tmp_path, place):
    bare.refuses_a_changed_bit(MACHINE, tmp_path, place)


def address(symbol):
    symbols = subprocess.run(
        [f"{MACHINE.prefix}nm", MACHINE.images / "mcs.elf"],
        check=True, capture_output=True, text=True).stdout
    return next(int(line.split()[0], 16) for line in symbols.splitlines()
                if line.endswith(f" {symbol}"))


@pytest.mark.parametrize("place", ["urv_data_start", "urv_bss_end",
                                   "urv_stack_top"])
def test_brd3_tst1_a_stuck_cell_of_the_variables_allows_no_start(
        tmp_path, place):
    """Found before the variables have their first values."""
    where = address(place) - (2 if place == "urv_stack_top" else 0)
    (tmp_path / "mcs.stuck").write_text(f"{where:x} 40")
    run = MACHINE.fly({"mcs": emulated.Tape(1)}, tmp_path)["mcs"]
    # Two words are tested together.
    assert run.has(f"no start: RAM is faulty, byte {where // 4 * 4}")
    assert "MCS" not in run.text


def test_brd3_tst1_a_stuck_cell_of_the_scratchpad_is_refused(tmp_path):
    (tmp_path / "mcs.stuck").write_text("110234 40")
    run = MACHINE.fly({"mcs": emulated.Tape(1)}, tmp_path)["mcs"]
    assert run.has("MCS refused") and not run.has("MCS started")
    last = max(run.rows)
    assert run.status(last)[bare.SELF_TEST] == bare.RAM_FAILED + (0x11A >> 4)
    assert run.pwm(last) == bare.SAFE


def test_saf11_a_refused_warm_reset_makes_the_servos_safe(tmp_path):
    """No task runs. The servos hold their words for 0.5 s; then the board's own
    ones reach them, with the brake as it was."""
    gsc, mcs = emulated.Tape(2), emulated.Tape(2, lag=emulated.LAG)
    gsc.read(0, [0x300] * emulated.CHANNELS)
    mcs.stick(900, 0x110234, 0x40, 0x40)
    mcs.plant(1000, emulated.RESET_SWITCH)
    run = MACHINE.fly({"gsc": gsc, "mcs": mcs}, tmp_path)["mcs"]
    assert run.has("MCS refused")
    flown = run.pwm(45)
    assert flown[:7] != bare.SAFE[:7]
    assert run.pwm(70) == flown
    brake = bare.SAFE.index(0xFFF)
    assert run.pwm(max(run.rows)) == (
        bare.SAFE[:brake] + flown[brake:brake + 1] + bare.SAFE[brake + 1:])


# The march in flight: a cell is a long word. It begins with the scratchpad.
RAM, SCRATCHPAD = 0x100000, 0x110000
SCRATCHPAD_CELLS, CELLS = 0x100, 0x4100
CELLS_PER_TICK = 2
CELLS_PER_BLOCK = 8
SELF_TEST_BIT = 4


def cell(where):
    """The number of the cell with this address."""
    return ((where - SCRATCHPAD) // 4 if where >= SCRATCHPAD
            else SCRATCHPAD_CELLS + (where - RAM) // 4)


def tick_of(number):
    """The tick in which the march comes to a cell, in the first pass."""
    return number // CELLS_PER_TICK + 1


def block_word(where):
    return bare.RAM_FAILED + cell(where) // CELLS_PER_BLOCK


def found_in(run, where):
    """The first row, in which the block of this address is reported."""
    return min((frame for frame in run.rows
                if run.status(frame)[bare.SELF_TEST] == block_word(where)),
               default=None)


def changed(good, planted):
    """The image with other machine code at one place."""
    program = (MACHINE.images / "mcs.raw").read_bytes()
    assert program.count(bytes.fromhex(good)) == 1
    return image_sum.image_of(
        program.replace(bytes.fromhex(good), bytes.fromhex(planted)),
        MACHINE.rom_size, "big")


def error_of_board(folder):
    return (folder / "board.err").read_text()


@pytest.mark.parametrize("value", [0, 1], ids=["at 0", "at 1"])
@pytest.mark.parametrize("byte", range(4))
def test_tst5_each_bit_of_a_cell_that_becomes_stuck_in_flight_is_found(
        tmp_path, byte, value):
    """One bit of the byte after the other, each in another cell, in the tick
    in which the march comes to it."""
    tape = emulated.Tape(0.3)
    places = {}
    for bit in range(8):
        tick = 20 + 10 * bit
        places[bit] = SCRATCHPAD + 4 * CELLS_PER_TICK * (tick + 5) + byte
        tape.stick(emulated.TICK_MS * tick, places[bit], 1 << bit,
                   value << bit)
    run = MACHINE.fly({"mcs": tape}, tmp_path)["mcs"]
    assert {bit: found_in(run, where) for bit, where in places.items()} == {
        bit: 2 + bit for bit in places}
    last = max(run.rows)
    assert run.downlink(last)[-1] & SELF_TEST_BIT
    assert run.numbers["overruns"] == 0
    assert error_of_board(tmp_path) == ""


def pairs_found(folder, images=None):
    """Pairs of bits of a cell, of which one begins to follow the other. The two
    bits of a pair differ in one background alone."""
    others = (1, 2, 4, 8, 16)
    pairs = [(0, other) for other in others] + [(other, 0) for other in others]
    tape = emulated.Tape(0.3)
    places = {}
    for number, pair in enumerate(pairs):
        tick = 20 + 10 * number
        places[pair] = SCRATCHPAD + 4 * CELLS_PER_TICK * (tick + 5)
        tape.couple(emulated.TICK_MS * tick, places[pair], *pair)
    run = MACHINE.fly({"mcs": tape}, folder, images)["mcs"]
    return {pair: found_in(run, where) == 2 + number
            for number, (pair, where) in enumerate(places.items())}


def test_tst5_a_bit_that_follows_another_one_of_its_cell_is_found(tmp_path):
    assert set(pairs_found(tmp_path).values()) == {True}


def test_tst5_each_background_is_needed(tmp_path):
    """Without 33333333h bits 0 and 2 are always alike."""
    image = tmp_path / "mcs.bin"
    image.write_bytes(changed("223c33333333", "223c55555555"))
    assert [pair for pair, is_found in pairs_found(
        tmp_path, {"mcs": image}).items() if not is_found] == [(0, 2), (2, 0)]


def test_tst5_a_stuck_cell_anywhere_in_ram_is_found(tmp_path):
    """Cells of a variable, of both ends of the stack, and the last one. A bit has the
    value that the program needs, or nobody reads it."""
    places = [
        (address("flight_ram_tests__progress"), 0x80, 0),
        (address("urv_stack_bottom"), 0x40, 0x40),
        (address("urv_stack_top") - 4, 0x80, 0),
        (SCRATCHPAD - 1, 1, 1)]
    tape = emulated.Tape((tick_of(CELLS) + 10) * emulated.TICK_MS / 1000)
    for where, bits, value in places:
        tape.stick(emulated.TICK_MS * (tick_of(cell(where)) - 5), where, bits,
                   value)
    run = MACHINE.fly({"mcs": tape}, tmp_path)["mcs"]
    assert {where: found_in(run, where) for where, _, _ in places} == {
        where: tick_of(cell(where)) // 10 for where, _, _ in places}
    assert run.numbers["overruns"] == 0
    assert sorted(run.rows) == list(range(len(run.rows)))
    assert error_of_board(tmp_path) == ""


def test_tst5_a_cell_that_the_march_has_just_left_is_found_in_a_pass(tmp_path):
    """The march begins again, 16.6 s later."""
    where = SCRATCHPAD + 0x20
    again = tick_of(CELLS + cell(where))
    tape = emulated.Tape((again + 20) * emulated.TICK_MS / 1000)
    tape.stick(emulated.TICK_MS * (tick_of(cell(where)) + 1), where, 1, 1)
    run = MACHINE.fly({"mcs": tape}, tmp_path)["mcs"]
    assert found_in(run, where) == again // 10
    assert again * emulated.TICK_MS < 16_700
    assert error_of_board(tmp_path) == ""


def test_tst5_a_restart_within_the_test_of_a_cell_keeps_its_contents(tmp_path):
    """The board compares. An interrupt waits for the end of the test."""
    bare.restarts(MACHINE, tmp_path,
                  [(emulated.ILLEGAL_IN_RAM_TEST, ILLEGAL),
                   (emulated.INTERRUPT_IN_RAM_TEST, UNUSED_VECTOR)])
    assert error_of_board(tmp_path) == ""


# Machine code of the march: the write that gives the contents back, and the
# comparison after it; the mask, and the first read; the write that gives the
# contents back at a start, and the reset of the kept address.
NOTHING = "4e71"
PLANTED = {
    "contents not given back":
        ("2082", "b490", "a test has changed the cell"),
    "not masked":
        ("46fc2700", "2410", "an interrupt while a cell is tested"),
    "not given back at a start":
        ("20ab0014", "42ab0010", "a test has changed the cell")}


@pytest.mark.parametrize("name", PLANTED)
def test_tst5_a_planted_fault_of_the_march_is_found(tmp_path, name):
    removed, after, error = PLANTED[name]
    image = tmp_path / "mcs.bin"
    image.write_bytes(changed(
        removed + after,
        NOTHING * (len(removed) // len(NOTHING)) + after))
    tape = emulated.Tape(1)
    tape.plant(200, emulated.INTERRUPT_IN_RAM_TEST if name == "not masked"
               else emulated.ILLEGAL_IN_RAM_TEST)
    MACHINE.fly({"mcs": tape}, tmp_path, {"mcs": image}, may_fail=True)
    assert error in error_of_board(tmp_path)


def test_tst5_the_march_delays_no_interrupt_of_a_flight(tmp_path):
    """Interrupts are masked for at most 3 us, once a cell, and the latest one
    does not come later than that."""
    run = MACHINE.fly({"mcs": emulated.Tape(1)}, tmp_path)["mcs"]
    limit = 3 * MACHINE.mhz
    assert 0 < run.numbers["ram_test_worst"] < limit
    assert run.numbers["late_clock_worst"] < limit
    assert run.numbers["late_converter_worst"] < LATEST


def test_brd4_errors_of_the_line_are_counted_and_spoil_a_block(tmp_path):
    """The line goes on after a wrong parity, a wrong frame and a character
    that came too soon."""
    gsc, mcs = emulated.Tape(2), emulated.Tape(2, lag=emulated.LAG)
    for number, event in enumerate((
            emulated.PARITY_ERROR, emulated.FRAMING_ERROR,
            emulated.LOST_CHARACTER)):
        mcs.plant(500 + 300 * number, emulated.ON_TELEMETRY_BOARD + event)
    runs = MACHINE.fly({"gsc": gsc, "mcs": mcs}, tmp_path)
    numbers = runs["mcs"].numbers
    assert [numbers[f"board_{name}"] for name in (
        "parity_errors", "framing_errors", "lost_characters")] == [1, 1, 1]
    # Each loses a block, and the boards begin again.
    lost = runs["gsc"].numbers["sent"] - numbers["received"]
    assert lost in (3, 4)
    assert [run.numbers["resets"] for run in runs.values()] == [3, 3]
    frame = max(runs["mcs"].rows)
    assert runs["mcs"].uplink(frame) == runs["gsc"].uplink(frame)
    assert runs["gsc"].numbers["board_parity_errors"] == 0


STICKS, SENSORS = 0x345, 0x456


def moved(seconds):
    """Tapes of both nodes whose words change 0.3 s before the end."""
    gsc, mcs = emulated.Tape(seconds), emulated.Tape(seconds, emulated.LAG)
    gsc.read(1000 * seconds - 300, [STICKS] * emulated.CHANNELS)
    mcs.read(1000 * seconds - 300, [SENSORS] * emulated.CHANNELS)
    return {"gsc": gsc, "mcs": mcs}


FAULTS = {
    "illegal instruction": (emulated.ILLEGAL_INSTRUCTION, ILLEGAL),
    "illegal instruction in an operation":
        (emulated.ILLEGAL_WITH_LOCK, ILLEGAL),
    "endless loop": (emulated.ENDLESS_LOOP, WATCHDOG),
    "endless loop in an operation": (emulated.LOOP_WITH_LOCK, WATCHDOG)}


@pytest.mark.parametrize("node", ["gsc", "mcs"])
@pytest.mark.parametrize("fault", FAULTS)
def test_brd8_d99_a_telemetry_board_restarts_alone(tmp_path, node, fault):
    """Blocks are lost. The controllers go on, and the link is back."""
    event, reason = FAULTS[fault]
    tapes = moved(2)
    tapes[node].plant(1000, emulated.ON_TELEMETRY_BOARD + event)
    runs = MACHINE.fly(tapes, tmp_path)
    assert runs[node].has(f"board restarts count 1 reason {reason}")
    assert "".join(run.text for run in runs.values()).count("restarts") == 1
    for run in runs.values():
        assert run.numbers["overruns"] == 0
        assert sorted(run.rows) == list(range(len(run.rows)))
        assert run.numbers["received"] >= 90
    link_is_up(runs)


@pytest.mark.parametrize("node", ["gsc", "mcs"])
@pytest.mark.parametrize("fault", FAULTS)
def test_brd8_a_controller_restarts_alone(tmp_path, node, fault):
    """Its telemetry board goes on."""
    event, reason = FAULTS[fault]
    tapes = moved(2)
    tapes[node].plant(1000, event)
    runs = MACHINE.fly(tapes, tmp_path)
    assert runs[node].has(f"restarts count 1 reason {reason}")
    assert "".join(run.text for run in runs.values()).count("restarts") == 1
    link_is_up(runs)


@pytest.mark.parametrize("node", ["gsc", "mcs"])
def test_brd8_a_controller_that_fails_in_its_first_start_has_a_link(
        tmp_path, node):
    """Before it has let its telemetry board use the memory of both."""
    tapes = moved(2)
    tapes[node].plant(0, emulated.ILLEGAL_IN_START)
    runs = MACHINE.fly(tapes, tmp_path)
    assert runs[node].has(f"restarts count 1 reason {ILLEGAL}")
    assert runs[node].has("board telemetry board cold start")
    link_is_up(runs)


def link_is_up(runs):
    """The last frames have the other node's latest words."""
    gsc, mcs = runs["gsc"], runs["mcs"]
    last_gsc, last_mcs = max(gsc.rows), max(mcs.rows)
    assert mcs.uplink(last_mcs)[0] == STICKS
    assert mcs.uplink(last_mcs) == gsc.uplink(last_gsc)
    assert gsc.downlink(last_gsc)[0] == SENSORS
    assert gsc.downlink(last_gsc)[:-1] == mcs.downlink(last_mcs)[:-1]


def test_brd8_no_processor_of_a_node_runs_ahead_of_the_other(
        tmp_path, monkeypatch):
    """While both work: by 64 cycles and an instruction at most, of which a
    division is the longest."""
    monkeypatch.setattr(MACHINE, "mhz", 100)
    _, runs = MACHINE.fly_both(tmp_path, 1, laws=False)
    for run in runs.values():
        for name in ("ahead_worst", "board_ahead_worst"):
            assert 0 < run.numbers[name] < 64 + 200


def board_place(name):
    """The address of a symbol of the telemetry board's program."""
    symbols = subprocess.run(
        [f"{MACHINE.prefix}nm", MACHINE.images / "telemetry_board.elf"],
        check=True, capture_output=True, text=True).stdout
    return next(int(line.split()[0], 16) for line in symbols.splitlines()
                if line.endswith(f" {name}"))


def the_link_is_down(runs, failed):
    """The failed board sends nothing, and is never started. Both controllers
    run, and have old data only: they see a lost link."""
    assert "board telemetry board cold start" not in runs[failed].text
    for node, run in runs.items():
        assert run.has(f"{node.upper()} started")
        assert sorted(run.rows) == list(range(len(run.rows)))
        assert run.numbers["overruns"] == run.numbers["received"] == 0
    last = max(runs["gsc"].rows)
    assert runs["gsc"].downlink(last)[-1] & bare.OLD
    assert runs["mcs"].uplink(max(runs["mcs"].rows))[-1] & bare.OLD


@pytest.mark.parametrize("node", ["gsc", "mcs"])
@pytest.mark.parametrize("place", [-1, 0x2_7000, "program"],
                         ids=["sum", "filling", "program"])
def test_brd10_a_changed_bit_of_a_telemetry_board_keeps_it_silent(
        tmp_path, node, place):
    image = bytearray((MACHINE.images / "telemetry_board.bin").read_bytes())
    # In the program, a bit of a text that the start does not need.
    if place == "program":
        place = image.index(b"framing_errors")
    image[place] ^= 0x10
    (tmp_path / "board.bin").write_bytes(image)
    tapes = {"gsc": emulated.Tape(1), "mcs": emulated.Tape(1, emulated.LAG)}
    runs = MACHINE.fly(tapes, tmp_path,
                       {f"{node}_board": tmp_path / "board.bin"})
    assert runs[node].has("board telemetry board refused, test 1")
    the_link_is_down(runs, node)


@pytest.mark.parametrize("place,line", [
    ("urv_data_start", "no start: RAM is faulty, byte {}"),
    ("urv_stack_bottom", "no start: RAM is faulty, byte {}"),
    ("urv_tested_ram", "telemetry board refused, test 2")])
def test_brd10_a_stuck_cell_of_a_telemetry_board_keeps_it_silent(
        tmp_path, place, line):
    where = board_place(place)
    (tmp_path / "gsc_board.stuck").write_text(f"{where:x} 40")
    tapes = {"gsc": emulated.Tape(1), "mcs": emulated.Tape(1, emulated.LAG)}
    runs = MACHINE.fly(tapes, tmp_path)
    assert runs["gsc"].has("board " + line.format(where))
    the_link_is_down(runs, "gsc")


def test_brd8_the_dual_ported_memory_at_power_up_is_random(tmp_path):
    """The emulator fills it, and the lock may be taken."""
    run = MACHINE.fly({"mcs": emulated.Tape(0.1)}, tmp_path)["mcs"]
    assert run.has("board telemetry board cold start")
    assert run.has("MCS started")


def test_d83_a_flight_is_the_same_on_every_run(tmp_path):
    texts = []
    for name in ("one", "other"):
        (tmp_path / name).mkdir()
        runs = MACHINE.fly({"gsc": emulated.Tape(1),
                            "mcs": emulated.Tape(1, lag=emulated.LAG)},
                           tmp_path / name)
        texts.append([run.text for run in runs.values()])
    assert texts[0] == texts[1]


def test_brd4_no_composite_type_may_be_at_an_odd_address():
    assert alignments.all_odd_types() == ALLOWED


def test_brd4_a_type_that_may_be_at_an_odd_address_is_found():
    assert alignments.odd_types(
        "for Pair'Size use 16;\nfor Pair'Alignment use 1;\n"
        "for Pair use record\n   A at 0 range 0 .. 7;\n"
        "for Flags'Size use 32;\nfor Flags'Alignment use 1;\n"
        "for Flags'Component_Size use 8;\n"
        "for Words'Size use 32;\nfor Words'Alignment use 2;\n"
        "for Words'Component_Size use 16;\n") == ["Flags", "Pair"]


# A program of a few instructions, with one vector for each exception that is
# named, and its data sheet's times.
HEAD = """
	.long	0x110000, begin
	.rept	254
	.long	handler
	.endr
"""

# The clock begins: the emulator reports the cycles until then.
START_CLOCK = """
	move.b	#0x60, 0xf00029
	move.b	#0, 0xf0002d
	move.b	#250, 0xf0002f
	tst.b	0xf0003d
	move.w	#1, 0xf3000e
	bra	.
"""

# The telemetry board ends after its controller.
END_WITH_CONTROLLER = HEAD + """
handler:
begin:	tst.l	0xf30008
	beq	begin
	move.w	#1, 0xf3000e
	bra	.
"""


def assembled(folder, name, text):
    source, linked = folder / f"{name}.s", folder / f"{name}.o"
    source.write_text(text)
    subprocess.run([f"{MACHINE.prefix}as", "-m68000",
                    "--register-prefix-optional", source, "-o", linked],
                   check=True)
    program = folder / f"{name}.elf"
    subprocess.run([f"{MACHINE.prefix}ld", "-Ttext", "0", "-e", "0", linked,
                    "-o", program], check=True)
    subprocess.run([f"{MACHINE.prefix}objcopy", "-O", "binary", "-j", ".text",
                    program, folder / f"{name}.bin"], check=True)
    return folder / f"{name}.bin"


def run_program(folder, text, head=HEAD):
    """The end of a controller with this program."""
    images = {"mcs": assembled(folder, "program", head + text),
              "mcs_board": assembled(folder, "board", END_WITH_CONTROLLER)}
    return MACHINE.fly({"mcs": emulated.Tape(1)}, folder, images)["mcs"]


# Sends a byte to the console. The program ends in the handler of any exception
# but a bus error.
PUT = """
	move.b	{byte}, 0xf00017
"""
END = """
handler:
	move.w	#1, 0xf3000e
	bra	.
"""
SENDER_ON = """
	move.b	#4, 0xf00015
"""


def test_brd4_the_console_is_silent_until_its_sender_is_on(tmp_path):
    run = run_program(tmp_path, f"""
begin:	{PUT.format(byte="#'A'")}
	btst	#2, 0xf00013
	bne	handler
	{SENDER_ON}
	{PUT.format(byte="#'B'")}
	btst	#2, 0xf00013
	beq	handler
	{PUT.format(byte="#'C'")}
	{END}""")
    assert run.text.startswith("BCcycles ")


@pytest.mark.parametrize("instruction, is_read, where", [
    ("move.b\t0x400000, d0", 1, 0x400000),
    ("move.l\td0, 0x12", 0, 0x12),
    ("move.w\t0x114040, d0", 1, 0x114040),
    ("move.w\td0, 0xf40002", 0, 0xF40002)],
    ids=["no device", "write to the ROM", "after the RAM", "after the watchdog"])
def test_brd2_brd4_where_nothing_answers_is_a_bus_error(
        tmp_path, instruction, is_read, where):
    """Vector 2. Seven words are stacked: the kind of access, the address, the
    instruction, the status and the program counter."""
    text = f"""
bus_error:
	lea	0x110000 - 14, a0
	cmp.l	a0, sp
	bne	handler
	move.w	(sp), d0
	and.w	#0x10, d0
	cmp.w	#{0x10 * is_read}, d0
	bne	handler
	cmp.l	#{where}, 2(sp)
	bne	handler
	move.w	fault, d0
	cmp.w	6(sp), d0
	bne	handler
	cmp.w	#0x2700, 8(sp)
	bne	handler
	{PUT.format(byte="#'Y'")}
	{END}
begin:	{SENDER_ON}
fault:	{instruction}
	bra	handler"""
    head = HEAD.replace("\t.rept\t254\n", "\t.long\tbus_error\n\t.rept\t253\n")
    assert head != HEAD
    assert run_program(tmp_path, text, head).text.startswith("Ycycles ")


def test_brd2_a_fault_while_an_exception_is_stacked_halts_the_processor(
        tmp_path):
    with pytest.raises(emulated.Failed, match="mcs: halted: a fault while an"
                       " exception is stacked, at 3ffffc, instruction at "):
        run_program(tmp_path, f"""
begin:	lea	0x400000, sp
	tst.b	0x400000
	{END}""")


@pytest.mark.parametrize("name, size, reason", [
    ("mcs.bin", MACHINE.rom_size + 1, "more than the 163840 bytes of the ROM"),
    ("mcs.tape", 23, "a tape without its end"),
    ("mcs.tape", 24 + 71, "a tape without its end")],
    ids=["ROM", "head of a tape", "entry of a tape"])
def test_brd4_a_file_of_another_size_ends_the_emulator_with_a_reason(
        tmp_path, name, size, reason):
    program = MACHINE.images / "telemetry_board.bin"
    for each, data in (("mcs.bin", program.read_bytes()),
                       ("mcs.tape", emulated.Tape(1).data())):
        (tmp_path / each).write_bytes(
            data if each != name else data.ljust(size, b"\0")[:size])
    done = subprocess.run(
        [MACHINE.images / "board", "250", tmp_path, "mcs",
         tmp_path / "mcs.bin", program, tmp_path / "mcs.tape"],
        capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 2
    assert done.stderr == f"board: {tmp_path / name}: {reason}\n"


def test_brd4_an_interrupt_takes_the_cycles_of_the_data_sheet(tmp_path):
    """44 for the interrupt of a device, with its vector, and 20 for RTE."""
    started = [run_program(tmp_path, f"""
handler:
	move.w	0xf10002, d1
	rte
begin:	move.w	#64, 0xf10004
	move.w	#{enabled}, 0xf10006
	move.w	#0x2000, sr
	move.w	#3, 0xf10000
	move.w	#2000, d0
1:	dbra	d0, 1b
	move.w	#0x2700, sr
{START_CLOCK}""").numbers["start"] for enabled in (0, 1)]
    # The handler reads the value, in 16 cycles.
    assert started[1] - started[0] == 44 + 16 + 20
