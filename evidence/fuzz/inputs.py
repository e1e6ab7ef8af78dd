# SPDX-License-Identifier: Apache-2.0
"""The inputs with which the fuzzing begins (SEC-14).

    evidence/fuzz/inputs.py board|files FOLDER    writes each as a file

inputs.json has those of a board in hexadecimal, those of the readers of files
as text, a character for each byte.
"""

import json
import sys
from pathlib import Path

FILE = Path(__file__).with_name("inputs.json")


def inputs(kind):
    """The bytes of each input, by name."""
    texts = json.loads(FILE.read_text("utf-8"))[kind]
    return {name: bytes.fromhex(text) if kind == "board"
            else text.encode("latin-1") for name, text in texts.items()}


if __name__ == "__main__":
    folder = Path(sys.argv[2])
    folder.mkdir(parents=True)
    for name, data in inputs(sys.argv[1]).items():
        (folder / name).write_bytes(data)
