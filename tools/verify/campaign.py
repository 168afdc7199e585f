#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans many random scenarios with `tern plan`, or with --flights flies through many random worlds with `tern fly`,
proves each plan or flight with `tern verify`, and prints one table. With --pairs, it holds the core's proofs of random
plans beside random tracks against exact numbers (docs/tracks.md).

Run k is scenario or world k // F of family k % F, of F families (tools/verify/scenarios.py, docs/simulator.md).
Finished runs are kept in FOLDER/NAME.csv, so that the same command goes on where a killed run was; another build of the
program begins anew. What is not proven is kept in FOLDER/NAME/. The table goes to FOLDER/NAME-table.md.

Exit status: 0; 1 where a plan or a flight is not proven, or a program failed; 2 for wrong usage."""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import time

sys.dont_write_bytecode = True  # no compiled copies in the source tree
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "campaigns"))
from scenarios import FAMILIES, scenario  # noqa: E402
from state import State  # noqa: E402
from subjects import Flights, Pairs, Plans, columns_of, least, summary_of  # noqa: E402


def parse_arguments():
    parser = argparse.ArgumentParser(prog="tools/prove", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=200, metavar="N", help="plan N scenarios (default 200)")
    parser.add_argument("--flights", type=int, metavar="N", help="fly N flights instead, and prove them")
    parser.add_argument("--pairs", type=int, metavar="N", help="prove N thousand pairs of plan and track instead")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="of each family's first run (default 1)")
    parser.add_argument("--family", choices=[*FAMILIES, *Flights.families], action="append", help="only these families")
    parser.add_argument("--set", metavar="KEY=VALUE", dest="settings", action="append", default=[],
                        help="a setting of all flights, besides depth_noise=0.01 and outliers=0.01")
    parser.add_argument("--name", default="", help="of state and table (default: from families, seed and settings)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="runs at a time (default: one a core)")
    parser.add_argument("--fresh", action="store_true", help="forget what was run before")
    parser.add_argument("--print", metavar="FAMILY:SEED", dest="shown", help="only print this scenario")
    parser.add_argument("--tern", help=argparse.SUPPRESS)
    parser.add_argument("--maps", default="bench/maps", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--folder", default="build/prove", type=pathlib.Path, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    kind = Flights if arguments.flights is not None else Pairs if arguments.pairs is not None else Plans
    arguments.tern = arguments.tern or f"build/host/{'tests/verify/tern_track_pairs' if kind is Pairs else 'tools/tern'}"
    for family in arguments.family or []:
        if family not in kind.families:
            parser.error(f"there are no {kind.name} of family {family}")
    return arguments, kind(arguments.tern, arguments.maps, arguments.settings)


def run_one(arguments, kind, family, seed):
    began = time.monotonic()
    row = {"row": family, "seed": seed}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subject, proof = kind.make(family, seed, folder, row), folder / "proof.json"
        if subject is not None:
            verified = subprocess.run([arguments.tern, "verify", *subject, "--brief", "--json", proof],
                                      capture_output=True, text=True)
            row["status"] = "FAILED"
            if proof.exists():
                found = json.loads(proof.read_text())["files"][0]
                row.update(summary_of(kind, found["claims"]), status=found["verdict"])
            if row["status"] != "proven":
                keep(arguments, f"{family}-{seed}", folder, verified.stdout + verified.stderr)
    row["seconds"] = round(time.monotonic() - began, 3)
    return row


def keep(arguments, name, folder, proof):
    kept = arguments.folder / arguments.name / name
    shutil.rmtree(kept, ignore_errors=True)
    shutil.copytree(folder, kept)
    (kept / "proof.txt").write_text(proof)
    print(f"not proven: {kept}\n{proof}", flush=True)


def run_all(arguments, kind, wanted, state):
    missing = [run for run in wanted if run not in state.runs]
    lock, began, done = threading.Lock(), time.monotonic(), 0

    def work(run):
        nonlocal done
        row = run_one(arguments, kind, *run)
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


def proven_of(rows):
    return sum(row["status"] == "proven" for row in rows)


def table_of(kind, runs):
    """Least margins, and in brackets the largest part of the tolerance that was used."""
    columns = [column for column in columns_of(kind) if least(runs, column) is not None]
    lines = [["family", *kind.counts([]), "proven", *columns]]
    lines.append(["---"] * len(lines[0]))
    for family in [*dict.fromkeys(run["row"] for run in runs), "all"]:
        rows = [run for run in runs if family in (run["row"], "all")]
        cells = [family, *kind.counts(rows).values(), proven_of(rows)]
        for column in columns:
            margin = least(rows, column)
            used = max((float(run[f"{column} used"]) for run in rows if run.get(f"{column} used")), default=0.0)
            share = f" ({100 * used:.3g} %)" if used > 0.0 else ""
            cells.append("" if margin is None else f"{number(margin)}{share}")
        lines.append(cells)
    return "".join("| " + " | ".join(map(str, cells)) + " |\n" for cells in lines)


def main():
    arguments, kind = parse_arguments()
    if arguments.shown:
        family, _, seed = arguments.shown.partition(":")
        print(scenario(family, int(seed), arguments.maps), end="")
        return 0
    families = arguments.family or kind.families
    named = [*([] if kind.name == "plans" else [kind.name.split()[-1]]), *(arguments.family or ["all"]), str(arguments.seed)]
    arguments.name = arguments.name or "-".join([*named, *arguments.settings])
    arguments.folder.mkdir(parents=True, exist_ok=True)
    path = arguments.folder / f"{arguments.name}.csv"
    if arguments.fresh:
        path.unlink(missing_ok=True)
    program = hashlib.sha256(pathlib.Path(arguments.tern).read_bytes()).hexdigest()[:16]
    columns = columns_of(kind)
    fields = ["row", "seed", "status", "flight", "commits", "claims", "refused", *columns, *(f"{name} used" for name in columns),
              "seconds"]
    state = State(path, " ".join([f"program {program}", kind.name, *kind.settings]), fields)
    count = {"plans": arguments.runs, "flights": arguments.flights}.get(kind.name, arguments.pairs)
    wanted = [(families[k % len(families)], arguments.seed + k // len(families)) for k in range(count)]
    run_all(arguments, kind, wanted, state)
    runs = [state.runs[run] for run in sorted(wanted, key=lambda run: (families.index(run[0]), run[1]))]
    table = table_of(kind, runs)
    (arguments.folder / f"{arguments.name}-table.md").write_text(table)
    print(table, end="")
    made = kind.counts(runs)[kind.name]
    claims = sum(int(run["claims"]) for run in runs if run.get("claims"))
    print(f"{made} {kind.name}, {claims} claims, {made - proven_of(runs)} not proven")
    return 1 if any(run["status"] in ("REFUTED", "OPEN", "FAILED") for run in runs) else 0


if __name__ == "__main__":
    sys.exit(main())
