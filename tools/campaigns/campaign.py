#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes many random runs, on all cores or on the ranks of mpirun, and prints one table (docs/campaigns.md).

  plan     plans through a family's worlds with full knowledge, each checked again by sampling
  fly      flights through worlds that are discovered on the way
  faults   such flights with each of the faults of faults.py, or with one: P25@5, P25@5/dropped-50
  attack   cases of a family of the attack, in blocks of 500
  swarm    swarms over lossy links (docs/swarm.md)

A row of the table is a family, such as P25, or P25@8 at 8 m/s (`tern fly --help`), or noise, boxes, ... for attack
(docs/attack.md), or T3-20 for swarm. Run k of a row is FAMILY:k. Finished runs are kept in FOLDER/NAME.csv, so that the
same command goes on where a killed one was. With another build of the program or other settings, it begins anew and
keeps the old runs as FOLDER/NAME-1.csv. Tables go to FOLDER/NAME-table.csv and .md. The first failing world of each row
goes to FOLDER/NAME-failures/, with as few obstacles as still fail.

Exit status: 0; 1 where a run touched something, broke an invariant, exceeded its tracking margin or crashed, or where
fewer than --least of a row's runs succeeded; 2 for wrong usage."""
import argparse
import hashlib
import os
import pathlib
import shlex
import shutil
import sys
import time

import kinds
import minimise
import pool
import table
from registry import KINDS
from state import State


def parse_arguments():
    parser = argparse.ArgumentParser(prog="tools/campaign", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kind", choices=sorted(KINDS), help="what to run")
    parser.add_argument("rows", nargs="+", metavar="FAMILY",
                        help="P25, P25@8, S20, C@6, B, O, M; noise, boxes; T3-20, swap-16/loss=0.5; ...")
    parser.add_argument("--runs", "--flights", type=int, default=100, metavar="N", help="of each row (default 100)")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="of the first run of each row (default 1)")
    parser.add_argument("--set", dest="settings", action="append", default=[], metavar="KEY=VALUE",
                        help="setting for all runs; flights have " + " ".join(kinds.Fly.settings_default))
    parser.add_argument("--name", default="", help="of state and tables (default: from kind, rows and settings)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="runs at a time (default: one a core)")
    parser.add_argument("--seconds", type=float, default=0.0, help="begin no run after this time; 0: make all")
    parser.add_argument("--fresh", action="store_true", help="forget what was run before")
    parser.add_argument("--share", type=float, default=1.0, help="part of the runs to make, 0 < share <= 1")
    parser.add_argument("--least", type=float, default=0.0,
                        help="part of each row's runs that must succeed (default 0: none)")
    parser.add_argument("--keep", type=int, default=1, metavar="K", help="failing worlds to keep of a row (default 1)")
    parser.add_argument("--trials", type=int, default=200, metavar="T", help="to make a kept world small (default 200)")
    parser.add_argument("--tern", default="build/host/tools/tern", help=argparse.SUPPRESS)
    parser.add_argument("--attack", default="build/host/tests/attack/tern_attack", help=argparse.SUPPRESS)
    parser.add_argument("--folder", default="build/campaign", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    arguments.runs = max(1, int(arguments.share * arguments.runs))
    arguments.settings = merge(KINDS[arguments.kind].settings_default, arguments.settings)
    return arguments


def merge(defaults, given):
    """Later settings replace earlier ones of the same key."""
    chosen = {}
    for text in [*defaults, *given]:
        chosen[text.split("=", 1)[0]] = text
    return list(chosen.values())


class Progress:
    def __init__(self, kind, total):
        self.kind, self.total, self.done, self.failures, self.began = kind, total, 0, 0, time.monotonic()
        self.shown = sys.stderr.isatty()

    def show(self, failed):
        self.done += 1
        self.failures += failed
        spent = time.monotonic() - self.began
        left = spent / self.done * (self.total - self.done)
        if self.shown or self.done % 100 == 0:
            print(f"\r{self.done} of {self.total} {self.kind.verb}, {spent:.0f} s, about {left:.0f} s left, "
                  f"{self.failures} failed  ", end="" if self.shown else "\n", file=sys.stderr,
                  flush=True)

    def say(self, text):
        print(f"{chr(13) if self.shown else ''}{text}", flush=True)


def describe(kind, entry):
    """What went wrong and the command that repeats it. Empty where nothing did."""
    wrong = [kind.excess(entry)]
    if kind.failed(entry):
        wrong.insert(0, f"{entry['status']}: {entry.get('reason') or entry.get('stage', '')}")
    if not any(wrong):
        return ""
    return f"{', '.join(filter(None, wrong))}: {shlex.join(kind.command(entry['row'], entry['seed']))}"


def missing_jobs(arguments, kind, state):
    """Seed by seed, so that all rows grow alike."""
    jobs = [kind.jobs(row, arguments.seed, arguments.runs) for row in arguments.rows]
    ordered = [job for together in zip(*jobs) for job in together]
    done = lambda job: all((job[0], seed) in state.runs for seed in kind_seeds(kind, job))
    return [job for job in ordered if not done(job)]


def wanted(arguments, kind, state, row):
    """The runs that were asked for. There may be others: of an earlier command with other seeds, or more of them."""
    jobs = kind.jobs(row, arguments.seed, arguments.runs)
    return state.of_row(row, {seed for job in jobs for seed in kind_seeds(kind, job)})


def kind_seeds(kind, job):
    return [job[1]] if kind.name == "attack" else range(job[1], job[1] + job[2])


def run_all(arguments, kind, state, executor, width):
    jobs = missing_jobs(arguments, kind, state)
    progress = Progress(kind, sum(len(kind_seeds(kind, job)) for job in jobs))
    end = time.monotonic() + arguments.seconds if arguments.seconds > 0.0 else float("inf")
    in_time = ((kind, job) for job in jobs if time.monotonic() <= end)
    for entries in pool.as_they_finish(executor, width, kinds.run_job, in_time):
        for entry in entries:
            if (entry["row"], entry["seed"]) in state.runs:
                continue
            state.add(entry)
            if describe(kind, entry):
                progress.say(describe(kind, entry))
            progress.show(kind.failed(entry))
    if progress.shown:
        print(file=sys.stderr)


def keep_failures(arguments, kind, state, stem, executor, width):
    """The first of each row, by seed. A file that is there already is not made again."""
    folder = pathlib.Path(f"{stem}-failures")
    jobs = []
    for row in arguments.rows if kind.keeps else []:
        failed = [entry for entry in wanted(arguments, kind, state, row) if kind.failed(entry)]
        jobs += [(kind, entry, str(folder), arguments.trials) for entry in failed[:arguments.keep]
                 if not (folder / minimise.file_name(row, entry["seed"])).exists()]
    for row, seed, text, words in pool.as_they_finish(executor, width, minimise.keep, jobs):
        print(f"{row}:{seed}: {words}", flush=True)
        if text is not None:
            folder.mkdir(parents=True, exist_ok=True)
            (folder / minimise.file_name(row, seed)).write_text(text)


def verdict(arguments, kind, state):
    """The exit status: what must never happen, and the least part that succeeds."""
    failed = False
    for row in arguments.rows:
        runs = wanted(arguments, kind, state, row)
        good = sum(entry["status"] == kind.good for entry in runs)
        failed = failed or good < arguments.least * len(runs) or \
            any(kind.is_defect(entry) or kind.excess(entry) for entry in runs)
    return 1 if failed else 0


def is_refused(arguments, kind):
    """True where the program does not know a row or a setting."""
    for row in arguments.rows:
        refusal = kind.refusal(row)
        if refusal:
            print(f"tools/campaign: {row}: {refusal}", file=sys.stderr)
            return True
    return False


def make(arguments, kind, executor, width):
    if is_refused(arguments, kind):
        return 2
    program = hashlib.sha256(pathlib.Path(kind.program).read_bytes()).hexdigest()[:16]
    seed = f", seed {arguments.seed}" if kind.name == "attack" else ""
    identity = f"{kind.name} program {program}, settings {' '.join(arguments.settings)}{seed}"
    words = " ".join([kind.name, *arguments.rows, *arguments.settings])
    stem = pathlib.Path(arguments.folder, arguments.name or hashlib.sha256(words.encode()).hexdigest()[:8])
    stem.parent.mkdir(parents=True, exist_ok=True)
    path = pathlib.Path(f"{stem}.csv")
    failures = pathlib.Path(f"{stem}-failures")
    if arguments.fresh:
        path.unlink(missing_ok=True)
        shutil.rmtree(failures, ignore_errors=True)
    state = State(path, identity, kind.fields)
    if state.put_aside:
        if failures.exists():
            failures.rename(state.put_aside.with_name(f"{state.put_aside.stem}-failures"))
        print(f"{path} has runs of another program or of other settings: it is now {state.put_aside}", flush=True)
    there = [entry for row in arguments.rows for entry in wanted(arguments, kind, state, row)]
    if there:
        print(f"{len(there)} runs are there already, from {path}", flush=True)
    for entry in there:
        if describe(kind, entry):
            print(describe(kind, entry), flush=True)
    run_all(arguments, kind, state, executor, width)
    keep_failures(arguments, kind, state, stem, executor, width)
    rows = {row: wanted(arguments, kind, state, row) for row in arguments.rows}
    table.write_tables(kind.name, [table.ROWS[kind.name](row, runs) for row, runs in rows.items()], stem)
    return verdict(arguments, kind, state)


def main():
    arguments = parse_arguments()
    program = arguments.attack if arguments.kind == "attack" else arguments.tern
    if not pathlib.Path(program).exists():
        print(f"tools/campaign: there is no program {program}; `tools/campaign build` makes it", file=sys.stderr)
        return 2
    kind = KINDS[arguments.kind](program, arguments.settings, arguments.seed)
    arguments.rows = kind.rows(arguments.rows)
    status = 0
    with pool.workers(arguments.jobs) as (executor, width):
        if executor is not None:
            status = make(arguments, kind, executor, width)
    return status


if __name__ == "__main__":
    sys.exit(main())
