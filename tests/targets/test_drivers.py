# SPDX-License-Identifier: Apache-2.0
"""BRD-6, BRD-9: the drivers of the chips, beside simulated chips on a host."""

import itertools
import os
import shutil
import subprocess

import pytest

import bare

PROJECT = "targets/drivers.gpr"
DRIVERS = bare.ROOT / "targets/drivers"

TESTS = [
    "MC68681: set up while characters arrive",
    "MC68681: characters between any two accesses",
    "MC68681: a character is given only to a free sender",
    "MC68681: a timer's periods between any two accesses",
    "MC68681: a timer's count and interrupts",
    "STM32 USART: set up while characters arrive",
    "STM32 USART: characters between any two accesses",
    "STM32 USART: a character is given only to a free sender",
    "STM32 watchdog: started with its time, and locked",
    "STM32 watchdog: each feed begins its time again",
    "STM32 ADC: set up during a conversion",
    "STM32 ADC: a conversion ends between any two accesses",
    "STM32 ADC: a value that is not taken is an overrun",
    "STM32 PWM: no output before the pulses are right",
    "STM32 PWM: a pulse changes at the end of its period",
    "STM32 PWM: pulses of 1 to 2 ms for all words",
    "SysTick: started, changed and stopped",
    "SysTick: a timer's periods between any two accesses"]


def built(folder):
    """The test program of the drivers in this copy of the repository."""
    subprocess.run(
        ["gprbuild", "-q", "-p", "-P", folder / PROJECT], check=True)
    return folder / "bin/test_chips"


def failed_tests(program):
    done = subprocess.run(
        [program], capture_output=True, text=True, timeout=300, check=False)
    results = [line.partition(": ")[::2] for line in done.stdout.splitlines()]
    assert [name for _, name in results] == TESTS
    failed = {name for result, name in results if result != "passed"}
    assert (done.returncode == 0) == (not failed)
    return failed


def test_brd6_brd7_brd9_the_drivers_report_each_event_once():
    assert failed_tests(built(bare.ROOT)) == set()


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """The sources of the test program."""
    folder = tmp_path_factory.mktemp("drivers")
    for name in ("targets/drivers", "targets/simulated_chips", "src/kernel"):
        shutil.copytree(bare.ROOT / name, folder / name)
    shutil.copy(bare.ROOT / PROJECT, folder / PROJECT)
    return folder


# gprbuild looks at whole seconds: each version has a second of its own.
SECONDS = itertools.count(1_000_000_000)


def write(path, text):
    path.write_text(text)
    os.utime(path, (next(SECONDS),) * 2)


@pytest.mark.parametrize("name, text, planted, found", [
    ("mc68681/mc68681-channels.adb",
     "         if Status.Errors /= No_Errors then\n",
     "         Write_Command (Port, Reset_Errors);\n"
     "         if Status.Errors /= No_Errors then\n",
     TESTS[1]),
    ("mc68681/mc68681-channels.adb",
     "               Write_Command (Port, Reset_Errors);\n",
     "               Count_Errors\n"
     "                 (Counts, True, Result.Wrong_Parity,\n"
     "                  Result.Wrong_Framing);\n"
     "               Read_Data (Port, Result.Data);\n"
     "               Write_Command (Port, Reset_Errors);\n"
     "               return;\n", TESTS[1]),
    ("mc68681/mc68681-channels.adb", "      Write_Command (Port, "
     "Reset_Mode_Pointer);\n", "", TESTS[1]),
    ("mc68681/mc68681-channels.adb",
     "Wrong_Framing or Is_Break", "Is_Break", TESTS[1]),
    ("mc68681/mc68681-timers.adb",
     "      if Is_Due then\n         Answer_Timer (Chip);\n      end if;\n",
     "      Answer_Timer (Chip);\n", TESTS[3]),
    ("stm32_usart/stm32_usart-channels.adb",
     "if Status.Received or else Status.Overrun then",
     "if Status.Received then", TESTS[6]),
    ("stm32_usart/stm32_usart-channels.adb",
     "         Result.Overrun := Status.Overrun;\n", "", TESTS[6]),
    ("stm32_usart/stm32_usart-channels.adb",
     "\n        and then not (Status.Received and then Status.Wrong_Parity);",
     ";", TESTS[7]),
    ("stm32_watchdog/stm32_watchdog-timers.adb",
     "      Write_Key (Unlock);\n", "", TESTS[8]),
    ("stm32_watchdog/stm32_watchdog-timers.adb",
     "   procedure Feed is\n   begin\n"
     "      Write_Key (STM32_Watchdog.Feed);\n",
     "   procedure Feed is\n   begin\n      Write_Key (Unlock);\n", TESTS[9]),
    ("stm32_adc/stm32_adc-conversions.adb",
     "      Write_Status ((others => False));\n", "", TESTS[10]),
    ("stm32_adc/stm32_adc-conversions.adb",
     "         Read_Status (After);\n", "         After := Before;\n",
     TESTS[12]),
    ("stm32_adc/stm32_adc-conversions.adb",
     "            Write_Status ((Overrun => False, others => True));\n", "",
     TESTS[12]),
    ("stm32_pwm/stm32_pwm-pulses.adb",
     "First_Is_Saved | Second_Is_Saved => True,",
     "First_Is_Saved | Second_Is_Saved => False,", TESTS[13]),
    ("stm32_pwm/stm32_pwm-pulses.adb",
     "      Generate_Update (Timer);\n", "", TESTS[13]),
    ("stm32_pwm/stm32_pwm-pulses.adb",
     "      Write_Outputs (Timer, No_Output);\n", "", TESTS[13]),
    ("stm32_pwm/stm32_pwm.ads",
     "* 1_000 / 16#FFF#", "* 1_000 / 16#1000#", TESTS[15]),
    ("cortex_systick/cortex_systick-timers.adb",
     "   begin\n      Write_Control (Stopped);\n      Write_Reload",
     "   begin\n      Write_Reload", TESTS[16]),
    ("cortex_systick/cortex_systick-timers.adb",
     "      Clear_Current;\n", "", TESTS[16]),
    ("cortex_systick/cortex_systick-timers.adb",
     "Is_Due := Now.Has_Ended;", "Is_Due := Now.Counts;", TESTS[17]),
], ids=["overrun reset unseen", "errors reset unseen", "mode pointer", "framing",
        "period unseen", "overrun alone", "overrun not reported",
        "sent while a parity error waits", "watchdog locked",
        "watchdog not fed", "old value", "one look", "overrun stays",
        "pulse cut", "values not taken", "output while set up",
        "longest pulse", "started while it counts", "old count",
        "wrong flag"])
def test_brd6_brd9_d92_a_planted_fault_of_a_driver_is_found(
        copy, name, text, planted, found):
    path = copy / "targets/drivers" / name
    good = path.read_text()
    assert good.count(text) == 1
    write(path, good.replace(text, planted))
    try:
        assert found in failed_tests(built(copy))
    finally:
        write(path, good)
