#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""order.py ROOT: the core's folders, in the order that tests/layers/includes.py enforces."""
import ast
import pathlib
import re
import sys

text = pathlib.Path(sys.argv[1], "tests/layers/includes.py").read_text()
print(" ".join(ast.literal_eval(re.search(r"^ORDER = (\[.*?\])", text, re.MULTILINE | re.DOTALL).group(1))))
