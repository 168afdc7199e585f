#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""format.py ROOT CLANG_FORMAT: every C and C++ file must be as .clang-format has it."""
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
import sources


def main():
    root, program = pathlib.Path(sys.argv[1]), sys.argv[2]
    if not shutil.which(program):
        print(f"{program} is not installed; tools/setup installs it")
        return 1
    files = [str(file) for file in sources.files(root) if file.suffix in (".cpp", ".hpp", ".c", ".h")]
    done = subprocess.run([program, "--dry-run", "--Werror", *files], capture_output=True, text=True)
    print(f"{done.stderr}{len(files)} files; {program} -i FILE... formats them")
    return 0 if done.returncode == 0 and files else 1


sys.exit(main())
