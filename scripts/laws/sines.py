#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tables of the test inputs' signals (FTI-3): URV.Signal_Tables.

    scripts/laws/sines.py renew     writes src/laws/urv-signal_tables.ads
    scripts/laws/sines.py check     reports whether it is as computed

A sum of n sines with Schroeder's phases has a peak below n. The share of a sine
is the reciprocal of that peak, for any first harmonic and any spacing: the peak
of the envelope, the absolute value of the sum of the complex exponentials.
"""

import math
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TABLE = ROOT / "src/laws/urv-signal_tables.ads"

UNIT = 16_384
SINES = 256
POWERS = 64
POWER_UNIT = 2_048
MOST_SINES = 12
SHARE_UNIT = 256
SEARCHED = 20_000
COLUMNS = 76

HEAD = """--  SPDX-License-Identifier: Apache-2.0

--  Made by scripts/laws/sines.py (FTI-3): not to be changed by hand.

package URV.Signal_Tables with Pure, SPARK_Mode is

   --  The amplitude of a signal; sines are in parts of it.
   Unit : constant := {unit};

   subtype Unit_Value is Integer range -Unit .. Unit;

   --  The sine at each 256th of a cycle.
   subtype Sine_Place is Integer range 0 .. {sines};

   type Sine_Table is array (Sine_Place) of Unit_Value;

   Sines : constant Sine_Table :=
     ({sine_rows});

   --  The power of 2 for each 64th of an octave.
   Power_Unit : constant := {power_unit};

   subtype Power_Place is Integer range 0 .. {powers};
   subtype Power is Integer range Power_Unit .. 2 * Power_Unit;

   type Power_Table is array (Power_Place) of Power;

   Powers : constant Power_Table :=
     ({power_rows});

   --  The share of each sine in their sum, with Schroeder's phases.
   Share_Unit : constant := {share_unit};

   subtype Sine_Count is Integer range 1 .. {most};
   subtype Share is Integer range 1 .. Share_Unit;

   type Share_Table is array (Sine_Count) of Share;

   Shares : constant Share_Table :=
     ({share_rows});

end URV.Signal_Tables;
"""


def sines():
    return [round(UNIT * math.sin(2 * math.pi * place / SINES))
            for place in range(SINES + 1)]


def powers():
    return [round(POWER_UNIT * 2 ** (place / POWERS))
            for place in range(POWERS + 1)]


def phase(place, count):
    """Schroeder's phase of a sine, in cycles; it is counted from 0."""
    return -place * (place - 1) / (2 * count)


def peak(count):
    """The largest absolute value of the envelope."""
    angles = [2 * math.pi * step / SEARCHED for step in range(SEARCHED)]
    return max(
        math.hypot(*(sum(part(place * angle
                              + 2 * math.pi * phase(place, count))
                         for place in range(count))
                     for part in (math.cos, math.sin)))
        for angle in angles)


def shares():
    return [min(SHARE_UNIT, math.floor(SHARE_UNIT / peak(count)))
            for count in range(1, MOST_SINES + 1)]


def rows(values):
    """Numbers, folded into lines."""
    lines, line = [], ""
    for value in values:
        word = f"{value}, "
        if len(line) + len(word) > COLUMNS - 6:
            lines.append(line.rstrip())
            line = ""
        line += word
    lines.append(line.rstrip().rstrip(","))
    return "\n      ".join(lines)


def text():
    return HEAD.format(
        unit=UNIT, sines=SINES, powers=POWERS, power_unit=POWER_UNIT,
        share_unit=SHARE_UNIT, most=MOST_SINES, sine_rows=rows(sines()),
        power_rows=rows(powers()), share_rows=rows(shares()))


def main():
    if sys.argv[1:] == ["renew"]:
        TABLE.write_text(text())
        return 0
    if sys.argv[1:] == ["check"]:
        if TABLE.read_text() != text():
            print(f"{TABLE.relative_to(ROOT)} is not as computed:"
                  " scripts/laws/sines.py renew")
            return 1
        return 0
    print(__doc__)
    return 2


if __name__ == "__main__":
    sys.exit(main())
