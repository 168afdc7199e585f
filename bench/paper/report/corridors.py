# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table 6, Figures 15 to 17, and the limits of Section 4.5."""
from markdown import mean, milliseconds, number, percent, picture, table
from printed import TABLE_6

PART = "corridors"


def map_table(of):
    body = []
    for m in sorted(TABLE_6):
        plain, boxed, tern = (of[str(m), name] for name in ("paper without box", "paper with box", "Tern"))
        saved = 1 - int(boxed["checks"]) / int(plain["checks"])
        body.append([str(m), f"{1000 * TABLE_6[m]:.0f}", plain["segments"], plain["checks"], milliseconds(plain["time_ms"]),
                     boxed["checks"], milliseconds(boxed["time_ms"]), percent(saved), tern["segments"],
                     milliseconds(tern["time_ms"]), tern["planes"], tern["obstacles"]])
    return table(["map", "paper: ms", "segments", "checks without box", "ms", "checks with box", "ms", "saved",
                  "Tern: segments", "ms", "planes", "obstacle boxes of the busiest segment"], body)


def width_table(of):
    body = []
    for m in sorted(TABLE_6):
        tern = of[str(m), "Tern"]
        body.append([str(m), number(tern["passage_m"], 2), number(tern["used"], 2), number(tern["extreme"], 2),
                     "1.4–1.8" if m <= 4 else "2.1–2.6", f"{1000 * float(tern['over_m']):.1f}"])
    return table(["map", "narrowest passage m", "corridor / passage, same line", "widest corridor / narrowest passage",
                  "paper", "corridor beyond a passage, mm"], body)


def limits_table(rows, what):
    body = []
    for row in rows:
        if row["what"] != what:
            continue
        counts = f"{row['ok']} of {row['maps']}"
        spare = f"{1000 * float(row['spare_m']):.0f}" if row["spare_m"] else ""
        why = "" if row["ok"] == row["maps"] else f"`no_path` {row['no_path']}, other {row['other']}"
        body.append([row["setting"].replace(";", ","), counts, why, spare, milliseconds(row["median_ms"]), milliseconds(row["max_ms"])])
    return table(["", "planned", "not planned", "least clearance beyond the radius, mm", "whole plan, median ms", "max ms"], body)


def chapter(results):
    rows = results.rows(PART, "corridors.csv")
    limits = results.rows(PART, "limits.csv")
    of = {(r["map"], r["method"]): r for r in rows}
    saved = [1 - int(of[str(m), "paper with box"]["checks"]) / int(of[str(m), "paper without box"]["checks"]) for m in TABLE_6]
    faster = [float(of[str(m), "paper with box"]["time_ms"]) / float(of[str(m), "Tern"]["time_ms"]) for m in TABLE_6]
    pictures = "\n".join(picture(f"map{m}_corridor.svg", f"Figure {15 + (m - 1) // 2}: ellipsoids and corridor on Map {m}")
                         for m in TABLE_6)
    return f"""## Safe corridors: Table 6, Figures 15 to 17

We implemented the construction of the paper's Section 3.3.1 and ran it on the paper's own path. Its obstacles are the
centres of surface voxels of its own grid. It runs with and without a bounding box 2 m around each segment. Tern's
construction runs on Tern's path. A *check* is one look at one obstacle point. Tern has no such count, because it
first merges voxels into solid boxes.

Measured on: {results.machine(PART, 'corridors.csv')}.

{map_table(of)}
{pictures}
- The paper says that the box saves 53.2 % of the checks on average, "more than half". Here it saves {percent(min(saved))} to {percent(max(saved))}, {percent(mean(saved))} in the mean. It saves more on
larger maps, because only what is inside the box counts. On Map 1, which is 3 m wide, nearly everything is inside.
With the box, polyhedra lose the planes that came from points outside it.
- The paper's times grow with the map, although it says that it uses a box. Our times with the box do not depend on
  what is outside.
- Tern is {min(faster):.0f} to {max(faster):.0f} times as fast as the construction with points. It treats every voxel as a solid cube. Planes that touch voxel centres
leave half a voxel inside the polyhedron.

### Corridor width over passage width

Section 4.5 gives ratios of 1.4–1.8 on Maps 1–4 and 2.1–2.6 on Maps 5–6, without a definition. Along one line, the ratio of a safe corridor cannot exceed 1, because the corridor would then reach into an obstacle. So we give two ratios. The first is the width of the corridor over that of the passage, as the mean over lines across the path (nine places a segment, eight directions). The second
is, for each segment, the widest corridor over the narrowest passage; it can exceed 1.

{width_table(of)}
The first ratio shows how much of the room a polyhedron uses. The last column shows that no polyhedron reaches into space that is not free; this is measured by sampling, and independent of Tern's own check. The second ratio is about as large as the paper's
figures, but it follows the shapes of the passages rather than their density.

### What Section 4.5 calls limits

The paper: above 45 % density, or where passages narrower than 0.3 m dominate, "the ellipsoid inflation may fail to converge within practical
time limits"; overhanging or non-convex obstacles may give corridors that "restrict trajectory optimization".

Density (10 × 10 × 3 m, voxels of 0.1 m, radius 0.1 m, 50 seeds each):

{limits_table(limits, 'density')}
A slit through a wall half a metre thick, radius 0.1 m:

{limits_table(limits, 'passage')}
Non-convex obstacles (4 × 4 × 3 m, radius 0.2 m):

{limits_table(limits, 'overhang')}
- Density does not limit Tern's corridor. Every connected map gets a plan, and the slowest plan takes milliseconds.
  Each loop has a bound that is known before it runs ([corridor](corridor.md)), so it cannot fail to converge.
- Narrow passages depend on the voxel size. A voxel is free only if *every* point of it is, so a slit must be as wide
  as the robot and up to two voxels more. With a robot 0.2 m wide, a slit of 0.3 m is found with voxels of 0.05 m or
  less, a slit of 0.24 m with voxels of 0.02 m. For narrower slits, the answer is `no_path`, without delay.
- Overhangs and non-convex shapes need no special treatment: to the corridor they are many boxes.
"""
