# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the scripts share: expectations, programs of a stand-in tree, and runs of a script in it."""
import os
import stat
import subprocess
import sys


def expect(condition, what):
    if not condition:
        raise SystemExit(f"{os.path.splitext(os.path.basename(sys.argv[0]))[0]}: {what}")


def write(path, text):
    """Writes a program, or another file, and returns its path."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
    return path


def run(script, arguments, folder, path, settings):
    """Runs the script in the folder. Its status, and what it printed."""
    environment = {**os.environ, **settings, "PYTHONDONTWRITEBYTECODE": "1", "PATH": path}
    done = subprocess.run([sys.executable, script, *arguments], capture_output=True, text=True, env=environment,
                          cwd=folder, timeout=280, check=False)
    expect("Traceback" not in done.stderr, done.stderr)
    return done.returncode, done.stdout + done.stderr
