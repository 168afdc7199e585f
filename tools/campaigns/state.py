# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finished runs in a file, one line each, written as they finish: a killed campaign goes on from it. The runs of
another program or of other settings are put aside, not deleted."""
import csv
import itertools


class State:
    def __init__(self, path, identity, fields):
        self.path, self.runs, self.put_aside = path, {}, None
        kept = self.load(identity)
        if not kept and path.exists() and path.stat().st_size:
            self.put_aside = next(free for k in itertools.count(1) if not (free := self.path_aside(k)).exists())
            path.rename(self.put_aside)
        self.file = path.open("a" if kept else "w", newline="")
        self.writer = csv.DictWriter(self.file, fields, restval="")
        if not kept:
            self.file.write(f"# {identity}\n")
            self.writer.writeheader()
            self.file.flush()

    def path_aside(self, k):
        return self.path.with_name(f"{self.path.stem}-{k}.csv")

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
            self.runs[entry["row"], int(entry["seed"])] = entry
        return len(lines) > 1

    def add(self, entry):
        """Kept as it is read back, so that a table does not depend on which runs are from an earlier process."""
        self.writer.writerow(entry)
        self.file.flush()
        self.runs[entry["row"], entry["seed"]] = {key: "" if value is None else str(value)
                                                  for key, value in entry.items()}

    def of_row(self, row, seeds):
        """The runs with these seeds that there are."""
        return [self.runs[row, seed] for seed in sorted(seeds) if (row, seed) in self.runs]
