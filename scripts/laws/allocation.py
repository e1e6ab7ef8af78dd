# SPDX-License-Identifier: Apache-2.0
"""The surfaces that replace a failed one: the gains of URV.Allocation (EXT-6).

    scripts/laws/allocation.py renew     writes src/laws/urv-allocation_table.ads
    scripts/laws/allocation.py check     fails if it is of another aircraft

The moments of each surface are those of the aircraft of sim/jsbsim. For each
failed surface, the other primary surfaces make its moment with the least
weighted movement: the weighted pseudo-inverse

    W^-1 B' (B W^-1 B')^-1 b

where B has the moments of the other surfaces, b those of the failed one, and W
weighs a surface by the square of its travel. Flaps only go down, and slowly:
they only help an aileron at its limit (URV.Allocation).
"""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
AIRCRAFT = ROOT / "sim/jsbsim/aircraft/lambda/lambda.xml"
TABLE = ROOT / "src/laws/urv-allocation_table.ads"
UNIT = 1024

SURFACES = ("left_aileron", "right_aileron", "left_elevator",
            "right_elevator", "left_rudder", "right_rudder", "left_flap_1",
            "right_flap_1", "left_flap_2", "right_flap_2")
PRIMARY = SURFACES[:6]
AXES = ("roll", "pitch", "yaw")

# Degrees of a word, as in Host.Scaling, and of the whole travel.
PER_WORD = {"aileron": 0.01, "elevator": 0.0125, "rudder": 0.0125,
            "flap": 15 / 2047}
TRAVEL = {"aileron": 20.0, "elevator": 25.0, "rudder": 25.0}
INNER, OUTER = 0.6, 0.4


def family(surface):
    return surface.split("_")[1]


def coefficients(path=AIRCRAFT):
    """The last number of each function aero/AXIS/NAME."""
    return {function.get("name"): float(list(function.iter("value"))[-1].text)
            for function in ElementTree.parse(path).iter("function")
            if list(function.iter("value"))}


def moments(path=AIRCRAFT):
    """The moments of a degree of each surface: roll, pitch and yaw
    coefficients, the pitch's of the chord in parts of the span's."""
    of = coefficients(path)
    chord = 1.75 / 14

    def each(surface):
        kind = family(surface)
        left = surface.startswith("left")
        if kind == "aileron":
            return (of["aero/roll/ailerons"] / 2, 0,
                    of["aero/yaw/ailerons"] / 2)
        if kind == "elevator":
            split = of["aero/roll/elevator-split"] / 2
            return (-split if left else split,
                    chord * of["aero/pitch/elevators"] / 2, 0)
        if kind == "rudder":
            return (of["aero/roll/rudders"] / 2, 0, of["aero/yaw/rudders"] / 2)
        part = (INNER if surface.endswith("1") else OUTER) / 2
        split = part * of["aero/roll/flap-split"]
        return (split if left else -split,
                part * chord * of["aero/pitch/flaps"], 0)

    return {surface: each(surface) for surface in SURFACES}


def solved(matrix, right):
    """A small system of linear equations."""
    size = len(right)
    rows = [[*row, value] for row, value in zip(matrix, right)]
    for place in range(size):
        best = max(range(place, size), key=lambda row: abs(rows[row][place]))
        rows[place], rows[best] = rows[best], rows[place]
        for row in range(size):
            if row != place:
                part = rows[row][place] / rows[place][place]
                rows[row] = [one - part * two for one, two in
                             zip(rows[row], rows[place])]
    return [row[-1] / row[place] for place, row in enumerate(rows)]


def gains(failed, of):
    """Words of each surface for a word that the failed one lacks."""
    helpers = [name for name in PRIMARY if name != failed]
    freedom = {name: TRAVEL[family(name)] ** 2 for name in helpers}
    square = [[sum(freedom[name] * of[name][i] * of[name][j]
                   for name in helpers) for j in range(3)] for i in range(3)]
    share = solved(square, of[failed])
    found = dict.fromkeys(SURFACES, 0.0)
    for name in helpers:
        degrees = freedom[name] * sum(
            of[name][axis] * share[axis] for axis in range(3))
        found[name] = (degrees * PER_WORD[family(failed)]
                       / PER_WORD[family(name)])
    return found


def title(name):
    return "_".join(word.capitalize() for word in name.split("_"))


def text(path=AIRCRAFT):
    of = moments(path)
    roll = {name: of[name][0] * PER_WORD[family(name)] for name in SURFACES}
    rows = ",\n".join(
        f"      {title(failed)} =>\n        ("
        + ",\n         ".join(
            f"{title(name)} => {round(UNIT * gain)}"
            for name, gain in gains(failed, of).items()) + ")"
        for failed in SURFACES)
    flaps = ",\n".join(
        f"      {title(name)} => "
        f"{round(UNIT * roll[name] / roll['left_aileron'])}"
        for name in SURFACES[6:])
    both = roll["left_flap_1"] + roll["left_flap_2"]
    return f"""--  SPDX-License-Identifier: Apache-2.0

--  The gains of the surfaces that replace a failed one (EXT-6), computed from
--  the aircraft's moments. scripts/laws/allocation.py writes this file; do not
--  edit it.

with URV.Law_Units; use URV.Law_Units;
with URV.Surfaces;  use URV.Surfaces;

package URV.Allocation_Table with Pure, SPARK_Mode is

   --  A gain of 1.
   Unit : constant := {UNIT};

   subtype Gain is Number range -4_096 .. 4_096;

   type Gain_Row is array (Surface) of Gain;
   type Gain_Table is array (Surface) of Gain_Row;

   --  Words of each surface that replace one word of the failed surface.
   Gains : constant Gain_Table :=
     (
{rows});

   --  Words of an aileron with the rolling moment of one word of the flap.
   type Flap_Row is array (Flap) of Number range -1_024 .. 1_024;

   Roll_Of_Flap : constant Flap_Row :=
     (
{flaps});

   --  Words of both flaps of a side with the rolling moment of one word of
   --  the aileron.
   Flap_For_Roll : constant := {round(UNIT * roll["left_aileron"] / both)};

end URV.Allocation_Table;
"""


def main(arguments):
    match arguments:
        case ["renew"]:
            TABLE.write_text(text(), encoding="utf-8")
        case ["check"]:
            if TABLE.read_text(encoding="utf-8") != text():
                sys.exit("src/laws/urv-allocation_table.ads is of another"
                         " aircraft; renew it with: python3"
                         " scripts/laws/allocation.py renew")
        case _:
            sys.exit("usage: allocation.py renew|check")


if __name__ == "__main__":
    main(sys.argv[1:])
