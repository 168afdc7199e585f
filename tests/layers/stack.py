#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""stack.py DIR --budget BYTES | --budgets TABLE --target NAME: worst-case stack over the call graph that gcc wrote
(-fcallgraph-info=su). Fails on recursion, on a frame without a bound, on an indirect call other than the caller's clock,
and above the budget. Prints the deepest chain."""
import argparse
import csv
import pathlib
import re
import sys

NODE = re.compile(r'node: \{ title: "([^"]+)" label: "([^"]*)"')
EDGE = re.compile(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"')
FRAME = re.compile(r"(\d+) bytes \((\w+(?:,\w+)?)\)")
# Calls through a pointer end here; the only one is the caller's clock, whose stack is the caller's. The ledger reads it,
# in whichever function the compiler inlines that.
INDIRECT = "__indirect_call"
CLOCK_CALLERS = ("4tern5Clock", "4tern6Ledger", "4tern8Pipeline")
# What a function outside the graph may take: memcpy and its kin, and the compiler's integer helpers, are leaves of a few
# registers.
OUTSIDE_FRAME = 64


def read(*folders):
    """Frames, calls and labels by symbol, and what is wrong with a frame, of every graph below the folders."""
    frames, calls, labels, faults = {}, {}, {}, []
    for path in sorted(path for folder in folders for path in pathlib.Path(folder).rglob("*.ci")):
        text = path.read_text()
        for name, label in NODE.findall(text):
            frame = FRAME.search(label)
            if frame:
                frames[name] = int(frame.group(1))
                labels[name] = label.split("\\n")[0]
                # "dynamic,bounded" is a frame that moves while arguments are pushed: the size is its bound.
                if frame.group(2) == "dynamic":
                    faults.append(f"{labels[name]}: frame is {frame.group(2)}")
        for source, target in EDGE.findall(text):
            calls.setdefault(source, set()).add(target)
    return frames, calls, labels, faults


def deepest(frames, calls, faults):
    """Depth and next call of every function, callees first; a function met again on the way down recurses."""
    depth, follow, state = {}, {}, {}
    for root in sorted(frames):
        stack = [(root, False)]
        while stack:
            name, done = stack.pop()
            if done:
                targets = sorted(set(calls.get(name, ())) - {INDIRECT})
                below = [(depth.get(t, 0) if t in frames else OUTSIDE_FRAME, t) for t in targets]
                best = max(below, default=(0, None))
                depth[name], follow[name] = frames[name] + best[0], best[1]
                state[name] = "done"
            elif name not in state:
                state[name] = "open"
                stack.append((name, True))
                for target in sorted(calls.get(name, ())):
                    if target == INDIRECT and not any(caller in name for caller in CLOCK_CALLERS):
                        faults.append(f"{name}: calls through a pointer")
                    if state.get(target) == "open":
                        faults.append(f"{name}: recursion through {target}")
                    elif target in frames and target not in state:
                        stack.append((target, False))
    return depth, follow


def print_chain(name, frames, follow, labels):
    while name:
        print(f"  {frames.get(name, OUTSIDE_FRAME):6d}  {labels.get(name, name + ' (outside, assumed)')}")
        name = follow.get(name)


def budget_of(table, target):
    rows = csv.DictReader(line for line in pathlib.Path(table).read_text().splitlines() if not line.startswith("#"))
    return {row["target"]: int(row["bytes"]) for row in rows}[target]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder")
    parser.add_argument("--budget", type=int)
    parser.add_argument("--budgets")
    parser.add_argument("--target")
    arguments = parser.parse_args()
    budget = arguments.budget or budget_of(arguments.budgets, arguments.target)
    frames, calls, labels, faults = read(arguments.folder)
    if not frames:
        print(f"no call graph under {arguments.folder}")
        return 1
    depth, follow = deepest(frames, calls, faults)
    worst = max(depth, key=lambda name: (depth[name], name))
    print(f"worst-case stack {depth[worst]} bytes of {budget}, over {len(frames)} functions:")
    print_chain(worst, frames, follow, labels)
    print("\n".join(faults))
    return 1 if faults or depth[worst] > budget else 0


if __name__ == "__main__":
    sys.exit(main())
