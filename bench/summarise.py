#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""summarise.py IN.json OUT.csv: Google Benchmark's aggregates as one row a map and stage, with the machine in comments."""
import csv
import json
import sys

STATISTICS = ("median", "p99", "max")


def main():
    data = json.load(open(sys.argv[1]))
    context = data["context"]
    rows = {}
    for entry in data["benchmarks"]:
        if entry.get("aggregate_name") in STATISTICS:
            row = rows.setdefault(tuple(entry["run_name"].split("/")[:2]), {})
            row[entry["aggregate_name"]] = entry["real_time"]
            for counter in ("work", "bound"):
                if counter in entry:
                    row[counter] = int(entry[counter])
    with open(sys.argv[2], "w", newline="") as out:
        out.write(f"# {context['num_cpus']} cores at {context['mhz_per_cpu']} MHz, {context['date'][:10]}, ")
        out.write("host preset (gcc, -O3), 100 plans a row, microseconds\n")
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(["map", "stage", "median_us", "p99_us", "max_us", "work", "bound"])
        for (name, stage), row in rows.items():
            times = [f"{row[s]:.1f}" for s in STATISTICS]
            writer.writerow([name, stage, *times, row.get("work", ""), row.get("bound", "")])
    print(f"{len(rows)} rows in {sys.argv[2]}")


main()
