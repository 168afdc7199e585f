# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The golden corpus of tests/golden/corpus.cpp once more, through the Python package."""
import math
import struct

import tern

MAPS, RANDOM, UNEVEN = 6, 240, 40
MASK = 2**64 - 1


class Random:
    """SplitMix64, as tests/support/random.hpp."""

    def __init__(self, seed):
        self.state = seed

    def next(self):
        self.state = (self.state + 0x9E3779B97F4A7C15) & MASK
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        return z ^ (z >> 31)

    def integer(self, low, high):
        return low + self.next() % (high - low + 1)

    def chance(self, p):
        return (self.next() >> 11) / 9007199254740992.0 < p


def map_scenario(path):
    """A scenario file with the records that the paper's maps have."""
    out = {"blocks": []}
    for line in path.read_text().splitlines():
        key, *numbers = line.split() if line[:1].isalpha() else [""]
        values = [float(n) for n in numbers]
        if key == "block":
            out["blocks"].append((values[:3], values[3:]))
        elif key:
            out[key] = values
    v, a = out["v_max"] * 3, out["a_max"] * 3
    return {"boundary": (out["boundary"][:3], out["boundary"][3:]), "cell": out["resolution"][0],
            "radius": out["radius"][0], "blocks": out["blocks"], "start": tern.State(out["start"]),
            "goal": out["goal"], "limits": {"v_max": v, "a_max": a}}


def random_block(random, nx, ny, nz):
    x, y = random.integer(0, nx - 4), random.integer(0, ny - 4)
    height = nz if random.chance(0.6) else random.integer(5, nz)
    z = 0 if random.chance(0.5) else nz - height
    wx, wy = random.integer(3, 14), random.integer(3, 14)
    return ([x / 10, y / 10, z / 10], [min(x + wx, nx) / 10, min(y + wy, ny) / 10, (z + height) / 10])


def distance_squared(point, block):
    return sum(max(low - p, 0.0, p - high)**2 for p, low, high in zip(point, *block))


def random_free_point(random, size, scenario):
    def draw():
        return [random.integer(0, 100 * n) / 1000 for n in size]
    point, room = draw(), scenario["radius"] + scenario["cell"]
    for _ in range(5):
        if all(distance_squared(point, block) >= room * room for block in scenario["blocks"]):
            break
        point = draw()
    return point


def random_scenario(index, uneven):
    random = Random(0x7465726E + index)
    size = random.integer(50, 100), random.integer(50, 100), random.integer(15, 30)
    out = {"boundary": ([0.0] * 3, [n / 10 for n in size]), "cell": 0.1 if random.chance(0.5) else 0.2,
           "radius": random.integer(0, 30) / 100}
    out["blocks"] = [None] * random.integer(0, 32)
    for b in range(len(out["blocks"])):
        out["blocks"][b] = random_block(random, *size)
    v, a = random.integer(5, 40) / 10, random.integer(5, 40) / 10
    out["limits"] = {"v_max": [v, v, 0.5 * v], "a_max": [a, a, 0.5 * a]}
    start, out["goal"] = random_free_point(random, size, out), random_free_point(random, size, out)
    velocity = [0.5 * v / 1024 * random.integer(-512, 512) for _ in range(3)] if index % 4 == 3 else [0.0] * 3
    out["start"] = tern.State(start, velocity)
    if uneven:
        out["limits"]["v_min"] = [0.0, 0.0, -0.5 * out["limits"]["v_max"][2]]
        out["limits"]["a_min"] = [0.0, 0.0, -0.75 * out["limits"]["a_max"][2]]
    return out


def scenarios(root):
    for number in range(1, MAPS + 1):
        yield map_scenario(root / f"bench/maps/map{number}.txt")
    for index in range(MAPS, MAPS + RANDOM + UNEVEN):
        out = random_scenario(index - MAPS, index >= MAPS + RANDOM)
        if index >= MAPS + RANDOM and index % 2 == 0:
            out["limits"]["v_horizontal"] = out["limits"]["v_max"][0]
        if index >= MAPS + RANDOM and index % 3 == 0:
            out["limits"]["a_horizontal"] = out["limits"]["a_max"][0]
        yield out


def plan(planner, scenario):
    """The status's number and the trajectory."""
    lower, upper = scenario["boundary"]
    dims = [math.ceil((u - l) / scenario["cell"] - 1e-9) for l, u in zip(lower, upper)]
    grid = tern.Grid(lower, scenario["cell"], dims, scenario["radius"], (lower, upper))
    for block in scenario["blocks"]:
        grid.mark_box(*block)
    grid.inflate()
    result = planner.plan(grid, scenario["start"], scenario["goal"], tern.Limits(**scenario["limits"]))
    return result.report.struct.status, result.trajectory


def add(value, words):
    """FNV-1a over 64-bit words."""
    for word in words:
        value = ((value ^ word) * 0x100000001B3) & MASK
    return value


def bits(*numbers):
    return struct.unpack(f"<{len(numbers)}Q", struct.pack(f"<{len(numbers)}d", *numbers))


def hash_plan(value, status, trajectory):
    value = add(value, [status])
    if trajectory is None:
        return value
    value = add(value, [len(trajectory), *bits(*trajectory.origin)])
    for segment in trajectory.segments:
        value = add(value, [*bits(segment["duration"]), int(segment["polyhedron"])])
        value = add(value, bits(*segment["points"].ravel()))
    return value


def corpus_hash(root):
    value, planner = 0xCBF29CE484222325, tern.Planner()
    for scenario in scenarios(root):
        value = hash_plan(value, *plan(planner, scenario))
    return value
