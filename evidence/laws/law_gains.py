# SPDX-License-Identifier: Apache-2.0
"""The numbers of URV.Law_Gains, and what a page about them is of (EXT-7)."""

import hashlib
import re
from pathlib import Path
from types import SimpleNamespace
from xml.etree.ElementTree import canonicalize

ROOT = Path(__file__).resolve().parents[2]
GAINS = ROOT / "src/laws/urv-law_gains.ads"
TIMES = (ROOT / "src/kernel/urvos-frames.ads",
         ROOT / "src/formats/urv-frame_times.ads")
AIRCRAFT = (ROOT / "sim/jsbsim/aircraft/lambda/lambda.xml",
            *sorted((ROOT / "sim/jsbsim/engine").glob("*.xml")))
CONSTANT = re.compile(r"^ +(\w+) *: constant :=\s+([^;]+);", re.M)
WHOLE = re.compile(r"-?[0-9_]+|[A-Za-z]\w*")


def number(text, known):
    """A product or a quotient of whole numbers and names before it."""
    value, sign = None, "*"
    for part in re.findall(r"-?\w+|[*/]", text):
        if part in "*/":
            sign = part
            continue
        if not WHOLE.fullmatch(part):
            raise ValueError(f"no number: {text}")
        this = (known[part] if part[0].isalpha()
                else int(part.replace("_", "")))
        value = (this if value is None else
                 value * this if sign == "*" else value // this)
    return value


def numbers(path, others):
    """A package's numbers by name, which it derives from others."""
    known = {}
    for name, value in CONSTANT.findall(path.read_text(encoding="utf-8")):
        known[name] = number(value, others | known)
    return known


def frame_times():
    """The length of a frame and what is derived from it."""
    known = {}
    for path in TIMES:
        known |= numbers(path, known)
    return known


FRAME_S = frame_times()["Microseconds_Per_Frame"] / 1e6


def gains(path=GAINS, table=0):
    """The package's numbers by name; those of the softer table, 1, in the
    place of the usual ones."""
    known = numbers(path, frame_times())
    if table:
        known |= {name.removeprefix("Soft_"): value
                  for name, value in known.items()
                  if name.startswith("Soft_")}
    return SimpleNamespace(**known)


def mark():
    """A hash of these gains and this aircraft, without comments."""
    every = "\n".join(f"{name} {value}"
                      for name, value in vars(gains()).items())
    data = every + "".join(
        canonicalize(from_file=path, strip_text=True) for path in AIRCRAFT)
    return hashlib.sha256(data.encode()).hexdigest()[:16]
