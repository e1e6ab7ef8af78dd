# SPDX-License-Identifier: Apache-2.0
"""The blocks of format 2 on the wire, by docs/security.md. Tags are not
looked at here: test_seal has a flight whose tags a library finds.
"""

from cases import FRAME_US, NUMBERS

SEALED, HELLO = 0xA, 0xB

# An uplink has these low bits of its number, which is a frame's.
TOLD = {"up": 1 << 6, "down": 1 << 24}

# The high half of the first byte in format 1: no bits of the first command; the
# mark of a frame, or none after a failed self-test.
MARKS = {"up": (0,), "down": (0, 5)}

# A good status of the node that received.
ANSWERED_BY = {"up": ("down", (0x2D, 0xD2)), "down": ("up", (0xD2,))}


def number_of(block, way):
    if way == "up":
        return (block[20] & 15) << 2 | block[21] >> 6
    return int.from_bytes(block[45:48], "big")


def marked(blocks, way):
    """Blocks that are not of format 1."""
    for block in blocks:
        if block[0] >> 4 not in MARKS[way]:
            yield f"a block of format 1 begins with {block[0]:02x}"
            return


def wrongs(blocks, way):
    """Violations of the order in which blocks are sent: hellos first, then
    only sealed ones, each with a higher number, or the same one again."""
    last = None
    for block in blocks:
        mark = block[0] >> 4
        if mark == HELLO and last is None:
            continue
        if mark != SEALED:
            yield (f"a block begins with {block[0]:02x}"
                   f" {'before' if last is None else 'after'} the first sealed")
            return
        if block == last:
            continue
        ahead = (number_of(block, way) - (number_of(last, way) if last else 0)
                 ) % TOLD[way]
        if not 0 < ahead < TOLD[way] // 2:
            yield (f"block {number_of(block, way)} after"
                   f" {number_of(last, way) if last else 'none'}")
            return
        last = block


def came_twice(said, phase):
    """How many sealed blocks were received whole once more after their
    receiver had taken them: the answer was lost, and they were sent again. The
    receiver looks as its frame begins, and takes the newest; what is answered
    just then is there already."""
    count = 0
    for way, (receiver, good) in ANSWERED_BY.items():
        frame_begins = NUMBERS.tick_us * phase if way == "up" else 0
        answers = [at for at, message in said[receiver] if message[0] in good]
        blocks = [(at, message) for at, message in said[way]
                  if len(message) > 1]
        found, place = {}, 0
        for at in answers:
            while place < len(blocks) and blocks[place][0] < at:
                place += 1
            if place:
                found[(at - frame_begins - 1) // FRAME_US] = blocks[place - 1][1]
        taken = set()
        for block in found.values():
            if block[1] >> 4 == SEALED:
                count += block in taken
                taken.add(block)
    return count
