#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in for PX4's simulator as port/px4/fly_sih sees it: named px4 it runs, named px4-NAME it is the client of a
command. They talk over files beside it. FAKE_PX4 in the environment says what goes wrong."""
import os
import sys
import time

bin_folder = os.path.dirname(os.path.abspath(sys.argv[0]))
wrong = os.environ.get("FAKE_PX4", "")
words = [os.path.basename(sys.argv[0])[4:], *sys.argv[1:]]
calls = os.path.join(bin_folder, "calls")


def say(text):
    print(text, flush=True)


def state():
    with open(calls, encoding="utf-8") as file:
        return file.read()


if words[0]:
    with open(calls, "a", encoding="utf-8") as file:
        file.write(" ".join(words) + "\n")
    if words[0] == "param" and words[2:3] == ["NO_SUCH"]:
        say("ERROR [param] Parameter NO_SUCH not found")
        sys.exit(1)
    if words[:2] == ["commander", "check"]:
        say("INFO  [commander] Preflight check: " + ("FAILED" if state().count("commander check") < 2 else "OK"))
    if words[:2] == ["listener", "vehicle_local_position"]:
        say(f"    x: 0.01\n    z: {-2.1 if state().count('listener') > 2 else -0.5}\n    vz: -0.05\n")
    if words[:2] == ["listener", "vehicle_status"]:
        say("    arming_state: 1\n    nav_state: 4")
    sys.exit(0)

sys.path.insert(0, os.environ["FAKE_PX4_WRITERS"])
from log_writers import PX4, ulog  # noqa: E402

assert sys.argv[1] == "-d" and os.path.isdir(sys.argv[2]) and os.environ["PX4_SIM_MODEL"] == "sihsim_quadx"
open(calls, "w", encoding="utf-8").close()
if wrong == "ends":
    say("ERROR [init] out of memory")
    sys.exit(3)
said = set()


def once(command, text):
    if command in state() and command not in said:
        said.add(command)
        say(text)


while "shutdown" not in state():
    if wrong == "refused":
        once("tern_offboard start", "ERROR [tern_offboard] no flight from here: start_occupied")
    else:
        once("tern_offboard start", "INFO  [tern_offboard] ready: switch to offboard")
    once("commander mode offboard", "INFO  [tern_offboard] rest: it is at the goal")
    time.sleep(0.05)
records = []
for k in range(100):  # 10 s, in offboard from 2 to 8 s; half a metre beside the plan
    us, offboard = 100000 * k, 20 <= k < 80
    records += [("vehicle_status", 0, (us, 2, 14 if offboard else 4)),
                ("trajectory_setpoint", 0, (us, 0.0, 0.1 * k, -2.0, 0.0, 1.0, 0.0, *[0.0] * 8)),
                ("vehicle_local_position", 0, (us, 0.5, 0.1 * k, -2.0, 0.0, 1.0, 0.0, 1))]
if wrong != "no log":
    os.makedirs("log/2026-01-01", exist_ok=True)
    with open("log/2026-01-01/12_00_00.ulg", "wb") as file:
        file.write(ulog(PX4, records))
