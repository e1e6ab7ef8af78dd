# SPDX-License-Identifier: Apache-2.0
"""GND-14: what a report says and shows of a flight."""

import base64
import csv
import json
import re
import subprocess
import zlib
from html.parser import HTMLParser

import numpy
import pytest
from conftest import URV, fly, run

from urv import flights, items, panels, verdicts

MB = 10 ** 6

# The bench flies level with these; then the battery sags, the link is cut
# meanwhile, and a switch is thrown.
SENSORS = """\
time_ms,battery_volts,alternator_volts,rpm,airspeed,altitude,pitch_attitude
0,2760,2800,3300,2240,2000,2100
5000,2450,2800,3300,2240,2000,2100
8000,2300,2800,3300,2240,2000,2100
9000,2760,2800,3300,2240,2000,2100
"""
STICKS = """\
time_ms,roll,switch3
0,2048,0
7000,3000,4095
"""
FAULTS = "10000 cut 1000\n"


@pytest.fixture(scope="session")
def sagging(tmp_path_factory):
    """The folder of a flight on the bench whose battery sags."""
    folder = tmp_path_factory.mktemp("sagging")
    for name, text in (("sensors.csv", SENSORS), ("sticks.csv", STICKS),
                       ("faults.txt", FAULTS)):
        (folder / name).write_text(text, encoding="utf-8")
    return fly(folder, "--seconds", "15", "--sensors", "sensors.csv",
               "--sticks", "sticks.csv", "--faults", "faults.txt")


def of(folder, *more):
    return (folder / "record.csv", "--summary", folder / "summary.json",
            "--events", folder / "events.jsonl", *more)


@pytest.fixture
def report(urv, tmp_path):
    """Makes a report, and gives its file."""
    def make(*arguments):
        result = urv("report", *arguments, "-o", "report.html")
        assert (result.returncode, result.stdout, result.stderr) == (
            0, "", "")
        return tmp_path / "report.html"
    return make


@pytest.fixture(scope="session")
def reports(tmp_path_factory):
    """The report of a whole flight, by its folder, made once."""
    folder = tmp_path_factory.mktemp("reports")
    made = {}

    def make(flight):
        if flight not in made:
            made[flight] = folder / f"{len(made)}.html"
            result = run(folder, URV, "report", *of(flight), "-o",
                         made[flight])
            assert (result.returncode, result.stdout, result.stderr) == (
                0, "", "")
        return made[flight]
    return make


class Texts(HTMLParser):
    """The text of a page, tags and what they refer to."""

    def __init__(self, path):
        super().__init__()
        self.texts, self.tags, self.addresses = [], [], []
        self.inside = None
        self.contents = {}
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.tags.append(tag)
        self.inside = attributes.get("id") if tag == "script" else None
        self.addresses += [attributes[name] for name in ("src", "href")
                           if name in attributes]

    def handle_data(self, text):
        if self.inside:
            self.contents[self.inside] = (
                self.contents.get(self.inside, "") + text)
        elif self.tags[-1:] not in (["style"], ["script"]):
            self.texts += text.replace("\N{NO-BREAK SPACE}", " ").split()

    @property
    def text(self):
        return " ".join(self.texts)


def test_gnd14_the_standard_flight_was_flown_well(reports, standard):
    page = reports(standard)
    assert page.stat().st_size < 4 * MB
    shown = Texts(page)
    text = shown.text
    # In this order, before any plot.
    places = [text.index(words) for words in (
        "Was it flown well? ✓ within limits Yes",
        "Was the link well? ✓ within limits Yes",
        "What was out of limits? ✓ within limits Nothing",
        "Flight quality", "The flight")]
    assert places == sorted(places)
    # Numbers are the summary's, with unit and limit.
    summary = json.loads((standard / "summary.json").read_text("utf-8"))
    quality = summary["flight_quality"]
    for name, value, unit, limit in (
            ("altitude in holds, RMS off", quality["altitude_rms_ft"], "ft",
             "100 ft"),
            ("airspeed in holds, most off", quality["airspeed_max_kt"], "kt",
             "10 kt")):
        assert f"{name} {value:.2f} {unit} at most {limit}" in text
    assert "stick to servo, at most 50.0 ms at most 70 ms" in text


def test_gnd14_a_report_needs_no_network(reports, standard):
    page = reports(standard)
    assert Texts(page).addresses == []
    text = page.read_text(encoding="utf-8")
    assert "default-src 'none'" in text
    assert "connect-src" not in text


def test_gnd14_what_was_out_of_limits_when_and_what_was_around(
        reports, sagging):
    text = Texts(reports(sagging)).text
    assert ("What was out of limits? ■ warning 1 warning, 0 cautions:"
            " battery volts.") in text
    row = re.search(
        r"warning battery volts (\d+\.\d+) s to (\d+\.\d+) s 23.00 V 23.50 V"
        r"(.*?)The flight", text)
    assert row, text
    assert (float(row[1]), float(row[2])) == pytest.approx((8, 9), abs=0.2)
    assert "switch 3, altitude and airspeed: on" in row[3]
    assert "no fresh data for" in row[3]
    assert "Was the link well? ■ warning No" in text


def test_gnd14_a_flight_s_exceedances(sagging):
    flight = flights.read(sagging / "record.csv", lambda record: None)
    found = [(each.item.name, each.level, round(each.worst, 2), each.limit)
             for each in flight.exceedances]
    assert found == [("battery_volts", "caution", 23.0, 25.0),
                     ("battery_volts", "warning", 23.0, 23.5)]
    assert [each.level for each in flight.excursions] == ["warning"]
    (silence,) = flight.silences
    assert silence.begin == pytest.approx(10.0, abs=0.1)
    assert silence.seconds == pytest.approx(1.0, abs=0.1)
    assert flight.switch_changes[0][1] == (
        "switch 3, altitude and airspeed: on")


def test_gnd14_stale_words_are_gaps_and_judged_by_nothing(sagging):
    flight = flights.read(sagging / "record.csv", lambda record: None)
    volts = flight.sensor("battery_volts")
    error = flight.columns["gsc.downlink.error"].astype(int)
    stale = error & items.STALE != 0
    assert stale.sum() > 40
    assert all(volts[stale] != volts[stale])
    # Before the first downlink all words are 0; that is no empty battery.
    first = flight.columns["gsc.downlink.battery_volts"] == 0
    assert first.any() and all(volts[first] != volts[first])


def test_gnd14_the_track_is_reckoned(standard):
    """From airspeed and heading rate alone; within 2 % of the way flown."""
    flight = flights.read(standard / "record.csv", lambda record: None)
    east, north = flight.reckoned_track
    true = (flight.columns["truth.east_ft"],
            flight.columns["truth.north_ft"])
    flown = 18_600
    for reckoned, truth in zip((east, north), true, strict=True):
        assert abs(reckoned[-1] - truth[-1]) < 0.02 * flown
    assert abs(true[0][-1]) > 0.5 * flown


def test_gnd14_every_word_is_in_the_page(reports, standard):
    """Not only those that are drawn at first."""
    shown = Texts(reports(standard))
    data = json.loads(shown.contents["data"])
    numbers = zlib.decompress(base64.b64decode(shown.contents["numbers"]))
    panel = next(panel for panel in data["panels"]
                 if panel["title"] == "Battery")
    (series,) = panel["traces"][0]["series"]
    assert series["type"] == "u2"
    words = [int.from_bytes(numbers[at:at + 2], "little") for at in range(
        series["at"], series["at"] + 2 * series["many"], 2)]
    with (standard / "record.csv").open(encoding="utf-8") as record:
        assert words == [int(row["gsc.downlink.battery_volts"])
                         for row in csv.DictReader(record)]
    assert panel["limits"] == [23.5, 25.0, 29.0, 31.0]


def test_gnd14_two_flights_are_laid_over_each_other(
        report, standard, sagging):
    shown = Texts(report(*of(standard, "--compare",
                             sagging / "record.csv")))
    assert "A: ✓ within limits Nothing" in shown.text
    assert "B: ■ warning 1 warning" in shown.text
    data = json.loads(shown.contents["data"])
    battery = next(panel for panel in data["panels"]
                   if panel["title"] == "Battery")
    of_a, of_b = battery["traces"][0]["series"]
    assert (of_a["many"], of_b["many"]) == (9000, 750)


@pytest.mark.parametrize("without", ["gsc.", "mcs."])
def test_gnd14_a_partition_s_record_has_a_report(
        urv, tmp_path, sagging, without):
    """It has the columns of one node alone."""
    with (sagging / "record.csv").open(encoding="utf-8") as record:
        rows = list(csv.reader(record))
    kept = [place for place, name in enumerate(rows[0])
            if not name.startswith((without, "link."))]
    text = "".join(",".join(row[place] for place in kept) + "\n"
                   for row in rows)
    (tmp_path / "node.csv").write_text(text, encoding="utf-8")
    result = urv("report", "node.csv", "-o", "report.html")
    assert (result.returncode, result.stderr) == (0, "")
    text = Texts(tmp_path / "report.html").text
    assert "1 warning, 0 cautions: battery volts." in text
    assert "(no flight_quality in a summary)" in text


@pytest.mark.parametrize("where", ["--events", "--summary"])
def test_gnd47_a_link_whose_blocks_were_refused_was_not_well(
        urv, tmp_path, standard, where):
    """However many came: they were not the aircraft's."""
    with (standard / "record.csv").open(encoding="utf-8") as record:
        received = int(list(csv.DictReader(record))[-1][
            "link.downlink_received"])
    told = {
        "--events": {"node": "gsc", "kind": "block_refused",
                     "count": received, "first_frame": 1, "last_frame": 99,
                     "first_ms": 20, "last_ms": 1980, "last_detail": 2},
        "--summary": {"frames": 3000, "link": {"downlink_received": received,
                               "blocks_refused": received}}}[where]
    (tmp_path / "told.json").write_text(json.dumps(told) + "\n", "utf-8")
    result = urv("report", standard / "record.csv", "-o", "report.html",
                 where, "told.json")
    assert (result.returncode, result.stderr) == (0, "")
    text = Texts(tmp_path / "report.html").text
    assert re.search(r"No: [^.]*delivery of data down; data down, refused",
                     text)
    assert f"{received} blocks" in text


def test_gnd14_nothing_read_is_shown_unescaped(
        urv, tmp_path, sagging, browser):
    evil = "<img src=x onerror=document.title=666>"
    event = json.dumps({"node": "gsc", "kind": evil, "count": 1,
                        "first_ms": 8000, "last_ms": 8000})
    (tmp_path / "events.jsonl").write_text(event + "\n", encoding="utf-8")
    record = tmp_path / f"{evil.replace('/', '')}.csv"
    record.write_bytes((sagging / "record.csv").read_bytes())
    result = urv("report", record, "--events", "events.jsonl", "-o",
                 "report.html")
    assert (result.returncode, result.stderr) == (0, "")
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "<img" not in text.partition('id="plotly"')[0]
    with opened(browser, tmp_path / "report.html") as page:
        assert page.title() == f"Flight report: {record.name}"
        assert page.locator("img").count() == 0
        assert evil in page.inner_text("#exceedances")


def wait_until_drawn(page):
    page.wait_for_selector("html[data-drawn]", state="attached",
                           timeout=120_000)


class opened:
    """A report in the browser, drawn, without an error."""

    def __init__(self, browser, path, **how):
        self.browser, self.path, self.how = browser, path, how
        self.faults = []

    def __enter__(self):
        self.context = self.browser.new_context(
            **{"viewport": {"width": 1280, "height": 800}, **self.how})
        # Nothing but the file itself may be asked for.
        self.context.route(re.compile("^(?!file:|data:|blob:)"),
                           lambda route: self.refuse(route))
        page = self.context.new_page()
        page.on("console", lambda said: self.faults.append(said.text)
                if said.type in ("error", "warning") else None)
        page.on("pageerror", lambda fault: self.faults.append(str(fault)))
        page.goto(self.path.as_uri())
        wait_until_drawn(page)
        return page

    def refuse(self, route):
        self.faults.append(route.request.url)
        route.abort()

    def __exit__(self, *_):
        self.context.close()
        assert self.faults == []


LOOKS = [{"viewport": {"width": width, "height": 800}, "color_scheme": scheme}
         for width in (1280, 400) for scheme in ("light", "dark")]


@pytest.mark.parametrize("how", LOOKS, ids=str)
def test_gnd14_it_fits_every_screen_in_both_schemes(
        reports, browser, standard, how):
    with opened(browser, reports(standard), **how) as page:
        width = how["viewport"]["width"]
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        plots = page.locator("figure .plot > div")
        assert plots.count() == page.evaluate("plots.length") > 20
        for box in page.evaluate(
                "[...document.querySelectorAll('.main-svg')].map("
                "(one) => one.getBoundingClientRect().right)"):
            assert box <= width
        dark, ink = page.evaluate(
            "[matchMedia('(prefers-color-scheme: dark)').matches,"
            " getComputedStyle(document.body).color]")
        assert dark == (how["color_scheme"] == "dark")
        tick = page.evaluate("getComputedStyle(document.querySelector("
                             "'.xtick text')).fill")
        assert tick == ink


def test_gnd14_a_zoom_of_one_plot_is_that_of_all(
        reports, browser, standard):
    ranges = ("plots.filter((plot) => !plot.isTrack).map("
              "(plot) => plot.element.layout.xaxis.range.map(Math.round))")
    with opened(browser, reports(standard)) as page:
        page.evaluate("Plotly.relayout(plots[3].element,"
                      " {'xaxis.range[0]': 75, 'xaxis.range[1]': 76})")
        wait_until_drawn(page)
        found = page.evaluate(ranges)
        assert found == [[75, 76]] * len(found) and len(found) > 20
        # Now each frame of that second is drawn.
        drawn = page.evaluate(
            "plots.find((plot) => plot.panel?.title === 'Airspeed,"
            " calibrated').element.data[0].x"
            ".filter((x) => x >= 75 && x <= 76).length")
        assert drawn == 51
        page.click("#whole")
        wait_until_drawn(page)
        assert page.evaluate(ranges) == [[0, 180]] * len(found)


def test_gnd14_no_peak_is_lost_however_long_the_flight(
        report, browser, tmp_path, standard):
    """A single frame of 180 s is drawn."""
    lines = (standard / "record.csv").read_text("utf-8").splitlines()
    place = lines[0].split(",").index("gsc.downlink.battery_volts")
    cells = lines[5001].split(",")
    cells[place] = "2200"
    lines[5001] = ",".join(cells)
    record = tmp_path / "peak.csv"
    record.write_text("\n".join(lines) + "\n", encoding="utf-8")
    with opened(browser, report(record)) as page:
        least = page.evaluate(
            "Math.min(...plots.find((plot) => plot.panel?.title === 'Battery'"
            ").element.data[0].y.filter((y) => y !== null))")
        assert least == pytest.approx(22.0)
        bands = page.evaluate(
            "plots.find((plot) => plot.panel?.title === 'Battery')"
            ".element.layout.shapes.length")
        assert bands >= 2


def test_gnd14_gaps_are_gaps(reports, browser, sagging):
    with opened(browser, reports(sagging)) as page:
        x, y = page.evaluate(
            "(({x, y}) => [x, y])(plots.find((plot) => plot.panel?.title"
            " === 'Battery').element.data[0])")
        assert not [at for at, value in zip(x, y, strict=True)
                    if 10.1 < at < 10.9 and value is not None]
        assert [at for at, value in zip(x, y, strict=True)
                if 10.0 < at < 11.1 and value is None]
        assert page.evaluate("plots.find((plot) => plot.panel?.title ==="
                             " 'Battery').element.data[0].connectgaps"
                             ) is False


def test_gnd14_frames_without_a_row_are_counted(urv, tmp_path, brief):
    """The head had two numbers of frames of one record, without a reason."""
    lines = (brief / "record.csv").read_text().splitlines(keepends=True)
    (tmp_path / "r.csv").write_text("".join(lines[:100] + lines[103:]))
    assert urv("report", "r.csv", "-o", "r.html").returncode == 0
    assert "997 frames, 0.02 s to 20.00 s, 162 columns; 3 frames without a" \
        " row</p>" in (tmp_path / "r.html").read_text("utf-8").replace(
            "\N{NO-BREAK SPACE}", " ")


def test_gnd14_a_click_on_an_exceedance_shows_it(
        reports, browser, sagging):
    with opened(browser, reports(sagging)) as page:
        page.click("#exceedances tbody tr button")
        begin, end = page.evaluate("shown")
        assert begin == pytest.approx(3.1, abs=0.3)
        assert end == pytest.approx(14.0, abs=0.3)


def test_gnd14_it_prints_on_white_with_every_plot(
        reports, browser, tmp_path, standard):
    with opened(browser, reports(standard),
                color_scheme="dark") as page:
        many = page.evaluate("plots.length")
        page.emulate_media(media="print", color_scheme="dark")
        # The page's policy lets nobody wait for an expression.
        while not page.evaluate("printing"):
            page.wait_for_timeout(50)
        assert page.evaluate(
            "getComputedStyle(document.body).backgroundColor"
            ) == "rgb(255, 255, 255)"
        widths = page.evaluate(
            "plots.map((plot) => plot.element._fullLayout.width)")
        assert widths == [690] * many
        assert page.evaluate(
            "[...document.querySelectorAll('.xtick text')].every((one) =>"
            " getComputedStyle(one).fill === 'rgb(0, 0, 0)')")
        pdf = page.pdf(format="A4")
    assert pdf.startswith(b"%PDF") and len(pdf) > 50_000


BAD_RECORDS = {
    "": ":1: the file is empty",
    "frame,time_ms\n": ": the record has no rows",
    "time_ms\n20\n": ":1: not a flight's record: it has no column frame",
    "frame,frame,time_ms\n": ':1: the column "frame" appears twice',
    "frame,time_ms\n0,20\n1\n": ":3: 1 cells, the header has 2",
    "frame,time_ms\n0,20\n1,x\x1b[31m\n": (
        ':3: time_ms: "x\\x1b[31m" is not a number'),
    "frame,time_ms\n0,20\n1,4e1\n": ':3: time_ms: "4e1" is not a number',
    "frame,time_ms\n0,20\n1,40.0\n": (
        ':3: time_ms: "40.0" has 1 decimals, the rows before have 0'),
    "frame,time_ms\n0,020\n": (
        ":2: time_ms: \"020\" is not written as a record's numbers are"),
}


BAD_RECORDS |= {
    "\ufeffframe,time_ms\n0,20\n": (
        ":1: it begins with a byte order mark; a record is UTF-8 with LF"
        " alone: save it so, or give the file as it was recorded"),
    "frame,time_ms\r\n0,20\r\n": (
        ":1: its lines end with CR LF; a record is UTF-8 with LF alone: save"
        " it so, or give the file as it was recorded"),
    # It had "100.00 % of -1997 frames".
    "frame,time_ms\n1,20\n2,40\n1,20\n": (
        ": time_ms goes back from 40 to 20 at row 3: not the record of one"
        " flight"),
}


@pytest.mark.parametrize("text", BAD_RECORDS, ids=lambda text: repr(text))
def test_gnd13_a_bad_record_is_refused_with_its_line(urv, tmp_path, text):
    (tmp_path / "bad.csv").write_bytes(text.encode())
    result = urv("report", "bad.csv", "-o", "report.html")
    assert (result.returncode, result.stdout) == (2, "")
    assert len(result.stderr.splitlines()) == 1
    assert "bad.csv" in result.stderr
    assert result.stderr.rstrip().endswith(BAD_RECORDS[text])
    assert not (tmp_path / "report.html").exists()


def test_gnd14_a_record_that_was_cut_short_still_has_a_report(
        urv, tmp_path, sagging):
    text = (sagging / "record.csv").read_bytes()
    (tmp_path / "cut.csv").write_bytes(text[:-100])
    result = urv("report", "cut.csv", "-o", "report.html")
    missing = "its line 751 is not whole and left out"
    assert (result.returncode, result.stderr) == (
        0, f'urv: "cut.csv" was cut short: {missing}\n')
    shown = Texts(tmp_path / "report.html").text
    assert "749 frames" in shown
    assert f"it was cut short: {missing}" in shown


def test_gnd14_a_report_says_what_the_summary_has_more(
        urv, tmp_path, sagging):
    lines = (sagging / "record.csv").read_bytes().splitlines(True)
    (tmp_path / "part.csv").write_bytes(b"".join(lines[:701]))
    summary = json.loads((sagging / "summary.json").read_text("utf-8"))
    (tmp_path / "summary.json").write_text(json.dumps(
        summary | {"unfinished": True}), encoding="utf-8")
    result = urv("report", "part.csv", "--summary", "summary.json",
                 "-o", "report.html")
    assert (result.returncode, result.stderr) == (0, "")
    shown = Texts(tmp_path / "report.html").text
    assert f"the summary has {summary['frames']} frames, the record 700" \
        in shown
    assert "the program was ended in flight" in shown


@pytest.mark.parametrize("option, text, message", [
    ("--events", "{}\n", ":1: the event has no node"),
    ("--events", "[1\n", ":1: no event"),
    ("--events", '{"node":1,"kind":"a"}\n', ":1: no event"),
    ("--summary", "{\n", ":2: not JSON"),
    ("--summary", "[]", ":1: no summary of a flight"),
])
def test_gnd14_bad_events_and_summaries_are_refused(
        urv, tmp_path, sagging, option, text, message):
    (tmp_path / "bad").write_text(text, encoding="utf-8")
    result = urv("report", sagging / "record.csv", option, "bad", "-o",
                 "report.html")
    assert (result.returncode, result.stdout) == (2, "")
    assert len(result.stderr.splitlines()) == 1
    assert f"bad{message}" in result.stderr


def test_gnd14_files_that_are_not_there(urv, sagging):
    record = sagging / "record.csv"
    for arguments, status, message in (
            (["none.csv", "-o", "a.html"], 2, '"none.csv" cannot be read'),
            (["none.txt", "-o", "a.html"], 2, "ends with .csv, .mcap or"),
            ([record, "--events", "no", "-o", "a.html"], 2, '"no" cannot be'),
            ([record, "-o", "no/a.html"], 1, '"no/a.html" cannot be written'),
            ([record], 2, "Missing option")):
        result = urv("report", *arguments)
        assert (result.returncode, result.stdout) == (status, ""), arguments
        assert len(result.stderr.splitlines()) == 1
        assert message in result.stderr


@pytest.mark.parametrize("value, level", [(50, "well"), (70, "well"),
                                          (71, "caution")])
def test_gnd14_latency_is_judged_by_the_design(value, level):
    (line,) = verdicts.latency_lines(
        None, {"latency_ms": {"max": value, "median": None}})
    assert line.level == level


def test_gnd14_make_fly_ends_with_the_report():
    """With all that it has written, and nothing more to install than what
    set-up installs for it."""
    from conftest import ROOT
    said = subprocess.run(
        ["make", "--no-print-directory", "-n", "fly"], cwd=ROOT, text=True,
        capture_output=True, check=True).stdout
    assert re.search(
        r"bin/urv report flight/record\.csv --summary flight/summary\.json"
        r"\s+--events flight/events\.jsonl\s+-o flight/report\.html",
        said.replace("\\\n", " ")), said


# The laws

LAW_STICKS = """\
time_ms,switch2,switch3
0,0,0
6000,4095,0
10000,4095,4095
14000,0,0
"""


@pytest.fixture(scope="session")
def lawful(tmp_path_factory):
    """The folder of a flight on the bench with laws, a lost link and what the
    ground has set."""
    folder = tmp_path_factory.mktemp("lawful")
    for name, text in (("sticks.csv", LAW_STICKS),
                       ("faults.txt", "18000 cut 7000\n"),
                       ("orders.txt", "2000 configure 1 2000 60000\n")):
        (folder / name).write_text(text, encoding="utf-8")
    return fly(folder, "--laws", "on", "--seconds", "30", "--sticks",
               "sticks.csv", "--faults", "faults.txt", "--orders",
               "orders.txt")


def as_the_ground_has_it(folder, tmp_path):
    """The record without what the aircraft alone knows."""
    with (folder / "record.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    kept = [name for name in rows[0] if not name.startswith("laws.")
            or name.startswith("laws.told")]
    path = tmp_path / "ground.csv"
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, kept, extrasaction="ignore",
                                lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    return path


@pytest.mark.parametrize("late", [0.0, 1.5], ids=["aircraft's", "ground's"])
def test_gnd14_a_report_has_the_laws_actions(lawful, report, tmp_path,
                                                late):
    record = (as_the_ground_has_it(lawful, tmp_path) if late
              else lawful / "record.csv")
    page = report(record).read_text("utf-8")
    text = re.sub(r"<[^>]*>", " ", page[:page.index("<script")])
    assert "What did the control laws do?" in text
    # While the link is cut nothing of it comes down.
    assert f"link was lost: {'' if late else 'holding, '}orbiting." in text
    taken = re.search(
        r"configuration 1 taken\s+([\d.]+)\s+s, gains 1 \(softer\)", text)
    assert 2.0 <= float(taken[1]) <= 2.1 + late
    happened = {one["label"]: one["spans"] for one in json.loads(re.search(
        r'id="data">(.*?)</script>', page, re.S)[1])["happened"]}
    [bank] = happened["law: bank by stick/pitch by stick"]
    assert bank == pytest.approx([6.0, 10.0], abs=0.3 + late)
    [holds] = happened["law: bank by stick/altitude/airspeed"]
    assert holds == pytest.approx([10.0, 14.0], abs=0.3 + late)
    [orbiting] = happened["alone: orbiting"]
    if not late:
        assert orbiting == pytest.approx([20.0, 26.0], abs=0.1)
        assert happened["alone: holding"] == [
            pytest.approx([18.5, 20.0], abs=0.1)]
    assert orbiting[1] == pytest.approx(26.0, abs=0.1 + late)


def test_gnd14_without_laws_a_report_says_nothing_of_them(sagging, reports):
    assert "control laws" not in reports(sagging).read_text("utf-8")


def test_rtp4_a_report_has_the_round_trip_that_a_partition_measured(
        report, standard, tmp_path):
    summary = json.loads((standard / "summary.json").read_text("utf-8"))
    summary["link"] |= {
        "round_trip_us": {"min": 310, "median": 420, "p99": 2210.5,
                          "max": 3890, "measured": 499},
        "late_answers": 2}
    (tmp_path / "slow.json").write_text(json.dumps(summary), "utf-8")
    text = Texts(report(standard / "record.csv", "--summary",
                        tmp_path / "slow.json")).text
    assert "round trip of the line, median 0.4 ms no limit" in text
    assert "round trip of the line, at most 3.9 ms no limit" in text
    assert re.search(r"answers after the board had given up . caution 2"
                     r" messages none", text), text.split("answers after")


def flight_of(**columns):
    return flights.Flight("record.csv", {
        name.replace("__", "."): numpy.asarray(values, float)
        for name, values in columns.items()})


def test_gnd14_the_messages_of_a_second_are_not_those_of_a_gap():
    """50 messages a second, 10 s without rows, and another start."""
    rows = numpy.r_[0:200, 700:900]
    count = numpy.where(rows < 850, rows, rows - 850)
    found = panels.rate(flight_of(
        time_ms=20 * rows, link__uplink_received=count),
        "link.uplink_received")
    is_known = numpy.isin(rows, [*range(50, 200), *range(750, 850)])
    assert (found[is_known] == 50).all()
    assert numpy.isnan(found[~is_known]).all()


def test_gnd14_no_latency_is_measured_over_a_gap():
    """A stick moves at row 10, its servo at row 12; later both do again, with
    missing rows between them."""
    rows = numpy.r_[0:30, 530:560]
    stick, servo = numpy.zeros((2, 1_000))
    stick[10:] = servo[12:] = 100
    stick[28:] = servo[530:] = 200
    columns = {f"console__{name}": numpy.zeros(60)
               for name in flights.STICKS} | {
        f"pwm__{name}": numpy.zeros(60) for name in flights.SERVOS}
    columns["console__roll"] = stick[rows]
    columns[f"pwm__{flights.SERVOS[0]}"] = servo[rows]
    seconds, milliseconds = flight_of(time_ms=20 * rows, **columns).latencies
    assert ([*seconds], [*milliseconds.round()]) == ([0.24], [40])
