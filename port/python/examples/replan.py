# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replans in flight when a door closes, and draws both plans: replan.py [PICTURE]."""
import sys

import numpy as np
import tern

LIMITS = tern.Limits(v_max=(2, 2, 1), a_max=(4, 4, 2))
GOAL = (9, 1, 1)
SWITCH = 1.0  # seconds after the first plan's beginning


def fly_past_door():
    grid = tern.Grid(origin=(0, 0, 0), cell=0.1, dims=(100, 80, 30), radius=0.3)
    grid.mark_box((4, 0, 0), (5, 3, 3))
    grid.mark_box((4, 4.5, 0), (5, 6.5, 3))  # a door at y = 3 .. 4.5, and a gap beyond 6.5
    grid.inflate()
    planner = tern.Planner()
    first = planner.plan(grid, (1, 1, 1), GOAL, LIMITS).trajectory

    grid.mark_box((4, 3, 0), (5, 4.5, 3))  # the door closes
    grid.inflate()
    clear = tern.clear_until(grid, first, SWITCH)
    second = planner.replan(grid, first, SWITCH, GOAL, LIMITS)
    if not second:
        raise SystemExit(f"brake: {second.report.meaning}; clear until {clear:.2f} s")
    return first, second.trajectory, clear


def draw(first, second, clear, picture):
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(6, 4.5), constrained_layout=True)
    for y, height in ((0, 3), (4.5, 2)):
        axes.add_patch(pyplot.Rectangle((4, y), 1, height, color="0.4"))
    axes.add_patch(pyplot.Rectangle((4, 3), 1, 1.5, color="tab:red", alpha=0.5))
    for plan, begin, style, label in ((first, 0, "--", "first plan"), (second, 0, "-", "new plan")):
        path = plan.evaluate(np.linspace(begin, plan.duration, 400)).position
        axes.plot(path[:, 0], path[:, 1], style, color="tab:blue", label=label)
    axes.plot(*first.evaluate(SWITCH).position[:2], "o", color="tab:blue", label="here the plans join")
    axes.plot(*first.evaluate(clear).position[:2], "x", color="tab:red", label="the first plan is clear until here")
    axes.set(xlabel="x, m", ylabel="y, m", aspect="equal", xlim=(0, 10), ylim=(0, 8))
    axes.legend(loc="lower center", fontsize=8)
    figure.savefig(picture)


if __name__ == "__main__":
    old, new, until = fly_past_door()
    join = np.abs(old.evaluate(SWITCH).acceleration - new.evaluate(0.0).acceleration).max()
    print(f"the first plan is clear until {until:.2f} s; the new one takes {new.duration:.2f} s and joins it "
          f"within {join:.0e} m/s^2")
    if len(sys.argv) > 1:
        draw(old, new, until, sys.argv[1])
