#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""minimiser.py TOOLS TERN ATTACK FOLDER: delta debugging on predicates that are known, and on real plans, flights and a
case of the attack: what is kept fails as the whole did, and without any one of its obstacles it does not."""
import pathlib
import random
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from expectations import expect, status  # noqa: E402

TOOLS, TERN, ATTACK, FOLDER = sys.argv[1:5]
sys.path.insert(0, TOOLS)
import kinds  # noqa: E402
import minimise  # noqa: E402


def known_predicates():
    for seed in range(50):
        rng = random.Random(seed)
        needed = set(rng.sample(range(100), rng.randint(0, 5)))
        fewest, asked = minimise.ddmin(list(range(100)), lambda items: needed <= set(items), 10000)
        if set(fewest) != needed or len(fewest) != len(needed) or asked > 400:
            return False
    return True


def asks_no_more_than_told():
    asked = []
    fewest, count = minimise.ddmin(list(range(64)), lambda items: asked.append(items) or 5 in items, 4)
    return len(asked) == count == 4 and 5 in fewest


def campaign(*words):
    return subprocess.run([sys.executable, f"{TOOLS}/campaign.py", *words, "--tern", TERN, "--attack", ATTACK,
                           "--folder", FOLDER, "--keep", "1"], capture_output=True, text=True)


def obstacles_of(text):
    lines = text.splitlines()
    return [number for number, line in enumerate(lines) if minimise.is_obstacle(line)]


def needs_each(kind, text, wanted):
    """True where the file fails, and does not once an obstacle is taken out."""
    path = pathlib.Path(FOLDER, "without.txt")
    lines = text.splitlines()
    path.write_text(text)
    if kind.status_of(path, {}) != wanted:
        return False
    for number in obstacles_of(text):
        path.write_text("".join(f"{line}\n" for k, line in enumerate(lines) if k != number))
        if kind.status_of(path, {}) == wanted:
            return False
    return True


def refused_plan():
    """The goal lies in a wall of a maze, so that one block is to blame."""
    done = campaign("plan", "M", "--runs", "1", "--seed", "4", "--set", "goal=6,3,1.2", "--name", "refused")
    text = pathlib.Path(FOLDER, "refused-failures", "M-4.txt").read_text()
    expect("a refused plan is kept: " + done.stdout.splitlines()[-4], len(obstacles_of(text)) == 1)
    expect("its file has the setting once", [line for line in text.splitlines() if line.startswith("goal")] ==
           ["goal 6 3 1.2"])
    expect("its block is needed", needs_each(kinds.Plan(TERN, [], 1), text, "goal_occupied"))


def late_flight():
    done = campaign("fly", "B", "--runs", "1", "--set", "time_limit=0.2", "--trials", "30", "--name", "late")
    text = pathlib.Path(FOLDER, "late-failures", "B-1.txt").read_text()
    expect("a flight that ends too early needs no obstacle at all: " + done.stdout.splitlines()[-3],
           obstacles_of(text) == [] and "time_limit 0.2" in text)
    expect("its file repeats it", kinds.Fly(TERN, [], 1).status_of(
        pathlib.Path(FOLDER, "late-failures", "B-1.txt"), {}) == "timeout")


def attacked_case():
    """The obstacles of a case, some of them left out: the world has the others."""
    kind = kinds.Attack(ATTACK, [], 1)
    entry = {"row": "noise", "seed": 0, "violations": "20 clearance"}
    lines = kind.world_file(entry).splitlines()
    few = pathlib.Path(FOLDER, "few.txt")
    few.write_text("\n".join(lines[:3]) + "\n")
    voxels = sum(int(end) - int(begin) for _, begin, end, *_ in map(str.split, lines[:3]))
    words = kind.file_command(few, entry)
    done = subprocess.run([*words, "--verbose"], capture_output=True, text=True)
    expect("a case's obstacles are written and read", len(lines) > 3 and f"solid {voxels}\n" in done.stdout)
    expect("a case without a violation is told from one", kind.status_of(few, entry) == "ok")
    state = "program 1\nseconds 2\n" + "tally 0 0 0 0 0 0 0 0 0 0\n" * 3 + \
        "tally 500 700 9 8 7 6 5 4 3 90000 0 600 41 100\nblock 0\n" \
        "violation 33 clearance by 1e-3 m\nviolation 43 near no\n"
    block = kind.read_state(state)
    expect("a block's state is read", (block["plans"], block["work"], block["ok"], block["contacts"],
                                       block["violations"], kind.case(block)) ==
           (700, 90000, 600, 1, "33 clearance;43 near", ["33", "clearance"]))


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    pathlib.Path(FOLDER).mkdir(parents=True)
    expect("predicates that are known: exactly what they need is left", known_predicates())
    expect("no more trials than told, and still failing", asks_no_more_than_told())
    refused_plan()
    late_flight()
    attacked_case()
    return status()


if __name__ == "__main__":
    sys.exit(main())
