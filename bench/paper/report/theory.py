# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The claims of Sections 3.2.4 and 3.3; reads the front end's results as well."""
from markdown import number, picture, table

PART = "theory"


def chapter(results):
    bound = results.rows(PART, "theory.csv")
    shortcut = results.rows(PART, "shortcut.csv")
    ellipsoid = results.rows(PART, "ellipsoid.csv")
    slopes = {r["kind"]: number(r["size"], 2) for r in shortcut if r["kind"].startswith("slope")}
    lines = table(["points W", "steps of the chain", "ms"], [[r["size"], r["lines"], number(r["time_ms"], 3)]
                                                       for r in shortcut if r["kind"] == "W"])
    rows = [["the paper's" if r["method"] == "paper" else "Tern's", r["maps"], r["equal"], r["fewer"], r["more"], r["beyond_jps"],
             r["counterexample"]] for r in bound]
    front = results.rows("front_end", "front_end.csv")
    of = {(r["map"], r["method"]): r for r in front if not r["state"]}
    maps = sorted({r["map"] for r in front})
    search = [1000 * float(of[m, "Tern search"]["time_ms"]) for m in maps]
    extra = [1000 * float(of[m, "Tern"]["time_ms"]) - s for m, s in zip(maps, search)]
    most_points = max(int(float(of[m, "Tern search"]["waypoints"])) for m in maps)
    most = max(int(r["shrinks_max"]) for r in ellipsoid)
    return f"""## The theory, tested

### Waypoint bound: N_JB = K + 2 ≤ N_JPS

K counts the direction changes of the jump-point path, N_JB the points after shortening. 10 × 10 × 3 m, 10 % and 30 %:

{table(["shortening", "maps", "N = K + 2", "fewer", "more", "more than N_JPS", "first counterexample to equality"], rows)}
The *inequality* holds on every map. Shortening only drops points, and two points inside one straight line are never
both needed. The *equality* is wrong. It describes a shortening that removes collinear points only, but a line of
sight skips turning points too. K + 2 is an upper bound that is rarely met.

### Complexity of the shortcut

The paper: O(W · D) for W points and lines of D voxels. Measured exponents (log-log slopes): the paper's own shortening {slopes["slope of the paper's time over W"]} in W and
{slopes["slope of the paper's time over D"]} in D, as claimed. Tern's shortcut looks for the shortest chain, not just for one that works. The worst case is a
zigzag in which no point sees further than its neighbours: every pair within the window is tried.

{lines}
{picture('theory.svg', "The shortcut's cost")}
Steps grow with W to the power of {slopes['slope of lines over W']}, time with {slopes['slope of time over W']}. Up to W = 64 all pairs are tried, beyond that 64 for each point
([path](path.md)). One line costs D to the power of {slopes['slope of time over D']}, because it tests words
of 64 voxels at a time. On the six maps W is {most_points} at most, and the shortcut
takes {min(extra):.0f} to {max(extra):.0f} µs where the search takes {min(search):.0f} to {max(search):.0f}. So the paper's "computationally negligible" holds for both.

### Convergence of the ellipsoid

The paper claims convergence "within finite iterations". Each shrink puts the nearest point on the surface, which removes at least that point from the inside. So the number of
points inside at the start bounds the number of steps. Measured for the paper's construction, on surface voxels of 0.1
m:

{table(["density", "segments", "shrinks, mean", "p99", "max", "obstacle points", "planes, max"], [[r["density"], r["segments"], r["shrinks_mean"], r["shrinks_p99"], r["shrinks_max"], r["points_mean"], r["planes_max"]] for r in ellipsoid])}
At most {most} shrinks, even with tens of thousands of points around and at 45 % density. The cost is in looking at points, not in
the number of steps. The steps of Tern's own fit also have a constant bound ([corridor](corridor.md)).
"""
