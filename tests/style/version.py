#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""version.py ROOT VERSION PROGRAM...: the newest release in CHANGELOG.md must be the build's version and the one that
the program prints."""
import pathlib
import re
import subprocess
import sys

RELEASE = re.compile(r"^## \[(\d+\.\d+\.\d+)\] - \d{4}-\d{2}-\d{2}$", re.MULTILINE)


def main():
    root, version, command = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
    releases = RELEASE.findall((root / "CHANGELOG.md").read_text())
    printed = subprocess.run([*command, "--version"], capture_output=True, text=True, check=True).stdout.split("\n")[0]
    newest = releases[0] if releases else "none"
    print(f"CHANGELOG.md: {newest}; CMakeLists.txt: {version}; the program: {printed}")
    return 0 if newest == version and printed == f"tern {version}" else 1


sys.exit(main())
