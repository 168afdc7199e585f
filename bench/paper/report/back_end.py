# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table 7 and Figures 18 to 23."""
from markdown import mean, milliseconds, number, percent, picture, table
from printed import TABLE_7

PART = "back_end"

NAMES = {"polynomial": "polynomial", "polynomial mended": "polynomial, collisions mended", "Bezier": "Bézier, same times",
         "Tern": "**Tern**, refined times"}
RADIUS = 0.1
LIMIT = 2.0


def snap(text):
    value = float(text)
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}"


def marked(text, bad, decimals):
    return f"**{float(text):.{decimals}f}** ✗" if bad else f"{float(text):.{decimals}f}"


def map_rows(rows, m):
    body = []
    for row in (r for r in rows if r["map"] == str(m)):
        snap_poly, snap_bezier, time_poly, time_bezier = TABLE_7[m]
        printed = {"polynomial": [str(snap_poly), f"{1000 * time_poly:.0f}"],
                   "Bezier": [str(snap_bezier), f"{1000 * time_bezier:.0f}"]}.get(row["method"], ["", ""])
        body.append([str(m), NAMES[row["method"]], row["segments"], snap(row["snap"]), number(row["duration_s"], 2),
                     marked(row["v_peak"], float(row["v_peak"]) > 1.001 * LIMIT, 2),
                     marked(row["a_peak"], float(row["a_peak"]) > 1.001 * LIMIT, 2),
                     marked(row["clearance_m"], float(row["clearance_m"]) < RADIUS - 1e-4, 3), row["solves"],
                     milliseconds(row["time_ms"]), number(row["slow_duration_s"], 2), snap(row["slow_snap"])] + printed)
    return body


def reductions(of):
    return {m: 1 - float(of[m, "Bezier"]["snap"]) / float(of[m, "polynomial"]["snap"]) for m in TABLE_7}


def listed(values):
    return ", ".join(percent(values[m], 0) for m in sorted(values))


def ratios(values):
    return ", ".join(f"{values[m]:.3g}" for m in sorted(values))


def chapter(results):
    rows = results.rows(PART, "back_end.csv")
    of = {(int(r["map"]), r["method"]): r for r in rows}
    body = [row for m in sorted(TABLE_7) for row in map_rows(rows, m)]
    measured = reductions(of)
    printed = {m: 1 - t[1] / t[0] for m, t in TABLE_7.items()}
    faster = {m: 1 - t[3] / t[2] for m, t in TABLE_7.items()}
    mended = {m: 1 - float(of[m, "Bezier"]["snap"]) / float(of[m, "polynomial mended"]["snap"]) for m in TABLE_7}
    colliding = [str(m) for m in TABLE_7 if float(of[m, "polynomial"]["clearance_m"]) < RADIUS - 1e-4]
    breaking = [str(m) for m in TABLE_7 if max(float(of[m, "polynomial"]["v_peak"]), float(of[m, "polynomial"]["a_peak"])) > 1.001 * LIMIT]
    turned = [str(m) for m in TABLE_7 if measured[m] < 0 and str(m) in colliding]
    exception = (f" Where the corridor constrains the curve most (Map {', '.join(turned)}), the sign is reversed: there, the polynomial has less snap because\n  it flies through walls."
                 if turned else "")
    time_ratio = mean(float(of[m, "Bezier"]["time_ms"]) / float(of[m, "polynomial"]["time_ms"]) for m in TABLE_7)
    mended_ratio = [float(of[m, "polynomial mended"]["time_ms"]) / float(of[m, "Bezier"]["time_ms"]) for m in TABLE_7]
    quicker = {m: 1 - float(of[m, "Tern"]["duration_s"]) / float(of[m, "polynomial mended"]["slow_duration_s"]) for m in TABLE_7}
    price = {m: float(of[m, "Tern"]["snap"]) / float(of[m, "polynomial mended"]["slow_snap"]) for m in TABLE_7}
    both = [str(m) for m in sorted(TABLE_7) if quicker[m] > 0 and price[m] < 1]
    pictures = "\n".join(picture(f"map{m}_trajectories.svg", f"Figure {m + 17}: polynomial and Bézier on Map {m}")
                         for m in TABLE_7)
    return f"""## Back end: Table 7 and Figures 18 to 23

- **Polynomial**: degree 7, through every waypoint of Tern's corridor, continuous to jerk, with the least snap. It has
  a closed form: one linear system.
- **Polynomial, collisions mended**: made safe as the paper describes. Solve, and look for collisions along the curve.
  Split each segment that has one in its middle, with a waypoint there and half of the time on each side. Solve again.
- **Bézier, same times**: what the paper optimises. It has one segment per polyhedron, the same durations (the trapezoid rule of Section 3.3.2), and its control points are inside the corridor. It need not pass through the waypoints, and it has no limits on velocity and acceleration.
- **Tern**: the plan that Tern returns, with refined durations and limits that hold for all t.

All flights go from rest to rest, with 2 m/s and 2 m/s² per axis and a radius of 0.1 m. ✗ marks a value that breaks a limit or the radius. *Slowed* is the same
path flown so slowly (or fast) that its peaks are exactly at the limits. Snap is the integral of |snap|² in m²/s⁷.

Measured on: {results.machine(PART, 'back_end.csv')}.

{table(["map", "method", "segments", "snap", "duration s", "peak v", "peak a", "clearance m", "solves", "ms", "slowed: s", "snap", "paper: snap", "ms"], body)}
{pictures}
### What agrees, and what does not

- **Snap.** With the same times the Bézier curve has {listed(measured)} less snap than the polynomial (Maps 1 to 6; negative: more), against {listed(printed)} in the
  paper's table. The reason is freedom: the polynomial must pass through each waypoint, the Bézier curve only near it. The basis plays
  no part: a polynomial of degree 7 *is* a Bézier curve.{exception} Against the mended polynomial the saving is {listed(mended)}.
- The paper's text says 40–55 % less snap on all maps; its table says {percent(min(printed.values()), 0)} on Map 2. It says 30–45 % less time; its table says
  {percent(min(faster.values()), 0)} to {percent(max(faster.values()), 0)}.
- **Absolute snap** cannot be compared: it changes with the seventh power of time, and the paper states neither its durations nor its limits.
- **Safety.** The polynomial comes too near to a block on Maps {", ".join(colliding)} and breaks a limit on Maps {", ".join(breaking)}. Wherever there is a ✗ for a limit, the times of the trapezoid rule are too short for the curve, also for the Bézier. Constraints on control
  points keep it in the corridor. To keep the limits, the durations must change, and the paper does not say how.
  Tern's refinement does that, and its plans have no ✗.
- **Times.** One linear system is cheaper than a quadratic programme: the Bézier takes {time_ratio:.1f} times as long as the bare polynomial in the mean. The polynomial is slow because it must then be tested for collisions. With one test every 10 ms of flight, it takes {min(mended_ratio):.0f} to {max(mended_ratio):.0f} times as long as the one programme, which needs no such tests. The paper's ratio is in between.
- **Tern's plans** trade duration against snap by one weight ([trajectory](trajectory.md)). Judge them by both columns. Compared with the mended polynomial slowed to the limits, they take {listed(quicker)} less time on Maps 1 to 6 (negative: more), with {ratios(price)} times its snap{": less of both on Maps " + ", ".join(both) if both else ""}.
"""
