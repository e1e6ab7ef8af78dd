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
    """Check the cards and print their lengths, sizes and words."""
    from urv import cards, whole_files

    whole_files.check_distinct({"--plot": plot}, {"FILE": file})
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
    """Print the orders that send the cards.

    They are for --orders of urv_sim, urv_gsc and bin/urv ground."""
    for place, each in enumerate(chosen(file, choose)):
        print(each.order(begin_ms + place * BETWEEN_MS))


@app.command()
def programme(
    file: FILE,
    sticks: Annotated[Path, typer.Option(
        metavar="FILE", help="The stick script to write, for --sticks.")],
    orders: Annotated[Path, typer.Option(
        metavar="FILE", help="The orders to write, for --orders.")],
):
    """Write a simulated flight that runs each card once.

    It is for urv_sim: trimmed flight with hands off, the card, recovery by the
    control laws, and the next one."""
    from urv import card_programme, cards, whole_files

    whole_files.check_distinct({"--sticks": sticks, "--orders": orders},
                               {"FILE": file})
    made = card_programme.of(cards.read(file))
    for path, text in ((sticks, made.sticks), (orders, made.orders)):
        with whole_files.replacing(path) as kept:
            kept.write_text(text, "ascii")
    print(f"{made.seconds:g} s: bin/urv_sim fly --plant jsbsim --sticks"
          f" {shown(sticks)} --orders {shown(orders)}"
          f" --seconds {made.seconds:g}")


@app.command()
def send(
    file: FILE,
    console: Annotated[str, typer.Option(
        metavar="udp:HOST:PORT", help="As of urv_gsc --console.")
    ] = "udp:127.0.0.1:6004",
    choose: Annotated[Optional[int], typer.Option(
        min=1, max=8, metavar="SLOT", help="The card that runs first.")
    ] = None,
):
    """Send the cards to the ground's node of a flight.

    The node sends them up. While a console has the sticks, the node takes orders
    from its station only: send them from the page, or before."""
    import secrets
    import time

    from urv import faults, packets, station

    address = station.address("--console", console)
    deck = chosen(file, choose)
    run = secrets.randbits(32)
    out, there = station.sender_to("--console", address)
    try:
        with out:
            for place, each in enumerate(deck, 1):
                out.sendto(packets.CardPacket(
                    run, place, time.time_ns() // 1000,
                    each.words()).encode(), there)
                time.sleep(BETWEEN_MS / 1000)
    except OSError as fault:
        raise faults.Refused(
            f"--console {console}: {faults.reason(fault)}") from fault
    print(f"{len(deck) - 1} cards sent to {console}; the aircraft reads them"
          " back in its log")


def shown(path):
    """A path as a command line has it, without control characters."""
    import shlex
    from urv import faults

    text = str(path)
    return shlex.quote(text) if text.isprintable() else faults.quoted(text)


def chosen(file, choose):
    """The cards of a file, and the order that chooses the first one."""
    from urv import cards, faults

    read = cards.read(file)
    if choose and choose not in [each.slot for each in read]:
        raise faults.Refused(f"--choose: there is no card in slot {choose}")
    return [*read, cards.Card(slot=choose or read[0].slot, kind="choose")]


def lines(card):
    """The card as text."""
    from urv import faults

    largest = {each: abs(values).max()
               for each, values in card.signals().items()}
    place = "" if card.place == "servo" else f" {card.place}"
    name = faults.quoted(card.name) if card.name else card.kind
    yield (f"slot {card.slot}: {name}: {card.seconds:g} s, "
           + ", ".join(f"{each.replace('_', ' ')}{place} {size:.2f}"
                       f" {card.unit(each)}"
                       for each, size in largest.items()))
    if card.kind == "multisine":
        shown = set()
        for surface in card.surfaces:
            found = tuple(card.harmonics(surface))
            if found not in shown:
                shown.add(found)
                yield (f"  {surface.replace('_', ' ')}: " + ", ".join(
                    f"{card.first * each / 100:g}" for each in found) + " Hz")
    yield "  envelope: " + card.envelope()
    yield "  words: " + " ".join(map(str, card.words()))
