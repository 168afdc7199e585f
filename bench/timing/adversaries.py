#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""adversaries.py [--rounds N] FOLDER IMAGE EMULATOR...: lets the adversary's image search for each stage's worst
scenario, two stages at a time, and writes them to FOLDER as adversary_<stage>.txt."""
import argparse
import concurrent.futures
import pathlib
import subprocess

STAGES = ["inflate", "search", "shortcut", "corridor", "trajectory", "check"]


def search(stage, arguments):
    command = arguments.emulator + [arguments.image, "-append", f"{stage} {arguments.rounds}"]
    run = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, check=True)
    lines = run.stdout.splitlines()
    kept = [line for line in lines if not line.startswith("# round")]
    (arguments.folder / f"adversary_{stage}.txt").write_text("\n".join(kept) + "\n")
    return "\n".join([stage] + [line for line in lines if line.startswith("# round")])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=1000)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("image")
    parser.add_argument("emulator", nargs="+")
    arguments = parser.parse_args()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for progress in pool.map(lambda stage: search(stage, arguments), STAGES):
            print(progress)


main()
