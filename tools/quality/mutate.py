#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Changes one token of the core at a time and looks whether a test notices (docs/evidence.md).

Mutants are made in a copy of the sources, in FOLDER/source, and built as shared libraries in FOLDER/build, with which
the tests of the preset `quality` run: they are built once. Headers are left alone, because tests compile them, too.
Tests run fastest first, those named after the changed stage before all others, and stop at the first that fails with
the change and passes without; one that takes far longer than before counts as failed. The tests of golden hashes are left out. The golden hash and a set
of plans and flights tell survivors apart: a mutant that changes no result of them is `equivalent`, any other has
`survived`.

Results are kept in build/mutate/results.csv, so that the same command goes on where a killed one was; another core
begins anew. Survivors named in tests/mutation/survivors.txt with a reason are `named`. Exit status: 0; 1 where a mutant
survived that is not named; 2 for wrong usage, or where the sources do not build without a change."""
import argparse
import csv
import pathlib
import re
import shutil
import subprocess
import sys
import time

import core_id
import mutants
import suite

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIELDS = ["id", "path", "kind", "before", "after", "result", "by", "seconds", "seed"]
COPIED = ["CMakeLists.txt", "CMakePresets.json", "bench", "core", "docs", "port", "tests", "toolchains", "tools"]
LIBRARIES = ["tern", "tern_tiny", "tern_mcu"]
# Tests of hashes and of the golden corpus, and tests that see none of the core's results. The records of the golden
# flight are compared with what the same core flies, so they run.
LEFT_OUT = ("tern_golden", "golden_flight_test", "golden_mcu_test", "golden_replans_test", "golden_flown_test",
            "baselines_")
CASES = ["table", "P25:1", "P12:2", "S20:3", "O:4", "M:5", "L:6", "G:7", "B:8", "I:9", "D:10",
         *(f"bench/maps/map{k}.txt" for k in range(1, 7)), "docs/missions.txt", "docs/yaw.txt", "--repeat", "1"]
FLIGHTS = ["P49@3:1", "O:2"]


def parse_arguments():
    parser = argparse.ArgumentParser(prog="tools/mutate", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=20, metavar="N", help="mutants to try (default 20)")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="of their order (default 1)")
    parser.add_argument("--files", default="", metavar="REGEX", help="only files whose path matches")
    parser.add_argument("--only", default="", metavar="ID", help="try this mutant alone, and again")
    parser.add_argument("--seconds", type=float, default=0.0, help="begin no mutant after this time; 0: try all")
    parser.add_argument("--list", action="store_true", help="print the mutants and try none")
    parser.add_argument("--results", default=str(ROOT / "build/mutate/results.csv"), help=argparse.SUPPRESS)
    parser.add_argument("--tests", default=str(ROOT / "build/quality"), help=argparse.SUPPRESS)
    parser.add_argument("--folder", default=str(ROOT / "build/mutate"), help=argparse.SUPPRESS)
    return parser.parse_args()


class Bench:
    """A copy of the sources with a build of the core's libraries, and the tests that run with them."""

    def __init__(self, folder, tests):
        self.source, self.build, self.programs = folder / "source", folder / "build", tests
        self.tests = suite.programs(tests, LEFT_OUT)
        self.seconds, self.sound, self.reference = {}, {}, None

    def prepare(self):
        self.copy()
        # A change may only be a warning.
        words = ["cmake", "--preset", "quality", "-B", str(self.build), "-DTERN_WERROR=OFF"]
        done = subprocess.run(words, cwd=self.source, capture_output=True, text=True)
        print("building the core", file=sys.stderr, flush=True)
        if done.returncode != 0 or not self.make():
            print(f"tools/mutate: the sources do not build without a change: {done.stderr.strip()[-300:]}",
                  file=sys.stderr)
            sys.exit(2)
        self.reference = self.results(self.programs)

    def copy(self):
        """Only what differs is written, so that a second run builds nothing anew."""
        for name in COPIED:
            top = ROOT / name
            for path in [top] if top.is_file() else top.rglob("*"):
                target = self.source / path.relative_to(ROOT)
                if path.is_file() and (not target.exists() or target.read_bytes() != path.read_bytes()):
                    target.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy(path, target)

    def make(self):
        return subprocess.run(["ninja", "-C", str(self.build), *LIBRARIES], capture_output=True).returncode == 0

    def is_sound(self, words):
        """True where the test passes without a change; one that does not is left out, aloud."""
        if words[0] not in self.sound:
            began = time.monotonic()
            self.sound[words[0]] = suite.passes(words, self.programs, 900.0)
            self.seconds[words[0]] = time.monotonic() - began
            if not self.sound[words[0]]:
                print(f"left out: {words[0].name} fails without a change", flush=True)
        return self.sound[words[0]]

    def place(self, words, stage):
        """Where a test comes in the order: that of the stage first, then fast ones."""
        name = words[0].name
        return name != f"{stage}_test", self.seconds.get(words[0], 5.0), name

    def killer(self, mutant):
        """The first test that fails, and does not without the change; empty where none does."""
        stage = mutant.path.split("/")[2]
        for words in sorted(self.tests, key=lambda test: self.place(test, stage)):
            if self.is_sound(words) and not suite.passes(words, self.build, 10.0 + 5.0 * self.seconds[words[0]]):
                return words[0].name
        return ""

    def results(self, core):
        """What plans and flights come to with the libraries of a build tree, and the golden hash."""
        tern, lines = self.programs / "tools/tern", []
        calls = [[tern, *CASES, "--rows", "/dev/stdout"], [self.programs / "tests/golden/tern_golden"]]
        calls += [[tern, "fly", world, "--json", "/dev/stdout"] for world in FLIGHTS]
        for words in calls:
            try:
                done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, timeout=120,
                                      env=suite.environment(core))
                lines += done.stdout.splitlines()
            except subprocess.TimeoutExpired:
                lines.append("too long")
        # The printed table has times.
        return [line for line in lines if not re.match(r"[\w:/.]+ +ok ", line)]

    def judge(self, mutant):
        path = self.source / mutant.path
        original = path.read_text()
        try:
            path.write_text(mutants.apply(mutant, original))
            if not self.make():
                return "not built", ""
            killer = self.killer(mutant)
            if killer:
                return "killed", killer
            return ("equivalent" if self.results(self.build) == self.reference else "survived"), ""
        finally:
            path.write_text(original)


class Results:
    def __init__(self, path, identity):
        self.done = {}
        text = path.read_text() if path.exists() else ""
        lines = text[:text.rfind("\n") + 1].splitlines()  # without one that was cut off
        kept = lines[:1] == [f"# {identity}"]
        if kept:
            self.done = {row["id"]: row for row in csv.DictReader(lines[1:])}
            path.write_text("".join(f"{line}\n" for line in lines))
        path.parent.mkdir(parents=True, exist_ok=True)
        self.file = path.open("a" if kept else "w", newline="")
        self.writer = csv.DictWriter(self.file, FIELDS, lineterminator="\n")
        if not kept:
            self.file.write(f"# {identity}\n")
            self.writer.writeheader()

    def add(self, row):
        self.writer.writerow(row)
        self.file.flush()
        self.done[row["id"]] = row


def named():
    """Survivors that are known, by id, with the reason."""
    path = ROOT / "tests/mutation/survivors.txt"
    lines = path.read_text().splitlines() if path.exists() else []
    return dict(line.split(" ", 1) for line in lines if line and not line.startswith("#"))


def print_table(rows, reasons):
    columns = ["killed", "survived", "named", "equivalent", "not built"]
    result = lambda row: "named" if row["result"] == "survived" and row["id"] in reasons else row["result"]
    print("| change | tried | " + " | ".join(columns) + " |\n| --- |" + " --- |" * (len(columns) + 1))
    for kind in [*sorted({row["kind"] for row in rows}), "all"]:
        chosen = [row for row in rows if kind in ("all", row["kind"])]
        counts = [sum(result(row) == column for row in chosen) for column in columns]
        print(f"| {kind} | {len(chosen)} | " + " | ".join(map(str, counts)) + " |")


def main():
    arguments = parse_arguments()
    folder = pathlib.Path(arguments.folder)
    order = mutants.chosen(ROOT, arguments.seed, arguments.files)
    order = [m for m in order if m.id == arguments.only] if arguments.only else order[:arguments.runs]
    if arguments.list or not order:
        for m in order:
            print(f"{m.id} {m.path}:{m.line}: {m.kind}: {m.before} -> {m.after}")
        return 0 if order else 2
    results = Results(pathlib.Path(arguments.results), f"core {core_id.present()}")
    missing = [m for m in order if m.id not in results.done or arguments.only]
    end = time.monotonic() + arguments.seconds if arguments.seconds else float("inf")
    bench = Bench(folder, pathlib.Path(arguments.tests))
    if missing:
        bench.prepare()
    for number, m in enumerate(missing, 1):
        if time.monotonic() > end:
            break
        began = time.monotonic()
        result, by = bench.judge(m)
        found = {**m._asdict(), "result": result, "by": by, "seconds": f"{time.monotonic() - began:.1f}",
                 "seed": arguments.seed}
        results.add({field: found[field] for field in FIELDS})
        print(f"{number} of {len(missing)}: {m.id} {m.path}:{m.line}: {m.kind}: {m.before} -> {m.after}: {result} {by}",
              file=sys.stderr, flush=True)
    rows, reasons = [results.done[m.id] for m in order if m.id in results.done], named()
    print_table(rows, reasons)
    return 1 if any(row["result"] == "survived" and row["id"] not in reasons for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
