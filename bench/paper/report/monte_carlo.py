# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table 5."""
from markdown import mean, milliseconds, number, percent, picture, table
from printed import TABLE_5

PART = "monte_carlo"

NAMES = {"paper A*": "A*, 6 neighbours", "paper JPS": "JPS, the paper's kind",
         "paper JPS-Bresenham": "JPS–Bresenham, the paper's kind", "A*": "A*, plain", "JPS": "JPS, plain",
         "Tern": "**Tern**"}
PRINTED = {"paper A*": "A*", "paper JPS": "JPS", "paper JPS-Bresenham": "JPS-Bresenham"}


def big_table(rows):
    body = []
    for row in rows:
        printed = ["", "", ""]
        if row["method"] in PRINTED:
            length, waypoints, seconds = TABLE_5[row["config"]][PRINTED[row["method"]]]
            printed = [f"{length:.2f}", f"{waypoints:.1f}", f"{1000 * seconds:.0f}"]
        body.append([row["config"], NAMES[row["method"]], number(row["length_m"], 2), number(row["waypoints"], 1),
                     milliseconds(row["time_ms"]), milliseconds(row["time_max_ms"]), number(row["expanded"], 0),
                     row["unsafe"]] + printed)
    return table(["config", "method", "length m", "waypoints", "ms, mean", "ms, max", "expanded", "too close",
                  "paper: m", "waypoints", "ms"], body)


def reduction(value, method, base, configs):
    """Mean over the configurations of 1 - method / base."""
    return mean(1 - value(c, method) / value(c, base) for c in configs)


def reduction_rows(rows):
    configs = list(TABLE_5)
    by = {(r["config"], r["method"]): r for r in rows}

    def mine(key):
        return lambda config, method: float(by[config, method][key])

    def theirs(index):
        return lambda config, method: TABLE_5[config][PRINTED[method]][index]

    def row(name, said, key, index, base):
        cells = [name, said, percent(reduction(theirs(index), "paper JPS-Bresenham", base, configs)),
                 percent(reduction(mine(key), "paper JPS-Bresenham", base, configs)),
                 percent(reduction(mine(key), "Tern", base, configs))]
        return cells

    return [row("length against JPS", "5.6 %", "length_m", 0, "paper JPS"),
            row("length against A*", "18.3 %", "length_m", 0, "paper A*"),
            row("waypoints against JPS", "67.3 %", "waypoints", 1, "paper JPS"),
            row("waypoints against A*", "92.1 %", "waypoints", 1, "paper A*")]


def counts(rows):
    first = {r["config"]: r for r in rows}.values()
    return table(["config", "solved", "not connected", "connected, but not found by the paper's JPS",
                  "only across a corner", "Tern's search longer than A*'s"],
                 [[r["config"], r["solved"], r["unsolved"], r["lost"], r["cut"], r["longer"]] for r in first])


def chapter(results):
    rows = results.rows(PART, "monte_carlo.csv")
    by = {(r["config"], r["method"]): r for r in rows}
    excess = [float(by[c, "paper JPS"]["length_m"]) / float(by[c, "JPS"]["length_m"]) - 1 for c in TABLE_5]
    shorter = [1 - float(by[c, "Tern"]["length_m"]) / float(by[c, "paper JPS-Bresenham"]["length_m"]) for c in TABLE_5]
    speed = [float(by[c, "A*"]["time_ms"]) / float(by[c, "Tern"]["time_ms"]) for c in TABLE_5]
    unsafe = sum(int(by[c, "paper JPS-Bresenham"]["unsafe"]) for c in TABLE_5)
    solved = sum(int(by[c, "Tern"]["solved"]) for c in TABLE_5)
    return f"""## Random maps: Table 5

Three sizes × two densities × 50 seeds. The paper does not print its maps. We fill ours with cuboids of 0.6 to 2.4 m until the union of these takes up 10 % or 30 % of the
volume. (This is before inflation; the paper does not say.) Start and goal are further apart than 30 % of the width.
All methods use voxels of 0.2 m and keep 0.1 m from the cuboids. All cuboids lie on the lattice, so the paper's grid and Tern's are
the same set of voxels. As in the paper, the means are over the maps that all methods solved. *Too close* counts paths
that come nearer to a block than 0.1 m.

The paper's A* seems to have 6 neighbours: its waypoints are 0.19 to 0.20 m apart on average. That is one voxel;
diagonal moves are longer. *A\\*, plain* has 26.

Measured on: {results.machine(PART, 'monte_carlo.csv')}.

{big_table(rows)}
{picture('monte_carlo.svg', 'Table 5 as bars')}
{counts(rows)}
The paper claims reductions. The table compares those in its text, those that follow from its Table 5 (means over the
six configurations), and those measured here:

{table(["JPS–Bresenham", "paper's text", "paper's table", "measured, the paper's kind", "measured, Tern"], reduction_rows(rows))}
### What agrees, and what does not

- Shortening reduces length and waypoints of the greedy JPS about as much as the paper says. The paper's own table does not support the 18.3 % against A*.
- For all three methods, lengths and waypoints are close to the printed ones, although the maps differ. The paper's A*
  is *longer* than its JPS, which is impossible for an optimal A* over the same moves. Six neighbours for A* and 26
  for the greedy JPS explain it.
- The paper's JPS is not optimal: it is {percent(min(excess))} to {percent(max(excess))} longer than plain JPS on the same voxels. Tern's paths are
  {percent(min(shorter))} to {percent(max(shorter))} shorter than JPS–Bresenham's.
- The greedy search closes nodes when it generates them, so it can miss the goal. The second table counts the maps on
  which it finds nothing although there is a path. Tern finds one on each of them. Its search was as short as A*'s on
  every map (last column).
- {unsafe} of {solved} JPS–Bresenham paths come nearer to a block than the 0.1 m that the grid was made for. On cuboids that lie on the lattice, its sampled line of sight has a whole voxel to spare. On the maps of Table 4, where faces can lie anywhere, it has no such reserve.
- The cost of A* does not explode. A plain A* needs milliseconds where the paper prints 114 s (Large-Low). Tern is {min(speed):.1f} to
  {max(speed):.1f} times as fast as the plain A* in the mean, and its lead grows for the longest query.
"""
