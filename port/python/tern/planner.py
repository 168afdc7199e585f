# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planning and replanning."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence

import numpy as np

from tern._library import HEADER_HASH, ffi, lib, require, status_name, triple, view, voxel, words
from tern.grid import Grid
from tern.request import CRequest, End, Fence, Limits, Via, c_fences, c_vias, state
from tern.track import Track, c_tracks
from tern.trajectory import Trajectory

STAGE = np.dtype([("work", "u8"), ("bound", "u8"), ("ticks", "u8")])
_QUALITIES = ("none", "hover", "stop-and-go", "optimised", "previous plan")
_GOAL_MODES = ("exact", "nearest")
_SEARCHES = ("fast", "optimal")


class Report:
    """What the planner says about a call: tern::Report. Its numbers are those of the C structure, `struct`."""

    def __init__(self, struct) -> None:
        self.struct = struct

    def __repr__(self) -> str:
        return f"<Report {self.status}: {self.meaning}>"

    @property
    def status(self) -> str:
        """The answer: "ok", "no_path", ..."""
        return status_name(self.struct.status)

    @property
    def meaning(self) -> str:
        """One line of English about the status."""
        return ffi.string(lib.tern_status_meaning(self.struct.status)).decode()

    @property
    def stage(self) -> str:
        """The stage where the answer arose."""
        return ffi.string(lib.tern_stage_name(self.struct.stage)).decode()

    @property
    def field(self) -> str:
        """The field of the request that is wrong, or "none"."""
        return ffi.string(lib.tern_field_name(self.struct.field)).decode()

    @property
    def fence(self) -> int | None:
        """The index of the fence that is wrong, or that start, via or goal breaks; or None."""
        return self.struct.fence if self.struct.fence >= 0 else None

    @property
    def track(self) -> int | None:
        """The index of the track that is wrong, that is in the way, or that the plan begins too near to and leaves; or
        None."""
        return self.struct.track if self.struct.track >= 0 else None

    @property
    def conflict(self) -> float:
        """When the first plan meets what is in the way, seconds since its beginning: for "start_in_contact",
        "goal_covered" and "no_clear_time"."""
        return self.struct.conflict

    @property
    def goal_free(self) -> float:
        """From when on the plan could rest at a goal that is covered, seconds since its beginning; or infinity."""
        return self.struct.goal_free

    @property
    def rest_clear_until(self) -> float:
        """Until when the plan's end is clear of what moves, seconds since the trajectory's beginning; or infinity."""
        return self.struct.rest_clear_until

    @property
    def waits(self) -> float:
        """Seconds that the plan rests before it sets out, for what moves."""
        return self.struct.waits

    @property
    def quality(self) -> str:
        """"none", "hover", "stop-and-go", "optimised" or "previous plan"."""
        return _QUALITIES[self.struct.quality]

    @property
    def entered(self) -> float:
        """The time on the trajectory at which the plan begins, seconds: 0 except for "previous plan"."""
        return self.struct.entered

    @property
    def goal_missed(self) -> str:
        """The status for which the plan ends at `reachable` instead of the goal, or "ok"."""
        return status_name(self.struct.goal_missed)

    @property
    def reachable(self) -> np.ndarray | None:
        """The point nearest to the goal that a path leads to, or None. World frame, metres."""
        return np.array(triple(self.struct.reachable)) if self.struct.has_reachable else None

    @property
    def nearest_free(self) -> np.ndarray | None:
        """The free voxel nearest to an occupied start or goal, or None. World frame, metres."""
        return np.array(triple(self.struct.nearest_free)) if self.struct.has_nearest_free else None

    @property
    def stages(self) -> dict[str, np.void]:
        """For each stage by name a record: work, bound (of the work) and ticks (0 without a clock)."""
        array = view(self.struct, STAGE, len(self.struct.diagnostics.stages), "diagnostics", "stages")
        return {ffi.string(lib.tern_stage_name(i)).decode(): record for i, record in enumerate(array)}

    @property
    def high_water(self) -> dict[str, int]:
        """The highest use of each capacity."""
        water = self.struct.diagnostics.high_water
        return {name: getattr(water, name) for name in dir(water)}


@dataclass(frozen=True)
class Result:
    """The answer to one plan. It is true if there is a trajectory."""
    trajectory: Trajectory | None
    report: Report

    def __bool__(self) -> bool:
        return self.trajectory is not None


@dataclass(frozen=True)
class Polyhedron:
    """Free space for the robot's centre: the points p with normals @ p <= offsets. World frame, metres.

    start, end: the line it was made for.
    """
    normals: np.ndarray
    offsets: np.ndarray
    start: np.ndarray
    end: np.ndarray


class Planner:
    """Plans on grids. Keep one: it remembers what it learned about a map, which changes no result. Not thread-safe; two
    planners are independent. Its workspace is 119 MB of address space with the default profile, of which a plan uses
    what its map needs."""

    def __init__(self) -> None:
        size = lib.tern_size_of(lib.TERN_SIZE_WORKSPACE)
        self._memory, pointer = words(size // 8 + 1)
        self.struct = ffi.new("tern_planner*")
        require(lib.tern_planner_init_for(self.struct, pointer, self._memory.nbytes, HEADER_HASH), "planner")
        self._origin = np.zeros(3)
        self._query = None

    def plan(self, grid: Grid, start: End, goal: End, limits: Limits, *, time_weight: float | None = None,
             fences: Sequence[Fence] = (), vias: Sequence[Via] = (), goal_mode: str = "exact", search: str = "fast",
             previous: Trajectory | None = None, previous_time: float = 0.0, begin: int = 0,
             tracks: Sequence[Track] = (), rest_clear: float = 0.0) -> Result:
        """Plans from start to goal. Both are a State, or a position to be at rest at. World frame, SI units.

        time_weight: duration against smoothness, 0.001 .. 1e6. goal_mode: "exact", or "nearest" to end as near to the
        goal as possible. search: "fast" or "optimal". previous: the plan that is being flown, with start its state at
        previous_time; see replan(). begin: when the plan begins, in nanoseconds of a clock of yours; the plan carries
        it. tracks: things that move, which the plan is proven clear of; for rest_clear seconds at its end, too. The grid
        must be inflated.
        """
        request = self._request(start, goal, limits, fences, vias, tracks, previous)
        request.struct.goal_mode = _GOAL_MODES.index(goal_mode)
        request.struct.search = _SEARCHES.index(search)
        request.struct.previous_time = previous_time
        request.struct.begin = begin
        request.struct.rest_clear = rest_clear
        if time_weight is not None:
            request.struct.time_weight = time_weight
        trajectory, report = Trajectory(), ffi.new("tern_report*")
        status = lib.tern_plan(self.struct, grid.struct, request.struct, trajectory.struct, report)
        self._origin = grid.origin
        self._query = (grid, request, status, trajectory)
        return Result(trajectory if status == 0 else None, Report(report))

    def replan(self, grid: Grid, previous: Trajectory, t: float, goal: End, limits: Limits, **options) -> Result:
        """A plan that continues `previous` from time t on. If none arrives earlier, the plan is `previous` itself, and its
        report's `entered` is t."""
        return self.plan(grid, previous.state(t), goal, limits, previous=previous, previous_time=t, **options)

    def corridor(self) -> list[Polyhedron]:
        """The corridor of the last plan, in flight order; empty if it has none."""
        count = lib.tern_corridor(self.struct, ffi.NULL, 0)
        structs = ffi.new("tern_polyhedron[]", max(count, 1))
        lib.tern_corridor(self.struct, structs, count)
        return [self._polyhedron(structs[i]) for i in range(count)]

    def record(self) -> bytes:
        """The last query and its answer as bytes, to be planned again elsewhere (docs/record.md). Call it before the grid
        changes. Raises RuntimeError if nothing was planned yet."""
        if self._query is None:
            raise RuntimeError("nothing was planned yet")
        grid, request, status, trajectory = self._query
        room = lib.tern_plan_record_bytes(voxel(grid.dims))
        data, used = np.empty(room, dtype=np.uint8), ffi.new("size_t*")
        pointer = ffi.cast("uint8_t*", data.ctypes.data)
        require(lib.tern_record_plan(grid.struct, request.struct, status, trajectory.struct, pointer, room, used), "record")
        return data[:used[0]].tobytes()

    def _polyhedron(self, struct):
        planes = np.array([(*triple(plane.normal), plane.offset) for plane in struct.planes[0:struct.count]])
        world = [self._origin + triple(v) for v in (getattr(struct, "from"), struct.to)]
        return Polyhedron(planes[:, :3], planes[:, 3] + planes[:, :3] @ self._origin, *world)

    @staticmethod
    def _request(start, goal, limits, fences, vias, tracks, previous):
        struct = ffi.new("tern_request*")
        lib.tern_request_init(struct)
        kept = [previous]
        struct.start = state(start).fields()
        struct.goal = state(goal).fields()
        struct.limits = limits.fields()
        struct.fences, struct.fence_count = c_fences(fences, kept), len(fences)
        struct.vias, struct.via_count = c_vias(vias, kept), len(vias)
        struct.tracks, struct.track_count = c_tracks(tracks, kept), len(tracks)
        struct.previous = previous.struct if previous is not None else ffi.NULL
        return CRequest(struct, kept)


def clear_until(grid: Grid, trajectory: Trajectory, t: float = 0.0, limits: Limits | None = None) -> float:
    """Until when the trajectory is proven clear on the grid from t on, in seconds after its beginning. With limits, it is
    proven to keep these too. It is trajectory.duration if all of it is."""
    struct = ffi.new("tern_limits*", limits.fields()) if limits is not None else ffi.NULL
    return lib.tern_clear_until(grid.struct, trajectory.struct, t, struct, lib.TERN_BEYOND_EMPTY, ffi.NULL)
