# SPDX-License-Identifier: Apache-2.0
"""GND-52: gamepads on the pilot's page, in a headless Chromium.

The browser's gamepads are window.pads; a test moves them.
"""

import pytest
from station_rig import Station, take_sticks, until
from test_page import CONTRAST, Pages

STANDARD = "Vendor Pad (STANDARD GAMEPAD)"
YOKE = "Flight Yoke 44f"
PADS = """
window.make = (id, index, mapping, axes, buttons) => ({id, index, mapping,
  connected: true, axes: Array(axes).fill(0),
  buttons: Array.from({length: buttons}, () => ({pressed: false, value: 0}))});
window.pads = [];
navigator.getGamepads = () => window.pads;
window.press = (pad, at, on) => {
  pads[pad].buttons[at] = {pressed: on, value: on ? 1 : 0};
};
"""
MAKE_STANDARD = f"pads[0] = make('{STANDARD}', 0, 'standard', 4, 17)"
MAKE_YOKE = f"pads[1] = make('{YOKE}', 1, '', 5, 12)"


@pytest.fixture
def station(standard, tmp_path):
    with Station(standard / "record.csv", tmp_path, row=100) as station:
        station.flying()
        yield station


@pytest.fixture
def pages(browser, station):
    pages = Pages(browser, station)
    yield pages
    for context in pages.contexts:
        context.close()
    assert pages.errors == []


class Pilot:
    """A page that flies, with what the node hears of it."""

    def __init__(self, station, page):
        self.station, self.page = station, page

    def do(self, script):
        self.page.evaluate(script)
        return self

    def heard(self, name):
        return self.station.node.heard[-1][1].columns[f"console.{name}"]

    def until(self, name, word):
        until(lambda: self.station.node.heard and self.heard(name) == word,
              f"{name} {word}")

    def stays(self, name, word, packets=25):
        """For a number of packets."""
        first = len(self.station.node.heard)
        until(lambda: len(self.station.node.heard) >= first + packets,
              "packets")
        assert {packet.columns[f"console.{name}"] for _, packet
                in self.station.node.heard[first:]} == {word}

    def source(self, text):
        self.page.locator("#source.caution", has_text=text).wait_for()

    def told(self, text):
        self.station.logged(text)


@pytest.fixture
def pilot(station, pages):
    return Pilot(station, pages.open(script=PADS))


def test_gnd52_all_eight_switches_are_on_the_gamepad(pilot):
    pilot.do(MAKE_STANDARD).told(f"flies by gamepad: {STANDARD}")
    take_sticks(pilot.page)
    pilot.until("roll", 2048)
    for number, button in ((1, 1), (2, 2), (3, 3), (4, 5), (5, 14), (6, 15),
                           (7, 4), (8, 0)):
        before = pilot.heard(f"switch{number}")
        pilot.do(f"press(0, {button}, true)")
        pilot.until(f"switch{number}", 4095 - before)
        pilot.do(f"press(0, {button}, false)")
        pilot.stays(f"switch{number}", 4095 - before, 3)


def test_gnd52_another_gamepad_never_replaces_a_lost_one(pilot):
    page = pilot.page
    pilot.do(MAKE_STANDARD).told("flies by gamepad")
    take_sticks(page)
    pilot.do("pads[0].axes[2] = 1").until("roll", 4095)
    # Another one of another name is at its place, fully to the left.
    pilot.do("pads[0] = make('Other', 0, 'standard', 4, 17);"
             "pads[0].axes[2] = -1")
    pilot.source("gamepad lost")
    silent = pilot.station.wait(lambda state: not state["live"], "no sticks")
    for name in ("GAMEPAD", "OTHER GAMEPAD"):
        page.locator("#alert_list li.caution", has_text=name).first.wait_for()
    pilot.told(f"lost its gamepad: {STANDARD}")
    pilot.station.sends_nothing(silent, 25)
    # By mouse and keyboard it is not used, either.
    page.keyboard.press("t")
    pilot.stays("roll", 2048)
    pilot.source("another gamepad, not used")
    # The pilot chooses it; it counts when it has been in the middle.
    page.keyboard.press("g")
    page.locator("#pad_list .use").click()
    pilot.source("roll to the middle")
    pilot.stays("roll", 2048)
    pilot.do("pads[0].axes[2] = 0")
    pilot.stays("roll", 2048, 10)
    pilot.do("pads[0].axes[2] = -1").until("roll", 0)


@pytest.mark.parametrize("used, name, word", [
    ("press(0, 7, true)", "brake", 4095),
    ("pads[0].axes[1] = -1", "throttle", 4095)], ids=["brake", "throttle"])
def test_gnd22_a_gamepad_that_only_braked_is_missed(pilot, used, name, word):
    """Its loss let go of the brake, and the sticks went up as before."""
    pilot.do(MAKE_STANDARD).told("flies by gamepad")
    take_sticks(pilot.page)
    pilot.do(used).until(name, word)
    pilot.do("pads.pop()").source("gamepad lost, no sticks go up")
    silent = pilot.station.wait(lambda state: not state["live"], "no sticks")
    pilot.station.sends_nothing(silent, 25)


def test_gnd52_a_chosen_gamepad_without_its_mapping_is_not_said_to_fly(
        pilot):
    pilot.page.evaluate(
        "([id, text]) => localStorage.setItem(`urv.pad.${id}`, text)",
        [YOKE, '{"roll": {"axis": 0, "sign": 1}, "pitch": {"axis": 1,'
         ' "sign": 1}}'])
    pilot.do(f"pads[0] = make('{YOKE}', 0, '', 5, 12)")
    pilot.told("flies by gamepad")
    take_sticks(pilot.page)
    pilot.do("pads[0].axes[0] = 1").until("roll", 4095)
    pilot.page.keyboard.press("g")
    pilot.page.locator("#pad_list .forget").click()
    pilot.until("roll", 2048)
    pilot.source("gamepad not mapped any more, not used: press G")


def test_gnd52_a_lost_gamepad_that_returns_counts_from_its_middle(pilot):
    pilot.do(MAKE_STANDARD).told("flies by gamepad")
    take_sticks(pilot.page)
    pilot.do("pads[0].axes[2] = 1").until("roll", 4095)
    pilot.do("window.kept = pads.pop()").source("gamepad lost")
    pilot.do("pads.push(kept)").told("has its gamepad again")
    pilot.until("roll", 2048)
    pilot.stays("roll", 2048)
    pilot.do("pads[0].axes[2] = -0.5")
    until(lambda: pilot.heard("roll") < 1500, "to the left")


def test_gnd52_first_values_do_not_count(pilot):
    """Axes, trigger and buttons that are not at rest from the beginning."""
    page = pilot.page
    pilot.do(MAKE_STANDARD + "; pads[0].axes = [1, 1, -1, 0.6];"
             "press(0, 7, true); press(0, 0, true); press(0, 4, true)")
    pilot.told("flies by gamepad")
    take_sticks(page)
    pilot.until("roll", 2048)
    throttle, brake = pilot.heard("throttle"), pilot.heard("brake")
    flaps = pilot.heard("switch8")
    for name, word in (("roll", 2048), ("pitch", 2048), ("yaw", 2048),
                       ("throttle", throttle), ("brake", brake),
                       ("switch8", flaps), ("switch7", 0)):
        pilot.stays(name, word, 5)
    pilot.source("roll to the middle, pitch to the middle, yaw to the middle,"
                 " release the brake")
    # A value that is no number never counts.
    pilot.do("pads[0].axes[2] = NaN").stays("roll", 2048)
    # From one side to the other it passes through the middle.
    pilot.do("pads[0].axes[2] = 0.5").stays("roll", 2048)
    pilot.do("pads[0].axes[2] = -1").until("roll", 0)


def test_gnd52_a_gamepad_without_mapping_is_used_when_mapped(pilot, pages):
    page = pilot.page
    pilot.do("pads[0] = null; " + MAKE_YOKE + "; pads[1].axes[3] = -1")
    pilot.told("not used until the pilot maps it: " + YOKE)
    pilot.source("gamepad not mapped, not used: press G")
    take_sticks(page)
    pilot.do("pads[1].axes[0] = 1").stays("roll", 2048)
    pilot.do("pads[1].axes[0] = 0")
    page.keyboard.press("g")
    page.locator("#pad_list .map").click()
    # Its own senses: roll is axis 1 the other way round, throttle a lever.
    for name, axis, value, rest in (("roll", 1, -0.9, 0), ("pitch", 0, 1, 0),
                                    ("throttle", 3, 1, -1)):
        page.locator(f"#map_{name} .set").click()
        page.locator("#pad_hint.caution").wait_for()
        pilot.do(f"pads[1].axes[{axis}] = {value}")
        page.locator(f"#map_{name} output", has_text=f"axis {axis}").wait_for()
        pilot.do(f"pads[1].axes[{axis}] = {rest}")
    for name, button in (("switch4", 11), ("switch7", 2), ("release", 3)):
        page.locator(f"#map_{name} .set").click()
        pilot.do(f"press(1, {button}, true)")
        page.locator(f"#map_{name} output",
                     has_text=f"button {button}").wait_for()
        pilot.do(f"press(1, {button}, false)")
    # Nothing of it flies while it is mapped.
    pilot.do("pads[1].axes[1] = -1").stays("roll", 2048)
    page.locator("#close_pads").click()
    pilot.do("pads[1].axes[1] = 0").stays("roll", 2048)
    pilot.do("pads[1].axes[1] = -1").until("roll", 4095)
    # The lever takes over when it meets the throttle.
    throttle = pilot.heard("throttle")
    assert throttle > 1000
    pilot.stays("throttle", throttle, 10)
    pilot.source("throttle lever to")
    pilot.do("pads[1].axes[3] = 1").until("throttle", 4095)
    pilot.do("pads[1].axes[3] = 0").until("throttle", 2048)
    # Inverted, it is the other way round.
    page.keyboard.press("g")
    page.locator("#pad_list .map").click()
    page.locator("#map_roll .invert").click()
    page.locator("#map_roll output", has_text="axis 1 +").wait_for()
    page.locator("#close_pads").click()
    pilot.do("pads[1].axes[1] = 0").stays("roll", 2048, 10)
    pilot.do("pads[1].axes[1] = -1").until("roll", 0)
    pilot.do("press(1, 11, true)").until("switch4", 4095)
    pilot.do("press(1, 3, true)")
    page.wait_for_selector("#holder:not(.mine)")
    # Remembered by the browser, for that name.
    again = page.context.new_page()
    again.add_init_script(PADS + MAKE_YOKE)
    again.goto(pilot.station.url)
    again.wait_for_selector("body[data-down=fresh]")
    pilot.station.logged(f"flies by gamepad: {YOKE}", 2)


def test_gnd52_a_mapping_that_is_spoiled_is_none(pilot):
    """The browser's memory may hold anything."""
    for text in ("{", "[]", "7", '{"roll": 1}',
                 '{"roll": {"axis": 99, "sign": 1}, "pitch": {"axis": 0,'
                 ' "sign": 1}}', '{"roll": {"axis": 0, "sign": 5}}'):
        pilot.page.evaluate(
            "([id, text]) => localStorage.setItem(`urv.pad.${id}`, text)",
            [YOKE, text])
        pilot.do(f"pads[0] = make('{YOKE}', 0, '', 5, 12)")
        pilot.source("gamepad not mapped, not used")
        pilot.do("pads.pop()")
        until(lambda: "mapped" not in pilot.page.locator(
            "#source").inner_text(), "none there")


def test_gnd52_of_several_the_pilot_chooses(pilot):
    pilot.do(MAKE_STANDARD + "; pads[1] = make('Second', 1, 'standard', 4,"
             " 17)")
    pilot.source("several gamepads: press G to choose one")
    pilot.told("has another gamepad")
    take_sticks(pilot.page)
    pilot.do("pads[0].axes[2] = 1; pads[1].axes[2] = -1").stays("roll", 2048)
    pilot.do("pads[0].axes[2] = 0; pads[1].axes[2] = 0")
    page = pilot.page
    other = page.locator("#alert_list li.caution:not(.past)",
                         has_text="OTHER GAMEPAD")
    other.wait_for()
    page.keyboard.press("g")
    page.locator("#pad_list .map").first.click()
    page.locator("#map_roll .set").click()
    page.locator("#pad_hint.caution").wait_for()
    # GND-28: on the page as a whole, and to be read.
    assert page.evaluate(CONTRAST) == []
    assert page.evaluate("""() => {
      const all = document.getElementById("gamepads");
      const box = all.getBoundingClientRect();
      return all.scrollHeight <= all.clientHeight + 1 && box.top >= 0
        && all.scrollWidth <= all.clientWidth + 1
        && box.bottom <= innerHeight;
    }""")
    page.locator("#close_pads").click()
    page.keyboard.press("g")
    page.locator("#pad_list .use").nth(1).click()
    pilot.told("flies by gamepad: Second")
    other.wait_for(state="detached")
    pilot.stays("roll", 2048)
    pilot.do("pads[0].axes[2] = 1; pads[1].axes[2] = -1").until("roll", 0)
