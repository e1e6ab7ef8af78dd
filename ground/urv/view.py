# SPDX-License-Identifier: Apache-2.0
"""The state of the flight from the frame packets, prepared for display (GND-4,
GND-7, GND-20, GND-26).

Age comes before value (GND-25): every value has its age, and missing frames
are not invented. The age of a frame is from its own time, not from its arrival
(GND-56). The flying party is that in the node's answer (GND-58).
"""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from urv import items, packets
from urv.alerts import CAUTION, INFO, WARNING, Alerts
from urv.answers import OTHER, Answers
from urv.deck import Deck
from urv.laws import ALONE, DOES, FAILING, SENSORS, Laws
from urv.repeats import Repeats, left_out
from urv.runs import RIVAL_S, Runs, Sender
from urv.starts import COLD, RESTARTS, Flying, Start, Starts

if TYPE_CHECKING:
    from urv.processes import Report

LOST_S = 0.5
"""An older word is crossed out, and the link counts as lost."""
STARTS_S = 10.0
"""The time that the ground's node has for its first frame, before their absence
is an alert: the station starts before it. Pages show it at once."""

KNOT_FT_MIN = 6076.12 / 60
LOG_LINES = 500
REFUSING_S = 1.0
"""After the last refused block a link counts as refusing for this time."""

WARNING_KINDS = {"self_test_failed", "rom_check_failed", "surface_failed"}
CAUTION_KINDS = {"warm_reset", "processor_restart", "task_overrun",
                 "link_reset", "link_block_bad", "link_block_scrapped",
                 "input_out_of_range", "ad_no_scan", "link_loss_state",
                 "sensor_not_valid", "block_refused"}
ALERT_KINDS = {"self_test_failed", "rom_check_failed", "block_refused"}
LOSS_KINDS = {"telin_no_block", "no_input", "core_no_downlink", "link_reset",
              "link_block_bad", "link_block_scrapped", "link_block_cleared"}
"""Errors at the ground that a lost link causes in every frame: they are
reported when the aircraft is heard again."""
WHY_REFUSED = {1: "of the other format", 2: "another key", 3: "a key of"
               " another number", 4: "a hello within a session"}
"""The reason, by the detail of block_refused."""

LAWS_SETTLE = 100
"""Frames from the first one received: after a start the laws reject every
sensor for a second, which is no news."""
ERROR_BITS = ((2, "ROM", "its ROM differs from what was loaded"),
              (4, "SELF-TEST", "its self-test has failed"))


@dataclass(frozen=True)
class Line:
    """One line of the station's log."""

    number: int
    time_us: int
    frame: int | None
    level: str
    kind: str
    text: str

    def shown(self) -> dict[str, Any]:
        """For pages, the file and the archive."""
        return dict(vars(self))


@dataclass
class View:
    """The newest state of the flight, its alerts and its log."""

    told: Callable[[Line], None] = lambda line: None
    now: Callable[[], float] = time.monotonic
    frame: packets.FramePacket | None = None
    values: list[float | None] = field(
        default_factory=lambda: [None] * len(packets.COLUMNS))
    derived: dict[str, float | None] = field(default_factory=dict)
    deck: Deck = field(default_factory=Deck)
    laws: Laws | None = None
    laws_state: str = "unknown"
    """True if the aircraft has its laws on: "unknown", "off", "on"."""
    alerts: Alerts = field(default_factory=Alerts)
    log: deque[Line] = field(default_factory=lambda: deque(maxlen=LOG_LINES))
    frames: int = 0
    bad: int = 0
    missing: int = 0
    late: int = 0
    foreign: int = 0
    """Datagrams of a machine whose frames are not taken."""
    answers: Answers = field(default_factory=Answers)
    refused: int = 0
    flying: Flying = field(default_factory=Flying)
    _runs: Runs = field(default_factory=Runs)
    _starts: Starts = field(default_factory=Starts)
    _repeats: Repeats = field(default_factory=Repeats)
    _foreign_at: float = float("-inf")
    _refused_at: float = float("-inf")
    _answered_at: float = float("-inf")
    _blocks: int = 0
    _lines: int = 0
    _began: float = 0.0
    _came: float = float("-inf")
    _made: float = float("-inf")
    _latest_s: float = 0.0
    _fault: str = ""
    _second: deque[tuple[float, bool]] = field(default_factory=deque)
    _fresh: int = 0
    _steady: int = 0
    """Fresh downlinks since the last frame without one."""

    def __post_init__(self) -> None:
        self._began = self.now()

    # Inputs

    def datagram(self, data: bytes, sender: Sender | None = None) -> bool:
        """True if it is a new frame packet. A fault in this code costs only
        this datagram (GND-57)."""
        try:
            return self._take(data, sender)
        except Exception as error:  # noqa: BLE001 - whatever it is
            self.bad += 1
            fault = f"{type(error).__name__}: {error}"
            if fault != self._fault:
                self._fault = fault
                self.note(CAUTION, "packet",
                          f"a frame could not be shown: {fault}")
            return False

    def stranger(self, host: str) -> None:
        """A datagram has arrived from a machine whose frames are not taken."""
        self.foreign += 1
        self.alerts.report(
            "foreign", WARNING, "FOREIGN FRAMES",
            f"{host} sends to this port, too: nothing of it is taken",
            time.time_ns() // 1000)
        self._foreign_at = self.now()

    def _take(self, data: bytes, sender: Sender | None) -> bool:
        try:
            frame = packets.FramePacket.decode(data)
        except packets.PacketError as error:
            self.bad += 1
            if self.bad == 1:
                self.note(CAUTION, "packet", f"dropped, and others as they"
                          f" come: {error}")
            return False
        old = self.frame
        now = self.now()
        if not self._runs.take(frame, now, sender):
            self.late += 1
            return False
        if self._runs.set_by:
            self.note(CAUTION, "run", "the clock of the ground's node was set"
                      f" by {self._runs.set_by:.1f} s")
        first = self._runs.began
        if first:
            # The counts of another run begin at 0.
            self._repeats.forget()
            self.answers.begin()
            self._fresh = 0
            self._blocks = self.refused = 0
            self.laws_state = "unknown"
            self.deck.begin()
        gap = self._runs.missing
        if gap > 0:
            self.missing += gap
            self.alerts.report(
                "frames", CAUTION, "FRAMES",
                f"{gap} missing before frame {frame.sequence}",
                frame.time_us)
        self.frame = frame
        self.frames += 1
        self._came = now
        self._made = made = now - self._runs.age
        self._second.append((made, frame.is_fresh))
        if first:
            self.note(INFO, "run", f"the ground's node runs, frame"
                      f" {frame.sequence}")
        self._calibrate(frame)
        self._link(frame, made)
        self._find_starts(frame, now)
        self._limits(frame, now)
        self._states(frame, old, now)
        self._laws(frame, now)
        self.deck.look(frame, now)
        self.tell_of_cards()
        self._errors(frame, now)
        self.answers.look(frame, made, now)
        self._drops(frame, now)
        self.look(now)
        return True

    def tell_of_cards(self) -> None:
        """Writes the events of test cards into the log."""
        for level, text in self.deck.said:
            self.note(level, "card", f"card {text}")
        self.deck.said.clear()

    def sent(self, sequence: int) -> None:
        """A console packet has left, and should appear in a frame."""
        self.answers.sent(sequence, self.now())

    def look(self, now: float) -> None:
        """Applies the changes due to time alone."""
        age = self.age_s(now)
        while self._second and now - self._second[0][0] > 1.0:
            self._second.popleft()
        self._look_at_age(age, now)
        down = self.downlink_s(now)
        is_old = down is not None and down >= LOST_S
        # The aircraft answers, without news.
        answers = now - self._answered_at < LOST_S
        self._alert_over_time(
            "link", is_old and not answers, "LINK LOST",
            f"no downlink for {LOST_S} s", now)
        self._alert_over_time(
            "sensors", is_old and answers, "SENSORS OLD",
            "the aircraft answers, but has no new scan of its sensors", now)
        self._alert_over_time(
            "sticks refused", self.answers.is_refused(now), "STICKS REFUSED",
            "the ground's node takes no packet of this station" + (
                ": another console flies" if self.answers.flies == OTHER
                else ""), now)
        if self._runs.has_rival(now):
            rival = self._runs.rival
            self.alerts.report(
                "rival", WARNING, "TWO GROUNDS",
                "another ground's node sends frames here, too"
                + (f", from {rival[0]}, port {rival[1]}" if rival else ""),
                time.time_ns() // 1000)
        else:
            self.alerts.away("rival", now)
        if now - self._foreign_at > RIVAL_S:
            self.alerts.away("foreign", now)
        # A gap is momentary: it is over when the frames arrive again.
        if age is not None and age < LOST_S:
            self.alerts.away("frames", now, 5.0)
        for alert in self.alerts.raised:
            self.note(alert.level, "alert", f"{alert.name}: {alert.text}",
                      alert.came_us)
        self.alerts.raised.clear()

    def _look_at_age(self, age: float | None, now: float) -> None:
        """Checks whether frames arrive, and in time."""
        waits, most = ((now - self._began, STARTS_S) if self.frame is None
                       else (now - self._came, LOST_S))
        self._alert_over_time(
            "silent", waits >= most, "NO FRAMES",
            "nothing comes from the ground's node", now)
        is_late = (age is not None and age >= LOST_S > waits)
        if is_late:
            self._latest_s = max(self._latest_s, age)
        self._alert_over_time(
            "late", is_late, "FRAMES LATE",
            f"frames arrive {age or 0.0:.1f} s after they were made: the"
            " shown values are old", now)
        if self._latest_s and not self.alerts.active("late"):
            self.note(INFO, "frames", "frames came up to"
                      f" {self._latest_s:.1f} s late")
            self._latest_s = 0.0

    def _alert_over_time(self, key: str, is_so: bool, name: str, text: str,
                         now: float) -> None:
        if is_so:
            self.alerts.report(key, WARNING, name, text,
                               time.time_ns() // 1000)
        else:
            self.alerts.away(key, now)

    def report(self, report: Report) -> None:
        """A report about another program of the flight."""
        if report.active:
            self.alerts.report(report.key, report.level, report.name,
                               report.text, time.time_ns() // 1000)
        else:
            self.alerts.away(report.key, self.now(), 0.0)

    def note(self, level: str, kind: str, text: str,
             time_us: int | None = None) -> Line:
        """Adds a line to the log."""
        self._lines += 1
        line = Line(self._lines,
                    time.time_ns() // 1000 if time_us is None else time_us,
                    self._frame_of(time_us), level, kind, text)
        self.log.append(line)
        self.told(line)
        return line

    def _frame_of(self, time_us: int | None) -> int | None:
        """The ground's frame of a line: the given one, or by default the frame
        that the node is in now, even if the newest received frame is old."""
        if self.frame is None or time_us is not None:
            return None if self.frame is None else self.frame.sequence
        now = self.now()
        behind = self.age_s(now) if now - self._came < LOST_S else 0.0
        return self.frame.sequence + int(behind / packets.FRAME_S)

    # Ages

    def age_s(self, now: float) -> float | None:
        """Seconds since the newest frame packet was made, by its own time;
        None before the first."""
        return None if self.frame is None else max(0.0, now - self._made)

    def clock_ahead_us(self) -> int | None:
        """The difference from a frame's time to this machine's UTC; None
        before the first frame."""
        if self.frame is None:
            return None
        made_utc_s = time.time() - (self.now() - self._runs.offset)
        return round((made_utc_s - self._runs.zero_s) * 1e6)

    def downlink_s(self, now: float) -> float | None:
        """The age of the downlink's words; None before the first."""
        if self.frame is None or self.frame.downlink_age == packets.NEVER:
            return None
        waited = max(0.0, now - self._made - packets.FRAME_S)
        return self.frame.downlink_age * packets.FRAME_S + waited

    def shown(self) -> dict[str, Any]:
        """The state for pages, 25 times a second."""
        now = self.now()
        age = self.age_s(now)
        down = self.downlink_s(now)
        state: dict[str, Any] = {
            "age_ms": None if age is None else round(age * 1000),
            "down_ms": None if down is None else round(down * 1000),
            "silent_ms": (None if self.frame is None
                          else round((now - self._came) * 1000)),
            "packets": {"frames": self.frames, "bad": self.bad,
                        "missing": self.missing, "late": self.late,
                        "foreign": self.foreign},
            "fresh": sum(fresh for _, fresh in self._second),
            "rate": len(self._second)}
        if self.frame is None:
            return state
        return state | {
            "seq": self.frame.sequence,
            "time_us": self.frame.time_us,
            "link": self.frame.link_state.name.lower(),
            "refused": self.refused,
            "refusing": now - self._refused_at < REFUSING_S,
            "answers": now - self._answered_at < LOST_S,
            "flying": self.flying.now,
            "console": self.frame.console_state.name.lower(),
            "pilot": self.frame.pilot.name.lower(),
            "counts": self.frame.link,
            "stick_ms": self.answers.stick_ms,
            "flies": self.answers.flies,
            "sticks_refused": self.answers.is_refused(now),
            "laws": None if self.laws is None else {
                "short": self.laws.short, "mode": self.laws.mode,
                "link": self.laws.link, "alone": self.laws.is_alone,
                "not_valid": self.laws.not_valid,
                "serial": self.laws.serial, "table": self.laws.table,
                "failed": self.laws.failed},
            "laws_state": self.laws_state,
            "cards": self.deck.shown(),
            "words": self.frame.words,
            "values": self.values,
            "derived": self.derived}

    # Contents of a frame

    def _calibrate(self, frame: packets.FramePacket) -> None:
        never = frame.downlink_age == packets.NEVER
        self.values = []
        for column, word in zip(packets.COLUMNS, frame.words, strict=True):
            item = items.COLUMNS[column]
            missing = never and column.startswith("gsc.downlink")
            self.values.append(
                None if missing or not item.is_scaled else
                round(item.value(word), 4))
        value = dict(zip(packets.COLUMNS, self.values, strict=True))
        self.derived = derive(value)

    def _limits(self, frame: packets.FramePacket, now: float) -> None:
        if not frame.is_fresh:
            return
        for column, value in zip(packets.COLUMNS, self.values, strict=True):
            item = items.COLUMNS[column]
            if value is None or not column.startswith("gsc.downlink"):
                continue
            found = item.level(value)
            for level in (CAUTION, WARNING):
                key = f"{column} {level}"
                if found == level:
                    self.alerts.report(
                        key, level, heading(item.name),
                        f"{value:.{item.decimals}f} {item.unit}"
                        f" ({limit_of(item, level, value)})", frame.time_us)
                else:
                    self.alerts.away(key, now)

    def _states(self, frame: packets.FramePacket,
                old: packets.FramePacket | None, now: float) -> None:
        alerts = self.alerts
        # Before the first console a silent console is no news.
        state = None
        if (frame.pilot != packets.Pilot.FLIES and frame.counts[
                packets.LINK_COUNTS.index("console_packets")] > 0):
            state = frame.console_state
        for lost, name, text in (
                (packets.ConsoleState.HELD, "STICKS HELD",
                 "console lost: no fresh words are sent, the aircraft reacts"
                 " as to a lost link"),
                (packets.ConsoleState.NEUTRAL, "STICKS NEUTRAL",
                 "console lost on the ground: engine idle, brake on")):
            self._alert_if(state == lost, lost.name.lower(), WARNING, name,
                           text, now)
        for node, column in (("mcs", "gsc.downlink.error"),
                             ("gsc", "gsc.uplink.error")):
            word = frame.words[packets.COLUMNS.index(column)]
            for bit, name, text in ERROR_BITS:
                key = f"{node} {name}"
                if word & bit:
                    alerts.report(key, WARNING, f"{name} {node.upper()}",
                                  f"{node}: {text}", frame.time_us)
                else:
                    alerts.away(key, now)
        if old is not None and old.run == frame.run:
            for name, before, after in (
                    ("the console", old.console_state, frame.console_state),
                    ("the link", old.link_state, frame.link_state),
                    ("the simulated pilot", old.pilot, frame.pilot)):
                if before != after:
                    word = after.name.lower().replace("_", " ")
                    self.note(INFO, "state", f"{name}: {word}")

    def _laws(self, frame: packets.FramePacket, now: float) -> None:
        """Handles the status of the aircraft's laws; ignores an old one."""
        self._fresh += frame.is_fresh
        self._steady = self._steady + 1 if frame.is_fresh else 0
        told = Laws.of(frame)
        if (told and told.mode) != (self.laws and self.laws.mode):
            self.note(INFO, "state", "the laws: "
                      + ("no report" if told is None else told.mode))
        self.laws = told
        if told is not None:
            self.laws_state = "on"
        elif frame.version >= packets.WHOLE and self._steady >= LAWS_SETTLE:
            # A lost downlink may have had a part of the laws' row.
            self.laws_state = "off"
        if not frame.is_fresh or self._fresh < LAWS_SETTLE:
            return
        link, not_valid, failed = (
            ("", (), ()) if told is None else
            (told.link, told.not_valid, told.failed))
        for name in ALONE:
            self._alert_if(name == link, f"laws {name}", WARNING,
                           f"ALONE: {name.upper()}", DOES[name], now)
        # One text for one reason.
        self._alert_if(not_valid == SENSORS, "laws sensors", CAUTION,
                       "SENSORS NOT VALID", "the laws believe none", now)
        for name in SENSORS:
            self._alert_if(
                name in not_valid and not_valid != SENSORS,
                f"laws sensor {name}", CAUTION,
                f"{heading(name)} NOT VALID",
                "the laws fly without this sensor", now)
        for name in FAILING:
            self._alert_if(name in failed, f"laws surface {name}", WARNING,
                           f"{heading(name)} FAILED",
                           "it does not follow its servo", now)

    def _alert_if(self, is_so: bool, key: str, level: str, name: str,
                  text: str, now: float) -> None:
        if is_so:
            self.alerts.report(key, level, name, text, self.frame.time_us)
        else:
            self.alerts.away(key, now, 0.0)

    def _link(self, frame: packets.FramePacket, now: float) -> None:
        """Checks whether blocks arrive, and whether the ground takes them."""
        row = frame.logs[0][packets.KINDS.index("block_refused")]
        came = frame.link["downlink_received"]
        if row.count > self.refused:
            self.refused = row.count
            self._refused_at = now
        elif came > self._blocks:
            self._answered_at = now
        self._blocks = came
        is_heard = frame.link_state == packets.LinkState.HEARD
        if not is_heard and now - self._refused_at < REFUSING_S:
            why = WHY_REFUSED.get(row.detail, "not the aircraft's")
            self.alerts.report(
                "refused", WARNING, "LINK REFUSED",
                f"blocks come, and none is taken: {why}", frame.time_us)
        else:
            self.alerts.away("refused", now)

    def _find_starts(self, frame: packets.FramePacket, now: float) -> None:
        flew = self.flying.now
        self.flying.look(frame)
        for start in self._starts.look(frame):
            in_flight = start.node == "mcs" and start.kind == COLD and flew
            level = WARNING if in_flight else CAUTION
            text = told_of(start, in_flight)
            self.note(level, "error",
                      f"{start.node} {start.kind}: {text}", frame.time_us)
            key = f"{start.node} {start.kind}"
            # An occurrence: each one is a new alert.
            self.alerts.away(key, now, 0.0)
            self.alerts.report(
                key, level, f"{heading(start.kind)} {start.node.upper()}",
                text, frame.time_us)

    def _errors(self, frame: packets.FramePacket, now: float) -> None:
        is_heard = frame.link_state == packets.LinkState.HEARD
        for event in frame.events:
            key = (event.node, event.kind)
            if is_held_scan(event, frame):
                self._repeats.pass_over(key, event.row.count)
            if event.kind in RESTARTS or (
                    not is_heard and event.node == "gsc"
                    and event.kind in LOSS_KINDS):
                continue
            new = self._repeats.take(key, event.row.count, now)
            if new is None:
                continue
            level = (WARNING if event.kind in WARNING_KINDS else
                     CAUTION if event.kind in CAUTION_KINDS else INFO)
            what = f"{event.node} {event.kind}"
            detail = f", detail {event.row.detail}" if event.row.detail else ""
            self.note(level, "error", f"{what}: {event.row.count} times, last"
                      f" in its frame {event.row.last_frame}{detail}"
                      + left_out(new), frame.time_us)
            if event.kind in ALERT_KINDS:
                # An occurrence: each one is a new alert.
                self.alerts.away(what, now, 0.0)
                self.alerts.report(
                    what, level,
                    f"{heading(event.kind)} {event.node.upper()}",
                    f"{event.row.count} times, last in frame"
                    f" {event.row.last_frame}", frame.time_us)

    def _drops(self, frame: packets.FramePacket, now: float) -> None:
        """Handles the datagrams that the node has dropped at its console
        port."""
        if self.answers.new_drops:
            self.alerts.report(
                "drops", CAUTION, "CONSOLE PACKETS DROPPED",
                f"the ground's node dropped {self.answers.new_drops} at its"
                " console port: another console sends, or they came late",
                frame.time_us)
        else:
            self.alerts.away("drops", now)


def is_held_scan(event: packets.Event, frame: packets.FramePacket) -> bool:
    """True if the ground's converter completes no scan because the console is
    lost."""
    return ((event.node, event.kind) == ("gsc", "ad_no_scan")
            and frame.console_state == packets.ConsoleState.HELD)


def told_of(start: Start, in_flight: bool) -> str:
    """The number of starts, and the last one in the node's own frames."""
    if start.kind == COLD:
        return "it has started again" + " in flight" * in_flight
    return f"{start.count} times, last in its frame {start.frame}"


def heading(name: str) -> str:
    """The name of an item or a kind as the title of an alert."""
    short = name
    for long in ("_volts", "_strength", "_attitude", "uplink_"):
        short = short.replace(long, "")
    return short.replace("_", " ").upper()


def limit_of(item: items.Item, level: str, value: float) -> str:
    """The limit that the value has passed, in words."""
    low = item.limits.get(f"{level}_low")
    if low is not None and value < low:
        return f"below {low:g} {item.unit}"
    return f"above {item.limits[f'{level}_high']:g} {item.unit}"


def derive(value: dict[str, float | None]) -> dict[str, float | None]:
    """Values derived from those of several sensors.

    It assumes calm air, and equates calibrated and true airspeed: at a few
    hundred feet they differ by a hundredth.
    """
    names = ("roll_attitude", "pitch_attitude", "alpha", "beta", "pitch_rate",
             "yaw_rate", "airspeed")
    found = [value[f"gsc.downlink.{name}"] for name in names]
    if None in found:
        return {"vertical_speed": None, "heading_rate": None,
                "flight_path": None}
    roll, pitch, alpha, beta = (math.radians(x) for x in found[:4])
    pitch_rate, yaw_rate, airspeed = found[4:]
    climb = (math.cos(alpha) * math.cos(beta) * math.sin(pitch)
             - math.sin(beta) * math.sin(roll) * math.cos(pitch)
             - math.sin(alpha) * math.cos(beta) * math.cos(roll)
             * math.cos(pitch))
    upright = max(abs(math.cos(pitch)), 0.05)
    rate = (pitch_rate * math.sin(roll) + yaw_rate * math.cos(roll)) / upright
    return {"vertical_speed": round(airspeed * KNOT_FT_MIN * climb, 1),
            "heading_rate": round(rate, 3),
            "flight_path": round(math.degrees(math.asin(
                max(-1.0, min(1.0, climb)))), 3)}
