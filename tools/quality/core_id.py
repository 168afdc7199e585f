#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which core something was measured with: a hash of the sources under core/.

  core_id.py                  prints that of the present sources
  core_id.py note PROGRAM...  notes beside each program which core it was just built from"""
import hashlib
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def present(root=ROOT):
    sums = hashlib.sha256()
    for path in sorted(path for path in (root / "core").rglob("*") if path.suffix in (".cpp", ".hpp", ".h")):
        sums.update(path.read_bytes())
    return sums.hexdigest()[:16]


def sum_of(program):
    return hashlib.sha256(pathlib.Path(program).read_bytes()).hexdigest()


def note_of(program):
    return pathlib.Path(f"{program}.core")


def note(program):
    note_of(program).write_text(f"{sum_of(program)} {present()}\n")


def built_from(program):
    """The core that a program was built from; "unknown" where its note is missing, or of another build of it."""
    words = note_of(program).read_text().split() if note_of(program).exists() else []
    return words[1] if len(words) == 2 and words[0] == sum_of(program) else "unknown"


def main():
    if sys.argv[1:2] == ["note"]:
        for program in sys.argv[2:]:
            note(program)
    elif len(sys.argv) == 1:
        print(present())
    else:
        print(__doc__, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
