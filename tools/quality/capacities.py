#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""capacities.py TIMES: runs the tests of statuses and capacities, and notes how many there are and how many failed."""
import csv
import datetime
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import core_id

ROOT = pathlib.Path(__file__).resolve().parents[2]
TESTS = ROOT / "build/host/tests/capacity"
TABLE = ROOT / "docs/measurements/capacities.csv"
COLUMNS = ["what", "number", "failed", "date", "core"]
FLIGHTS = ("capacity_flight_sweep_test", "CapacityFlight")
# What a table's row counts: tests of a suite, or the numbers that tests of a suite tell.
COUNTED = [("statuses reached", "capacity_statuses_test", "Statuses/EveryStatus", "tests", ""),
           ("capacities and budgets exceeded, each alone", "capacity_exceeded_test", "Capacities/EveryCapacity", "tests", ""),
           ("places of the core that ask whether one is full, each made to fail", "capacity_sweep_test", "CapacitySweep",
            "numbers", "EveryPlace"),
           ("plans with one question answered with full", "capacity_sweep_test", "CapacitySweep", "numbers", "OfAPlan"),
           ("other calls, likewise", "capacity_sweep_test", "CapacitySweep", "numbers", "OfOtherCalls"),
           ("flights, likewise", *FLIGHTS, "numbers", "")]


def results(program, times):
    """The suites of a test program, by name: (name, number that it tells or 1, failed or not) of each test."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "out.json")
        subprocess.run([TESTS / program, f"--gtest_output=json:{path}", "--gtest_brief=1"],
                       env=dict(os.environ, TERN_CAPACITY_TIMES=times), cwd=TESTS)
        suites = json.loads(path.read_text())["testsuites"] if path.exists() else []
    return {suite["name"]: [(test["name"], int(test.get("number", 0)), "failures" in test)
                            for test in suite["testsuite"]] for suite in suites}


def main():
    core, date = core_id.present(), datetime.date.today().isoformat()
    found = {program: results(program, sys.argv[1]) for program in dict.fromkeys(row[1] for row in COUNTED)}
    rows, failed = [], 0
    for what, program, suite, counted, part in COUNTED:
        tests = [test for test in found[program].get(suite, []) if part in test[0]]
        bad = sum(test[2] for test in tests)
        number = len(tests) if counted == "tests" else sum(test[1] for test in tests)
        failed += bad + (number == 0)
        rows.append([what, number, bad, date, core])
        print(f"{what}: {number}, failed {bad}", flush=True)
    with TABLE.open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
