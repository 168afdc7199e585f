#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""flight_report_test.py SITL FOLDER: port/sitl/flight_report.py on logs that this test writes into FOLDER."""
import math
import os
import struct
import subprocess
import sys

from log_writers import ARDUPILOT, PX4, dataflash, ulog
from script_run import expect

sitl, folder = sys.argv[1:3]
sys.path.insert(0, sitl)
import flight_log  # noqa: E402
import flight_report  # noqa: E402

os.makedirs(folder, exist_ok=True)


def write(name, content):
    path = os.path.join(folder, name)
    with open(path, "wb") as file:
        file.write(content)
    return path


def near(value, wanted, tolerance, what):
    expect(abs(value - wanted) <= tolerance, f"{what}: {value}, and not {wanted}")


def circle(t):
    """The plan, north, east, down and its velocity: a circle of 5 m in 10 s."""
    w = 2 * math.pi / 10
    return [5 * math.sin(w * t), 5 * math.cos(w * t), -2.0], [5 * w * math.cos(w * t), -5 * w * math.sin(w * t), 0.0]


def px4_log(end=13.0):
    """Offboard twice, from 1 to 2 s and from 3 to 12 s. The estimate is 0.3 m east of the plan, in the first flight
    2 m, the truth 0.1 m north of the estimate."""
    records = []
    for k in range(int(100 * end)):
        t, us = 0.01 * k, 10000 * k
        if k % 50 == 0:
            offboard = 1 <= t < 2 or 3 <= t < 12
            records.append(("vehicle_status", 0, (us, 2, 14 if offboard else 4)))
        place, velocity = circle(t)
        if k % 20 == 0:
            inside = 1 <= t < 2 or 3 <= t < 12
            wanted = place if inside else [9.0, 9.0, 9.0]  # PX4's own
            records.append(("trajectory_setpoint", 0, (us, *wanted, *velocity, *[0.0] * 8)))
        place, velocity = circle(t + 0.003)
        east = place[1] + (0.3 if t > 2.5 else 2.0)
        if k % 2 == 0:
            records.append(("vehicle_local_position", 0, (us + 3000, place[0], east, place[2], *velocity, 1)))
            records.append(("vehicle_local_position", 1, (us + 3000, 77.0, 77.0, 77.0, *velocity, 1)))
            records.append(("vehicle_local_position_groundtruth", 0,
                            (us + 3000, place[0] + 0.1, east, place[2], *velocity, 1)))
    return ulog(PX4, records)


def ardupilot_log():
    """Guided from 3 to 12 s. Along north with 1 m/s, 2 m up; 0.2 m below, and the truth 0.4 m east."""
    records = [("MODE", (0, 5, 5, 1)), ("TEST", (1, 150, 250, -350, 450, 473977418, -3, 7))]
    for k in range(130):
        us = 100000 * k
        if us in (3000000, 12000000):
            records.append(("MODE", (us, 4 if us == 3000000 else 5, 4 if us == 3000000 else 5, 2)))
        for axis, desired, actual in (("N", 0.1 * k, 0.1 * k), ("E", 1.0, 1.0), ("D", -2.0, -1.8)):
            records.append(("PSC" + axis, (us, desired, 99.0, actual, 0.0)))
        records.append(("SIM2", (us, 0.1 * k, 1.4, -1.8, 0.0, 0.0, 0.0)))
    return dataflash(ARDUPILOT, records)


# The block begins 8 m north, and the vehicle is never further north than 5.1 m. It passes there at 2.5 s and 12.5 s,
# just outside the flight: the least distance is at the flight's last sample.
MAP = write("map.txt", b"boundary -9 -9 0 9 99 9\nradius 0.25 # of the body\nblock -9 8 0 9 9 5 120 120 120\n")
PX4_LOG = write("px4.ulg", px4_log())
flight = flight_report.flight_of_ulog(PX4_LOG)
near(flight.begin, 3.0, 1e-6, "begin")
near(flight.end, 12.0, 1e-6, "end")
found = flight_report.errors(flight)
expect(len(found) > 420, f"samples: {len(found)}")
near(max(found), 0.3, 2e-3, "largest error")  # cubics over 0.2 s of the circle are 1e-4 m off
near(min(found), 0.3, 2e-3, "least error")
near(max(flight_report.drifts(flight)), 0.1, 1e-5, "drift")
blocks, radius = flight_report.read_map(MAP)
north = max(circle(t)[0][0] for t in (3.003, 11.983)) + 0.1
near(flight_report.clearance(flight, blocks), 8.0 - north, 1e-5, "clearance")
near(flight_report.distance_to(([0, 0, 0], [1, 1, 1]), [4, 5, 0.5]), 5.0, 1e-12, "distance")
near(flight_report.distance_to(([0, 0, 0], [1, 1, 1]), [0.5, 0.5, 0.5]), 0.0, 0.0, "distance inside")

log = flight_log.read_log(PX4_LOG, ["vehicle_local_position"])["vehicle_local_position"]
expect(len(log) == 650 and all(record["x"] < 70 for record in log), "the second instance was read")
expect(log[0]["timestamp"] == 3000 and log[0]["xy_valid"] is True, "fields of a topic")
cut = flight_log.read_log(write("cut.ulg", px4_log()[:-5000]), ["vehicle_local_position"])["vehicle_local_position"]
expect(600 < len(cut) < 650, "a log that was cut")

ARDUPILOT_LOG = write("00000001.BIN", ardupilot_log())
flight = flight_report.flight_of_dataflash(ARDUPILOT_LOG)
near(flight.begin, 3.0, 1e-9, "begin")
near(flight.end, 12.0, 1e-9, "end")
found = flight_report.errors(flight)
expect(len(found) == 91, f"samples: {len(found)}")
near(max(found), 0.2, 1e-6, "largest error")
near(max(flight_report.drifts(flight)), 0.4, 1e-6, "drift")
near(flight_report.clearance(flight, blocks), 0.0, 0.0, "clearance within the block")
test = flight_log.read_log(ARDUPILOT_LOG, ["TEST"])["TEST"][0]
expect(test == {"TimeUS": 1, "a": 1.5, "b": 2.5, "c": -3.5, "d": 4.5, "Lat": 473977418 * 1e-7, "e": -3, "f": 7},
       str(test))
garbage = ardupilot_log().replace(b"\xa3\x95\xa1", b"?\xa3\x95\xffx\xa3\x95\xa1", 3)
found = flight_report.errors(flight_report.flight_of_dataflash(write("garbage.BIN", garbage)))
near(max(found), 0.2, 1e-6, "largest error among garbage")


def run(*arguments):
    done = subprocess.run([sys.executable, os.path.join(sitl, "flight_report.py"), *arguments], capture_output=True,
                          text=True, check=False)
    return done.returncode, done.stdout + done.stderr


status, said = run(PX4_LOG, "--map", MAP)
expect(status == 0, said)
for line in ("flight     9.0 s in offboard", "error      largest 0.30 m, mean 0.30 m", "estimate   largest 0.10 m off",
             f"clearance  {8 - north:.2f} m from the blocks to the vehicle's centre, {7.75 - north:.2f} m to its body"):
    expect(line in said, f"'{line}' is not in:\n{said}")
status, said = run(ARDUPILOT_LOG)
expect(status == 0 and "9.0 s in guided" in said and "largest 0.20 m" in said and "clearance" not in said, said)
BAD_MAP = write("bad.txt", b"block 1 2 3\n")
NO_FLIGHT = write("none.ulg", ulog(PX4, [("vehicle_status", 0, (1, 2, 4))]))
NO_PSC = write("none.BIN", dataflash(ARDUPILOT, [("MODE", (1, 4, 4, 1))]))
NEVER_GUIDED = write("never.BIN", ardupilot_log().replace(struct.pack("<QBBB", 3000000, 4, 4, 2),
                                                         struct.pack("<QBBB", 3000000, 5, 5, 2)))
for arguments, text in (((os.path.join(folder, "nowhere.ulg"),), "No such file"), ((MAP,), "neither a ULog nor"),
                        ((PX4_LOG, "--map", BAD_MAP), "bad.txt:1: 'block' lacks numbers"),
                        ((NO_FLIGHT,), "not in offboard"), ((NO_PSC,), "no PSCN records"),
                        ((NEVER_GUIDED,), "not in guided mode")):
    status, said = run(*arguments)
    expect(status != 0 and text in said and "Traceback" not in said, f"{arguments}: {status}, {said}")
print("flight_report_test: ok")
