# SPDX-License-Identifier: Apache-2.0
"""Nodes on a bare machine in an emulator, and the simulation's words beside
theirs.

    tape = Tape(lag=3, quantum=8, seconds=10)
    tape.read(0, words_by_channel)
    runs = CORTEX_M.fly({"gsc": Tape(...), "mcs": tape}, folder)

Two nodes fly in lock-step, joined by their serial ports: the result does not
depend on the computer (D-82, D-83). docs/board.md says more.
"""

import contextlib
import csv
import random
import shutil
import socket
import struct
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
IMAGES = ROOT / "obj" / "targets"

CHARACTER_US = 96
TICK_MS = 2
CHANNELS = 32
TAPE_ADDRESS = 0x08080000

# An instruction takes 8 ns of the emulator's time, which is 1.344 cycles at
# 168 million cycles a second.
ICOUNT_SHIFT = 3
CYCLES_PER_INSTRUCTION = 168e6 * 2 ** ICOUNT_SHIFT / 1e9

WORDS, ILLEGAL_INSTRUCTION, UNEXPECTED_INTERRUPT = range(3)

# Only the MC68000 has these. Three befall the next character that the line of
# its telemetry board receives. After the last one no tick comes, or no character
# time.
ODD_ADDRESS, PARITY_ERROR, FRAMING_ERROR, LOST_CHARACTER = range(3, 7)
ENDLESS_LOOP, LOST_TIMER = range(7, 9)

# An illegal instruction and an endless loop when the processor next claims the
# dual-ported memory.
ILLEGAL_WITH_LOCK, LOOP_WITH_LOCK = range(9, 11)

# A byte of the controller's RAM becomes stuck. An illegal instruction or an
# unused interrupt comes in the next test of a cell.
STUCK_BITS, ILLEGAL_IN_RAM_TEST, INTERRUPT_IN_RAM_TEST = range(11, 14)
RESET_SWITCH = 14

# An illegal instruction at power up, when the controller has read its settings.
ILLEGAL_IN_START = 15

# A read of a place where nothing answers.
NO_DEVICE = 16

# Is added to an event that befalls the telemetry board's processor.
ON_TELEMETRY_BOARD = 32

LAWS_ON, SEALED = 1, 2

# The keys of a sealed flight, as in targets/nodes/node_programs.adb.
KEYS = "key 1 000102030405060708090a0b0c0d0e0f\n"

# The number of words in each part of a row, in order.
UPLINK, DOWNLINK, STATUS, PWM = 14, 28, 12, 14

# A tape on the Cortex-M4 has 6,001 entries, in the flash after the program; a
# scripted flight has one each 60 ms.
MOST_SECONDS = 360

FRAME_MS = 20
FRAMES_PER_S = 1000 // FRAME_MS

# The aircraft's lag in ticks, in a joined flight.
LAG = 3

STICKS = ["roll", "pitch", "yaw", "throttle", "brake",
          *(f"switch{number}" for number in range(1, 9))]
SENSORS = [f"{side}_{name}" for name in ("flap_1", "flap_2", "aileron",
                                         "elevator", "rudder")
           for side in ("right", "left")] + [
    "alpha", "beta", "altitude_offset", "lateral_acceleration",
    "longitudinal_acceleration", "vertical_acceleration", "rpm",
    "battery_volts", "alternator_volts", "roll_attitude", "pitch_attitude",
    "roll_rate", "pitch_rate", "yaw_rate", "airspeed", "altitude",
    "uplink_signal_strength"]


class Tape:
    """The inputs of an emulated node; see Tapes in targets."""

    def __init__(self, seconds, lag=0, quantum=0, flags=0, line_delay_us=0):
        self.lag, self.quantum, self.flags = lag, quantum, flags
        self.line_delay_us = line_delay_us
        self.length = int(seconds * 1e6 / CHARACTER_US)
        self.entries = []
        self.read(0, [0x800] * CHANNELS)

    def read(self, time_ms, words):
        """The converter reads these words from a time on, by channel."""
        self.entries.append((self.tick(time_ms), WORDS, list(words)))

    def plant(self, time_ms, event):
        self.entries.append((self.tick(time_ms), event, [0] * CHANNELS))

    def stick(self, time_ms, address, bits, value):
        """From a time on, these bits of a byte read as those of the value."""
        assert value & ~bits == 0
        self.entries.append((self.tick(time_ms), STUCK_BITS,
                             [address & 0xFFFF, address >> 16, bits, value, 0]))

    def couple(self, time_ms, address, bit, other):
        """From a time on, a bit of a long word reads as another bit of it."""
        address += 3 - bit // 8
        self.entries.append((self.tick(time_ms), STUCK_BITS, [
            address & 0xFFFF, address >> 16, 1 << bit % 8, 0, other + 1]))

    def tick(self, time_ms):
        """The first tick of the node that is not before a time."""
        return max(0, -(-time_ms // TICK_MS) - self.lag)

    def data(self):
        entries = sorted(self.entries, key=lambda each: each[0])
        head = struct.pack("<6I", self.lag, self.quantum, self.line_delay_us,
                           self.flags, self.length, len(entries))
        return head + b"".join(
            struct.pack(f"<2I{CHANNELS}H", tick, kind,
                        *(words + [0x800] * CHANNELS)[:CHANNELS])
            for tick, kind, words in entries)


class Failed(Exception):
    """An emulator has not ended its flight. The text says why."""


class Run:
    """The output of an emulated node."""

    def __init__(self, text):
        self.text = text
        self.rows = {}
        self.numbers = {}
        self.pulses = []
        for line in text.splitlines():
            name, *rest = line.split() or [""]
            prefix = ""
            if name == "board" and rest:
                prefix, (name, *rest) = "board_", rest
            if name == "row":
                self.rows[int(rest[1])] = [int(word, 16) for word in rest[2:]]
            elif name == "pulses":
                self.pulses = [int(word, 16) for word in rest]
            elif len(rest) >= 2 and rest[1].isdigit():
                self.numbers.update(zip((prefix + each for each in rest[::2]),
                                        map(int, rest[1::2])))

    def has(self, line):
        return line in self.text.splitlines()

    def uplink(self, frame):
        return self.rows[frame][:UPLINK]

    def downlink(self, frame):
        return self.rows[frame][UPLINK:UPLINK + DOWNLINK]

    def status(self, frame):
        return self.rows[frame][UPLINK + DOWNLINK:][:STATUS]

    def pwm(self, frame):
        return self.rows[frame][UPLINK + DOWNLINK + STATUS:]


# The longest time of an emulated flight. It takes 10 to 20 s on a machine that
# has nothing else to do.
LIMIT_S = 300


class Machine:
    """A bare machine in its emulator. Each has name, prefix of its compiler,
    quantum and delay of a joined flight's line, and start."""

    @property
    def images(self):
        return IMAGES / self.name

    def build(self, node):
        subprocess.run([ROOT / "targets" / "build.sh", self.name, node],
                       check=True)

    def fly(self, tapes, folder, images=None, limit_s=LIMIT_S,
            may_fail=False):
        """Runs the nodes of these tapes until their ends; Run of each by
        name. Two are joined by their serial lines. An emulator that fails is
        an error, unless it may."""
        folder = Path(folder)
        for name, tape in tapes.items():
            (folder / f"{name}.tape").write_bytes(tape.data())
        failed = False
        with contextlib.ExitStack() as stack:
            for each in list(
                    self.start(list(tapes), folder, images or {}, stack)):
                try:
                    failed = each.wait(limit_s) != 0 or failed
                except subprocess.TimeoutExpired:
                    raise Failed(f"no end after {limit_s:g} s") from None
        if failed and not may_fail:
            raise Failed("".join(
                path.read_text(errors="replace")
                for path in sorted(folder.glob("*.err"))).strip())
        return {name: Run(self.text(folder, name)) for name in tapes}

    def text(self, folder, name):
        return (folder / f"{name}.txt").read_text(errors="replace")

    def image(self, name, images):
        return images.get(name, self.images / f"{name}.bin")

    def fly_both(self, folder, seconds, laws, sealed=False):
        """A scripted flight, by the simulation and by two emulated nodes: the
        rows of the one, the runs of the other."""
        folder = Path(folder)
        line = {"quantum": self.quantum, "line_delay_us": self.line_delay_us}
        seal = SEALED if sealed else 0
        gsc = Tape(seconds, flags=seal, **line)
        mcs = Tape(seconds, lag=LAG, flags=seal | (LAWS_ON if laws else 0),
                   **line)
        scripted(STICKS, gsc, folder / "sticks.csv", seconds, 1)
        scripted(SENSORS, mcs, folder / "sensors.csv", seconds, 2)
        record = folder / "record.csv"
        keys = folder / "keys"
        keys.write_text(KEYS, encoding="utf-8")
        keys.chmod(0o600)
        subprocess.run(
            [ROOT / "bin" / "urv_sim", "fly", "--seconds", str(seconds),
             "--sticks", folder / "sticks.csv",
             "--sensors", folder / "sensors.csv",
             "--laws", "on" if laws else "off", "--phase", str(LAG),
             "--line-delay", str(self.line_delay_us / 1000),
             *(["--format", "2", "--key", keys] if sealed else []),
             "--record", record, "--quiet"], check=True)
        with record.open(encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        return rows, self.fly({"gsc": gsc, "mcs": mcs}, folder)


class CortexM(Machine):
    """An STM32F405 in QEMU. One emulator for each node; after each quantum of
    the line they exchange its characters."""

    name = "cortex_m"
    prefix = "arm-linux-gnueabihf-"
    needed = ("qemu-system-arm", "arm-linux-gnueabihf-gnatmake-12")
    rom_size = 112 * 1024
    quantum = 8
    line_delay_us = (quantum - 1) * CHARACTER_US

    # More arguments of the emulator, for tests.
    more = ()

    def command(self, image, tape, console, line):
        return ["qemu-system-arm", "-M", "netduinoplus2", "-semihosting",
                "-icount", f"shift={ICOUNT_SHIFT},align=off,sleep=off",
                "-display", "none", "-monitor", "none",
                "-chardev", f"{line},id=line",
                "-serial", f"file:{console}", "-serial", "chardev:line",
                "-kernel", str(image), "-device",
                f"loader,file={tape},addr={TAPE_ADDRESS:#x},force-raw=on",
                *self.more]

    def start(self, names, folder, images, stack):
        # Both ends are open here until both emulators have ended: at a closed
        # line QEMU loses the characters that it has not read.
        ends = socket.socketpair() if len(names) == 2 else [None]
        for end in filter(None, ends):
            stack.enter_context(end)
        for name, end in zip(names, ends, strict=True):
            running = subprocess.Popen(
                self.command(self.image(name, images), folder / f"{name}.tape",
                             folder / f"{name}.txt",
                             f"socket,fd={end.fileno()}" if end else "null"),
                pass_fds=[end.fileno()] if end else [],
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                stderr=(folder / f"{name}.err").open("w"))
            stack.callback(stop, running)
            yield running


class MC68000(Machine):
    """The report's processor, two boards in one emulator (musashi/board.c).
    Their line delays nothing, but a received character waits for the next
    character time of the simulation."""

    name = "mc68000"
    prefix = "m68k-linux-gnu-"
    needed = ("m68k-linux-gnu-gnatmake-12", "gcc")
    rom_size = 160 * 1024
    quantum = 0
    line_delay_us = 0
    archive = ROOT / "obj" / "musashi" / "machine68k-0.4.1.tar.gz"
    # No task is late, and no timer interrupt is lost.
    mhz = 250

    def build(self, node):
        subprocess.run([ROOT / "targets/mc68000/musashi/build_board.sh"],
                       check=True)
        super().build("telemetry_board")
        super().build(node)

    def text(self, folder, name):
        """Lines of the telemetry board begin with "board": its figures are
        "board_NAME"."""
        board = super().text(folder, f"{name}_board")
        return super().text(folder, name) + "".join(
            f"board {line}\n" for line in board.splitlines())

    def start(self, names, folder, images, stack):
        command = [self.images / "board", str(self.mhz), folder]
        for name in names:
            command += [name, self.image(name, images),
                        images.get(f"{name}_board", self.image(
                            "telemetry_board", images)),
                        folder / f"{name}.tape"]
        running = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=(folder / "board.err").open("w"))
        stack.callback(stop, running)
        yield running


CORTEX_M = CortexM()
MC68000_BOARD = MC68000()
MACHINES = {each.name: each for each in (CORTEX_M, MC68000_BOARD)}


def scripted(names, tape, path, seconds, seed):
    """Random words, others every three frames, for the simulation and for
    the tape."""
    numbers = random.Random(seed)
    lines = ["time_ms," + ",".join(names)]
    for time_ms in range(0, int(seconds * 1000), 3 * FRAME_MS):
        words = [numbers.randrange(0x1000) for _ in names]
        lines.append(f"{time_ms}," + ",".join(map(str, words)))
        tape.read(time_ms, words)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def words(row, group):
    return [int(value) for name, value in row.items()
            if name.startswith(f"{group}.")]


def differences(rows, runs):
    """Each group of words that is not the simulation's, with its frame."""
    gsc, mcs = runs["gsc"], runs["mcs"]
    for row in rows:
        frame = int(row["frame"])
        for node, group, seen in (
                (gsc, "gsc.uplink", gsc.uplink),
                (gsc, "gsc.downlink", gsc.downlink),
                (mcs, "mcs.uplink", mcs.uplink),
                (mcs, "mcs.downlink", mcs.downlink), (mcs, "pwm", mcs.pwm)):
            if frame in node.rows and seen(frame) != words(row, group):
                yield frame, group


def missing(rows, runs):
    """Each node with a frame of the simulation that it has no row of. The last
    frame may end after the flight."""
    for name, run in runs.items():
        for row in rows[:-1]:
            if int(row["frame"]) not in run.rows:
                yield int(row["frame"]), name


def tools_missing(machine, nodes=("gsc", "mcs")):
    """The missing programs and files of those that fly a machine's images."""
    files = [ROOT / "bin" / "urv_sim",
             *(machine.images / f"{node}.{kind}" for node in nodes
               for kind in ("bin", "elf"))]
    if machine is MC68000_BOARD:
        files += [machine.images / name
                  for name in ("board", "telemetry_board.bin")]
    return [name for name in machine.needed if not shutil.which(name)] + [
        str(each.relative_to(ROOT)) for each in files if not each.exists()]


def check_tools(machine):
    """Ends the program if something is not there."""
    if lack := tools_missing(machine):
        sys.exit(f"{Path(sys.argv[0]).name}: missing: {', '.join(lack)}:"
                 f" make {machine.name} makes or installs them")


def stop(process):
    if process.poll() is None:
        process.kill()
    process.wait()
