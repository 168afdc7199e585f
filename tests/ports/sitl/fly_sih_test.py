#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""fly_sih_test.py FLY_SIH FOLDER: port/px4/fly_sih with a stand-in for a tree of PX4 in FOLDER and for the build tools:
what it calls in what order, what it prints, and what it says when something is wrong."""
import os
import shutil
import sys

from script_run import expect, run, write

script, folder = os.path.realpath(sys.argv[1]), os.path.realpath(sys.argv[2])
here = os.path.dirname(os.path.realpath(__file__))
shutil.rmtree(folder, ignore_errors=True)
tree, tools, build = (os.path.join(folder, name) for name in ("PX4", "tools", "PX4/build/px4_sitl_default"))
for path in (tools, os.path.join(tree, "ROMFS"), os.path.join(tree, "src/modules/logger")):
    os.makedirs(path)
COMMANDS = ["px4", "px4-param", "px4-commander", "px4-listener", "px4-shutdown", "px4-tern_offboard"]

write(os.path.join(tree, "Makefile"), "")
write(os.path.join(tools, "cmake"), f"#!/bin/sh\necho cmake \"$@\" >>{folder}/built\n")
write(os.path.join(tools, "make"), f"""#!/bin/sh
echo make "$@" "$TERN_PREFIX" >>{folder}/built
mkdir -p build/px4_sitl_default/bin build/px4_sitl_default/etc
cd build/px4_sitl_default/bin
for name in {' '.join(COMMANDS)}; do ln -sf {here}/fake_px4.py "$name"; done
[ "$FAKE_PX4" != "old build" ] || rm px4-tern_offboard
[ "$FAKE_PX4" != "no build" ] || {{ echo "error: no Eigen"; exit 1; }}
""")
for tool in ("g++", "ninja"):
    write(os.path.join(tools, tool), "#!/bin/sh\n")


def fly(*arguments, wrong="", path=None):
    return run(script, arguments, folder, path or tools + ":" + os.environ["PATH"],
               {"FAKE_PX4": wrong, "FAKE_PX4_WRITERS": here})


status, said = fly(tree, "--parameter", "MPC_XY_VEL_MAX=9")
expect(status == 0, said)
for line in ("flight     6.0 s in offboard", "error      largest 0.50 m, mean 0.50 m",
             "clearance  0.00 m from the blocks to the vehicle's centre"):  # the fake flies through the block
    expect(line in said, f"'{line}' is not in:\n{said}")
with open(os.path.join(folder, "built"), encoding="utf-8") as built:
    lines = built.read().splitlines()
expect([line.split()[:2] for line in lines] == [["cmake", "-S"], ["cmake", "--build"], ["cmake", "--install"],
                                                ["make", "px4_sitl_default"]], str(lines))
expect(lines[3].endswith(f"LOCATION={os.path.dirname(script)} {folder}/fly_sih/tern-install"), lines[3])
with open(os.path.join(build, "bin/calls"), encoding="utf-8") as called:
    calls = called.read().splitlines()
world = os.path.join(os.path.dirname(script), "world.txt")
order = ["param set NAV_DLL_ACT 0", "param set MPC_XY_VEL_MAX 9", "commander check", "commander takeoff",
         f"tern_offboard start 10.0 2.0 2.0 {world} blind", "commander mode offboard", "commander mode auto:loiter",
         "commander land", "shutdown"]
at = [calls.index(call) for call in order]
expect(at == sorted(at), str(calls))

for arguments, wrong, text in (
        ((folder,), "", "is no tree of PX4: it has no Makefile"),
        ((tree, "--goal", "1,2"), "", "write EAST,NORTH,UP"),
        ((tree, "--map", "nowhere.txt"), "", "nowhere.txt: no such file"),
        ((tree,), "no build", "build PX4 failed. The end of"),
        ((tree,), "old build", "was configured without the module. Remove that folder"),
        ((tree,), "ends", "it ended with status 3"),
        ((tree, "--parameter", "NO_SUCH=1"), "", "param set NO_SUCH 1 failed: ERROR [param]"),
        ((tree,), "refused", "the module said: ERROR [tern_offboard] no flight from here: start_occupied"),
        ((tree,), "no log", "PX4 wrote no log below")):
    shutil.rmtree(os.path.join(folder, "fly_sih"), ignore_errors=True)
    status, said = fly(*arguments, wrong=wrong)
    expect(status != 0 and text in said, f"{arguments} {wrong}: {status}, {said}")
status, said = fly(tree, path=os.path.dirname(sys.executable) + "-nothing")
expect(status != 0 and "missing: cmake (3.16 or later), make" in said, said)
print("fly_sih_test: ok")
