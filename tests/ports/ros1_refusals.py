#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Starts port/ros's flight node for ROS 1 with parameters that it must refuse: ros1_refusals.py NODE FOLDER"""
import subprocess
import sys
import xmlrpc.client

from ros1.master import Master

REFUSED = [
    ("speed", "fast", "parameter speed is refused: it is no number"),
    ("camera/least", "near", "parameter camera/least is refused: it is no number"),
    ("setpoint_rate", "often", "parameter setpoint_rate is refused: it is no number"),
    ("frame", 7, "parameter frame is refused: it is no text"),
    ("camera/most", -1.0, "parameter camera/most = -1 m is refused"),
    ("tracker", "yes", "parameter tracker is refused: it is no bool"),
    ("detections", "radar", 'parameter detections = "radar" is refused'),
    ("other_class", "boat", 'parameter other_class = "boat" is refused'),
    ("clusters", "boat", 'parameter clusters = "boat" is refused'),
    ("output", "joystick", 'parameter output = "joystick" is refused'),
]


def main():
    node, folder = sys.argv[1:]
    with Master(folder) as master:
        parameters = xmlrpc.client.ServerProxy(master.uri)
        for name, value, words in REFUSED:
            parameters.setParam("/test", f"/tern/{name}", value)
            run = subprocess.run([node], env=master.environment, capture_output=True, text=True, timeout=60, check=False)
            said = run.stdout + run.stderr
            assert run.returncode == 1 and words in said, f"{name} = {value}: {run.returncode}: {said}"
            parameters.deleteParam("/test", f"/tern/{name}")
    print(f"{len(REFUSED)} refused")


if __name__ == "__main__":
    main()
