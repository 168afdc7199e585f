#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""sizes.py OBJDUMP ARCHIVE IMAGE: bytes of code and constants that the core brings, and what the image takes of each
kind of memory."""
import subprocess
import sys


def sections(objdump, path):
    """(name, size, flags) of every section of every object in the file."""
    lines = subprocess.run([objdump, "-h", path], capture_output=True, text=True, check=True).stdout.splitlines()
    for line, flags in zip(lines, lines[1:]):
        words = line.split()
        if len(words) == 7 and words[0].isdigit():
            yield words[1], int(words[2], 16), flags


def main():
    objdump, archive, image = sys.argv[1:]
    core = {"code": 0, "constants": 0}
    for _, size, flags in sections(objdump, archive):
        if "ALLOC" in flags and size:
            core["code" if "CODE" in flags else "constants"] += size
    print(f"core: {core['code']} bytes of code, {core['constants']} of constants")
    for name, size, flags in sections(objdump, image):
        if "ALLOC" in flags:
            print(f"image: {name:12} {size:10} bytes")
    return 0 if core["code"] > 0 else 1


sys.exit(main())
