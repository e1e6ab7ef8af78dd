#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compare the tags of bin/urv_seal with those of libsodium (SEC-2).

    evidence/seal_tags.py [NUMBER] [SEED]    a million random messages

evidence/seal/urv_seal.gpr builds the program.
Exit status: 0 all are the same; 1 one is not.
"""

import argparse
import random
import subprocess
import sys
from pathlib import Path

from nacl.bindings import crypto_shorthash_siphash24 as siphash

from whole_numbers import whole

TOOL = Path(__file__).resolve().parent.parent / "bin" / "urv_seal"
AT_ONCE = 50_000


def main(number=1_000_000, seed=1):
    drawn = random.Random(seed)
    for done in range(0, number, AT_ONCE):
        cases = [(drawn.randbytes(16), drawn.randbytes(drawn.randrange(64)))
                 for _ in range(min(AT_ONCE, number - done))]
        lines = "".join(f"{key.hex()} {message.hex()}\n"
                        for key, message in cases)
        found = subprocess.run([TOOL, "tags"], input=lines, text=True,
                               capture_output=True, check=True).stdout
        for (key, message), tag in zip(cases, found.split(), strict=True):
            if int(tag) != int.from_bytes(siphash(message, key), "little"):
                print(f"key {key.hex()}, message {message.hex()}: {tag}")
                return 1
    print(f"{number} tags, all the same")
    return 0


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("number", type=whole(1), nargs="?",
                        default=1_000_000, help="of messages (a million)")
    parser.add_argument("seed", type=int, nargs="?", default=1)
    given = parser.parse_args()
    if not TOOL.exists():
        sys.exit(f"seal_tags.py: missing: {TOOL.relative_to(TOOL.parents[1])}:"
                 " gprbuild -p -P evidence/seal/urv_seal.gpr builds it")
    return given.number, given.seed


if __name__ == "__main__":
    sys.exit(main(*arguments()))
