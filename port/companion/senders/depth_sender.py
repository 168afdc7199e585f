# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sends frames of depth to tern_companion; depth_format.h explains each field.

    with DepthSender("/run/tern/depth") as sender:
        sender.send(image, fx, fy, cx, cy, stamp_ns=stamp)
"""
import socket
import struct
import time

import numpy as np

HEADER = struct.Struct("<IHHIIqIIII6d3d4d")
MAGIC, VERSION = 0x4E524554, 1
LOOKS_AHEAD = (0.5, -0.5, 0.5, -0.5)


def now():
    """Nanoseconds on the clock of stamps, CLOCK_MONOTONIC."""
    return time.clock_gettime_ns(time.CLOCK_MONOTONIC)


class DepthSender:
    """A connection to the companion's socket. Raises OSError if there is none, or if it ends: connect again."""

    def __init__(self, path):
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self._socket.connect(path)

    def send(self, image, fx, fy, cx, cy, stamp_ns, sensor=0, least=0.2, most=20.0, position=(0.0, 0.0, 0.0),
             attitude=LOOKS_AHEAD):
        """A depth image, height x width: uint16 in millimetres or float32 in metres, undistorted."""
        formats = {np.dtype(np.uint16): 1, np.dtype(np.float32): 2}
        if image.dtype not in formats or image.ndim != 2:
            raise ValueError(f"a depth image is uint16 or float32 and has two axes, not {image.dtype}, {image.shape}")
        self._send(formats[image.dtype], image, (fx, fy, cx, cy), stamp_ns, sensor, (least, most), position, attitude)

    def send_points(self, points, stamp_ns, sensor=0, least=0.2, most=20.0, position=(0.0, 0.0, 0.0),
                    attitude=(1.0, 0.0, 0.0, 0.0)):
        """A scan, height x width x 3: float32 in the sensor's axes, in metres."""
        if points.dtype != np.float32 or points.ndim != 3 or points.shape[2] != 3:
            raise ValueError(f"a scan is float32 and height x width x 3, not {points.dtype}, {points.shape}")
        self._send(3, points, (0.0,) * 4, stamp_ns, sensor, (least, most), position, attitude)

    def _send(self, kind, numbers, lens, stamp_ns, sensor, reach, position, attitude):
        payload = np.ascontiguousarray(numbers).tobytes()
        height, width = numbers.shape[:2]
        header = HEADER.pack(MAGIC, VERSION, HEADER.size, sensor, kind, stamp_ns, width, height, len(payload), 0, *lens,
                             *reach, *position, *attitude)
        self._socket.sendall(header + payload)

    def close(self):
        self._socket.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
