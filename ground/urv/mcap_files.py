# SPDX-License-Identifier: Apache-2.0
"""Records as MCAP, for Foxglove and similar programs (GND-15).

A topic for each group of columns, /gsc/downlink and so on, with a message for
each frame: `raw` has the words, `value` the same in their units, NaN where they
are stale. Counts, times and the truth are separate numbers. The messages are
protobuf with fixed places for all fields, so that a thousand of them can be
made, or read, at once.

A file may be hostile: no length in it, and no unpacked chunk, may be beyond
LARGEST_RECORD (SEC-14).
"""

from __future__ import annotations

import struct
from contextlib import contextmanager
from dataclasses import replace

import lz4.frame
import numpy
import zstandard
from google.protobuf import descriptor_pb2
from mcap.exceptions import EndOfFile, McapError
from mcap.records import Channel, Chunk, Message, Metadata
from mcap.stream_reader import (CRCValidationError, StreamReader,
                                breakup_chunk)
from mcap.writer import CompressionType, Writer as McapWriter

from urv import faults, input_files, items, records

MARK = "urv.record"
VERSION = "1"
OTHERS = "frame"
"""The topic of columns without a group: frame, time_ms and such."""

_TYPES = descriptor_pb2.FieldDescriptorProto
_FIXED_32, _FIXED_64, _NESTED = 5, 1, 2

NANOSECONDS_PER_MS = 1_000_000

LARGEST_RECORD = 16 * 2 ** 20
"""Bytes, of a record and of a chunk unpacked; bin/urv writes chunks of 1 MB."""


def varint(number):
    """A tag or a length in protobuf's form."""
    found = bytearray()
    while number > 0x7F:
        found.append(number & 0x7F | 0x80)
        number >>= 7
    found.append(number)
    return bytes(found)


class Layout:
    """The messages of a topic: their schema, and the place of each column in
    them."""

    def __init__(self, group, names, places, decimals):
        self.group = group
        self.topic = "/" + group.replace(".", "/")
        self.places = dict(zip(names, places, strict=True))
        self.template = bytearray()
        self.offsets = {}
        self.message = descriptor_pb2.DescriptorProto(
            name="".join(part.capitalize() for part in group.split(".")))
        words = [name for name in names if name in items.COLUMNS]
        self.values = [name for name in words
                       if items.COLUMNS[name].is_scaled]
        if words:
            self.nested(1, "raw", [
                (name, name, _TYPES.TYPE_FIXED32, "<u4") for name in words])
            self.nested(2, "value", [
                (name, f"{name}.value", _TYPES.TYPE_DOUBLE, "<f8")
                for name in self.values])
        number = 3
        for name in names:
            if name not in words:
                kind, code = ((_TYPES.TYPE_DOUBLE, "<f8")
                              if decimals[self.places[name]]
                              else (_TYPES.TYPE_SFIXED64, "<i8"))
                self.template += self.field(
                    self.message, number, name, kind)
                self.place(self.template, name, code)
                number += 1
        self.kind = numpy.dtype({
            "names": list(self.offsets),
            "formats": [code for _, code in self.offsets.values()],
            "offsets": [offset for offset, _ in self.offsets.values()],
            "itemsize": len(self.template)})

    @staticmethod
    def field(message, number, name, kind, type_name=None):
        """Declare a field; its tag."""
        message.field.add(
            name=records.group_of(name)[1], number=number, type=kind,
            type_name=type_name, label=_TYPES.LABEL_OPTIONAL)
        wire = {_TYPES.TYPE_FIXED32: _FIXED_32,
                _TYPES.TYPE_MESSAGE: _NESTED}.get(kind, _FIXED_64)
        return varint(number << 3 | wire)

    def place(self, text, key, code, base=0):
        """Reserves room for a number."""
        self.offsets[key] = (base + len(text), code)
        text += bytes(int(code[-1]))

    def nested(self, number, name, fields):
        """A nested message, and its room."""
        inner = self.message.nested_type.add(name=name.capitalize())
        text = bytearray()
        found = []
        for place, (column, key, kind, code) in enumerate(fields, 1):
            text += self.field(inner, place, column, kind)
            found.append((key, len(text), code))
            text += bytes(int(code[-1]))
        head = self.field(self.message, number, name, _TYPES.TYPE_MESSAGE,
                          f".urv.{self.message.name}.{inner.name}")
        head += varint(len(text))
        base = len(self.template) + len(head)
        self.template += head + text
        for key, offset, code in found:
            self.offsets[key] = (base + offset, code)

    @property
    def schema(self):
        """In MCAP's form."""
        file = descriptor_pb2.FileDescriptorProto(
            name=f"urv/{self.group}.proto", package="urv", syntax="proto3",
            message_type=[self.message])
        return descriptor_pb2.FileDescriptorSet(
            file=[file]).SerializeToString()

    def blank(self, many):
        """Room for messages, and the numbers in it. Bytes between the numbers
        are in the room alone: numpy copies no padding."""
        room = bytearray(self.template) * many
        return room, numpy.frombuffer(room, dtype=self.kind)

    def encoded(self, rows, stale):
        """A message for each row."""
        room, made = self.blank(len(rows))
        for name, place in self.places.items():
            made[name] = rows[:, place]
        for name in self.values:
            values = items.COLUMNS[name].value(rows[:, self.places[name]])
            if stale is not None:
                values[stale] = numpy.nan
            made[f"{name}.value"] = values
        size = self.kind.itemsize
        text = bytes(room)
        return [text[at:at + size] for at in range(0, len(text), size)]

    def decoded(self, messages, rows):
        """The messages' columns, into rows; whether all had this layout."""
        size = self.kind.itemsize
        if any(len(message) != size for message in messages):
            return False
        text = b"".join(messages)
        read = numpy.frombuffer(text, dtype=self.kind)
        for name, place in self.places.items():
            rows[:, place] = read[name]
        # All bytes except the numbers equal the template.
        room, numbers = self.blank(len(messages))
        for name in self.kind.names:
            numbers[name] = read[name]
        return room == text


def layouts(columns):
    """The layouts of a record's topics."""
    groups = {}
    for place, name in enumerate(columns.names):
        group = records.group_of(name)[0] or OTHERS
        groups.setdefault(group, []).append((name, place))
    return [Layout(group, *zip(*members, strict=True), columns.decimals)
            for group, members in groups.items()]


class Writer:
    """Writes rows as messages."""

    def __init__(self, path, columns):
        self.names = columns.names
        self.frame = columns.names.index("frame")
        self.time = columns.names.index("time_ms")
        self.stream = open(path, "wb")  # noqa: SIM115 - closed by close
        self.file = McapWriter(
            self.stream, compression=CompressionType.ZSTD)
        self.file.start(profile="", library="bin/urv")
        self.file.add_metadata(MARK, {
            "version": VERSION, "columns": ",".join(columns.names),
            "decimals": ",".join(map(str, columns.decimals))})
        self.layouts = layouts(columns)
        self.channels = []
        for layout in self.layouts:
            schema = self.file.register_schema(
                f"urv.{layout.message.name}", "protobuf", layout.schema)
            self.channels.append(self.file.register_channel(
                layout.topic, "protobuf", schema))

    def write(self, rows):
        stale = records.stale_rows(self.names, rows)
        frames = (rows[:, self.frame].astype(numpy.int64) & 0xFFFFFFFF
                  ).tolist()
        times = numpy.rint(
            rows[:, self.time] * NANOSECONDS_PER_MS).astype(int).tolist()
        messages = [layout.encoded(rows, stale.get(layout.group))
                    for layout in self.layouts]
        add = self.file.add_message
        for row, (frame, time) in enumerate(zip(frames, times, strict=True)):
            for channel, of_topic in zip(
                    self.channels, messages, strict=True):
                add(channel, time, of_topic[row], time, frame)

    def close(self, is_whole):
        with self.stream:
            if is_whole:
                self.file.finish()


class BoundedStream:
    """A file that limits the size of a read. A damaged length asks for up to
    2**64 bytes."""

    def __init__(self, file):
        self.file = file

    def read(self, length):
        if not 0 <= length <= LARGEST_RECORD:
            raise ValueError(f"a length of {length}")
        return self.file.read(length)


def unpacked(chunk):
    """The records of a chunk. Raises ValueError when it is too large."""
    if chunk.uncompressed_size > LARGEST_RECORD:
        raise ValueError("too large a chunk")
    data = chunk.data
    if chunk.compression == "zstd":
        # Frames that do not give their length need the other limit.
        if zstandard.frame_content_size(data) > LARGEST_RECORD:
            raise ValueError("too large a chunk")
        data = zstandard.decompress(data, LARGEST_RECORD)
    elif chunk.compression == "lz4":
        unpack = lz4.frame.LZ4FrameDecompressor()
        try:
            data = unpack.decompress(data, LARGEST_RECORD)
        except RuntimeError as fault:
            raise ValueError("not LZ4") from fault
        if not unpack.eof:
            raise ValueError("too large a chunk, or cut short")
    return breakup_chunk(replace(chunk, compression="", data=data),
                         validate_crc=True)


def parts_of(stream):
    """The file's records in order, including those in chunks, a chunk at a
    time. The summary at the file's end is not needed."""
    for part in StreamReader(
            BoundedStream(stream), validate_crcs=True, emit_chunks=True,
            record_size_limit=LARGEST_RECORD).records:
        if isinstance(part, Chunk):
            yield from unpacked(part)
        else:
            yield part


class Record:
    """A record in an MCAP file written by bin/urv."""

    def __init__(self, path, stream, forgiving=False):
        self.path = path
        self.stream = stream
        self.forgiving = forgiving
        self.size = path.stat().st_size
        self.cut_short = None
        """The missing part of a record that was cut short, for people."""

        self.parts = parts_of(stream)
        mark = next((each for each in self.parts
                     if isinstance(each, (Metadata, Message))), None)
        if (not isinstance(mark, Metadata) or mark.name != MARK
                or mark.metadata.get("version") != VERSION):
            raise faults.Refused(
                f"{faults.quoted(path)}: no record: bin/urv convert has not"
                " written it")
        names = mark.metadata["columns"].split(",")
        records.check_names(names, faults.quoted(path))
        self.columns = records.Columns(names, records.read_decimals(
            mark.metadata["decimals"].split(","), names))
        self.names, self.decimals = names, self.columns.decimals
        self.layouts = layouts(self.columns)

    @property
    def position(self):
        return self.stream.tell()

    def messages(self):
        """Each message with its topic. A forgiving reader stops where the file
        was cut short."""
        sizes = {layout.topic: layout.kind.itemsize
                 for layout in self.layouts}
        topic_of = {}
        try:
            for part in self.parts:
                if isinstance(part, Channel):
                    topic_of[part.id] = part.topic
                elif isinstance(part, Message):
                    topic = topic_of[part.channel_id]
                    if topic in sizes:
                        if len(part.data) != sizes[topic]:
                            raise self.not_ours(topic)
                        yield topic, part.data
        except (EndOfFile, struct.error, zstandard.ZstdError,
                CRCValidationError):
            # Also for an incomplete last chunk.
            if not self.forgiving or self.position < self.size:
                raise
            self.cut_short = "it has no end; what came before is read"

    @records.bounded
    def blocks(self):
        waiting = {layout.topic: [] for layout in self.layouts}
        last = self.layouts[-1].topic
        for topic, data in self.messages():
            waiting[topic].append(data)
            if len(waiting[topic]) > records.ROWS_PER_BLOCK:
                raise self.missing()
            if (topic == last
                    and len(waiting[last]) == records.ROWS_PER_BLOCK):
                yield self.rows(waiting)
                waiting = {topic: [] for topic in waiting}
        if self.cut_short:
            whole = min(map(len, waiting.values()))
            waiting = {topic: messages[:whole]
                       for topic, messages in waiting.items()}
        if any(waiting.values()):
            yield self.rows(waiting)

    def rows(self, waiting):
        many = {len(messages) for messages in waiting.values()}
        if len(many) != 1:
            raise self.missing()
        rows = numpy.empty((many.pop(), len(self.names)))
        for layout in self.layouts:
            if not layout.decoded(waiting[layout.topic], rows):
                raise self.not_ours(layout.topic)
        bad = self.columns.first_bad(rows)
        if bad:
            raise faults.Refused(
                f"{faults.quoted(self.path)}: {bad[1]}: a number that no"
                " record has")
        return rows

    def missing(self):
        return faults.Refused(
            f"{faults.quoted(self.path)}: messages of some topics are missing")

    def not_ours(self, topic):
        return faults.Refused(
            f"{faults.quoted(self.path)}: {topic}: messages are not as"
            " bin/urv convert writes them")


@contextmanager
def opened(path, forgiving=False):
    """A record for reading."""
    stream = input_files.opened(path)
    with stream:
        try:
            yield Record(path, stream, forgiving)
        except (McapError, EOFError, ValueError, KeyError, OverflowError,
                struct.error, zstandard.ZstdError) as fault:
            raise faults.Refused(
                f"{faults.quoted(path)}: no MCAP file, or one that is"
                " damaged") from fault
