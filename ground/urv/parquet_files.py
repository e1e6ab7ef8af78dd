# SPDX-License-Identifier: Apache-2.0
"""Records as Parquet, for notebooks (GND-15).

    table = pandas.read_parquet("record.parquet")
    table["gsc.downlink.altitude.value"]

Each column of the record is one of the file, words as 16 bits. They are
followed, for each word with a scale, by NAME.value in its unit, without a value
where the words are stale; the unit is in the field's metadata.

A file may be hostile (SEC-14, D-65). The size of its end, its columns and its
rows are checked before they are read; input_files.limit_memory limits the
unpacked size of a page. Some damage ends the process that runs Arrow, so a
process of its own reads the file.
"""

import multiprocessing
import os
from contextlib import contextmanager

import numpy
import pyarrow
import pyarrow.parquet

from urv import faults, input_files, items, records

MARK = b"urv.record"
VERSION = b"1"
DECIMALS = b"urv.decimals"
UNIT = b"unit"

ROWS_PER_GROUP = 20_000

LARGEST_END = 8 * 2 ** 20
"""Bytes of the metadata, at the file's end; a day's record has half of it."""
MAGIC = b"PAR1"
LARGEST_CHUNK = 16 * 2 ** 20
"""Bytes of a column in a row group, unpacked; bin/urv writes 176 kB."""
MOST_LISTED = 1_000_000
"""Elements of a list in the metadata."""


def field(name, decimals):
    """A column with the type of the record."""
    if decimals:
        kind = pyarrow.float64()
    elif name in items.COLUMNS:
        kind = pyarrow.uint16()
    else:
        kind = pyarrow.int64()
    return pyarrow.field(name, kind, nullable=False,
                         metadata={DECIMALS: str(decimals).encode()})


class Writer:
    """Writes rows, some thousands at a time."""

    def __init__(self, path, columns):
        self.names = columns.names
        self.fields = [field(*column) for column in zip(
            columns.names, columns.decimals, strict=True)]
        self.scaled = [
            (place, name) for place, name in enumerate(columns.names)
            if name in items.COLUMNS and items.COLUMNS[name].is_scaled]
        values = [
            pyarrow.field(f"{name}.value", pyarrow.float64(), metadata={
                UNIT: items.COLUMNS[name].unit.encode()})
            for _, name in self.scaled]
        self.schema = pyarrow.schema(
            self.fields + values, metadata={MARK: VERSION})
        # Arrow takes some names for addresses: it gets an open file.
        self.stream = open(path, "wb")  # noqa: SIM115 - closed by close
        self.file = pyarrow.parquet.ParquetWriter(
            self.stream, self.schema, compression="zstd",
            write_page_checksum=True)
        self.waiting = []

    def write(self, rows):
        self.waiting.append(rows)
        if sum(map(len, self.waiting)) >= ROWS_PER_GROUP:
            self.flush()

    def flush(self):
        if not self.waiting:
            return
        rows = numpy.concatenate(self.waiting)
        self.waiting = []
        arrays = [
            pyarrow.array(rows[:, place].astype(one.type.to_pandas_dtype()))
            for place, one in enumerate(self.fields)]
        stale = records.stale_rows(self.names, rows)
        for place, name in self.scaled:
            arrays.append(pyarrow.array(
                items.COLUMNS[name].value(rows[:, place]),
                mask=stale.get(records.group_of(name)[0])))
        self.file.write_table(
            pyarrow.Table.from_arrays(arrays, schema=self.schema))

    def close(self, is_whole):
        with self.stream:
            if is_whole:
                self.flush()
            self.file.close()


class ArrowRecord:
    """A record in a Parquet file written by bin/urv, read by Arrow."""

    def __init__(self, path, file):
        self.path = path
        self.file = file
        schema = file.schema_arrow
        if (schema.metadata or {}).get(MARK) != VERSION:
            raise faults.Refused(
                f"{faults.quoted(path)}: no record: bin/urv convert has not"
                " written it")
        fields = [one for one in schema if DECIMALS in (one.metadata or {})]
        names = [one.name for one in fields]
        records.check_names(names, faults.quoted(path))
        decimals = records.read_decimals(
            [one.metadata[DECIMALS].decode() for one in fields], names)
        self.columns = records.Columns(names, decimals)
        self.names, self.decimals = names, decimals
        self.kinds = [field(*one).type for one in zip(
            names, decimals, strict=True)]
        self.check_sizes()

    def check_sizes(self):
        """To be called before any unpacking."""
        metadata = self.file.metadata
        if (metadata.num_columns > 2 * records.MOST_COLUMNS
                or metadata.num_rows > records.MOST_ROWS):
            raise ValueError("more than a day, or too many columns")
        for group in range(metadata.num_row_groups):
            of_group = metadata.row_group(group)
            for place in range(of_group.num_columns):
                if not (0 <= of_group.column(place).total_uncompressed_size
                        <= LARGEST_CHUNK):
                    raise ValueError("too large a column")

    @records.bounded
    def blocks(self):
        batches = self.file.iter_batches(
            records.ROWS_PER_BLOCK, columns=self.names, use_threads=False)
        while (batch := _told(self.path, lambda: next(batches, None))):
            if (sorted(batch.schema.names) != sorted(self.names)
                    or [batch.schema.field(name).type
                        for name in self.names] != self.kinds):
                raise ValueError("other columns than those of its schema")
            rows = numpy.empty((batch.num_rows, len(self.names)))
            for place, name in enumerate(self.names):
                column = batch.column(name)
                if column.null_count:
                    raise ValueError("a word is missing")
                rows[:, place] = column.to_numpy(zero_copy_only=False)
            bad = self.columns.first_bad(rows)
            if bad:
                raise faults.Refused(
                    f"{faults.quoted(self.path)}: {bad[1]}: a number that no"
                    " record has")
            yield rows


def _told(path, read):
    """Reads with Arrow's errors turned into those of the file. It raises
    OSErrors of its own, without a number."""
    try:
        return read()
    except MemoryError:
        # Arrow's is an ArrowException, too.
        raise MemoryError from None
    except (pyarrow.ArrowException, OSError, ValueError) as fault:
        if isinstance(fault, OSError) and fault.errno:
            raise faults.Refused(f"{faults.quoted(path)} cannot be read:"
                                 f" {faults.reason(fault)}") from fault
        raise damaged(path) from fault


def damaged(path):
    return faults.Refused(
        f"{faults.quoted(path)}: not a Parquet file, or damaged or cut"
        " short: its end lists its contents")


def check_end(stream):
    """Checks the length of the metadata, which Arrow does not limit. Raises
    ValueError."""
    size = stream.seek(0, os.SEEK_END)
    stream.seek(max(0, size - 8))
    end = stream.read(8)
    stream.seek(0)
    if (end[4:] != MAGIC
            or int.from_bytes(end[:4], "little") > min(size, LARGEST_END)):
        raise ValueError("no end of a Parquet file")


@contextmanager
def opened_by_arrow(path):
    with input_files.opened(path) as stream:
        _told(path, lambda: check_end(stream))
        file = _told(path, lambda: pyarrow.parquet.ParquetFile(
            stream, page_checksum_verification=True, pre_buffer=False,
            thrift_string_size_limit=LARGEST_END,
            thrift_container_size_limit=MOST_LISTED))
        with file:
            try:
                yield ArrowRecord(path, file)
            except (ValueError, KeyError) as fault:
                raise damaged(path) from fault


def read_apart(path, ours, theirs):
    """Runs in the reading process: sends the columns, the blocks and an end,
    or the file's error. Arrow prints there the reason when it ends the
    process."""
    ours.close()
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    try:
        with opened_by_arrow(path) as record:
            theirs.send((record.names, record.decimals,
                         record.file.metadata.num_rows))
            for rows in record.blocks():
                theirs.send(rows)
            theirs.send(None)
    except Exception as fault:
        theirs.send(fault)


class Record:
    """A record in a Parquet file, as the reading process sends it."""

    cut_short = None

    def __init__(self, path, pipe):
        self.path = path
        self.pipe = pipe
        self.names, self.decimals, self.size = self.received()
        self.columns = records.Columns(self.names, self.decimals)
        self.position = 0

    def received(self):
        try:
            sent = self.pipe.recv()
        except EOFError as fault:
            raise damaged(self.path) from fault
        if isinstance(sent, Exception):
            raise sent
        return sent

    def blocks(self):
        while (rows := self.received()) is not None:
            self.position += len(rows)
            yield rows


@contextmanager
def opened(path, forgiving=False):
    """A record for reading. A file that was cut short is refused: without its
    end nothing of it can be read."""
    del forgiving
    context = multiprocessing.get_context("fork")
    ours, theirs = context.Pipe(duplex=False)
    reader = context.Process(target=read_apart, args=(path, ours, theirs),
                             daemon=True)
    reader.start()
    theirs.close()
    try:
        yield Record(path, ours)
    finally:
        # It ends when its output is not read any more.
        ours.close()
        reader.join()
