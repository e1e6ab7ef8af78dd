# SPDX-License-Identifier: Apache-2.0
"""Records as Parquet, for notebooks (GND-15).

    table = pandas.read_parquet("record.parquet")
    table["gsc.downlink.altitude.value"]

Each column of the record is one of the file, words as 16 bits. After them
stands, for each word with a scale, NAME.value in its unit, without a value
where the words are stale; the unit is in the field's metadata.
"""

from contextlib import contextmanager

import numpy
import pyarrow
import pyarrow.parquet

from urv import faults, items, records

MARK = b"urv.record"
VERSION = b"1"
DECIMALS = b"urv.decimals"
UNIT = b"unit"

ROWS_PER_GROUP = 20_000


def field(name, decimals):
    """A column as it stands in the record."""
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


class Record:
    """A record in a Parquet file that bin/urv has written."""

    cut_short = None

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
        self.columns = records.Columns(
            names, [int(one.metadata[DECIMALS]) for one in fields])
        self.names, self.decimals = names, self.columns.decimals
        self.size = file.metadata.num_rows
        self.position = 0

    def blocks(self):
        batches = self.file.iter_batches(
            records.ROWS_PER_BLOCK, columns=self.names)
        while (batch := _told(self.path, lambda: next(batches, None))):
            rows = numpy.empty((batch.num_rows, len(self.names)))
            for place, name in enumerate(self.names):
                rows[:, place] = batch.column(name).to_numpy(
                    zero_copy_only=False)
            self.position += len(rows)
            yield rows


def _told(path, read):
    """What is read; what Arrow finds wrong is the file's fault. It raises
    OSErrors of its own, without a number."""
    try:
        return read()
    except (pyarrow.ArrowException, OSError) as fault:
        if isinstance(fault, OSError) and fault.errno:
            raise faults.Refused(f"{faults.quoted(path)} cannot be read:"
                                 f" {faults.reason(fault)}") from fault
        raise faults.Refused(
            f"{faults.quoted(path)}: no Parquet file, or one that is damaged"
            " or cut short: its end says what is in it") from fault


@contextmanager
def opened(path, forgiving=False):
    """A record to be read. One that was cut short is refused: without its end
    nothing of it can be read."""
    del forgiving
    try:
        stream = path.open("rb")
    except OSError as fault:
        raise faults.Refused(f"{faults.quoted(path)} cannot be read:"
                             f" {faults.reason(fault)}") from fault
    with stream:
        file = _told(path, lambda: pyarrow.parquet.ParquetFile(
            stream, page_checksum_verification=True))
        with file:
            yield Record(path, file)
