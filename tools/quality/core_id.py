#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which core something was measured with: a hash of the sources under core/. Comments, blanks and line breaks do not
count. Printed, if this is run by itself."""
import hashlib
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Strings and characters are matched too, so that a // in one of them stays.
PIECE = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'|//[^\n]*|/\*.*?\*/', re.S)


def code(text):
    """The source without its comments, all blanks alike."""
    bare = PIECE.sub(lambda piece: " " if piece.group().startswith("/") else piece.group(), text)
    return " ".join(bare.split())


def present(root=ROOT):
    sums = hashlib.sha256()
    for path in sorted(path for path in (root / "core").rglob("*") if path.suffix in (".cpp", ".hpp", ".h")):
        sums.update(code(path.read_text()).encode() + b"\n")
    return sums.hexdigest()[:16]


if __name__ == "__main__":
    print(present())
