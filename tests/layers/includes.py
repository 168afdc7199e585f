#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""includes.py ROOT: fails where a stage of the core includes one to its right in the data flow, qp includes any stage,
a file of the core includes a header that the core must not know, or a public header one of the C++ library."""
import pathlib
import re
import sys

ORDER = ["base", "grid", "inflation", "view", "map", "world", "search", "guide", "path", "ellipsoid", "corridor",
         "curve", "yaw", "times", "qp", "trajectory", "check", "proof", "planner", "flight", "record"]
# check shares nothing with the stages that it checks; qp knows nothing of trajectories.
NARROW = {"qp": {"base", "qp"}, "check": {"base", "grid", "check"},
          "proof": {"base", "grid", "proof"}, "record": {"base", "grid", "flight", "record"}}
# From the standard library the core takes types and placement, nothing that runs.
SYSTEM = {"cstddef", "cstdint", "new", "stddef.h", "stdint.h", "stdbool.h", "Eigen/Core"}
# The users of a public header may have no C++ library at all, as modules of NuttX.
PUBLIC = {"stddef.h", "stdint.h", "stdbool.h"}


def allowed(stage):
    return NARROW.get(stage, set(ORDER[: ORDER.index(stage) + 1]))


def problems(path, stage):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if not match:
            continue
        name = match.group(2)
        if match.group(1) == "<":
            if name not in (PUBLIC if stage is None else SYSTEM):
                yield f"{path}:{number}: <{name}> is not for {'a public header' if stage is None else 'the core'}"
        elif not name.startswith("tern/"):
            other = name.split("/")[0]
            if stage is None or other not in allowed(stage):
                yield f"{path}:{number}: {stage or 'a public header'} must not include {name}"


def main():
    core = pathlib.Path(sys.argv[1]) / "core"
    found, files = [], 0
    for path in sorted(core.rglob("*.[ch]*")):
        if path.suffix not in (".h", ".hpp", ".cpp"):
            continue
        inside = path.relative_to(core).parts
        stage = inside[1] if inside[0] == "src" else None
        found += problems(path, stage)
        files += 1
    print("\n".join(found) or f"{files} files include only what is left of them")
    return 1 if found or files == 0 else 0


sys.exit(main())
