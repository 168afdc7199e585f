# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The occupancy grid that is planned on."""
from __future__ import annotations

from typing import Sequence

import numpy as np
import numpy.typing as npt

from tern._library import ffi, lib, points, require, vector, voxel, words


class Grid:
    """A box of voxels, each free or an obstacle. World frame, metres.

    origin: the lower corner of voxel (0, 0, 0).
    cell: the voxels' edge.
    dims: voxels along x, y and z.
    radius: the robot's.
    tracking_margin: how far the vehicle may be off its plan. The centre keeps both together from every obstacle voxel.
    boundary: lower and upper corner of where the centre may be; by default, all of the grid.

    Raises TernError for what tern_grid_bind() refuses. Everything is free at first. Call inflate() after marking and
    before planning.
    """

    def __init__(self, origin: Sequence[float], cell: float, dims: Sequence[int], radius: float,
                 boundary: Sequence[Sequence[float]] | None = None, tracking_margin: float = 0.0) -> None:
        if boundary is None:
            boundary = [origin, [o + cell * n for o, n in zip(origin, dims)]]
        spec = ffi.new("tern_grid_spec*", {
            "origin": vector(origin), "cell": cell, "dims": voxel(dims), "radius": radius,
            "tracking_margin": tracking_margin,
            "boundary": {"lower": vector(boundary[0]), "upper": vector(boundary[1])}})
        self.struct = ffi.new("tern_grid*")
        count = lib.tern_grid_words(spec.dims)
        self._memory, pointer = words(count)
        require(lib.tern_grid_bind(self.struct, spec, pointer, count), "grid")
        self.origin = np.array(origin, dtype=np.float64)
        self.cell = float(cell)
        self.dims = tuple(int(n) for n in dims)
        self.radius = float(radius)

    def mark_box(self, lower: Sequence[float], upper: Sequence[float]) -> None:
        """Marks every voxel that the box meets as an obstacle."""
        require(lib.tern_grid_mark_box(self.struct, _box(lower, upper)), "box")

    def clear_box(self, lower: Sequence[float], upper: Sequence[float]) -> None:
        """Frees every voxel that the box meets."""
        require(lib.tern_grid_clear_box(self.struct, _box(lower, upper)), "box")

    def mark_points(self, world: npt.ArrayLike) -> int:
        """Marks the voxel of each point of an (n, 3) array. Returns how many points are inside the grid."""
        memory, pointer = points(world)
        inside = ffi.new("size_t*")
        require(lib.tern_grid_mark_points(self.struct, pointer, len(memory), inside), "points")
        return int(inside[0])

    def mark_grid(self, fine: Grid) -> None:
        """Marks what an inflated fine grid closes in this coarse one, for a far way. This grid's cell is four times the
        fine one's, and the fine grid begins at a corner of a cell of this one. Each cell that is not marked is half
        free at least, and neighbours that are not are joined by free voxels."""
        field = ffi.new("uint8_t*")
        status = lib.tern_grid_mark_grid(self.struct, fine.struct, field)
        require(status, ffi.string(lib.tern_field_name(field[0])).decode())

    def inflate(self) -> None:
        """Makes the grid ready to be planned on, after any number of marks."""
        require(lib.tern_grid_inflate(self.struct), "grid")


def _box(lower, upper):
    return ffi.new("tern_box*", {"lower": vector(lower), "upper": vector(upper)})
