# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
import struct

from cflib import calls


class MemoryElement:
    TYPE_TRAJ = 0x12


class Poly4D:
    class Poly:
        def __init__(self, values=None):
            self.values = values or [0.0] * 8

    def __init__(self, duration, x=None, y=None, z=None, yaw=None):
        self.duration = duration
        self.x, self.y, self.z, self.yaw = x, y, z, yaw

    def pack(self):
        values = [v for axis in (self.x, self.y, self.z, self.yaw) for v in axis.values]
        return struct.pack("<33f", *values, self.duration)


class TrajectoryMemory:
    def __init__(self):
        self.trajectory = []

    def write_data_sync(self, start_addr=0):
        calls.append(("write", start_addr, b"".join(piece.pack() for piece in self.trajectory)))
        return True


class Memory:
    def get_mems(self, type):
        return [TrajectoryMemory()] if type == MemoryElement.TYPE_TRAJ else []
