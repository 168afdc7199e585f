# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""guided_sender_test.py SENDER: plays ArduPilot to port/ardupilot/guided_sender over a UDP socket. Compares every frame
of a flight with the same plan made through the Python package, and says what is sent when."""
import signal
import socket
import struct
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import tern

START, GOAL, HEADING = np.array([-2.0, 0.5, 1.5]), np.array([3.0, 0.5, 2.0]), 0.7  # east, north, up; from north
GUIDED, LOITER = 4, 5
EXTRA = {0: 50, 30: 39, 32: 185, 84: 143}


def checksum(data):
    crc = 0xFFFF
    for byte in data:
        t = byte ^ (crc & 0xFF)
        t ^= (t << 4) & 0xFF
        crc = (crc >> 8) ^ (t << 8) ^ (t << 3) ^ (t >> 4)
    return crc


def frame_of(message, payload):
    payload = payload.rstrip(b"\0") or b"\0"
    body = struct.pack("<BBBBBB", len(payload), 0, 0, 0, 1, 1) + message.to_bytes(3, "little") + payload
    return b"\xfd" + body + struct.pack("<H", checksum(body + bytes([EXTRA[message]])))


class Setpoint:
    def __init__(self, frame):
        body, (crc,) = frame[1:-2], struct.unpack("<H", frame[-2:])
        assert frame[0] == 0xFD and body[6:9] == b"\x54\0\0" and crc == checksum(body + bytes([EXTRA[84]]))
        fields = struct.unpack("<I11fHBBB", body[9:].ljust(53, b"\0"))
        self.sequence, self.time, self.numbers, self.rest = frame[4], fields[0], np.float32(fields[1:12]), fields[12:]
        self.position = np.array([self.numbers[1], self.numbers[0], -self.numbers[2]])
        self.velocity, self.acceleration = self.numbers[3:6], self.numbers[6:9]


class Vehicle:
    """The autopilot, and the sender that it talks to."""

    def __init__(self):
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.process = subprocess.Popen([sys.argv[1], str(self.port), *map(str, GOAL)], stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL, text=True)
        assert self.process.stdout.readline() == "listening\n"

    def send(self, message, payload):
        self.socket.sendto(frame_of(message, payload), ("127.0.0.1", self.port))

    def heartbeat(self, mode=GUIDED, armed=True, state=4, autopilot=3):
        self.send(0, struct.pack("<IBBBBB", mode, 2, autopilot, 128 if armed else 0, state, 3))

    def be_at(self, position, east_velocity=0.0):
        self.send(30, struct.pack("<I6f", 1000, 0, 0, HEADING, 0, 0, 0))
        self.send(32, struct.pack("<I6f", 1000, position[1], position[0], -position[2], 0, east_velocity, 0))

    def receive(self, seconds=1.0):
        self.socket.settimeout(seconds)
        try:
            return Setpoint(self.socket.recv(512))
        except TimeoutError:
            return None

    def begin(self, position=START):
        """Hovers until the sender has planned, and is there when it begins."""
        self.heartbeat()
        self.be_at(position)
        assert self.process.stdout.readline().startswith("plan of")
        self.be_at(position)

    def follow(self, count=None, jump=0.0):
        """The frames to come, `count` of them or all; the vehicle is where they say, or off by `jump`."""
        frames = []
        while count is None or len(frames) < count:
            frame = self.receive()
            if frame is None:
                break
            frames.append(frame)
            if len(frames) % 25 == 1:
                self.heartbeat()
            self.be_at(frame.position + [0.0, 0.0, jump])
        return frames


def expected_plan(start):
    grid = tern.Grid((-5, -10, -1), 0.2, (100, 100, 35), 0.3, ((-5, -10, 0.5), (15, 10, 6)), tracking_margin=0.3)
    grid.mark_box((4, -3, 0), (5, 3, 5))
    grid.inflate()
    limits = tern.Limits.from_ardupilot(wpnav_speed_m_s=3.0)
    plan = tern.Planner().plan(grid, start, GOAL, limits).trajectory
    heading = np.float32(HEADING).astype(float)
    return plan, tern.plan_yaw(plan, start=np.pi / 2 - heading, rate_max=1.0, acceleration_max=1.0)


def sends_nothing_until_it_is_ready():
    vehicle = Vehicle()
    vehicle.be_at(START)  # nobody knows the autopilot yet
    for heartbeat, speed in (({"autopilot": 8}, 0.0), ({"mode": LOITER}, 0.0), ({"armed": False}, 0.0),
                             ({"state": 3}, 0.0), ({}, 1.0)):
        for _ in range(3):
            vehicle.heartbeat(**heartbeat)
            vehicle.be_at(START, speed)
            assert vehicle.receive(0.15) is None, heartbeat
    vehicle.begin()
    spoilt = bytearray(frame_of(32, struct.pack("<I6f", 1000, 0, 0, 0, 0, 0, 0)))
    spoilt[12] ^= 1
    vehicle.socket.sendto(bytes(spoilt), ("127.0.0.1", vehicle.port))
    return vehicle


def compare_with_the_plan():
    vehicle = sends_nothing_until_it_is_ready()
    frames = vehicle.follow()
    assert vehicle.process.wait(10) == 0
    plan, yaw = expected_plan(np.float32(START).astype(float))
    for number, frame in enumerate(frames):
        expected = tern.setpoint_ned(plan, frame.time / 1000, yaw)
        assert frame.time == 20 * number and frame.sequence == number % 256 and frame.rest == (0, 1, 1, 1)
        numbers = [*expected.position, *expected.velocity, *expected.acceleration, expected.yaw, expected.yaw_rate]
        np.testing.assert_allclose(frame.numbers, np.float32(numbers), rtol=1e-6, atol=1e-6)
    rest = [frame for frame in frames if frame.time >= 1000 * plan.duration]
    assert len(rest) == 51, len(rest)  # a second at the goal, without velocity and acceleration
    for frame in rest:
        assert not frame.velocity.any() and not frame.acceleration.any()
        np.testing.assert_allclose(frame.position, GOAL, atol=1e-6)
    return f"{len(frames)} frames over {plan.duration:.2f} s and a second of hover, all as expected"


def plan_again_where_the_vehicle_has_moved():
    vehicle, moved = Vehicle(), START + [0.0, -0.6, 0.0]
    vehicle.heartbeat()
    vehicle.be_at(START)
    assert vehicle.process.stdout.readline().startswith("plan of")
    vehicle.be_at(moved)
    assert vehicle.process.stdout.readline() == "the vehicle has moved\n"
    vehicle.begin(moved)
    np.testing.assert_allclose(vehicle.follow()[0].position, moved, atol=1e-6)
    assert vehicle.process.wait(10) == 0


def fall_silent_outside_guided_mode():
    for heartbeat in ({"mode": LOITER}, {"armed": False}, {"state": 3}):
        vehicle = Vehicle()
        vehicle.begin()
        vehicle.follow(50)
        vehicle.heartbeat(**heartbeat)
        left = vehicle.follow()
        assert len(left) <= 3 and vehicle.process.wait(10) == 1


def expect_rest(vehicle, frames):
    """The frames come to rest, smoothly, and end a second later, short of the goal."""
    assert vehicle.process.wait(10) == 1
    speeds = np.array([np.linalg.norm(frame.velocity) for frame in frames])
    assert speeds[0] > 0.3 and not speeds[-50:].any() and (np.diff(speeds) < 0.1).all(), speeds
    assert np.linalg.norm(frames[-1].position - GOAL) > 0.3
    for a, b in zip(frames, frames[1:]):
        step = np.linalg.norm(b.position - a.position)
        assert step < 0.02 * max(np.linalg.norm(a.velocity), np.linalg.norm(b.velocity)) + 1e-3, step


def come_to_rest_when_interrupted():
    vehicle = Vehicle()
    vehicle.begin()
    vehicle.follow(70)
    vehicle.process.send_signal(signal.SIGTERM)
    expect_rest(vehicle, vehicle.follow())


def come_to_rest_without_telemetry():
    vehicle = Vehicle()
    vehicle.begin()
    vehicle.follow(30)
    expect_rest(vehicle, list(iter(vehicle.receive, None)))


def come_to_rest_where_the_vehicle_is_when_it_strays():
    vehicle = Vehicle()
    vehicle.begin()
    before = vehicle.follow(70)[-1]
    vehicle.be_at(before.position + [0.0, 0.0, 1.5])
    frames = vehicle.follow()
    late = [frame for frame in frames if np.linalg.norm(frame.position - before.position) > 1.0]
    assert len(frames) - len(late) <= 3 and abs(late[0].position[2] - before.position[2] - 1.5) < 0.2
    expect_rest(vehicle, late)


def refuse_words():
    for words in (["14600", "1O", "2", "2"], ["14600", "1", "2"], ["14600", "1", "2", ""]):
        assert subprocess.run([sys.argv[1], *words], stderr=subprocess.DEVNULL).returncode == 2


def main():
    cases = [compare_with_the_plan, plan_again_where_the_vehicle_has_moved, fall_silent_outside_guided_mode,
             come_to_rest_when_interrupted, come_to_rest_without_telemetry,
             come_to_rest_where_the_vehicle_is_when_it_strays, refuse_words]
    with ThreadPoolExecutor(len(cases)) as pool:
        for case, future in [(case, pool.submit(case)) for case in cases]:
            print(case.__name__.replace("_", " ") + ": " + (future.result() or "ok"))


main()
