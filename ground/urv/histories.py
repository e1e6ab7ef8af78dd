# SPDX-License-Identifier: Apache-2.0
"""Flights with random sticks, modes, engine, surfaces and link, and then 90 s of
calm in which every active hold must be held (SIM-6, EXT-8).

    drawn = histories.draw(1234)
    drawn.sticks, drawn.conditions, drawn.faults    the files of urv_sim
    drawn.seconds                                   the flight's length
    drawn.values                                    the drawn values, by name

The same seed gives the same flight, whatever other flights are flown.
"""

import random
from typing import NamedTuple

from urv import dispersions

CALM_S = 90
HISTORY_S = (25, 60)
EVENTS = (4, 12)
SHORTEST_S, LONGEST_S = 1, 10

# Without laws, or with damped rates only, the pilot flies by hand: small
# deflections, for short times.
BY_HAND_MOST = 250
BY_HAND_S = 3

# The modes that the switches select, and their weights.
MODES = {"direct": 1, "damping": 2, "attitude": 6, "hold": 7, "level": 3,
         "level_hold": 4}
SWITCHES = {"direct": (), "damping": (1,), "attitude": (2,), "hold": (2, 3),
            "level": (2, 4), "level_hold": (3, 4)}
BY_HAND = ("direct", "damping")
CALM_MODES = {name: often for name, often in MODES.items()
              if name not in BY_HAND}

COLUMNS = ("roll", "pitch", "yaw", "throttle",
           *(f"switch{number}" for number in range(1, 9)))
MIDDLE, FULL = 2048, 4095

# In the calm: pitch and throttle that keep the aircraft in the air.
CALM_PITCH = (-60, 500)
CALM_LEVER = (1800, FULL)
CLIMBING_LEVER = 2500

MOST_FAULTS = 3
FAULT_MS = (1_000, 20_000)
FOR_GOOD = 0.1
LOST_IN_CALM = 0.2
RECOVERED = "slow 99"

BALLAST_LB = (-10, 20)
BALLAST_AFT_IN = (-10, 10)
WIND_KT = (0, 15)


class Drawn(NamedTuple):
    """A flight's input files, its length, and the values drawn for it."""

    sticks: str
    conditions: str
    faults: str
    seconds: int
    values: dict


def draw(seed):
    """The flight of that seed."""
    chance = random.Random(f"history {seed}")
    history_s = chance.randint(*HISTORY_S)
    rows, mode = [], "hold"
    at_ms = 0
    row = words(chance, mode, is_calm=True)
    row |= {"roll": MIDDLE, "pitch": MIDDLE, "throttle": MIDDLE}
    rows.append((0, row))
    at_ms = 3_000
    while at_ms < history_s * 1000 - 500:
        mode = chance.choices(list(MODES), list(MODES.values()))[0]
        rows.append((at_ms, words(chance, mode, is_calm=False)))
        at_ms += chance.randrange(
            SHORTEST_S * 1000,
            (BY_HAND_S if mode in BY_HAND else LONGEST_S) * 1000)
    calm_mode = chance.choices(
        list(CALM_MODES), list(CALM_MODES.values()))[0]
    rows.append((history_s * 1000, words(chance, calm_mode, is_calm=True)))
    faults, values = drawn_faults(chance, history_s)
    values |= {"history_s": float(history_s),
               "calm_mode": float(list(MODES).index(calm_mode))}
    conditions = "\n".join((
        f"wind {chance.randrange(360)} {round(chance.uniform(*WIND_KT), 1)}",
        f"ballast {round(chance.uniform(*BALLAST_LB), 1)}"
        f" {round(chance.uniform(*BALLAST_AFT_IN), 1)}"))
    return Drawn(
        "\n".join([",".join(("time_ms", *COLUMNS)), *(
            ",".join(map(str, (at, *(row[name] for name in COLUMNS))))
            for at, row in rows)]) + "\n",
        conditions + "\n", "\n".join(faults or ["# none"]) + "\n",
        history_s + CALM_S, values)


def words(chance, mode, is_calm):
    """Sticks and switches of one moment."""
    row = {name: 0 for name in COLUMNS}
    row |= {"roll": MIDDLE, "pitch": MIDDLE, "yaw": MIDDLE,
            "throttle": MIDDLE}
    for number in SWITCHES[mode]:
        row[f"switch{number}"] = FULL
    row["switch8"] = FULL * (chance.random() < 0.1)
    if mode in BY_HAND:
        for name in ("roll", "pitch"):
            row[name] += chance.randint(-BY_HAND_MOST, BY_HAND_MOST)
    elif is_calm:
        row["roll"] = chance.choice((MIDDLE, chance.randint(0, FULL)))
        row["throttle"] = chance.randint(*CALM_LEVER)
        if chance.random() < 0.4:
            row["pitch"] += chance.randint(*CALM_PITCH)
            row["throttle"] = max(row["throttle"], CLIMBING_LEVER)
    else:
        row["roll"] = chance.choice((MIDDLE, chance.randint(0, FULL)))
        row["pitch"] = chance.choice((MIDDLE, chance.randint(0, FULL)))
        row["yaw"] = chance.choice((MIDDLE,) * 3 + (chance.randint(0, FULL),))
        row["throttle"] = chance.choice(
            (MIDDLE, 0, FULL, chance.randint(0, FULL)))
    return row


def drawn_faults(chance, history_s):
    """The lines of the fault file, and the values drawn for them."""
    lines, for_good, calm_ms = [], 0, history_s * 1000
    kinds = [chance.choice(("engine", "surface", "cut"))
             for _ in range(chance.randint(0, MOST_FAULTS))]
    names = {}
    for kind in kinds:
        first = chance.randrange(3_000, calm_ms - 2_000)
        last = min(first + chance.randint(*FAULT_MS), calm_ms - 500)
        if kind == "cut":
            lines.append(f"{first} cut {last - first}")
            continue
        name = ("throttle" if kind == "engine"
                else chance.choice(dispersions.SURFACES))
        how = chance.choice((
            "stuck", f"stuck {chance.randrange(4096)}",
            "stuck 0" if kind == "engine" else "float",
            f"slow {chance.randrange(1, 50)}"))
        stays = chance.random() < FOR_GOOD
        if name in names:
            # One fault per servo, so that its end is final.
            continue
        names[name] = stays
        lines.append(f"{first} surface {name} {how}")
        if stays:
            for_good += 1
        else:
            lines.append(f"{last} surface {name} {RECOVERED}")
    is_lost = chance.random() < LOST_IN_CALM
    if is_lost:
        first = calm_ms - chance.randrange(0, 5_000)
        lines.append(f"{first} cut {(history_s + CALM_S) * 1000 - first}")
    return lines, {"faults": float(len(kinds)), "for_good": float(for_good),
                   "surface_fault": float(bool(names)),
                   "lost_in_calm": float(is_lost)}
