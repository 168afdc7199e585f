# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""A ROS 1 master on a free port, for tests."""
import os
import pathlib
import signal
import socket
import subprocess
import tempfile
import time


def end(process, how):
    process.send_signal(how)
    process.wait(60)


class Master:
    """`environment` is that of its nodes; `folder` has their logs."""

    def __init__(self, folder=None):
        self.folder = pathlib.Path(folder or tempfile.mkdtemp(prefix="tern_ros1_"))
        self.folder.mkdir(parents=True, exist_ok=True)
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.uri = f"http://127.0.0.1:{self.port}"
        self.environment = {**os.environ, "ROS_MASTER_URI": self.uri, "ROS_IP": "127.0.0.1",
                            "ROS_HOME": str(self.folder), "ROS_LOG_DIR": str(self.folder)}

    def __enter__(self):
        self.process = subprocess.Popen(["/usr/bin/python3", "/usr/bin/rosmaster", "--core", "-p", str(self.port)],
                                        env=self.environment, stdout=subprocess.DEVNULL)
        for _ in range(200):
            with socket.socket() as probe:
                if probe.connect_ex(("127.0.0.1", self.port)) == 0:
                    return self
            time.sleep(0.1)
        end(self.process, signal.SIGTERM)
        raise RuntimeError("the master does not start")

    def __exit__(self, *_):
        end(self.process, signal.SIGTERM)
