# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""guided_sender_test.py SENDER: plays ArduPilot to port/ardupilot/guided_sender over a UDP socket, and compares every
frame that it sends with the same plan made through the Python package."""
import socket
import struct
import subprocess
import sys

import numpy as np
import tern

START, GOAL = (-2.0, 0.5, 1.5), (3.0, 0.5, 2.0)
EXTRA = {32: 185, 84: 143}


def checksum(data):
    crc = 0xFFFF
    for byte in data:
        t = byte ^ (crc & 0xFF)
        t ^= (t << 4) & 0xFF
        crc = (crc >> 8) ^ (t << 8) ^ (t << 3) ^ (t >> 4)
    return crc


def frame_of(message, payload, sequence=0):
    body = struct.pack("<BBBBBB", len(payload), 0, 0, sequence, 1, 1) + message.to_bytes(3, "little") + payload
    return b"\xfd" + body + struct.pack("<H", checksum(body + bytes([EXTRA[message]])))


def read_setpoint(frame):
    body, (crc,) = frame[1:-2], struct.unpack("<H", frame[-2:])
    assert frame[0] == 0xFD and body[6:9] == b"\x54\0\0" and crc == checksum(body + bytes([EXTRA[84]]))
    fields = struct.unpack("<I11fHBBB", body[9:].ljust(53, b"\0"))
    return frame[4], fields[0], np.float32(fields[1:12]), fields[12:]


def expected_plan():
    grid = tern.Grid((-5, -10, -1), 0.2, (100, 100, 35), 0.3, ((-5, -10, 0.5), (15, 10, 6)), tracking_margin=0.3)
    grid.mark_box((4, -3, 0), (5, 3, 5))
    grid.inflate()
    plan = tern.Planner().plan(grid, START, GOAL, tern.Limits.from_ardupilot(wpnav_speed_m_s=3.0)).trajectory
    return plan, tern.plan_yaw(plan, rate_max=1.0, acceleration_max=1.0)


def fly(sender):
    """Sends positions until the sender answers, then reads its stream."""
    vehicle = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    vehicle.bind(("127.0.0.1", 0))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    process = subprocess.Popen([sender, str(port), *map(str, GOAL)], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "listening\n"
    position = struct.pack("<I6f", 1000, START[1], START[0], -START[2], 0, 0, 0)
    spoilt = bytearray(frame_of(32, position))
    spoilt[12] ^= 1
    for frame in (b"\xfd", bytes(spoilt), frame_of(32, position.rstrip(b"\0"))):
        vehicle.sendto(frame, ("127.0.0.1", port))
    vehicle.settimeout(60)
    frames = [read_setpoint(vehicle.recv(512))]
    while process.poll() is None or frames[-1][1] % 20 != 0:
        vehicle.settimeout(1)
        try:
            frames.append(read_setpoint(vehicle.recv(512)))
        except TimeoutError:
            break
    assert process.wait(60) == 0
    return frames


def main():
    plan, yaw = expected_plan()
    frames = fly(sys.argv[1])
    assert [frame[1] for frame in frames] == list(range(0, int(1000 * plan.duration) + 1001, 20))
    for number, (sequence, time, numbers, rest) in enumerate(frames):
        setpoint = tern.setpoint_ned(plan, time / 1000, yaw)
        assert sequence == number % 256 and rest == (0, 1, 1, 1), (sequence, rest)
        np.testing.assert_array_equal(numbers, np.float32([*setpoint.position, *setpoint.velocity, *setpoint.acceleration,
                                                           setpoint.yaw, setpoint.yaw_rate]))
    print(f"{len(frames)} frames over {plan.duration:.2f} s and a second of hover, all as expected")


main()
