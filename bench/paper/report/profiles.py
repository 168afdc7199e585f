# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 8, and each plan against its limits."""
from markdown import number, picture, table

PART = "profiles"


def chapter(results):
    rows = results.rows(PART, "profiles.csv")
    trapezoid, plans = rows[0], rows[1:]
    body = [[r["profile"].replace("map", "Map "), number(r["duration_s"], 2), number(r["v_peak"], 4), number(r["a_peak"], 4),
             number(r["jerk_peak"], 1)] for r in plans]
    pictures = "\n".join(picture(f"{r['profile']}_profiles.svg", f"{r['profile'].replace('map', 'Map ')}: profiles and hodographs")
                         for r in plans)
    return f"""## Profiles: Figure 8, and each plan against its limits

With the numbers of Figure 8 (30 m, 10 m/s, 1 s to reach that speed), Tern's time allocation gives {number(trapezoid['duration_s'], 3)} s and
{number(trapezoid['distance_m'], 3)} m, as in the paper: T = x/v + v/a = 3 + 1.

{picture('trapezoid.svg', 'Figure 8: trapezoidal profile')}
The figures show position, velocity, acceleration and jerk of each plan over time, and the hodographs in the plane of their two busiest axes. The limits hold for each axis. Jerk has no limit, but it is continuous. The table has the sampled peaks of the axes:

{table(["map", "duration s", "peak v, m/s (limit 2)", "peak a, m/s² (limit 2)", "peak jerk, m/s³"], body)}
{pictures}
"""
