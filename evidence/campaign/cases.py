# SPDX-License-Identifier: Apache-2.0
"""The faults that the campaign injects into the link.

A case is one or more faults close together, then calm: enough frames to
recover in and to see that nothing comes after. A shard is as many cases as
fit into one flight; its name is all that is needed to make it again:

    single/PHASE/FIRST/STOP/STEP   every STEPth of the single faults
    many/PHASE/SEED/COUNT          COUNT pairs and triples by chance
    cut/PHASE/SEED/STEP            cuts from 1 ms to 10 s
    stall/PHASE/NODE/MS/STEP_US    a stall at every point of a frame
    reset/PHASE/NODE/STEP_US       a telemetry board restarted, likewise
    start/PHASE/NODE/HOW/STEP_US   a node reset (HOW is warm), or its
                                   processor restarted (processor), likewise
    soak/PHASE/SEED/RATE/FRAMES    spells of bit errors
    calm/PHASE/FRAMES              no fault at all
    mix/FIRST/STOP                 random mixes of everything (mixes.py),
                                   each a flight of its own
"""

import random
import sys
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from flight_numbers import NUMBERS  # noqa: E402

FRAME_US = NUMBERS.frame_us
CHARACTER_US = NUMBERS.character_us

# Characters of an exchange, each way.
CHARACTERS = {"up": NUMBERS.exchange_up_characters,
              "down": NUMBERS.exchange_down_characters}
PLACES = [(way, n + 1) for way, count in CHARACTERS.items()
          for n in range(count)]

# Each fault of a single character.
HARMS = (["drop {n}", "dup {n}"]
         + [f"insert {{n}} {byte:02x}" for byte in range(256)]
         + [f"flip {{n}} {mask:x}" for mask in range(1, 512)])
SINGLES = len(PLACES) * len(HARMS)

# Frames of calm at the end of a case, the one with the last fault's end
# included, and before the first case.
CALM = 7
LEAD = 40

CUTS_MS = (1, 1.5, 2, 3, 4, 6, 8, 10, 13, 16, 20, 25, 30, 40, 60, 100, 200,
           500, 1_000, 2_000, 5_000, 10_000)
NOISY_FRAMES = 93


class Fault(NamedTuple):
    """A line of the script: when, counted from the frame in which the case
    begins, what, and how long it lasts. A fault of the Nth character ends
    with that character (duration None)."""

    at_us: int
    way: str
    text: str
    character: int
    duration_us: int | None


class Case(NamedTuple):
    faults: list
    frames: int


def of_character(at_us, way, harm, n):
    return Fault(at_us, way, harm.format(n=n), n, None)


def lasting(at_us, way, text, duration_us):
    return Fault(at_us, way, text.format(ms=f"{duration_us / 1000:.3f}"),
                 0, duration_us)


def case(faults, last_us):
    return Case(faults, last_us // FRAME_US + CALM)


def singles(first, stop, step):
    for index in range(first, min(stop, SINGLES), step):
        place, harm = divmod(index, len(HARMS))
        way, n = PLACES[place]
        yield case([of_character(0, way, HARMS[harm], n)], 0)


def by_chance(chance, count):
    """Pairs and triples: within one exchange and its retries."""
    for index in range(count):
        faults = []
        for _ in range(2 + index % 2):
            way = chance.choice(("up", "down"))
            # Few insertions and few errors of parity: those would leave
            # little for the checksum to do.
            harm = chance.choice((
                "drop {n}", "dup {n}",
                f"insert {{n}} {chance.randrange(256):02x}",
                f"flip {{n}} {chance.randrange(1, 512):x}",
                f"flip {{n}} {1 << chance.randrange(8) | 0x100:x}",
                f"flip {{n}} {chance.choice((3, 6, 0x11, 0xf0)):x}"))
            at = chance.randrange(0, 12_000)
            faults.append(of_character(
                at, way, harm, chance.randrange(1, CHARACTERS[way] + 1)))
        # An Nth character may be one of a later frame.
        yield case(faults, 3 * FRAME_US)


def cuts(chance, step):
    for index in range(0, len(CUTS_MS) * 40, step):
        duration = round(CUTS_MS[index % len(CUTS_MS)] * 1000)
        at = chance.randrange(FRAME_US)
        yield case([lasting(at, "", "cut {ms}", duration)], at + duration)


def stalls(node, duration_ms, step_us):
    duration = round(float(duration_ms) * 1000)
    for at in range(0, FRAME_US, step_us):
        yield case([lasting(at, node, "stall telemetry {ms}", duration)],
                   at + duration)


def resets(node, step_us):
    for at in range(0, FRAME_US, step_us):
        yield case([lasting(at, node, "reset telemetry", 1)], at + 1)


def starts(node, how, step_us):
    for at in range(0, FRAME_US, step_us):
        yield case([lasting(at, node, f"reset {how}", 1)], at + 1)


def soak(rate, frames):
    duration = NOISY_FRAMES * FRAME_US
    for _ in range(frames // (NOISY_FRAMES + CALM)):
        yield case([lasting(0, way, f"ber {rate} {{ms}}", duration)
                    for way in ("up", "down")], duration)


def calm(frames):
    """One fault that lasts no time, and nothing else."""
    yield Case([lasting(0, "", "cut {ms}", 0)], frames)


def of_shard(name):
    """The phase, the seed of the flight and the cases of a shard."""
    group, phase, *rest = name.split("/")
    seed = 1
    if group == "single":
        made = singles(*map(int, rest))
    elif group == "many":
        made = by_chance(random.Random(f"many {phase} {rest[0]}"),
                         int(rest[1]))
    elif group == "cut":
        made = cuts(random.Random(f"cut {phase} {rest[0]}"), int(rest[1]))
    elif group == "stall":
        made = stalls(rest[0], rest[1], int(rest[2]))
    elif group == "reset":
        made = resets(rest[0], int(rest[1]))
    elif group == "start":
        made = starts(rest[0], rest[1], int(rest[2]))
    elif group == "soak":
        seed = int(rest[0])
        made = soak(rest[1], int(rest[2]))
    elif group == "calm":
        made = calm(int(rest[0]))
    else:
        raise ValueError(f"no such shard: {name}")
    return int(phase), seed, list(made)


RATES = ("1e-6", "1e-5", "1e-4", "1e-3", "1e-2")

# For each size: phases with single faults, of which every STEPth; pairs and
# triples; every which cut; stalls' lengths and distance; frames of all soaks,
# and without a fault at each phase; random mixes.
SIZES = {
    "tiny": {"phases": (3,), "step": 37, "many": 400, "cuts": 15,
             "stalls_ms": (1, 25), "stall_step_us": 1_000, "soak": 5_000,
             "calm": 200, "mixes": 500},
    "short": {"phases": (3,), "step": 1, "many": 4_000, "cuts": 2,
              "stalls_ms": (0.2, 2, 5, 25), "stall_step_us": 96,
              "soak": 50_000, "calm": 5_000, "mixes": 2_000},
    "full": {"phases": (0, 3, 7), "step": 1, "many": 20_000, "cuts": 1,
             "stalls_ms": (0.1, 0.5, 2, 3, 5, 10, 25, 60),
             "stall_step_us": 48, "soak": 1_000_000, "calm": 100_000,
             "mixes": 20_000},
}


MIXES_A_SHARD = 100


def plan(size):
    """The names of the shards."""
    chosen = SIZES[size]
    step = chosen["step"]
    for phase in chosen["phases"]:
        chunk = 2_000 * step
        for first in range(0, SINGLES, chunk):
            yield f"single/{phase}/{first}/{first + chunk}/{step}"
        for node in ("gsc", "mcs"):
            for duration in chosen["stalls_ms"]:
                yield (f"stall/{phase}/{node}/{duration}"
                       f"/{chosen['stall_step_us']}")
            yield f"reset/{phase}/{node}/{chosen['stall_step_us']}"
            for how in ("warm", "processor"):
                yield f"start/{phase}/{node}/{how}/{chosen['stall_step_us']}"
        yield f"cut/{phase}/{phase}/{chosen['cuts']}"
    for phase in range(NUMBERS.frame_ticks):
        yield f"calm/{phase}/{chosen['calm']}"
    count = min(1_000, chosen["many"])
    for seed in range(chosen["many"] // count):
        phase = chosen["phases"][seed % len(chosen["phases"])]
        yield f"many/{phase}/{seed}/{count}"
    frames = min(20_000, chosen["soak"] // len(RATES))
    for seed in range(chosen["soak"] // frames):
        phase = chosen["phases"][seed % len(chosen["phases"])]
        yield f"soak/{phase}/{seed}/{RATES[seed % len(RATES)]}/{frames}"
    for first in range(0, chosen["mixes"], MIXES_A_SHARD):
        yield f"mix/{first}/{first + MIXES_A_SHARD}"
