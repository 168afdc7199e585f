#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""painted_stack.py --graph DIR... --interrupt BYTES -- EMULATOR... IMAGE: runs the golden image, fails where it does, and
holds the painted high-water mark of its plans against the call graph of everything below its plan(). A mark above the
graph says that the graph lacks something; one below half of it, that the paint or the corpus misses the deep chains."""
import argparse
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "layers"))
sys.dont_write_bytecode = True
import stack  # noqa: E402

ROOT = re.compile(r"\{anonymous\}::plan\(")
MARK = re.compile(r"stack high water (\d+) of")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--graph", action="append", required=True)
    parser.add_argument("--interrupt", type=int, required=True)
    parser.add_argument("command", nargs="+")
    arguments = parser.parse_args()
    run = subprocess.run(arguments.command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True)
    print(run.stdout, end="")
    mark = MARK.search(run.stdout)
    if run.returncode != 0 or not mark:
        print(f"exit status {run.returncode}")
        return 1
    frames, calls, labels, faults = stack.read(*arguments.graph)
    depth, follow = stack.deepest(frames, calls, faults)
    # Start-up calls the constructors through pointers, before and above any plan.
    faults = [fault for fault in faults if not fault.startswith("tern_board_run:")]
    roots = [name for name, label in labels.items() if ROOT.search(label)]
    if len(roots) != 1:
        print(f"{len(roots)} functions are plan() in the call graph of {len(frames)}")
        return 1
    painted, bound = int(mark.group(1)), depth[roots[0]] + arguments.interrupt
    print(f"stack of a plan: {painted} bytes painted, {bound} by the call graph ({arguments.interrupt} an interrupt's):")
    stack.print_chain(roots[0], frames, follow, labels)
    print("\n".join(faults))
    return 0 if bound / 2 <= painted <= bound and not faults else 1


sys.exit(main())
