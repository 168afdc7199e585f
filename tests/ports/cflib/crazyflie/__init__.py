# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
from cflib import calls, estimate, strays
from cflib.crazyflie.mem import Memory


class Commander:
    """Records every command with its arguments by name, as cflib names them."""

    def takeoff(self, absolute_height_m, duration_s):
        calls.append(("takeoff", absolute_height_m, duration_s))

    def go_to(self, x, y, z, yaw, duration_s, relative=False):
        calls.append(("go_to", (x, y, z), yaw, duration_s, relative))
        estimate.update({"stateEstimate.x": x + strays[0], "stateEstimate.y": y, "stateEstimate.z": z})

    def define_trajectory(self, trajectory_id, offset, n_pieces, type=0):
        calls.append(("define", trajectory_id, offset, n_pieces, type))

    def start_trajectory(self, trajectory_id, time_scale=1.0, relative_position=False, relative_yaw=False, reversed=False):
        calls.append(("start", trajectory_id, time_scale, relative_position, relative_yaw, reversed))

    def land(self, absolute_height_m, duration_s):
        calls.append(("land", absolute_height_m, duration_s))

    def stop(self):
        calls.append(("stop",))


class Param:
    def set_value(self, complete_name, value):
        calls.append(("param", complete_name, value))


class Platform:
    def send_arming_request(self, do_arm):
        calls.append(("arm", do_arm))


class Crazyflie:
    def __init__(self, rw_cache=None):
        self.mem = Memory()
        self.param = Param()
        self.platform = Platform()
        self.high_level_commander = Commander()
