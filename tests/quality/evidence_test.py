#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""evidence_test.py TOOLS: `tools/evidence release` in a pretended repository, whose commands leave a few results: a
killed run goes on, another core begins anew, and the page sums up. Also the bounds, and what a hash of the core is of."""
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from expectations import expect, status  # noqa: E402

QUALITY = pathlib.Path(sys.argv[1], "quality")
sys.path.insert(0, str(QUALITY))
import bounds  # noqa: E402
import core_id  # noqa: E402

RELEASE = "import pathlib, sys, evidence; evidence.ROOT = pathlib.Path(sys.argv.pop(1)); sys.exit(evidence.main())"
ENVIRONMENT = {"PYTHONPATH": str(QUALITY), "PATH": "/bin:/usr/bin", "PYTHONDONTWRITEBYTECODE": "1"}
FLOWN = """# fly program 1, settings tracking_margin=0.1
row,seed,status,reason,time_s,full_knowledge_s,tracking_max,asked
P25@5,7,reached,,12,10,0.1,300
P25@5,8,stuck,no way,12,0,0.1,200
S20,7,reached,,12,10,0.12,100
"""
PROVEN = """# program 1 plans
row,seed,status,claims,curve used
boxes,1,proven,30,0.25
boxes,2,no_path,,
far,1,proven,12,
"""
MUTANTS = "# core 1\nid,result\n" + "".join(f"m{k},{'survived' if k == 7 else 'killed'}\n" for k in range(20))
FUZZED = "entry,date,seed,seconds,inputs,coverage edges,corpus,found wrong\n" + 2 * "solve,2026-11-26,1,1800,5000,70,4,0\n"
# What a command leaves, at the folder of its results.
LEFT = {"flights": FLOWN, "proven-plans": PROVEN, "mutants": MUTANTS, "fuzz": FUZZED,
        "coverage": "stage,branches,taken,named\nall,200,190,9\ncore/src/x,200,190,9\n",
        "capacities": "what,number,failed\nstatuses reached,46,0\n"}
COMMANDS = ["capacities", "campaign", "prove", "coverage", "fuzz", "mutate"]
# Attacks hang if there is a file `hang`; fuzzers end with the number in a file `wrong`.
PRETENDER = """#!/bin/sh
echo "$0 $*" >>calls
case "$*" in *attack*) if [ -e hang ]; then sleep 600; fi ;; esac
for word; do
  case $word in build/evidence/*) cp -r left/. "$(echo "$word" | cut -d/ -f1-3)" ;; esac
done
case $0 in *fuzz) if [ -e wrong ]; then exit "$(cat wrong)"; fi ;; esac
"""


def pretend(root):
    for folder in ("core/src", "tools", "left", "docs/measurements"):
        (root / folder).mkdir(parents=True)
    (root / "core/src/x.cpp").write_text("int x = 1;\n")
    (root / "CMakeLists.txt").write_text("project(tern VERSION 0.2.0)\n")
    (root / "CHANGELOG.md").write_text("## [Unreleased]\n\n## [0.2.0] - 2026-11-26\n")
    for name in COMMANDS:
        (root / "tools" / name).write_text(PRETENDER)
        (root / "tools" / name).chmod(0o755)
    for name, text in LEFT.items():
        (root / "left" / f"{name}.csv").write_text(text)


def released(root, *words):
    """What a run said, its status, and the commands that it ran."""
    (root / "calls").unlink(missing_ok=True)
    done = subprocess.run([sys.executable, "-c", RELEASE, root, *words], env=ENVIRONMENT, capture_output=True, text=True)
    calls = (root / "calls").read_text().splitlines() if (root / "calls").exists() else []
    return done.stderr, done.returncode, calls


def killed(root):
    """A run that is ended while it attacks."""
    (root / "hang").touch()
    running = subprocess.Popen([sys.executable, "-c", RELEASE, root, "release"], env=ENVIRONMENT,
                               stderr=subprocess.PIPE, text=True)
    for _ in range(600):
        if (root / "calls").exists() and "attack" in (root / "calls").read_text():
            break
        time.sleep(0.05)
    _, again, _ = released(root, "release")
    running.send_signal(signal.SIGTERM)
    said = running.communicate()[1]
    (root / "hang").unlink()
    expect("a second run beside it is refused", again == 2)
    expect("a run that is ended says so", running.returncode == 1 and "the same command goes on from here" in said)


def going_on(root):
    page = root / "docs/measurements/evidence.md"
    killed(root)
    released(root, "page")
    expect("the page has what was done before, and says what was not", "proven" in page.read_text() and
           "Not run to the end: attack, flights," in page.read_text())
    said, code, calls = released(root, "release")
    expect("the same command goes on with what was under way", code == 0 and "4 of 11 steps are done" in said and
           "tools/campaign attack" in calls[0] and len(calls) == 7)
    expect("done is done", released(root, "release")[1:] == (0, []))
    said, code, calls = released(root, "release", "--hours", "24")
    expect("more hours make all longer that has a length", len(calls) == 10 and "--runs 1440" in " ".join(calls))
    (root / "core/src/x.cpp").write_text("// One.\nint x =\n    1;  // x\n")
    expect("a comment changes nothing", released(root, "release", "--hours", "24")[1:] == (0, []))
    (root / "core/src/x.cpp").write_text("int x = 2;\n")
    said, code, _ = released(root, "page")
    expect("another core has no page yet", code == 2 and "nothing was run for the core" in said)
    (root / "wrong").write_text("1")
    said, code, calls = released(root, "release")
    expect("it begins anew", len(calls) == 11)
    expect("what was found is said last, with its log", code == 1 and
           "fuzzers found something or broke: build/evidence/" in said.splitlines()[-1])
    expect("and is looked for again", len(released(root, "release")[2]) == 1)
    (root / "wrong").write_text("2")
    (root / "core/src/x.cpp").write_text("int x = 3;\n")
    expect("what failed runs again", released(root, "release")[1] == 1 and len(released(root, "release")[2]) == 1)
    text = page.read_text()
    expect("and the page says so", "# Evidence for Tern 0.2.0\n" in text and "Not run to the end: fuzzers." in text)
    return text


def sums(text):
    expect("flights add up over families", "| flights | P25@5 S20 | 3 | 2 | 0 | 0 | 600 | 1 in 2 |" in text)
    expect("what failed is named",
           "- `P25@5:8`: stuck no way\n- `S20:7`: reached tracking error 0.120 m, margin 0.1 m\n" in text)
    expect("proofs", "| plans | 3 | 2 | 2 | 42 | 25.0 % |" in text)
    expect("statuses", "| statuses reached | 46 | 0 |" in text)
    expect("branches", "Tests take 190 of 200 branches" in text and "9 are named" in text and "1 are neither" in text)
    expect("mutants", "| 20 | 19 | 1 | 0 | 0 | 0 | 95.0 % | 78.4 % |\n\nSurvived: m7." in text)
    expect("fuzzers", "| solve | 1.00 | 10000 | 70 | 0 |" in text)


def bounding():
    expect("nothing in 100 trials", abs(bounds.upper(0, 100) - (1.0 - 0.05 ** 0.01)) < 1e-9)
    expect("all of 100 trials", abs(bounds.lower(100, 100) - 0.05 ** 0.01) < 1e-9)
    expect("95 of 100 trials", abs(bounds.lower(95, 100) - 0.897747) < 1e-6)
    expect("no trials", bounds.upper(0, 0) == 1.0 and bounds.lower(0, 0) == 0.0)
    expect("a // in a string is no comment", core_id.code("a('\"', \"//\") /* b */;  // c\nd") == "a('\"', \"//\") ; d")


def main():
    with tempfile.TemporaryDirectory() as folder:
        pretend(pathlib.Path(folder))
        sums(going_on(pathlib.Path(folder)))
    bounding()
    return status()


if __name__ == "__main__":
    sys.exit(main())
