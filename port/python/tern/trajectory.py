# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans, as numpy sees them."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from tern._library import ffi, lib, triple, view
from tern.request import State

SEGMENT = np.dtype({"names": ["duration", "points", "polyhedron"], "formats": ["f8", ("f8", (8, 3)), "i4"],
                    "offsets": [0, 8, 200], "itemsize": 208})
assert SEGMENT.itemsize == ffi.sizeof("tern_segment") and ffi.offsetof("tern_segment", "polyhedron") == 200
assert ffi.sizeof("tern_sample") == 15 * 8


@dataclass(frozen=True)
class Samples:
    """The state at one time, each field of shape (3,), or at n times, each of shape (n, 3). World frame; m, m/s, m/s^2,
    m/s^3, m/s^4."""
    position: np.ndarray
    velocity: np.ndarray
    acceleration: np.ndarray
    jerk: np.ndarray
    snap: np.ndarray


class Trajectory:
    """A plan. It owns its memory, and no call changes it."""

    def __init__(self) -> None:
        self.struct = ffi.new("tern_trajectory*")

    def __len__(self) -> int:
        """Its segments."""
        return self.struct.count

    @property
    def duration(self) -> float:
        """Seconds from the beginning to rest."""
        return lib.tern_duration(self.struct)

    @property
    def begin(self) -> int:
        """When the plan begins: nanoseconds of a clock of yours, as the request said."""
        return self.struct.begin

    def time_on(self, now: int) -> float:
        """The time on the plan when its clock shows `now` (nanoseconds): seconds, negative before its beginning."""
        return lib.tern_time_on(self.struct, now)

    @property
    def origin(self) -> np.ndarray:
        """World frame, metres: what `control_points` are relative to."""
        return np.array(triple(self.struct.origin))

    @property
    def segments(self) -> np.ndarray:
        """A read-only view of the segments, a record each: duration (s), points (8, 3), polyhedron (an index into the
        corridor)."""
        segments = view(self.struct, SEGMENT, len(self), "segments")
        segments.flags.writeable = False
        return segments

    @property
    def control_points(self) -> np.ndarray:
        """The Bezier control points, shape (segments, 8, 3), metres relative to `origin`: a view, too."""
        return self.segments["points"]

    def evaluate(self, t: npt.ArrayLike) -> Samples:
        """The state at a time, or at each of an array of times, seconds after the beginning. Every time has an answer:
        the beginning before it and for NaN, rest at the goal after the end."""
        times = np.asarray(t, dtype=np.float64)
        out = np.empty((times.size, 5, 3))
        samples = ffi.cast("tern_sample*", out.ctypes.data)
        for i, time in enumerate(times.flat):
            lib.tern_evaluate(self.struct, time, samples + i)
        out = out.reshape(times.shape + (5, 3))
        return Samples(*(out[..., k, :] for k in range(5)))

    def state(self, t: float) -> State:
        """The state at a time, as a start to replan from: bit for bit what the planner asks for."""
        sample = ffi.new("tern_sample*")
        lib.tern_evaluate(self.struct, t, sample)
        return State(triple(sample.position), triple(sample.velocity), triple(sample.acceleration),
                     triple(sample.jerk))
