#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""make_forests.py FOLDER: the gate's forests, seeded: cuboids on a 0.2 m lattice fill a part of 20 x 20 x 4 m, start and
goal in opposite corners and connected for a robot of 0.4 m. Writes forest_<percent>_<seed>.txt."""
import collections
import pathlib
import random
import sys

CELL = 0.2
SIZE = (100, 100, 20)  # in cells
START, GOAL = (5, 5, 7), (94, 94, 12)
CLEAR = 5  # cells around start and goal that stay free
MARGIN = 2  # cells of clearance that the connection keeps
FORESTS = [(percent, seed) for percent in (10, 15, 20, 25, 30) for seed in (1, 2)]


def near(cuboid, point):
    lower, upper = cuboid
    return all(lower[a] - CLEAR <= point[a] < upper[a] + CLEAR for a in range(3))


def random_cuboid(rng):
    lower = [rng.randrange(SIZE[0] - 3), rng.randrange(SIZE[1] - 3), 0]
    upper = [min(SIZE[a], lower[a] + rng.randint(3, 10)) for a in range(2)] + [SIZE[2]]
    kind = rng.random()
    if kind < 0.25:
        upper[2] = rng.randint(6, 17)
    elif kind < 0.35:
        lower[2] = rng.randint(3, 14)
    return lower, upper


def volume(cuboid):
    return [(x, y, z) for x in range(cuboid[0][0], cuboid[1][0]) for y in range(cuboid[0][1], cuboid[1][1])
            for z in range(cuboid[0][2], cuboid[1][2])]


def connected(cuboids):
    """Breadth-first over cells that keep MARGIN from every cuboid."""
    blocked = set()
    for lower, upper in cuboids:
        blocked.update(volume(([max(0, v - MARGIN) for v in lower],
                               [min(SIZE[a], upper[a] + MARGIN) for a in range(3)])))
    seen, queue = {START}, collections.deque([START])
    while queue:
        cell = queue.popleft()
        if cell == GOAL:
            return True
        for axis in range(3):
            for step in (-1, 1):
                after = list(cell)
                after[axis] += step
                after = tuple(after)
                if 0 <= after[axis] < SIZE[axis] and after not in seen and after not in blocked:
                    seen.add(after)
                    queue.append(after)
    return False


def forest(percent, seed):
    rng = random.Random(1000 * percent + seed)
    while True:
        cuboids, filled = [], set()
        while 100 * len(filled) < percent * SIZE[0] * SIZE[1] * SIZE[2]:
            cuboid = random_cuboid(rng)
            if not near(cuboid, START) and not near(cuboid, GOAL):
                cuboids.append(cuboid)
                filled.update(volume(cuboid))
        if connected(cuboids):
            return cuboids


def metres(cells):
    return " ".join(f"{c * CELL:.1f}" for c in cells)


def main():
    folder = pathlib.Path(sys.argv[1])
    for percent, seed in FORESTS:
        lines = [f"# random forest of cuboids, {percent} % of the volume, seed {seed}; written by make_forests.py",
                 f"boundary 0 0 0 {metres(SIZE)}"]
        lines += [f"block {metres(lower)} {metres(upper)}" for lower, upper in forest(percent, seed)]
        lines += [f"start {metres(START)}", f"goal {metres(GOAL)}", "resolution 0.1", "radius 0.25", "v_max 2", "a_max 2"]
        (folder / f"forest_{percent}_{seed}.txt").write_text("\n".join(lines) + "\n")


main()
