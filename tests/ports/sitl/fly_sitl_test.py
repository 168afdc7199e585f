#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""fly_sitl_test.py FLY_SITL FOLDER FAKE_ARDUCOPTER COMPANION: port/ardupilot/fly_sitl with a stand-in for a tree of
ArduPilot in FOLDER and for the build tools, and with the real tern_companion, which flies round a block that only the
simulated camera shows it."""
import os
import re
import shutil
import sys

script, folder, copter, companion = map(os.path.realpath, sys.argv[1:5])
here = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(script), "..", "sitl"))
import mavlink  # noqa: E402
from script_run import expect, run, write  # noqa: E402

shutil.rmtree(folder, ignore_errors=True)
tree, tools = os.path.join(folder, "ardupilot"), os.path.join(folder, "tools")
for path in (tools, os.path.join(tree, "ArduCopter"), os.path.join(tree, "Tools/autotest/default_params")):
    os.makedirs(path)

write(os.path.join(tree, "Tools/autotest/default_params/copter.parm"), "FRAME_CLASS 1\n")
write(os.path.join(tree, "waf"), f"""#!/bin/sh
echo waf "$@" >>{folder}/built
mkdir -p build/sitl/bin && ln -sf {here}/fake_arducopter.py build/sitl/bin/arducopter
""")
write(os.path.join(tools, "cmake"), f"""#!/bin/sh
echo cmake "$@" >>{folder}/built
[ "$FAKE_WRONG" != "no build" ] || {{ echo "error: no Eigen"; exit 1; }}
mkdir -p fly_sitl/tern/port/companion && ln -sf {companion} fly_sitl/tern/port/companion/tern_companion
""")
write(os.path.join(tools, "g++"), "#!/bin/sh\n")
# In the way from (0, 0, 2) to (7, 0, 2).
MAP = write(os.path.join(folder, "map.txt"), """boundary -9 -9 0 20 9 5
block 3.5 -1 0 4 0.8 4
radius 0.3
tracking_margin 0.3
v_horizontal 2
""")


def fly(*arguments, wrong="", path=None):
    return run(script, arguments, folder, path or tools + ":" + os.environ["PATH"],
               {"FAKE_WRONG": wrong, "FAKE_ARDUCOPTER": copter})


# The checksum of MAVLink's own documentation, and a frame that is spoilt.
expect(mavlink.checksum(b"123456789") == 0x6F91, "checksum")
frame = mavlink.pack("COMMAND_LONG", 7, command=400, p1=1.0, target_system=1)
expect(mavlink.unpack(b"\xfdgarbage" + frame)[0][1:] == ("COMMAND_LONG", {
    **{f"p{k}": float(k == 1) for k in range(1, 8)}, "command": 400, "target_system": 1, "target_component": 0,
    "confirmation": 0}), "a frame among garbage")
expect(mavlink.unpack(frame[:-1] + b"?") == [], "a frame that is spoilt")

status, said = fly(tree, "--map", MAP, "--goal", "7,0,2", "--parameter", "SIM_SPEEDUP=1")
with open(os.path.join(folder, "fly_sitl/companion.log"), encoding="utf-8") as file:
    expect(status == 0, said + file.read())
expect(re.search(r"flight     \d+\.\d s in guided", said) is not None, said)
error = re.search(r"error      largest (\d\.\d\d) m", said)
expect(error is not None and float(error.group(1)) < 0.6, said)
clearance = re.search(r"clearance  (\d\.\d\d) m from the blocks to the vehicle's centre", said)
expect(clearance is not None and 0.4 < float(clearance.group(1)) < 2.0, said)
print(said)
with open(os.path.join(folder, "built"), encoding="utf-8") as built:
    lines = built.read().splitlines()
expect([line.split()[:2] for line in lines] == [["cmake", "-S"], ["cmake", "--build"], ["waf", "configure"],
                                                ["waf", "copter"]], str(lines))
expect(lines[0].endswith("-DTERN_BUILD_COMPANION=ON") and lines[2].endswith("--board sitl"), str(lines))
with open(os.path.join(folder, "fly_sitl/arducopter.log"), encoding="utf-8") as file:
    log = file.read()
expect("'GUID_TIMEOUT', '0.3'" in log and "'SIM_SPEEDUP', '1'" in log and "FRAME_CLASS" in log, log)

for arguments, wrong, text in (((folder,), "", "is no tree of ArduPilot: it has no waf"),
                               ((tree, "--goal", "north"), "", "write EAST,NORTH,UP"),
                               ((tree, "--map", "nowhere.txt"), "", "nowhere.txt: no such file"),
                               ((tree,), "no build", "configure Tern failed. The end of"),
                               ((tree,), "ends", "it ended with status 1. The end of"),
                               ((tree, "--map", MAP, "--set", "color=1"), "", "no tern_companion: it ended")):
    status, said = fly(*arguments, wrong=wrong)
    expect(status != 0 and text in said, f"{arguments} {wrong}: {status}, {said}")
status, said = fly(tree, path=os.path.dirname(sys.executable) + "-nothing")
expect(status != 0 and "missing: cmake (3.16 or later)" in said, said)
print("fly_sitl_test: ok")
