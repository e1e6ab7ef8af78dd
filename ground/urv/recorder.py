# SPDX-License-Identifier: Apache-2.0
"""bin/urv recorder: the rows of the aircraft's flight recorder (FTI-10)."""

from pathlib import Path
from typing import Annotated, Optional

import typer

app = typer.Typer(help="Fetch the aircraft's flight recorder.")

OUT = Annotated[Path, typer.Argument(
    metavar="FILE", help="The recording to write, FILE.recording.")]

ROWS_AT_ONCE = 100
"""Of a request: a lost one costs little."""

SILENCE_S = 1.0
"""Without a block for longer, the aircraft is asked again."""

QUIET_REQUESTS = 15
"""Requests without any block in answer, before the fetch is given up."""

MOST_WRONG = 4
"""A row that has come whole so often with wrong sums is wrong aboard."""

GAP = 3
"""Rows that are asked for once more, rather than with a request of their
own."""


@app.command()
def fetch(
    file: OUT,
    console: Annotated[str, typer.Option(
        metavar="udp:HOST:PORT", help="As of urv_gsc --console.")
    ] = "udp:127.0.0.1:6004",
    last: Annotated[Optional[float], typer.Option(
        min=0.02, metavar="S", help="Only the newest seconds.")] = None,
):
    """Fetch the recorder's rows from the aircraft, which is on the ground.

    Status 0: all rows have come. Status 1: some are missing; FILE has the
    others, and the missing ones are named."""
    from urv import faults, recorder_blocks, recordings, whole_files

    check_name(file)
    rows = recorder_blocks.Rows()
    with Node(console) as node:
        first, end, reason = fetched(node, rows, last)
    with whole_files.replacing(file) as path:
        recordings.write(path, rows.in_order())
    missing = rows.missing(first, end)
    print(f"{len(rows.rows)} of {end - first} rows fetched, {first} to"
          f" {end - 1}")
    if missing:
        raise faults.Failed(
            f"{len(missing)} rows are missing ({named(missing)}): {reason}")


@app.command()
def read(
    blocks: Annotated[Path, typer.Argument(
        metavar="BLOCKS", help="As written by urv_sim --fetched.")],
    file: OUT,
):
    """Make a recording of the blocks that came down in a simulated flight."""
    from urv import faults, input_files, recorder_blocks, recordings, \
        whole_files

    check_name(file)
    rows = recorder_blocks.Rows()
    with input_files.opened_text(blocks) as source:
        while line := source.readline(4 * (recorder_blocks.BLOCK_WORDS + 1)
                                      + 2):
            try:
                kind, *words = (int(line[at:at + 4], 16) for at
                                in range(0, len(line.rstrip("\n")), 4))
            except ValueError as fault:
                raise faults.Refused(
                    f"{faults.quoted(blocks)}: not a file of --fetched"
                ) from fault
            rows.take(kind, words)
    with whole_files.replacing(file) as path:
        recordings.write(path, rows.in_order())
    print(f"{len(rows.rows)} rows, {len(rows.parts)} others not whole")


def check_name(file):
    from urv import faults, recordings

    if file.suffix != recordings.KIND:
        raise faults.Refused(f"{faults.quoted(file)}: a recording's name ends"
                             f" with {recordings.KIND}")


def named(numbers):
    """Numbers of rows as text."""
    from urv import recorder_blocks

    spans = [f"{first}" if many == 1 else f"{first} to {first + many - 1}"
             for first, many in recorder_blocks.spans(numbers)]
    return ", ".join(spans[:5]) + (", ..." if len(spans) > 5 else "")


class Node:
    """The ground's node: requests go to its console's port."""

    def __init__(self, console):
        from urv import station

        self.console = console
        self.address = station.address("--console", console)
        self.sequence = 0

    def __enter__(self):
        import secrets
        import socket

        from urv import faults

        self.run = secrets.randbits(32)
        family = (socket.AF_INET6 if ":" in self.address[0]
                  else socket.AF_INET)
        self.socket = socket.socket(family, socket.SOCK_DGRAM)
        try:
            self.socket.connect(self.address)
        except OSError as fault:
            self.socket.close()
            raise faults.Refused(
                f"--console {self.console}: {fault}") from fault
        return self

    def __exit__(self, *_):
        self.socket.close()

    def ask(self, first, many):
        """Sends a request."""
        import time

        from urv import faults, packets, recorder_blocks

        self.sequence += 1
        try:
            self.socket.send(packets.RequestPacket(
                self.run, self.sequence, time.time_ns() // 1000,
                recorder_blocks.request(first, many)).encode())
        except ConnectionRefusedError as fault:
            raise faults.Failed(
                f"--console {self.console}: nothing listens there"
            ) from fault

    def block(self):
        """The next block, kind and words, or None after a silence."""
        from urv import faults, packets

        self.socket.settimeout(SILENCE_S)
        while True:
            try:
                data = self.socket.recv(256)
            except TimeoutError:
                return None
            except ConnectionRefusedError as fault:
                raise faults.Failed(
                    f"--console {self.console}: nothing listens there"
                ) from fault
            try:
                return packets.decode_recorder(data)
            except packets.PacketError:
                continue


def asked(node, rows, first, many):
    """Asks for rows and takes what comes, until all have come or nothing
    more does. The number of blocks."""
    from urv import recorder_blocks

    before, blocks = rows.reports, 0
    node.ask(first, many)
    while found := node.block():
        rows.take(*found)
        blocks += 1
        if rows.reports > before and (
                many == 0 or rows.report.answer != 0
                or not rows.missing(first, first + many)):
            break
        if (found[0] == recorder_blocks.ROWS and many
                and is_last(found[1], first + many - 1)):
            break
    return blocks


def is_last(words, number):
    """The block is the last one of that row."""
    return (words[0] >> 10 == 3
            and (words[0] & 0x3FF) << 12 | words[1] == number)


def fetched(node, rows, last):
    """The first row, the one after the last, and the reason for missing
    ones."""
    from urv import faults, recorder_blocks

    for _ in range(QUIET_REQUESTS):
        asked(node, rows, 0, 0)
        if rows.report:
            break
    else:
        raise faults.Failed(
            "no answer: the link is lost, or the aircraft has no recorder")
    report = rows.report
    if report.answer == 1:
        raise faults.Failed(f"refused: {recorder_blocks.ANSWERS[1]}")
    end = report.first + report.held
    first = report.first
    if last is not None:
        first = max(first, end - max(1, round(last / 0.02)))
    return first, end, complete(node, rows, first, end)


def complete(node, rows, first, end):
    """Asks until no row is missing; the reason, if one still is."""
    from urv import recorder_blocks

    quiet = 0
    while wanted := [number for number in rows.missing(first, end)
                     if rows.wrong.get(number, 0) < MOST_WRONG]:
        begin, many = joined(recorder_blocks.spans(wanted))
        came = asked(node, rows, begin, min(many, ROWS_AT_ONCE))
        if rows.report.answer == 1:
            return recorder_blocks.ANSWERS[1]
        if rows.report.first > begin:
            return "the aircraft does not hold them any more"
        if rows.report.first + rows.report.held < end:
            return "the aircraft had a cold start"
        quiet = 0 if came else quiet + 1
        if quiet == QUIET_REQUESTS:
            return "the aircraft does not answer any more"
    return "their sums are wrong aboard"


def joined(spans):
    """The first span with those that follow closely."""
    begin, many = spans[0]
    for first, more in spans[1:]:
        if first - begin - many > GAP:
            break
        many = first + more - begin
    return begin, many
