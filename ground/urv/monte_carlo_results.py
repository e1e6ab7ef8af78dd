# SPDX-License-Identifier: Apache-2.0
"""The results of a campaign's flights, and its Parquet.

A row for each flight, by seed: the drawn values, the measures, the used share
of each limit, and whether all was well. The contents are independent of the
worker and the time.
"""

from typing import NamedTuple

from urv import faults, success

# The parts of the summary about the flight and its link.
PARTS = ("flight_quality", "circuit")
LINK = ("uplink_bad", "downlink_bad", "gsc_resets", "mcs_resets")


class Flight(NamedTuple):
    """One flight of the campaign."""

    seed: int
    drawn: dict
    measured: dict
    used: dict
    fault: str

    @property
    def worst(self):
        """The largest used share of a limit."""
        return max(*self.used.values(),
                   success.BEYOND if self.has_false_failure else 0.0)

    @property
    def is_sound(self):
        """True if none of its surfaces fails."""
        return not self.drawn.get("surface_fault")

    @property
    def has_false_failure(self):
        """True if a surface or the engine is reported as failed, and none
        fails."""
        return self.is_sound and bool(self.measured.get("surfaces_named"))

    @property
    def is_success(self):
        return self.worst <= 1.0


def flight(pilot, job, result):
    """A flight from its job and the worker's answer."""
    summary = result.get("summary", {})
    measured = {}
    for part in PARTS:
        for name, value in (summary.get(part) or {}).items():
            measured[name] = None if value is None else float(value)
    for name in LINK:
        if name in summary.get("link", {}):
            measured[name] = float(summary["link"][name])
    if summary:
        measured["surfaces_named"] = float(
            len(summary.get("failed_surfaces", ())))
    known = {**summary, "holds": result.get("holds", {})}
    used = {limit.name: limit.used(known)
            for limit in success.limits(pilot)}
    return Flight(job["seed"], job["values"], measured, used,
                  result.get("fault", ""))


def names(flights, part):
    """The names in any flight, in their order."""
    return list(dict.fromkeys(
        name for each in flights for name in getattr(each, part)))


def write(path, campaign, cargo_hash, flights):
    import pyarrow
    import pyarrow.parquet

    columns = {"seed": pyarrow.array(
        [each.seed for each in flights], pyarrow.int64())}
    for part, prefix in (("drawn", "drawn."), ("measured", ""),
                         ("used", "used.")):
        for name in names(flights, part):
            columns[prefix + name] = pyarrow.array(
                [getattr(each, part).get(name) for each in flights],
                pyarrow.float64())
    columns["success"] = pyarrow.array(
        [each.is_success for each in flights], pyarrow.bool_())
    columns["fault"] = pyarrow.array(
        [each.fault for each in flights], pyarrow.string())
    table = pyarrow.table(columns).replace_schema_metadata({
        "urv.monte_carlo": "1", "urv.pilot": campaign.pilot,
        "urv.seconds": str(campaign.seconds), "urv.cargo": cargo_hash,
        "urv.surface_percent": str(campaign.surface_percent),
        "urv.console_percent": str(campaign.console_percent)})
    try:
        # Arrow takes some names for addresses: it gets an open file.
        with open(path, "wb") as file:
            pyarrow.parquet.write_table(table, file, compression="zstd")
    except OSError as fault:
        raise faults.Failed(f"{faults.quoted(path)} cannot be written:"
                            f" {faults.reason(fault)}") from fault
