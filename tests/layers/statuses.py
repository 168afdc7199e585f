#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""statuses.py ROOT: every value of tern::Status must be expected by some test, and have a name and a meaning."""
import pathlib
import re
import sys


def main():
    root = pathlib.Path(sys.argv[1])
    header = (root / "core/include/tern/status.hpp").read_text()
    body = re.search(r"enum class Status[^{]*\{(.*?)\n\};", header, re.S).group(1)
    values = re.findall(r"^\s*(k\w+) = \d+", body, re.M)
    words = (root / "core/src/base/status.cpp").read_text()
    # A statement that expects may span lines: look at everything up to its semicolon.
    expected = set()
    for path in (root / "tests").rglob("*.cpp"):
        for statement in path.read_text().split(";"):
            if re.search(r"EXPECT_|ASSERT_|expect_|expect\(", statement):
                expected |= set(re.findall(r"Status::(k\w+)", statement))
    faults = [f"no test expects Status::{v}" for v in values if v not in expected]
    faults += [f"Status::{v} lacks a name or a meaning" for v in values if words.count(f"Status::{v}:") != 2]
    print("\n".join(faults) or f"all {len(values)} status values are expected by some test")
    return 1 if faults or not values else 0


sys.exit(main())
