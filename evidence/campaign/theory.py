#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The link under bit errors: what theory says and what the simulation does.

  theory.py [--frames N] [--renew]
      measures, prints the table; --renew writes it into docs/evidence/link.md, and the
      plot docs/evidence/link-errors.svg

Theory is a closed form from the protocol as docs/link.md has it. What is
measured comes from the wire alone: who sent what, and how it was answered.
The nodes' frames begin together (--phase 0), so that both boards are given
their blocks at the same moment.
"""

import argparse
import bisect
import math
import re
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parent))

import cases  # noqa: E402
import checker  # noqa: E402
import run  # noqa: E402

EVIDENCE = run.ROOT / "docs" / "evidence"

# Characters of a data message.
UP = cases.NUMBERS.uplink_characters
DOWN = cases.NUMBERS.downlink_characters
DEAD_SPACE = cases.NUMBERS.dead_space_characters
IDLE = cases.NUMBERS.idle_characters
GUARD = cases.NUMBERS.guard_characters
# When in its frame a board is given its block: with the servos.
PUT_US = cases.NUMBERS.servo_tick * cases.NUMBERS.tick_us
CHARACTER_MS = cases.CHARACTER_US / 1000

RATES = ("1e-6", "1e-5", "3e-5", "1e-4", "3e-4", "1e-3", "3e-3", "1e-2")
QUANTITIES = ("up_delivered", "up_sent", "up_ms",
              "down_delivered", "down_sent")


def answered_after():
    """How many characters after the first transmission of an uplink its answer
    begins, on average: the aircraft's timer counts on whatever happens, so
    the wait ends GUARD counts after its last character."""
    starts = {(frame * cases.FRAME_US + PUT_US) % cases.CHARACTER_US
              for frame in range(cases.CHARACTER_US)}
    return GUARD - sum(starts) / len(starts) / cases.CHARACTER_US


class Turn(NamedTuple):
    """How a turn of the ground may end: it need not be taken again; or it
    ended with the ground's idle time, for nothing was heard of it."""

    probability: float
    characters: float
    is_good: bool = False
    is_idled: bool = False


def turns(q, whole, spoken, silent):
    """The ends of a turn after which so many characters were spoken, or so
    many if the first one was lost; the message that counts is whole so often."""
    return (Turn(whole * q, spoken, is_good=True),
            Turn((q - whole) * q, spoken),
            Turn(q * (1 - q), spoken + IDLE, is_idled=True),
            Turn(1 - q, silent + DEAD_SPACE + IDLE, is_idled=True))


def taken_twice(ends):
    """A turn that did not end well is taken once more."""
    for first in ends:
        if first.is_good:
            yield first
        else:
            for second in ends:
                yield second._replace(
                    probability=first.probability * second.probability,
                    characters=first.characters + second.characters)


def exchanges(rate):
    """Each length of an exchange, the ground's idle time at its end (D-28)
    included, with its probability."""
    q = (1 - rate) ** 9
    answer = answered_after() + 1
    up = turns(q, q**UP, UP + answer, UP)
    down = turns(q, q**DOWN, 1 + DOWN + answer, 1)
    for sent in taken_twice(up):
        for asked in taken_twice(down):
            yield (sent.probability * asked.probability,
                   sent.characters + asked.characters
                   + (0 if asked.is_idled else IDLE))


def late_start(rate):
    """How many characters a frame's exchange begins late, on average, for the
    one before it was not over. That one is taken to have begun in time."""
    frame = cases.FRAME_US / cases.CHARACTER_US
    return sum(probability * max(0, characters - frame)
               for probability, characters in exchanges(rate))


def theory(rate):
    """Per block: the fraction delivered, how often it is sent, and for the
    uplink how long it takes from the controller to the other board."""
    # A character arrives; all of a data message does.
    q = (1 - rate) ** 9
    a, b = q**UP, q**DOWN

    # Up: sent again unless the aircraft's good status is heard.
    up_delivered = a * (2 - a)
    up_sent = 1 + (1 - a * q)

    # What passes between the two transmissions when the first was spoilt:
    # nothing was answered; or a bad status was, and heard; or not heard.
    between = ((1 - q) * (DEAD_SPACE + IDLE)
               + (q - a) * (answered_after() + 1 + (1 - q) * IDLE))
    up_characters = (UP + (1 - a) * 2 * UP + between) / (2 - a)

    # Down: the ground knows of the block once a status, good or bad, is
    # heard; it commands once more unless data came whole. The second
    # command is not heard after a bad status that was not.
    known = 1 - (1 - q**2) ** 2
    down_sent = known * q * (1 + (1 - q) + q * (1 - q) + q**2 * (q - b))
    return {"up_delivered": up_delivered, "up_sent": up_sent,
            "up_ms": (up_characters + late_start(rate)) * CHARACTER_MS,
            "down_delivered": down_sent * b, "down_sent": down_sent}


class Message(NamedTuple):
    start_us: int
    end_us: int
    content: bytes


def messages(wire, way):
    """Data messages and status messages of one direction."""
    name = way.encode()
    times = list(map(int, re.findall(rb"^(\d+)," + name, wire, re.MULTILINE)))
    sent = bytes.fromhex(
        b"".join(re.findall(rb"," + name + rb",(..)", wire)).decode())
    place = 0
    while place < len(sent):
        length = checker.MESSAGE_LENGTHS[way][sent[place]]
        if place + length <= len(sent):
            yield Message(times[place],
                          times[place + length - 1] + cases.CHARACTER_US,
                          sent[place:place + length])
        place += length


class Mean(NamedTuple):
    value: float
    error: float   # standard error


def mean(values):
    count = len(values)
    average = sum(values) / count
    variance = sum((value - average) ** 2 for value in values) / (count - 1)
    return Mean(average, math.sqrt(variance / count))


def answered_well(blocks, answers, good):
    """When each block was first received whole, by its content; how often
    it was sent."""
    good_times = sorted(answer.start_us for answer in answers
                        if answer.content[0] in good)
    received, sent = {}, {}
    for block in blocks:
        sent[block.content] = sent.get(block.content, 0) + 1
        answer = bisect.bisect_right(good_times, block.end_us)
        if (answer < len(good_times) and good_times[answer]
                <= block.end_us + GUARD * cases.CHARACTER_US):
            received.setdefault(block.content, block.end_us)
    return received, sent


def measure(rate, frames, seed=1):
    """The same quantities from a flight, after its first 20 frames."""
    with tempfile.TemporaryDirectory(prefix="urv-theory-") as folder:
        folder = Path(folder)
        flown = run.fly(folder, 0, seed, frames, "".join(
            f"0 {way} ber {rate} {frames * cases.FRAME_US // 1000}\n" for way in ("up", "down")))
        if flown.returncode != 0:
            raise RuntimeError(flown.stderr)
        wire = (folder / "wire.csv").read_bytes()

    up = list(messages(wire, "up"))
    down = list(messages(wire, "down"))
    results = {}
    for way, blocks, answers, good in (
        ("up", up, down, (0x2D, 0xD2)), ("down", down, up, (0xD2,)),
    ):
        received, sent = answered_well(
            [block for block in blocks if len(block.content) > 1],
            [answer for answer in answers if len(answer.content) == 1], good)
        delays, counts = [], []
        # Blocks by the number of the frame their words were sampled in; the
        # board is given them a frame later.
        by_number = {
            int.from_bytes(content[1:3], "big")
            + (int.from_bytes(content[3:5], "big") << 12) - 1: content
            for content in sent}
        for number in range(20, frames - 20):
            content = by_number.get(number)
            counts.append(sent.get(content, 0))
            if content in received:
                put = (number + 1) * cases.FRAME_US + PUT_US
                delays.append((received[content] - put) / 1000)
            else:
                delays.append(None)
        results[f"{way}_delivered"] = mean(
            [delay is not None for delay in delays])
        results[f"{way}_sent"] = mean(counts)
        if way == "up":
            results["up_ms"] = mean(
                [delay for delay in delays if delay is not None])
    return results


def z_score(measured, expected, frames):
    """In standard errors. One event more or less is never a difference."""
    return abs(measured.value - expected) / max(measured.error, 1 / frames)


def table(points):
    yield ("| bit error rate | uplink delivered | sent, per block |"
           " latency, ms | downlink delivered | sent, per frame |")
    yield "|---|---|---|---|---|---|"
    for rate, expected, measured in points:
        yield " | ".join([f"| {rate}"] + [
            f"{expected[name]:.4f} / {measured[name].value:.4f}"
            f" ± {2.58 * measured[name].error:.4f}" for name in QUANTITIES
        ]) + " |"


def svg(points):
    """Delivered fractions and transmissions against the bit error rate."""
    left, top, width, height = 60, 20, 560, 300
    low, high = -6.0, -1.8

    def x(rate):
        return left + (math.log10(rate) - low) / (high - low) * width

    def y(value):
        return top + (2 - value) / 2 * height

    lines = [
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 375"'
        ' font-family="sans-serif" font-size="12">',
        '<rect width="640" height="375" fill="white"/>']
    for n in range(5):
        value = n / 2
        lines.append(
            f'<path d="M{left} {y(value):.1f}h{width}" stroke="#ddd"/>'
            f'<text x="{left - 8}" y="{y(value) + 4:.1f}"'
            f' text-anchor="end">{value}</text>')
    for power in range(-6, -1):
        at = x(10.0**power)
        lines.append(
            f'<path d="M{at:.1f} {top}v{height}" stroke="#ddd"/>'
            f'<text x="{at:.1f}" y="{top + height + 16}"'
            f' text-anchor="middle">1e{power}</text>')
    lines.append(f'<text x="{left + width / 2}" y="{top + height + 34}"'
                 ' text-anchor="middle">bit error rate; lines: theory;'
                 ' points: simulated, with 99% intervals</text>')
    for place, (name, colour, label) in enumerate((
        ("up_delivered", "#0b62a4", "uplink delivered"),
        ("up_sent", "#7a92a3", "uplink sent"),
        ("down_delivered", "#b1361e", "downlink delivered"),
        ("down_sent", "#d9a08f", "downlink sent"),
    )):
        steps = [10 ** (low + n * (high - low) / 200) for n in range(201)]
        path = " ".join(f"{x(rate):.1f},{y(theory(rate)[name]):.1f}"
                        for rate in steps)
        lines.append(f'<polyline points="{path}" fill="none"'
                     f' stroke="{colour}" stroke-width="1.5"/>')
        for rate, _, measured in points:
            at, point = x(float(rate)), measured[name]
            error = 2.58 * point.error
            lines.append(
                f'<path d="M{at:.1f} {y(point.value - error):.1f}'
                f'V{y(point.value + error):.1f}" stroke="{colour}"/>'
                f'<circle cx="{at:.1f}" cy="{y(point.value):.1f}" r="3"'
                f' fill="{colour}"/>')
        lines.append(f'<text x="{left + 10 + 135 * place}" y="372"'
                     f' fill="{colour}">{label}</text>')
    lines.append("</svg>")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--frames", type=int, default=50_000)
    parser.add_argument("--renew", action="store_true",
                        help="write table and plot into docs")
    chosen = parser.parse_args()
    frames = chosen.frames
    points = []
    for rate in RATES:
        points.append((rate, theory(float(rate)), measure(rate, frames)))
        print(rate, *(
            f"{name} {points[-1][1][name]:.5f} {point.value:.5f}"
            f" ({z_score(point, points[-1][1][name], frames):.1f})"
            for name, point in points[-1][2].items()), flush=True)
    made = "".join(f"{line}\n" for line in table(points))
    print(made, end="")
    if chosen.renew:
        renew(made, points)


def renew(made, points):
    (EVIDENCE / "link-errors.svg").write_text(svg(points), encoding="ascii")
    page = (EVIDENCE / "link.md").read_text(encoding="utf-8")
    begin, end = "<!-- make -C evidence theory -->\n", "<!-- end -->\n"
    before, rest = page.split(begin)
    after = rest.split(end)[1]
    (EVIDENCE / "link.md").write_text(before + begin + made + end + after,
                                  encoding="utf-8")


if __name__ == "__main__":
    main()
