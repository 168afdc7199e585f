# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table 4 and Figures 9 to 14."""
from markdown import mean, milliseconds, number, percent, picture, table
from printed import TABLE_4

PART = "front_end"

NAMES = {
    "A*": "A*, plain", "JPS": "JPS, plain", "paper JPS": "JPS, the paper's kind",
    "paper JPS-Bresenham": "JPS–Bresenham, the paper's kind", "Tern search": "Tern, search alone", "Tern": "**Tern**",
}


def label(row):
    if row["method"] in NAMES:
        return NAMES[row["method"]]
    return f"{row['method']}, " + ("first solution" if row["state"] == "first" else f"after {float(row['state'][:-2]):g} s")


def spread(row, key, decimals):
    sd = float(row[key.split("_")[0] + "_sd"])
    text = number(row[key], decimals)
    return f"{text} ± {sd:.{decimals}f}" if sd > 0 else text


def printed_cell(row):
    name = {"paper JPS": "JPS", "paper JPS-Bresenham": "JPS-Bresenham"}.get(row["method"])
    if row["state"] == "first":
        name = row["method"]
    if name is None:
        return ["", "", ""]
    length, waypoints, seconds = TABLE_4[int(row["map"])][name]
    return [f"{length:.4f}", str(waypoints), f"{1000 * seconds:.0f}"]


def map_table(rows):
    body = []
    for row in rows:
        found = f"{row['found']} of {row['runs']}" if row["runs"] != "1" else ""
        expanded = row["expanded"] if row["expanded"] != "0" else ""
        body.append([label(row), spread(row, "length_m", 4 if row["runs"] == "1" else 2),
                     number(row["waypoints"], 0 if row["runs"] == "1" else 1),
                     "" if row["state"].endswith(" s") else milliseconds(row["time_ms"]), expanded,
                     number(row["clearance_m"], 3), found] + printed_cell(row))
    return table(["method", "length m", "waypoints", "ms", "expanded", "clearance m", "found", "paper: m", "waypoints",
                  "ms"], body)


def agreement(rows):
    """How far the paper's kind of front end is from what the paper prints, by map."""
    body = []
    for number_of_map in sorted(TABLE_4):
        cells = [str(number_of_map)]
        for method, name in (("paper JPS", "JPS"), ("paper JPS-Bresenham", "JPS-Bresenham")):
            row = next(r for r in rows if r["map"] == str(number_of_map) and r["method"] == method)
            length, waypoints, _ = TABLE_4[number_of_map][name]
            mine = (f"{float(row['length_m']):.4f}", f"{float(row['waypoints']):.0f}")
            same = mine == (f"{length:.4f}", str(waypoints))
            gap = float(row["length_m"]) / length - 1
            cells.append("equal to the digit" if same else f"{gap:+.2%}, {mine[1]} waypoints for {waypoints}".replace("%", " %"))
        body.append(cells)
    return table(["map", "JPS", "JPS–Bresenham"], body)


def reductions():
    by_map = [TABLE_4[m] for m in sorted(TABLE_4)]
    length = [1 - t["JPS-Bresenham"][0] / t["JPS"][0] for t in by_map]
    points = [1 - t["JPS-Bresenham"][1] / t["JPS"][1] for t in by_map]
    return length, points


def comparison(rows):
    ratios = {"search": [], "length": [], "points": []}
    for m in sorted(TABLE_4):
        of = {r["method"]: r for r in rows if r["map"] == str(m) and not r["state"]}
        ratios["length"].append(1 - float(of["Tern"]["length_m"]) / float(of["paper JPS-Bresenham"]["length_m"]))
        ratios["points"].append(float(of["paper JPS-Bresenham"]["waypoints"]) - float(of["Tern"]["waypoints"]))
        ratios["search"].append(float(of["A*"]["time_ms"]) / float(of["Tern"]["time_ms"]))
    return ratios


def sampling_notes(rows):
    """What RRT* and PRM came to; nothing where the program was built without them."""
    tern = {r["map"]: float(r["length_m"]) for r in rows if r["method"] == "Tern"}
    lines = []
    for method in ("RRT*", "PRM"):
        mine = [r for r in rows if r["method"] == method]
        if not mine:
            return "- RRT\\* and PRM were left out of this run.\n"
        first = [float(r["time_ms"]) for r in mine if r["state"] == "first"]
        last = [r for r in mine if r["state"] == mine[-1]["state"]]
        shorter = [r["map"] for r in last if float(r["length_m"]) < tern[r["map"]]]
        all_found = all(r["found"] == r["runs"] for r in last)
        where = "Maps " + ", ".join(shorter) if len(shorter) > 1 else "Map " + shorter[0] if shorter else "no map"
        lines.append(f"- {method.replace('*', chr(92) + '*')} finds its first path after {min(first):.1f} to {max(first):.0f} ms in the mean, not after seconds; "
                     f"after {float(mine[-1]['state'][:-2]):g} s its path is shorter than Tern's on {where}"
                     + ("" if all_found else ", and some seeds have none") + ".\n")
    lines.append("- The paper's 3 to 7 s for both come from its implementation, not from the methods. The path of a sampling planner is not "
                 "bound to the lattice and keeps no margin from the voxels, so it can be shorter than an optimal grid path.\n")
    return "".join(lines)


def chapter(results):
    rows = results.rows(PART, "front_end.csv")
    text = """## Front end: Table 4 and Figures 9 to 14

*The paper's kind* is our version of the paper's front end. It runs on the paper's grid: voxels of 0.2 m, every cuboid
grown by 0.1 m on all sides. Its JPS is greedy: it takes the node with the least Manhattan distance to the goal plus
length of the last jump, and it closes nodes when it generates them. Its line of sight is sampled.

A*, plain JPS and Tern search the grid of the scenarios. It has voxels of 0.1 m; a voxel is free if each of its points
keeps 0.1 m from every block. RRT* and PRM (OMPL, default settings, 20 seeds) plan among the free voxels of that grid.

Lengths are measured from the exact start to the exact goal. *Clearance* is the least distance of the path from a block.
Times are processor time for the search alone, the least of seven runs. For RRT* and PRM they are wall-clock times:
mean and standard deviation over the seeds that found a path.

"""
    text += f"Measured on: {results.machine(PART, 'front_end.csv')}.\n\n"
    for m in sorted(TABLE_4):
        text += f"### Map {m}\n\n" + map_table([r for r in rows if r["map"] == str(m)]) + "\n"
        text += picture(f"map{m}_paths.svg", f"Figure {m + 8}: paths on Map {m}") + "\n"
    text += "### What agrees, and what does not\n\nThe paper's kind of front end against the paper's Table 4:\n\n"
    text += agreement(rows)
    length, points = reductions()
    ratios = comparison(rows)
    text += f"""
- On Maps 1 and 2, the length of JPS–Bresenham agrees with the printed one to the last digit; on Map 1, so does that of JPS. This tells us which search is behind the table: an optimal search cannot give these lengths. On Map 2, our JPS length is the
  figure that the paper prints for *RRT\\**
  (14.9452): two cells of the table seem to be swapped, so that 14.6572 would be the length of RRT\\*.
- The paper gives no start and goal for Maps 3 to 6. Ours are fitted to its lengths
  ([bench/maps](../bench/maps/README.md)). On these maps, the figures can only be compared roughly.
- The paper's text says that JPS–Bresenham is 4–10 % shorter than JPS; its own table says {percent(min(length))} to {percent(max(length))}, {percent(mean(length))} in
  the mean. The text says that it has 52 % fewer waypoints than JPS; the table says {percent(mean(points), 0)}.
- The paper says that JPS–Bresenham is shortest of all. A plain A* on a finer grid is shorter, because the greedy
  search is not optimal. Tern's paths are {percent(min(ratios['length']))} to {percent(max(ratios['length']))} shorter
  than those of the paper's kind, on voxels half as wide. They have {mean(ratios['points']):.1f} waypoints fewer in
  the mean, and they keep the radius everywhere.
- Times: the paper's were measured in MATLAB. The greedy search is fast because its voxels are twice as wide, and
  because it never improves a path. On the same grid Tern's search is {min(ratios['search']):.1f} to {max(ratios['search']):.0f} times as fast as the plain A*.
- Plain JPS is no faster than plain A* on most maps: its unlimited jumps scan all of the free space. Tern's search is fast for two more reasons: it scans 64 voxels at a time, and it bounds the sweeps
([search](search.md)).
{sampling_notes(rows)}"""
    return text
