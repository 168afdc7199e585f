# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""crazyflie_upload_test.py UPLOAD: runs port/crazyflie/upload.py over a stand-in for cflib, and checks what it sends."""
import importlib.util
import struct
import sys

import cflib
import numpy as np
import tern

specification = importlib.util.spec_from_file_location("upload", sys.argv[1])
upload = importlib.util.module_from_spec(specification)
specification.loader.exec_module(upload)
slept = []
upload.time.sleep = slept.append
sys.argv[1:] = ["radio://0/80/2M"]


def run(x=0.1, strays=0.0):
    """The names of what is sent from the ground at `x`, and why it ended early, if it did."""
    cflib.calls.clear()
    slept.clear()
    cflib.estimate.update({"stateEstimate.x": x, "stateEstimate.y": 0.0, "stateEstimate.z": 0.0})
    cflib.strays[0] = strays
    try:
        upload.main()
        return [call[0] for call in cflib.calls], None
    except SystemExit as ended:
        return [call[0] for call in cflib.calls], str(ended)


ready = ["init_drivers", "write", "define", "param", "reset_estimator"]
assert run(x=0.6) == (ready, "no take-off: 0.60 m from the plan's start, seen from above; at most 0.5 m")
assert run(x=np.nan)[0] == ready
names, why = run(strays=0.08)
assert names == ready + ["arm", "takeoff", "go_to", "land", "stop"], names
assert why == "the plan was not flown: 0.08 m from its start, at most 0.05 m", why

plan, yaw = upload.make_plan()
names, why = run()
assert why is None and names == ready + ["arm", "takeoff", "go_to", "start", "land", "stop"], (names, why)
calls = dict((call[0], call[1:]) for call in cflib.calls)
offset, data = calls["write"]
assert (offset, data) == (0, tern.crazyflie_raw(plan, yaw)[0].tobytes())
assert len(data) <= 4096
assert calls["define"] == (1, 0, len(data) // 132, 0)
assert calls["param"] == ("stabilizer.controller", "2") and calls["arm"] == (True,)
assert calls["start"] == (1, 1.0, False, False, False)
assert calls["go_to"][0] == upload.START and calls["go_to"][3] is False
assert slept[3] > plan.duration

# The bytes, evaluated as the firmware does, keep away from the obstacle and end at the goal.
begin, nearest = 0.0, np.inf
lower, upper = (np.array(corner) for corner in upload.OBSTACLES[0])
for piece in struct.iter_unpack("<33f", data):
    for t in np.linspace(0, piece[32], 100):
        at = np.array([np.polynomial.polynomial.polyval(t, piece[8 * k:8 * k + 8]) for k in range(3)])
        nearest = min(nearest, np.linalg.norm(np.maximum(np.maximum(lower - at, at - upper), 0)))
    begin += piece[32]
assert nearest >= 0.15 - 1e-4, nearest
assert np.abs(at - upload.GOAL).max() < 1e-3 and abs(begin - plan.duration) < 1e-4
print(f"{len(data)} bytes, nearest obstacle {nearest:.3f} m")
