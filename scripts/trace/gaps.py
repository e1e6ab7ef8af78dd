# SPDX-License-Identifier: Apache-2.0
"""Missing or wrong links between requirements, code, theorems and tests
(EVI-1).

Each gap is one line with its place and the remedy.
"""

import re
from functools import cached_property

import requirements_file
import source_names

SRC = ("src",)
PROOFS = ("proofs",)
PROGRAMS = ("host", "sim", "real_time")
UNIT_TESTS = "tests/unit"
PYTHON_TESTS = ("tests/simulation", "tests/real_time", "tests/ground",
                "tests/changes", "tests/targets")


class Repository:
    """The contents of the repository, by kind."""

    def __init__(self, root):
        self.root = root
        self.text = (root / requirements_file.FILE).read_text(encoding="utf-8")
        self.requirements = requirements_file.parsed(self.text)
        self.uids = {item.uid for item in self.requirements}

    @cached_property
    def units(self):
        return source_names.read_units(self.root, SRC + PROOFS + PROGRAMS)

    @cached_property
    def tests(self):
        """The tests of each test file, by the name TESTS has for it."""
        found = {}
        for path in sorted((self.root / UNIT_TESTS).glob("*_tests.adb")):
            name = source_names.UNIT.search(path.read_text("utf-8"))
            # Not a package, or not one of tests: the main program, the suite.
            if not name or name[1] == "All_Tests":
                continue
            file = path.relative_to(self.root).as_posix()
            found[name[1]] = source_names.unit_tests(path, file)
        for folder in PYTHON_TESTS:
            for path in sorted((self.root / folder).glob("test_*.py")):
                file = path.relative_to(self.root).as_posix()
                found[path.stem] = source_names.simulation_tests(path, file)
        return found

    def tested_in(self, uid):
        """The test files with a test of this requirement."""
        return {name for name, tests in self.tests.items()
                if any(uid in test.requirements for test in tests)}

    def unlinked(self, item):
        """The units of src and proofs that name a requirement without a
        link from it, each with the field that should have the link."""
        linked = {source_names.unit_and_name(self.units, link)[0]
                  for link in item.code + item.theorems}
        for unit in self.units.values():
            if item.uid in unit.requirements and unit not in linked:
                if self.is_in(unit, SRC):
                    yield "CODE", unit.name
                elif self.is_in(unit, PROOFS):
                    yield "THEOREMS", unit.name

    def is_in(self, unit, folders):
        return any(file.startswith(f"{folder}/")
                   for file in unit.files for folder in folders)


def requirement_gaps(repository):
    """Each requirement has code and a test; what is open has no test, but
    a reason."""
    for line in requirements_file.unread(repository.text):
        yield f"{requirements_file.FILE}: cannot be read: {line}"
    seen = set()
    for item in repository.requirements:
        if item.uid in seen:
            yield f"{item.uid}: stands twice"
        seen.add(item.uid)
        tested = repository.tested_in(item.uid)
        if item.is_open != bool(item.why_open):
            yield f"{item.uid}: Open without a WHY, or a WHY and not Open"
        if item.is_open:
            if tested:
                yield (f"{item.uid}: has tests in {', '.join(sorted(tested))}"
                       " and is no longer Open")
            continue
        if not item.code:
            yield f"{item.uid}: names no CODE"
        if not tested:
            yield f"{item.uid}: no test names it"
        for name in item.tests:
            if name not in repository.tests:
                yield f"{item.uid}: TESTS names {name}, which does not exist"
            elif name not in tested:
                yield f"{item.uid}: TESTS names {name}, which has no test of it"
        for name in sorted(tested - set(item.tests)):
            yield f"{item.uid}: TESTS does not name {name}, which tests it"


def link_gaps(repository):
    """Each link from a requirement leads somewhere that names it."""
    for item in repository.requirements:
        for kind, links in (("CODE", item.code), ("THEOREMS", item.theorems)):
            for link in links:
                if "/" in link:
                    yield from file_gaps(repository, item.uid, link)
                    continue
                unit, name = source_names.unit_and_name(repository.units, link)
                if not unit or not unit.places_of(name):
                    yield f"{item.uid}: {kind} names {link}, which does not exist"
                elif item.uid not in unit.requirements:
                    yield (f"{item.uid}: {kind} names {link}, but no comment of"
                           f" {unit.name} names {item.uid}")


def file_gaps(repository, uid, link):
    """A link to a file that is not Ada."""
    file = repository.root / link
    if not file.is_file():
        yield f"{uid}: CODE names {link}, which does not exist"
    elif uid not in source_names.requirements_in(file.read_text("utf-8")):
        yield f"{uid}: CODE names {link}, which does not name {uid}"


def code_gaps(repository):
    """Each unit of src and proofs is there for a requirement, and each
    requirement that it names links to it."""
    for item in repository.requirements:
        for kind, unit in repository.unlinked(item):
            yield (f"{item.uid}: {kind} does not name {unit} or a part of it,"
                   f" which names {item.uid}")
    linked = set()
    for item in repository.requirements:
        for link in item.code + item.theorems:
            unit, name = source_names.unit_and_name(repository.units, link)
            if unit:
                linked |= {unit.name, (unit.name, name.lower())}
    for unit in repository.units.values():
        for uid in sorted(unit.requirements - repository.uids):
            yield f"{unit.files[0]}: names {uid}, which is no requirement"
        if repository.is_in(unit, SRC):
            if not unit.is_empty and unit.name not in linked:
                yield f"{unit.files[0]}: no requirement's CODE names it"
        elif unit.name.startswith("Theorems."):
            yield from theorem_gaps(repository, unit, linked)


def theorem_gaps(repository, unit, linked):
    """Each theorem of the unit's spec belongs to a requirement, by itself or
    with all of the unit."""
    if (unit.name, "") in linked:
        return
    spec = (repository.root / unit.files[0]).read_text(encoding="utf-8")
    for name in re.findall(r"^   procedure (\w+)", spec, re.M):
        if (unit.name, name.lower()) not in linked:
            yield (f"{unit.files[0]}: no requirement's THEOREMS names"
                   f" {unit.name}.{name}")


def test_gaps(repository):
    """Each test names a requirement, and each package of tests is run."""
    suite = repository.root / UNIT_TESTS / "all_tests.adb"
    run = set(re.findall(r"^ *(\w+)\.Add_To", suite.read_text("utf-8"), re.M))
    for name, tests in repository.tests.items():
        for test in tests:
            where = f"{test.file}:{test.lines[0]}"
            if not test.requirements:
                yield f'{where}: "{test.name}" names no requirement'
            for uid in sorted(test.requirements - repository.uids):
                yield f'{where}: "{test.name}" names {uid}, which is none'
        if not tests:
            yield f"{name}: has no test"
        elif tests[0].file.startswith(UNIT_TESTS) and name not in run:
            yield f"{tests[0].file}: all_tests.adb does not run it"


def all_gaps(root):
    """All of them."""
    repository = Repository(root)
    return [*requirement_gaps(repository), *link_gaps(repository),
            *code_gaps(repository), *test_gaps(repository)]
