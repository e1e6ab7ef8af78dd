#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Explores how controller and telemetry board, two MC68000s, may share the
dual-ported memory: all orders of their accesses with few switches (BRD-8;
mc68000/exploration/explore.c).

    targets/explorations.py [SWITCHES]
    targets/explorations.py SCENARIO BEGINNER [SWITCH ...]

The second command makes one run again, and prints each access to the memory; the
first one prints it for a wrong run. Exit status: 0 when each run has the results of
the same operations one after the other.
"""

import re
import subprocess
import sys

import emulated

FOLDER = emulated.MC68000_BOARD.images
SWITCHES = 2

CONTROLLER, BOARD = 0, 1

# Orders for exploration_program.adb
(INITIALISE, PUT, TAKE, DISCARD, CLEAR, HAS_RECEIVED, TALLY, ACCEPT, NEXT,
 START) = range(1, 11)
GROUND, AIRCRAFT = 0, 1

DATA, COMMAND, GOOD, BAD = 0xB4, 0x4B, 0xD2, 0xCC
GUARD_TIME, DEAD_SPACE = 3, 30


def order(operation, data=0, time=0):
    return operation | time << 8 | data << 16


def put(block):
    return order(PUT, block)


def hear(character):
    return order(ACCEPT, character, time=1)


def speak(time=1):
    return order(NEXT, time=time)


def checksum(characters):
    value = 0
    for each in characters:
        value ^= each
        for _ in range(8):
            value = value >> 1 ^ (0x9C if value & 1 else 0)
    return value


def message(block):
    """The orders to hear a block of four equal bytes, but for its judgement."""
    characters = [DATA] + 4 * [block]
    return [hear(each) for each in characters + [checksum(characters)]]


def received(block):
    return message(block) + [speak(GUARD_TIME), speak(), speak(), speak()]


# A board's role, what it did before, and what it does now beside the
# controller. Before, the controller has put a block if PUT_BEFORE says so.
MOMENTS = {
    "first_block_ends": (AIRCRAFT, 0, message(1)[:-1],
                         [message(1)[-1], speak(GUARD_TIME)]),
    "second_block_ends": (AIRCRAFT, 0, received(1) + message(2)[:-1],
                          [message(2)[-1], speak(GUARD_TIME)]),
    "third_block_ends": (AIRCRAFT, 0, received(1) + received(2) + message(3),
                         [speak(GUARD_TIME)]),
    "third_block_comes": (AIRCRAFT, 0, received(1) + received(2),
                          message(3)[:2]),
    "block_begins": (GROUND, 1, [], [speak(), speak()]),
    "new_block_begins": (GROUND, 2, [], [speak(), speak()]),
    "downlink_begins": (AIRCRAFT, 1, [], [hear(COMMAND), speak(), speak()]),
    "good_status": (GROUND, 1, 7 * [speak()], [hear(GOOD), speak()]),
    "bad_status": (GROUND, 1, 7 * [speak()], [hear(BAD), speak()]),
    "no_status": (GROUND, 1, 7 * [speak()], [speak(DEAD_SPACE)]),
    "second_bad_status": (GROUND, 1,
                          7 * [speak()] + [hear(BAD)] + 7 * [speak()],
                          [hear(BAD), speak()]),
    "start": (AIRCRAFT, 1, received(1), [order(START)]),
    "start_while_sending": (GROUND, 1, 3 * [speak()], [order(START)]),
}

OPERATIONS = {
    "put": [put(0x71)], "put_twice": [put(0x71), put(0x72)],
    "take": [order(TAKE)], "discard": [order(DISCARD)],
    "clear": [order(CLEAR)], "has_received": [order(HAS_RECEIVED)],
    "tally": [order(TALLY)]}

# Then both report all that they have.
AFTER = [
    (CONTROLLER, [order(HAS_RECEIVED), order(TAKE), order(TAKE),
                  order(TALLY)]),
    (BOARD, [speak() for _ in range(10)] + [speak(DEAD_SPACE)] +
     [hear(COMMAND)] + [speak() for _ in range(8)]),
    (CONTROLLER, [order(TALLY)])]


def line(kind, processor, orders):
    return f"{kind} {processor} " + " ".join(f"{each:x}" for each in orders)


def scenarios(moments=MOMENTS, operations=OPERATIONS):
    for moment, (role, blocks, before, now) in moments.items():
        for operation, orders in operations.items():
            yield f"scenario {operation}_as_{moment}"
            yield line("before", CONTROLLER, [order(INITIALISE, role)] + [
                put(0x61 + each) for each in range(blocks)])
            yield line("before", BOARD, before)
            yield line("both", CONTROLLER, orders)
            yield line("both", BOARD, now)
            for processor, each in AFTER:
                yield line("after", processor, each)
            yield "end"


def explored(switches=SWITCHES, divided=False, folder=FOLDER, chosen=None):
    """The line of each scenario by its name, and the names of the wrong ones."""
    done = subprocess.run(
        [FOLDER / "explore", folder / "exploration.bin", str(switches),
         "divided" if divided else "whole"],
        input="\n".join(chosen or scenarios()) + "\n", text=True,
        capture_output=True, check=False)
    lines = {each.split()[0]: each for each in done.stdout.splitlines()}
    wrong = {name for name, each in lines.items() if each.endswith("WRONG")}
    if done.returncode not in (0, 1) or (done.returncode == 1) != bool(wrong):
        raise RuntimeError(done.stderr)
    return lines, wrong


WRONG_RUN = re.compile(r" wrong: begins (\d), switches((?: \d+)*);")


def command(name, line_of_wrong):
    """The command that makes the wrong run of a scenario again."""
    beginner, switches = WRONG_RUN.search(line_of_wrong).groups()
    return f"targets/explorations.py {name} {beginner}{switches}"


def again(name, beginner, switches=(), divided=False, folder=FOLDER):
    """The exit status of one run, and a line for each of its accesses."""
    lines = list(scenarios())
    begin = lines.index(f"scenario {name}")
    done = subprocess.run(
        [FOLDER / "explore", folder / "exploration.bin", str(len(switches)),
         "divided" if divided else "whole", beginner, *switches],
        input="\n".join(lines[begin:lines.index("end", begin) + 1]) + "\n",
        text=True, capture_output=True, check=False)
    if done.returncode not in (0, 1):
        raise RuntimeError(done.stderr)
    return done.returncode, done.stdout


def number(name, text):
    return int(re.search(rf" {name} (\d+)", text)[1])


def main():
    name, *more = sys.argv[1:] or [str(SWITCHES)]
    is_again = f"scenario {name}" in scenarios()
    if not all(each.isdigit() for each in more) or bool(more) != is_again or (
            not is_again and not name.isdigit()):
        sys.exit(__doc__)
    for each in ("explore", "exploration.bin"):
        if not (FOLDER / each).exists():
            sys.exit(f"explorations.py: missing: {each}:"
                     " targets/mc68000/musashi/build_board.sh and"
                     " targets/build.sh mc68000 exploration make both")
    try:
        if is_again:
            status, text = again(name, more[0], more[1:])
            print(text, end="")
            return status
        lines, wrong = explored(int(name))
    except RuntimeError as error:
        sys.exit(f"explorations.py: {error}".strip())
    for each in lines.values():
        print(each)
    for each in sorted(wrong):
        print(f"again: {command(each, lines[each])}")
    print(f"{len(lines)} scenarios, {len(wrong)} wrong,"
          f" {sum(number('runs', each) for each in lines.values()):,} runs")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
