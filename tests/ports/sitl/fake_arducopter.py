#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in for ArduPilot's simulator: runs FAKE_ARDUCOPTER of the environment, and then writes its DataFlash log."""
import os
import signal
import subprocess
import sys

here = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, here)
from log_writers import ARDUPILOT, dataflash  # noqa: E402

for word in ("--model", "--wipe", "--home", "--defaults"):
    assert word in sys.argv, word
for path in sys.argv[sys.argv.index("--defaults") + 1].split(","):
    with open(path, encoding="utf-8") as file:
        print(path, file.read().split(), flush=True)
if os.environ.get("FAKE_WRONG") == "ends":
    sys.exit("PANIC: no model")
with subprocess.Popen([os.environ["FAKE_ARDUCOPTER"], *sys.argv[1:]]) as copter:
    signal.signal(signal.SIGTERM, lambda *_: copter.terminate())
    copter.wait()
records, mode = [("MODE", (1, 5, 5, 1))], 5
with open("log.csv", encoding="utf-8") as file:
    for line in file:
        us, now, *numbers = line.split()
        us, now, numbers = int(us), int(now), list(map(float, numbers))
        if now != mode:
            records.append(("MODE", (us, now, now, 2)))
            mode = now
        for k, axis in enumerate("NED"):
            records.append(("PSC" + axis, (us, numbers[k], numbers[k], numbers[3 + k], 0.0)))
        records.append(("SIM2", (us, *numbers[6:9], 0.0, 0.0, 0.0)))
os.makedirs("logs", exist_ok=True)
with open("logs/00000001.BIN", "wb") as file:
    file.write(dataflash(ARDUPILOT, records))
