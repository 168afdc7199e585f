#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""headers.py ROOT COMPILER...: every public header must compile alone, without the C++ standard library's headers, in
each standard that it promises, with each of these C++ compilers. Those of C must compile as C too."""
import pathlib
import subprocess
import sys

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Wdouble-promotion", "-Wfloat-equal",
            "-Werror"]
CXX = ["c++11", "gnu++11", "gnu++14", "c++17"]
C = ["c99", "c11"]


def compiles(compiler, language, standard, folders, header):
    includes = [f"-I{folder}" for folder in folders]
    command = [compiler, "-x", language, f"-std={standard}", "-fsyntax-only", *WARNINGS, *includes, "-"]
    if language == "c++":
        command.insert(1, "-nostdinc++")
    done = subprocess.run(command, input=f'#include "{header}"\n', capture_output=True, text=True)
    if done.returncode != 0:
        print(f"{' '.join(command)} < {header}\n{done.stderr}")
    return done.returncode == 0


def main():
    folders = [pathlib.Path(sys.argv[1]) / name for name in ("core/include", "port/stacks/include")]
    headers = [path.relative_to(folder) for folder in folders for path in sorted(folder.glob("*/*.h*"))]
    tried = [(compiler, "c++", standard, header) for compiler in sys.argv[2:] for standard in CXX for header in headers]
    tried += [(compiler, "c", standard, header) for compiler in sys.argv[2:] for standard in C
              for header in headers if header.suffix == ".h"]
    bad = [case for case in tried if not compiles(case[0], case[1], case[2], folders, case[3])]
    print(f"{len(headers)} headers, {len(tried)} compilations, {len(bad)} failed")
    return 1 if bad or not headers or not tried else 0


sys.exit(main())
