# SPDX-License-Identifier: Apache-2.0
"""SIM-1: what urv_sim reads. Good input is taken as promised; bad input gives
one line on standard error and exit status 2, and no output file."""

import json
import os
import re
import subprocess

import pytest
from conftest import FRAMES_PER_S, PROGRAM, SENSORS

OUTPUTS = ("record.csv", "summary.json", "wire.csv", "events.jsonl")
ALL_OUTPUTS = ("--record", "record.csv", "--summary", "summary.json",
               "--wire", "wire.csv", "--events", "events.jsonl")

SWITCHES = [f"switch{n}" for n in range(1, 9)]
STICKS = ["roll", "pitch", "yaw", "throttle", "brake"]
NEUTRAL = {**dict.fromkeys(STICKS, 0x800), **dict.fromkeys(SWITCHES, 0)}

TIME_RANGE = ("is not a time from 0 to 10000000000 ms"
              " with at most three decimals")
WORD_RANGE = "is not a word from 0 to 4095"


def unknown(title, names):
    """The complaint about a column of no such name."""
    return f'unknown column "{title}"; there are ' + ", ".join(names)


def unknown_stick(title):
    return unknown(title, ["time_ms", *STICKS, *SWITCHES])


def unknown_sensor(title):
    return unknown(title, ["time_ms", *SENSORS, "error"])


@pytest.fixture
def refused(urv_sim, tmp_path):
    """Run a command that must be refused; return what it said."""

    def run(*arguments):
        before = {path: path.read_bytes() if path.is_file() else None
                  for path in tmp_path.rglob("*")}
        result = urv_sim(*arguments)
        after = {path: path.read_bytes() if path.is_file() else None
                 for path in tmp_path.rglob("*")}
        assert result.returncode == 2, result
        assert after == before, "files were created or altered"
        assert result.stdout == ""
        assert result.stderr.endswith("\n")
        assert result.stderr.count("\n") == 1, result.stderr
        return result.stderr[:-1]

    return run


# --- command line ---------------------------------------------------------

OPTIONS = ("--seconds", "--plant", "--sticks", "--pilot", "--sensors",
           "--faults", "--conditions", "--orders", "--seed", "--phase",
           "--drift", "--lock", "--line-delay", "--schedule", "--processors",
           "--laws", "--orbit-after", "--terminate-after", "--format", "--key",
           "--recorder", "--record", "--recording", "--fetched", "--summary",
           "--wire", "--events", "--pace", "--quiet")

COMMAND_LINES = [
    ([], "no command; there are fly, items, numbers, tables, help, --version"),
    (["hover"],
     'unknown command "hover"; there are fly, items, numbers, tables, help,'
     " --version"),
    (["--Version"],
     'unknown command "--Version"; there are fly, items, numbers, tables,'
     " help, --version"),
    (["help", "me"],
     'unknown command "me"; there are fly, items, numbers, tables'),
    (["help", "fly", "me"], 'unexpected argument "me"'),
    (["items", "roll"], 'unexpected argument "roll"'),
    (["--version", "2"], 'unexpected argument "2"'),
    *((["fly", word, *more], f'unknown option "{word.partition("=")[0]}";'
       f" there are {', '.join(OPTIONS)}")
      for word, *more in (["--warp", "9"], ["--warp=9"], ["--Quiet"],
                          ["-q"], ["--second=1"])),
    (["fly", "away"], 'unexpected argument "away"'),
    (["fly", "a=b"], 'unexpected argument "a=b"'),
    (["fly", ""], 'unexpected argument ""'),
    (["fly", "--quiet", "yes"], 'unexpected argument "yes"'),
    (["fly", "--quiet=yes"], "--quiet takes no value"),
    (["fly", "--quiet", "--quiet"], "--quiet is given twice"),
    (["fly", "--phase", "1", "--phase=2"], "--phase is given twice"),
    (["fly", "--plant", "glider"],
     '--plant: "glider" is neither "bench" nor "jsbsim"'),
    (["fly", "--pace", "fast"],
     '--pace: "fast" is neither "max" nor "realtime"'),
    (["fly", "--pilot", "nobody"],
     '--pilot: "nobody" is not a flight the pilot knows;'
     " there are standard, level, circuit, damped-circuit"),
    *((["fly", "--pilot", "standard", *more],
       "--pilot needs an aircraft to fly: add --plant jsbsim")
      for more in ([], ["--plant", "bench"])),
    (["fly", "--pilot", "standard", "--sticks", "s.csv"],
     "--pilot and --sticks do not go together"),
    (["fly", "--sticks", "s.csv", "--pilot", "standard"],
     "--pilot and --sticks do not go together"),
    (["fly", "--plant", "jsbsim", "--sensors", "s.csv"],
     "--sensors and --plant jsbsim do not go together"),
    (["fly", "--sensors", "s.csv", "--plant=jsbsim"],
     "--sensors and --plant jsbsim do not go together"),
    (["fly", "--seed", "18446744073709551616"],
     '--seed: "18446744073709551616" is not a whole number'
     " from 0 to 18446744073709551615"),
    *((["fly", "--phase", value],
       f'--phase: "{value}" is not a whole number from 0 to 9')
      for value in ("12", "10", "-1", "1.5", "three", "0x3", " 3")),
    (['fly', '--lock=yes'], '--lock takes no value'),
    *((["fly", "--drift", value],
       f'--drift: "{value}" is not a whole number from -200 to 200')
      for value in ("201", "-201", "-", "1.5", "much")),
    *((["fly", "--schedule", value],
       f'--schedule: "{value}" is neither "report" nor "fast"')
      for value in ("Fast", "slow", "1")),
    *((["fly", "--processors", value],
       f'--processors: "{value}" is not a number of processors from 1 to 4')
      for value in ("0", "5", "12", "-1", "two", "1.0")),
    *((["fly", "--laws", "on", "--orbit-after", value],
       f'--orbit-after: "{value}" is not a number of seconds from 1 to 60'
       " with at most one decimal")
      for value in ("0.9", "60.1", "-1", "5.55", "soon")),
    *((["fly", "--laws", "on", "--terminate-after", value],
       f'--terminate-after: "{value}" is not a number of seconds from 2 to'
       " 300 with at most one decimal")
      for value in ("1.9", "300.1", "never")),
    (["fly", "--laws", "on", "--terminate-after", "5"],
     "--terminate-after: 5 s do not come after the 5 s of --orbit-after"),
    (["fly", "--plant", "jsbsim", "--terminate-after=10.5",
      "--orbit-after=20"],
     "--terminate-after: 10.5 s do not come after the 20 s of --orbit-after"),
    *((["fly", *laws, option, "30"],
       "--orbit-after and --terminate-after are times of the control laws:"
       " add --laws on")
      for option in ("--orbit-after", "--terminate-after")
      for laws in ([], ["--plant", "jsbsim", "--laws", "off"])),
    *((["fly", "--seconds", value],
       f'--seconds: "{value}" is not a number of seconds above 0 and up to'
       " 10000000 with at most six decimals")
      for value in ("0", "0.0", "-1", "ten", "1e3", ".5", "5.", "1,5", "nan",
                    "10000000.000001", "99999999999999999999",
                    "0.0000001")),
]

NEED_A_VALUE = [option for option in OPTIONS[:-1] if option != "--lock"]


@pytest.mark.parametrize("arguments, message", COMMAND_LINES)
def test_bad_command_line(refused, arguments, message):
    outputs = ALL_OUTPUTS if arguments[:1] == ["fly"] else ()
    # A stray command takes no options.
    assert refused(*arguments, *outputs) == "urv_sim: " + message


@pytest.mark.parametrize("option", NEED_A_VALUE)
@pytest.mark.parametrize("ending", ["", "=", " ", " --quiet"])
def test_missing_value(refused, option, ending):
    arguments = {
        "": [option],
        "=": [option + "="],
        " ": [option, ""],
        " --quiet": [option, "--quiet"],
    }[ending]
    said = refused("fly", *arguments)
    assert said == f"urv_sim: {option} needs a value"


def test_long_argument_is_quoted_on_one_line(refused):
    said = refused("fly", "--phase", "a\nb" + "c" * 1000)
    assert said == ('urv_sim: --phase: "a?b' + "c" * 57
                    + '..." is not a whole number from 0 to 9')


# --- sticks and sensors ---------------------------------------------------

BAD_ROWS = [
    ("", 1, "the file is empty"),
    ("\n", 1, unknown_stick("")),
    ("time_ms,roll,\n0,1,2\n", 1, unknown_stick("")),
    ("time_ms,bank\n0,1\n", 1, unknown_stick("bank")),
    ("Time_ms,roll\n0,1\n", 1, unknown_stick("Time_ms")),
    ("time_ms,switch_1\n0,1\n", 1, unknown_stick("switch_1")),
    ("time_ms,switch9\n0,1\n", 1, unknown_stick("switch9")),
    ("time_ms,error\n0,1\n", 1, unknown_stick("error")),
    ("time_ms;roll\n0;1\n", 1, unknown_stick("time_ms;roll")),
    ("time_ms,roll,pitch,roll\n0,1,2,3\n", 1, 'column "roll" comes twice'),
    ("time_ms,roll,time_ms\n0,1,2\n", 1, 'column "time_ms" comes twice'),
    ("roll,pitch\n1,2\n", 1, 'there is no column "time_ms"'),
    ("time_ms,roll", 2, "there is no row after the header"),
    ("time_ms,roll\n", 2, "there is no row after the header"),
    ("time_ms,roll\n\n\n", 2, "there is no row after the header"),
    ("time_ms,roll\n0,4096\n", 2, f'roll: "4096" {WORD_RANGE}'),
    ("time_ms,roll\n0,0x1000\n", 2, f'roll: "0x1000" {WORD_RANGE}'),
    ("time_ms,roll\n0,-1\n", 2, f'roll: "-1" {WORD_RANGE}'),
    ("time_ms,roll\n0,+1\n", 2, f'roll: "+1" {WORD_RANGE}'),
    ("time_ms,roll\n0,1.0\n", 2, f'roll: "1.0" {WORD_RANGE}'),
    ("time_ms,roll\n0,\n", 2, f'roll: "" {WORD_RANGE}'),
    ("time_ms,roll\n0,0x\n", 2, f'roll: "0x" {WORD_RANGE}'),
    ("time_ms,roll\n0,7ff\n", 2, f'roll: "7ff" {WORD_RANGE}'),
    ("time_ms,roll\n0,1 2\n", 2, f'roll: "1 2" {WORD_RANGE}'),
    ("time_ms,roll\n0,99999999999999999999999\n", 2,
     f'roll: "99999999999999999999999" {WORD_RANGE}'),
    ("time_ms,switch3\r\n0,5000\r\n", 2, f'switch3: "5000" {WORD_RANGE}'),
    ("time_ms,roll\nsoon,1\n", 2, f'time_ms: "soon" {TIME_RANGE}'),
    ("time_ms,roll\n-1,1\n", 2, f'time_ms: "-1" {TIME_RANGE}'),
    ("time_ms,roll\n0.0001,1\n", 2, f'time_ms: "0.0001" {TIME_RANGE}'),
    ("time_ms,roll\n0x10,1\n", 2, f'time_ms: "0x10" {TIME_RANGE}'),
    ("time_ms,roll\n10000000000.001,1\n", 2,
     f'time_ms: "10000000000.001" {TIME_RANGE}'),
    ("roll,time_ms\n1,20\n2,40\n3,40\n", 4,
     "time_ms: the row's time is not after that of the row before"),
    ("time_ms,roll\n0,1\n40,1\n20,1\n", 4,
     "time_ms: the row's time is not after that of the row before"),
    ("time_ms,roll\n0,1\n20\n", 3,
     "the row has 1 fields, the header has 2"),
    ("time_ms,roll\n0,1\n20,1,2\n", 3,
     "the row has 3 fields, the header has 2"),
    ("time_ms,roll\n0,1\n\n \n20,1\n", 3,
     "the line is blank, but rows follow"),
    ("time_ms,roll\n0,1\n20," + "1" * 5000 + "\n", 3,
     "the line is longer than 4096 characters"),
    ("time_ms,roll\n" + "".join(f"{20 * n},1\n" for n in range(70000))
     + "1400000,oops", 70002, f'roll: "oops" {WORD_RANGE}'),
]


@pytest.mark.parametrize(
    "text, line, message", BAD_ROWS,
    ids=[f"{n}:{row[2][:40]}" for n, row in enumerate(BAD_ROWS)])
def test_bad_sticks(refused, write, text, line, message):
    write("sticks.csv", text)
    said = refused("fly", "--sticks", "sticks.csv", *ALL_OUTPUTS)
    assert said == f"sticks.csv:{line}: {message}"


@pytest.mark.parametrize("text, line, message", [
    ("", 1, "the file is empty"),
    ("time_ms,roll\n0,1\n", 1, unknown_sensor("roll")),
    ("time_ms,altitude\n0,4096\n", 2, f'altitude: "4096" {WORD_RANGE}'),
    ("time_ms,error\n0,4096\n", 2, f'error: "4096" {WORD_RANGE}'),
    ("time_ms,rpm\n0,1\n0,1\n", 3,
     "time_ms: the row's time is not after that of the row before"),
])
def test_bad_sensors(refused, write, text, line, message):
    write("sensors.csv", text)
    said = refused("fly", "--sensors", "sensors.csv", *ALL_OUTPUTS)
    assert said == f"sensors.csv:{line}: {message}"


# --- faults ---------------------------------------------------------------

FORM = "the form of this fault is TIME_MS "
LINE_FAULTS = "up|down ber|replay|flip|drop|dup|insert"
NODE_FAULTS = "mcs|gsc stall|reset|rom|ram|halt|bus_error, gsc console"
SURFACE_FAULTS = "surface NAME stuck|float|slow"
ANY_FAULT = f"cut, {LINE_FAULTS}, {NODE_FAULTS}, {SURFACE_FAULTS}"
SURFACES = (
    "left_aileron, right_aileron, left_elevator, right_elevator, left_rudder,"
    " right_rudder, steering, throttle, brake, left_flap_1, right_flap_1,"
    " left_flap_2, right_flap_2")
BAD_FAULTS = [
    ("", 1, "the file is empty"),
    ("soon cut 5\n", 1, f'TIME_MS: "soon" {TIME_RANGE}'),
    ("# nothing\n\n-5 cut 5\n", 3, f'TIME_MS: "-5" {TIME_RANGE}'),
    ("100\n", 1, "no fault follows the time"),
    ("100 # cut 5\n", 1, "no fault follows the time"),
    *((f"100 {words}\n", 1, f"{what}; there are {choices}")
      for words, what, choices in (
          ("gremlin 5", 'unknown fault "gremlin"', ANY_FAULT),
          ("Cut 5", 'unknown fault "Cut"', ANY_FAULT),
          ("sideways flip 1 1", 'unknown fault "sideways"', ANY_FAULT),
          ("msc bus_error", 'unknown fault "msc"', ANY_FAULT),
          ("up gremlin 5", 'unknown fault "gremlin"', LINE_FAULTS),
          ("down", "no fault follows", LINE_FAULTS),
          ("gsc hang 5", 'unknown fault "hang"', NODE_FAULTS),
          ("mcs", "no fault follows", NODE_FAULTS),
          ("surface brake", "no fault follows", SURFACE_FAULTS),
          ("surface brake cutt", 'unknown fault "cutt"', SURFACE_FAULTS),
          ("surface", "no surface follows", SURFACES),
          ("surface rudder stuck", 'unknown surface "rudder"', SURFACES))),
    ("100 cut\n", 1, FORM + "cut DURATION_MS"),
    ("100 cut 5 5\n", 1, FORM + "cut DURATION_MS"),
    ("100 up cut 5\n", 1, FORM + "cut DURATION_MS"),
    ("100 flip 1 1\n", 1, FORM + "up|down flip N MASK"),
    ("100 mcs flip 1 1\n", 1, FORM + "up|down flip N MASK"),
    ("100 up flip 1\n", 1, FORM + "up|down flip N MASK"),
    ("100 down drop\n", 1, FORM + "up|down drop N"),
    ("100 down drop 1 2 3 4 5 6 7\n", 1, FORM + "up|down drop N"),
    ("100 up stall adc 5\n", 1, FORM + "mcs|gsc stall adc|telemetry"
     " DURATION_MS"),
    ("100 mcs console 5\n", 1, FORM + "gsc console DURATION_MS"),
    ("100 console 5\n", 1, FORM + "gsc console DURATION_MS"),
    ("100 gsc console\n", 1, FORM + "gsc console DURATION_MS"),
    ("100 cut soon\n", 1, f'DURATION_MS: "soon" {TIME_RANGE}'),
    ("100 up drop 0\n", 1,
     'N: "0" is not a whole number from 1 to 2147483647'),
    ("100 up drop 0x1\n", 1,
     'N: "0x1" is not a whole number from 1 to 2147483647'),
    ("100 up flip 1 0\n", 1,
     'MASK: "0" is not a hexadecimal number from 1 to 1ff'),
    ("100 up flip 1 200\n", 1,
     'MASK: "200" is not a hexadecimal number from 1 to 1ff'),
    ("100 up flip 1 xy\n", 1,
     'MASK: "xy" is not a hexadecimal number from 1 to 1ff'),
    ("100 up insert 1 100\n", 1,
     'BYTE: "100" is not a hexadecimal number from 0 to ff'),
    ("100 up ber 1.5 10\n", 1,
     'P: "1.5" is not a probability from 0 to 1'),
    ("100 up ber often 10\n", 1,
     'P: "often" is not a probability from 0 to 1'),
    ("100 mcs stall pwm 5\n", 1,
     'unknown board "pwm"; there are adc, telemetry'),
    ("100 gsc reset hot\n", 1,
     'unknown reset "hot"; there are cold, warm, processor, telemetry'),
    ("10 cut 5\n20 mcs reset\n", 2,
     FORM + "mcs|gsc reset cold|warm|processor|telemetry"),
    ("100 reset warm\n", 1,
     FORM + "mcs|gsc reset cold|warm|processor|telemetry"),
    ("100 mcs rom 0\n", 1, FORM + "mcs|gsc rom ADDRESS MASK"),
    ("100 mcs rom 10000 1\n", 1,
     'ADDRESS: "10000" is not a hexadecimal number from 0 to ffff'),
    ("100 mcs rom 0 100\n", 1,
     'MASK: "100" is not a hexadecimal number from 1 to ff'),
    ("100 up ram 0 1\n", 1, FORM + "mcs|gsc ram ADDRESS MASK"),
    ("100 gsc ram 2000 1\n", 1,
     'ADDRESS: "2000" is not a hexadecimal number from 0 to 1fff'),
    ("100 gsc ram 0 0\n", 1,
     'MASK: "0" is not a hexadecimal number from 1 to ffff'),
    ("100 stuck 5\n", 1, FORM + "surface NAME stuck [WORD]"),
    ("100 mcs float\n", 1, FORM + "surface NAME float"),
    ("100 surface brake cut 5\n", 1, FORM + "cut DURATION_MS"),
    ("100 surface brake stuck 1 2\n", 1, FORM + "surface NAME stuck [WORD]"),
    ("100 surface brake slow\n", 1, FORM + "surface NAME slow PERCENT"),
    ("100 surface brake slow 0\n", 1,
     'PERCENT: "0" is not a whole number from 1 to 99'),
    ("100 surface brake stuck 4096\n", 1,
     'WORD: "4096" is not a whole number from 0 to 4095'),
    ("100 gsc bus_error 1\n", 1, FORM + "mcs|gsc bus_error"),
    ("100 mcs halt 1\n", 1, FORM + "mcs|gsc halt"),
    ("100 halt\n", 1, FORM + "mcs|gsc halt"),
]


@pytest.mark.parametrize("text, line, message", BAD_FAULTS)
def test_bad_faults(refused, write, text, line, message):
    write("faults.txt", text)
    said = refused("fly", "--faults", "faults.txt", *ALL_OUTPUTS)
    assert said == f"faults.txt:{line}: {message}"


# --- files that cannot be read --------------------------------------------

@pytest.mark.parametrize("option", ["--sticks", "--sensors", "--faults"])
def test_missing_file(refused, option):
    said = refused("fly", option, "none.txt", *ALL_OUTPUTS)
    assert said == ("none.txt:1: cannot be opened:"
                    " No such file or directory")


@pytest.mark.parametrize("option", ["--sticks", "--sensors", "--faults"])
def test_folder_in_place_of_a_file(refused, tmp_path, option):
    (tmp_path / "folder").mkdir()
    said = refused("fly", option, "folder", *ALL_OUTPUTS)
    assert said == "folder:1: cannot be read: Is a directory"


def test_long_and_foreign_file_name_is_said_whole(refused, write):
    name = "ä" * 100 + "é" * 20 + ".csv"
    write(name, "time_ms,oops\n")
    said = refused("fly", "--sticks", name, *ALL_OUTPUTS)
    assert said == name + ":1: " + unknown_stick("oops")


# --- files that cannot be written -----------------------------------------

@pytest.mark.parametrize("option", ["--record", "--recording",
                                    "--fetched", "--summary", "--wire",
                                    "--events"])
def test_output_in_a_missing_folder(refused, option):
    outputs = dict(zip(ALL_OUTPUTS[::2], ALL_OUTPUTS[1::2], strict=True))
    outputs[option] = "none/out"
    said = refused("fly", "--seconds", "0.1",
                   *(word for pair in outputs.items() for word in pair))
    assert said == (f'urv_sim: {option}: "none/out" cannot be created:'
                    " No such file or directory")


def test_output_that_is_a_folder(refused, tmp_path):
    (tmp_path / "folder").mkdir()
    said = refused("fly", "--record", "record.csv", "--wire", "folder")
    assert said == ('urv_sim: --wire: "folder" cannot be created:'
                    " Is a directory")


def test_sim1_the_reason_is_that_of_the_output_not_of_a_later_look(
        refused, tmp_path):
    """A missing file in a folder without write permission had the reason "No
    such file or directory". Root may write there, but not to this name."""
    (tmp_path / "folder").mkdir(mode=0o555)
    name, reason = (("folder/out", "Permission denied") if os.geteuid()
                    else ("new/", "Is a directory"))
    said = refused("fly", "--seconds", "0.1", "--record", name)
    assert said == f'urv_sim: --record: "{name}" cannot be created: {reason}'


def test_what_existed_stays_when_another_output_fails(refused, write):
    # `refused` compares every file before and after.
    write("record.csv", "precious\n")
    write("summary.json", "{}\n")
    refused("fly", "--record", "record.csv", "--summary", "summary.json",
            "--wire", "none/wire.csv")


def test_what_existed_stays_when_input_is_bad(refused, write):
    for name in OUTPUTS:
        write(name, "precious\n")
    write("sticks.csv", "time_ms,oops\n")
    refused("fly", "--sticks", "sticks.csv", *ALL_OUTPUTS)


@pytest.mark.parametrize("option", ["--record", "--recording",
                                    "--fetched", "--summary", "--wire",
                                    "--events"])
@pytest.mark.parametrize("target", ["precious", "elsewhere.csv"])
def test_sec15_an_output_follows_no_link(
        refused, write, tmp_path, option, target):
    # `refused` compares every file before and after.
    write("precious", "precious\n")
    (tmp_path / "out").symlink_to(target)
    said = refused("fly", "--seconds", "0.1", option, "out")
    assert said == (f'urv_sim: {option}: "out" cannot be created: it is a'
                    " symbolic link")


@pytest.mark.parametrize("name", ["/dev/stdout", "/proc/self/fd/1"])
def test_sec15_standard_output_may_be_an_output(urv_sim, name):
    result = urv_sim("fly", "--seconds", "0.1", "--quiet", "--summary", name)
    assert (result.returncode, result.stderr) == (0, "")
    assert json.loads(result.stdout)["frames"] == 5


@pytest.mark.parametrize("option", ["--sticks", "--sensors", "--faults",
                                    "--conditions", "--orders"])
@pytest.mark.parametrize("kind", ["pipe", "device"])
def test_sec14_an_input_is_a_regular_file(refused, tmp_path, option, kind):
    """Nobody writes to the pipe: a program that opens it waits for ever."""
    name = "/dev/zero"
    if kind == "pipe":
        name = "pipe"
        os.mkfifo(tmp_path / name)
    said = refused("fly", option, name, *ALL_OUTPUTS)
    assert said == f"{name}:1: is not a regular file"


def test_output_that_must_not_be_written(refused, tmp_path, write):
    """Root may write any file but some of the kernel's."""
    name = "wire.csv" if os.geteuid() else "/proc/sys/kernel/ostype"
    if os.geteuid():
        write(name, "precious\n")
        (tmp_path / name).chmod(0o444)
    said = refused("fly", "--wire", name)
    assert re.fullmatch(
        f'urv_sim: --wire: "{name}" cannot be created:'
        " (Permission denied|Read-only file system)", said), said


@pytest.mark.parametrize("second", [
    "out", "./out", "folder/../out", "link"])
def test_two_outputs_in_one_file(refused, tmp_path, second):
    (tmp_path / "folder").mkdir()
    (tmp_path / "link").symlink_to("out")
    said = refused("fly", "--record", "out", "--wire", second)
    assert said == "urv_sim: --wire and --record name the same file"


@pytest.mark.parametrize("option, text", [
    ("--sticks", "time_ms,roll\n0,1\n"),
    ("--sensors", "time_ms,rpm\n0,1\n"),
    ("--faults", "0 cut 1\n"),
    ("--orders", "0 configure 1 100 100\n"),
])
def test_output_that_is_an_input(refused, write, option, text):
    write("in", text)
    said = refused("fly", option, "in", "--summary", "./in")
    assert said == f"urv_sim: --summary and {option} name the same file"


@pytest.mark.parametrize("option, text", [
    ("--sticks", "time_ms,roll\n0,1\n"),
    ("--conditions", "servos 50 100 0\n"),
])
def test_sim1_an_output_that_is_a_hard_link_of_an_input(
        refused, write, tmp_path, option, text):
    write("in", text)
    (tmp_path / "other").hardlink_to(tmp_path / "in")
    said = refused("fly", option, "in", "--summary", "other")
    assert said == f"urv_sim: --summary and {option} name the same file"


def test_sim1_outputs_that_are_hard_links_of_one_file(
        refused, write, tmp_path):
    write("out", "precious\n")
    (tmp_path / "other").hardlink_to(tmp_path / "out")
    said = refused("fly", "--record", "out", "--summary", "other")
    assert said == "urv_sim: --summary and --record name the same file"


@pytest.mark.parametrize("options", [
    ["--sticks", "file", "--summary", "-"],
    ["--record", "file", "--summary", "-"],
])
def test_sim1_standard_output_is_a_file_with_a_name(
        tmp_path, write, options):
    write("file", "time_ms,roll\n0,1\n")
    with (tmp_path / "file").open("a") as out:
        result = subprocess.run(
            [PROGRAM, "fly", "--seconds", "0.1", *options], cwd=tmp_path,
            stdout=out, stderr=subprocess.PIPE, text=True, check=False)
    assert (result.returncode, result.stderr) == (
        2, f"urv_sim: --summary and {options[0]} name the same file\n")
    assert (tmp_path / "file").read_text() == "time_ms,roll\n0,1\n"


def test_sec5_an_output_that_is_the_file_of_keys(refused, write, tmp_path):
    write("keys", "key 1 " + "0123456789abcdef" * 2 + "\n")
    (tmp_path / "keys").chmod(0o600)
    said = refused("fly", "--format", "2", "--key", "keys", "--wire", "keys")
    assert said == "urv_sim: --wire and --key name the same file"


# --- what is taken --------------------------------------------------------

def test_quiet_flight_prints_nothing(urv_sim):
    result = urv_sim("fly", "--seconds", "0.5", "--quiet")
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")


@pytest.mark.parametrize("options, frames", [
    (["--seconds", "0.5"], 25),
    (["--seconds", "1"], 50),
    (["--seconds=0.000001"], 1),
    (["--seconds", "0.020001"], 2),
    ([], 3000),
])
def test_length_of_a_flight(fly, options, frames):
    flight = fly(*options)
    assert flight.summary["frames"] == frames
    assert flight.summary["seconds"] == frames / FRAMES_PER_S
    assert len(flight.rows) == frames


@pytest.mark.parametrize("last_ms, frames", [
    (0, 1), (15, 2), (20, 2), (200, 11), (205, 12)])
def test_a_script_is_flown_until_its_last_row(fly, write, last_ms, frames):
    """The frame in which its last row is seen is the flight's last."""
    times = dict.fromkeys((0, last_ms))
    write("sticks.csv", "time_ms,roll\n" + "".join(
        f"{time},2048\n" for time in times))
    assert fly("--sticks", "sticks.csv").summary["frames"] == frames


def test_old_outputs_are_replaced(fly, write):
    for name in OUTPUTS:
        write(name, "old " * 100_000)
    flight = fly("--seconds", "0.1")
    assert "old" not in flight.path("record.csv").read_text()
    assert "old" not in flight.path("wire.csv").read_text()
    assert "old" not in flight.path("events.jsonl").read_text()
    assert flight.summary["frames"] == 5


def test_null_device_takes_any_output(urv_sim):
    result = urv_sim("fly", "--seconds=0.1", "--quiet",
                     "--record=/dev/null", "--wire=/dev/null")
    assert (result.returncode, result.stderr) == (0, "")


# The same script, written in every way the format allows.
WRITINGS = {
    "plain": "time_ms,roll,switch8\n0,1,0\n50,2,4095\n110,3,0\n",
    "no last line end": "time_ms,roll,switch8\n0,1,0\n50,2,4095\n110,3,0",
    "CR LF": "time_ms,roll,switch8\r\n0,1,0\r\n50,2,4095\r\n110,3,0\r\n",
    "blank end": "time_ms,roll,switch8\n0,1,0\n50,2,4095\n110,3,0\n\n \n",
    "other order": "switch8,roll,time_ms\n0,1,0\n4095,2,50\n0,3,110\n",
    "hexadecimal":
        "time_ms,roll,switch8\n0,0x1,0x0\n50,0x2,0xFfF\n110,0X003,0\n",
    "decimals": "time_ms,roll,switch8\n0.0,1,0\n50.000,2,4095\n110.0,3,0\n",
    "blanks": " time_ms,\troll , switch8\n0, 1,0 \n50 ,2, 4095\n110,3,0\n",
    "byte order mark":
        "\ufefftime_ms,roll,switch8\n0,1,0\n50,2,4095\n110,3,0\n",
    "all columns":
        f"time_ms,{','.join(NEUTRAL)}\n"
        + "".join(
            f"{time},{','.join(map(str, {**NEUTRAL, **row}.values()))}\n"
            for time, row in ((0, {"roll": 1}),
                              (50, {"roll": 2, "switch8": 4095}),
                              (110, {"roll": 3}))),
}


@pytest.mark.parametrize("writing", WRITINGS)
def test_sticks_hold_until_the_next_row(fly, write, writing):
    write("sticks.csv", WRITINGS[writing])
    record = fly("--sticks", "sticks.csv").record
    # The last row holds for a frame: 130 ms, rounded up to 7 frames.
    assert record["time_ms"] == [20, 40, 60, 80, 100, 120, 140]
    assert record["console.roll"] == [1, 1, 2, 2, 2, 3, 3]
    assert record["console.switch8"] == [0, 0, 4095, 4095, 4095, 0, 0]
    for name in NEUTRAL.keys() - {"roll", "switch8"}:
        assert set(record["console." + name]) == {NEUTRAL[name]}, name


def test_sticks_are_neutral_before_the_first_row(fly, write):
    write("sticks.csv", "time_ms,pitch\n50,7\n")
    record = fly("--sticks", "sticks.csv").record
    assert record["console.pitch"] == [0x800, 0x800, 7, 7]


def test_seconds_win_over_the_sticks(fly, write):
    write("sticks.csv", "time_ms,pitch\n0,7\n5000,8\n")
    flight = fly("--sticks", "sticks.csv", "--seconds", "0.1")
    assert flight.summary["frames"] == 5


def test_sensors_may_have_every_name_of_the_downlink(fly, write, tmp_path):
    names = [name.removeprefix("mcs.downlink.")
             for name in fly("--seconds=0.02").record
             if name.startswith("mcs.downlink.")]
    assert len(names) == 28
    write("sensors.csv", f"time_ms,{','.join(names)}\n"
          f"0,{','.join(str(100 + n) for n in range(28))}\n")
    flight = fly("--sensors", "sensors.csv", "--seconds=1", name="again")
    last = flight.rows[-1]
    for n, name in enumerate(names[:-1]):
        assert last["mcs.downlink." + name] == 100 + n, name


# A fault in every way the format allows, the same written plainly, and whether
# a flight of half a second is another one with it.
FAULTS = [
    ("100 cut 50        # both ways\r\n", "100 cut 50", True),
    ("\t120.5\tup  flip 3 1ff\n", "120.5 up flip 3 1FF", True),
    ("# first\n\n  # second\n100.000 down drop 0001", "100 down drop 1",
     True),
    ("100 down flip 4 0x1", "100 down flip 4 1", True),
    ("100 down flip 2147483647 0x1", "# none", False),
    ("300 cut 0", "# none", False),
    ("140 up ber 0.010 200\n", "140 up ber 1e-2 200", True),
    ("100 down ber 0 10", "# none", False),
    ("160 up dup 3", "160.0 up dup 3", True),
    ("170 down insert 3 A5", "170 down insert 3 a5", True),
    ("184 gsc stall telemetry 2.5", "184 gsc stall telemetry 2.500", True),
    ("185 mcs stall adc 42.5", "185.000 mcs stall adc 42.5 # long", True),
    ("188 gsc console 600", " 188.0  gsc console 600.000", False),
    ("190 mcs reset warm", "  190 mcs   reset warm  ", True),
    ("190 gsc reset processor", "190\tgsc\treset\tprocessor", True),
    ("205 gsc reset telemetry", "205.0 gsc reset telemetry", True),
    ("195 mcs bus_error", "195 mcs bus_error#", True),
    ("200 gsc rom ffff FF\n250 gsc reset warm",
     "250 gsc reset warm\n200 gsc rom 0xFFFF 0xff", True),
    ("200 mcs ram 0x1fff ffff\n250 mcs reset warm",
     "250 mcs reset warm\n200 mcs ram 1FFF ffff", True),
]


@pytest.mark.parametrize("odd, plain, is_another", FAULTS,
                         ids=[each[0].strip() for each in FAULTS])
def test_a_fault_is_taken_however_it_is_written(
        fly, write, odd, plain, is_another):
    def flown(name, faults):
        write(f"{name}.txt", faults)
        flight = fly("--faults", f"{name}.txt", "--seconds=0.5",
                     "--sensors", "sensors.csv", name=name)
        return [flight.path(file).read_bytes()
                for file in ("record.csv", "wire.csv", "events.jsonl")]

    # Words that change, so that it shows when they are late.
    write("sensors.csv", "time_ms,roll_rate\n" + "".join(
        f"{10 * row},{row}\n" for row in range(50)))
    assert flown("odd", odd) == flown("plain", plain)
    assert (flown("odd", odd) != flown("none", "# none")) == is_another
