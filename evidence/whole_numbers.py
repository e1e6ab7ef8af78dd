# SPDX-License-Identifier: Apache-2.0
"""Whole numbers within bounds, as arguments of a command. A measurement of
nothing must not seem to be a good one.

    parser.add_argument("--flights", type=whole(1), default=100)
"""

import argparse


def whole(least, most=None):
    """The type of such an argument."""
    bounds = f"at least {least}" if most is None else f"{least} to {most}"

    def number(text):
        try:
            value = int(text)
        except ValueError:
            value = None
        if value is None or value < least or (
                most is not None and value > most):
            raise argparse.ArgumentTypeError(f"{text}: not {bounds}")
        return value

    return number
