#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans many random scenarios with `tern plan`, proves each plan with `tern verify`, and prints one table.

Run k is scenario k // F of family k % F, of F families (tools/verify/scenarios.py). Finished runs are kept in
FOLDER/NAME.csv, so that the same command goes on where a killed run was; another build of the program begins anew. A
plan that is not proven is kept with its scenario in FOLDER/NAME/. The table goes to FOLDER/NAME-table.md.

Exit status: 0; 1 where a plan is not proven, or a program failed; 2 for wrong usage."""
import argparse
import concurrent.futures
import csv
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import time

sys.dont_write_bytecode = True
from scenarios import FAMILIES, scenario  # noqa: E402  (no compiled copy in the source tree)

# Claims of one kind share a column.
GROUPS = {"joint": "joints", "start": "ends", "goal": "ends", "reachable": "ends", "via": "vias",
          "boundary": "boundary", "inside": "inside corridor", "corridor": "corridor", "curve": "curve", "fence": "fences",
          "velocity": "velocity", "acceleration": "acceleration", "jerk": "jerk"}
COLUMNS = list(dict.fromkeys(GROUPS.values()))
FIELDS = ["family", "seed", "status", "claims", *COLUMNS, *(f"{name} used" for name in COLUMNS), "seconds"]


def parse_arguments():
    parser = argparse.ArgumentParser(prog="tools/prove", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=200, metavar="N", help="scenarios (default 200)")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="of each family's first scenario (default 1)")
    parser.add_argument("--family", choices=FAMILIES, action="append", help="only these families")
    parser.add_argument("--name", default="", help="of state and table (default: from seed and families)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="runs at a time (default: one a core)")
    parser.add_argument("--fresh", action="store_true", help="forget what was run before")
    parser.add_argument("--print", metavar="FAMILY:SEED", dest="shown", help="only print this scenario")
    parser.add_argument("--tern", default="build/host/tools/tern", help=argparse.SUPPRESS)
    parser.add_argument("--maps", default="bench/maps", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--folder", default="build/prove", type=pathlib.Path, help=argparse.SUPPRESS)
    return parser.parse_args()


def summary_of(claims):
    """Of each kind: the least margin, and the largest part of a tolerance that is used."""
    row = {"claims": len(claims)}
    for claim in claims:
        group, margin = GROUPS[claim["claim"].split()[0]], float(claim["margin_at_least"])
        tolerance = float(claim["tolerance"])
        used = max(0.0, -margin / tolerance) if tolerance > 0.0 else float(margin < 0.0)
        row[group] = min(margin, row.get(group, margin))
        row[f"{group} used"] = max(used, row.get(f"{group} used", 0.0))
    return row


def run_one(arguments, family, seed):
    began = time.monotonic()
    row = {"family": family, "seed": seed}
    text = scenario(family, seed, arguments.maps)
    with tempfile.TemporaryDirectory() as folder:
        world, plan, proof = (pathlib.Path(folder, name) for name in ("scenario.txt", "plan.json", "proof.json"))
        world.write_text(text)
        planned = subprocess.run([arguments.tern, "plan", world, "--json", plan], capture_output=True, text=True)
        if planned.returncode == 3:
            row["status"] = json.loads(plan.read_text())["status"]
        else:
            verified = subprocess.run([arguments.tern, "verify", plan, world, "--brief", "--json", proof],
                                      capture_output=True, text=True)
            if proof.exists():
                found = json.loads(proof.read_text())["files"][0]
                row.update(summary_of(found["claims"]), status=found["verdict"])
            else:
                row["status"] = "FAILED"
                print(f"{family}:{seed}: {planned.stderr.strip()} {verified.stderr.strip()}", flush=True)
            if row["status"] != "proven":
                keep(arguments, f"{family}-{seed}", text, plan, verified.stdout)
    row["seconds"] = round(time.monotonic() - began, 3)
    return row


def keep(arguments, name, text, plan, proof):
    folder = arguments.folder / arguments.name
    folder.mkdir(exist_ok=True)
    (folder / f"{name}.txt").write_text(text)
    if plan.exists():
        (folder / f"{name}.json").write_text(plan.read_text())
    (folder / f"{name}.proof").write_text(proof)
    print(f"not proven: {folder / name}.txt\n{proof}", flush=True)


class State:
    """Finished runs in a file, one line each, written as they finish."""

    def __init__(self, path, identity):
        self.runs = {}
        kept = self.load(path, identity)
        self.file = path.open("a" if kept else "w", newline="")
        self.writer = csv.DictWriter(self.file, FIELDS)
        if not kept:
            self.file.write(f"# {identity}\n")
            self.writer.writeheader()
            self.file.flush()

    def load(self, path, identity):
        """False where there is nothing to go on with. A line that was cut off does not count."""
        if not path.exists():
            return False
        text = path.read_text()
        whole = text[:text.rfind("\n") + 1]
        path.write_text(whole)
        lines = whole.splitlines()
        if len(lines) < 2 or lines[0] != f"# {identity}":
            return False
        self.runs = {(row["family"], int(row["seed"])): row for row in csv.DictReader(lines[1:])}
        return True

    def add(self, row):
        self.writer.writerow(row)
        self.file.flush()
        self.runs[row["family"], row["seed"]] = {key: str(value) for key, value in row.items()}


def run_all(arguments, wanted, state):
    missing = [run for run in wanted if run not in state.runs]
    lock, began, done = threading.Lock(), time.monotonic(), 0

    def work(run):
        nonlocal done
        row = run_one(arguments, *run)
        with lock:
            state.add(row)
            done += 1
            if done % 50 == 0 or done == len(missing):
                spent = time.monotonic() - began
                print(f"{done} of {len(missing)} runs, {spent:.0f} s, about {spent / done * (len(missing) - done):.0f} s "
                      "left", file=sys.stderr, flush=True)

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(work, missing))


def number(value):
    return f"{value:.3g}" if value else "0"


def table_of(runs):
    """Least margins, and in brackets the largest part of the tolerance that a plan used."""
    lines = [["family", "scenarios", "plans", "proven", *COLUMNS], ["---"] * (len(COLUMNS) + 4)]
    for family in [*dict.fromkeys(run["family"] for run in runs), "all"]:
        rows = [run for run in runs if family in (run["family"], "all")]
        plans = [run for run in rows if run.get("claims")]
        cells = [family, len(rows), len(plans), sum(run["status"] == "proven" for run in plans)]
        for column in COLUMNS:
            margins = [float(run[column]) for run in plans if run.get(column)]
            used = [float(run[f"{column} used"]) for run in plans if run.get(f"{column} used")]
            share = f" ({100 * max(used):.3g} %)" if used and max(used) > 0.0 else ""
            cells.append(f"{number(min(margins))}{share}" if margins else "")
        lines.append(cells)
    return "".join("| " + " | ".join(map(str, cells)) + " |\n" for cells in lines)


def main():
    arguments = parse_arguments()
    if arguments.shown:
        family, _, seed = arguments.shown.partition(":")
        print(scenario(family, int(seed), arguments.maps), end="")
        return 0
    families = arguments.family or list(FAMILIES)
    arguments.name = arguments.name or "-".join([*(arguments.family or ["all"]), str(arguments.seed)])
    arguments.folder.mkdir(parents=True, exist_ok=True)
    if arguments.fresh:
        (arguments.folder / f"{arguments.name}.csv").unlink(missing_ok=True)
    program = hashlib.sha256(pathlib.Path(arguments.tern).read_bytes()).hexdigest()[:16]
    state = State(arguments.folder / f"{arguments.name}.csv", f"program {program}")
    wanted = [(families[k % len(families)], arguments.seed + k // len(families)) for k in range(arguments.runs)]
    run_all(arguments, wanted, state)
    runs = [state.runs[run] for run in sorted(wanted, key=lambda run: (families.index(run[0]), run[1]))]
    table = table_of(runs)
    (arguments.folder / f"{arguments.name}-table.md").write_text(table)
    print(table, end="")
    plans = [run for run in runs if run.get("claims")]
    claims = sum(int(run["claims"]) for run in plans)
    print(f"{len(plans)} plans, {claims} claims, {sum(run['status'] != 'proven' for run in plans)} not proven")
    return 1 if any(run["status"] in ("REFUTED", "OPEN", "FAILED") for run in runs) else 0


if __name__ == "__main__":
    sys.exit(main())
