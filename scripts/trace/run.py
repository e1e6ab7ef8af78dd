#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Requirements linked to code, theorems and tests, and back.

    scripts/trace/run.py check     says what is missing; exit status 1 if so
    scripts/trace/run.py renew     writes the links that comments and tests'
                                   names call for into the requirements
    scripts/trace/run.py export [FOLDER [UID ...]]
                                   HTML by StrictDoc, in trace/ or FOLDER; with
                                   the links of all requirements or of those
"""

import shutil
import subprocess
import sys
from pathlib import Path

import gaps
import requirements_file
import source_names

ROOT = Path(__file__).resolve().parent.parent.parent
WORK = ROOT / "obj" / "trace"

CONFIGURATION = """\
from strictdoc.core.project_config import ProjectConfig


def create_config():
    return ProjectConfig(
        project_title="URV",
        project_features=["TABLE_SCREEN", "TRACEABILITY_SCREEN", "SEARCH",
                          "REQUIREMENT_TO_SOURCE_TRACEABILITY"],
        source_root_path={sources!r},
        include_source_paths=["**"],
    )
"""


def relations(repository, item):
    """Role, file, first and last line of what a requirement is linked to.

    A link to nothing, which is a gap, is left out.
    """
    found = []
    for role, links in (("Code", item.code), ("Theorem", item.theorems)):
        for link in links:
            if "/" in link:
                if not (ROOT / link).is_file():
                    continue
                lines = (ROOT / link).read_text("utf-8").count("\n")
                found.append((role, link, 1, lines))
                continue
            unit, name = source_names.unit_and_name(repository.units, link)
            found += [(role, *place)
                      for place in (unit.places_of(name) if unit else ())]
    for name in item.tests:
        found += [("Test", test.file, *test.lines)
                  for test in repository.tests.get(name, ())
                  if item.uid in test.requirements]
    return sorted(set(found))


def report():
    """Say what is missing; return whether anything is."""
    found = gaps.all_gaps(ROOT)
    for gap in found:
        print(gap)
    repository = gaps.Repository(ROOT)
    items = repository.requirements
    still_open = [item.uid for item in items if item.is_open]
    tests = sum(map(len, repository.tests.values()))
    print(f"{len(items)} requirements, {tests} tests, {len(found)} gaps;"
          f" open: {', '.join(still_open) or 'none'}")
    return bool(found)


def renew():
    """Write the links that comments and tests' names call for.

    A link to a unit is added, unless there is one to a part of it. None to
    code or theorems is taken away: what leads nowhere is for a person.
    """
    repository = gaps.Repository(ROOT)
    by_uid = {item.uid: item for item in repository.requirements}

    def links_of(uid):
        item = by_uid[uid]
        links = {"CODE": list(item.code), "THEOREMS": list(item.theorems),
                 "TESTS": sorted(repository.tested_in(uid))}
        for kind, unit in repository.unlinked(item):
            links[kind].append(unit)
        return links

    text = requirements_file.with_links(repository.text, links_of)
    (ROOT / requirements_file.FILE).write_text(text, encoding="utf-8")


def export(html, wanted=()):
    """Let StrictDoc write the requirements as HTML, with the links of those
    wanted or of all."""
    repository = gaps.Repository(ROOT)
    by_uid = {item.uid: item for item in repository.requirements}
    if strange := set(wanted) - set(by_uid):
        print(f"no requirements: {', '.join(sorted(strange))}")
        return 2
    linked = {uid: relations(repository, item)
              if not wanted or uid in wanted else []
              for uid, item in by_uid.items()}
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    (WORK / "requirements.sdoc").write_text(
        requirements_file.with_relations(repository.text, linked.get),
        encoding="utf-8")
    files = sorted({file for links in linked.values()
                    for _, file, _, _ in links})
    # StrictDoc looks through everything below its root: a copy is quicker.
    copies = WORK / "sources"
    for file in files:
        (copies / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / file, copies / file)
    (WORK / "strictdoc_config.py").write_text(
        CONFIGURATION.format(sources=str(copies)), encoding="utf-8")
    strictdoc = ROOT / ".venv" / "bin" / "strictdoc"
    result = subprocess.run(
        [strictdoc, "export", WORK, "--config", WORK, "--output-dir",
         WORK / "out"],
        capture_output=True, text=True, check=False)
    if result.returncode != 0:
        print(result.stdout, result.stderr, sep="\n")
        return 1
    shutil.rmtree(html, ignore_errors=True)
    shutil.move(WORK / "out" / "html", html)
    print(f"{html}/index.html shows {len(by_uid)} requirements and the"
          f" {len(files)} files they are linked to")
    return 0


def main(arguments):
    match arguments:
        case ["check"]:
            return report()
        case ["renew"]:
            renew()
            return report()
        case ["export"]:
            return export(ROOT / "trace") | report()
        case ["export", folder, *wanted]:
            return export(Path(folder), wanted) | report()
        case _:
            print(__doc__, file=sys.stderr)
            return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
