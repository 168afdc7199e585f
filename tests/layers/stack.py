#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""stack.py DIR --budget BYTES: worst-case stack over the call graph that gcc wrote (-fcallgraph-info=su).
Fails on recursion, on a frame without a bound, on an indirect call other than the caller's clock, and above the
budget. Prints the deepest chain."""
import argparse
import pathlib
import re
import sys

NODE = re.compile(r'node: \{ title: "([^"]+)" label: "([^"]*)"')
EDGE = re.compile(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"')
FRAME = re.compile(r"(\d+) bytes \((\w+(?:,\w+)?)\)")
# Calls through a pointer end here; the only one is the caller's clock, whose stack is the caller's.
INDIRECT = "__indirect_call"
CLOCK_CALLER = "run_phase"


def read(folder):
    frames, calls, labels, faults = {}, {}, {}, []
    for path in sorted(pathlib.Path(folder).rglob("*.ci")):
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
                below = [(depth.get(t, 0), t) for t in sorted(calls.get(name, ())) if t in frames]
                best = max(below, default=(0, None))
                depth[name], follow[name] = frames[name] + best[0], best[1]
                state[name] = "done"
            elif name not in state:
                state[name] = "open"
                stack.append((name, True))
                for target in sorted(calls.get(name, ())):
                    if target == INDIRECT and CLOCK_CALLER not in name:
                        faults.append(f"{name}: calls through a pointer")
                    if state.get(target) == "open":
                        faults.append(f"{name}: recursion through {target}")
                    elif target in frames and target not in state:
                        stack.append((target, False))
    return depth, follow


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder")
    parser.add_argument("--budget", type=int, required=True)
    arguments = parser.parse_args()
    frames, calls, labels, faults = read(arguments.folder)
    if not frames:
        print(f"no call graph under {arguments.folder}")
        return 1
    depth, follow = deepest(frames, calls, faults)
    worst = max(depth, key=lambda name: (depth[name], name))
    print(f"worst-case stack {depth[worst]} bytes of {arguments.budget}, over {len(frames)} functions:")
    name = worst
    while name:
        print(f"  {frames[name]:6d}  {labels[name]}")
        name = follow[name]
    for fault in faults:
        print(fault)
    return 1 if faults or depth[worst] > arguments.budget else 0


sys.exit(main())
