#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""envelope.py FOLDER: writes scenarios for three vehicles with limits of thrust, tilt and body rates into the folder.

Each flies from rest to rest through worlds of its own size: straight and steep legs in the open, forests and gates.
tools/bench reference compares their plans with a solver that has the limits as they are."""
import random
import sys
from pathlib import Path

# name: speed, thrust over weight, tangent of the tilt, rad/s, least thrust, metres across
VEHICLES = {
    "racer": (20, 5.0, 3.732, 12, 2.0, 40),           # 75 degrees
    "racer_heavy": (15, 4.0, 2.747, 10, 2.0, 40),     # 70 degrees
    "delivery": (12, 2.0, 1.0, 3.5, 3.0, 60),         # 2 kg, 45 degrees
    "delivery_loaded": (10, 1.5, 0.7, 3.5, 3.0, 60),  # 35 degrees
}
GRAVITY = 9.80665
LEGS = [(1, 0, 0), (0.7, 0.7, 0), (0.9, 0, 0.4), (0.5, 0.2, -0.6), (0, 0, 1), (0, 0, -1)]


def record(key, *values):
    return " ".join([key, *(f"{v:.6g}" for v in values)])


def limits(vehicle):
    speed, lift, tilt, rate, least, _ = VEHICLES[vehicle]
    thrust = lift * GRAVITY
    return [record("v_max", speed), record("a_max", 2 * thrust), record("thrust_max", thrust),
            record("thrust_min", least), record("tilt_tangent", tilt), record("rate_max", rate)]


def scenario(vehicle, start, goal, blocks):
    size = VEHICLES[vehicle][5]
    return "\n".join([record("boundary", 0, 0, 0, size, size, size / 3), record("start", *start), record("goal", *goal),
                      record("resolution", 0.2), record("radius", 0.3), *limits(vehicle),
                      *(record("block", *b) for b in blocks)]) + "\n"


def legs(vehicle):
    size = VEHICLES[vehicle][5]
    middle = (size / 2, size / 2, size / 6)
    for direction in LEGS:
        for part in (0.15, 0.45):
            half = [part * size * d * (1 if abs(d) < 1 or direction[0] else 0.33) for d in direction]
            half[2] = max(-0.3 * size / 2, min(0.3 * size / 2, half[2]))
            yield [m - h for m, h in zip(middle, half)], [m + h for m, h in zip(middle, half)], []


def forests(vehicle, rng):
    size = VEHICLES[vehicle][5]
    for _ in range(14):
        start = (1, rng.uniform(2, size - 2), rng.uniform(1, size / 3 - 1))
        goal = (size - 1, rng.uniform(2, size - 2), rng.uniform(1, size / 3 - 1))
        blocks = []
        while len(blocks) < size:
            x, y, r = rng.uniform(3, size - 3), rng.uniform(0, size), rng.uniform(0.2, 1.2)
            blocks.append((x - r, y - r, 0, x + r, y + r, size / 3))
        yield start, goal, blocks


def gates(vehicle, rng):
    size = VEHICLES[vehicle][5]
    top = size / 3
    for _ in range(8):
        blocks = []
        for k in range(1, 4):
            x, y, z = k * size / 4, rng.uniform(3, size - 3), rng.uniform(2, top - 2)
            blocks += [(x, 0, 0, x + 0.4, y - 1.5, top), (x, y + 1.5, 0, x + 0.4, size, top),
                       (x, y - 1.5, 0, x + 0.4, y + 1.5, z - 1.2), (x, y - 1.5, z + 1.2, x + 0.4, y + 1.5, top)]
        yield (1, size / 2, top / 2), (size - 1, size / 2, top / 2), blocks


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    rng = random.Random(1)
    for vehicle in VEHICLES:
        for kind, cases in (("leg", legs(vehicle)), ("forest", forests(vehicle, rng)), ("gates", gates(vehicle, rng))):
            for k, case in enumerate(cases):
                (folder / f"{vehicle}_{kind}{k}.txt").write_text(scenario(vehicle, *case))


if __name__ == "__main__":
    main()
