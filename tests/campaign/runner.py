#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""runner.py CAMPAIGN FOLDER: the campaign's runner with a program in place of `tern` that pretends to fly: a killed run
goes on, a crash costs one flight, failures are named with the command that repeats them."""
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from expectations import expect, status  # noqa: E402

CALLS = "calls"
PRETENDER = """#!/bin/sh
# Without a log: a short flight, to learn whether there is such a family.
case "$*" in
  *--json*) ;;
  *P99:*) echo "tern: P99 is no family" >&2; exit 2 ;;
  *) exit 0 ;;
esac
echo "$2" >>"{folder}/calls"
while [ "$1" != --json ]; do world=${{world:-$2}}; shift; done
status=reached error=0.1
case $world in
  P25:3) kill -SEGV $$ ;;
  P25:4) status=stuck ;;
  C@8:2) status=collision ;;
  S20:2) error=0.15 ;;
  P12:1) status=collision contact='"contact": {{"speed": 3.0, "broken_assumption": "pose_margin"}},' ;;
  P12:2) status=threat contact='"contact": {{"speed": 2.0, "broken_assumption": "still_world", "shown": true,
    "commanded_speed": 1.75, "brake_speed": 1.5}},' ;;
  P12:3) status=collision contact='"contact": {{"speed": 1.0, "broken_assumption": ""}},' ;;
esac
cat >"$2" <<EOF
{{$contact "status": "$status", "reason": "as told", "time_s": 12.0, "length_m": 60.0, "mean_speed": 5.0, "min_clearance": 0.4,
 "tracking_error": {{"max": $error}}, "full_knowledge_s": 10.0, "straight_s": 9.6, "standing_s": 0.5, "states": {{"threat": 0.0}},
 "plans": {{"asked": 10, "committed": 9, "dropped": 0, "failed": 1}}, "work": {{"max": 4000, "total": 50000}},
 "watched": {{"points": 7, "voxels": 7}}, "commands_hash": "0"}}
EOF
[ $status = reached ] || exit 3
"""


def main():
    campaign, folder = sys.argv[1], pathlib.Path(sys.argv[2], "pretended")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    program = folder / "tern"
    program.write_text(PRETENDER.format(folder=folder))
    program.chmod(0o755)

    def run(*arguments):
        own = ["--tern", str(program), "--folder", str(folder), "--name", "t", "--keep", "0"]
        return subprocess.run([sys.executable, campaign, "fly", *own, *arguments], capture_output=True, text=True)

    calls = lambda: (folder / CALLS).read_text().split()
    done = run("P25", "--flights", "2")
    expect("flights that all reach: status 0", done.returncode == 0 and len(calls()) == 2)
    expect("time over full knowledge", "| P25 | 2 | 2 | 0 | 0 | 5.00 | 1.200 |" in done.stdout)
    done = run("P25", "--flights", "5")
    expect("a further run flies what is missing", calls()[2:] and sorted(calls()) == [f"P25:{k}" for k in range(1, 6)])
    expect("a crash costs one flight, and the status is 1", done.returncode == 1 and "crash: " in done.stdout)
    expect("a failure comes with its command", f"{program} fly P25:4 --compare" in done.stdout)
    expect("the row counts what reached and what crashed", "| P25 | 5 | 3 | 0 | 1 |" in done.stdout)
    state = folder / "t.csv"
    state.write_text(state.read_text()[:-20])
    done = run("P25", "--flights", "5")
    expect("a line that was cut off is flown again", len(calls()) == 6)
    expect("what is kept is reported again", "stuck: as told" in done.stdout)
    done = run("P25", "--flights", "1", "--seed", "6")
    expect("other seeds have a table of their own", done.returncode == 0 and "stuck" not in done.stdout and
           "| P25 | 1 | 1 | 0 | 0 |" in done.stdout)
    done = run("P25", "--flights", "2")
    expect("so do fewer", "| P25 | 2 | 2 | 0 | 0 |" in done.stdout and len(calls()) == 7 and done.returncode == 0)
    done = run("P25", "--flights", "5", "--fresh", "--least", "0.9")
    expect("--fresh flies all again", len(calls()) == 12 and done.returncode == 1)
    done = run("C@8", "--flights", "2", "--set", "v_max=4")
    expect("other settings begin anew, a contact is status 1", len(calls()) == 14 and done.returncode == 1)
    expect("settings are passed on", "--set v_max=4" in done.stdout and "| C@8 | 2 | 1 | 1 | 0 |" in done.stdout)
    expect("the runs with the settings before are put aside", "P25,5" in (folder / "t-1.csv").read_text() and
           f"it is now {folder / 't-1.csv'}" in done.stdout)
    done = run("C@8", "--flights", "2", "--set", "v_max=4")
    expect("it says how many runs are there already", "2 runs are there already" in done.stdout)
    done = run("S20", "--flights", "2", "--set", "v_max=4")
    expect("a flight beyond its tracking margin is named, and the status is 1", done.returncode == 1 and
           f"tracking error 0.150 m, margin 0.1 m: {program} fly S20:2" in done.stdout)
    done = run("S20", "--flights", "2", "--set", "tracking_margin=0.15")
    expect("a flight within its tracking margin is not", done.returncode == 0 and "margin" not in done.stdout)
    done = run("C@8", "P99")
    expect("a family that there is not: status 2, no run", done.returncode == 2 and len(calls()) == 18 and
           "P99: tern: P99 is no family" in done.stderr)
    done = subprocess.run([sys.executable, campaign, "attack", "boxes", "--attack", str(program), "--folder", str(folder),
                           "--set", "v_max=4"], capture_output=True, text=True)
    expect("the attack has no settings: status 2", done.returncode == 2 and
           "boxes: the attack has no settings: leave out --set v_max=4" in done.stderr)
    faults(campaign, folder, program)
    swarms(campaign, folder)
    return status()


SWARMER = """#!/bin/sh
case "$*" in
  *--json*) ;;
  *X-4:*) echo "tern: there is no swarm X-4" >&2; exit 2 ;;
  *) exit 3 ;;
esac
world=$2
while [ "$1" != --json ]; do shift; done
contacts= state=
case $world in
  swap-4:2) contacts='{"time": 1.0}' ;;
  swap-4:3) state='"state": "rest", ' ;;
esac
cat >"$2" <<EOF
{"members": [{$state"unasked": 1}], "disagreed": 0, "contacts": [$contacts], "vehicles": 4, "arrived": 3,
 "mean_travel": 8.25, "last_arrival": 9.5, "least_distance": 0.61, "body_radius": 0.3, "least_clearance": 0.4,
 "packets": 10, "lost": 5, "bytes": 100, "fleet_units": 9, "untold": 0, "time": 9.5, "hash": "0"}
EOF
exit 3
"""


def swarms(campaign, folder):
    program = folder / "swarmer"
    program.write_text(SWARMER)
    program.chmod(0o755)

    def run(*arguments):
        own = ["--tern", str(program), "--folder", str(folder), "--name", "s", "--fresh"]
        return subprocess.run([sys.executable, campaign, "swarm", *own, *arguments], capture_output=True, text=True)

    done = run("swap-4", "--runs", "1")
    expect("a swarm that arrives", done.returncode == 0 and
           "| swap-4 | perfect | 1 | 1 | 4 | 3 | 0 | 0 | 10.0 | 8.25 | 8.25 | 9.50 | 1 |" in done.stdout)
    done = run("swap-4/loss=0.5,partition=2:6", "--runs", "3")
    expect("a contact is status 1, and its command has the links", done.returncode == 1 and
           f"{program} swarm swap-4:2 --seed 2 --loss 0.5 --partition 2 6" in done.stdout and
           "| swap-4 | loss=0.5 partition=2:6 | 3 | 1 | 12 | 9 | 1 | 0 |" in done.stdout)
    done = run("X-4")
    expect("a swarm that there is not: status 2", done.returncode == 2 and "X-4: tern: there is no swarm" in done.stderr)


def faults(campaign, folder, program):
    def run(*arguments):
        own = ["--tern", str(program), "--folder", str(folder), "--name", "f", "--keep", "0", "--fresh"]
        return subprocess.run([sys.executable, campaign, "faults", *own, *arguments], capture_output=True, text=True)

    done = run("P12/jumps-beyond", "P12/appears-2", "--runs", "2", "--set", "v_max=4")
    row = "| P12 | {} | 2 | 0 | 0 | 0 | 1 | 1 | 0 | 0 | 0.400 | 3.00 | 0.25 | 0.00 |"
    expect("a contact that a broken assumption explains is no defect", done.returncode == 0 and
           all(row.format(fault) in done.stdout for fault in ("jumps-beyond", "appears-2")))
    done = run("P12/jumps-beyond", "--runs", "3", "--set", "v_max=4")
    expect("any other one is, and its command has the fault", done.returncode == 1 and
           f"{program} fly P12:3 --set time_limit=60" in done.stdout and
           "--set v_max=4 --set pose_jump=0.2,1" in done.stdout)
    done = run("P25", "--runs", "1")
    expect("a family is flown with every fault", "| P25 | none | 1 | 1 |" in done.stdout and
           "| P25 | dropped-50 | 1 | 1 |" in done.stdout and len(done.stdout.splitlines()) > 25)
    done = run("P25/rain")
    expect("a fault that there is not: status 2", done.returncode == 2 and "P25/rain: there is no such fault" in done.stderr)


if __name__ == "__main__":
    sys.exit(main())
