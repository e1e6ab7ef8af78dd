# SPDX-License-Identifier: Apache-2.0
"""The monitor's knowledge of the words: their names and order, the servos'
transform of a command (PWM-2, figure 13), their words until then."""

COMMANDS = ("roll", "pitch", "yaw", "throttle", "brake",
            *(f"switch{n}" for n in range(1, 9)))
SENSORS = tuple("""right_flap_1 left_flap_1 right_flap_2 left_flap_2
right_aileron left_aileron right_elevator left_elevator right_rudder
left_rudder alpha beta altitude_offset lateral_acceleration
longitudinal_acceleration vertical_acceleration rpm battery_volts
alternator_volts roll_attitude pitch_attitude roll_rate pitch_rate yaw_rate
airspeed altitude uplink_signal_strength""".split())
SERVOS = ("left_aileron", "right_aileron", "left_elevator", "right_elevator",
          "left_rudder", "right_rudder", "steering", "throttle", "brake",
          "left_flap_1", "right_flap_1", "left_flap_2", "right_flap_2",
          "discretes")

MIDDLE, LARGEST = 0x800, 0xFFF

# The words of a console without a script.
NEUTRAL_STICKS = (MIDDLE,) * 5 + (0,) * 8
NEUTRAL_SENSORS = (MIDDLE,) * 27

# The word of each output from power up until the first commands (SAF-1):
# surfaces at zero, flaps up, the engine idle, brakes full on, all off.
SAFE = {name: MIDDLE for name in SERVOS} | {
    "throttle": 0, "brake": LARGEST, "discretes": 0}
SAFE_ROW = tuple(SAFE[name] for name in SERVOS)

# The same as commands: what the ground sends up for a lost console when it
# knows that the aircraft is on the ground (SAF-10).
SAFE_COMMANDS = (MIDDLE, MIDDLE, MIDDLE, 0, LARGEST) + (0,) * 8

BRAKE = SERVOS.index("brake")


def unattended(servos):
    """The outputs when no controller has touched the board for half a second
    (SAF-11): safe, the brake as it was."""
    return tuple(servos[BRAKE] if place == BRAKE else word
                 for place, word in enumerate(SAFE_ROW))


# A card's inputs to the servos change these only (FTI-6). In the record an input
# is the word of a centred servo with it. Inputs to the sticks of roll, pitch and
# yaw have the places of the left surfaces; that of yaw steers, too. A law makes
# servo words of the inputs to its commands.
ADDED = SERVOS[:6]
AT_SERVO, AT_STICK, AT_COMMAND = range(3)


def without_inputs(servos, added, where=AT_SERVO):
    """The outputs without the inputs of a test card. Where: their place."""
    if where == AT_COMMAND:
        return tuple(servos)
    if where == AT_STICK:
        roll, pitch, yaw = added[::2]
        added = (roll, roll, pitch, pitch, yaw, yaw, yaw)
    return tuple(
        word if place >= len(added) or added[place] == MIDDLE
        else word - added[place] + MIDDLE
        for place, word in enumerate(servos))


# The error word's bit that says: these are words of an earlier scan.
STALE = 1


def is_on(switch):
    return switch >= MIDDLE


def transformed(commands):
    """The 14 outputs for 13 command words."""
    roll, pitch, yaw, throttle, brake = (
        min(word, LARGEST) for word in commands[:5])
    switches = commands[5:13]
    flaps = LARGEST if is_on(switches[7]) else MIDDLE
    discretes = sum(1 << bit for bit, word in enumerate(switches)
                    if is_on(word))
    return (roll, roll, pitch, pitch, yaw, yaw, yaw, throttle, brake,
            flaps, flaps, flaps, flaps, discretes)


def orders_of(commands):
    """The parts of a command: five words and eight switches."""
    return (*commands[:5], *map(is_on, commands[5:13]))


def orders_behind(servos):
    """The orders that give these outputs; None if there are none."""
    discretes = servos[13]
    if discretes > 0xFF:
        return None
    orders = (servos[0], servos[2], servos[4], servos[7], servos[8],
              *(bool(discretes >> bit & 1) for bit in range(8)))
    made = transformed((*orders[:5],
                        *(LARGEST if on else 0 for on in orders[5:])))
    return orders if made == servos else None


# The first servos are those that a control law flies: surfaces and throttle.
# After it has let go they may be on their way to the sticks for a second.
FLOWN = 8
LETTING_GO_ROWS = 50


def law_rows(titles, rows):
    """For each row whether a control law may fly the servos in it."""
    if "laws.link" not in titles:
        return [False] * len(rows)
    link = titles.index("laws.link")
    modes = [titles.index("laws." + name)
             for name in ("lateral", "vertical", "power")]
    found, since = [], LETTING_GO_ROWS
    for row in rows:
        is_flown = int(row[link]) > 1 or any(row[at] != "0" for at in modes)
        since = 0 if is_flown else since + 1
        found.append(since <= LETTING_GO_ROWS)
    return found


def is_by_law(before, words, near, failed=0):
    """A law may have made of the first outputs these of the others: brake,
    flaps and discretes stay, or are what a message says that is not old. With
    a failed surface the flaps may make up for it."""

    def others(outputs):
        return outputs[FLOWN:] if not failed else (
            outputs[BRAKE], outputs[-1])

    return (max(words[:FLOWN]) <= LARGEST
            and (others(words) == others(before)
                 or any(not message[-1] & STALE
                        and others(transformed(message[:13]))
                        == others(words)
                        for message in near)))
