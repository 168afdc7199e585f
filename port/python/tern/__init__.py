# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tern plans smooth, collision-free trajectories for multirotors. This package is its C interface with numpy arrays; the
same request gives the same bits as in C and C++. docs/python.md has examples.

World frame: east, north, up. Units: metres, seconds, radians; maps and flights take times in nanoseconds.
"""
from tern._library import TernError
from tern.export import (ExportError, Setpoint, YawPlan, crazyflie_compressed, crazyflie_raw, mavlink_setpoint, plan_yaw,
                         setpoint_error, setpoint_ned)
from tern.far_way import FarWay
from tern.flight import Command, Flight, RollingMap, Tick, limit_speed
from tern.grid import Grid
from tern.planner import Planner, Polyhedron, Report, Result, clear_until
from tern.request import Fence, Limits, State, Via
from tern.track import Track
from tern.trajectory import Samples, Trajectory

__version__ = "0.1.0"

__all__ = [
    "Command", "FarWay", "Fence", "Flight", "Grid", "Limits", "Planner", "Polyhedron", "Report", "Result", "RollingMap",
    "Samples", "Setpoint", "State", "TernError", "Tick", "Track", "Trajectory", "Via", "YawPlan",
    "clear_until", "crazyflie_compressed", "crazyflie_raw", "limit_speed", "mavlink_setpoint", "plan_yaw",
    "setpoint_error", "setpoint_ned",
]
