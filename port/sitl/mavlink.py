# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The few messages of MAVLink 2 with which a script takes off and lands."""
import select
import socket
import struct

# number: (name, format, fields, the message's seed of the checksum)
_MESSAGES = {
    0: ("HEARTBEAT", "IBBBBB", "custom_mode type autopilot base_mode system_status mavlink_version", 50),
    31: ("ATTITUDE_QUATERNION", "I7f", "time_boot_ms q1 q2 q3 q4 rollspeed pitchspeed yawspeed", 246),
    32: ("LOCAL_POSITION_NED", "I6f", "time_boot_ms x y z vx vy vz", 185),
    76: ("COMMAND_LONG", "7fHBBB", "p1 p2 p3 p4 p5 p6 p7 command target_system target_component confirmation", 152),
    77: ("COMMAND_ACK", "HB", "command result", 143),
    253: ("STATUSTEXT", "B50s", "severity text", 83),
}
_NUMBERS = {entry[0]: number for number, entry in _MESSAGES.items()}
_GROUND_STATION = (255, 190)


def checksum(data):
    """CRC-16/MCRF4XX."""
    crc = 0xFFFF
    for byte in data:
        byte ^= crc & 0xFF
        byte ^= (byte << 4) & 0xFF
        crc = (crc >> 8) ^ (byte << 8) ^ (byte << 3) ^ (byte >> 4)
    return crc & 0xFFFF


def pack(name, sequence, **values):
    """A frame of a ground station. Fields that are not given are 0."""
    number = _NUMBERS[name]
    _, form, fields, seed = _MESSAGES[number]
    payload = struct.pack("<" + form, *(values.get(field, 0) for field in fields.split())).rstrip(b"\0") or b"\0"
    head = struct.pack("<BBBBBB", len(payload), 0, 0, sequence & 0xFF, *_GROUND_STATION) + number.to_bytes(3, "little")
    return b"\xfd" + head + payload + struct.pack("<H", checksum(head + payload + bytes([seed])))


def unpack(data):
    """[(component, name, {field: value})] of the frames in some bytes; what is unknown or spoilt is left out."""
    found = []
    at = data.find(b"\xfd")
    while 0 <= at and at + 12 <= len(data):
        length = data[at + 1]
        signed = 13 if data[at + 2] & 1 else 0
        head, payload = data[at + 1:at + 10], data[at + 10:at + 10 + length]
        end = at + 12 + length + signed
        entry = _MESSAGES.get(int.from_bytes(data[at + 7:at + 10], "little"))
        if entry is not None and end <= len(data):
            name, form, fields, seed = entry
            layout = struct.Struct("<" + form)
            if struct.unpack_from("<H", data, at + 10 + length)[0] == checksum(head + payload + bytes([seed])):
                values = layout.unpack(payload.ljust(layout.size, b"\0")[:layout.size])
                found.append((data[at + 6], name, dict(zip(fields.split(), values))))
        at = data.find(b"\xfd", end if end <= len(data) and entry is not None else at + 1)
    return found


class Link:
    """A UDP port at which an autopilot talks. `last` has the last message of each name."""

    def __init__(self):
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self._peer = None
        self._sequence = 0
        self._acks = {}
        self.port = self._socket.getsockname()[1]
        self.last = {}
        self.texts = []

    def send(self, name, **values):
        if self._peer is not None:
            self._sequence += 1
            self._socket.sendto(pack(name, self._sequence, **values), self._peer)

    def command(self, command, *parameters):
        """Asks for a command; forgets the answer to the last one of its number."""
        self._acks.pop(command, None)
        named = {f"p{k + 1}": value for k, value in enumerate(parameters)}
        self.send("COMMAND_LONG", command=command, target_system=1, target_component=1, **named)

    def answer(self, command):
        """The result of a command: 0 is accepted; None if there is none yet."""
        return self._acks.get(command)

    def listen(self, seconds):
        """Takes what comes within some seconds, at least once; returns after the first datagrams."""
        if not select.select([self._socket], [], [], seconds)[0]:
            return
        while select.select([self._socket], [], [], 0)[0]:
            data, self._peer = self._socket.recvfrom(4096)
            for component, name, values in unpack(data):
                if component != 1:  # an autopilot passes on what others say
                    continue
                self.last[name] = values
                if name == "COMMAND_ACK":
                    self._acks[values["command"]] = values["result"]
                if name == "STATUSTEXT":
                    self.texts.append(values["text"].rstrip(b"\0").decode("ascii", "replace"))
