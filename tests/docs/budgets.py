#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""budgets.py ROOT: what the tests allow a plan to take, instructions and stack, and how many plans the golden hash
covers, in the README's words."""
import csv
import pathlib
import re
import sys


def rows(path):
    return list(csv.DictReader(line for line in path.read_text().splitlines() if not line.startswith("#")))


def main():
    root = pathlib.Path(sys.argv[1])
    plans = {row["scenario"]: int(row["budget"]) for row in rows(root / "bench/timing/budgets.csv")
             if row["stage"] == "plan"}
    print("| plan | " + " | ".join(f"{plans[f'map{i}'] / 1e6:.3g}" for i in range(1, 7)) + " |")
    host = int(re.search(r"--budget (\d+)", (root / "tests/layers/CMakeLists.txt").read_text()).group(1))
    boards = {row["target"]: int(row["bytes"]) for row in rows(root / "tests/board/stack_budgets.csv")}
    print(f"{host:,} bytes on x86-64")
    print(f"{boards['baremetal-aarch64']:,} on aarch64")
    print(f"{boards['cortex-m7']:,} on Cortex-M7")
    counts = re.findall(r"constexpr int k(?:Map|Random|Uneven)Count = (\d+);", (root / "tests/golden/corpus.hpp").read_text())
    print(f"{sum(map(int, counts))} scenarios")


main()
