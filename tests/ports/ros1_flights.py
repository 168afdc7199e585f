#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flies worlds of the simulator through ROS 1 topics: a master, port/ros's flight node, and a world that publishes its
camera and judges contact.

  ros1_flights.py --node NODE --world ros1_fly_world [--family P25] [--first 20000] [--flights 1] [--spoilt 0.05]
                  [--jump 1.0] [--least-reached SHARE] [--bags]

Prints a line for each flight and a summary. Exit status 0 if there was no contact, and enough goals were reached."""
import argparse
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time


def free_port():
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return free.getsockname()[1]


def wait_for(port):
    for _ in range(200):
        with socket.socket() as probe:
            if probe.connect_ex(("127.0.0.1", port)) == 0:
                return
        time.sleep(0.1)
    raise RuntimeError("the master does not start")


def end(process, how):
    process.send_signal(how)
    process.wait(60)


def fly(options, member, environment, *bag):
    """One flight: what ros1_fly_world says of it. `bag`: "record" or "play", and the file."""
    log = open(pathlib.Path(environment["ROS_HOME"], "node.log"), "a")
    world = subprocess.Popen([options.world, member, str(options.spoilt), str(options.jump), *bag],
                             env=environment, stdout=subprocess.PIPE, text=True)
    node = None
    try:
        if world.stdout.readline() != "ready\n":
            return {"world": member, "end": "no world"}
        node = subprocess.Popen([options.node], env=environment, stdout=log, stderr=log)
        answer = world.stdout.readline()
        return json.loads(answer) if answer else {"world": member, "end": "no answer"}
    finally:
        for process in (node, world):
            if process is not None:
                end(process, signal.SIGINT)  # nodes write their logs' last lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--node", required=True)
    parser.add_argument("--world", required=True)
    parser.add_argument("--family", default="P25")
    parser.add_argument("--first", type=int, default=20000, help="seed of the first world")
    parser.add_argument("--flights", type=int, default=1)
    parser.add_argument("--spoilt", type=float, default=0.0, help="share of messages that are lost or wrong")
    parser.add_argument("--jump", type=float, default=0.0, help="metres that the estimate jumps by")
    parser.add_argument("--least-reached", type=float, default=1.0, help="share of the goals")
    parser.add_argument("--bags", action="store_true", help="record each flight to a bag, and play that to a new node")
    parser.add_argument("--log", help="folder for the node's log")
    options = parser.parse_args()
    folder = options.log or tempfile.mkdtemp(prefix="tern_ros1_")
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    port = free_port()
    environment = {**os.environ, "ROS_MASTER_URI": f"http://127.0.0.1:{port}", "ROS_IP": "127.0.0.1",
                   "ROS_HOME": folder, "ROS_LOG_DIR": folder}
    master = subprocess.Popen(["/usr/bin/python3", "/usr/bin/rosmaster", "--core", "-p", str(port)], env=environment,
                              stdout=subprocess.DEVNULL)
    ends = []
    try:
        wait_for(port)
        for seed in range(options.first, options.first + options.flights):
            member = f"{options.family}:{seed}"
            bag = str(pathlib.Path(folder, f"{options.family}_{seed}.bag"))
            for how in ("record", "play") if options.bags else (None,):
                flown = fly(options, member, environment, *((how, bag) if how else ()))
                ends.append(flown["end"])
                print(json.dumps(flown), flush=True)
    finally:
        end(master, signal.SIGTERM)
    reached, contacts = ends.count("reached"), ends.count("contact")
    print(f"{options.family}: {len(ends)} flights, {reached} reached, {contacts} contacts")
    return 0 if contacts == 0 and reached >= options.least_reached * len(ends) else 1


if __name__ == "__main__":
    sys.exit(main())
