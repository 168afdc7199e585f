#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""tidy.py ROOT COMMANDS CLANG_TIDY: the core's sources must be clean under .clang-tidy. COMMANDS is the build's
compile_commands.json, which gives definitions and include folders. Each file is compiled without precompiled headers,
so one that forgets an include is found, too."""
import concurrent.futures
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

# What clang needs of a gcc command line; the rest is optimisation and warnings.
KEPT = ("-D", "-I", "-isystem", "-std=", "-fno-exceptions", "-fno-rtti")


def kept_options(command):
    words = iter(shlex.split(command))
    options = []
    for word in words:
        if word.startswith(KEPT):
            options.append(word)
            if word in ("-D", "-I", "-isystem"):
                options.append(next(words))
    return options


def core_sources(root, commands):
    """One entry a file: the core is built several times over, with different capacities."""
    entries = {}
    for entry in json.loads(commands.read_text()):
        file = pathlib.Path(entry["file"])
        if root / "core/src" in file.parents and "/tern.dir/" in entry["command"]:
            entries[file] = kept_options(entry["command"])
    return entries


def tidy(program, file, options):
    command = [program, "--quiet", str(file), "--", *options]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.returncode, f"{shlex.join(command)}\n{done.stdout}{done.stderr}"


def main():
    root, commands, program = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    if not shutil.which(program):
        print(f"{program} is not installed; tools/setup installs it")
        return 1
    sources = core_sources(root, commands)
    on_disk = set((root / "core/src").rglob("*.cpp"))
    for file in sorted(on_disk - sources.keys()):
        print(f"{file}: not in {commands}")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        answers = list(pool.map(lambda file: tidy(program, file, sources[file]), sorted(sources)))
    bad = [text for status, text in answers if status != 0]
    print("\n".join(bad))
    print(f"{len(sources)} files, {len(bad)} with findings")
    return 1 if bad or not sources or on_disk - sources.keys() else 0


sys.exit(main())
