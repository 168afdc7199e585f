#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""gate.py --budgets TABLE [--update] [--results CSV] [--caps IMAGE] IMAGE EMULATOR...: runs the corpus' image and the
caps' image twice each, wants both runs equal to the last digit, and compares every count with its budget. Fails above a
budget, where a row has none, where a flight's tick is above LONGEST_TICK, and where a cap row did not reach its
capacity; warns below 70 % of a budget, so that budgets ratchet down. --update writes new budgets instead, 10 % above the counts."""
import argparse
import csv
import pathlib
import subprocess
import sys
import time
import typing

HEADROOM = 1.10
SLACK = 0.70
# Instructions of a flight's tick, whatever its budget: 4 ms at 0.7 ns each (docs/timing.md).
LONGEST_TICK = 5_700_000
# Instructions of a unit of work, in every stage and job (docs/timing.md), where at least LEAST_UNITS of them were done.
UNIT_BAND = (400, 1500)
LEAST_UNITS = 100
# Below this a count is mostly the reading of the counter; it has a budget but no warning.
SMALL = 10000
STAGES = ["grid", "mark", "inflate", "world", "search", "shortcut", "corridor", "times", "trajectory", "check",
          "detour", "previous", "stop_first", "tracks", "tracks proof", "plan"]
TICKS = ["rest tick", "look tick", "fly tick", "stop tick", "threat tick", "commit tick"]
UNITS = ["path unit", "corridor unit", "trajectory unit", "unit"]
COUNTED = ["world", "search", "shortcut", "corridor", "times", "trajectory", "check", "previous", "stop_first", "reach",
           "first frame", "frame", "scan", "slide x", "slide y", "slide z", "snapshot", "fixed", "motion", "point", "timed", "far way"]
MAP_JOBS = ["first frame", "frame", "scan", "slide x", "slide y", "slide z", "snapshot", "map unit"]
FAR = ["far way", "far tick", "far unit"]


class Cap(typing.NamedTuple):
    """What a loop took at its configured bound. `units` of work; a plan goes through it `times` times at most."""
    count: int
    reached: int
    capacity: int
    units: int
    times: int


def run_twice(command):
    """Both at once: a loaded machine is part of the test."""
    runs = [subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    outputs = [run.communicate()[0] for run in runs]
    return outputs, [run.returncode for run in runs]


def run_image(command):
    """What both runs printed; None, with the reason printed, where they differ or failed."""
    outputs, codes = run_twice(command)
    if outputs[0] == outputs[1] and not any(codes):
        return outputs[0]
    print(outputs[0])
    print("FAILS: two runs differ" if outputs[0] != outputs[1] else f"FAILS: the image ended with status {codes[0]}")
    return None


def parse(text):
    """Notes, and {(name, stage): the row's numbers} in the order printed."""
    notes = [line[2:] for line in text.splitlines() if line.startswith("# ")]
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    rows = {(row[0], row[1]): tuple(int(value) for value in row[2:]) for row in list(csv.reader(lines))[1:]}
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


def write_budgets(path, notes, counts):
    with path.open("w", newline="") as file:
        file.write("# Counts (instructions retired, or cycles of SysTick) that each row may have; written by gate.py --update.\n")
        file.write(f"# {compiler_of(notes)}\n")
        file.write("scenario,stage,budget\n")
        for (scenario, stage), count in counts.items():
            if count > 0:
                file.write(f"{scenario},{stage},{round_up(int(count * HEADROOM))}\n")


def thousands(count):
    return f"{count / 1000:,.0f}" if count else "-"


def print_table(rows, budgets, stages):
    """Thousands of counts, a line a scenario; then per stage the worst, its part of its budget, its work and the
    bound on that. Stages that no scenario has are left out."""
    stages = [stage for stage in stages if any(stage == of for _, of in rows)]
    names = list(dict.fromkeys(scenario for scenario, of in rows if of in stages))
    if not names:
        return
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


def print_caps(caps):
    """A line a cap: thousands of instructions, whether it was reached, instructions for a unit of work."""
    print(f"{'':18}{'stage':12}{'thousands':>12}{'reached':>12}{'capacity':>12}{'units':>12}{'a unit':>10}{'times':>8}")
    for (name, stage), cap in caps.items():
        print(f"{name:18}{stage:12}{thousands(cap.count):>12}{cap.reached:>12}{cap.capacity:>12}{cap.units:>12}"
              f"{cap.count // max(1, cap.units):>10}{cap.times:>8}")


def print_bounds(rows, caps):
    """Per stage: the costliest of its caps, the worst scenario, and what part of the one the other is."""
    print(f"{'':12}{'bound':>16}{'worst':>14}{'worst / bound':>16}  from, seen in")
    for stage in STAGES:
        bounds = [(cap.count * cap.times, name) for (name, of), cap in caps.items() if of == stage]
        if not bounds:
            continue
        bound, cap = max(bounds)
        worst, scenario = max((row[0], name) for (name, of), row in rows.items() if of == stage)
        print(f"{stage:12}{thousands(bound):>16}{thousands(worst):>14}{worst / bound:>16.2g}  {cap}, {scenario}")


def instructions_per_unit(rows):
    """{stage: [(instructions of a unit, scenario)]}, where a row counts both."""
    found = {}
    for (scenario, stage), row in rows.items():
        if stage in COUNTED and row[1] >= LEAST_UNITS:
            found.setdefault(stage, []).append((row[0] / row[1], scenario))
    return found


def print_units(rows):
    print(f"{'':12}{'least':>10}{'mean':>10}{'most':>10}  in")
    for stage, found in instructions_per_unit(rows).items():
        values = [value for value, _ in found]
        print(f"{stage:12}{min(values):>10.0f}{sum(values) / len(values):>10.0f}{max(values):>10.0f}  {max(found)[1]}")


def check_units(rows):
    low, high = UNIT_BAND
    return [f"{scenario} {stage}: a unit takes {value:.0f} instructions, not {low} to {high}"
            for stage, found in instructions_per_unit(rows).items() for value, scenario in found
            if not low <= value <= high]


def check_caps(caps):
    return [f"{name} {stage}: reached {cap.reached} of {cap.capacity}, so that its bound was not measured"
            for (name, stage), cap in caps.items() if cap.reached != cap.capacity]


def check_ticks(counts):
    return [f"{flight} {kind}: {count} is above {LONGEST_TICK}, which no tick may take"
            for (flight, kind), count in counts.items() if kind in TICKS and count > LONGEST_TICK]


def compare(counts, budgets):
    failures, warnings = check_ticks(counts), []
    for (scenario, stage), count in counts.items():
        budget = budgets.get((scenario, stage))
        if budget is None:
            if count > 0:
                failures.append(f"{scenario} {stage}: {count} and no budget")
        elif count > budget:
            failures.append(f"{scenario} {stage}: {count} is above its budget of {budget}")
        elif budget > SMALL and count < SLACK * budget:
            warnings.append(f"{scenario} {stage}: {count} is below 70 % of its budget of {budget}: lower it")
    for scenario, stage in budgets:
        if (scenario, stage) not in counts:
            failures.append(f"{scenario} {stage}: has a budget and was not run")
    return failures, warnings


def judge(rows, counts, caps, made_with, budgets, notes):
    failures, warnings = compare(counts, budgets)
    # A unit is about a thousand instructions of a 64-bit processor; a microcontroller computes doubles in many more.
    failures += check_units(rows) if caps else []
    for warning in warnings:
        print(f"warning: {warning}")
    failures += check_caps(caps)
    for failure in failures:
        print(f"FAILS: {failure}")
    if failures and made_with != compiler_of(notes):
        print(f"The budgets belong to {made_with}; this is {compiler_of(notes)}. Counts belong to a compiler.")
    print(f"{len(budgets)} budgets, {len(failures)} failures, {len(warnings)} warnings")
    return 1 if failures else 0


def show(notes, rows, caps, budgets):
    print("\n".join(notes))
    # The image's first note ends in what it counts.
    print(f"thousands of {notes[0].rsplit(', ', 1)[-1]}; stages")
    print_table(rows, budgets, STAGES)
    print("and the longest single unit of work, which is the least that a slice can be")
    print_table(rows, budgets, UNITS)
    print("jobs of rolling maps, and the longest unit")
    print_table(rows, budgets, MAP_JOBS)
    print("a far way, its longest tick and its longest unit")
    print_table(rows, budgets, FAR)
    print("and the longest ticks of flights")
    print_table(rows, budgets, TICKS)
    print("instructions of a unit of work")
    print_units(rows)
    if not caps:
        return
    print("each loop at its configured bound")
    print_caps(caps)
    print("thousands of instructions at the bound, in the worst scenario, and their ratio")
    print_bounds(rows, caps)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--budgets", type=pathlib.Path, required=True)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--results", type=pathlib.Path, help="where to keep the counts as CSV")
    parser.add_argument("--caps", help="the image of the caps")
    parser.add_argument("image")
    parser.add_argument("emulator", nargs="+")
    arguments = parser.parse_args()
    began = time.monotonic()
    images = [image for image in (arguments.image, arguments.caps) if image]
    outputs = [run_image(arguments.emulator + [image]) for image in images]
    if None in outputs:
        return 1
    notes, rows = parse(outputs[0])
    cap_rows = parse(outputs[1])[1] if arguments.caps else {}
    caps = {key: Cap(*row) for key, row in cap_rows.items()}
    counts = {key: row[0] for key, row in (rows | cap_rows).items()}
    if arguments.results:
        arguments.results.write_text("".join(outputs))
    if arguments.update:
        write_budgets(arguments.budgets, notes, counts)
    made_with, budgets = read_budgets(arguments.budgets)
    show(notes, rows, caps, budgets)
    print(f"two runs equal to the last digit; {time.monotonic() - began:.0f} s")
    return judge(rows, counts, caps, made_with, budgets, notes)


sys.exit(main())
