#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""symbols.py [--eigen] NM ARCHIVE[,ARCHIVE] [SYMBOL...]: contract C1 on the archives themselves. Every undefined symbol
must be their own, on the allow-list or one of the further ones given (a 32-bit processor's integer helpers), and there
must be no writable data. Nor a function of Eigen's: the linker could take the caller's instead, compiled with the caller's
flags (C3). --eigen allows those, for an archive compiled for size, whose callers must have no Eigen of their own."""
import subprocess
import sys

ALLOWED = {"memcpy", "memset", "memmove", "memcmp", "sqrt", "_GLOBAL_OFFSET_TABLE_"}
# Mangled names of namespace Eigen: functions, const member functions, local data.
EIGEN = ("_ZN5Eigen", "_ZNK5Eigen", "_ZZN5Eigen", "_ZGVN5Eigen")


def main():
    arguments = sys.argv[1:]
    eigen = arguments[0] == "--eigen"
    nm, archives, *further = arguments[eigen:]
    allowed = ALLOWED | set(further)
    text = subprocess.run([nm, *archives.split(",")], capture_output=True, text=True, check=True).stdout
    defined, undefined, writable = set(), set(), set()
    for line in text.splitlines():
        words = line.split()
        if len(words) < 2 or line.endswith(":"):
            continue
        kind, name = words[-2], words[-1]
        if kind == "U":
            undefined.add(name)
        else:
            defined.add(name)
            if kind in "BbDdGgSsC":
                writable.add(name)
    foreign = sorted(undefined - defined - allowed)
    shared = sorted(name for name in defined if name.startswith(EIGEN) and not eigen)
    for name in shared:
        print(f"{name} is a function of Eigen's that was not inlined")
    for name in foreign:
        print(f"needs {name}, which is not on the allow-list")
    for name in sorted(writable):
        print(f"{name} is writable global data")
    used = sorted((undefined - defined) & allowed)
    print(f"{len(defined)} symbols defined; from outside: {', '.join(used) or 'nothing'}")
    return 1 if foreign or shared or writable or not defined else 0


sys.exit(main())
