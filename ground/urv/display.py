# SPDX-License-Identifier: Apache-2.0
"""The display of a flight for Yamcs: attitude, air data, surfaces, engine and
electrical, link health (GND-32), and missing frames (GND-34).

An .opi file, which Yamcs's pages show. Units, ranges and limits are those of
urv.items; Yamcs itself marks values that are out of date or beyond a limit.
"""

from __future__ import annotations

from xml.etree import ElementTree

from urv import items, laws, packets, xtce

BACK, TEXT, DIM = (18, 23, 28), (242, 245, 247), (163, 175, 186)
AMBER, RED, WHITE = (255, 176, 0), (255, 116, 104), (242, 245, 247)
TRACK = (39, 48, 58)
LOST, DOUBT, PICK = (179, 20, 12), (138, 86, 0), (0, 100, 122)
WIDTH, HEIGHT = 1240, 772
WIDGETS = "org.csstudio.opibuilder.widgets."
KINDS = {"Label": "Label", "Rectangle": "Rectangle", "gauge": "Gauge",
         "TextUpdate": "Text Update", "progressbar": "Progress Bar"}
SURFACES = ("left_flap_2", "left_flap_1", "left_aileron", "left_elevator",
            "left_rudder", "right_rudder", "right_elevator", "right_aileron",
            "right_flap_1", "right_flap_2")
# The number of 20 ms frames without a fresh downlink.
LOST_FRAMES = 15
# An instrument shows the range of flight, not that of its word.
RANGES = {"airspeed": (0, 130), "altitude": (0, 2000), "rpm": (0, 8000),
          "battery_volts": (16, 34), "alternator_volts": (16, 34),
          "roll_attitude": (-90, 90), "pitch_attitude": (-45, 45)}


def flight() -> str:
    """The text of the file."""
    display = _Display()
    display.box(8, 8, 300, 684, "Link health")
    rows = [("frames", "/URV/frames"), ("link", "/URV/link_state"), ("console", "/URV/console_state"),
            ("pilot", "/URV/pilot"),
            ("age of downlink, frames", "/URV/downlink_age"),
            ("frame", "/URV/sequence")]
    rows += [(name.replace("_", " "), f"/URV/link/{name}")
             for name in (*packets.LINK_COUNTS, "blocks_refused")]
    rows += [(f"laws: {name}", f"/URV/laws/{name}")
             for name in ("link", "lateral", "vertical", "power")]
    for row, (label, name) in enumerate(rows):
        display.row(20, 38 + 28 * row, 276, label, name)
    signal = "uplink_signal_strength"
    display.row(20, 38 + 28 * len(rows), 276, "signal", down(signal), signal)
    # Beside the link's state, in place of its label.
    display.told(14, 66, 160, 28, "BLOCKS REFUSED",
                 "/URV/link/blocks_refused", "pv0 > 0", LOST)

    display.box(316, 8, 450, 330, "Attitude")
    display.gauge(326, 40, 210, "roll_attitude", "roll")
    display.gauge(546, 40, 210, "pitch_attitude", "pitch")
    for at, name in enumerate(("roll_rate", "pitch_rate", "yaw_rate")):
        display.row(326 + 145 * (at % 3), 292, 140,
                    name.replace("_", " "), down(name), name, 74)

    display.box(774, 8, 458, 330, "Air data")
    display.gauge(784, 40, 210, "airspeed", "airspeed")
    display.gauge(1014, 40, 210, "altitude", "altitude")
    for at, name in enumerate(("alpha", "beta", "vertical_acceleration")):
        label = {"vertical_acceleration": "load"}.get(name, name)
        display.row(784 + 148 * (at % 3), 292, 142, label, down(name), name,
                    50)

    display.box(316, 346, 450, 346, "Engine and electrical")
    for at, name in enumerate(("rpm", "battery_volts", "alternator_volts")):
        display.gauge(326 + 147 * at, 378, 132, name,
                      name.replace("_volts", ""))
    for at, name in enumerate(("throttle", "brake")):
        item = items.COLUMNS[f"gsc.uplink.{name}"]
        y = 574 + 36 * at
        display.label(326, y, 80, 28, f"{name} up")
        display.bar(416, y, 220, 28, f"/URV/gsc/uplink/{name}",
                    0, item.at_4095)
        display.value(640, y, 116, 28, f"/URV/gsc/uplink/{name}", 0)
    display.told(420, 576, 66, 24, "FAILED", "/URV/laws/failed",
                 f"(pvInt0 & {1 << laws.FAILING.index('throttle')}) != 0",
                 LOST)
    display.row(326, 648, 430, "field", down("altitude_offset"),
                "altitude_offset", 80)

    display.box(774, 346, 458, 346, "Surfaces")
    for at, name in enumerate(SURFACES):
        item = items.COLUMNS[f"gsc.downlink.{name}"]
        y = 376 + 31 * at
        most = max(-item.at_0, item.at_4095)
        display.label(784, y, 116, 26, name.replace("_", " "))
        display.bar(900, y, 220, 26, down(name), -most, most, marker=True)
        display.value(1128, y, 98, 26, down(name), 1)
        bit = 1 << laws.SURFACES.index(name)
        display.told(904, y + 2, 66, 22, "FAILED", "/URV/laws/failed",
                     f"(pvInt0 & {bit}) != 0", LOST)
    display.box(8, 700, 1224, 66, "Switches")
    display.told(110, 704, 190, 24, "LAWS OFF, OR WAITING", "/URV/laws/link",
                 f'pvStr0 == "{laws.LINK[0]}"', DOUBT)
    for at, item in enumerate(items.SWITCHES):
        x = 20 + 151 * at
        display.label(x, 730, 112, 30, f"{at + 1} {item.use}")
        display.label(x + 112, 732, 30, 26, "off")
        display.told(x + 112, 732, 34, 26, "ON",
                     f"/URV/gsc/uplink/{item.name}", "pv0 >= 0.5", PICK)
    # Yamcs marks values out of date only after a second.
    display.told(316, 8, 916, 684, "NO DOWNLINK", "/URV/downlink_age",
                 f"pv0 >= {LOST_FRAMES}", LOST, 34)
    for box, text in (((8, 68, 300, 624), ""),
                      ((8, 700, 1224, 66), ""),
                      ((316, 8, 916, 684), "FRAMES MISSING")):
        display.told(*box, text, "/URV/frames",
                     f'pvStr0 == "{xtce.FRAMES[1]}"', LOST, 34)
    return display.text()


def down(name: str) -> str:
    """The parameter of a word of the downlink."""
    return f"/URV/gsc/downlink/{name}"


class _Display:
    def __init__(self) -> None:
        self.root = ElementTree.Element(
            "display", typeId="org.csstudio.opibuilder.Display",
            version="1.0.0")
        self._set(self.root, name="Flight", widget_type="Display",
                  width=WIDTH, height=HEIGHT, x=0, y=0,
                  auto_zoom_to_fit_all="true", show_grid="false",
                  show_ruler="false")
        self._common(self.root)
        self._colour(self.root, "background_color", BACK)
        self._colour(self.root, "foreground_color", TEXT)

    def text(self) -> str:
        ElementTree.indent(self.root)
        return ('<?xml version="1.0" encoding="UTF-8"?>\n'
                + ElementTree.tostring(self.root, encoding="unicode") + "\n")

    def box(self, x: int, y: int, width: int, height: int,
            title: str) -> None:
        widget = self._widget("Rectangle", x, y, width, height, title)
        self._set(widget, line_width=1, line_style=0, transparent="false",
                  fill_level=0, horizontal_fill="true", gradient="false")
        self._colour(widget, "background_color", BACK)
        for name in ("line_color", "bg_gradient_color", "fg_gradient_color"):
            self._colour(widget, name, (70, 82, 94))
        self.label(x + 10, y + 4, width - 20, 28, title, 14, bold=True)

    def label(self, x: int, y: int, width: int, height: int, text: str,
              size: int = 10, bold: bool = False) -> None:
        widget = self._widget("Label", x, y, width, height, text)
        self._set(widget, text=text, transparent="true",
                  horizontal_alignment=0, vertical_alignment=1,
                  auto_size="false", wrap_words="false")
        self._font(widget, size, bold)
        self._colour(widget, "foreground_color", TEXT if bold else DIM)

    def row(self, x: int, y: int, width: int, label: str, name: str,
            item: str | None = None, labelled: int = 180) -> None:
        self.label(x, y, labelled, 28, label)
        places = (items.COLUMNS[f"gsc.downlink.{item}"].decimals
                  if item else 0)
        self.value(x + labelled, y, width - labelled, 28, name,
                   min(places, 2))

    def value(self, x: int, y: int, width: int, height: int, name: str,
              places: int) -> None:
        widget = self._widget("TextUpdate", x, y, width, height, name)
        self._set(widget, pv_name=name, text="--", precision=places,
                  precision_from_pv="false", show_units="true",
                  format_type=1 if places else 0, horizontal_alignment=2,
                  vertical_alignment=1, transparent="false",
                  border_alarm_sensitive="true",
                  forecolor_alarm_sensitive="true", wrap_words="false",
                  auto_size="false")
        self._font(widget, 10, True)
        self._colour(widget, "foreground_color", TEXT)
        self._colour(widget, "background_color", BACK)

    def told(self, x: int, y: int, width: int, height: int, text: str,
             name: str, when: str, colour: tuple[int, int, int],
             size: int = 9) -> None:
        """A label over other widgets, while the condition holds."""
        widget = self._widget("Label", x, y, width, height, text,
                              shown=(name, when))
        self._set(widget, text=text, transparent="false",
                  horizontal_alignment=1, vertical_alignment=1,
                  auto_size="false", wrap_words="false")
        self._font(widget, size, True)
        self._colour(widget, "foreground_color", (255, 255, 255))
        self._colour(widget, "background_color", colour)

    def gauge(self, x: int, y: int, size: int, item: str,
              label: str) -> None:
        low, high = RANGES[item]
        name = down(item)
        widget = self._widget("gauge", x, y, size, size, name)
        self._set(widget, pv_name=name, minimum=low, maximum=high,
                  limits_from_pv="false", show_scale="true",
                  show_minor_ticks="false", major_tick_step_hint=50,
                  show_value_label="false", effect_3d="false",
                  transparent_background="true", ramp_gradient="false",
                  border_alarm_sensitive="true", log_scale="false",
                  value_label_format="")
        limits = items.COLUMNS[f"gsc.downlink.{item}"].limits
        markers = False
        for level, limit, colour in (
                ("lolo", "warning_low", RED), ("lo", "caution_low", AMBER),
                ("hi", "caution_high", AMBER), ("hihi", "warning_high", RED)):
            there = limit in limits and low < limits[limit] < high
            markers = markers or there
            self._set(widget, **{f"show_{level}": str(there).lower(),
                                 f"level_{level}": limits.get(limit, low)})
            self._colour(widget, f"color_{level}", colour)
        self._set(widget, show_markers=str(markers).lower())
        self._colour(widget, "needle_color", WHITE)
        self._colour(widget, "foreground_color", TEXT)
        self._colour(widget, "background_color", TRACK)
        self._font(widget, 8, False)
        places = min(items.COLUMNS[f"gsc.downlink.{item}"].decimals, 2)
        # A small one has its value below its name.
        wide = size > 150
        self.label(x + 2, y + size + 6 * wide, 84, 28, label)
        self.value(x + (size - 110) * wide, y + size + (6 if wide else 28),
                   108 if wide else size, 28, name, places)
        further, bit = divmod(laws.SENSORS.index(item), laws.WORD_BITS)
        self.told(x + size // 2 - 38, y + size // 2 + 12, 76, 22,
                  "NOT VALID",
                  f"/URV/laws/not_valid_{('low', 'high')[further]}",
                  f"(pvInt0 & {1 << bit}) != 0", DOUBT)

    def bar(self, x: int, y: int, width: int, height: int, name: str,
            low: float, high: float, marker: bool = False) -> None:
        widget = self._widget("progressbar", x, y, width, height, name)
        self._set(widget, pv_name=name, minimum=low, maximum=high,
                  limits_from_pv="false", show_scale="false",
                  show_label="false", show_markers="false", effect_3d="false",
                  horizontal="true", origin=0, origin_ignored="false",
                  indicator_mode=str(marker).lower(), border_alarm_sensitive="true",
                  log_scale="false", transparent_background="true",
                  show_minor_ticks="false", major_tick_step_hint=50,
                  scale_format="", value_label_format="")
        for level in ("lolo", "lo", "hi", "hihi"):
            self._set(widget, **{f"show_{level}": "false",
                                 f"level_{level}": low})
            self._colour(widget, f"color_{level}", AMBER)
        self._colour(widget, "fill_color", WHITE)
        self._font(widget, 8, False, "scale_font")
        self._colour(widget, "color_fillbackground", TRACK)
        self._colour(widget, "foreground_color", TEXT)
        self._colour(widget, "background_color", BACK)
        self._font(widget, 8, False)

    def _widget(self, kind: str, x: int, y: int, width: int, height: int,
                name: str, shown: tuple[str, str] | None = None
                ) -> ElementTree.Element:
        """Shown always, or while the condition of a parameter holds."""
        widget = ElementTree.SubElement(
            self.root, "widget", typeId=WIDGETS + kind, version="1.0.0")
        self._set(widget, widget_type=KINDS[kind], name=name, x=x, y=y, width=width,
                  height=height, visible=str(shown is None).lower(), enabled="true", tooltip="",
                  wuid=f"urv:{len(self.root)}", border_style=0,
                  border_width=1)
        self._colour(widget, "border_color", DIM)
        self._common(widget)
        if shown is not None:
            name, when = shown
            rule = ElementTree.SubElement(
                widget.find("rules"), "rule", name="shown",
                prop_id="visible", out_exp="false")
            ElementTree.SubElement(
                ElementTree.SubElement(rule, "exp", bool_exp=when),
                "value").text = "true"
            ElementTree.SubElement(rule, "pv", trig="true").text = name
        scales = ElementTree.SubElement(widget, "scale_options")
        self._set(scales, width_scalable="true", height_scalable="true",
                  keep_wh_ratio="false")
        return widget

    @staticmethod
    def _common(element: ElementTree.Element) -> None:
        """Properties that Yamcs's pages require, even if empty."""
        for name in ("scripts", "rules"):
            ElementTree.SubElement(element, name)
        ElementTree.SubElement(element, "actions", hook="false",
                               hook_all="false")
        macros = ElementTree.SubElement(element, "macros")
        ElementTree.SubElement(macros, "include_parent_macros").text = "true"

    @staticmethod
    def _set(element: ElementTree.Element, **values: object) -> None:
        for name, value in values.items():
            ElementTree.SubElement(element, name).text = str(value)

    @staticmethod
    def _colour(element: ElementTree.Element, name: str,
                colour: tuple[int, int, int]) -> None:
        red, green, blue = map(str, colour)
        ElementTree.SubElement(
            ElementTree.SubElement(element, name), "color",
            red=red, green=green, blue=blue)

    @staticmethod
    def _font(element: ElementTree.Element, size: int, bold: bool,
              name: str = "font") -> None:
        ElementTree.SubElement(
            ElementTree.SubElement(element, name), "opifont.name",
            fontName="Liberation Sans", height=str(size),
            style="1" if bold else "0").text = "URV"
