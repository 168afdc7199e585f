#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""bindings.py CC OUTPUT OPTION...: writes the Python module OUTPUT that declares Tern's C interface to cffi. The
declarations are those of the C headers, run through the preprocessor with the library's own include folders and
definitions. So they have its capacities, and no second copy of the interface can fall behind."""
import pathlib
import re
import subprocess
import sys
import tempfile

import cffi

# These include the others.
HEADERS = ["tern/tern_corridor.h", "tern/tern_far_way.h", "tern/tern_record.h", "tern_stacks/stacks.h"]
EMPTY = ["stddef.h", "stdint.h", "stdbool.h"]  # cffi knows their types
CONSTANTS = ["TERN_ABI", "TERN_MAX_SEGMENTS", "TERN_MAX_PLANES", "TERN_MAVLINK_SETPOINT_BYTES",
             "TERN_CRAZYFLIE_PIECES"]
INLINE = re.compile(r"^static inline .*?^\}", re.MULTILINE | re.DOTALL)
CAPACITIES = re.compile(r"const uint64_t values\[\] = \{(.*?)\};", re.DOTALL)


def preprocessed(compiler, options):
    text = "".join(f'#include "{header}"\n' for header in HEADERS)
    text += "enum { " + ", ".join(f"PY_{name} = {name}" for name in CONSTANTS) + " };\n"
    text += "enum { PY_CRAZYFLIE_BYTES = TERN_CRAZYFLIE_COMPRESSED_BYTES(TERN_MAX_SEGMENTS) };\n"
    with tempfile.TemporaryDirectory() as empty:
        for name in EMPTY:
            pathlib.Path(empty, name).touch()
        command = [compiler, "-E", "-P", "-std=c99", "-nostdinc", f"-I{empty}", *options, "-"]
        return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout


def header_hash(text):
    """What tern_header_hash() returns in a C program with these headers."""
    value = 0xCBF29CE484222325
    for capacity in CAPACITIES.search(text).group(1).split(","):
        expression = re.sub(r"\b(0x[0-9a-f]+|\d+)u\b", r"\1", " ".join(capacity.split()))
        value = (value ^ int(eval(expression, {"__builtins__": {}}))) * 0x100000001B3 % 2**64  # integers and products
    return value


def main():
    compiler, output, *options = sys.argv[1:]
    text = preprocessed(compiler, options)
    ffi = cffi.FFI()
    ffi.cdef(INLINE.sub("", text))
    ffi.set_source(pathlib.Path(output).stem, None)
    ffi.emit_python_code(output)
    with open(output, "a", encoding="utf-8") as module:
        module.write(f"HEADER_HASH = {header_hash(text):#x}\n")


main()
