# SPDX-License-Identifier: Apache-2.0
"""Random differences between flights, drawn from the flight's seed.

    drawn = dispersions.draw(1234, "standard", 180)
    drawn = dispersions.draw(1234, "standard", 180, surface_percent=5)
    drawn.conditions, drawn.faults      the files of urv_sim
    drawn.values                        the drawn values, by name

The same seed, pilot and length give the same flight, whatever other flights
are flown.
"""

import math
import random
from typing import NamedTuple

# Flights from the runway and back onto it.
CIRCUITS = ("circuit", "damped-circuit")

# Uniform between the two. A circuit begins towards the east, and like any
# pilot this one takes off and lands into the wind.
WIND_FROM_DEG = dict.fromkeys(CIRCUITS, (0, 180))
EVERYWHERE_DEG = (0, 360)
WIND_KT = dict.fromkeys(CIRCUITS, (0, 10))
USUAL_WIND_KT = (0, 15)
TURBULENCE_KT = (0, 15)
BALLAST_LB = (-5, 15)
BALLAST_AFT_IN = (-20, 20)

# Standard deviations of each sensor's constant error, in its unit.
BIAS = {"alpha": 0.3, "beta": 0.3, "roll_attitude": 0.5,
        "pitch_attitude": 0.5, "roll_rate": 0.1, "pitch_rate": 0.1,
        "yaw_rate": 0.1, "airspeed": 1.0, "altitude": 5.0}

# Standard deviations of the noise are between zero and these.
NOISE = {"alpha": 0.2, "beta": 0.2, "roll_attitude": 0.1,
         "pitch_attitude": 0.1, "roll_rate": 0.2, "pitch_rate": 0.2,
         "yaw_rate": 0.2, "airspeed": 0.5, "altitude": 1.0}

# All servos of a flight: per cent of the usual lag and rate limit; the dead
# band in per cent of the travel. A sound servo is within these (EXT-6).
SERVO_LAG_PERCENT = (50, 150)
SERVO_RATE_PERCENT = (50, 150)
SERVO_DEAD_BAND_PERCENT = (0, 1)

# The probability of a wrong bit on the line, and the duration of a cut; both
# uniform in their logarithms.
BIT_ERRORS = (1e-7, 1e-5)
MOST_CUTS = 2
CUT_MS = (20, 500)


# One of them fails in the requested percentage of flights, at any time except
# near the beginning and the end.
SURFACES = tuple(f"{side}_{name}" for name in (
    "aileron", "elevator", "rudder", "flap_1", "flap_2")
    for side in ("left", "right"))
CALM_S = 5

# The console is lost once in the requested percentage of flights, at any time;
# the duration is uniform in its logarithm.
CONSOLE_LOST_MS = (500, 20_000)


class Drawn(NamedTuple):
    """A flight's input files, and the values drawn for them."""

    conditions: str
    faults: str
    values: dict


def draw(seed, pilot, seconds, surface_percent=0, console_percent=0):
    """The flight of that seed."""
    chance = random.Random(f"{pilot} {seconds} {seed}")

    def between(pair):
        return round(chance.uniform(*pair), 3)

    def even_in_logarithm(pair):
        return math.exp(chance.uniform(*map(math.log, pair)))

    values = {
        "wind_from_deg": between(WIND_FROM_DEG.get(pilot, EVERYWHERE_DEG)),
        "wind_kt": between(WIND_KT.get(pilot, USUAL_WIND_KT)),
        "turbulence_kt": between(TURBULENCE_KT),
        "ballast_lb": between(BALLAST_LB),
        "ballast_aft_in": between(BALLAST_AFT_IN),
    }
    conditions = [
        f"wind {values['wind_from_deg']} {values['wind_kt']}",
        f"turbulence {values['turbulence_kt']}",
        f"ballast {values['ballast_lb']} {values['ballast_aft_in']}"]
    for sensor, spread in BIAS.items():
        bias = round(chance.gauss(0.0, spread), 3)
        if sensor == "altitude" and pilot in CIRCUITS:
            # Below zero the altimeter shows zero: no pilot takes off with
            # that.
            bias = abs(bias)
        values[f"bias_{sensor}"] = bias
        conditions.append(f"bias {sensor} {values[f'bias_{sensor}']:.3f}")
    for sensor, most in NOISE.items():
        values[f"noise_{sensor}"] = between((0, most))
        conditions.append(f"noise {sensor} {values[f'noise_{sensor}']:.3f}")

    # From a separate source: older draws keep their values.
    servos = servo_traits(random.Random(f"servos {pilot} {seconds} {seed}"))
    values |= servos
    conditions.append("servos " + " ".join(map(str, servos.values())))

    values["bit_error_rate"] = float(f"{even_in_logarithm(BIT_ERRORS):.3g}")
    faults = [f"0 {way} ber {values['bit_error_rate']:.3g} {seconds * 1000}"
              for way in ("up", "down")]
    lengths = [round(even_in_logarithm(CUT_MS))
               for _ in range(chance.randint(0, MOST_CUTS))]
    for length in lengths:
        faults.append(
            f"{chance.randrange(1000, seconds * 1000)} cut {length}")
    if surface_percent:
        # Drawn last: all other values are independent of it.
        failure, share = surface_failure(chance, seconds), chance.random()
        values["surface_fault"] = float(share * 100 < surface_percent)
        if values["surface_fault"]:
            faults.append(failure)
    if console_percent:
        # From a separate source: all other values are independent of it.
        lost = random.Random(f"{pilot} {seconds} {seed} console")
        at_ms = lost.randrange(1000, seconds * 1000)
        length = round(math.exp(lost.uniform(
            *map(math.log, CONSOLE_LOST_MS))))
        is_lost = lost.random() * 100 < console_percent
        values["console_lost_ms"] = float(length if is_lost else 0)
        if is_lost:
            faults.append(f"{at_ms} gsc console {length}")
    values["cuts"] = len(lengths)
    values["cut_ms"] = sum(lengths)
    return Drawn("\n".join(conditions) + "\n", "\n".join(faults) + "\n",
                 values)


def servo_traits(chance):
    """The traits of all servos of the flight, by name."""
    return {name: round(chance.uniform(*pair), 3) for name, pair in (
        ("servo_lag_percent", SERVO_LAG_PERCENT),
        ("servo_rate_percent", SERVO_RATE_PERCENT),
        ("servo_dead_band_percent", SERVO_DEAD_BAND_PERCENT))}


def surface_failure(chance, seconds):
    """A line of the fault file."""
    at_ms = chance.randrange(CALM_S * 1000, (seconds - CALM_S) * 1000 + 1)
    how = chance.choice((
        "stuck", f"stuck {chance.randrange(4096)}", "float",
        f"slow {chance.randrange(1, 100)}"))
    return f"{at_ms} surface {chance.choice(SURFACES)} {how}"
