#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""progress.py TERN: a flight that takes a while shows on a terminal how far it is, and takes that away at its end.
Where standard error is none, it shows nothing. Exit status 77 where the system has no pseudo-terminals."""
import os
import pathlib
import pty
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from expectations import expect, status  # noqa: E402

FLIGHT = [sys.argv[1], "fly", "S20:1", "--set", "tick_hz=1000", "time_limit=6"]
SKIPPED = 77


def on_a_terminal(master, slave):
    """What the flight writes to standard error, and to standard output."""
    process = subprocess.Popen(FLIGHT, stdout=subprocess.PIPE, stderr=slave)
    os.close(slave)
    shown = b""
    while True:
        try:
            part = os.read(master, 4096)
        except OSError:  # the other end is closed
            part = b""
        if not part:
            break
        shown += part
    return shown.decode(), process.communicate()[0].decode()


def main():
    try:
        master, slave = pty.openpty()
    except OSError as error:
        print(f"SKIPPED: there is no pseudo-terminal to show progress on: {error}")
        return SKIPPED
    shown, printed = on_a_terminal(master, slave)
    lines = shown.split("\r")
    expect(f"it shows how far it is, {len(lines) - 1} times", len(lines) > 2 and "s flown," in lines[1])
    expect("it takes that away at the end", lines[-1] == "\033[K")
    expect("what it prints is not in between", printed.startswith("timeout after") and "\r" not in printed)
    done = subprocess.run(FLIGHT, capture_output=True, text=True)
    expect("a file gets nothing of it", done.stderr == "" and done.stdout == printed)
    return status()


if __name__ == "__main__":
    sys.exit(main())
