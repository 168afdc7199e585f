# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans round a wall and draws the plan in its corridor: first_plan.py [PICTURE]."""
import sys

import numpy as np
import tern


def plan_round_wall():
    grid = tern.Grid(origin=(0, 0, 0), cell=0.1, dims=(100, 80, 30), radius=0.3)
    grid.mark_box((4, 0, 0), (5, 6, 3))  # a wall with a gap at one end
    grid.inflate()
    planner = tern.Planner()
    limits = tern.Limits(v_max=(2, 2, 1), a_max=(4, 4, 2))
    result = planner.plan(grid, start=(1, 1, 1), goal=(9, 1, 1), limits=limits)
    if not result:
        raise SystemExit(f"no plan: {result.report.status}, {result.report.meaning}")
    return result.trajectory, planner.corridor()


def draw(trajectory, corridor, picture):
    from matplotlib import pyplot
    figure, (above, speed) = pyplot.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    x, y = np.meshgrid(np.linspace(0, 10, 101), np.linspace(0, 8, 81))
    for polyhedron in corridor:  # the slice of each at the plan's height, 1 m
        at = np.stack([x, y, np.ones_like(x)], axis=-1)
        inside = np.all(at @ polyhedron.normals.T <= polyhedron.offsets, axis=-1)
        above.contourf(x, y, inside, levels=[0.5, 1.5], colors=["tab:green"], alpha=0.2)
    t = np.linspace(0, trajectory.duration, 500)
    samples = trajectory.evaluate(t)
    above.add_patch(pyplot.Rectangle((4, 0), 1, 6, color="0.4"))
    above.plot(samples.position[:, 0], samples.position[:, 1], color="tab:blue")
    above.set(title="plan and corridor from above", xlabel="x, m", ylabel="y, m", aspect="equal", xlim=(0, 10), ylim=(0, 8))
    speed.plot(t, samples.velocity[:, :2], label=["along x", "along y"])
    speed.set(title="velocity", xlabel="t, s", ylabel="m/s")
    speed.legend()
    figure.savefig(picture)


if __name__ == "__main__":
    plan, polyhedra = plan_round_wall()
    at = plan.evaluate(3.0).position
    print(f"{plan.duration:.1f} s; after 3 s at {at[0]:.1f} {at[1]:.1f} {at[2]:.1f}; {len(polyhedra)} polyhedra")
    if len(sys.argv) > 1:
        draw(plan, polyhedra, sys.argv[1])
