# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a plan is asked for: ends, limits, fences and vias."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Sequence, Union

import numpy as np

from tern._library import ffi, lib, require, triple, vector

_ZERO = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class State:
    """Start or goal: position and its first three derivatives. World frame; m, m/s, m/s^2, m/s^3."""
    position: Sequence[float]
    velocity: Sequence[float] = _ZERO
    acceleration: Sequence[float] = _ZERO
    jerk: Sequence[float] = _ZERO

    def fields(self) -> dict:
        """For a tern_state."""
        return {name: vector(getattr(self, name)) for name in ("position", "velocity", "acceleration", "jerk")}


End = Union[State, Sequence[float]]


def state(end: End) -> State:
    """A position alone is a state at rest."""
    return end if isinstance(end, State) else State(end)


_AXES = ("v_max", "a_max", "v_min", "a_min", "j_max")
_NUMBERS = ("v_horizontal", "a_horizontal", "j_horizontal", "thrust_max", "thrust_min", "tilt_tangent", "rate_max")


@dataclass(frozen=True)
class Limits:
    """Limits of a plan, in m/s, m/s^2 and m/s^3, as tern::Limits.

    v_max, a_max: for each axis, > 0. v_min, a_min: for motion in the negative direction, < 0; 0 means minus the upper
    one. v_horizontal, a_horizontal, j_horizontal: for the horizontal norm; 0 means none. j_max: for each axis; 0 means
    none. thrust_max, thrust_min, tilt_tangent, rate_max: the vehicle's thrust over mass, the tangent of its largest
    tilt, and its roll and pitch rate together in rad/s; 0 means none.
    """
    v_max: Sequence[float]
    a_max: Sequence[float]
    v_min: Sequence[float] = _ZERO
    a_min: Sequence[float] = _ZERO
    v_horizontal: float = 0.0
    a_horizontal: float = 0.0
    j_max: Sequence[float] = _ZERO
    j_horizontal: float = 0.0
    thrust_max: float = 0.0
    thrust_min: float = 0.0
    tilt_tangent: float = 0.0
    rate_max: float = 0.0

    def fields(self) -> dict:
        """For a tern_limits."""
        out = {name: vector(getattr(self, name)) for name in _AXES}
        return {**out, **{name: getattr(self, name) for name in _NUMBERS}}

    @classmethod
    def _of(cls, struct) -> "Limits":
        return cls(**{name: triple(getattr(struct, name)) for name in _AXES},
                   **{name: getattr(struct, name) for name in _NUMBERS})

    @classmethod
    def from_px4(cls, **parameters: float) -> "Limits":
        """Limits of plans that PX4 can follow: its defaults, but for the parameters given (mpc_xy_vel_max=5.0). Speeds
        are below the parameters. Raises TernError for a parameter out of its range (docs/export.md)."""
        return cls._from("px4", parameters)

    @classmethod
    def from_ardupilot(cls, **parameters: float) -> "Limits":
        """Limits of plans that ArduPilot can follow, likewise, in metres (wpnav_speed_m_s=5.0)."""
        return cls._from("ardupilot", parameters)

    @classmethod
    def from_crazyflie(cls, **parameters: float) -> "Limits":
        """Limits of plans that a Crazyflie can follow, likewise (thrust_base=40000 with a payload)."""
        return cls._from("crazyflie", parameters)

    @classmethod
    def _from(cls, stack, parameters):
        values = ffi.new(f"tern_{stack}_parameters*")
        getattr(lib, f"tern_{stack}_defaults")(values)
        for name, value in parameters.items():
            setattr(values, name, value)
        limits = ffi.new("tern_limits*")
        bad = ffi.new("uint8_t*")
        status = getattr(lib, f"tern_limits_from_{stack}")(values, limits, bad)
        require(status, f"{stack}'s parameter for {ffi.string(lib.tern_field_name(bad[0])).decode()}, in metres")
        return cls._of(limits)


@dataclass(frozen=True)
class Fence:
    """A convex geofence: the points p with normals @ p <= offsets. World frame, metres. keep_out: the plan stays outside
    of it, with the radius to spare; otherwise inside. begin, until: of a fence for a while, nanoseconds of the clock of
    Planner.plan's `begin`, or of Flight.tick; clock_error: by how much its clock may be off, seconds. If begin and
    until are equal, it always holds."""
    normals: Sequence[Sequence[float]]
    offsets: Sequence[float]
    keep_out: bool = False
    begin: int = 0
    until: int = 0
    clock_error: float = 0.0

    @classmethod
    def box(cls, lower: Sequence[float], upper: Sequence[float], keep_out: bool = False, **times) -> "Fence":
        """A fence that is a box. times: begin, until and clock_error."""
        normals = np.vstack([np.eye(3), -np.eye(3)])
        return cls(normals, np.concatenate([np.asarray(upper, float), -np.asarray(lower, float)]), keep_out, **times)


@dataclass(frozen=True)
class Via:
    """A point to pass on the way. tolerance: how near the plan comes, m. stop: at rest there,
    for dwell seconds. velocity: with it there."""
    position: Sequence[float]
    tolerance: float = 0.0
    stop: bool = False
    velocity: Sequence[float] | None = None
    dwell: float = 0.0


@dataclass
class CRequest:
    """A tern_request and all that it points to. Keep it as long as the call lasts."""
    struct: object
    kept: list = field(default_factory=list)


def c_fences(fences: Sequence[Fence], kept: list):
    """The fences as an array of tern_fence, or null; what they point to goes into `kept`."""
    out = ffi.new("tern_fence[]", len(fences)) if fences else ffi.NULL
    for i, fence in enumerate(fences):
        if len(fence.normals) != len(fence.offsets):
            raise ValueError(f"fence {i} has {len(fence.normals)} normals and {len(fence.offsets)} offsets")
        planes = ffi.new("tern_halfspace[]", [{"normal": vector(n), "offset": float(o)}
                                              for n, o in zip(fence.normals, fence.offsets)])
        kept.append(planes)
        out[i] = {"planes": planes, "count": len(planes), "kind": int(fence.keep_out),
                  "from": fence.begin, "until": fence.until, "clock_error": fence.clock_error}
    kept.append(out)
    return out


def c_vias(vias: Sequence[Via], kept: list):
    """The vias as an array of tern_via, or null."""
    out = ffi.new("tern_via[]", len(vias)) if vias else ffi.NULL
    for i, via in enumerate(vias):
        out[i] = {"position": vector(via.position), "tolerance": via.tolerance, "stop": via.stop,
                  "has_velocity": via.velocity is not None, "velocity": vector(via.velocity or _ZERO),
                  "dwell": via.dwell}
    kept.append(out)
    return out
