#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""commands.py PAGE HEADING TERN FOLDER: runs the first block of shell commands below that heading of the page, in a folder
of their own that has the page's as `docs`, and prints what they print, but for processor times."""
import os
import pathlib
import re
import shutil
import subprocess
import sys


def main():
    page, heading, tern, folder = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3], pathlib.Path(sys.argv[4])
    section = page.read_text().split(f"\n## {heading}\n", 1)[1]
    commands = re.search(r"```sh\n(.*?)```", section, re.DOTALL).group(1)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "docs").symlink_to(page.parent.resolve())
    path = f"{pathlib.Path(tern).parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(["sh", "-e"], input=commands, cwd=folder, env={**os.environ, "PATH": path}, stdout=subprocess.PIPE,
                          text=True)
    print("".join(line for line in done.stdout.splitlines(True) if not line.startswith("  time (us)")), end="")
    return done.returncode


sys.exit(main())
