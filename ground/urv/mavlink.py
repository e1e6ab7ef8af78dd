# SPDX-License-Identifier: Apache-2.0
"""bin/urv mavlink: the flight as MAVLink 2, for QGroundControl and others
(GND-40, GND-41, GND-45, GND-53, GND-56, GND-57).

docs/mavlink.md has the message of each item. The direction is one way:
messages from a ground control station are ignored.
"""

from __future__ import annotations

import math
import socket
import time
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import typer

from urv import faults, items, laws, outputs, packets, station, view
from urv.packets import FramePacket, LinkState, Pilot
from urv.repeats import Repeats, left_out
from urv.runs import Runs
from urv.starts import COLD, RESTARTS, Flying, Starts

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

FRAMES_PER_S = 1_000_000 // packets.FRAME_US

# Periods of messages, in frames.
HEARTBEAT = FRAMES_PER_S
ATTITUDE = 2
VFR_HUD = 5
SERVOS = 5
STATUS = FRAMES_PER_S // 2
RADIO = FRAMES_PER_S

# While the link is lost, the report is repeated with this period in frames.
LOST = 10 * FRAMES_PER_S

# The longest wait for a packet. A signal that comes just before a wait does not
# end it.
LOOKS_S = 1.0

SYSTEM_ID = 1
COMPONENT_ID = 1

M_PER_S_PER_KNOT = 1852 / 3600
M_PER_FT = 0.3048
FT_PER_MIN_TO_M_PER_S = M_PER_FT / 60

# Unknown values of fields of 8 bits and more.
UNKNOWN_8 = 255
UNKNOWN_16 = 65_535
NO_HEADING = -1

# A surface's whole travel is 1000 us of a servo's pulse, its middle 1500.
PULSE_MIDDLE_US = 1500
WORDS_PER_US = 4.096

# The scale of a SiK radio, which ground stations convert back into dBm.
RSSI_PER_DB = 1.9
RSSI_ZERO_DB = -127.0

SENSED_BY = {
    "SENSOR_3D_GYRO": ("roll_rate", "pitch_rate", "yaw_rate"),
    "SENSOR_3D_ACCEL": ("lateral_acceleration", "longitudinal_acceleration",
                        "vertical_acceleration"),
    "SENSOR_ABSOLUTE_PRESSURE": ("altitude",),
    "SENSOR_DIFFERENTIAL_PRESSURE": ("airspeed",),
    "AHRS": ("roll_attitude", "pitch_attitude"),
    "SENSOR_BATTERY": ("battery_volts",)}
"""The words of each sensor that MAVLink has."""

ROM_OR_SELF_TEST = 6
"""Bits of the downlink's error word."""

MOST_TEXT = 50


def mavlink(
    listen: str = typer.Option(
        "udp:127.0.0.1:6005", metavar="udp:HOST:PORT",
        help="Port of the frame packets: urv_gsc --publish. HOST is this"
        " machine's loopback."),
    to: str = typer.Option(
        "udp:127.0.0.1:14550", metavar="udp:HOST:PORT",
        help="Destination of MAVLink."),
):
    """Send the flight as MAVLink 2, until interrupted."""
    from urv import web

    here = station.address("--listen", listen)
    there = station.address("--to", to)
    if not web.is_loopback(here[0]):
        raise faults.Refused(
            f"--listen {faults.quoted(listen)}: not this machine's loopback")
    receiver = station.bound(socket.SOCK_DGRAM, *here, "--listen")
    receiver.settimeout(LOOKS_S)
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
    bridge = Bridge(Sender(there))
    terminal = outputs.Terminal()
    try:
        terminal.say(
            f"mavlink: from udp:{here[0]}:{receiver.getsockname()[1]}"
            f" to udp:{there[0]}:{there[1]}")
        if not web.is_loopback(there[0]):
            terminal.say("mavlink: whoever is on that network can read it")
        while True:
            try:
                packet = receiver.recvfrom(4096)
            except TimeoutError:
                continue
            bridge.datagram(*packet)
    except KeyboardInterrupt:
        terminal.say(
            f"mavlink: {bridge.frames} frames, {bridge.missing} missing,"
            f" {bridge.bad} bad, {bridge.sender.sent} messages,"
            f" {bridge.sender.not_sent} not sent")
    terminal.close()
    if terminal.problem() is not None:
        raise faults.Failed(terminal.problem())


class Sender:
    """A file for datagrams, which never blocks."""

    def __init__(self, there: tuple[str, int]) -> None:
        self._socket, self._there = station.sender_to("--to", there)
        self._socket.setblocking(False)
        self.sent = 0
        self.not_sent = 0

    def write(self, data: bytes) -> None:
        try:
            self._socket.sendto(data, self._there)
            self.sent += 1
        except OSError:
            self.not_sent += 1


class Bridge:
    """Frame packets in, MAVLink out."""

    def __init__(self, sender: Any,
                 now: Callable[[], float] = time.monotonic) -> None:
        from pymavlink.dialects.v20 import common

        self.sender = sender
        self._now = now
        self.frames = 0
        self.bad = 0
        self.missing = 0
        self._runs = Runs()
        self._starts = Starts()
        self._flight = Flight(common, self._starts)
        self._link = common.MAVLink(
            sender, srcSystem=SYSTEM_ID, srcComponent=COMPONENT_ID)

    def datagram(self, data: bytes, came_from: Any = None) -> None:
        """Sends the due messages for the frame in a datagram, if there is
        one."""
        try:
            frame = FramePacket.decode(data)
        except packets.PacketError:
            self.bad += 1
            return
        if not self._runs.take(frame, self._now(),
                               came_from and came_from[:2]):
            self.bad += 1
            return
        self.missing += self._runs.missing
        if self._runs.began:
            self._flight = Flight(self._flight.dialect, self._starts,
                                  self._flight.flying)
        self.frames += 1
        try:
            for message in self._flight.messages(frame, self._runs.age):
                self._link.send(message)
        except Exception:  # noqa: BLE001 - one bad frame costs itself
            self.bad += 1


@dataclass
class Due:
    """The messages with a period in frames."""

    every: int
    _next: int = 0

    def now(self, sequence: int) -> bool:
        """True if the message is due, and is then done. After a gap the rhythm
        is the earlier one."""
        if sequence < self._next:
            return False
        self._next = sequence - sequence % self.every + self.every
        return True


@dataclass
class Flight:
    """One run of the ground's node, and its reports so far."""

    dialect: Any
    starts: Starts = field(default_factory=Starts)
    flying: Flying = field(default_factory=Flying)
    _heartbeat: Due = field(default_factory=lambda: Due(HEARTBEAT))
    _attitude: Due = field(default_factory=lambda: Due(ATTITUDE))
    _hud: Due = field(default_factory=lambda: Due(VFR_HUD))
    _servos: Due = field(default_factory=lambda: Due(SERVOS))
    _status: Due = field(default_factory=lambda: Due(STATUS))
    _radio: Due = field(default_factory=lambda: Due(RADIO))
    _laws: dict[str, int] = field(default_factory=dict)
    _repeats: Repeats = field(default_factory=Repeats)
    _state: LinkState = LinkState.NEVER_HEARD
    _lost_at: int = 0
    _lost_next: int = 0
    _refused: int = 0
    _frames: int = 0
    _stale: int = 0
    _late_next: int | None = None

    def messages(self, frame: FramePacket,
                 age_s: float = 0.0) -> Iterator[Any]:
        """The due messages for this frame, whose age is age_s. The
        aircraft's values are sent only with a frame that is fresh and not
        late: the first one when they are due."""
        is_late = age_s >= view.LOST_S
        if is_late and frame.is_fresh:
            frame = replace(frame, downlink_age=int(
                age_s / packets.FRAME_S))
        self._frames += 1
        self._stale += not frame.is_fresh
        flew = self.flying.now
        self.flying.look(frame)
        value = {
            name: items.COLUMNS[name].value(word)
            for name, word in frame.columns.items()
            if items.COLUMNS[name].is_scaled}
        sequence = frame.sequence
        if (frame.link_state == LinkState.HEARD and not is_late
                and self._heartbeat.now(sequence)):
            yield self.heartbeat(frame)
        if frame.is_fresh:
            if self._attitude.now(sequence):
                yield self.attitude(frame, value)
            if self._servos.now(sequence):
                yield self.servos(frame)
            if self._hud.now(sequence):
                yield self.hud(value)
        if self._status.now(sequence):
            yield self.status(frame, value)
        if self._radio.now(sequence):
            yield self.radio(frame, value)
        yield from self.late_texts(frame, age_s if is_late else None)
        yield from self.start_texts(frame, flew)
        yield from self.texts(frame)

    def heartbeat(self, frame: FramePacket) -> Any:
        """The aircraft is heard."""
        mav = self.dialect
        broken = frame.columns["gsc.downlink.error"] & ROM_OR_SELF_TEST
        mode = (mav.MAV_MODE_FLAG_AUTO_ENABLED
                if frame.pilot == Pilot.FLIES
                else mav.MAV_MODE_FLAG_MANUAL_INPUT_ENABLED)
        state = mav.MAV_STATE_STANDBY
        if self.flying.now:
            mode |= mav.MAV_MODE_FLAG_SAFETY_ARMED
            state = mav.MAV_STATE_ACTIVE
        return mav.MAVLink_heartbeat_message(
            mav.MAV_TYPE_FIXED_WING, mav.MAV_AUTOPILOT_GENERIC, mode, 0,
            mav.MAV_STATE_CRITICAL if broken else state, 3)

    def attitude(self, frame: FramePacket, value: dict[str, float]) -> Any:
        """There is no compass: the heading is not-a-number."""
        down = "gsc.downlink.{}".format
        return self.dialect.MAVLink_attitude_message(
            boot_ms(frame),
            math.radians(value[down("roll_attitude")]),
            math.radians(value[down("pitch_attitude")]), math.nan,
            *(math.radians(value[down(name)])
              for name in ("roll_rate", "pitch_rate", "yaw_rate")))

    def servos(self, frame: FramePacket) -> Any:
        """The positions of the surfaces, as pulses that would hold them
        there."""
        pulses = [pulse_us(frame.columns[f"gsc.downlink.{name}"])
                  for name in laws.SURFACES]
        return self.dialect.MAVLink_servo_output_raw_message(
            frame.sequence * packets.FRAME_US % 2 ** 32, 0,
            *pulses, *[0] * (16 - len(pulses)))

    def hud(self, value: dict[str, float]) -> Any:
        """Speeds and heights. Ground speed and heading are unknown."""
        down = "gsc.downlink.{}".format
        climb = view.derive(value)["vertical_speed"]
        return self.dialect.MAVLink_vfr_hud_message(
            value[down("airspeed")] * M_PER_S_PER_KNOT, math.nan,
            NO_HEADING, round(value["gsc.uplink.throttle"]),
            (value[down("altitude")] + value[down("altitude_offset")])
            * M_PER_FT,
            climb * FT_PER_MIN_TO_M_PER_S)

    def status(self, frame: FramePacket, value: dict[str, float]) -> Any:
        """Sensors, battery, and the number of frames that were not fresh since
        the last call."""
        mav = self.dialect
        battery = items.COLUMNS["gsc.downlink.battery_volts"]
        volts = value["gsc.downlink.battery_volts"]
        air = (mav.MAV_SYS_STATUS_SENSOR_3D_GYRO
               | mav.MAV_SYS_STATUS_SENSOR_3D_ACCEL
               | mav.MAV_SYS_STATUS_SENSOR_ABSOLUTE_PRESSURE
               | mav.MAV_SYS_STATUS_SENSOR_DIFFERENTIAL_PRESSURE
               | mav.MAV_SYS_STATUS_AHRS)
        power = mav.MAV_SYS_STATUS_SENSOR_BATTERY
        healthy = 0
        if frame.is_fresh:
            low = power if battery.level(volts) == "warning" else 0
            healthy = (air | power) & ~(low | self.doubted(frame))
        dropped = 10_000 * self._stale // self._frames
        self._frames = self._stale = 0
        errors = {node: sum(event.row.count for event in frame.events
                            if event.node == node)
                  for node in packets.NODES}
        return mav.MAVLink_sys_status_message(
            air | power, air | power, healthy, 0,
            min(round(volts * 1000), UNKNOWN_16 - 1)
            if frame.is_fresh else UNKNOWN_16, -1, -1,
            dropped, in_16(frame.link["downlink_bad"]),
            in_16(errors["mcs"]), in_16(errors["gsc"]),
            in_16(frame.link["resets"]), in_16(frame.link["overruns"]))

    def doubted(self, frame: FramePacket) -> int:
        """The sensors that the laws reject."""
        told = laws.Laws.of(frame)
        found = 0
        for name in told.not_valid if told else ():
            for sensor, words in SENSED_BY.items():
                if name in words:
                    found |= getattr(self.dialect,
                                     f"MAV_SYS_STATUS_{sensor}")
        return found

    def radio(self, frame: FramePacket, value: dict[str, float]) -> Any:
        """The uplink at the aircraft's receiver is the remote side."""
        level = UNKNOWN_8
        if frame.is_fresh:
            level = rssi(value["gsc.downlink.uplink_signal_strength"])
        return self.dialect.MAVLink_radio_status_message(
            UNKNOWN_8, level, 100, UNKNOWN_8, UNKNOWN_8,
            in_16(frame.link["downlink_bad"]), 0)

    def late_texts(self, frame: FramePacket,
                   age_s: float | None) -> Iterator[Any]:
        """Frames arrive long after they were made. The report is repeated
        while that lasts, and ends with another report."""
        mav = self.dialect
        if age_s is None:
            if self._late_next is not None:
                self._late_next = None
                yield self.text(mav.MAV_SEVERITY_INFO, "frames in time")
        elif self._late_next is None or frame.sequence >= self._late_next:
            self._late_next = frame.sequence + LOST
            yield self.text(mav.MAV_SEVERITY_CRITICAL,
                            f"frames {age_s:.1f} s late")

    def start_texts(self, frame: FramePacket, flew: bool) -> Iterator[Any]:
        """Every start of a node. A cold start of the aircraft in flight is
        critical."""
        mav = self.dialect
        for start in self.starts.look(frame):
            in_flight = start.node == "mcs" and start.kind == COLD and flew
            yield self.text(
                mav.MAV_SEVERITY_CRITICAL if in_flight
                else mav.MAV_SEVERITY_WARNING,
                f"{start.node} {start.kind}: {start.count}"
                + " in flight" * in_flight)

    def link_texts(self, frame: FramePacket) -> Iterator[Any]:
        """Changes of the link. A loss is repeated while it lasts, and so is
        the arrival of refused blocks."""
        mav = self.dialect
        changed = frame.link_state != self._state
        self._state = frame.link_state
        refused = frame.logs[0][packets.KINDS.index("block_refused")].count
        if self._state == LinkState.HEARD:
            self._refused = refused
            if changed:
                yield self.text(mav.MAV_SEVERITY_INFO, "link heard")
            return
        if changed:
            self._lost_at = frame.sequence
            self._lost_next = frame.sequence + LOST
            yield self.text(mav.MAV_SEVERITY_CRITICAL, "link lost")
        elif (self._state == LinkState.LOST
                and frame.sequence >= self._lost_next):
            self._lost_next += LOST
            seconds = (frame.sequence - self._lost_at) // FRAMES_PER_S
            yield self.text(mav.MAV_SEVERITY_CRITICAL,
                            f"link lost for {seconds} s")
        if refused > self._refused and self._repeats.take(
                ("link", "refused"), refused,
                frame.sequence / FRAMES_PER_S) is not None:
            yield self.text(mav.MAV_SEVERITY_CRITICAL,
                            f"link refused: {refused} blocks")

    def texts(self, frame: FramePacket) -> Iterator[Any]:
        """News of the link, the laws and the error logs. Errors that a lost
        link causes in each frame wait for its end."""
        mav = self.dialect
        yield from self.link_texts(frame)
        yield from self.law_texts(frame)
        for event in frame.events:
            key = event.node, event.kind
            if view.is_held_scan(event, frame):
                self._repeats.pass_over(key, event.row.count)
            if event.kind in RESTARTS or (
                    self._state != LinkState.HEARD and event.node == "gsc"
                    and event.kind in {*view.LOSS_KINDS, "block_refused"}):
                continue
            new = self._repeats.take(
                key, event.row.count, frame.sequence / FRAMES_PER_S)
            if new is None:
                continue
            severity = (
                mav.MAV_SEVERITY_CRITICAL
                if event.kind in view.WARNING_KINDS else
                mav.MAV_SEVERITY_WARNING
                if event.kind in view.CAUTION_KINDS else
                mav.MAV_SEVERITY_INFO)
            yield self.text(
                severity, f"{event.node} {event.kind}: {event.row.count}"
                + left_out(new))

    def law_texts(self, frame: FramePacket) -> Iterator[Any]:
        """News of the laws: modes and failures."""
        told = laws.Laws.of(frame)
        if not frame.is_fresh:
            return
        mav = self.dialect
        now = {} if told is None else {
            f"laws: {told.mode}": mav.MAV_SEVERITY_INFO,
            **{f"alone: {name}": mav.MAV_SEVERITY_CRITICAL
               for name in laws.ALONE if name == told.link},
            **{f"{name} not valid": mav.MAV_SEVERITY_WARNING
               for name in told.not_valid},
            **{f"{name} failed": mav.MAV_SEVERITY_CRITICAL
               for name in told.failed}}
        if told is not None and told.not_valid == laws.SENSORS:
            # As after a start: one text for one reason.
            now = {text: severity for text, severity in now.items()
                   if not text.endswith(" not valid")}
            now["no sensor is valid"] = mav.MAV_SEVERITY_WARNING
        for text, severity in now.items():
            if text not in self._laws:
                yield self.text(severity, text)
        self._laws = now

    def text(self, severity: int, text: str) -> Any:
        return self.dialect.MAVLink_statustext_message(
            severity, text.encode("ascii")[:MOST_TEXT])


def boot_ms(frame: FramePacket) -> int:
    """The frame's beginning, in the time of the ground's node."""
    return frame.sequence * (packets.FRAME_US // 1000) % 2 ** 32


def pulse_us(word: int) -> int:
    """1000 to 2000."""
    middle = items.COLUMNS["gsc.downlink.left_aileron"].zero_word
    return round(PULSE_MIDDLE_US + (word - middle) / WORDS_PER_US)


def rssi(dbm: float) -> int:
    """In the scale of a SiK radio; the last value means unknown."""
    return max(0, min(UNKNOWN_8 - 1,
                      round(RSSI_PER_DB * (dbm - RSSI_ZERO_DB))))


def in_16(count: int) -> int:
    """The last value also means more."""
    return min(count, 2 ** 16 - 1)
