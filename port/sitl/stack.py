# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts for PX4's and ArduPilot's simulators share: building, waiting, and saying what went wrong."""
import os
import shutil
import socket
import subprocess
import sys
import time

TERN = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))


class Failure(Exception):
    """What went wrong, and what to do."""


def main_of(fly):
    """Runs a script, and says a failure in one line."""
    try:
        fly()
    except Failure as failure:
        sys.exit(f"{os.path.basename(sys.argv[0])}: {failure}")
    except KeyboardInterrupt:
        sys.exit("interrupted")


def say(text):
    print(text, flush=True)


def need_tools(tools):
    """`tools`: {program: what to install}."""
    missing = [f"{tool} ({hint})" for tool, hint in tools.items() if shutil.which(tool) is None]
    if missing:
        raise Failure("missing: " + ", ".join(missing))


def need_tree(path, name, files):
    """The absolute path of a stack's tree, which has these files."""
    path = os.path.realpath(path)
    for file in files:
        if not os.path.exists(os.path.join(path, file)):
            raise Failure(f"{path} is no tree of {name}: it has no {file}")
    return path


def need_file(path):
    if not os.path.isfile(path):
        raise Failure(f"{path}: no such file")
    return os.path.realpath(path)


def read_point(text):
    try:
        point = [float(word) for word in text.split(",")]
    except ValueError:
        point = []
    if len(point) != 3:
        raise Failure(f"--goal {text}: write EAST,NORTH,UP in metres")
    return point


def tail(path, lines=15):
    with open(path, errors="replace", encoding="utf-8") as file:
        return "".join(file.readlines()[-lines:]).rstrip()


def run(what, command, log, cwd=None, env=None):
    """Runs a command to its end; its output goes to `log`."""
    say(f"{what}: {' '.join(command)}")
    with open(log, "a", encoding="utf-8") as file:
        done = subprocess.run(command, cwd=cwd, env={**os.environ, **(env or {})}, stdout=file,
                              stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        raise Failure(f"{what} failed. The end of {log}:\n{tail(log)}")


def build_tern(folder, log, options, targets=()):
    """Builds Tern into `folder`."""
    build = ["cmake", "--build", folder, "--parallel", str(os.cpu_count())]
    for target in targets:
        build += ["--target", target]
    run("configure Tern", ["cmake", "-S", TERN, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", *options], log)
    run("build Tern", build, log)


def free_port():
    """A UDP port that nobody uses."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_for(what, seconds, condition, server, pause=0.2):
    """Asks until `condition` is true; fails when the server has ended."""
    say(f"wait for {what}")
    end = time.monotonic() + seconds
    while not condition():
        status = server.process.poll()
        if status is not None or time.monotonic() > end:
            why = f"not within {seconds:.0f} s" if status is None else f"it ended with status {status}"
            raise Failure(f"no {what}: {why}. The end of {server.log}:\n{tail(server.log)}")
        time.sleep(pause)


class Server:
    """A simulator that runs beside the script. Its output goes to `log`."""

    def __init__(self, command, log, cwd, env=None):
        self.log = log
        with open(log, "w", encoding="utf-8") as file:
            self.process = subprocess.Popen(command, cwd=cwd, env={**os.environ, **(env or {})}, stdout=file,
                                            stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.terminate()
            try:
                self.process.wait(10)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()

    def said(self):
        with open(self.log, errors="replace", encoding="utf-8") as file:
            return file.read()


def print_report(log, map_path):
    """Prints what the log says."""
    say(f"log        {log}")
    command = [sys.executable, os.path.join(TERN, "port/sitl/flight_report.py"), log, "--map", map_path]
    if subprocess.run(command, check=False).returncode != 0:
        raise Failure("the log has no flight to report")
