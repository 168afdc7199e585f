# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads what PX4 and ArduPilot log: ULog and DataFlash. Both describe their own records, so this needs no package.
A log that ends in the middle of a record, as after a crash, is read up to there."""
import struct

_ULOG_MAGIC = b"ULog\x01\x125"
_ULOG_TYPES = {"int8_t": "b", "uint8_t": "B", "int16_t": "h", "uint16_t": "H", "int32_t": "i", "uint32_t": "I",
               "int64_t": "q", "uint64_t": "Q", "float": "f", "double": "d", "bool": "?", "char": "c"}
_DATAFLASH_MAGIC = b"\xa3\x95"
_DATAFLASH_FORMAT = 128
# Format, and what a number is multiplied by.
_DATAFLASH_TYPES = {"b": ("b", None), "B": ("B", None), "h": ("h", None), "H": ("H", None), "i": ("i", None),
                    "I": ("I", None), "f": ("f", None), "d": ("d", None), "g": ("e", None), "q": ("q", None),
                    "Q": ("Q", None), "c": ("h", 0.01), "C": ("H", 0.01), "e": ("i", 0.01), "E": ("I", 0.01),
                    "L": ("i", 1e-7), "M": ("B", None), "n": ("4s", None), "N": ("16s", None), "Z": ("64s", None),
                    "a": ("64s", None)}


class LogError(Exception):
    """A file that is no log, or lacks something."""


def read_log(path, wanted):
    """{name: [{field: value}]} of the records with the names `wanted`, in the order of the file. Of topics with several
    instances, the first. Fields of arrays are named as in `position[0]`."""
    with open(path, "rb") as file:
        data = file.read()
    if data.startswith(_ULOG_MAGIC):
        return _read_ulog(data, wanted)
    if data.startswith(_DATAFLASH_MAGIC):
        return _read_dataflash(data, wanted)
    raise LogError(f"{path}: neither a ULog nor a DataFlash log")


def _ulog_fields(formats, name, prefix=""):
    """[(field, character of struct)] of a format, with the formats in it."""
    fields = []
    for text in filter(None, formats[name].split(";")):
        kind, field = text.split(" ")
        kind, _, count = kind.partition("[")
        for k in range(int(count[:-1])) if count else [None]:
            label = prefix + field if k is None else f"{prefix}{field}[{k}]"
            if kind in _ULOG_TYPES:
                fields.append((label, _ULOG_TYPES[kind]))
            else:
                fields += _ulog_fields(formats, kind, label + ".")
    return fields


def _read_ulog(data, wanted):
    formats, layouts, records = {}, {}, {name: [] for name in wanted}
    at = 16
    while at + 3 <= len(data):
        size, kind = struct.unpack_from("<HB", data, at)
        body = data[at + 3:at + 3 + size]
        at += 3 + size
        if len(body) < size:
            break
        if kind == ord("F"):
            name, _, fields = body.decode("ascii").partition(":")
            formats[name] = fields
        elif kind == ord("A"):
            instance, number = struct.unpack_from("<BH", body)
            name = body[3:].decode("ascii")
            if name in records and instance == 0:
                fields = _ulog_fields(formats, name)
                layouts[number] = (name, [f for f, _ in fields], struct.Struct("<" + "".join(c for _, c in fields)))
        elif kind == ord("D") and struct.unpack_from("<H", body)[0] in layouts:
            name, labels, layout = layouts[struct.unpack_from("<H", body)[0]]
            values = layout.unpack(body[2:].ljust(layout.size, b"\0")[:layout.size])  # padding at the end is left out
            records[name].append(dict(zip(labels, values)))
    return records


def _read_dataflash(data, wanted):
    lengths, layouts, records = {_DATAFLASH_FORMAT: 89}, {}, {name: [] for name in wanted}
    at = 0
    while at + 3 <= len(data):
        length = lengths.get(data[at + 2])
        if data[at:at + 2] != _DATAFLASH_MAGIC or length is None:
            at = data.find(_DATAFLASH_MAGIC, at + 1)
            if at < 0:
                break
            continue
        kind, body = data[at + 2], data[at + 3:at + length]
        at += length
        if len(body) < length - 3:
            break
        if kind == _DATAFLASH_FORMAT:
            number, size, name, form, labels = struct.unpack("<BB4s16s64s", body)
            name, form, labels = (text.rstrip(b"\0").decode("ascii", "replace") for text in (name, form, labels))
            lengths[number] = max(size, 3)
            if name in records and all(c in _DATAFLASH_TYPES for c in form):
                layout = struct.Struct("<" + "".join(_DATAFLASH_TYPES[c][0] for c in form))
                layouts[number] = (name, labels.split(","), [_DATAFLASH_TYPES[c][1] for c in form], layout)
        elif kind in layouts:
            name, labels, scales, layout = layouts[kind]
            values = layout.unpack(body[:layout.size])
            records[name].append({label: value if scale is None else scale * value
                                  for label, value, scale in zip(labels, values, scales)})
    return records
