#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flies worlds of the simulator through ROS 1 topics: a master, port/ros's flight node, and a world that publishes its
sensors and judges contact.

  ros1_flights.py --node NODE --world ros1_fly_world [--family P25] [--first 20000] [--flights 1]
                  [--sensors camera|cameras|lidar|both] [--spoilt 0.05] [--jump 1.0] [--least-reached SHARE] [--bags]
                  [--real-time] [--output multidof|mavros]

Prints a line for each flight and a summary. Exit status 0 if there was no contact, enough goals were reached, the node
showed markers and a map that fit the world, and its record of each flight was flown again with the same commands."""
import argparse
import json
import pathlib
import shutil
import signal
import subprocess
import sys

from ros1.master import Master, end

NODE_LOG = "node.log"
AGREES = 1.0  # s, for which a node that is played a bag must send its setpoints. Then it may plan otherwise: a bag
# does not tell in which tick a message reached the node. The node's record does
MOST_OFF = 0.5  # m, of a voxel in which something was seen from the nearest thing of the true world


def fly(options, member, master, *bag):
    """One flight: what ros1_fly_world says of it, and of its record. `bag`: "record" or "play", and the file."""
    records = master.folder / "records"
    shutil.rmtree(records, ignore_errors=True)
    log = open(master.folder / NODE_LOG, "a")
    clock = "real" if options.real_time else "lockstep"
    world = subprocess.Popen([options.world, member, str(options.spoilt), str(options.jump), options.sensors, clock,
                              options.output, *bag],
                             env=master.environment, stdout=subprocess.PIPE, text=True)
    node = None
    try:
        if world.stdout.readline() != "ready\n":
            return {"world": member, "end": "no world"}
        node = subprocess.Popen([options.node, f"_record:={records}"], env=master.environment, stdout=log, stderr=log)
        answer = world.stdout.readline()
        flown = json.loads(answer) if answer else {"world": member, "end": "no answer"}
    finally:
        for process in (node, world):
            if process is not None:
                end(process, signal.SIGINT)  # nodes write their logs' last lines, and what is left of a record
    return {**flown, "replay": replay(options, records, bag[1:] if bag[:1] == ("record",) else ())}


def replay(options, records, bag):
    """What ros1_fly_world says of the one record of a flight."""
    files = list(records.glob("*.record"))
    if len(files) != 1:
        return {"difference": f"{len(files)} records"}
    done = subprocess.run([options.world, "replay", files[0], *bag], stdout=subprocess.PIPE, text=True)
    return json.loads(done.stdout or '{"difference": "no record"}')


def replay_fault(flown, has_bag):
    """What is wrong with a flight that was flown again from its record, or nothing."""
    again = flown.get("replay", {})
    if again.get("difference", "no replay") or again["ticks"] < 100:
        return f"a record was not flown again: {again}"
    if has_bag and (again["different"] > 0 or again["compared"] < 0.9 * again["ticks"]):
        return f"a record is not the bag's flight: {again}"
    return None


def displays_fault(flown, options):
    """What is wrong with what the node showed of a flight, or nothing."""
    markers = flown.get("markers", {})
    missing = [name for name in ("plan", "corridor", "look_at") if markers.get(name, 0) == 0]
    if missing or "in_the_way" not in markers:
        return f"markers are missing: {missing}"
    if markers.get("not_finite", 0) > 0:
        return "a marker has a point that is not finite"
    if flown["obstacles"] == 0:
        return "the map was not shown"
    if options.jump == 0.0 and flown["obstacles_off"] > MOST_OFF:
        return f"an obstacle was shown {flown['obstacles_off']} m from the nearest one"
    return None


def log_fault(text, options, nodes):
    """What is wrong with what the nodes said, or nothing. With spoilt messages, tf came late, too."""
    waits = text.count("frames wait, because tf2 has no")
    if options.spoilt > 0.0 and waits != nodes * (2 if options.sensors in ("cameras", "both") else 1):
        return f"{waits} times it was said that frames wait for tf"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--node", required=True)
    parser.add_argument("--world", required=True)
    parser.add_argument("--family", default="P25")
    parser.add_argument("--first", type=int, default=20000, help="seed of the first world")
    parser.add_argument("--flights", type=int, default=1)
    parser.add_argument("--sensors", default="camera", choices=["camera", "cameras", "lidar", "both"],
                        help="one that looks ahead, one to each side, all around, or the first and the third")
    parser.add_argument("--spoilt", type=float, default=0.0, help="share of messages that are lost or wrong")
    parser.add_argument("--jump", type=float, default=0.0, help="metres that the estimate jumps by")
    parser.add_argument("--least-reached", type=float, default=1.0, help="share of the goals")
    parser.add_argument("--bags", action="store_true", help="record each flight to a bag, and play it to a new node")
    parser.add_argument("--real-time", action="store_true", help="by the clock, instead of as fast as the computer can")
    parser.add_argument("--output", default="multidof", choices=["multidof", "mavros"], help="form of the setpoints")
    parser.add_argument("--log", help="folder for the node's log")
    options = parser.parse_args()
    flights, played, faults = [], [], []
    has_setpoints = options.output == "multidof" and options.jump == 0.0  # a bag does, as the flight commands them
    with Master(options.log) as master:
        (master.folder / NODE_LOG).unlink(missing_ok=True)
        for seed in range(options.first, options.first + options.flights):
            member = f"{options.family}:{seed}"
            bag = str(master.folder / f"{options.family}_{seed}.bag")
            for how in ("record", "play") if options.bags else (None,):
                flown = fly(options, member, master, *((how, bag) if how else ()))
                (played if how == "play" else flights).append(flown)
                print(json.dumps(flown), flush=True)
                faults.append(displays_fault(flown, options) if flown["end"] == "reached" else None)
                faults.append(replay_fault(flown, how == "record" and has_setpoints))
        log = pathlib.Path(master.folder, NODE_LOG).read_text()
        faults.append(log_fault(log, options, len(flights) + len(played)))
        faults += [f"a bag was not flown again: {flown}" for flown in played if flown.get("agreed", 0.0) < AGREES]
    faults = [fault for fault in faults if fault]
    ends = [flown["end"] for flown in flights]
    reached, contacts = ends.count("reached"), ends.count("contact")
    print(f"{options.family}: {len(ends)} flights, {reached} reached, {contacts} contacts", *faults, sep="\n")
    return 0 if contacts == 0 and reached >= options.least_reached * len(ends) and not faults else 1


if __name__ == "__main__":
    sys.exit(main())
