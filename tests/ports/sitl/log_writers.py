# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes logs as PX4 and ArduPilot do, from their descriptions of the formats: for tests of what reads them."""
import struct


def _ulog(kind, body):
    return struct.pack("<HB", len(body), ord(kind)) + body


def ulog(formats, records):
    """`formats`: {topic: (text, struct)}. `records`: (topic, instance, values) in order. A field named _padding0 at the
    end of a topic is described, and left out of its data, as PX4 does."""
    out = b"ULog\x01\x125" + bytes([1]) + struct.pack("<Q", 1000)
    out += _ulog("B", bytes(40))
    for name, (text, _) in formats.items():
        out += _ulog("F", f"{name}:{text}".encode())
    out += _ulog("I", bytes([8]) + b"char[4] x" + b"some")
    numbers = {}
    for name, instance, values in records:
        if (name, instance) not in numbers:
            numbers[name, instance] = len(numbers) + 3
            out += _ulog("A", struct.pack("<BH", instance, numbers[name, instance]) + name.encode())
        out += _ulog("D", struct.pack("<H", numbers[name, instance]) + struct.pack("<" + formats[name][1], *values))
    return out + _ulog("L", struct.pack("<BQ", 54, 5) + b"the end")


def dataflash(formats, records):
    """`formats`: {name: (number, characters, labels, struct)}. `records`: (name, values) in order."""
    out = b""

    def describe(number, name, characters, labels, length):
        return (b"\xa3\x95\x80" + struct.pack("<BB4s16s64s", number, length, name.encode(), characters.encode(),
                                              labels.encode()))

    out += describe(128, "FMT", "BBnNZ", "Type,Length,Name,Format,Columns", 89)
    for name, (number, characters, labels, layout) in formats.items():
        out += describe(number, name, characters, labels, 3 + struct.calcsize("<" + layout))
    for name, values in records:
        number, _, _, layout = formats[name]
        out += b"\xa3\x95" + bytes([number]) + struct.pack("<" + layout, *values)
    return out


STATUS = "uint64_t timestamp;uint8_t arming_state;uint8_t nav_state;uint8_t[6] _padding0"
SETPOINT = ("uint64_t timestamp;float[3] position;float[3] velocity;float[3] acceleration;float[3] jerk;float yaw;"
            "float yawspeed")
POSITION = "uint64_t timestamp;float x;float y;float z;float vx;float vy;float vz;bool xy_valid;uint8_t[7] _padding0"
PX4 = {"vehicle_status": (STATUS, "QBB"), "trajectory_setpoint": (SETPOINT, "Q14f"),
       "vehicle_local_position": (POSITION, "Q6fB"), "vehicle_local_position_groundtruth": (POSITION, "Q6fB")}
ARDUPILOT = {"MODE": (160, "QMBB", "TimeUS,Mode,ModeNum,Rsn", "QBBB"),
             "PSCN": (161, "Qffff", "TimeUS,DPN,TPN,PN,DVN", "Qffff"),
             "PSCE": (162, "Qffff", "TimeUS,DPE,TPE,PE,DVE", "Qffff"),
             "PSCD": (163, "Qffff", "TimeUS,DPD,TPD,PD,DVD", "Qffff"),
             "SIM2": (164, "Qdddfff", "TimeUS,PN,PE,PD,VN,VE,VD", "Qdddfff"),
             "TEST": (165, "QcCeELbh", "TimeUS,a,b,c,d,Lat,e,f", "QhHiIibh")}
