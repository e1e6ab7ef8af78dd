# SPDX-License-Identifier: Apache-2.0
"""BRD-1, BRD-2, BRD-3, BRD-9, TST-5: both nodes on a bare Cortex-M4, in QEMU,
beside the simulation of the same flight."""

import concurrent.futures
import math
import socket
import subprocess
import time

import pytest

import bare
import emulated
import image_sum

MACHINE = emulated.CORTEX_M
SERVOS = 13
ROM, SCRATCHPAD = 0x08000000, 0x20010000
pytestmark = bare.needs(MACHINE)


@pytest.fixture(scope="module", autouse=True)
def built():
    """Both images."""
    for node in ("mcs", "gsc"):
        MACHINE.build(node)


@pytest.mark.parametrize("laws", [False, True], ids=["direct", "laws"])
def test_brd1_each_frame_has_the_words_of_the_simulation(tmp_path, laws):
    bare.flies_like_the_simulation(MACHINE, tmp_path, laws)


def test_brd1_a_node_that_starts_later_loses_no_character(
        tmp_path, monkeypatch):
    start = MACHINE.start

    def late(*given):
        for node in start(*given):
            yield node
            time.sleep(2)

    monkeypatch.setattr(MACHINE, "start", late)
    rows, runs = MACHINE.fly_both(tmp_path, 1, laws=False)
    assert list(emulated.differences(rows, runs)) == []


def test_brd1_a_difference_is_found(tmp_path):
    rows, runs = MACHINE.fly_both(tmp_path, 1, laws=False)
    rows[20]["pwm.throttle"] = str(int(rows[20]["pwm.throttle"]) ^ 1)
    rows[30]["gsc.downlink.alpha"] = "4096"
    assert list(emulated.differences(rows, runs)) == [
        (20, "pwm"), (30, "gsc.downlink")]


def test_brd9_the_servos_timers_have_the_pulses_of_the_words(tmp_path):
    """1 to 2 ms. QEMU keeps the timers' registers; it shows no output."""
    rows, runs = MACHINE.fly_both(tmp_path, 1, laws=False)
    pulses = runs["mcs"].pulses
    expected = [1000 + word * 1000 // 4095
                for word in emulated.words(rows[-1], "pwm")]
    assert len(set(pulses)) > 5
    assert pulses[:SERVOS] == expected[:SERVOS]
    assert all(1000 <= pulse <= 2000 for pulse in pulses)


def test_brd2_d81_a_fault_of_the_processor_restarts_it(tmp_path):
    bare.restarts(MACHINE, tmp_path, [
        (emulated.ILLEGAL_INSTRUCTION, 3),       # hard fault
        (emulated.UNEXPECTED_INTERRUPT, 23)])    # interrupt 7


@pytest.mark.parametrize("place", ["program", "filling", -5, -1],
                         ids=["program", "filling", "one sum", "the other"])
def test_brd3_tst1_a_changed_bit_of_the_image_is_refused(tmp_path, place):
    bare.refuses_a_changed_bit(MACHINE, tmp_path, place)


@pytest.mark.parametrize("order", ["big", "little"])
def test_brd3_the_sum_is_that_of_the_flight_software(order):
    """Known sums of three longs, as in the unit test; and the sums of an image
    with its own are known numbers."""
    assert image_sum.sums([0x31323334, 0x35363738, 0xDEADBEEF]) == (
        0x2556451C, 0x8FF6E1EC)
    image = image_sum.image_of(b"a program", MACHINE.rom_size, order)
    assert len(image) == MACHINE.rom_size
    assert image_sum.sums(image_sum.longs_of(image, order)) == (0, 0)


def test_tst1_the_period_of_the_sum_is_longer_than_any_image():
    """x is of order 2**32 - 1 modulo the polynomial: it is primitive. The same
    change of two longs is therefore found at any distance."""
    def times(left, right):
        product = 0
        for bit in reversed(range(32)):
            product = image_sum.times_x(product)
            if right >> bit & 1:
                product ^= left
        return product

    def power(exponent):
        result = 1
        for digit in f"{exponent:b}":
            result = times(result, result)
            if digit == "1":
                result = image_sum.times_x(result)
        return result

    order = 2 ** 32 - 1
    primes = (3, 5, 17, 257, 65537)
    assert math.prod(primes) == order
    assert power(order) == 1
    assert all(power(order // prime) != 1 for prime in primes)


def test_brd3_a_program_that_is_too_long_gets_no_sum():
    with pytest.raises(ValueError, match="114681 bytes: 114680 is the most"):
        image_sum.image_of(bytes(MACHINE.rom_size - 7), MACHINE.rom_size,
                           "little")


class Debugger:
    """QEMU's debugger, by GDB's remote protocol."""

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(emulated.LIMIT_S)
        while True:
            try:
                self.socket.connect(str(path))
                break
            except OSError:
                time.sleep(0.05)
        self.read = self.socket.makefile("rb").read

    def ask(self, text):
        """The answer to a command."""
        self.socket.sendall(
            f"${text}#{sum(text.encode()) % 256:02x}".encode())
        answer = b""
        while (byte := self.read(1)) != b"$":
            assert byte in b"+", byte
        while (byte := self.read(1)) != b"#":
            answer += byte
        self.read(2)
        self.socket.sendall(b"+")
        return answer.decode()

    def go_to(self, place):
        """Runs until the processor is at this place."""
        assert self.ask(f"Z1,{place:x},2") == "OK"
        assert self.ask("c").startswith("T05")
        assert self.register(15) == place
        assert self.ask(f"z1,{place:x},2") == "OK"

    def jump(self, place):
        registers = self.ask("g")
        where = place.to_bytes(4, "little").hex()
        assert self.ask(
            f"G{registers[:120]}{where}{registers[128:]}") == "OK"

    def register(self, number):
        registers = bytes.fromhex(self.ask("g"))
        return int.from_bytes(registers[4 * number:4 * number + 4], "little")


def address(symbol):
    symbols = subprocess.run(
        [f"{MACHINE.prefix}nm", MACHINE.images / "mcs.elf"],
        check=True, capture_output=True, text=True).stdout
    return next(int(line.split()[0], 16) for line in symbols.splitlines()
                if line.endswith(f" {symbol}")) & ~1


def read_back():
    """The place where the march first reads what it has written."""
    instruction = b"\x05\x68"         # ldr r5, [r0]
    program = (MACHINE.images / "mcs.bin").read_bytes()
    return program.index(instruction, address("urv_march") - ROM) + ROM


def fly_debugged(folder, monkeypatch, actions):
    """A flight whose emulator a debugger first stops; its actions run in a
    thread. The run, and the words that they have found."""
    path = folder / "debugger"
    monkeypatch.setattr(MACHINE, "more", (
        "-gdb", f"unix:{path},server=on", "-S"))
    found = []

    def debug():
        debugger = Debugger(path)
        try:
            actions(debugger, found)
        finally:
            debugger.ask("D")
            debugger.socket.close()

    with concurrent.futures.ThreadPoolExecutor() as pool:
        debugged = pool.submit(debug)
        run = MACHINE.fly({"mcs": emulated.Tape(0.5)}, folder)["mcs"]
        debugged.result()
    return run, found


def restart_within_a_test(debugger, found):
    """The processor restarts while the first cell has another word."""
    debugger.go_to(read_back())
    cell = debugger.register(0)
    found.append(cell)
    found.append(debugger.ask(f"m{cell:x},4"))
    debugger.jump(address("urv_restart_processor"))
    debugger.go_to(address("urv_run"))
    found.append(debugger.ask(f"m{cell:x},4"))
    found.append(debugger.ask(f"m{address('urv_kept') + 16:x},4"))


def test_tst5_a_restart_within_the_test_of_a_cell_keeps_its_contents(
        tmp_path, monkeypatch):
    run, found = fly_debugged(tmp_path, monkeypatch, restart_within_a_test)
    assert found == [SCRATCHPAD, "ffffffff", "00000000", "00000000"]
    assert run.has("MCS processor restart")


def spoil_a_read(debugger, found):
    """The first read-back of the third cell finds another bit."""
    for number in range(3):
        debugger.go_to(read_back())
        if number < 2:
            debugger.ask("s")
    cell = debugger.register(0)
    wrong = debugger.register(1) ^ 0x10
    debugger.ask(f"M{cell:x},4:" + wrong.to_bytes(4, "little").hex())
    found.append(cell)


def test_tst5_a_cell_that_reads_another_value_is_reported(
        tmp_path, monkeypatch):
    """QEMU has no stuck bits: the debugger changes a cell within its test."""
    run, found = fly_debugged(tmp_path, monkeypatch, spoil_a_read)
    assert found == [SCRATCHPAD + 8]
    assert run.has("MCS started")
    last = max(run.rows)
    assert run.status(last)[bare.SELF_TEST] == bare.RAM_FAILED
    assert run.downlink(last)[-1] & 4
    assert run.numbers["overruns"] == 0


def test_d80_the_runtime_needs_no_tasks_and_no_exceptions():
    text = (MACHINE.images / "runtime/adainclude/system.ads").read_text()
    for restriction in ("No_Tasking", "No_Exception_Propagation",
                        "No_Finalization"):
        assert f"pragma Restrictions ({restriction});" in text


def test_d82_a_flight_is_the_same_on_every_run(tmp_path):
    texts = []
    for name in ("one", "other"):
        (tmp_path / name).mkdir()
        line = {"quantum": MACHINE.quantum,
                "line_delay_us": MACHINE.line_delay_us}
        tapes = {"gsc": emulated.Tape(1, **line),
                 "mcs": emulated.Tape(1, lag=emulated.LAG, **line)}
        runs = MACHINE.fly(tapes, tmp_path / name)
        texts.append([runs[node].text for node in tapes])
    assert texts[0] == texts[1]
