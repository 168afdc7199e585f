#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests with a core whose branches are counted, and lists the branches of core/src that none takes.

tests/coverage/exceptions.txt names branches that are left out, one a line: FILE | SOURCE LINE | REASON. The source line
stands for its place, without its comment, so that other lines and comments may change. A line there that no untaken
branch needs any more is an error."""
import argparse
import collections
import concurrent.futures
import csv
import json
import os
import pathlib
import re
import subprocess
import sys
import time

import mutants
import suite

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXCEPTIONS = ROOT / "tests/coverage/exceptions.txt"
SHARES = 4  # runs of each test program, so that the longest does not run alone at the end
LONGEST_RUN = 7200.0  # seconds


def parse_arguments():
    parser = argparse.ArgumentParser(prog="tools/coverage", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--files", default="", metavar="REGEX", help="list only files whose path matches")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="tests at a time (default: one a core)")
    parser.add_argument("--report-only", action="store_true", help="run nothing; read the counts of the last run")
    parser.add_argument("--results", default="", metavar="FILE", help="write the table there, too")
    parser.add_argument("--tests", default=str(ROOT / "build/quality"), help=argparse.SUPPRESS)
    parser.add_argument("--core", default=str(ROOT / "build/coverage"), help=argparse.SUPPRESS)
    return parser.parse_args()


def run_share(words, share, core):
    """Runs one share of a program's cases, or all of what is not GoogleTest's. Returns None, or how the run failed."""
    variables = dict(suite.environment(core), GTEST_TOTAL_SHARDS=str(SHARES), GTEST_SHARD_INDEX=str(share))
    log = core / f"{words[0].name}.{share}.log"
    with log.open("w") as output:
        ended = suite.run(words, variables, LONGEST_RUN, output)
    if ended == "passes":
        log.unlink()
        return None
    return f"{words[0].name}, share {share + 1} of {SHARES}, {ended} with the counted core: {log}"


def run_tests(programs, core, jobs):
    """Every test once; counts of processes add up in the core's own files. Returns what failed."""
    for path in core.rglob("*.gcda"):
        path.unlink()
    runs = [(words, share) for words in programs for share in range(SHARES if words[0].name.endswith("_test") else 1)]
    began, done, failed = time.monotonic(), 0, []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for run in concurrent.futures.as_completed([pool.submit(run_share, *run, core) for run in runs]):
            done += 1
            failed += [run.result()] if run.result() else []
            print(f"\r{done} of {len(runs)} runs, {time.monotonic() - began:.0f} s, {len(failed)} failed  ",
                  end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    return failed


def branches(core):
    """{(file, line): [taken or not, of each branch]} over all libraries."""
    done = subprocess.run(["gcovr", "--root", str(ROOT), "--filter", "core/src/", "--filter", "core/include/", "--json",
                           "--gcov-ignore-parse-errors", str(core)],
                          capture_output=True, text=True, cwd=ROOT)
    if done.returncode != 0:
        print(f"tools/coverage: gcovr failed: {done.stderr.strip()[-500:]}", file=sys.stderr)
        sys.exit(2)
    found = {}
    for file in json.loads(done.stdout)["files"]:
        for line in file["lines"]:
            if line["branches"]:
                found[file["file"], line["line_number"]] = [branch["count"] > 0 for branch in line["branches"]]
    return found


def code(line):
    return mutants.code_of(line).strip()


def read_exceptions():
    exceptions = {}
    for number, line in enumerate(EXCEPTIONS.read_text().splitlines() if EXCEPTIONS.exists() else [], 1):
        if not line or line.startswith("#"):
            continue
        parts = line.split(" | ")
        if len(parts) < 3 or not all(parts):
            print(f"{EXCEPTIONS}:{number}: must be FILE | SOURCE LINE | REASON", file=sys.stderr)
            sys.exit(2)
        exceptions[parts[0], code(" | ".join(parts[1:-1]))] = parts[-1]  # a source line may have a bar of its own
    return exceptions


def main():
    arguments = parse_arguments()
    core = pathlib.Path(arguments.core)
    programs = suite.programs(pathlib.Path(arguments.tests))
    failed = []
    if not arguments.report_only:
        failed = run_tests(programs, core, arguments.jobs)
    for failure in failed:
        print(failure)
    exceptions, used, totals = read_exceptions(), set(), collections.defaultdict(lambda: [0, 0, 0])
    listed = 0
    for (path, line), taken in sorted(branches(core).items()):
        source = (ROOT / path).read_text().splitlines()[line - 1].strip()
        named = path, code(source)
        missing = taken.count(False)
        is_named = missing > 0 and named in exceptions
        used |= {named} if is_named else set()
        for key in ("/".join(path.split("/")[:3]), "all"):
            totals[key][0] += len(taken)
            totals[key][1] += len(taken) - missing
            totals[key][2] += missing if is_named else 0
        if missing and not is_named and re.search(arguments.files, path):
            listed += 1
            print(f"{path}:{line}: {missing} of {len(taken)} branches not taken: {source}")
    unused = sorted(set(exceptions) - used) if not arguments.files else []
    for path, source in unused:
        print(f"{EXCEPTIONS.relative_to(ROOT)}: not needed any more: {path} | {source}")
    if arguments.results:
        write_table(pathlib.Path(arguments.results), totals)
    everything = totals["all"]
    print(f"{everything[1]} of {everything[0]} branches taken, {everything[2]} named as exceptions, "
          f"{everything[0] - everything[1] - everything[2]} not")
    return 1 if listed or unused or failed else 0


def write_table(path, totals):
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["stage", "branches", "taken", "named"])
        writer.writerows([key, *counts] for key, counts in sorted(totals.items()))


if __name__ == "__main__":
    sys.exit(main())
