# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Things that move."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence

import numpy as np

from tern._library import ffi, lib, require, triple, vector
from tern.trajectory import Trajectory

_ZERO = (0.0, 0.0, 0.0)
_SHAPES = ("ball", "cylinder", "box")
CLASSES = ("person", "cyclist", "car", "truck", "bird", "drone", "aircraft")
_ENDS = ("goes on", "gone", "stays", "reach")


@dataclass(frozen=True)
class Track:
    """A thing that moves, as a tube in time: tern::Track. World frame; m, m/s, m/s^2, and nanoseconds of the clock of
    Planner.plan's `begin`.

    position: its centre at `measured`, or what pieces are relative to. shape: "ball" and "cylinder" (upright) of
    `radius`, "box"; half: a box's half edges, z of a cylinder. error, error_speed, error_growth: s seconds after
    `measured` it is within error + error_speed s + error_growth s^2 / 2 of its curve. reach: it also stays within
    error + reach s of its first place; 0: nothing is known. end: what holds after `until`: "goes on" (until does not
    matter), "gone", "stays", or "reach" (it stays, and the error grows by `reach`). pieces: (duration, 8 x 3 points)
    of degree 7, relative to `position`, in place of a velocity.
    """
    position: Sequence[float]
    velocity: Sequence[float] = _ZERO
    shape: str = "ball"
    radius: float = 0.0
    half: Sequence[float] = _ZERO
    error: float = 0.0
    error_speed: float = 0.0
    error_growth: float = 0.0
    reach: float = 0.0
    measured: int = 0
    until: int = 0
    end: str = "goes on"
    pieces: Sequence[tuple[float, Sequence[Sequence[float]]]] = ()

    @classmethod
    def of(cls, trajectory: Trajectory, radius: float, **more) -> "Track":
        """Another vehicle's plan: a ball of `radius` that stays at its end. `more`: further members, such as its error."""
        count = max(trajectory.struct.count, 1)
        pieces, struct = ffi.new("tern_track_piece[]", count), ffi.new("tern_track*")
        require(lib.tern_track_of(trajectory.struct, radius, pieces, count, struct), "track")
        curve = tuple((pieces[i].duration, tuple(triple(p) for p in pieces[i].points)) for i in range(struct.piece_count))
        known = {"position": triple(struct.position), "radius": struct.radius, "measured": struct.measured,
                 "until": struct.until, "end": _ENDS[struct.end], "pieces": curve}
        return cls(**{**known, **more})

    @classmethod
    def of_class(cls, kind: str, position: Sequence[float], **more) -> "Track":
        """A thing of a class of CLASSES at a position: its shape and size, and what it may do (error_growth, reach).
        `more`: further members, such as velocity, measured and error, or bounds of your own. Raises ValueError for a class
        that is none."""
        struct = ffi.new("tern_track*")
        require(lib.tern_track_of_class(CLASSES.index(kind), struct), "class")
        known = {"position": position, "shape": _SHAPES[struct.shape], "radius": struct.radius,
                 "half": triple(struct.half), "error_growth": struct.error_growth, "reach": struct.reach}
        return cls(**{**known, **more})


def c_tracks(tracks: Sequence[Track], kept: list):
    """The tracks as an array of tern_track, or null; what they point to goes into `kept`."""
    out = ffi.new("tern_track[]", len(tracks)) if tracks else ffi.NULL
    for i, track in enumerate(tracks):
        pieces = ffi.new("tern_track_piece[]", len(track.pieces)) if track.pieces else ffi.NULL
        for p, (duration, points) in enumerate(track.pieces):
            if np.shape(points) != (8, 3):
                raise ValueError(f"piece {p} of track {i} has {np.shape(points)} points, not (8, 3)")
            pieces[p] = {"duration": duration, "points": [vector(point) for point in points]}
        kept.append(pieces)
        out[i] = {"measured": track.measured, "until": track.until, "position": vector(track.position),
                  "velocity": vector(track.velocity), "pieces": pieces, "piece_count": len(track.pieces), "id": i,
                  "shape": _SHAPES.index(track.shape), "end": _ENDS.index(track.end), "radius": track.radius,
                  "half": vector(track.half), "error": track.error, "error_speed": track.error_speed,
                  "error_growth": track.error_growth, "reach": track.reach}
    kept.append(out)
    return out
