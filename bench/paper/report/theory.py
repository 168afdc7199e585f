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
The *inequality* holds on every map: shortening only drops points, and two points inside one straight leg are never both needed. The *equality* is wrong: it describes a
shortening that removes collinear points alone, and a line of sight skips turning points as well. K + 2 is an upper bound, rarely met.

### Complexity of the shortcut

The paper: O(W · D) for W points and lines of D voxels. Measured exponents (log-log slopes): the paper's own shortening {slopes["slope of the paper's time over W"]} in W and
{slopes["slope of the paper's time over D"]} in D: as claimed. Tern's shortcut looks for the shortest chain, not for the first that will do. On a zigzag in which no point sees further than its
neighbours, so that every pair within the window is tried:

{lines}
{picture('theory.svg', "The shortcut's cost")}
Steps grow with W to the power of {slopes['slope of lines over W']}, time with {slopes['slope of time over W']}: all pairs up to W = 64, and
64 a point beyond ([path](path.md)). One line costs D to the power of {slopes['slope of time over D']}: it tests words of 64 voxels, not voxels. On the six maps W is {most_points} at most, and the shortcut
takes {min(extra):.0f} to {max(extra):.0f} µs where the search takes {min(search):.0f} to {max(search):.0f}. So the paper's "computationally negligible" holds for both.

### Convergence of the ellipsoid

The paper claims convergence "within finite iterations". Each shrink puts the nearest point on the surface and so removes at least that one from the
inside: the points inside at the start bound the steps. Measured, the paper's construction on surface voxels of 0.1 m:

{table(["density", "segments", "shrinks, mean", "p99", "max", "obstacle points", "planes, max"], [[r["density"], r["segments"], r["shrinks_mean"], r["shrinks_p99"], r["shrinks_max"], r["points_mean"], r["planes_max"]] for r in ellipsoid])}
At most {most} shrinks, with tens of thousands of points about and at 45 % density as well: it is the looks at points that cost, not the number of steps. Tern's own fit has a
constant bound on its steps besides ([corridor](corridor.md)).
"""
