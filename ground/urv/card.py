# SPDX-License-Identifier: Apache-2.0
"""bin/urv card: test cards for the aircraft (FTI-7)."""

from pathlib import Path
from typing import Annotated, Optional

import typer

app = typer.Typer(help="Check test cards, plot them, make their orders.")

FILE = Annotated[Path, typer.Argument(
    metavar="FILE", help="The cards, TOML: docs/flight-test.md.")]

BETWEEN_MS = 200
"""Between two orders; the node sends one in 100 ms."""


@app.command()
def check(
    file: FILE,
    plot: Annotated[Optional[Path], typer.Option(
        metavar="FILE", help="The inputs over time and their spectra, HTML.")
    ] = None,
):
    """Check the cards and print each with its length, size and words."""
    from urv import cards, whole_files

    read = cards.read(file)
    for each in read:
        for line in lines(each):
            print(line)
    if plot:
        from urv import card_page
        with whole_files.replacing(plot) as path:
            path.write_text(card_page.page(read, file.name), "utf-8")


@app.command()
def orders(
    file: FILE,
    begin_ms: Annotated[int, typer.Option(
        min=0, max=10_000_000, metavar="MS", help="Time of the first order.")
    ] = 3_000,
    choose: Annotated[Optional[int], typer.Option(
        min=1, max=8, metavar="SLOT", help="The card that runs first.")
    ] = None,
):
    """Print the orders that send the cards, for --orders of urv_sim, urv_gsc
    and bin/urv ground."""
    from urv import cards, faults

    read = cards.read(file)
    if choose and choose not in [each.slot for each in read]:
        raise faults.Refused(f"--choose: there is no card in slot {choose}")
    wanted = choose or read[0].slot
    for place, each in enumerate(
            [*read, cards.Card(slot=wanted, kind="choose")]):
        print(each.order(begin_ms + place * BETWEEN_MS))


def lines(card):
    """The card as text."""
    from urv import cards
    seconds = card.length / cards.FRAMES_PER_S
    largest = {each: abs(values).max()
               for each, values in card.signals().items()}
    yield (f"slot {card.slot}: {card.name or card.kind}: {seconds:g} s, "
           + ", ".join(f"{each.replace('_', ' ')} {size:.2f} deg"
                       for each, size in largest.items()))
    if card.kind == "multisine":
        shown = set()
        for surface in card.surfaces:
            found = tuple(card.harmonics(surface))
            if found not in shown:
                shown.add(found)
                yield (f"  {surface.replace('_', ' ')}: " + ", ".join(
                    f"{card.first * each / 100:g}" for each in found) + " Hz")
    limits = [text for text, is_set in (
        (f"bank {card.bank} deg", card.bank != cards.NO_LIMIT),
        (f"pitch {card.pitch} deg", card.pitch != cards.NO_LIMIT),
        (f"alpha {card.alpha} deg", card.alpha != cards.NO_LIMIT),
        (f"load 1 +- {card.load / 10:g} g", card.load != cards.NO_LIMIT),
        (f"airspeed {card.slowest / 32:g} to {card.fastest / 32:g} kt",
         (card.slowest, card.fastest) != (0, cards.FIELD)),
        (f"altitude from {card.lowest / 2:g} ft", card.lowest != 0))
        if is_set]
    yield "  envelope: " + (", ".join(limits) or "none")
    yield "  words: " + " ".join(map(str, card.words()))
