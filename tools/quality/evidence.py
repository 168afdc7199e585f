#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the evidence for a release: runs the commands that look for failures, one after the other, and writes one page,
docs/measurements/evidence.md (docs/evidence.md).

  release  runs what is not done yet, and writes the page
  page     only writes the page, from what there is so far

Results are kept in build/evidence/CORE/, where CORE is a hash of the code under core/. So the same command goes on
where a killed one was, and another core begins anew. More hours make the runs longer and keep what was run.

Exit status: 0; 1 where a step found something or failed, which is said at the end; 2 for wrong usage."""
import argparse
import collections
import datetime
import fcntl
import json
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import time

import core_id
import evidence_page

ROOT = pathlib.Path(__file__).resolve().parents[2]
FLOWN = ["P49@3", "P49@5", "P49@8", "P49@12", "P36@3", "P36@5", "P36@8", "P36@12", "P25@3", "P25@5", "P25@8", "P25@12",
         "S05", "S10", "S20", "C@4", "C@6", "C@8", "B", "O", "M", "L", "G", "I", "D"]
RIGID = ["P49@3", "P49@5", "P36@3", "P36@5", "P25@3", "P25@5", "S05", "S10", "S20"]
PLANNED = ["P25", "P12", "S20", "O", "M", "L"]
ATTACKED = ["noise", "boxes", "slots", "maze", "corners", "stairs", "tunnels", "far", "fences", "changes"]
COVERAGE = 0.5  # hours, with its builds, whatever was asked for

Step = collections.namedtuple("Step", "name hours words")


def steps(hours, folder, core):
    """What is run, in this order. Lengths are for so many hours of two cores of the README's computer. The seeds are the
    core's own: no test and no earlier release has had these worlds."""
    seed = 1 + int(core[:5], 16)

    def step(name, share, an_hour, *words):
        """`an_hour` is the length of a step for each hour of the whole; it stands for N among the words."""
        length = str(max(1, round(an_hour * hours)))
        return Step(name, share * hours, [length if word == "N" else str(word) for word in words])

    def campaign(name, share, an_hour, kind, rows, *more):
        return step(name, share, an_hour, "tools/campaign", kind, *rows, "--runs", "N", "--seed", seed,
                    "--folder", folder, "--name", name, *more)

    def proofs(name, share, an_hour, what):
        return step(name, share, an_hour, "tools/prove", what, "N", "--seed", seed,
                    "--folder", folder, "--name", name)

    return [step("capacities", 0.03, 10, "tools/capacities", "N", f"{folder}/capacities.csv"),
            campaign("plans", 0.04, 350, "plan", PLANNED),
            proofs("proven-plans", 0.04, 2500, "--runs"),
            proofs("proven-flights", 0.04, 15, "--flights"),
            campaign("attack", 0.20, 32000, "attack", ATTACKED),
            campaign("flights", 0.27, 60, "fly", FLOWN),
            campaign("rigid", 0.08, 35, "fly", RIGID, "--set", "tracking=quadrotor"),
            campaign("faults", 0.04, 5, "faults", ["P25@5"]),
            Step("coverage", COVERAGE, ["tools/coverage", "--results", f"{folder}/coverage.csv"]),
            step("fuzzers", 0.10, 144, "tools/fuzz", "N", "--in-all", "--results", f"{folder}/fuzz.csv"),
            step("mutants", 0.16, 20, "tools/mutate", "--runs", "N", "--seed", seed,
                 "--results", f"{folder}/mutants.csv")]


def version():
    """The project's version, and whether the changelog has changes since."""
    number = re.search(r"^project\(\w+ VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.M).group(1)
    since = re.search(r"^## \[Unreleased\]\n(.*?)^## \[", (ROOT / "CHANGELOG.md").read_text(), re.M | re.S)
    return number + (" with unreleased changes" if since and since.group(1).strip() else "")


def machine():
    found = re.search(r"^model name\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.M)
    return f"{os.cpu_count()} cores of {found.group(1) if found else os.uname().machine}"


def spoken(hours):
    minutes = round(60.0 * hours)
    return f"{minutes // 60} h {minutes % 60:02d} min" if minutes >= 60 else f"{minutes} min"


def say(text):
    print(f"evidence: {text}", file=sys.stderr, flush=True)


class Journal:
    """Which steps are done: how they ended, how long they took in all, and with which words."""

    def __init__(self, folder):
        self.path = folder / "steps.json"
        self.steps = json.loads(self.path.read_text()) if self.path.exists() else {}

    def has_run(self, step):
        """With any length. A status of 1 says that something was found."""
        return self.steps.get(step.name, {}).get("status") in (0, 1)

    def is_done(self, step):
        """What found something runs again, because a command that broke ends with 1, too."""
        noted = self.steps.get(step.name, {})
        return noted.get("status") == 0 and noted["words"] == step.words

    def note(self, step, status, seconds):
        before = self.steps.get(step.name, {}).get("seconds", 0.0)
        self.steps[step.name] = {"words": step.words, "status": status, "seconds": round(before + seconds, 1),
                                 "date": datetime.date.today().isoformat(), "machine": machine()}
        fresh = self.path.with_suffix(".new")
        fresh.write_text(json.dumps(self.steps, indent=1) + "\n")
        fresh.rename(self.path)


def run(step, folder, journal, lock):
    """The step's progress is shown; what it prints goes to a file. It holds the lock, too, and ends with this process
    unless that is killed outright."""
    began, status = time.monotonic(), None
    with (folder / f"{step.name}.log").open("a") as log:
        log.write(f"{shlex.join(step.words)}\n")
        log.flush()
        process = subprocess.Popen(step.words, cwd=ROOT, stdout=log, pass_fds=[lock], start_new_session=True)
        try:
            status = process.wait()
        finally:
            if status is None:
                os.killpg(process.pid, signal.SIGTERM)
                process.wait()
            journal.note(step, status, time.monotonic() - began)
    return status


def release(hours, core, folder):
    lock = os.open(folder / "lock", os.O_CREAT | os.O_RDWR)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        say(f"{folder} is in use: another run, or what a killed one left running, has to end first")
        return 2
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: sys.exit("evidence: stopped; the same command goes on from here"))
    began, journal, wanted = time.monotonic(), Journal(folder), steps(hours, str(folder.relative_to(ROOT)), core)
    todo = [step for step in wanted if not journal.is_done(step)]
    say(f"Tern {version()}, core {core}: {len(wanted) - len(todo)} of {len(wanted)} steps are done, the rest takes "
        f"about {spoken(sum(step.hours for step in todo))} on two cores, besides builds; results: "
        f"{folder.relative_to(ROOT)}")
    for step in todo:
        say(f"[{wanted.index(step) + 1} of {len(wanted)}] {step.name}, about {spoken(step.hours)}; "
            f"{spoken((time.monotonic() - began) / 3600.0)} so far: {shlex.join(step.words)}")
        status = run(step, folder, journal, lock)
        if core_id.present(ROOT) != core:
            journal.note(step, None, 0.0)
            say("the core has changed: its evidence begins anew with the same command")
            return 1
        if status:
            say(f"{step.name} ended with status {status}: {folder.relative_to(ROOT)}/{step.name}.log")
    write_page(core, folder, journal, wanted)
    failed = [step for step in wanted if not journal.is_done(step)]
    for step in failed:
        say(f"{step.name} {'found something or broke' if journal.has_run(step) else 'did not run to its end'}: "
            f"{folder.relative_to(ROOT)}/{step.name}.log")
    return 1 if failed else 0


def write_page(core, folder, journal, wanted):
    missing = [step.name for step in wanted if not journal.has_run(step)]
    page = ROOT / "docs/measurements/evidence.md"
    page.write_text(evidence_page.text(version(), core, folder, journal.steps, missing))
    say(f"{page.relative_to(ROOT)} is written" + (f", without {', '.join(missing)}" if missing else ""))


def main():
    parser = argparse.ArgumentParser(prog="tools/evidence", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=["release", "page"])
    parser.add_argument("--hours", type=float, default=12.0, metavar="H", help="length of all runs (default 12)")
    arguments = parser.parse_args()
    if not 0.0 < arguments.hours < 10000.0:
        parser.error("--hours must be above 0 and below 10000")
    core = core_id.present(ROOT)
    folder = ROOT / "build/evidence" / core
    if arguments.command == "release":
        folder.mkdir(parents=True, exist_ok=True)
        return release(arguments.hours, core, folder)
    if not (folder / "steps.json").exists():
        say(f"nothing was run for the core {core} yet: tools/evidence release")
        return 2
    write_page(core, folder, Journal(folder), steps(arguments.hours, folder, core))
    return 0


if __name__ == "__main__":
    sys.exit(main())
