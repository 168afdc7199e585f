#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""sums.py ROOT: fails where the core adds up with a function of Eigen's, which promises no order for its sums
(base/linear.hpp has our own). A guard on text, cheap and not complete: it cannot tell a product of matrices."""
import pathlib
import re
import sys

NAMES = ["dot", "norm", "squaredNorm", "stableNorm", "lpNorm", "normalize", "normalized", "sum", "prod", "mean", "trace",
         "determinant", "inverse", "redux", "lazyProduct", "llt", "ldlt"]
SUM = re.compile(rf"(?:\.|->)\s*(?:template\s+)?({'|'.join(NAMES)})\s*(?:<[^<>]*>)?\(")
COMMENT = re.compile(r"//[^\n]*")
# Each of these must be found, or not.
FOUND = ["a.dot(b)", "m.col(0).norm()", "v->sum()", "m.inverse()", "v.lpNorm<1>()"]
CLEAN = ["dot(a, b)", "sum(pair)", "point.mean", "// a.dot(b)"]


def sums(text):
    return [(number, match.group(1)) for number, line in enumerate(text.splitlines(), 1)
            for match in SUM.finditer(COMMENT.sub("", line))]


def main():
    wrong = [text for text in FOUND if not sums(text)] + [text for text in CLEAN if sums(text)]
    paths = sorted((pathlib.Path(sys.argv[1]) / "core").rglob("*.[ch]pp"))
    found = [f"{path}:{number}: Eigen's {name}() adds up in an order of its own"
             for path in paths for number, name in sums(path.read_text())]
    print("\n".join([f"taken wrongly: {text}" for text in wrong] + found) or f"{len(paths)} files use no sum of Eigen's")
    return 1 if wrong or found or not paths else 0


sys.exit(main())
