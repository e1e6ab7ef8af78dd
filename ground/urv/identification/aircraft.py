# SPDX-License-Identifier: Apache-2.0
"""The aircraft file: mass properties and prior derivatives (GND-61).

JSON, as written by sim/jsbsim/derivatives.py. The derivatives in it are
optional and only for comparison: no estimate uses them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path

from urv import faults, input_files

DEFAULT = (Path(__file__).resolve().parents[3]
           / "sim/jsbsim/aircraft/lambda/derivatives.json")

GRAVITY = 32.174
"""ft/s2; the aircraft file may have the local one."""

LEAST, MOST = 1e-6, 1e9
"""Bounds of a positive number; no aircraft has others."""

LONGEST_NAME = 60

MOMENTS, MOMENTS_BY_AIRFLOW = "moments", "moments_by_airflow"
DELAYED = ("attitude", "rates", "accelerations", "airflow",
           MOMENTS, MOMENTS_BY_AIRFLOW)
"""Groups of sensors with a delay of their own, measurements.GROUPS; and the moments
of a simulation that integrates by steps, after rates and surfaces and after the
airflow."""
MOST_DELAY_MS = 500.0
DEVIATION_MS = 2.0
LEAST_DEVIATION_MS = 0.01

POSITIVE = ("mass_slug", "ixx_slug_ft2", "iyy_slug_ft2", "izz_slug_ft2",
            "wing_area_ft2", "span_ft", "chord_ft")


@dataclass(frozen=True)
class Aircraft:
    """Mass properties in slug and ft, about the centre of gravity."""

    name: str
    mass: float
    ixx: float
    iyy: float
    izz: float
    ixz: float
    wing_area: float
    span: float
    chord: float
    gravity: float = GRAVITY
    """Local gravity as level accelerometers show it, ft/s2."""
    prior: dict[str, float] = field(default_factory=dict)
    """Derivatives for comparison, per rad."""
    delays: dict[str, float] = field(default_factory=dict)
    """Known delays, s: DELAYED."""
    delays_deviation: float = DEVIATION_MS / 1e3
    """How well each delay is known: a standard deviation, s."""


def read(path: Path = DEFAULT) -> Aircraft:
    """The aircraft of a file. Raises faults.Refused."""
    where = faults.quoted(path)
    try:
        given = input_files.parsed(input_files.text(path))
    except ValueError as fault:
        raise faults.Refused(f"{where}: not JSON: {fault}") from fault
    if not isinstance(given, dict):
        raise faults.Refused(f"{where}: no aircraft file")
    for name in (*POSITIVE, "ixz_slug_ft2"):
        if name not in given:
            raise faults.Refused(f"{where}: there is no {name}")
        if not _is_number(given[name]) or (
                name in POSITIVE and given[name] <= 0):
            raise faults.Refused(f"{where}: {name} is no"
                                 f" {'positive ' * (name in POSITIVE)}number")
        if abs(given[name]) > MOST or (
                name in POSITIVE and given[name] < LEAST):
            least = LEAST if name in POSITIVE else -MOST
            raise faults.Refused(f"{where}: {name} is from {least:g} to"
                                 f" {MOST:g}")
    if given["ixx_slug_ft2"] * given["izz_slug_ft2"] <= (
            given["ixz_slug_ft2"] ** 2):
        raise faults.Refused(f"{where}: ixz_slug_ft2 is too large")
    gravity = given.get("gravity_ft_s2", GRAVITY)
    if not _is_number(gravity) or not 32.0 <= gravity <= 32.3:
        raise faults.Refused(f"{where}: gravity_ft_s2 is from 32.0 to 32.3")
    name = given.get("aircraft", Path(path).stem)
    if not isinstance(name, str) or not name.isprintable() or (
            len(name) > LONGEST_NAME):
        raise faults.Refused(f"{where}: aircraft is a name of at most"
                             f" {LONGEST_NAME} printable characters")
    prior = given.get("derivatives", {})
    if not isinstance(prior, dict) or not all(
            _is_number(value) for value in prior.values()):
        raise faults.Refused(f"{where}: derivatives are names with numbers")
    delays = given.get("delays_ms", {})
    if not isinstance(delays, dict) or not all(
            each in DELAYED and _is_number(value)
            and 0.0 <= value <= MOST_DELAY_MS
            for each, value in delays.items()):
        raise faults.Refused(
            f"{where}: delays_ms are numbers from 0 to {MOST_DELAY_MS:g} of"
            f" {', '.join(DELAYED)}")
    deviation = given.get("delays_deviation_ms", DEVIATION_MS)
    if not _is_number(deviation) or not (
            LEAST_DEVIATION_MS <= deviation <= MOST_DELAY_MS):
        raise faults.Refused(
            f"{where}: delays_deviation_ms is from {LEAST_DEVIATION_MS:g} to"
            f" {MOST_DELAY_MS:g}")
    return Aircraft(
        name,
        given["mass_slug"], given["ixx_slug_ft2"], given["iyy_slug_ft2"],
        given["izz_slug_ft2"], given["ixz_slug_ft2"], given["wing_area_ft2"],
        given["span_ft"], given["chord_ft"], gravity,
        {name: float(value) for name, value in prior.items()},
        {each: value / 1e3 for each, value in delays.items()},
        deviation / 1e3)


def _is_number(value) -> bool:
    return (isinstance(value, (int, float)) and not isinstance(value, bool)
            and math.isfinite(value))
