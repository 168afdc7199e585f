#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""ranks.py CAMPAIGN TERN ATTACK FOLDER MPIRUN PYTHON: real plans, flights and attacks in one process, on 1 and 4
ranks of mpirun, and killed in the middle and run again: the tables are the same to the byte. MPIRUN or PYTHON empty:
without ranks."""
import contextlib
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from expectations import expect, status  # noqa: E402

CAMPAIGN, TERN, ATTACK, FOLDER, MPIRUN, PYTHON = sys.argv[1:7]
ROWS = {"plan": ["P25", "P49", "--set", "v_max=3"],
        "fly": ["P49@3", "--set", "time_limit=1.5", "--set", "sensor_size=40,30"],
        "attack": ["far"]}
RUNS = {"plan": 8, "fly": 3, "attack": 60}
# As root and with more ranks than cores, as in containers.
MPI = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_btl="self,vader",
           OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_btl_vader_single_copy_mechanism="none")


def words(kind, name, ranks=0, runs=None):
    python = [MPIRUN, "-n", str(ranks), PYTHON] if ranks else [sys.executable]
    return [*python, CAMPAIGN, kind, *ROWS[kind], "--runs", str(runs or RUNS[kind]), "--tern", TERN, "--attack", ATTACK,
            "--folder", FOLDER, "--name", name]


def run(kind, name, ranks=0):
    done = subprocess.run(words(kind, name, ranks), capture_output=True, text=True, env=MPI if ranks else None)
    if done.returncode not in (0, 1) or "Traceback" in done.stderr:
        print(done.stdout, done.stderr)
    return tables(name)


def tables(name):
    read = lambda ending: pathlib.Path(FOLDER, f"{name}-table.{ending}").read_bytes()
    return read("csv"), read("md")


def kill_session(leader):
    """Ends the leader and all that it started: mpirun gives each rank a process group of its own, so a signal to the
    leader's group would leave the ranks at work."""
    for process in filter(str.isdigit, os.listdir("/proc")):
        with contextlib.suppress(ProcessLookupError):
            if os.getsid(int(process)) == leader:
                os.kill(int(process), signal.SIGKILL)


def kill_midway(kind, name, ranks=0):
    """Ends a campaign with SIGKILL once its state has a few runs. It would have 50 times the runs of the whole one: a
    campaign of a few runs may end before a busy machine gets to kill it. Returns how many runs its state has, and how
    many it would have had."""
    path = pathlib.Path(FOLDER, f"{name}.csv")
    lines = lambda: len(path.read_text().splitlines()) - 2 if path.exists() else 0
    runs = 50 * RUNS[kind]
    process = subprocess.Popen(words(kind, name, ranks, runs), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               env=MPI if ranks else None, start_new_session=True)
    while process.poll() is None and lines() < 1:
        time.sleep(0.01)
    kill_session(process.pid)
    process.wait()
    return lines(), runs


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    whole = {kind: run(kind, f"{kind}-whole") for kind in ROWS}
    for kind in ("plan", "fly"):
        begun, runs = kill_midway(kind, f"{kind}-killed")
        expect(f"{kind}: killed after {begun} runs of {runs} a row", 0 < begun < runs)
        expect(f"{kind}: after a kill and a resume the same table", run(kind, f"{kind}-killed") == whole[kind])
    if not MPIRUN or not PYTHON:
        print("SKIPPED: campaigns on ranks of mpirun; tools/setup mpi installs what they need")
        return status() or 77
    started = subprocess.run([MPIRUN, "-n", "2", "true"], capture_output=True, text=True, env=MPI)
    if started.returncode != 0:
        print("SKIPPED: mpirun starts no ranks here (it needs /dev/shm):", started.stderr.strip()[-300:])
        return status() or 77
    for ranks in (1, 4):
        expect(f"plan: {ranks} ranks, the same table", run("plan", f"plan-{ranks}", ranks) == whole["plan"])
    for kind in ("fly", "attack"):
        expect(f"{kind}: 4 ranks, the same table", run(kind, f"{kind}-4", 4) == whole[kind])
    begun, runs = kill_midway("plan", "plan-ranks-killed", 4)
    expect(f"plan: ranks killed after {begun} runs of {runs} a row", 0 < begun < runs)
    expect("plan: ranks resumed by 2, the same table", run("plan", "plan-ranks-killed", 2) == whole["plan"])
    return status()


if __name__ == "__main__":
    sys.exit(main())
