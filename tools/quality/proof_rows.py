# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Totals of `tools/prove`, one row a run of it, and how the page of the evidence may show them. `core` is the hash of the
core's sources (core_id.py)."""
import csv
import pathlib

FILE = pathlib.Path(__file__).resolve().parents[2] / "docs/measurements/proofs.csv"
HEAD = ["kind", "date", "core", "families", "seeds", "settings"]
COUNTS = {"plans": ["scenarios", "plans"], "flights": ["flights", "reached", "commits"]}
# Least margins: m, m/s, m/s^2 and m/s^3.
MARGINS = ["joints", "ends", "vias", "boundary", "inside corridor", "corridor", "curve", "fences", "velocity",
           "acceleration", "jerk", "rest", "takeovers", "goal", "commands", "tracking", "body"]
FIELDS = [*HEAD, "scenarios", "plans", "flights", "reached", "commits", "proven", "claims", *MARGINS]


def rows_of(path):
    return list(csv.DictReader(path.read_text().splitlines())) if path.exists() else []


def add(row, path=FILE):
    """A row takes the place of an earlier one of the same kind, families, settings and first seed."""
    key = lambda row: (row["kind"], row["families"], row["settings"], int(row["seeds"].split()[0]))
    kept = [other for other in rows_of(path) if key(other) != key(row)]
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(sorted([*kept, row], key=key))


def section(table, path=FILE):
    """The page's section; empty without results."""
    rows, text = rows_of(path), ""
    for kind, counts in COUNTS.items():
        chosen = [row for row in rows if row["kind"] == kind]
        if not chosen:
            continue
        margins = [column for column in MARGINS if any(row[column] for row in chosen)]
        columns = [column for column in HEAD if column != "kind"] + counts + ["proven", "claims"]
        body = [[row[column] for column in [*columns, *margins]] for row in chosen]
        summed = [str(sum(int(row[column]) for row in chosen)) for column in [*counts, "proven", "claims"]]
        lowest = [min((row[column] for row in chosen if row[column]), key=float) for column in margins]
        body.append(["all", *[""] * (len(HEAD) - 2), *summed, *lowest])
        text += f"\n### Of {kind}\n\n" + table([*columns, *margins], body)
    if not text:
        return ""
    return ("\n## Proofs\n\n`tools/prove` proves plans and flights again in exact arithmetic ([verify](../verify.md)). The "
            "last columns have the\nleast margins, in m, m/s, m/s² and m/s³; below 0, they use part of a tolerance.\n" +
            text)
