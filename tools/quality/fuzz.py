#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the libFuzzer entries, one after the other, and notes how long and how often each ran."""
import argparse
import csv
import datetime
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENTRIES = ["scenario", "solve", "depth", "record", "request"]
TABLE = ROOT / "docs/measurements/fuzz.csv"
COLUMNS = ["entry", "date", "seed", "seconds", "inputs", "coverage edges", "corpus", "found wrong"]
LONGEST = 4096  # bytes of an input
KEPT = 40       # files of a corpus at most


def parse_arguments():
    parser = argparse.ArgumentParser(prog="tools/fuzz", description=__doc__)
    parser.add_argument("seconds", type=int, nargs="?", default=60, help="of each entry (default 60)")
    parser.add_argument("entries", nargs="*", default=[], metavar="ENTRY", help=" ".join(ENTRIES))
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="of the mutations (default 1)")
    parser.add_argument("--merge", action="store_true", help="add to the corpora what was found; fuzz nothing")
    parser.add_argument("--build", default=str(ROOT / "build/fuzz"), help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    unknown = set(arguments.entries) - set(ENTRIES)
    if unknown:
        parser.error(f"no such entry: {' '.join(sorted(unknown))}; the entries are {' '.join(ENTRIES)}")
    arguments.entries = arguments.entries or ENTRIES
    return arguments


def corpus_of(entry):
    return ROOT / "tests/fuzz/corpus" / entry


def fuzzer_of(arguments, entry):
    return pathlib.Path(arguments.build, "tests/fuzz", f"{entry}_fuzzer")


def last(pattern, text):
    found = re.findall(pattern, text)
    return int(found[-1]) if found else 0


def fuzz(arguments, entry):
    found = pathlib.Path(arguments.build, "found", entry)
    found.mkdir(parents=True, exist_ok=True)
    words = [fuzzer_of(arguments, entry), found, corpus_of(entry), f"-max_total_time={arguments.seconds}",
             f"-seed={arguments.seed}", f"-max_len={LONGEST}", "-print_final_stats=1", "-timeout=60",
             "-rss_limit_mb=4096",
             f"-artifact_prefix={arguments.build}/{entry}-"]
    done = subprocess.run(words, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    text = done.stderr.decode(errors="replace")
    row = [entry, datetime.date.today().isoformat(), arguments.seed, arguments.seconds,
           last(r"stat::number_of_executed_units: (\d+)", text) or last(r"#(\d+)", text), last(r"cov: (\d+)", text),
           len(list(found.iterdir())), int(done.returncode != 0)]
    print(", ".join(f"{name} {value}" for name, value in zip(COLUMNS, row)), flush=True)
    if done.returncode != 0:
        print(text[-3000:], flush=True)
    return row


def merge(arguments, entry):
    """Inputs that reach more than the corpus does, the shortest of them first, up to the size of a kept corpus."""
    found, corpus = pathlib.Path(arguments.build, "found", entry), corpus_of(entry)
    fresh = pathlib.Path(arguments.build, "merged", entry)
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir(parents=True)
    subprocess.run([fuzzer_of(arguments, entry), "-merge=1", f"-max_len={LONGEST}", fresh, corpus, found],
                   cwd=ROOT, check=True, stderr=subprocess.DEVNULL)
    room = KEPT - len(list(corpus.iterdir()))
    chosen = sorted((path for path in fresh.iterdir() if not (corpus / path.name).exists()),
                    key=lambda path: (path.stat().st_size, path.name))
    step = max(1, len(chosen) // max(1, room))
    for path in chosen[::step][:max(0, room)]:
        shutil.copy(path, corpus / path.name[:16])
    print(f"{entry}: {len(list(corpus.iterdir()))} files in the corpus", flush=True)


def main():
    arguments = parse_arguments()
    if arguments.merge:
        for entry in arguments.entries:
            merge(arguments, entry)
        return 0
    rows = [fuzz(arguments, entry) for entry in arguments.entries]
    is_new = not TABLE.exists()
    with TABLE.open("a", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows] if is_new else rows)
    return 1 if any(row[-1] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
