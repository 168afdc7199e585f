# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""ros1_test.py NODE DRIVER FOLDER: a ROS 1 master, port/ros's node and the driver that plays a bag to it."""
import os
import pathlib
import socket
import subprocess
import sys
import time

node, driver, folder = sys.argv[1:]
pathlib.Path(folder).mkdir(exist_ok=True)
with socket.socket() as free:
    free.bind(("127.0.0.1", 0))
    port = free.getsockname()[1]
environment = {**os.environ, "ROS_MASTER_URI": f"http://127.0.0.1:{port}", "ROS_IP": "127.0.0.1", "ROS_HOME": folder,
               "ROS_LOG_DIR": folder}
master = subprocess.Popen(["/usr/bin/python3", "/usr/bin/rosmaster", "--core", "-p", str(port)], env=environment)
planner = None
try:
    for _ in range(200):
        with socket.socket() as probe:
            if probe.connect_ex(("127.0.0.1", port)) == 0:
                break
        time.sleep(0.1)
    planner = subprocess.Popen([node], env=environment)
    answer = subprocess.run([driver, str(pathlib.Path(folder, "wall.bag"))], env=environment, timeout=120).returncode
finally:
    for process in (planner, master):
        if process is not None:
            process.terminate()
            process.wait(30)
sys.exit(answer)
