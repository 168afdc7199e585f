#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""gate.py --budgets TABLE [--update] [--results CSV] IMAGE EMULATOR...: runs the timing image twice, wants both runs
equal to the last digit, and compares every count with its budget. Fails above a budget and where a row has none; warns
below 70 % of one, so that budgets ratchet down. --update writes new budgets instead, 10 % above the counts."""
import argparse
import csv
import pathlib
import subprocess
import sys
import time

HEADROOM = 1.10
SLACK = 0.70
# Below this a count is mostly the reading of the counter; it has a budget but no warning.
SMALL = 10000
STAGES = ["mark", "inflate", "search", "shortcut", "corridor", "times", "trajectory", "check", "plan"]
UNITS = ["path unit", "corridor unit", "trajectory unit"]


def run_twice(command):
    """Both at once: a loaded machine is part of the test."""
    runs = [subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    outputs = [run.communicate()[0] for run in runs]
    return outputs, [run.returncode for run in runs]


def parse(text):
    """Notes, and {(scenario, stage): (count, work, bound)} in the order printed."""
    notes = [line[2:] for line in text.splitlines() if line.startswith("# ")]
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    rows = {}
    for row in csv.DictReader(lines):
        rows[row["scenario"], row["stage"]] = tuple(int(row[key]) for key in ("count", "work", "bound"))
    return notes, rows


def round_up(count):
    """Three digits, rounded up."""
    step = 10 ** max(0, len(str(count)) - 3)
    return -(-count // step) * step


def compiler_of(notes):
    return next((note for note in notes if note.startswith("compiler")), "compiler unknown")


def read_budgets(path):
    lines = path.read_text().splitlines() if path.exists() else []
    made_with = next((line[2:] for line in lines if line.startswith("# compiler")), None)
    table = csv.DictReader(line for line in lines if not line.startswith("#"))
    return made_with, {(row["scenario"], row["stage"]): int(row["budget"]) for row in table}


def write_budgets(path, notes, rows):
    with path.open("w", newline="") as file:
        file.write("# Instructions retired that each stage of each scenario may take; written by gate.py --update.\n")
        file.write(f"# {compiler_of(notes)}\n")
        file.write("scenario,stage,budget\n")
        for (scenario, stage), (count, _, _) in rows.items():
            if count > 0:
                file.write(f"{scenario},{stage},{round_up(int(count * HEADROOM))}\n")


def thousands(count):
    return f"{count / 1000:,.0f}" if count else "-"


def print_table(rows, budgets, stages):
    """Thousands of instructions, a line a scenario; then per stage the worst, its part of its budget, its work and the
    bound on that."""
    names = list(dict.fromkeys(scenario for scenario, _ in rows))
    width = max(len(name) for name in names + ["worst / budget"])
    column = max(12, 2 + max(len(stage) for stage in stages))
    show = lambda cells: "".join(f"{cell:>{column}}" for cell in cells)
    print(f"{'':{width}}{show(stages)}")
    for name in names:
        print(f"{name:{width}}{show(thousands(rows.get((name, stage), (0,))[0]) for stage in stages)}")
    worst = {stage: max((rows[key][0], key[0]) for key in rows if key[1] == stage) for stage in stages}
    print(f"{'worst':{width}}{show(thousands(worst[stage][0]) for stage in stages)}")
    parts = [worst[stage][0] / budgets.get((worst[stage][1], stage), float("inf")) for stage in stages]
    print(f"{'worst / budget':{width}}{show(f'{part:.2f}' if part else '-' for part in parts)}")
    for label, index in (("most work", 1), ("work's bound", 2)):
        most = (max(rows[key][index] for key in rows if key[1] == stage) for stage in stages)
        print(f"{label:{width}}{show(value or '-' for value in most)}")


def compare(rows, budgets):
    failures, warnings = [], []
    for (scenario, stage), (count, _, _) in rows.items():
        budget = budgets.get((scenario, stage))
        if budget is None:
            if count > 0:
                failures.append(f"{scenario} {stage}: {count} and no budget")
        elif count > budget:
            failures.append(f"{scenario} {stage}: {count} is above its budget of {budget}")
        elif budget > SMALL and count < SLACK * budget:
            warnings.append(f"{scenario} {stage}: {count} is below 70 % of its budget of {budget}: lower it")
    for scenario, stage in budgets:
        if (scenario, stage) not in rows:
            failures.append(f"{scenario} {stage}: has a budget and was not run")
    return failures, warnings


def judge(rows, made_with, budgets, notes):
    failures, warnings = compare(rows, budgets)
    for warning in warnings:
        print(f"warning: {warning}")
    for failure in failures:
        print(f"FAILS: {failure}")
    if failures and made_with != compiler_of(notes):
        print(f"The budgets belong to {made_with}; this is {compiler_of(notes)}. Counts belong to a compiler.")
    print(f"{len(budgets)} budgets, {len(failures)} failures, {len(warnings)} warnings")
    return 1 if failures else 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--budgets", type=pathlib.Path, required=True)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--results", type=pathlib.Path, help="where to keep the counts as CSV")
    parser.add_argument("image")
    parser.add_argument("emulator", nargs="+")
    arguments = parser.parse_args()
    began = time.monotonic()
    outputs, codes = run_twice(arguments.emulator + [arguments.image])
    if outputs[0] != outputs[1] or any(codes):
        print(outputs[0])
        print("FAILS: two runs differ" if outputs[0] != outputs[1] else f"FAILS: the image ended with status {codes[0]}")
        return 1
    notes, rows = parse(outputs[0])
    if arguments.results:
        arguments.results.write_text(outputs[0])
    if arguments.update:
        write_budgets(arguments.budgets, notes, rows)
    made_with, budgets = read_budgets(arguments.budgets)
    print("\n".join(notes))
    print("thousands of instructions retired; stages")
    print_table(rows, budgets, STAGES)
    print("and the longest single unit of work, which is the least that a slice can be")
    print_table(rows, budgets, UNITS)
    print(f"two runs equal to the last digit; {time.monotonic() - began:.0f} s")
    return judge(rows, made_with, budgets, notes)


sys.exit(main())
