# SPDX-License-Identifier: Apache-2.0
"""bin/urv: the ground station's commands, a module for each (GND-10).

Only the module of the called command is imported, so that help is quick. A
command's module imports at its top only the packages of every set-up: typer and
Python's own. Packages that `scripts/setup.sh fly` omits are imported at their
use, so that no command needs another's packages.

Exit status, as bin/urv_sim's: 0 done; 1 an output cannot be written, or
another failure; 2 bad command line or bad input; 130 interrupted, for a
command that would have ended by itself (D-39).
"""

import importlib
import os
import signal
import sys
from pathlib import Path

import typer

from urv import faults

# Typer's status for an interrupt, too.
INTERRUPTED = 130

ROOT = Path(__file__).resolve().parents[2]

# The line of each command in the list of all. The module
# is named like it, with _ for -. It has the command's function, or an app of
# several commands.
COMMANDS = {
    "convert": "Convert a record without loss.",
    "report": "Make a report of a flight, as HTML.",
    "identify": "Estimate stability and control derivatives from flights.",
    "xtce": "Write the mission database, for Yamcs.",
    "station": "Serve the page, for flying and watching.",
    "mavlink": "Send the flight as MAVLink 2, until interrupted.",
    "ground": "Fly in real time, with page and Yamcs.",
    "keygen": "Make a key of the sealed link.",
    "pictures": "Make the pictures of README: page, display in Yamcs, report.",
    "monte-carlo": "Fly many flights in random conditions.",
    "yamcs-gate": "Serve the pages of a Yamcs to this machine.",
    "card": "Check test cards, plot them, make their orders.",
    "recorder": "Fetch the aircraft's flight recorder.",
}


def command_of(name):
    """The command, from its module."""
    module = importlib.import_module(f"urv.{name.replace('-', '_')}")
    alone = typer.Typer(rich_markup_mode=None)
    if hasattr(module, "app"):
        alone.add_typer(module.app, name=name)
    else:
        alone.command(name)(getattr(module, name.replace("-", "_")))
    return typer.main.get_group(alone).commands[name]


class Commands(typer.core.TyperGroup):
    """All commands, each imported at its use."""

    def __init__(self, **more):
        super().__init__(**{**more, "commands": dict.fromkeys(COMMANDS)})

    def get_command(self, ctx, cmd_name):
        if cmd_name in COMMANDS and not self.commands[cmd_name]:
            self.commands[cmd_name] = command_of(cmd_name)
        return self.commands.get(cmd_name)

    def format_commands(self, ctx, formatter):
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))


app = typer.Typer(
    name="urv", cls=Commands, invoke_without_command=True,
    add_completion=False, rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]})


def choices(context):
    return "there are " + ", ".join(
        [*context.command.list_commands(context), "--help", "--version"])


def show_version(asked: bool):
    """This version, as in alire.toml."""
    if asked:
        for line in (ROOT / "alire.toml").read_text("utf-8").splitlines():
            if line.startswith("version = "):
                print("urv", line.split('"')[1])
        raise typer.Exit


@app.callback()
def urv(
    context: typer.Context,
    version: bool = typer.Option(
        False, "--version", callback=show_version, is_eager=True,
        help="Print the program's version."),
):
    """The ground station: records, reports, displays."""
    if context.invoked_subcommand is None:
        raise faults.Refused(f"no command; {choices(context)}")


def interrupt(_signal, _frame):
    raise KeyboardInterrupt


def complain(text):
    """Prints a line on standard error, if possible."""
    try:
        print(f"urv: {text}", file=sys.stderr, flush=True)
    except OSError:
        pass


def drop_standard_output():
    """Discards unwritten output, so that Python does not try to write it
    again."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def missing(fault):
    """The package that an import did not find, and the command that installs
    it."""
    what = (f"the package {fault.name} is missing"
            if isinstance(fault, ModuleNotFoundError) and fault.name
            else f"a package is missing ({' '.join(str(fault).split())})")
    # Only Yamcs itself needs more than page installs. The browser's package
    # belongs to the tests.
    target = "test" if fault.name == "playwright" else "page"
    return f"{what}: scripts/setup.sh {target} installs it"


def misused(fault):
    """The error in the command line, with the choices."""
    said = fault.format_message().rstrip(".")
    context = getattr(fault, "ctx", None)
    if said.startswith("No such command") and context:
        said += f"; {choices(context)}"
    return "".join(letter if letter.isprintable() else ascii(letter)[1:-1]
                   for letter in " ".join(said.split()))


def main(arguments=None):
    """Run one command; return its exit status."""
    signal.signal(signal.SIGTERM, interrupt)
    try:
        status = app(args=arguments, prog_name="urv", standalone_mode=False)
        sys.stdout.flush()
        if status == INTERRUPTED:
            complain("interrupted")
        return status or 0
    except (faults.Refused, faults.Failed) as fault:
        complain(fault)
        return fault.status
    except typer.TyperException as fault:
        complain(misused(fault))
        return fault.exit_code
    except MemoryError:
        # Only commands that read foreign files have a limit.
        complain("the file needs more memory than any record does: it is"
                 " damaged, or made to do so")
        return 2
    except KeyboardInterrupt:
        complain("interrupted")
        return INTERRUPTED
    except BrokenPipeError:
        drop_standard_output()
        complain("standard output cannot be written: Broken pipe")
        return 1
    except OSError as fault:
        drop_standard_output()
        what = (faults.quoted(fault.filename) if fault.filename
                else "standard output")
        complain(f"{what}: {faults.reason(fault)}")
        return 1
    except ImportError as fault:
        # In a package of several parts, like yamcs, a part may be missing.
        name = (fault.name or "").split(".")[0]
        if name == "urv":
            raise
        complain(missing(fault))
        return 1
