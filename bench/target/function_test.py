#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""function_test.py ROOT FOLDER [EMULATOR...] PROGRAM: does tern_target_bench run, say what it must and write what
bench/results holds? Times are not looked at."""
import csv
import pathlib
import subprocess
import sys

CASES = ["map1", "forest_10_1"]
STAGES = ["inflate", "search", "shortcut", "corridor", "trajectory", "check", "total"]


def run(command, *arguments):
    done = subprocess.run([*command, *arguments], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def table_of(path):
    return list(csv.DictReader(line for line in path.read_text().splitlines() if not line.startswith("#")))


def check_table(root, path, faults):
    rows = table_of(path)
    committed = table_of(root / "bench/results/epyc-vm/stages.csv")
    missing = set(committed[0]) - set(rows[0])
    faults += [f"no column {name}, which the committed tables have" for name in missing]
    if [(row["map"], row["stage"]) for row in rows] != [(case, stage) for case in CASES for stage in STAGES]:
        faults.append("not one row a case and stage")
    for row in rows:
        if not 0.0 < float(row["median_us"]) <= float(row["p99_us"]) <= float(row["max_us"]):
            faults.append(f"{row['map']} {row['stage']}: times are not ordered")
        if row["work"] and not 0 < int(row["work"]) <= int(row["bound"]):
            faults.append(f"{row['map']} {row['stage']}: work above its bound")


def main():
    root, folder, command = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:]
    table = folder / "function_test.csv"
    table.unlink(missing_ok=True)
    selection = [part for case in CASES for part in ("--case", case)]
    status, text = run(command, "--repetitions", "3", "--csv", str(table), *selection)
    print(text)
    faults = [f"exit status {status}"] if status != 0 else []
    said = ["self-test: ok", ": equal", "board: ", "cpu: ", "kernel: ", "build: ", "configuration ", "SCHED_FIFO ",
            "median cycles"]
    if len(command) > 1:
        said.append("EMULATED: no time or cycle below means anything")
    faults += [f"does not say '{words}'" for words in said if words not in text]
    if table.exists():
        check_table(root, table, faults)
    else:
        faults.append("no table was written")
    # What must not end with exit status 0: other bits than expected, a file that cannot be, wrong usage.
    for wanted, arguments in ((1, ["--expect", "0" * 16]), (1, ["--csv", str(folder / "none" / "x.csv"), "--repetitions",
                               "1", "--case", "map1"]), (2, ["--repetitions", "0"]), (2, ["--case", "map7"])):
        status, text = run(command, *arguments)
        if status != wanted:
            faults.append(f"exit status {status} instead of {wanted} with {arguments}")
    print("\n".join(faults) or "the program does what it says; the times above are no measurement")
    return 1 if faults else 0


sys.exit(main())
