#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""record.py [--write] FILE COMMAND...: runs a board's image that prints a record, and compares its bytes with FILE,
which the host's tests replay. --write makes FILE from them."""
import pathlib
import subprocess
import sys


def main():
    arguments = sys.argv[1:]
    write = arguments[0] == "--write"
    path, command = pathlib.Path(arguments[write]), arguments[write + 1:]
    run = subprocess.run(command, capture_output=True, text=True, timeout=600)
    if run.returncode != 0:
        print(run.stdout, run.stderr, sep="\n")
        return 1
    lines = [line.split()[1] for line in run.stdout.splitlines() if line.startswith("record ")]
    record = bytes.fromhex("".join(lines))
    if write:
        path.write_bytes(record)
    equal = bool(record) and path.read_bytes() == record
    print(f"{len(record)} bytes recorded, {'equal to' if equal else 'DIFFERENT from'} {path}")
    return 0 if equal else 1


sys.exit(main())
