#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the libFuzzer entries side by side, and notes how long and how often each ran. What an entry found stays in
build/fuzz/found, so that a run goes on where the one before ended, with another seed."""
import argparse
import concurrent.futures
import csv
import datetime
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENTRIES = ["scenario", "solve", "depth", "record", "request", "airspace"]
COLUMNS = ["entry", "date", "seed", "seconds", "inputs", "coverage edges", "corpus", "found wrong"]
LONGEST = 4096  # bytes of an input
KEPT = 40       # files that a merge chooses for a corpus, at most
CHOSEN = re.compile("[0-9a-f]{16}")  # names that a merge gives; others were given by hand


def parse_arguments():
    parser = argparse.ArgumentParser(prog="tools/fuzz", description=__doc__)
    parser.add_argument("seconds", type=int, nargs="?", default=60, help="of each entry (default 60)")
    parser.add_argument("entries", nargs="*", default=[], metavar="ENTRY", help=" ".join(ENTRIES))
    parser.add_argument("--seed", type=int, default=0, metavar="S",
                        help="of the mutations (default: the number of the entry's run)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="entries at a time (default: one a core)")
    parser.add_argument("--merge", action="store_true", help="choose the corpora anew from what was found; fuzz nothing")
    parser.add_argument("--results", type=pathlib.Path, default=ROOT / "build/fuzz/runs.csv", metavar="FILE",
                        help="a line a run is added there (default build/fuzz/runs.csv)")
    parser.add_argument("--in-all", action="store_true", help="the runs in --results count as a part of SECONDS")
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


def rows_before(arguments, entry):
    path = arguments.results
    rows = list(csv.DictReader(path.read_text().splitlines())) if path.exists() else []
    return [row for row in rows if row["entry"] == entry]


def seconds_left(arguments, entry):
    spent = sum(int(row["seconds"]) for row in rows_before(arguments, entry)) if arguments.in_all else 0
    return max(0, arguments.seconds - spent)


def last(pattern, text):
    found = re.findall(pattern, text)
    return int(found[-1]) if found else 0


def fuzz(arguments, entry):
    """One run. Returns its row, and what the fuzzer said where it found something wrong."""
    found = pathlib.Path(arguments.build, "found", entry)
    found.mkdir(parents=True, exist_ok=True)
    seed = arguments.seed or 1 + len(rows_before(arguments, entry))
    words = [fuzzer_of(arguments, entry), found, corpus_of(entry), f"-max_total_time={seconds_left(arguments, entry)}",
             f"-seed={seed}", f"-max_len={LONGEST}", "-print_final_stats=1", "-timeout=60", "-rss_limit_mb=4096",
             f"-artifact_prefix={arguments.build}/{entry}-"]
    began = datetime.datetime.now()
    done = subprocess.run(words, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    text = done.stderr.decode(errors="replace")
    seconds = round((datetime.datetime.now() - began).total_seconds())
    row = [entry, began.date().isoformat(), seed, seconds,
           last(r"stat::number_of_executed_units: (\d+)", text) or last(r"#(\d+)", text), last(r"cov: (\d+)", text),
           len(list(found.iterdir())), int(done.returncode != 0)]
    return row, text[-3000:] if done.returncode != 0 else ""


def note(path, row):
    """A run is noted when it ends, so that a killed command loses those under way alone."""
    is_new = not path.exists()
    with path.open("a", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([COLUMNS, row] if is_new else [row])


def fuzz_all(arguments):
    """The exit status: 1 where an entry found something wrong."""
    wrong, entries = 0, [entry for entry in arguments.entries if seconds_left(arguments, entry)]
    with concurrent.futures.ThreadPoolExecutor(max(1, arguments.jobs)) as pool:
        runs = [pool.submit(fuzz, arguments, entry) for entry in entries]
        for run in concurrent.futures.as_completed(runs):
            row, text = run.result()
            note(arguments.results, row)
            wrong |= bool(text)
            print(", ".join(f"{name} {value}" for name, value in zip(COLUMNS, row)), text, sep="\n" if text else "",
                  flush=True)
    return int(wrong)


def reached(control):
    """Of each input of a merge, by name: the features that it reaches (edges, and how often it takes each), as
    libFuzzer's control file has them."""
    lines = control.read_text().splitlines()
    names = lines[2:2 + int(lines[0])]
    features = {}
    for line in lines:
        words = line.split()
        if words[:1] == ["FT"]:
            features[names[int(words[1])]] = set(words[2:])
    return features


def choose(features, named):
    """Inputs that, with those named, reach the most features, one after the other; of equal ones, the shortest. KEPT
    at most, and none that reaches nothing more. Also how many features that is."""
    chosen, known = [], set().union(*(features[name] for name in features if name in named))
    left = dict(sorted(((name, reach) for name, reach in features.items() if name not in named),
                       key=lambda item: (pathlib.Path(item[0]).stat().st_size, item[0])))
    while left and len(chosen) < KEPT:
        best = max(left, key=lambda name: len(left[name] - known))
        if left[best] <= known:
            break
        known |= left.pop(best)
        chosen.append(best)
    return chosen, len(known)


def merge(arguments, entry):
    """The corpus anew: of all inputs that there are, those that reach the most features. A file with a name given by
    hand stays: it is an input that once led to a mistake."""
    found, corpus = pathlib.Path(arguments.build, "found", entry), corpus_of(entry)
    fresh = pathlib.Path(arguments.build, "merged", entry)
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir(parents=True)
    found.mkdir(parents=True, exist_ok=True)
    control = fresh.with_suffix(".control")
    control.unlink(missing_ok=True)
    subprocess.run([fuzzer_of(arguments, entry), "-set_cover_merge=1", f"-merge_control_file={control}",
                    f"-max_len={LONGEST}", fresh, corpus, found], cwd=ROOT, check=True, stderr=subprocess.DEVNULL)
    features = reached(control)
    named = {str(path) for path in corpus.iterdir() if not CHOSEN.fullmatch(path.name)}
    chosen, count = choose(features, named)
    kept = {hashlib.sha1(data).hexdigest()[:16]: data for data in (pathlib.Path(name).read_bytes() for name in chosen)}
    for path in corpus.iterdir():
        if str(path) not in named:
            path.unlink()
    for name, data in kept.items():
        (corpus / name).write_bytes(data)
    print(f"{entry}: {len(kept) + len(named)} files in the corpus reach {count} of "
          f"{len(set().union(*features.values()))} features", flush=True)


def main():
    arguments = parse_arguments()
    if arguments.merge:
        for entry in arguments.entries:
            merge(arguments, entry)
        return 0
    return fuzz_all(arguments)


if __name__ == "__main__":
    sys.exit(main())
