# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the paper prints in its Section 4: the tables as they stand there, and what its text says of them."""

# Table 4: (path length in m, waypoints, seconds) by map.
TABLE_4 = {
    1: {"JPS": (3.7276, 13, 0.13), "RRT*": (5.5098, 6, 4.82), "PRM": (5.2365, 7, 3.37),
        "JPS-Bresenham": (3.4859, 8, 0.15)},
    2: {"JPS": (14.6572, 26, 0.21), "RRT*": (14.9452, 9, 5.24), "PRM": (16.9338, 6, 4.56),
        "JPS-Bresenham": (14.2825, 8, 0.24)},
    3: {"JPS": (23.0685, 25, 0.64), "RRT*": (23.3988, 8, 4.89), "PRM": (27.2583, 6, 5.02),
        "JPS-Bresenham": (22.6777, 6, 0.28)},
    4: {"JPS": (27.1576, 47, 0.82), "RRT*": (28.2183, 13, 7.20), "PRM": (32.1264, 14, 5.59),
        "JPS-Bresenham": (25.8701, 13, 0.91)},
    5: {"JPS": (24.4271, 32, 0.61), "RRT*": (24.8791, 9, 4.21), "PRM": (25.8316, 9, 4.55),
        "JPS-Bresenham": (23.3693, 14, 0.68)},
    6: {"JPS": (19.0359, 39, 0.37), "RRT*": (18.8136, 9, 5.68), "PRM": (19.1350, 9, 4.86),
        "JPS-Bresenham": (18.4513, 18, 0.45)},
}

# Table 5: (path length in m, waypoints, seconds), means of 50 trials.
TABLE_5 = {
    "Small-Low": {"A*": (9.05, 49.3, 0.270), "JPS": (7.82, 10.4, 0.046), "JPS-Bresenham": (7.39, 3.4, 0.046)},
    "Small-High": {"A*": (7.60, 42.0, 0.150), "JPS": (7.27, 15.9, 0.037), "JPS-Bresenham": (6.94, 7.1, 0.036)},
    "Medium-Low": {"A*": (18.27, 95.4, 6.001), "JPS": (17.39, 21.4, 0.303), "JPS-Bresenham": (16.64, 8.1, 0.303)},
    "Medium-High": {"A*": (14.76, 77.8, 2.222), "JPS": (13.37, 23.9, 0.067), "JPS-Bresenham": (12.58, 8.6, 0.066)},
    "Large-Low": {"A*": (35.21, 180.1, 113.939), "JPS": (34.35, 42.8, 2.117), "JPS-Bresenham": (31.96, 10.7, 2.113)},
    "Large-High": {"A*": (31.39, 161.0, 73.639), "JPS": (32.22, 53.0, 0.383), "JPS-Bresenham": (30.87, 16.9, 0.380)},
}

# Table 6: seconds by map.
TABLE_6 = {1: 0.041, 2: 0.056, 3: 0.099, 4: 0.124, 5: 0.154, 6: 0.183}

# Table 7: (snap integral of polynomial and Bezier, seconds of polynomial and Bezier) by map.
TABLE_7 = {1: (1576, 842, 0.055, 0.032), 2: (796, 582, 0.073, 0.048), 3: (2546, 1470, 0.086, 0.063),
           4: (3131, 1856, 0.105, 0.087), 5: (4537, 2105, 0.158, 0.103), 6: (5687, 2574, 0.256, 0.141)}

# Table 8: cost and seconds (max, average, min) and success rate.
TABLE_8 = {
    "Proposed": {"cost": (1024, 973, 958), "time": (0.44, 0.37, 0.34), "success": 0.99},
    "Fast-Planner": {"cost": (1537, 1323, 1248), "time": (0.46, 0.41, 0.35), "success": 0.95},
    "EGO-Planner": {"cost": (1489, 1275, 1094), "time": (0.43, 0.37, 0.32), "success": 0.96},
}
