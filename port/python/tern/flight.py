# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flights through a world that is discovered: a rolling map, and a flight over it and a planner."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Optional, Sequence

import numpy as np
import numpy.typing as npt

from tern._library import ffi, lib, points, require, triple, vector, voxel, words
from tern.planner import Planner
from tern.request import Fence, Limits, c_fences
from tern.track import Track, c_tracks

_MODES = ("rest", "look", "fly", "stop", "threat")
_BLOCKERS = ("nothing", "unseen", "obstacle", "window", "fence", "track")
_NEVER = 2**63 - 1  # INT64_MAX


class RollingMap:
    """A window of voxels that follows the vehicle: tern::RollingMap. World frame, metres, nanoseconds.

    settings: further fields of tern::MapSpec by name, such as range=6.0 or support=1.
    """

    def __init__(self, origin: Sequence[float], cell: float, dims: Sequence[int], radius: float,
                 **settings: float) -> None:
        spec = ffi.new("tern_map_spec*")
        lib.tern_map_spec_init(spec, ffi.new("tern_vec3*", vector(origin)), cell, voxel(dims), radius)
        for name, value in settings.items():
            setattr(spec, name, value)
        self.dims = tuple(int(n) for n in dims)
        self.struct = ffi.new("tern_map*")
        count = lib.tern_map_words(spec)
        self._memory, pointer = words(max(count, 1))
        require(lib.tern_map_bind(self.struct, spec, pointer, count, ffi.NULL), "map")

    def assume_free(self, center: Sequence[float], radius: float) -> None:
        """States, before take-off, that a ball is free."""
        require(lib.tern_map_assume_free(self.struct, ffi.new("tern_vec3*", vector(center)), radius), "ball")

    def assume_column(self, base: Sequence[float], radius: float, height: float) -> None:
        """States, before take-off, where the vehicle stands: an upright cylinder is free, and the ground below it is no
        higher than its base. A flight may begin there."""
        column = ffi.new("tern_cylinder*", (vector(base), radius, height))
        require(lib.tern_map_assume_column(self.struct, column), "column")

    @property
    def busy(self) -> bool:
        """Is a job in work? Then it takes no frame; a flight's tick() goes on with the job, or finish() does."""
        return _is_running(lib.tern_map_step(self.struct, 0))

    def begin_depth(self, depth: npt.ArrayLike, camera: Sequence[float], position: Sequence[float],
                    quaternion: Sequence[float], t: int, nearest: float = 0.1, furthest: float = 10.0,
                    no_return: float = 0.0) -> None:
        """Begins to enter a depth image in metres, shape (height, width); NaN and 0 are no measurement.

        camera: fx, fy, cx, cy in pixels. position, quaternion (w, x, y, z): the camera's, from its axes (right, down,
        ahead) to the world's. t: nanoseconds. nearest, furthest: what the camera measures, metres. no_return: with
        more than 0, pixels of 0 or inf say that nothing is nearer than so many metres. Raises TernError, also while
        the map is busy.
        """
        image = np.ascontiguousarray(depth, dtype=np.float32)
        height, width = image.shape
        fx, fy, cx, cy = camera
        frame = ffi.new("tern_depth_view*", {
            "z32": ffi.cast("float*", image.ctypes.data), "width": width, "height": height, "stride": width,
            "fx": fx, "fy": fy, "cx": cx, "cy": cy, "scale": 1.0, "min": nearest, "max": furthest,
            "no_return": no_return})
        pose = ffi.new("tern_pose*", {"position": vector(position), "quaternion": list(quaternion)})
        self._begin(lib.tern_map_begin_frame(self.struct, frame, pose, t), image)

    def begin_scan(self, world: npt.ArrayLike, origin: Sequence[float], t: int) -> None:
        """Begins to enter a scan: points of shape (n, 3), measured from origin. World frame, metres; t in nanoseconds.
        The map needs the setting scan_pixel."""
        memory, pointer = points(world)
        sensor = ffi.new("tern_vec3*", vector(origin))
        self._begin(lib.tern_map_begin_scan(self.struct, pointer, len(memory), sensor, t), memory)

    def begin_beams(self, directions: npt.ArrayLike, ranges: npt.ArrayLike, origin: Sequence[float], t: int,
                    nearest: float = 0.1, furthest: float = float("inf")) -> None:
        """Begins to enter a scan by its beams: directions of shape (n, 3), of any length, world frame; ranges of shape
        (n,), metres from origin. inf: nothing came back; NaN, or not within [nearest, furthest): nothing is known."""
        memory, pointer = points(directions)
        measured = np.ascontiguousarray(ranges, dtype=np.float32)
        if measured.shape != (len(memory),):
            raise ValueError(f"ranges must have the shape ({len(memory)},), not {measured.shape}")
        beams = ffi.new("tern_beams*", {"directions": pointer, "ranges": ffi.cast("float*", measured.ctypes.data),
                                        "count": len(memory), "min": nearest, "max": furthest})
        sensor = ffi.new("tern_vec3*", vector(origin))
        self._begin(lib.tern_map_begin_beams(self.struct, beams, sensor, t), (memory, measured))

    def finish(self) -> None:
        """Ends the job in work. For maps that no flight uses."""
        while _is_running(lib.tern_map_step(self.struct, 1 << 20)):
            pass

    def seen(self, index: Sequence[int]) -> bool:
        """Was the voxel seen free?"""
        return bool(lib.tern_map_seen(self.struct, voxel(index)))

    def _begin(self, status, data):
        if not _is_running(status):
            require(status, "frame")
        self._entered = data  # the map reads it until the job is done


def _is_running(status):
    return ffi.string(lib.tern_status_name(status)) == b"running"


def _reason(refusal):
    """What a refused start is about, for people."""
    field = ffi.string(lib.tern_field_name(refusal.field)).decode()
    text = f"flight: {field}" + (f", fence {refusal.fence}" if refusal.fence >= 0 else "")
    if refusal.blocked_by == lib.TERN_BLOCKED_BY_NOTHING:
        return text
    what = ffi.string(lib.tern_blocked_by_text(refusal.blocked_by)).decode()
    place = " ".join(f"{x:.2f}" for x in triple(refusal.blocked_at))
    return f"{text}: {what} is {refusal.distance:.2f} m away, at {place}; it must be {refusal.needed:.2f} m"


@dataclass(frozen=True)
class Command:
    """What to fly at one time: position to snap, shape (3,) each, and where to point the sensor. World frame."""
    position: np.ndarray
    velocity: np.ndarray
    acceleration: np.ndarray
    jerk: np.ndarray
    snap: np.ndarray
    look_at: np.ndarray


@dataclass(frozen=True)
class Tick:
    """What one tick did: mode ("rest", "look", "fly", "stop", "threat"), why it rests, counts of plans, for how many
    nanoseconds no frame was entered into the map, and what is in the way ("nothing", "unseen", "obstacle", "window",
    "fence"), where (world frame, metres), and for a fence its index among the flight's, otherwise -1. Then how far the
    vehicle was last measured to be off the plan, metres, and the part of its speed that this leaves. `report`
    is the whole answer as C gives it."""
    mode: str
    reason: str
    arrived: bool
    asked: int
    committed: int
    dropped: int
    failed: int
    work: int
    map_stale: bool
    frame_age: int
    blocked_by: str
    blocked_at: np.ndarray
    blocked_fence: int
    stray: float
    speed_share: float
    report: Any = field(repr=False, compare=False)  # tern_flight_report*


def _flight_spec(limits, settings):
    spec = ffi.new("tern_flight_spec*")
    lib.tern_flight_spec_init(spec, ffi.new("tern_limits*", limits.fields()))
    for name, value in settings.items():
        setattr(spec, name, value)
    return spec


def limit_speed(limits: Limits, clearance: float, range: float, speed: float, size: float, delay: float = 0.0,
                **settings: float) -> Limits:
    """Limits for flights where things that move may come from beyond the range of their detector: all limits of speed
    are multiplied by the same number, 1 at most, so that a vehicle which first hears of such a thing is at rest before
    the thing can touch it (docs/flight.md).

    clearance: radius and tracking_margin of the map, metres, >= 0. range: within this distance of the vehicle a thing's
    centre is measured at the next scan, metres, > 0. speed: the thing's largest, m/s, >= 0. size: from its centre to
    its farthest point, and the error of its measured place, metres, >= 0. delay: from one scan to the next, and from a
    scan to Flight.update_track, seconds, >= 0. settings: those of the Flight. Raises TernError: non_finite_input,
    invalid_argument for a value out of range or a limit rate_max, limits_invalid if the range is too short.
    """
    struct = ffi.new("tern_limits*", limits.fields())
    room = ffi.new("tern_trajectory*")
    require(lib.tern_limit_speed(range, delay, speed, size, _flight_spec(limits, settings), clearance, struct, room),
            "from beyond")
    return Limits._of(struct)


class Flight:
    """Flies to a goal and commits only to what is proven: tern::Flight. Times are nanoseconds of a clock of yours.

    settings: further fields of tern::FlightSpec by name, such as horizon=6.0 or tick=10_000_000. Raises TernError where
    tern_flight_start() refuses, for example if the surroundings of `position` were not seen or assumed free.
    """

    def __init__(self, limits: Limits, rolling_map: RollingMap, planner: Planner, position: Sequence[float], t: int,
                 fences: Sequence[Fence] = (), **settings: float) -> None:
        self._kept = [rolling_map, planner]
        spec = _flight_spec(limits, settings)
        spec.fences, spec.fence_count = c_fences(fences, self._kept), len(fences)
        self.tick_ns = spec.tick
        self.struct = ffi.new("tern_flight*")
        count = lib.tern_flight_words(voxel(rolling_map.dims))
        self._memory, pointer = words(count)
        start = ffi.new("tern_vec3*", vector(position))
        refusal = ffi.new("tern_flight_refusal*")
        status = lib.tern_flight_start(self.struct, spec, rolling_map.struct, planner.struct, pointer, count, start, t,
                                       refusal)
        require(status, _reason(refusal))

    def set_goal(self, goal: Sequence[float]) -> None:
        """Sets the goal, wherever it is."""
        require(lib.tern_flight_set_goal(self.struct, ffi.new("tern_vec3*", vector(goal))), "goal")

    def land(self, place: Sequence[float], ground: float, speed: float) -> None:
        """Flies to the point above `place` and descends to it, at most at `speed`. `place`: of the vehicle's centre once
        it stands; `ground`: a height that the ground there does not exceed."""
        require(lib.tern_flight_land(self.struct, ffi.new("tern_vec3*", vector(place)), ground, speed), "landing")

    def stop(self) -> None:
        """Comes to rest soon and forgets the goal."""
        require(lib.tern_flight_stop(self.struct))

    def tick(self, t: int) -> Tick:
        """Does one tick's work. Call it every `tick_ns`. Raises TernError with clock_behind if `t` falls: see set_clock."""
        report = ffi.new("tern_flight_report*")
        require(lib.tern_flight_tick(self.struct, t, report))
        reason = ffi.string(lib.tern_flight_reason_text(report.reason)).decode()
        return Tick(_MODES[report.mode], reason, report.reason in (lib.TERN_FLIGHT_ARRIVED, lib.TERN_FLIGHT_LANDED), report.asked,
                    report.committed, report.dropped, report.failed, report.work, bool(report.map_stale),
                    report.frame_age, _BLOCKERS[report.blocked_by], np.array(triple(report.blocked_at)),
                    report.blocked_fence, report.stray, report.speed_share, report)

    def note_position(self, position: Sequence[float], t: int) -> None:
        """Says where the vehicle was measured to be at time `t`. It flies slower while it strays from its plan."""
        require(lib.tern_flight_note_position(self.struct, ffi.new("tern_vec3*", vector(position)), t), "position")

    def update_track(self, id: int, track: Track) -> None:
        """A thing that moves was measured. `id`, 0 .. 2**32 - 1, says who it is: the next measurement of the same thing has
        the same one, and takes its place. `track` has no pieces, and its `measured` is no more than a tick after the last
        tick. Raises TernError: tracks_full, clock_behind for one older than the last, invalid_argument,
        non_finite_input."""
        kept: list = []
        struct = c_tracks([track], kept)
        struct[0].id = id
        require(lib.tern_flight_update_track(self.struct, struct), f"track {id}")

    def forget_track(self, id: int) -> None:
        """The thing is gone for certain. Raises TernError if there is none with this id."""
        require(lib.tern_flight_forget_track(self.struct, id), f"track {id}")

    def rest_clear_until(self) -> Optional[int]:
        """Until when the place where the committed plan ends stays clear of all things that move, and of fences for a
        while, nanoseconds, as the last tick knew them; None if nothing comes there within an hour."""
        until = lib.tern_flight_rest_clear_until(self.struct)
        return None if until == _NEVER else until

    def set_clock(self, t: int) -> None:
        """The clock was set, back or ahead, and shows `t` now: one tick after the last one."""
        require(lib.tern_flight_set_clock(self.struct, t))

    def command(self, t: int) -> Command:
        """What to fly at a time. For times before the last tick: what it was then."""
        command = ffi.new("tern_command*")
        lib.tern_flight_command(self.struct, t, command)
        sample = command.sample
        parts = (sample.position, sample.velocity, sample.acceleration, sample.jerk, sample.snap, command.look_at)
        return Command(*(np.array(triple(v)) for v in parts))
