# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Yaw plans, and plans in the formats of flight stacks."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence

import numpy as np
import numpy.typing as npt

from tern._library import ffi, lib, require, vector
from tern.trajectory import Trajectory

_MODES = ("fixed", "along motion", "towards point")


class YawPlan:
    """Where the nose points during a plan."""

    def __init__(self) -> None:
        self.struct = ffi.new("tern_yaw_plan*")

    @property
    def duration(self) -> float:
        """Seconds until the nose rests."""
        return lib.tern_yaw_duration(self.struct)

    def evaluate(self, t: npt.ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Angle (rad, counter-clockwise from x, without jumps) and rate (rad/s) at a time or an array of times."""
        times = np.asarray(t, dtype=np.float64)
        out = np.empty((times.size, 2))
        sample = ffi.new("tern_yaw_sample*")
        for i, time in enumerate(times.flat):
            lib.tern_yaw_evaluate(self.struct, time, sample)
            out[i] = sample.angle, sample.yaw.rate
        out = out.reshape(times.shape + (2,))
        return out[..., 0], out[..., 1]


def plan_yaw(trajectory: Trajectory, mode: str = "along motion", *, start: float = 0.0, rate_max: float = 1.0,
             acceleration_max: float = 2.0, heading: float = 0.0, point: Sequence[float] = (0.0, 0.0, 0.0)) -> YawPlan:
    """A yaw plan within limits (rad/s, rad/s^2) from rest at the angle `start`.

    mode: "along motion", "fixed" (to `heading`, rad) or "towards point" (`point`, world frame). Raises TernError.
    """
    request = ffi.new("tern_yaw_request*")
    lib.tern_yaw_request_init(request, ffi.new("tern_heading*", _heading(start)), rate_max, acceleration_max)
    request.mode = _MODES.index(mode)
    request.heading = _heading(heading)
    request.point = vector(point)
    plan = YawPlan()
    planner = ffi.new("tern_yaw_planner*")
    require(lib.tern_plan_yaw(planner, trajectory.struct, request, plan.struct), "yaw")
    return plan


def _heading(angle):
    return {"cosine": float(np.cos(angle)), "sine": float(np.sin(angle))}


@dataclass(frozen=True)
class Setpoint:
    """North, east, down; yaw clockwise from north, NaN without a yaw plan: the fields of PX4's TrajectorySetpoint.
    Single precision."""
    position: np.ndarray
    velocity: np.ndarray
    acceleration: np.ndarray
    jerk: np.ndarray
    yaw: float
    yaw_rate: float


def _setpoint(trajectory, t, yaw, origin):
    sample = ffi.new("tern_sample*")
    lib.tern_evaluate(trajectory.struct, t, sample)
    heading = ffi.NULL
    if yaw is not None:
        heading = ffi.new("tern_yaw_sample*")
        lib.tern_yaw_evaluate(yaw.struct, t, heading)
    out = ffi.new("tern_setpoint*")
    lib.tern_setpoint_ned(sample, heading, _origin(origin), out)
    return out


@dataclass(frozen=True)
class ExportError:
    """How far an export is from the plan at equal times, at most: m, m/s, m/s^2, m/s^3, rad, rad/s."""
    position: float
    velocity: float
    acceleration: float
    jerk: float
    yaw: float
    yaw_rate: float


def _error(struct):
    return ExportError(struct.position, struct.velocity, struct.acceleration, struct.jerk, struct.yaw, struct.yaw_rate)


def _origin(origin):
    return ffi.new("tern_vec3*", vector(origin))


def setpoint_error(trajectory: Trajectory, yaw: YawPlan | None = None,
                   origin: Sequence[float] = (0.0, 0.0, 0.0)) -> ExportError:
    """What setpoint_ned and mavlink_setpoint lose of a plan by rounding to single precision."""
    out = ffi.new("tern_export_error*")
    struct = yaw.struct if yaw is not None else ffi.NULL
    require(lib.tern_setpoint_error(trajectory.struct, struct, _origin(origin), out), "trajectory")
    return _error(out)


def setpoint_ned(trajectory: Trajectory, t: float, yaw: YawPlan | None = None,
                 origin: Sequence[float] = (0.0, 0.0, 0.0)) -> Setpoint:
    """The setpoint of time t, relative to the autopilot's origin, which is given in Tern's world."""
    struct = _setpoint(trajectory, t, yaw, origin)
    parts = (struct.position, struct.velocity, struct.acceleration, struct.jerk)
    return Setpoint(*(np.array(list(v), dtype=np.float32) for v in parts), struct.yaw, struct.yaw_rate)


def mavlink_setpoint(trajectory: Trajectory, t: float, sequence: int, time_boot_ms: int, yaw: YawPlan | None = None,
                     origin: Sequence[float] = (0.0, 0.0, 0.0), system: int = 255, component: int = 190,
                     target_system: int = 1, target_component: int = 1) -> bytes:
    """The same as one MAVLink 2 frame, SET_POSITION_TARGET_LOCAL_NED, to be written to the autopilot's port."""
    header = ffi.new("tern_mavlink_header*", {
        "system": system, "component": component, "target_system": target_system,
        "target_component": target_component, "sequence": sequence % 256, "time_boot_ms": time_boot_ms})
    frame = ffi.new("uint8_t[]", lib.PY_TERN_MAVLINK_SETPOINT_BYTES)
    count = lib.tern_mavlink_setpoint(_setpoint(trajectory, t, yaw, origin), header, frame)
    return bytes(ffi.buffer(frame, count))


def crazyflie_raw(trajectory: Trajectory, yaw: YawPlan | None = None,
                  origin: Sequence[float] = (0.0, 0.0, 0.0)) -> tuple[np.ndarray, ExportError]:
    """A Crazyflie's pieces, shape (pieces, 33), single precision: coefficients of x, y, z and yaw by rising powers of
    time, eight each, then the duration. Its tobytes() is what the firmware's trajectory memory holds. `origin` is the
    point of the world that becomes 0. There are more pieces than segments if the yaw needs them."""
    room = lib.PY_TERN_CRAZYFLIE_PIECES
    pieces, count = ffi.new("tern_crazyflie_piece[]", room), ffi.new("int32_t*")
    struct, error = yaw.struct if yaw is not None else ffi.NULL, ffi.new("tern_export_error*")
    require(lib.tern_crazyflie_raw(trajectory.struct, struct, _origin(origin), pieces, room, count, error), "segments")
    numbers = np.frombuffer(ffi.buffer(pieces), dtype=np.float32).reshape(-1, 33)
    return numbers[:count[0]].copy(), _error(error)


def crazyflie_compressed(trajectory: Trajectory, yaw: YawPlan | None = None,
                         origin: Sequence[float] = (0.0, 0.0, 0.0)) -> tuple[bytes, Trajectory, ExportError]:
    """The Crazyflie's compressed form, the trajectory that it flies, and how far that is from the plan. Prove the
    trajectory with clear_until()."""
    room = lib.PY_CRAZYFLIE_BYTES
    data, used, error = ffi.new("uint8_t[]", room), ffi.new("int32_t*"), ffi.new("tern_export_error*")
    struct, at = yaw.struct if yaw is not None else ffi.NULL, _origin(origin)
    require(lib.tern_crazyflie_compressed(trajectory.struct, struct, at, data, room, used, error), "compressed form")
    flown = Trajectory()
    require(lib.tern_crazyflie_decompressed(data, used[0], at, flown.struct), "compressed form")
    return bytes(ffi.buffer(data, used[0])), flown, _error(error)
