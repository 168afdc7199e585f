#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""shell.py ROOT SHELLCHECK: every shell script, known by its first line, must be clean under shellcheck."""
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
import sources

SHELL = re.compile(rb"#!.*\b(sh|bash)\n")


def is_script(file):
    with file.open("rb") as stream:
        return SHELL.fullmatch(stream.readline(100)) is not None


def main():
    root, program = pathlib.Path(sys.argv[1]), sys.argv[2]
    if not shutil.which(program):
        print(f"{program} is not installed; tools/setup installs it")
        return 1
    scripts = [str(file) for file in sources.files(root) if is_script(file)]
    done = subprocess.run([program, *scripts], capture_output=True, text=True)
    print(f"{done.stdout}{done.stderr}{len(scripts)} scripts")
    return 0 if done.returncode == 0 and scripts else 1


sys.exit(main())
