# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The shared library: found, loaded and checked once, when the package is imported."""
import os
import pathlib

import numpy as np

from tern import _bindings

ffi = _bindings.ffi

NAME = "libtern_shared.so"
VERSIONED = "libtern_shared.so.0.1"


def _candidates():
    """TERN_LIBRARY, then the library beside this file, then what the system's loader finds."""
    if "TERN_LIBRARY" in os.environ:
        return [os.environ["TERN_LIBRARY"]]
    beside = pathlib.Path(__file__).with_name(NAME)
    return [str(beside)] if beside.exists() else [VERSIONED, NAME]


def _open():
    errors = []
    for name in _candidates():
        try:
            return ffi.dlopen(name)
        except OSError as error:
            errors.append(str(error))
    raise ImportError("tern: no shared library; build Tern with TERN_SHARED, or set TERN_LIBRARY to its path. " +
                      "; ".join(errors))


def _check(library):
    """The library must have the interface and the capacities of the bindings, and sound arithmetic."""
    if library.tern_abi() != library.PY_TERN_ABI:
        raise ImportError(f"tern: the library has ABI {library.tern_abi()}, the bindings {library.PY_TERN_ABI}")
    sizes = {library.TERN_SIZE_REQUEST: "tern_request", library.TERN_SIZE_TRAJECTORY: "tern_trajectory",
             library.TERN_SIZE_REPORT: "tern_report", library.TERN_SIZE_GRID_SPEC: "tern_grid_spec"}
    for what, name in sizes.items():
        if library.tern_size_of(what) != ffi.sizeof(name):
            raise ImportError(f"tern: {name} has {library.tern_size_of(what)} bytes in the library, "
                              f"{ffi.sizeof(name)} in the bindings")
    faults = ffi.new("uint32_t*")
    if library.tern_self_test(_bindings.HEADER_HASH, faults) != 0:
        raise ImportError(f"tern: the self-test failed, faults {faults[0]:#x} (docs/faults.md)")


lib = _open()
_check(lib)

HEADER_HASH = _bindings.HEADER_HASH


class TernError(ValueError):
    """A call was refused. `status` is the status's name, the message says what it means."""

    def __init__(self, status, detail=""):
        self.status = status_name(status)
        meaning = ffi.string(lib.tern_status_meaning(status)).decode()
        super().__init__(f"{self.status}: {meaning}" + (f" ({detail})" if detail else ""))


def status_name(status):
    """The name of a status's number."""
    return ffi.string(lib.tern_status_name(status)).decode()


def require(status, detail=""):
    """Raises TernError unless the status is ok."""
    if status != 0:
        raise TernError(status, detail)


def vector(values):
    """Three numbers for a tern_vec3."""
    x, y, z = (float(v) for v in values)
    return {"x": x, "y": y, "z": z}


def voxel(values):
    """Three integers for a tern_voxel."""
    x, y, z = (int(v) for v in values)
    return {"x": x, "y": y, "z": z}


def triple(v):
    """A tern_vec3 or tern_voxel as a tuple."""
    return (v.x, v.y, v.z)


def view(owner, dtype, count, *path):
    """A numpy view, without a copy, of `count` elements of a field of a structure that ffi.new() returned. `path`: the
    names that lead to the field. The array keeps the structure alive."""
    return np.frombuffer(ffi.buffer(owner), dtype, count, ffi.offsetof(ffi.typeof(owner).item, *path))


def words(count):
    """Uninitialised 64-bit words: the array, which the caller keeps, and a pointer into it."""
    memory = np.empty(count, dtype=np.uint64)
    return memory, ffi.cast("uint64_t*", memory.ctypes.data)


def points(array):
    """An (n, 3) array of doubles, contiguous, and a pointer to it as tern_vec3."""
    memory = np.ascontiguousarray(array, dtype=np.float64)
    if memory.ndim != 2 or memory.shape[1] != 3:
        raise ValueError(f"points must have the shape (n, 3), not {memory.shape}")
    return memory, ffi.cast("tern_vec3*", memory.ctypes.data)
