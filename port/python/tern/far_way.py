# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Far ways: a coarse grid of the whole world gives a flight near goals."""
from __future__ import annotations

from typing import Optional, Sequence

import numpy as np

from tern._library import ffi, lib, require, triple, vector
from tern.flight import RollingMap, Tick
from tern.grid import Grid
from tern.planner import Planner

_STATES = ("no goal", "searching", "leads", "no way")


class FarWay:
    """The way through a coarse grid: tern::FarWay. It gives a Flight near goals, one after the other.

    coarse: a grid with radius 0 and large cells, in which all that is known is marked; inflate it. planner: one that
    nobody else plans with, not the flight's. ahead: how far ahead near goals are at most, metres, 3 to 256 cells of the
    coarse grid; a little less than half the window. patience: nanoseconds without getting a cell further until the way
    is in doubt. Raises TernError, invalid_argument for what is out of range.
    """

    def __init__(self, coarse: Grid, planner: Planner, ahead: float, patience: int = 10_000_000_000) -> None:
        self._kept = (coarse, planner)
        self.struct = ffi.new("tern_far_way*")
        spec = ffi.new("tern_far_way_spec*", {"ahead": ahead, "patience": patience})
        require(lib.tern_far_way_start(self.struct, spec, coarse.struct, planner.struct), "far way")

    def set_goal(self, goal: Sequence[float]) -> None:
        """Sets the goal, world frame, and looks for a way to it. Call it again after marking or clearing cells."""
        require(lib.tern_far_way_set_goal(self.struct, ffi.new("tern_vec3*", vector(goal))), "goal")

    def tick(self, position: Sequence[float], last: Optional[Tick], rolling_map: RollingMap, t: int,
             work: int = 1000) -> Optional[np.ndarray]:
        """Does one tick's work, before each Flight.tick(). position: the vehicle's. last: what the last Flight.tick() gave;
        None before the first. Returns the near goal if the flight's goal is to be set to it now, shape (3,), otherwise
        None."""
        report = ffi.new("tern_flight_report*") if last is None else last.report
        near_goal = ffi.new("tern_vec3*")
        place = ffi.new("tern_vec3*", vector(position))
        is_new = lib.tern_far_way_tick(self.struct, place, report, rolling_map.struct, t, work, near_goal)
        return np.array(triple(near_goal)) if is_new else None

    @property
    def is_last(self) -> bool:
        """Is the near goal the goal?"""
        return bool(lib.tern_far_way_is_last(self.struct))

    @property
    def state(self) -> str:
        """"no goal", "searching", "leads" or "no way"."""
        return _STATES[lib.tern_far_way_state(self.struct)]

    @property
    def left(self) -> float:
        """Metres along the way to its end; 0 unless it leads."""
        return lib.tern_far_way_left(self.struct)

    @property
    def searches(self) -> int:
        """How many ways were sought."""
        return lib.tern_far_way_searches(self.struct)

    @property
    def marked(self) -> int:
        """How many cells of the coarse grid were marked, because the near map has something there."""
        return lib.tern_far_way_marked(self.struct)
