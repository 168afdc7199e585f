#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flies many random worlds with `tern fly`, on all cores, and prints one table.

A row of the table is a family of worlds, such as P25, or P25@8 at 8 m/s; `tern fly --help` names them. Flight k of a row
is the world FAMILY:k. Finished flights are kept in FOLDER/NAME.csv, so that the same command goes on where a killed run
was; another build of the program or other settings begin anew. Tables go to FOLDER/NAME-table.csv and .md.

Exit status: 0; 1 where a flight touched something, broke an invariant or crashed, or where fewer than --least of a row's
flights reached the goal; 2 for wrong usage."""
import argparse
import concurrent.futures
import csv
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import threading
import time

FIELDS = ["row", "seed", "status", "reason", "time_s", "length_m", "mean_speed", "min_clearance", "tracking_max",
          "full_knowledge_s", "asked", "committed", "dropped", "failed", "work_max", "work_total", "threat_s",
          "watched_points", "watched_voxels", "commands_hash", "seconds"]
BROKEN = {"collision", "invariant", "crash", "too_long"}
# Noise of the sensor in all campaigns, unless --set says otherwise.
SETTINGS = ["tracking=bounded", "tracking_margin=0.1", "depth_noise=0.01", "outliers=0.01"]


def parse_arguments():
    parser = argparse.ArgumentParser(prog="tools/fly", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rows", nargs="+", metavar="FAMILY", help="P25, P25@8, S20, C@6, B, O, M, ...")
    parser.add_argument("--flights", type=int, default=100, metavar="N", help="of each row (default 100)")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="of the first flight of each row (default 1)")
    parser.add_argument("--set", dest="settings", action="append", default=[], metavar="KEY=VALUE",
                        help="setting for all flights; campaigns have " + " ".join(SETTINGS))
    parser.add_argument("--name", default="", help="of state and tables (default: from rows and settings)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="flights at a time (default: one a core)")
    parser.add_argument("--seconds", type=float, default=0.0, help="begin no flight after this time; 0: fly all")
    parser.add_argument("--fresh", action="store_true", help="forget what was flown before")
    parser.add_argument("--share", type=float, default=1.0, help="part of the flights to fly, 0 < share <= 1")
    parser.add_argument("--least", type=float, default=0.0, help="part of each row's flights that must reach the goal")
    parser.add_argument("--tern", default="build/host/tools/tern", help=argparse.SUPPRESS)
    parser.add_argument("--folder", default="build/fly", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    arguments.flights = max(1, int(arguments.share * arguments.flights))
    arguments.settings = merge(SETTINGS, arguments.settings)
    return arguments


def merge(defaults, given):
    """Later settings replace earlier ones of the same key."""
    chosen = {}
    for text in [*defaults, *given]:
        chosen[text.split("=", 1)[0]] = text
    return list(chosen.values())


def command(arguments, row, seed):
    return [arguments.tern, "fly", f"{row}:{seed}", "--compare",
            *(word for text in arguments.settings for word in ("--set", text))]


def fly(arguments, row, seed):
    """One flight in a process of its own: a crash costs that flight alone."""
    began = time.monotonic()
    entry = {"row": row, "seed": seed}
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder, "log.json")
        try:
            done = subprocess.run([*command(arguments, row, seed), "--json", str(log)], capture_output=True, text=True,
                                  timeout=1200)
            entry.update(read_log(log) if done.returncode in (0, 3) else
                         {"status": "crash", "reason": f"exit {done.returncode}: {done.stderr.strip()[:200]}"})
        except subprocess.TimeoutExpired:
            entry.update({"status": "too_long", "reason": "the process was ended after 1200 s"})
    entry["seconds"] = round(time.monotonic() - began, 2)
    return entry


def read_log(path):
    log = json.loads(path.read_text())
    return {"status": log["status"], "reason": log["reason"], "time_s": log["time_s"], "length_m": log["length_m"],
            "mean_speed": log["mean_speed"], "min_clearance": log["min_clearance"],
            "tracking_max": log["tracking_error"]["max"], "full_knowledge_s": log.get("full_knowledge_s", 0.0),
            **log["plans"], "work_max": log["work"]["max"], "work_total": log["work"]["total"],
            "threat_s": log["states"]["threat"], "watched_points": log["watched"]["points"],
            "watched_voxels": log["watched"]["voxels"], "commands_hash": log["commands_hash"]}


class State:
    """Finished flights in a file, one line each, written as they finish."""

    def __init__(self, path, identity):
        self.path, self.flights = path, {}
        kept = self.load(identity)
        self.file = path.open("a" if kept else "w", newline="")
        self.writer = csv.DictWriter(self.file, FIELDS)
        if not kept:
            self.file.write(f"# {identity}\n")
            self.writer.writeheader()
            self.file.flush()

    def load(self, identity):
        """False where there is nothing to go on with. A line that was cut off does not count."""
        if not self.path.exists():
            return False
        text = self.path.read_text()
        whole = text[:text.rfind("\n") + 1]
        if whole != text:
            self.path.write_text(whole)
        lines = whole.splitlines()
        if not lines or lines[0] != f"# {identity}":
            return False
        for entry in csv.DictReader(lines[1:]):
            self.flights[entry["row"], int(entry["seed"])] = entry
        return len(lines) > 1

    def add(self, entry):
        self.writer.writerow(entry)
        self.file.flush()
        self.flights[entry["row"], entry["seed"]] = {key: str(value) for key, value in entry.items()}


class Progress:
    def __init__(self, total):
        self.total, self.done, self.failures, self.began = total, 0, 0, time.monotonic()
        self.shown = sys.stderr.isatty()

    def show(self, failed):
        self.done += 1
        self.failures += failed
        spent = time.monotonic() - self.began
        left = spent / self.done * (self.total - self.done)
        if self.shown or self.done % 100 == 0:
            print(f"\r{self.done} of {self.total} flights, {spent:.0f} s, about {left:.0f} s left, "
                  f"{self.failures} not reached  ", end="" if self.shown else "\n", file=sys.stderr, flush=True)


def fly_all(arguments, state):
    """Seed by seed, so that all rows grow alike."""
    wanted = [(row, seed) for seed in range(arguments.seed, arguments.seed + arguments.flights)
              for row in arguments.rows if (row, seed) not in state.flights]
    progress = Progress(len(wanted))
    end = time.monotonic() + arguments.seconds if arguments.seconds > 0.0 else float("inf")
    lock = threading.Lock()

    def run(job):
        if time.monotonic() > end:
            return
        entry = fly(arguments, *job)
        with lock:
            state.add(entry)
            if entry["status"] != "reached":
                print(f"{'' if not progress.shown else chr(13)}{describe(arguments, entry)}", flush=True)
            progress.show(entry["status"] != "reached")

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(run, wanted))
    if progress.shown:
        print(file=sys.stderr)


def describe(arguments, entry):
    return f"{entry['status']}: {entry['reason']}: {shlex.join(command(arguments, entry['row'], entry['seed']))}"


def mean(values):
    return sum(values) / len(values) if values else 0.0


def quantile(values, part):
    return sorted(values)[min(len(values) - 1, int(part * len(values)))] if values else 0.0


COLUMNS = ["family", "flights", "reached", "contacts", "invariants broken", "mean speed, m/s",
           "time over full knowledge, mean", "p95", "tracking error, m", "least clearance, m", "units a plan",
           "most units a tick", "plans dropped", "s of threat"]


def table_row(row, flights):
    number = lambda key, entries: [float(entry[key]) for entry in entries if entry.get(key)]
    reached = [entry for entry in flights if entry["status"] == "reached"]
    ratio = [float(entry["time_s"]) / float(entry["full_knowledge_s"]) for entry in reached
             if float(entry["full_knowledge_s"]) > 0.0]
    count = lambda status: sum(entry["status"] == status for entry in flights)
    return [row, len(flights), len(reached), count("collision"), count("invariant"),
            f"{mean(number('mean_speed', reached)):.2f}",
            f"{mean(ratio):.3f}" if ratio else "", f"{quantile(ratio, 0.95):.3f}" if ratio else "",
            f"{max(number('tracking_max', flights), default=0.0):.3f}",
            f"{min(number('min_clearance', flights), default=0.0):.3f}",
            f"{sum(number('work_total', flights)) / max(1.0, sum(number('asked', flights))):.0f}",
            f"{max(number('work_max', flights), default=0.0):.0f}",
            f"{sum(number('dropped', flights)):.0f}", f"{sum(number('threat_s', flights)):.2f}"]


def write_tables(arguments, rows, stem):
    with open(f"{stem}-table.csv", "w", newline="") as file:
        csv.writer(file).writerows([COLUMNS, *rows])
    lines = [COLUMNS, ["---"] * len(COLUMNS), *rows]
    text = "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)
    pathlib.Path(f"{stem}-table.md").write_text(text)
    print(text, end="")


def verdict(arguments, state):
    """The exit status: what must never happen, and the least part that reaches the goal."""
    failed = False
    for row in arguments.rows:
        flights = [entry for (name, _), entry in state.flights.items() if name == row]
        reached = sum(entry["status"] == "reached" for entry in flights)
        failed = failed or any(entry["status"] in BROKEN for entry in flights) or \
            reached < arguments.least * len(flights)
    return 1 if failed else 0


def main():
    arguments = parse_arguments()
    if arguments.flights < 1 or not pathlib.Path(arguments.tern).exists():
        print("tools/fly: nothing to fly, or no program", file=sys.stderr)
        return 2
    program = hashlib.sha256(pathlib.Path(arguments.tern).read_bytes()).hexdigest()[:16]
    identity = f"program {program}, settings {' '.join(arguments.settings)}"
    name = arguments.name or hashlib.sha256((" ".join([*arguments.rows, *arguments.settings])).encode()).hexdigest()[:8]
    folder = pathlib.Path(arguments.folder)
    folder.mkdir(parents=True, exist_ok=True)
    if arguments.fresh:
        (folder / f"{name}.csv").unlink(missing_ok=True)
    state = State(folder / f"{name}.csv", identity)
    for entry in state.flights.values():
        if entry["status"] != "reached":
            print(describe(arguments, entry), flush=True)
    fly_all(arguments, state)
    rows = [table_row(row, [entry for (flown, _), entry in sorted(state.flights.items()) if flown == row])
            for row in arguments.rows]
    write_tables(arguments, rows, folder / name)
    return verdict(arguments, state)


if __name__ == "__main__":
    sys.exit(main())
