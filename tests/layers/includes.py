#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""includes.py ROOT: fails where a stage of the core includes one to its right in the data flow, qp includes any stage,
the certifier a header that the stages that it judges have, too, a file of the core one that the core must not know, or
a public header one of the C++ library. With --self-test: whether it finds that."""
import pathlib
import re
import sys

ORDER = ["base", "grid", "inflation", "view", "map", "world", "search", "guide", "path", "ellipsoid", "corridor",
         "curve", "tracks", "flood", "yaw", "times", "qp", "trajectory", "prove", "planner", "lookout", "flight", "record",
         "fleet"]
# qp knows nothing of trajectories, and a fleet nothing of how plans are made.
NARROW = {"qp": {"base", "qp"}, "record": {"base", "grid", "flight", "record"},
          "fleet": {"base", "fleet"}}
# The certifier shares nothing with what it judges but these, header by header: arithmetic, the rows of the grid's
# words, what every stage is sliced by, and the refusal of fences that are none.
CERTIFIER = {"base/math.hpp", "base/double_double.hpp", "base/triple.hpp", "base/work.hpp", "base/progress.hpp",
             "base/capacity.hpp", "base/fence_fault.hpp", "base/track_fault.hpp", "grid/bit_rows.hpp"}
# From the standard library the core takes types and placement, nothing that runs.
SYSTEM = {"cstddef", "cstdint", "new", "stddef.h", "stdint.h", "stdbool.h", "Eigen/Core"}
# The users of a public header may have no C++ library at all, as modules of NuttX.
PUBLIC = {"stddef.h", "stdint.h", "stdbool.h"}


def may_include(stage, name):
    other = name.split("/")[0]
    if stage is None:
        return False
    if stage == "prove":
        return other == stage or name in CERTIFIER
    return other in NARROW.get(stage, set(ORDER[: ORDER.index(stage) + 1]))


def problems(path, stage, text):
    for number, line in enumerate(text.splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if not match:
            continue
        name = match.group(2)
        if match.group(1) == "<":
            if name not in (PUBLIC if stage is None else SYSTEM):
                yield f"{path}:{number}: <{name}> is not for {'a public header' if stage is None else 'the core'}"
        elif not name.startswith("tern/") and not may_include(stage, name):
            yield f"{path}:{number}: {stage or 'a public header'} must not include {name}"


def self_test():
    """Includes that each stage may not have, and some that it may."""
    wrong = {"prove": ["base/bounds.hpp", "base/polyhedron.hpp", "base/linear.hpp", "grid/lattice.hpp", "curve/bezier.hpp",
                       "world/world.hpp", "planner/pipeline.hpp"],
             "qp": ["grid/bit_rows.hpp"], "grid": ["prove/proof.hpp"], None: ["base/math.hpp"]}
    right = {"prove": ["base/math.hpp", "prove/solid.hpp", "tern/grid.hpp"], "planner": ["prove/check_stage.hpp"]}
    missed = [(stage, name) for stage, names in wrong.items() for name in names
              if not list(problems("file", stage, f'#include "{name}"'))]
    accused = [(stage, name) for stage, names in right.items() for name in names
               if list(problems("file", stage, f'#include "{name}"'))]
    print(f"missed: {missed}, wrongly accused: {accused}")
    return 1 if missed or accused else 0


def main():
    if sys.argv[1] == "--self-test":
        return self_test()
    core = pathlib.Path(sys.argv[1]) / "core"
    found, files = [], 0
    for path in sorted(core.rglob("*.[ch]*")):
        if path.suffix not in (".h", ".hpp", ".cpp"):
            continue
        inside = path.relative_to(core).parts
        stage = inside[1] if inside[0] == "src" else None
        found += problems(path, stage, path.read_text())
        files += 1
    print("\n".join(found) or f"{files} files include only what is left of them")
    return 1 if found or files == 0 else 0


sys.exit(main())
