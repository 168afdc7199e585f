# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""A depth camera in a simulator that has none: it sees the blocks of a map and the ground, from the vehicle's pose."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "companion", "senders"))
from depth_sender import DepthSender, now  # noqa: E402

WIDTH, HEIGHT, FOCAL = 120, 90, 60.0  # pixels: 90 degrees by 74
RATE = 15.0  # Hz
FARTHEST = 20.0  # m


def rotation(q):
    """The matrix of a quaternion (w, x, y, z)."""
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def depth_image(blocks, position_ned, attitude_ned):
    """Depth along the axis of a camera that looks ahead, metres: float32, HEIGHT x WIDTH. 0 is no measurement.
    `blocks`: (lower, upper) in east, north, up; the ground is at 0."""
    u, v = np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT))
    body = np.stack([np.ones(u.shape), (u - 0.5 * (WIDTH - 1)) / FOCAL, (v - 0.5 * (HEIGHT - 1)) / FOCAL])  # depth 1
    north, east, down = np.tensordot(rotation(attitude_ned), body, axes=1)
    along = np.stack([east, north, -down])
    along[np.abs(along) < 1e-9] = 1e-9
    eye = np.array([position_ned[1], position_ned[0], -position_ned[2]]).reshape(3, 1, 1)
    depth = np.full(u.shape, FARTHEST)
    for lower, upper in [*blocks, ([-1e4, -1e4, -1.0], [1e4, 1e4, 0.0])]:
        a = (np.reshape(lower, (3, 1, 1)) - eye) / along
        b = (np.reshape(upper, (3, 1, 1)) - eye) / along
        near, far = np.minimum(a, b).max(axis=0), np.maximum(a, b).min(axis=0)
        hit = (near < far) & (far > 0.0)
        depth = np.where(hit, np.minimum(depth, np.maximum(near, 0.0)), depth)
    return depth.astype(np.float32)


class Camera:
    """Sends what it sees to tern_companion."""

    def __init__(self, path, blocks):
        self._sender, self._blocks, self._due = DepthSender(path), blocks, 0

    def look(self, position_ned, attitude_ned):
        """Takes and sends an image, if one is due."""
        stamp = now()
        if stamp < self._due:
            return
        self._due = stamp + int(1e9 / RATE)
        self._sender.send(depth_image(self._blocks, position_ned, attitude_ned), FOCAL, FOCAL, 0.5 * (WIDTH - 1),
                          0.5 * (HEIGHT - 1), stamp_ns=stamp, most=1000.0)
