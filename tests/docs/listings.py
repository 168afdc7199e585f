#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""listings.py ROOT: every C, C++ and Python listing of README.md, docs/ and port/ must stand in a file of docs/examples
or in an example of port/, which tests compile and run. Line breaks and indentation may differ. A listing without a
language must not look like code."""
import pathlib
import re
import sys

FENCE = re.compile(r"^[ \t]*```[ \t]*(\S*)[ \t]*\n(.*?)^[ \t]*```[ \t]*$", re.MULTILINE | re.DOTALL)
CODE = {"c", "cpp", "c++", "cc", "cxx", "h", "hpp", "python"}
OTHER = {"sh", "cmake", "json", "text", "make", "yaml"}


def words(text):
    return " ".join(text.split())


def looks_like_code(listing):
    return re.search(r"[;{]\s*(//.*)?$|^\s*#include", listing, re.MULTILINE) is not None


def pages(root):
    return [root / "README.md", *sorted((root / "docs").rglob("*.md")), *sorted((root / "port").rglob("*.md"))]


def faults_of(page, examples):
    for language, listing in FENCE.findall(page.read_text()):
        first = listing.strip().split("\n")[0]
        if language.lower() in CODE:
            if not any(words(listing) in example for example in examples):
                yield f"{page}: no file of docs/examples has the listing that begins with: {first}"
        elif language not in OTHER and (language or looks_like_code(listing)):
            yield f"{page}: '{language}' is no known language of a listing: {first}"


def main():
    root = pathlib.Path(sys.argv[1])
    files = [file for folder in ("docs/examples", "port") for file in sorted((root / folder).rglob("*"))
             if file.suffix in {".cpp", ".hpp", ".c", ".py"}]
    examples = [words(file.read_text()) for file in files]
    faults = [fault for page in pages(root) for fault in faults_of(page, examples)]
    count = sum(language.lower() in CODE for page in pages(root) for language, _ in FENCE.findall(page.read_text()))
    print("\n".join(faults))
    print(f"{count} listings, {len(examples)} examples, {len(faults)} faults")
    return 1 if faults or count == 0 else 0


sys.exit(main())
