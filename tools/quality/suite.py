# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tests of the preset `quality`, which run with any build of the core's libraries in place of their own."""
import os
import subprocess

ATTACKED = 400  # cases of the attack, which counts as one test


def programs(tests, without=()):
    """The command of each test program that is built."""
    found = [path for path in sorted(tests.glob("tests/**/*_test"))
             if path.is_file() and os.access(path, os.X_OK) and not path.name.startswith(tuple(without))]
    commands = [[path, "--gtest_brief=1", "--gtest_fail_fast"] for path in found]
    attack = tests / "tests/attack/tern_attack"
    if attack.exists():
        commands.append([attack, "--cases", str(ATTACKED), "--jobs", "1", "--quiet"])
    golden = tests / "tests/golden/tern_golden"
    if golden.exists() and not golden.name.startswith(tuple(without)):
        commands.append([golden])
    return commands


def environment(core):
    """The core's libraries come from another build tree."""
    return dict(os.environ, LD_LIBRARY_PATH=f"{core}/core:{core}/tests/attack")


def passes(words, core, seconds):
    return run(words, environment(core), seconds, subprocess.DEVNULL) == "passes"


def run(words, variables, seconds, output):
    """Runs a test program. `output` receives what it prints. Returns how it ended."""
    try:
        status = subprocess.run(words, cwd=words[0].parent, stdout=output, stderr=subprocess.STDOUT, env=variables,
                                timeout=seconds).returncode
    except subprocess.TimeoutExpired:
        return f"ended after {seconds:.0f} s"
    return "passes" if status == 0 else f"ends with status {status}"
