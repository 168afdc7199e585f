# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""record_test.py TERN FILE: what Python planned and recorded, the command line plans again to the same bits."""
import pathlib
import subprocess
import sys

import tern

program, file = sys.argv[1], pathlib.Path(sys.argv[2])
limits = tern.Limits((2, 2, 1), (4, 4, 2))
grid = tern.Grid((0, 0, 0), 0.1, (100, 80, 30), 0.25, tracking_margin=0.05)
grid.mark_box((4, 0, 0), (5, 6, 3))
grid.inflate()
planner = tern.Planner()
try:
    planner.record()
    raise SystemExit("recorded without a plan")
except RuntimeError:
    pass


def replay():
    """Exit status and output of the replay of the planner's last query."""
    file.write_bytes(planner.record())
    done = subprocess.run([program, "replay", str(file)], capture_output=True, text=True)
    return done.returncode, done.stdout


first = planner.plan(grid, (1, 1, 1), (9, 1, 1), limits, vias=[tern.Via((2, 3, 1.2), tolerance=0.05)]).trajectory
status, text = replay()
assert status == 0 and f"ok, {len(first)} segments in {first.duration:.3f} s; every bit as recorded" in text, text
second = planner.replan(grid, first, 1.25, (9, 2, 1), limits, fences=[tern.Fence.box((-1, -1, -1), (11, 9, 2.5))])
status, text = replay()
assert second and status == 0 and "every bit as recorded" in text, text
planner.plan(grid, (1, 1, 1), (4.5, 1, 1), limits)  # in the wall
status, text = replay()
assert status == 0 and "goal_occupied; every bit as recorded" in text, text
data = bytearray(planner.record())
data[-20] ^= 1
file.write_bytes(data)
assert subprocess.run([program, "replay", str(file)], capture_output=True).returncode != 0
print("three queries replayed")
