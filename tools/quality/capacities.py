#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""capacities.py TIMES [FILE]: runs the tests of statuses and capacities, prints how many there are and how many failed,
and writes that to FILE."""
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TESTS = ROOT / "build/host/tests/capacity"
COLUMNS = ["what", "number", "failed"]
# What a table's row counts: tests of a suite, or the numbers that tests of a suite tell.
COUNTED = [("statuses reached", "Statuses/EveryStatus", "tests", ""),
           ("capacities and budgets exceeded, each alone", "Capacities/EveryCapacity", "tests", ""),
           ("places of the core that ask whether one is full, each made to fail", "CapacitySweep", "numbers",
            "EveryPlace"),
           ("plans with one question answered with full", "CapacitySweep", "numbers", "OfAPlan"),
           ("other calls, likewise", "CapacitySweep", "numbers", "OfOtherCalls"),
           ("flights, likewise", "CapacityFlight", "numbers", "")]


def results(times):
    """The suites of the test programs, by name: (name, number that it tells or 0, failed or not) of each test."""
    suites = {}
    for program in sorted(path for path in TESTS.glob("*_test") if path.is_file()):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "out.json")
            subprocess.run([program, f"--gtest_output=json:{path}", "--gtest_brief=1"],
                           env=dict(os.environ, TERN_CAPACITY_TIMES=times), cwd=TESTS)
            for suite in json.loads(path.read_text())["testsuites"] if path.exists() else []:
                suites[suite["name"]] = [(test["name"], int(test.get("number", 0)), "failures" in test)
                                         for test in suite["testsuite"]]
    return suites


def main():
    suites, rows, failed = results(sys.argv[1]), [], 0
    for what, suite, counted, part in COUNTED:
        tests = [test for test in suites.get(suite, []) if part in test[0]]
        bad = sum(test[2] for test in tests)
        number = len(tests) if counted == "tests" else sum(test[1] for test in tests)
        failed += bad + (number == 0)
        rows.append([what, number, bad])
        print(f"{what}: {number}, failed {bad}", flush=True)
    if len(sys.argv) > 2:
        with open(sys.argv[2], "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
