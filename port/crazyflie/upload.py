#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""upload.py URI: plans on the ground station, writes the plan into a Crazyflie's trajectory memory, and flies it. It needs
cflib, and a Crazyflie that knows where it is (Lighthouse, Loco or motion capture)."""
import math
import sys
import time

import cflib.crtp
import tern
from cflib.crazyflie import Crazyflie
from cflib.crazyflie.log import LogConfig
from cflib.crazyflie.mem import MemoryElement, Poly4D
from cflib.crazyflie.syncCrazyflie import SyncCrazyflie
from cflib.crazyflie.syncLogger import SyncLogger
from cflib.utils.reset_estimator import reset_estimator

START, GOAL = (0.0, 0.0, 0.6), (1.6, 0.4, 1.0)
OBSTACLES = [((0.7, -0.4, 0.0), (0.9, 0.4, 1.5))]  # yours, metres in the positioning system's frame
PIECES = 31  # of 132 bytes, in the firmware's memory of 4096
TRAJECTORY = 1  # its number in the firmware
CONTROLLER = "2"  # Mellinger's: it uses the plan's accelerations
NEAR_START = 0.5  # metres, seen from above: the way to the plan's start is not proven, so it must be short
AT_START = 0.05  # metres from the plan's start where the plan may begin: make_plan's tracking margin


def make_plan():
    """The plan and its yaw: slow, because a Crazyflie flies in rooms."""
    grid = tern.Grid((-1.0, -1.5, 0.0), 0.05, (70, 60, 36), radius=0.1, boundary=((-1, -1.5, 0.3), (2.5, 1.5, 1.8)),
                     tracking_margin=0.05)
    for box in OBSTACLES:
        grid.mark_box(*box)
    grid.inflate()
    result = tern.Planner().plan(grid, START, GOAL, tern.Limits((0.8, 0.8, 0.5), (1, 1, 1)))
    if not result or len(result.trajectory) > PIECES:
        raise SystemExit(f"no plan: {result.report.meaning}")
    return result.trajectory, tern.plan_yaw(result.trajectory, rate_max=1.0)


def upload(cf, plan, yaw):
    """Writes the pieces and tells the firmware of them."""
    pieces, _ = tern.crazyflie_raw(plan, yaw)
    memory = cf.mem.get_mems(MemoryElement.TYPE_TRAJ)[0]
    memory.trajectory = [Poly4D(float(row[32]), *(Poly4D.Poly([float(c) for c in row[8 * k:8 * k + 8]])
                                                  for k in range(4))) for row in pieces]
    if not memory.write_data_sync():
        raise SystemExit("the upload failed")
    cf.high_level_commander.define_trajectory(TRAJECTORY, 0, len(pieces))


def position(cf):
    """The estimated position, metres."""
    log = LogConfig("position", period_in_ms=50)
    for axis in "xyz":
        log.add_variable(f"stateEstimate.{axis}", "float")
    with SyncLogger(cf, log) as logger:
        _, values, _ = next(iter(logger))
    return [values[f"stateEstimate.{axis}"] for axis in "xyz"]


def prepare(cf):
    """On the ground: chooses the controller, lets the estimator find its position, and arms."""
    cf.param.set_value("stabilizer.controller", CONTROLLER)
    reset_estimator(cf)
    off = math.dist(position(cf)[:2], START[:2])
    if not off <= NEAR_START:
        raise SystemExit(f"no take-off: {off:.2f} m from the plan's start, seen from above; at most {NEAR_START} m")
    cf.platform.send_arming_request(True)
    time.sleep(1.0)


def fly(cf, plan, yaw):
    """Takes off, goes to the plan's start, flies the plan and lands. Lands at once if it is not at the start."""
    commander = cf.high_level_commander
    commander.takeoff(START[2], 2.0)
    time.sleep(3.0)
    commander.go_to(*START, float(yaw.evaluate(0.0)[0]), 2.0)
    time.sleep(3.0)
    off = math.dist(position(cf), START)
    if off <= AT_START:
        # Not relative: a plan that is moved is no longer the plan that was proven.
        commander.start_trajectory(TRAJECTORY, 1.0, relative_position=False)
        time.sleep(plan.duration + 1.0)
    commander.land(0.0, 3.0)
    time.sleep(4.0)
    commander.stop()
    if not off <= AT_START:
        raise SystemExit(f"the plan was not flown: {off:.2f} m from its start, at most {AT_START} m")


def main():
    plan, yaw = make_plan()
    print(f"{plan.duration:.2f} s")
    cflib.crtp.init_drivers()
    with SyncCrazyflie(sys.argv[1], cf=Crazyflie(rw_cache="./cache")) as link:
        upload(link.cf, plan, yaw)
        prepare(link.cf)
        fly(link.cf, plan, yaw)


if __name__ == "__main__":
    main()
