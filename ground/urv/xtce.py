# SPDX-License-Identifier: Apache-2.0
"""bin/urv xtce: the frame packet as a mission database (GND-12, GND-34).

XTCE, as Yamcs reads it. The packet's layout is that of urv.packets; units,
calibrators and limits are those of urv.items.

A caution is WARNING there and a warning CRITICAL: XTCE's names for the same.
Words of the downlink are taken only while they are fresh. An old value
therefore goes out of date, and no limit applies to it.
"""

import re
from pathlib import Path
from typing import Annotated

import typer

from urv import deck, items, laws, packets, whole_files

SYSTEM = "URV"
CONTAINER = "frame"

# In Yamcs a parameter is out of date when it was not received for 1.9 times
# the expected time between two packets: here after 0.285 s.
EXPECTED_EVERY_S = 0.15
OUT_OF_DATE_S = 1.9 * EXPECTED_EVERY_S

# Yamcs checks for such parameters only once a second. Another parameter
# therefore reports a gap at once: ten frames, and the watch's interval. Each
# check is a task of the one thread that all timers of Yamcs's processor share.
MISSING_AFTER_S = 0.2
WATCHED_EVERY_S = 0.05
FRAMES = ("coming", "MISSING")
WATCH = """
        org.yamcs.mdb.ProcessorData here = execCtx.getProcessorData();
        org.yamcs.Processor processor = org.yamcs.YamcsServer.getServer()
            .getProcessor(here.getYamcsInstance(), here.getProcessorName());
        boolean come = processor != null && sequence != null;
        if (come) {{
            long now = processor.getCurrentTime();
            long ahead = clock_ahead == null ? 0L : Math.round(
                1000.0 * clock_ahead.getEngValue().toDouble());
            long made = sequence.getGenerationTime() + ahead;
            come = now - sequence.getAcquisitionTime() <= {milliseconds}
                && now - made <= {milliseconds};
        }}
        frames.setStringValue(come ? "{coming}" : "{missing}");
"""

HEADER = (
    ("magic", 32, "55525646h"), ("version", 16, "of the packet"),
    ("length", 16, "of the packet, in bytes"),
    ("run", 32, "another number with each start of the ground's program"),
    ("sequence", 32, "the major frame, from 0"))

# The bits of an error word, from the last one, and the level when set.
ERROR_BITS = (
    ("stale", "WATCH", "the words before are those of an earlier scan"),
    ("rom_differs", "CRITICAL", "the ROM differs from what was loaded"),
    ("self_test_failed", "CRITICAL", "before the start"))

LOG_ROW = (("count", 32, "how often"), ("first_frame", 32, "of its node"),
           ("last_frame", 32, "of its node"),
           ("detail", 16, "of the last one"))
FRAME_MEANINGS = {
    "number": "of the aircraft's frame, modulo 4096",
    "card": "the card that runs, 0: none",
    "phase": "frame of the running card modulo 16, or why the last one ended"}
WORD_BITS = 16

# After a start the laws reject every sensor for a second, and the report of
# that takes another one: no reason for 27 alarms.
STARTS_FRAMES = 125


def xtce(
    output: Annotated[Path, typer.Option(
        "-o", "--output", metavar="FILE", help="The file to write.")],
):
    """Write the mission database, for Yamcs.

    The frame packet as XTCE: every field, calibrated, with limits.
    """
    text = mission_database()
    with whole_files.replacing(output) as path:
        path.write_text(text, encoding="utf-8")


def mission_database() -> str:
    """The text of the file."""
    from yamcs import pymdb

    system = pymdb.System(
        SYSTEM, short_description="Flight controller and ground station")
    pymdb.Container(
        system, CONTAINER, list(_Entries(pymdb, system)),
        bits=8 * packets.FRAME_LENGTH, rate=EXPECTED_EVERY_S,
        short_description="Contents of GSC CORE at the end of a major frame")
    _watch_frames(pymdb, system)
    text = system.dumps(top_comment="bin/urv xtce wrote this.") + "\n"
    # pymdb has no trigger of this kind.
    return re.sub(r"<OnParameterUpdateTrigger [^>]*/>",
                  "<OnPeriodicRateTrigger"
                  f' fireRateInSeconds="{WATCHED_EVERY_S}"/>', text)


def _watch_frames(pymdb, system):
    """Reports whether frames arrive, even while none does. Late frames do not
    count as present (GND-56): the station gives the difference between the
    clock of their times and this machine's."""
    clock = pymdb.FloatParameter(
        system, "clock_ahead", bits=64, units="s",
        data_source=pymdb.DataSource.LOCAL, initial_value=0.0,
        persistent=False,
        short_description="difference from the time of a frame to the UTC of"
        " this machine; the station sets it")
    frames = pymdb.EnumeratedParameter(
        system, "frames", list(enumerate(FRAMES)),
        data_source=pymdb.DataSource.DERIVED,
        short_description="whether frame packets come",
        alarm=pymdb.EnumerationAlarm(
            {FRAMES[1]: pymdb.AlarmLevel.CRITICAL}))
    pymdb.Algorithm(
        system, "watch_frames", language="java-expression",
        text=WATCH.format(milliseconds=round(1000 * MISSING_AFTER_S),
                          coming=FRAMES[0], missing=FRAMES[1]),
        inputs=[pymdb.InputParameter("sequence"),
                pymdb.InputParameter(clock)],
        outputs=[pymdb.OutputParameter(frames)],
        triggers=[pymdb.ParameterTrigger("sequence")])


class _Entries:
    """The entries of the packet, in order. Parameters belong to a subsystem
    for each group of the record's columns, and for link, log and status."""

    def __init__(self, pymdb, system):
        self.pymdb = pymdb
        self.system = system
        self.age = None
        self.version = None

    def __iter__(self):
        yield from self.header()
        yield from self.whole_numbers("link", 32, packets.LINK_COUNTS)
        for column in packets.COLUMNS:
            yield from self.word(column)
        for node in packets.NODES:
            yield from self.log(node)
        yield from self.whole_numbers("status", 16, packets.STATUS,
                                      bitpos=8 * packets.TAIL_AT)
        yield self.choice("pilot", packets.Pilot)
        yield from self.law_words()
        yield from self.card_words()
        yield self.refused()
        yield from self.frame_words()

    def refused(self):
        """From the ground's log once more: the number of blocks it has
        refused. Any is a caution."""
        row = packets.KINDS.index("block_refused") + 1
        return self.pymdb.ParameterEntry(
            self.pymdb.IntegerParameter(
                self.subsystem("link"), "blocks_refused", signed=False,
                short_description="blocks that the ground did not take",
                alarm=self.pymdb.ThresholdAlarm(warning_high=0),
                encoding=self.encoding(32)),
            bitpos=8 * packets.row_at("gsc", row),
            condition=self.pymdb.gte(self.version, packets.WHOLE))

    def frame_words(self):
        """The frame of the downlink (FTI-12)."""
        pymdb = self.pymdb
        system = self.subsystem("frame")
        comes = pymdb.all_of(pymdb.gte(self.version, packets.FRAMED),
                             pymdb.eq(self.age, 0))
        for place, name in enumerate(packets.FRAME_WORDS):
            yield self.whole_number(
                system, name, WORD_BITS, FRAME_MEANINGS.get(
                    name, "servo word of the aircraft")
                + f", {packets.UNKNOWN_WORD}: unknown",
                8 * packets.FRAME_AT + place * WORD_BITS, comes)

    def subsystem(self, path):
        """The subsystem of that dotted name, made when there is none."""
        found = self.system
        for name in path.split("."):
            there = {each.name: each for each in found.subsystems}
            found = there.get(name) or self.pymdb.Subsystem(found, name)
        return found

    def encoding(self, bits):
        return self.pymdb.IntegerEncoding(bits=bits)

    def whole_number(self, system, name, bits, description=None, bitpos=None,
                     condition=None):
        return self.pymdb.ParameterEntry(self.pymdb.IntegerParameter(
            system, name, signed=False, short_description=description,
            encoding=self.encoding(bits)), bitpos=bitpos,
            condition=condition)

    def whole_numbers(self, path, bits, names, bitpos=None):
        system = self.subsystem(path)
        for name in names:
            yield self.whole_number(system, name, bits, bitpos=bitpos)
            bitpos = None

    def choice(self, name, choices, alarm=None):
        """The alarm is one of the choices and its level."""
        def word(each):
            return each.name.lower().replace("_", " ")

        return self.pymdb.ParameterEntry(self.pymdb.EnumeratedParameter(
            self.system, name,
            [(each.value, word(each)) for each in choices],
            alarm=None if alarm is None else self.pymdb.EnumerationAlarm(
                {word(alarm[0]): self.pymdb.AlarmLevel[alarm[1]]}),
            encoding=self.encoding(16)))

    def header(self):
        for name, bits, description in HEADER:
            entry = self.whole_number(self.system, name, bits, description)
            if name == "version":
                self.version = entry.parameter
            yield entry
        yield self.pymdb.ParameterEntry(self.pymdb.AbsoluteTimeParameter(
            self.system, "time", self.pymdb.Epoch.UNIX,
            short_description="UTC, when the frame's words were taken",
            encoding=self.pymdb.IntegerTimeEncoding(bits=64, scale=1e-6)))
        age = self.whole_number(
            self.system, "downlink_age", 32,
            "frames since the downlink's words were fresh")
        self.age = age.parameter
        yield age
        yield self.choice("console_state", packets.ConsoleState)
        yield self.choice("link_state", packets.LinkState, alarm=(
            packets.LinkState.LOST, "CRITICAL"))
        yield self.whole_number(
            self.system, "console_sequence", 32,
            "of the console packet whose words are at the converter")

    def word(self, column):
        group, _, name = column.rpartition(".")
        item = items.COLUMNS[column]
        system = self.subsystem(group)
        if not item.is_scaled:
            at = self.position(column)
            yield self.whole_number(system, name, 16, "bits", bitpos=at)
            yield from self.error_bits(system, at)
            return
        alarm = None
        if item.limits:
            alarm = self.pymdb.ThresholdAlarm(
                critical_low=item.warning_low, warning_low=item.caution_low,
                warning_high=item.caution_high,
                critical_high=item.warning_high)
        is_downlink = group == "gsc.downlink"
        parameter = self.pymdb.FloatParameter(
            system, name, bits=64, units=item.unit,
            short_description=item.label, alarm=alarm,
            encoding=self.encoding(16),
            calibrator=self.pymdb.Polynomial(
                [0.0 - item.per_word * item.zero_word, item.per_word]))
        yield self.pymdb.ParameterEntry(
            parameter, bitpos=self.position(column),
            condition=(self.pymdb.eq(self.age, 0) if is_downlink else None))

    @staticmethod
    def position(column):
        """In bits. Each word needs it: by default Yamcs continues after the
        last entry present."""
        return 8 * (packets.WORDS_AT + 2 * packets.COLUMNS.index(column))

    def error_bits(self, system, word_at):
        """Each bit as a parameter, from the same word."""
        for bit, (name, level, meaning) in enumerate(ERROR_BITS):
            yield self.flag(system, name, word_at, bit, level,
                            description=meaning)

    def flag(self, system, name, word_at, bit, level, yes="yes",
             description=None, condition=None, frames=1):
        """A bit of the word, the last one is 0; its level after this number of
        successive frames with the bit set."""
        return self.pymdb.ParameterEntry(
            self.pymdb.EnumeratedParameter(
                system, name, [(0, "no"), (1, yes)],
                short_description=description,
                alarm=self.pymdb.EnumerationAlarm(
                    {yes: self.pymdb.AlarmLevel[level]},
                    minimum_violations=frames),
                encoding=self.encoding(1)),
            bitpos=word_at + WORD_BITS - 1 - bit, condition=condition)

    def log(self, node):
        """A row for each kind of error; the last ones of the packet are
        empty."""
        system = self.subsystem(f"log.{node}")
        for row, kind in enumerate(packets.KINDS, 1):
            yield self.pymdb.ParameterEntry(
                self.pymdb.AggregateParameter(system, kind, [
                    self.pymdb.IntegerMember(
                        name, signed=False, short_description=description,
                        encoding=self.encoding(bits))
                    for name, bits, description in LOG_ROW]),
                bitpos=8 * packets.row_at(node, row),
                condition=(self.pymdb.gte(self.version, packets.WHOLE)
                           if row > packets.FIRST_ROWS else None))

    def card_words(self):
        """The status of the aircraft's test cards (FTI-8): urv.deck."""
        pymdb = self.pymdb
        at = 8 * packets.row_at("mcs", packets.CARDS_ROW)
        comes = pymdb.all_of(pymdb.gte(self.version, packets.WHOLE),
                             pymdb.eq(self.age, 0))
        system = self.subsystem("cards")
        # The first word's nibbles, from the highest.
        yield pymdb.ParameterEntry(
            pymdb.EnumeratedParameter(
                system, "ended", list(enumerate(deck.VERDICTS)),
                alarm=pymdb.EnumerationAlarm({
                    reason: pymdb.AlarmLevel.WATCH
                    for reason in deck.VERDICTS
                    if reason not in deck.EXPECTED}),
                encoding=self.encoding(deck.NIBBLE)),
            bitpos=at, condition=comes)
        for place, (name, what) in enumerate((
                ("last", "the card that ran last, 0: none"),
                ("running", "the card that runs, 0: none"),
                ("chosen", "the card of the next run, 0: none")), 1):
            yield self.whole_number(system, name, deck.NIBBLE, what,
                                    at + place * deck.NIBBLE, comes)
        yield self.whole_number(system, "frame", WORD_BITS,
                                "of the card that runs, from 0",
                                at + WORD_BITS, comes)

    def law_words(self):
        """The status of the aircraft's control laws: urv.laws."""
        pymdb = self.pymdb
        at = 8 * packets.row_at("mcs", packets.LAWS_ROW)
        comes = pymdb.all_of(pymdb.gte(self.version, packets.WHOLE),
                             pymdb.eq(self.age, 0))
        system = self.subsystem("laws")
        # The first word's nibbles, from the highest.
        for place, (name, names) in enumerate((
                ("link", laws.LINK), ("power", laws.POWER),
                ("vertical", laws.VERTICAL), ("lateral", laws.LATERAL))):
            alarm = None if name != "link" else pymdb.EnumerationAlarm(
                {label: pymdb.AlarmLevel.CRITICAL for label in laws.ALONE})
            yield pymdb.ParameterEntry(
                pymdb.EnumeratedParameter(
                    system, name, list(enumerate(names)), alarm=alarm,
                    encoding=self.encoding(laws.NIBBLE_BITS)),
                bitpos=at + place * laws.NIBBLE_BITS, condition=comes)
        for word, (name, what) in enumerate((
                ("not_valid_low", "a bit for each of the first sensors"),
                ("not_valid_high", "for the others"),
                ("silent", "frames without an uplink"),
                ("failed", "a bit for each surface"),
                ("age", "of the aircraft's node since its cold start, in"
                 " 16 frames")), 1):
            yield self.whole_number(system, name, WORD_BITS, what,
                                    at + word * WORD_BITS, comes)
        # The last word: the number is above four bits with the table.
        at_last = at + (items.of_buffer("laws")[-1].position - 1) * WORD_BITS
        for name, bits, place, what in (
                ("configuration", WORD_BITS, 0,
                 "that was taken last: its number times 16, and its table"),
                ("configuration_number", WORD_BITS - laws.NIBBLE_BITS, 0,
                 "of the one that was taken last, 0 when none was"),
                ("gains_table", laws.NIBBLE_BITS,
                 WORD_BITS - laws.NIBBLE_BITS, "that it has set")):
            yield self.whole_number(system, name, bits, what,
                                    at_last + place, comes)
        for path, names, word, level, yes, what, frames in (
                ("laws.sensor", laws.SENSORS, 1, "WARNING", "NOT VALID",
                 "the laws do not believe it", STARTS_FRAMES),
                ("laws.surface", laws.FAILING, 4, "CRITICAL", "FAILED",
                 "it does not follow its servo", 1)):
            inner = self.subsystem(path)
            for place, name in enumerate(names):
                further, bit = divmod(place, WORD_BITS)
                yield self.flag(inner, name,
                                at + (word + further) * WORD_BITS, bit,
                                level, yes, what, comes, frames)

