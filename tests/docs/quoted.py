#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""quoted.py PAGE COMMAND...: every line that the command prints must stand in the page, whatever its line breaks."""
import pathlib
import shlex
import subprocess
import sys


def words(text):
    return " ".join(text.split())


def main():
    page, command = pathlib.Path(sys.argv[1]), sys.argv[2:]
    done = subprocess.run(command, capture_output=True, text=True)
    lines = [words(line) for line in done.stdout.splitlines() if line.strip()]
    text = words(page.read_text())
    missing = [line for line in lines if line not in text]
    for line in missing:
        print(f"{page} does not say: {line}")
    print(f"{shlex.join(command)}\n{done.stderr}{len(lines)} lines printed, {len(missing)} of them not in {page.name}")
    return 0 if done.returncode == 0 and lines and not missing else 1


sys.exit(main())
