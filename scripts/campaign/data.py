# SPDX-License-Identifier: Apache-2.0
"""Words at the converters that tell when they were sampled.

Every frame has its own: the first two words are the frame's number, the
others depend on it. So a block that arrives tells its age, and any block
that never was sent is seen.
"""

STICKS = (["roll", "pitch", "yaw", "throttle", "brake"]
          + [f"switch{n}" for n in range(1, 9)])
SENSORS = """right_flap_1 left_flap_1 right_flap_2 left_flap_2 right_aileron
left_aileron right_elevator left_elevator right_rudder left_rudder alpha beta
altitude_offset lateral_acceleration longitudinal_acceleration
vertical_acceleration rpm battery_volts alternator_volts roll_attitude
pitch_attitude roll_rate pitch_rate yaw_rate airspeed altitude
uplink_signal_strength""".split()


def words(frame, count):
    # Not all zero, as memory is before anything has come.
    mixed = (frame + 1) * 2654435761
    return [frame + 1 & 0xFFF, frame + 1 >> 12] + [
        (mixed >> (place % 13)) * (2 * place + 1) & 0xFFF
        for place in range(2, count)]


def text(frame, count):
    return ",".join(map(str, words(frame, count)))


def write_script(path, names, frames, lag_ms):
    """New words as each of the node's frames begins."""
    with open(path, "w", encoding="ascii") as script:
        script.write(f"time_ms,{','.join(names)}\n")
        for frame in range(frames):
            script.write(f"{20 * frame + lag_ms},{text(frame, len(names))}\n")
