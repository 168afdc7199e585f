#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""table.py STAGES.csv: the README's worst-case table, median / p99 / max in microseconds, from bench/results."""
import csv
import sys


def short(text):
    value = float(text)
    return f"{value:.0f}" if value >= 10 else f"{value:.1f}"


def main():
    lines = [line for line in open(sys.argv[1]) if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    stages = list(dict.fromkeys(row["stage"] for row in rows))
    maps = list(dict.fromkeys(row["map"] for row in rows))
    cells = {(row["map"], row["stage"]): row for row in rows}
    print("| stage | " + " | ".join(maps) + " |")
    print("| --- |" + " --- |" * len(maps))
    for stage in stages:
        entries = []
        for name in maps:
            row = cells[name, stage]
            entries.append(" / ".join(short(row[k]) for k in ("median_us", "p99_us", "max_us")))
        print(f"| {stage} | " + " | ".join(entries) + " |")


main()
