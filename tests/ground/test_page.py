# SPDX-License-Identifier: Apache-2.0
"""The pilot's page in a headless Chromium, beside a stand-in of the node.

GND-25 values and their age, GND-26 alerts, GND-28 sizes and contrast.
"""

import re
import signal

import pytest
from fake_node import recording_of
from station_rig import KEYS_COUNT, PATIENCE_S, Station, take_sticks, until

from urv import items, laws, packets

SIZES = [(1280, 800), (1440, 900), (1920, 1080), (820, 1180), (400, 800)]
# A page of a slow machine shows that its data is old (GND-56).
ALIVE = "body[data-down=fresh], body[data-down=old]"
NOT_FRESH = "body[data-down=old], body[data-down=lost]"


@pytest.fixture
def record(standard):
    return standard / "record.csv"


@pytest.fixture
def station(record, tmp_path):
    with Station(record, tmp_path, "--recordings", tmp_path,
                 row=100) as station:
        station.flying()
        yield station


class Pages:
    """Pages of one browser; none may say an error."""

    def __init__(self, browser, station):
        self.browser, self.station = browser, station
        self.errors = []
        self.contexts = []

    def open(self, width=1280, height=800, scheme="dark", script=None,
             until=ALIVE):
        context = self.browser.new_context(
            viewport={"width": width, "height": height}, color_scheme=scheme)
        context.set_default_timeout(PATIENCE_S * 1000)
        self.contexts.append(context)
        page = context.new_page()
        page.on("console", lambda message: self.errors.append(message.text)
                if message.type in ("error", "warning") else None)
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.add_init_script(KEYS_COUNT + (script or ""))
        page.goto(self.station.url)
        page.wait_for_selector(until)
        return page

    def close(self, page):
        self.contexts.remove(page.context)
        page.context.close()


@pytest.fixture
def pages(browser, station):
    pages = Pages(browser, station)
    yield pages
    for context in pages.contexts:
        context.close()
    assert pages.errors == []


def seen_frame(page):
    return int(page.evaluate("document.body.dataset.seq"))


NUMBER = re.compile(r"[\u2212-]?[\d.]+")


def number(text):
    return float(NUMBER.search(text.replace("\u2007", ""))
                 .group().replace("\u2212", "-"))


def told(read):
    """The texts of values. Digits go while no frames come, which may be on a
    machine that is slow."""
    def numbers():
        texts = read()
        return texts if all(map(NUMBER.search, texts)) else None
    return until(numbers, "numbers")


METERS = ("rpm", "battery_volts", "alternator_volts", "vertical_acceleration",
          "longitudinal_acceleration", "altitude_offset")
SURFACES = ("left_flap_2", "left_flap_1", "left_aileron", "left_elevator",
            "left_rudder", "right_rudder", "right_elevator", "right_aileron",
            "right_flap_1", "right_flap_2")


def test_gnd25_every_value_on_the_page_is_the_records(station, pages):
    page = pages.open()
    station.node.speed = 0
    for row in (200, 1100, 1400, 3000, 4500, 7500):
        station.node.row = row
        shown = dict(zip(packets.COLUMNS, station.node.rows[row],
                         strict=True))

        def value(name, shown=shown):
            column = f"gsc.downlink.{name}"
            return items.COLUMNS[column].value(shown[column])
        until(lambda shown=shown: station.state()["words"]
              == list(shown.values()), "the row at the station")
        frame = station.state()["seq"]
        page.wait_for_function("seq => +document.body.dataset.seq > seq",
                               arg=frame)
        for name in METERS + SURFACES:
            place = page.locator(f"#{name}")
            text, = told(place.all_inner_texts)
            item = items.COLUMNS[f"gsc.downlink.{name}"]
            places = 1 if name in SURFACES else item.decimals
            assert number(text) == pytest.approx(
                value(name), abs=0.51 * 10 ** -places), (row, name, text)
            assert text.endswith(f" {item.unit}")
        for panel, name in (("speed", "airspeed"), ("height", "altitude")):
            exact = told(
                page.locator(f"#{panel} .exact").all_text_contents)[0]
            assert number(exact) == pytest.approx(value(name), abs=0.051)
        corners = told(page.locator("#attitude .corner").all_text_contents)
        for text, name in zip(corners, ("pitch_attitude", "roll_attitude",
                                        "alpha", "beta"), strict=True):
            wanted = value(name)
            assert number(text) in (
                pytest.approx(wanted, abs=0.051),
                pytest.approx(abs(wanted), abs=0.051)), (row, name, text)
        bank = corners[1]
        if abs(value("roll_attitude")) > 1:
            assert ("R" if value("roll_attitude") > 0 else "L") in bank
        rotation = page.locator("#attitude .ages > g").first.get_attribute(
            "transform")
        assert float(re.search(r"\((.*)\)", rotation).group(1)) == (
            pytest.approx(-value("roll_attitude"), abs=1e-3))


def test_gnd25_command_and_position_of_a_surface(station, pages):
    """The mark of the command is at the surface position that the stick asks
    for."""
    page = pages.open()
    station.node.speed = 0
    for word in (2048, 3000, 100):
        for name in ("gsc.uplink.roll", "gsc.downlink.left_aileron"):
            station.node.words[name] = word

        def at(part):
            return page.locator(
                f".surface:has(#left_aileron) g{part}").first.get_attribute(
                "transform")
        until(lambda word=word: at(":has(> .picked)") == at(
            ":has(> .position)") and station.state()["words"][
                packets.COLUMNS.index("gsc.uplink.roll")] == word,
            "both marks at one place")


def test_gnd25_a_battery_sag_is_coloured_and_listed(station, pages):
    page = pages.open()
    item = items.COLUMNS["gsc.downlink.battery_volts"]
    before = station.node.sequence
    low = item.word(item.warning_low - 1)
    station.node.words["gsc.downlink.battery_volts"] = low
    page.locator("#alert_list li.warning.unseen",
                 has_text="WARNING BATTERY").wait_for()
    page.locator(".meter.warning #battery_volts").wait_for()
    # The first frame that the station got: none was missing, or it says so.
    frame = station.logged("BATTERY")[0]["frame"]
    first = next(packet.sequence for packet in station.node.history
                 if packet.columns["gsc.downlink.battery_volts"] == low)
    assert before <= first <= frame
    assert frame - first <= station.state()["packets"]["missing"]
    until(lambda: "\u25b2" in page.locator("#battery_volts").inner_text(),
          "its mark")
    colour = page.locator("#battery_volts").evaluate(
        "element => getComputedStyle(element).color")
    assert colour == "rgb(255, 116, 104)"
    # It does not vanish, acknowledged or not.
    page.keyboard.press("k")
    page.locator("#alert_list li.warning:not(.unseen)",
                 has_text="BATTERY").wait_for()
    del station.node.words["gsc.downlink.battery_volts"]
    page.locator("#alert_list li.warning.past",
                 has_text="BATTERY").wait_for()


def test_gnd25_a_cut_link_is_reported_large_and_its_digits_go(station, pages):
    page = pages.open()
    station.node.cut = True
    page.wait_for_selector("body[data-down=old], body[data-down=lost]")
    page.wait_for_selector("body[data-down=lost]")
    lost = page.locator("#lost")
    lost.wait_for()
    assert "LINK LOST" in lost.inner_text()
    age = number(page.locator("#lost_for").inner_text())
    assert age >= 0.5
    for name in METERS + SURFACES:
        assert not re.search(r"\d", page.locator(f"#{name}").inner_text())
    assert page.locator("#speed .drums, #speed .exact").first.evaluate(
        "element => getComputedStyle(element).visibility") == "hidden"
    assert page.locator("#attitude .cross").evaluate(
        "element => getComputedStyle(element).display") != "none"
    page.locator("#alert_list li.warning", has_text="LINK LOST").wait_for()
    station.logged("LINK LOST")
    until(lambda: number(page.locator("#lost_for").inner_text()) > age,
          "seconds that go on")
    station.node.cut = False
    page.wait_for_selector("body[data-down=fresh]")
    lost.wait_for(state="hidden")


def test_gnd25_without_frames_or_station_nothing_looks_alive(
        station, pages):
    page = pages.open()
    station.node.silent = True
    page.wait_for_selector("body[data-frame=lost][data-down=lost]")
    until(lambda: "NO FRAMES" in page.locator("#lost").inner_text(),
          "NO FRAMES")
    station.node.silent = False
    page.wait_for_selector("body[data-down=fresh]")
    station.process.send_signal(signal.SIGSTOP)
    try:
        page.wait_for_selector("body[data-frame=lost][data-down=lost]")
        until(lambda: not re.search(r"\d", " ".join(
            page.locator(".meter output, .surface output, figcaption output,"
                         " #fresh, #stick_ms").all_inner_texts())),
            "no digit of old words")
        assert "not known" in page.locator("#holder").inner_text()
    finally:
        station.process.send_signal(signal.SIGCONT)
    page.wait_for_selector("body[data-down=fresh]")


# All at once: alone, no sensor that an instrument shows, five surfaces.
TROUBLE = (0x4243, 0x8C00, 0xFFFF & sum(
    1 << laws.SENSORS.index(name) - 16 for name in laws.SENSORS[16:]), 9000,
    0b0101010101)


def test_gnd7_the_laws_report_is_on_the_page(station, pages):
    station.node.laws = (0x1133,)
    page = pages.open()
    page.locator("#laws", has_text="level alt spd").wait_for()
    until(lambda: page.locator(".doubt:visible, .has_failed").count() == 0,
          "no doubt")
    station.node.laws = (
        0x2133, 0, 1 << laws.SENSORS.index("airspeed") - 16, 30,
        1 << laws.SURFACES.index("left_aileron"))
    page.locator("#laws.warning", has_text="\u25b2 HOLDING").wait_for()
    # While frames are late the page hides this; it comes back with them.
    until(lambda: page.locator("#speed .doubt").inner_text()
          == "\u25c6 airspeed not valid"
          and page.locator(".has_failed output").evaluate_all(
              "all => all.map(one => one.id)") == ["left_aileron"]
          and page.locator(".has_failed .failed").is_visible(),
          "the sensor and the surface")
    assert page.locator("#height .doubt").is_hidden()
    for name in ("ALONE: HOLDING", "LEFT AILERON FAILED",
                 "AIRSPEED NOT VALID"):
        page.locator("#alert_list li", has_text=name).wait_for()
    # Old data shows nothing.
    station.node.cut = True
    page.wait_for_selector("body[data-down=lost]")
    until(lambda: page.locator(".doubt:visible, .has_failed").count() == 0
          and page.locator("#laws").inner_text() == "\u2013\u2013",
          "nothing of the laws")


def test_gnd21_keys_mouse_and_switches_fly(station, pages):
    page = pages.open()
    until(lambda: page.locator("#switch8").is_disabled(), "no switch yet")
    take_sticks(page)
    heard = station.node.heard
    until(lambda: heard, "a console packet")
    first = heard[0][1].columns
    # The page holds what it was shown last, a moment ago.
    shown = [packet.columns["console.throttle"]
             for packet in station.node.history]
    assert min(abs(first["console.throttle"] - word) for word in shown) <= 2, (
        "taking the sticks moves nothing")
    page.keyboard.down("ArrowRight")
    until(lambda: heard[-1][1].words[0] == 3072, "half a roll")
    page.keyboard.up("ArrowRight")
    until(lambda: heard[-1][1].words[0] == 2048, "the middle again")
    page.keyboard.press("8")
    until(lambda: heard[-1][1].columns["console.switch8"] == 4095, "flaps")
    page.locator("#switch8.on", has_text="on").wait_for()
    box = page.locator("#right_stick").bounding_box()
    middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.move(*middle)
    page.mouse.down()
    page.mouse.move(middle[0] - box["width"] / 4,
                    middle[1] + box["height"] / 4)
    until(lambda: heard[-1][1].words[0] < 1500 and heard[-1][1].words[1]
          > 2600, "left and back")
    page.mouse.up()
    until(lambda: heard[-1][1].words[:2] == (2048, 2048), "let go")
    page.keyboard.down("w")
    until(lambda: heard[-1][1].columns["console.throttle"] == 4095, "full")
    page.keyboard.up("w")
    page.keyboard.press("x")
    page.wait_for_selector("#holder:not(.mine)")
    assert station.state()["holder"] is None


def held_mouse(station, page, button="left"):
    """The mouse holds the right stick to the right."""
    box = page.locator("#right_stick").bounding_box()
    at = (box["x"] + box["width"] * 0.75, box["y"] + box["height"] / 2)
    page.mouse.move(*at)
    page.mouse.down(button=button)
    return at


def stays(station, word, packets=25):
    """The roll stick, for a number of packets."""
    first = len(station.node.heard)
    until(lambda: len(station.node.heard) >= first + packets, "packets")
    assert {packet.words[0] for _, packet
            in station.node.heard[first:]} == {word}


def test_gnd22_a_release_that_the_page_does_not_see_holds_no_stick(
        station, pages):
    """The window loses its focus, a menu opens, or the system hides the
    release of a key."""
    page = pages.open()
    take_sticks(page)
    heard = station.node.heard
    until(lambda: heard, "a console packet")
    # A menu takes the release of this button.
    held_mouse(station, page, "right")
    stays(station, 2048)
    page.mouse.up(button="right")
    x, y = held_mouse(station, page)
    until(lambda: heard[-1][1].words[0] > 2800, "right")
    page.evaluate("dispatchEvent(new Event('blur'))")
    until(lambda: heard[-1][1].words[0] == 2048, "let go")
    page.mouse.move(x + 3, y)
    stays(station, 2048)
    page.mouse.up()
    held_mouse(station, page)
    until(lambda: heard[-1][1].words[0] > 2800, "right")
    page.locator("#right_stick").dispatch_event(
        "pointermove", {"buttons": 0})
    until(lambda: heard[-1][1].words[0] == 2048, "let go")
    page.mouse.up()
    for script in ("new KeyboardEvent('keyup', {key: 'Meta'})",
                   "new MouseEvent('contextmenu', {cancelable: true})"):
        page.keyboard.down("ArrowRight")
        until(lambda: heard[-1][1].words[0] == 3072, "half a roll")
        may_open = page.evaluate(f"window.dispatchEvent({script})")
        until(lambda: heard[-1][1].words[0] == 2048, "the middle")
        assert may_open == ("Meta" in script)
        page.keyboard.up("ArrowRight")


LONGEST = """
window.longest = 0;
const push = Array.prototype.push;
Array.prototype.push = function (...given) {
  const length = push.apply(this, given);
  if (given[0] instanceof Array && typeof given[0][1] === "number") {
    window.longest = Math.max(window.longest, length);
  }
  return length;
};
"""


def test_gnd36_a_hidden_page_keeps_no_states(station, pages):
    """It kept each, 90,000 an hour, and dropped them one by one in the end."""
    page = pages.open(script=LONGEST)
    page.evaluate("window.requestAnimationFrame = () => 0")
    # As when it is hidden: states come, and nothing is drawn.
    page.evaluate("""() => {
      Object.defineProperty(document, "hidden", {get: () => true,
        configurable: true});
      document.dispatchEvent(new Event("visibilitychange"));
    }""")
    first = station.state()["seq"]
    station.wait(lambda state: state["seq"] > first + 400, "400 frames")
    assert 1 < page.evaluate("window.longest") < 100


def test_gnd50_each_switch_says_what_it_does_and_whether_it_can(
        station, pages):
    page = pages.open()
    for number, item in enumerate(items.SWITCHES, 1):
        button = page.locator(f"#switch{number}")
        assert button.locator(".name").inner_text() == f"{number} {item.use}"
    # No law is told: the frames are many before that is known.
    page.locator("#switch1 .note", has_text="laws off").wait_for()
    until(lambda: [page.locator(f"#switch{number} .note").text_content()
                   for number in range(1, 9)] == [
        "laws off" if item.works == "laws" else "" for item in items.SWITCHES]
          and page.locator("#laws").inner_text() == "off", "the laws are off")
    station.node.laws = (0x1133,)
    until(lambda: not "".join(
        page.locator(".switch .note").all_text_contents()), "the laws are on")
    station.node.cut = True
    page.locator("#switch1 .note", has_text="not known").wait_for()


def test_gnd21_packets_come_fifty_times_a_second(station, pages):
    page = pages.open()
    take_sticks(page)
    heard = station.node.heard
    until(lambda: len(heard) > 300, "packets")
    # Other programs may slow the page; nothing makes it faster.
    sequences = [packet.sequence for _, packet in heard]
    assert sequences == sorted(set(sequences))
    took = heard[-1][0] - heard[0][0]
    assert len(heard) / took < 110


def test_gnd21_a_second_page_names_the_pilot_and_asks(station, pages):
    first, second = pages.open(), pages.open()
    take_sticks(first)
    second.locator("#holder", has_text="console 1 flies").wait_for()
    ask(station, first, second, lambda: first.keyboard.press("n"),
        "console 1 keeps the sticks")
    first.locator("#asked").wait_for(state="hidden")
    second.locator("#take:enabled").wait_for()
    ask(station, first, second, lambda: first.evaluate(
        "document.querySelector('#give').click()"),
        "console 2 has the sticks, console 1 had them")
    second.wait_for_selector("#holder.mine")
    first.locator("#holder", has_text="console 2 flies").wait_for()


def ask(station, first, second, answer, outcome):
    """The second page asks the first, which answers. The pages and the station
    have seconds for it: where a slow machine takes longer, the second page has
    the sticks without an answer, releases them, and it is tried again."""
    def outcomes():
        return sum(outcome in line["text"] for line in station.lines())

    before = outcomes()

    def is_answered():
        if station.state()["holder"] == 2:
            second.keyboard.press("x")
            station.wait(lambda state: state["holder"] is None, "free sticks")
        take_sticks(first)
        second.keyboard.press("t")
        until(lambda: first.locator("#asked").is_visible()
              or station.state()["holder"] == 2, "the question")
        shown = first.locator("#asking").text_content()
        answer()
        station.wait(lambda state: state["asker"] is None, "an answer")
        return "console 2 asks" in shown and outcomes() > before
    until(is_answered, outcome)


GAMEPAD = """
window.pad = {id: "test pad", connected: true, index: 0,
  axes: [0, 0, 0, 0], mapping: "standard",
  buttons: Array.from({length: 17}, () => ({pressed: false, value: 0}))};
navigator.getGamepads = () => [window.pad];
"""


def test_gnd22_a_gamepad_flies_has_a_dead_zone_and_may_be_lost(
        station, pages):
    page = pages.open(script=GAMEPAD)
    page.evaluate("pad.buttons[9] = {pressed: true, value: 1}")
    page.wait_for_selector("#holder.mine")
    heard = station.node.heard
    page.evaluate("pad.axes[2] = 0.07")
    until(lambda: len(heard) > 20, "packets")
    assert {packet.words[0] for _, packet in heard} == {2048}
    page.evaluate("pad.axes[2] = 1")
    until(lambda: heard[-1][1].words[0] == 4095, "all the way")
    page.evaluate("window.lost = pad; window.pad = null")
    page.locator("#source.caution", has_text="gamepad lost").wait_for()
    page.locator("#alert_list li.caution", has_text="GAMEPAD").wait_for()
    station.wait(lambda state: state["console"] == "neutral", "neutral")
    page.locator("#holder.warning", has_text="NEUTRAL").wait_for()
    page.evaluate("window.pad = lost")
    page.wait_for_selector("#holder.mine")


def test_gnd22_a_hidden_page_lets_the_sticks_fall_silent(station, pages):
    page = pages.open()
    take_sticks(page)
    until(lambda: station.node.heard, "packets")
    page.evaluate("""() => {
        Object.defineProperty(document, "hidden", {get: () => true,
          configurable: true});
        document.dispatchEvent(new Event("visibilitychange"));
    }""")
    station.wait(lambda state: state["console"] == "neutral", "neutral")
    assert "HIDDEN" in {
        alert["name"] for alert in station.state()["alerts"]}


def alerts_of(page, name):
    return page.locator("#alert_list li.caution", has_text=name).first


def test_gnd22_when_a_page_goes_the_others_show_it(station, pages):
    """Hidden, frozen or left: no sticks, and a caution on other pages."""
    other = pages.open()
    for number, script in enumerate((
            "dispatchEvent(new Event('pagehide'))",
            "document.dispatchEvent(new Event('freeze'))")):
        page = pages.open()
        take_sticks(page)
        first = len(station.node.heard)
        until(lambda first=first: len(station.node.heard) > first, "packets")
        page.evaluate(script)
        station.logged("HIDDEN", number + 1)
        alerts_of(other, "HIDDEN").wait_for()
        page.keyboard.press("x")
        station.wait(lambda state: state["holder"] is None, "free sticks")
    page = pages.open()
    take_sticks(page)
    until(lambda: station.state()["live"], "packets")
    page.close()
    station.wait(lambda state: state["holder"] is None, "free sticks")
    alerts_of(other, "PAGE CLOSED").wait_for()
    # The page that comes again shows it, too.
    alerts_of(pages.open(), "PAGE CLOSED").wait_for()


HANG = """(ms) => {
  const ends = performance.now() + ms;
  while (performance.now() < ends);
}"""


def test_gnd22_a_hung_page_is_shown_on_the_others_and_on_itself(
        station, pages):
    other, page = pages.open(), pages.open()
    take_sticks(page)
    until(lambda: station.state()["live"], "packets")
    page.keyboard.down("ArrowRight")
    until(lambda: station.node.heard[-1][1].words[0] == 3072, "half a roll")
    page.evaluate(HANG, 3000)
    for one in (other, page):
        alerts_of(one, "BROWSER HUNG").wait_for()
    alerts_of(other, "PAGE SILENT").wait_for()
    # A key that is still held counts, one that was released does not.
    page.keyboard.up("ArrowRight")
    until(lambda: station.node.heard[-1][1].words[0] == 2048, "the middle")
    station.logged("flies again after")


def test_gnd51_keys_that_waited_in_a_hung_browser_do_not_count(
        station, pages):
    page = pages.open()
    take_sticks(page)
    until(lambda: station.node.heard, "packets")
    # As a browser does after it hung: an event of a second ago.
    page.evaluate("""() => {
      for (const key of ["8", "ArrowRight", "w"]) {
        const event = new KeyboardEvent("keydown", {key, bubbles: true});
        Object.defineProperty(event, "timeStamp",
          {value: performance.now() - 1000});
        document.body.dispatchEvent(event);
      }
    }""")
    first = len(station.node.heard)
    until(lambda: len(station.node.heard) > first + 20, "packets")
    words = {packet.words for _, packet in station.node.heard[first:]}
    assert len(words) == 1
    assert next(iter(words))[0] == 2048 and next(iter(words))[-1] == 0


def test_gnd51_a_page_of_another_station_says_that_it_must_be_reloaded(
        station, pages):
    page = pages.browser.new_context().new_page()
    page.add_init_script("""
      const parse = JSON.parse;
      JSON.parse = (text) => {
        const found = parse(text);
        return found?.t === "hello" ? {...found, protocol: 3} : found;
      };""")
    page.goto(station.url)
    page.locator("#lost", has_text="OLD PAGE: RELOAD IT").wait_for()
    page.keyboard.press("t")
    page.wait_for_timeout(300)
    assert station.state()["holder"] is None
    page.context.close()


def test_fti8_d96_the_panel_of_cards_and_the_key_that_ends_one(
        station, pages, tmp_path):
    station.node.laws = (0x1000,)
    row = packets.CARDS_ROW - 1
    station.node.logs[1][row] = packets.LogRow(
        (1 | 1 << 4 | 1 << 8) << 16 | 7, 1 << 20, 0, 0)
    page, other = pages.open(), pages.open()
    page.keyboard.press("f")
    page.locator("#card_state.runs", has_text="card 1 runs").wait_for()
    assert page.locator("#end_card").is_disabled()
    take_sticks(page)
    page.locator("#end_card:enabled").wait_for()
    page.keyboard.press("5")
    until(lambda: station.node.heard
          and station.node.heard[-1][1].words[9] == 4_095, "switch 5 on")
    page.keyboard.press("e")
    until(lambda: station.node.heard[-1][1].words[9] == 0, "switch 5 off")
    station.node.logs[1][row] = packets.LogRow(
        (1 | 1 << 8 | 7 << 12) << 16 | 7, 1 << 20, 0, 0)
    page.locator("#card_state.caution",
                 has_text="card 1: envelope left").wait_for()
    path = tmp_path / "cards.toml"
    path.write_text("# One.\n[[card]]\nkind = 'step'\nmoves = ['yaw']\n"
                    "amplitude_deg = 1\npulse_s = 1\n", "utf-8")
    page.locator("#card_file").set_input_files(path)
    until(lambda: len(station.node.cards) == 2, "cards")
    # A watcher sees it, and cannot send.
    other.keyboard.press("f")
    other.locator("#card_order", has_text="take the sticks").wait_for()
    assert other.locator("#card_file").is_disabled()


def test_fti8_a_file_of_cards_that_cannot_be_sent_is_reported(
        station, pages, tmp_path):
    """Nothing said that it cannot be read, and "is too long" stayed until the
    next file."""
    station.node.laws = (0x1000,)
    page = pages.open()
    page.keyboard.press("f")
    take_sticks(page)
    page.locator("#end_card:enabled").wait_for()
    path = tmp_path / "cards.toml"
    path.write_text("x = 1\n" * 1_000, "utf-8")
    page.locator("#card_file").set_input_files(path)
    said = page.locator("#card_order.caution")
    said.get_by_text("cards.toml is too long").wait_for()
    page.evaluate("""() => {
      const now = performance.now.bind(performance);
      performance.now = () => now() + 11_000;
    }""")
    said.get_by_text("cards.toml is too long").wait_for(state="detached")
    page.evaluate("""() => {
      File.prototype.text = () => Promise.reject(new Error("gone"));
    }""")
    page.locator("#card_file").set_input_files(path)
    said.get_by_text("cards.toml cannot be read").wait_for()
    assert station.node.cards == []


def test_fti13_the_panel_of_the_recorder(station, pages):
    node = station.node.recorder
    node.rows = recording_of(range(2_000, 2_200))
    page, other = pages.open(), pages.open()
    page.keyboard.press("r")
    page.locator("#recorder_state", has_text="not asked yet").wait_for()
    page.locator("#ask_recorder").click()
    page.locator("#recorder_holds", has_text="200 rows, 4.0 s, of 600 s"
                 ).wait_for()
    # Text typed there moves no switch.
    page.locator("#fetch_last").press_sequentially("1")
    node.a_frame = 1
    page.locator("#fetch").click()
    page.locator("#open_recorder.runs", has_text="rec").wait_for()
    page.locator("#stop_fetch:enabled").click()
    page.locator("#recorder_state", has_text="stopped").wait_for()
    node.a_frame = 100
    wrong = list(node.rows[2_170])
    wrong[5] ^= 1
    node.rows[2_170] = tuple(wrong)
    page.locator("#fetch").click()
    page.locator("#recorder_missing.caution",
                 has_text="2170: their sums are wrong aboard").wait_for()
    page.locator("#recorder_state", has_text="rows are missing: 1").wait_for()
    page.locator("#recorder_fetched", has_text="49 of 50 rows, 98 %"
                 ).wait_for()
    # A watcher sees it, and cannot fetch.
    take_sticks(page)
    other.keyboard.press("r")
    other.locator("#recorder_missing.caution").wait_for()
    other.locator("#who_fetches", has_text="take the sticks").wait_for()
    assert other.locator("#fetch").is_disabled()


def test_gnd35_an_order_from_the_page_and_what_became_of_it(station, pages):
    station.node.laws = (0x1000,)
    page, other = pages.open(), pages.open()
    page.keyboard.press("c")
    assert page.locator("#send_order").is_disabled()
    take_sticks(page)
    page.locator("#send_order:enabled").wait_for()
    page.locator("#gains").select_option("1")
    # Text typed there moves no switch.
    page.locator("#orbit_after").fill("")
    page.locator("#orbit_after").press_sequentially("2.5")
    page.locator("#end_after").fill("61")
    send_order(page)
    page.locator("#ordered.taken", has_text="taken by the aircraft").wait_for()
    order = station.node.orders[-1]
    assert (order.table, order.orbit, order.end) == (1, 25, 610)
    until(lambda: page.locator("#in_force").inner_text() == (
        f"number {order.serial}: gains 1 (softer), orbit after 2.5 s, end"
        " after 61 s"), "it in force")
    until(lambda: station.node.heard, "sticks")
    assert station.node.heard[-1][1].words[5:] == (0,) * 8
    station.node.refuses = 3
    send_order(page)
    page.locator("#ordered.caution",
                 has_text="refused by the aircraft: a control law").wait_for()
    # A watcher sees it, and cannot order.
    other.keyboard.press("c")
    other.locator("#ordered.caution", has_text="refused").wait_for()
    assert other.locator("#send_order").is_disabled()
    # The instruments are not covered, and the stick's keys fly again.
    assert page.evaluate("""() => {
        const box = id => document.getElementById(id).getBoundingClientRect();
        return box("orders").top - box("systems").bottom;
    }""") >= -1
    page.keyboard.press("8")
    until(lambda: station.node.heard[-1][1].words[-1] == 4095, "flaps")
    page.keyboard.press("c")
    page.locator("#orders").wait_for(state="hidden")


def send_order(page):
    """The station drops an order that was half a second on its way (GND-51),
    as on a slow machine: it is sent again until the station says something."""
    before = page.locator("#ordered").text_content()

    def is_sent():
        page.locator("#send_order:enabled").click()
        for _ in range(30):
            if page.locator("#ordered").text_content() != before:
                return True
            page.wait_for_timeout(100)
        return False
    until(is_sent, "an order")


EVIL = "<img src=x onerror=document.title='owned'><script>1</script>"


def test_gnd27_what_is_typed_is_shown_and_never_run(station, pages):
    page, other = pages.open(), pages.open()
    page.keyboard.press("m")
    page.keyboard.type(EVIL)
    page.keyboard.press("Enter")
    for one in (page, other):
        line = one.locator("#lines li", has_text="mark").first
        line.wait_for()
        assert EVIL in line.inner_text()
        assert one.locator("#lines img, #lines script").count() == 0
        assert one.title() == "URV console"
    # The keys of the note moved nothing else.
    assert station.state()["holder"] is None


def overlaps(page):
    """Texts of one panel that lie over each other, or leave the page."""
    return page.evaluate("""() => {
      const seen = [...document.querySelectorAll(
        "button, output, .name, .corner, #holder, #counted, #source")]
        .filter(one => one.checkVisibility({visibilityProperty: true})
          && one.textContent.trim() && !one.closest("#lost, dialog"));
      const box = one => one.getBoundingClientRect();
      const wrong = [];
      seen.forEach((one, at) => {
        const a = box(one);
        if (a.left < -1 || a.top < -1 || a.right > innerWidth + 1
          || a.bottom > innerHeight + 1) wrong.push(["out", one.textContent]);
        if (one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0
          && one.tagName === "BUTTON") wrong.push(["cut", one.textContent]);
        for (const other of seen.slice(at + 1)) {
          if (one.contains(other) || other.contains(one)) continue;
          const b = box(other);
          if (Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1
            && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1) {
            wrong.push([one.textContent, other.textContent]);
          }
        }
      });
      return wrong;
    }""")


def settled(page, look, wanted):
    """The result of one look at the page, once it is the wanted one: a late
    machine's page is redrawn when its frames stop and come again."""
    for _ in range(50):
        seen = look()
        if seen == wanted:
            break
        page.wait_for_timeout(200)
    return seen


@pytest.mark.parametrize("scheme", ["dark", "light"])
def test_gnd28_it_fits_without_scrolling_and_nothing_overlaps(
        station, pages, scheme):
    station.node.laws = TROUBLE
    station.node.counts.update(dict.fromkeys(station.node.counts, 1234))
    page = None
    for width, height in SIZES:
        # Five pages that draw at once would be slow.
        if page is not None:
            pages.close(page)
        page = pages.open(width, height, scheme)
        page.locator("#attitude .doubt").wait_for()
        cut = page.evaluate("""() => [
            ...document.querySelectorAll("#status button")].filter(one =>
              one.getBoundingClientRect().right
              > document.getElementById("status")
                  .getBoundingClientRect().right).map(one => one.id)""")
        assert cut == [], width
        assert settled(page, lambda: page.evaluate(
            "[document.documentElement.scrollWidth,"
            " document.documentElement.scrollHeight]"), [width, height]) == [
                width, height]
        assert settled(page, lambda: overlaps(page), []) == [], width
        page.keyboard.press("c")
        inside = page.evaluate("""() => {
          const all = document.getElementById("orders");
          const box = all.getBoundingClientRect();
          return !all.open || box.width === 0
            || (all.scrollHeight <= all.clientHeight + 1
                && all.scrollWidth <= all.clientWidth + 1
                && box.right <= innerWidth && box.bottom <= innerHeight);
        }""")
        assert inside, (width, "orders")
        assert page.locator("#orders").is_visible() == (width >= 900)
        sticks = page.locator("#sticks").is_visible()
        assert sticks == (width >= 900)
        for shown in ("#attitude", "#speed", "#height", "#bars", "#alerts",
                      "#who"):
            assert page.locator(shown).is_visible(), (width, shown)
        for shown in ("#engine", "#surfaces", "#log"):
            assert page.locator(shown).is_visible() == (width >= 600), (
                width, shown)
        # No large part of the page is empty.
        assert page.evaluate("""() => Math.max(...["#alerts", "#log"].map(
            one => document.querySelector(one).getBoundingClientRect().bottom
          ))""") >= height * 0.7, width
    # The last is the small one: it cannot take the sticks.
    page.keyboard.press("t")
    page.wait_for_timeout(300)
    assert station.state()["holder"] is None


PANELS = {"c": "#orders", "f": "#cards", "r": "#recorder", "g": "#gamepads"}


def test_gnd28_one_panel_over_the_sticks_at_a_time(station, pages):
    """With the recorder's panel open the keys of orders and cards seemed to do
    nothing: theirs opened beneath it. Esc closed none of them."""
    page = pages.open()

    def shown():
        return [panel for panel in PANELS.values()
                if page.locator(panel).is_visible()]
    for key in "rcgfcr":
        page.keyboard.press(key)
        assert shown() == [PANELS[key]]
    page.keyboard.press("m")
    page.keyboard.press("Escape")
    assert shown() == ["#recorder"]
    page.keyboard.press("Escape")
    assert shown() == []
    page.locator("#open_cards").click()
    page.locator("#configure").click()
    assert shown() == ["#orders"]
    page.keyboard.press("c")
    assert shown() == []


CUT_BUTTONS = """() => [...document.querySelectorAll("aside .panel")].flatMap(
  panel => [...panel.querySelectorAll("button")].filter(one =>
    one.checkVisibility() && (
      one.getBoundingClientRect().right > panel.getBoundingClientRect().right
      || one.getBoundingClientRect().bottom
        > panel.getBoundingClientRect().bottom)).map(one => one.id))"""


def test_gnd28_no_button_is_cut_when_the_sticks_are_asked_for(
        station, pages):
    """The question pushed two buttons out of the panel, and a window of 900 to
    1279 pixels cut four at its edge."""
    first, second = pages.open(1280, 800), pages.open(1280, 800)
    take_sticks(first)

    def is_asked():
        if station.state()["holder"] == 2:
            second.keyboard.press("x")
            take_sticks(first)
        second.keyboard.press("t")
        first.wait_for_timeout(200)
        cut = first.evaluate(CUT_BUTTONS)
        return first.locator("#asked").is_visible() and [cut]
    assert until(is_asked, "the question") == [[]]
    pages.close(second)
    for width in (900, 1024, 1279):
        first.set_viewport_size({"width": width, "height": 700})
        assert settled(first, lambda: first.evaluate(CUT_BUTTONS), []) == [], (
            width)


CONTRAST = """() => {
  const light = text => {
    const [r, g, b] = text.match(/[\\d.]+/g).map(Number).map(x => {
      x /= 255; return x <= 0.04045 ? x / 12.92 : ((x + .055) / 1.055) ** 2.4;
    });
    return .2126 * r + .7152 * g + .0722 * b;
  };
  const behind = element => {
    for (let one = element; one; one = one.parentElement) {
      const colour = getComputedStyle(one).backgroundColor;
      if (!/^rgba.*, 0\\)$/.test(colour)) return colour;
    }
  };
  const wrong = [];
  for (const one of document.querySelectorAll("body *")) {
    const own = [...one.childNodes].some(
      node => node.nodeType === 3 && node.data.trim());
    if (!own || !one.checkVisibility({visibilityProperty: true})
      || one.closest("#attitude")) continue;
    const style = getComputedStyle(one);
    const front = light(one instanceof SVGElement ? style.fill
      : style.color);
    const back = light(behind(one));
    const ratio = (Math.max(front, back) + .05) / (Math.min(front, back)
      + .05);
    if (ratio < 4.5) wrong.push([one.outerHTML.slice(0, 80), ratio]);
  }
  return wrong;
}"""


@pytest.mark.parametrize("scheme", ["dark", "light"])
def test_gnd28_every_text_has_contrast(station, pages, scheme):
    low = items.COLUMNS["gsc.downlink.battery_volts"]
    station.node.words["gsc.downlink.battery_volts"] = low.word(
        low.caution_low - 0.2)
    station.node.words["gsc.downlink.alternator_volts"] = 0
    station.node.laws = TROUBLE
    page = pages.open(scheme=scheme)
    page.locator("#attitude .doubt").wait_for()
    page.locator("#alert_list li.warning[data-key^=gsc]",
                 has_text="ALTERNATOR").wait_for()
    # The laws do not believe it either, which is another one.
    page.locator("#alert_list li.caution[data-key^=gsc]",
                 has_text="BATTERY").wait_for()
    take_sticks(page)
    page.keyboard.press("c")
    page.locator("#orders").wait_for()
    assert page.evaluate(CONTRAST) == []
    page.keyboard.press("k")
    page.locator("#alert_list li.warning:not(.unseen)",
                 has_text="ALTERNATOR").wait_for()
    station.node.words.clear()
    page.locator("#alert_list li.warning.past",
                 has_text="ALTERNATOR").wait_for()
    assert page.evaluate(CONTRAST) == []
    page.keyboard.press("l")
    assert page.evaluate("document.documentElement.dataset.theme") == (
        "light" if scheme == "dark" else "dark")
    until(lambda: page.evaluate(CONTRAST) == [], "contrast")


LIST = """() => import("/page/panels.js").then((panels) => {
  const times = [0, 1.7e15, 253402300799999999, 8.7e18, 2 ** 64, -1, null];
  panels.showAlerts(times.map((came_us, at) => ({key: `k${at}`,
    level: "caution", name: `N${at}`, text: "t", came_us, count: 1,
    active: true, seen: false})), () => 0);
  panels.showLines(times.map((time_us, at) => ({level: "info", kind: "k",
    text: `line ${at}`, time_us})));
  return [document.querySelectorAll("#alert_list .when"),
    document.querySelectorAll("#lines li")].map((rows) =>
    Array.from(rows, (row) => row.innerText));
})"""


def test_gnd57_no_time_takes_the_other_rows_of_a_list(station, pages):
    page = pages.open()
    alerts, lines = page.evaluate(LIST)
    assert alerts[:5] == ["00:00:00", "22:13:20", "00:00:00", "--:--:--",
                          "--:--:--"]
    assert len(alerts) == 7
    assert [f"line {at}" in " ".join(lines) for at in range(7)] == [True] * 7


HUNG = """
window.hang = (ms) => {
  const ends = performance.now() + ms;
  while (performance.now() < ends);
};
window.seen = [];
new MutationObserver(() => window.seen.push([performance.now(),
  Number(document.body.dataset.seq), document.body.dataset.frame]))
  .observe(document, {subtree: true, attributes: true,
    attributeFilter: ["data-seq"]});
"""


def test_gnd56_what_waited_in_a_browser_that_hung_is_old(station, pages):
    """The first state that it draws afterwards came before it hung."""
    page = pages.open(script=HUNG)
    before = page.evaluate("(seen.length = 0, hang(3000), performance.now())")
    until(lambda: page.evaluate("seen.length") > 20, "more states")
    drawn = [each for each in page.evaluate("seen") if each[0] >= before - 1]
    newest = drawn[-1][1]
    for at, sequence, frame in drawn:
        # By when it was drawn, how old that frame was at least.
        behind = (newest - sequence) * packets.FRAME_S - (
            drawn[-1][0] - at) / 1000
        assert frame != "fresh" or behind < 0.5, (sequence, newest)


def test_gnd25_pictures_follow_the_frames(station, pages):
    """Each picture is of a newer frame, never of an older one."""
    page = pages.open()
    drawn = page.evaluate("""() => new Promise(done => {
      const drawn = [];
      new MutationObserver(() => {
        drawn.push(+document.body.dataset.seq);
        if (drawn.length === 50) done(drawn);
      }).observe(document.body, {attributeFilter: ["data-seq"]});
    })""")
    assert drawn == sorted(drawn)
    assert drawn[-1] - drawn[0] >= 50


BUSY = """
setInterval(() => {
  const ends = performance.now() + 200;
  while (performance.now() < ends);
}, 220);
"""


def test_gnd36_a_page_that_is_too_slow_says_so_and_shows_the_newest(
        station, pages):
    """Its thread is busy with something else nine tenths of the time."""
    # Data that waits in its browser is older than two frames, and so dimmed
    # (GND-56).
    page = pages.open(script=BUSY, until=NOT_FRESH)
    slow = page.locator("#slow", has_text="left out")
    slow.wait_for()
    # A part of its first second was fast.
    until(lambda: number(slow.text_content()) < 25, "fewer pictures")
    # Not later and later: after 300 frames it is what it was.
    first = station.state()["seq"]
    station.wait(lambda state: state["seq"] > first + 300, "300 frames")
    lags = []
    for _ in range(20):
        newest = station.state()["seq"]
        lags.append(newest - seen_frame(page))
    assert min(lags) <= 100, lags
