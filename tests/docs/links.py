#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""links.py ROOT: every relative link of every page must lead to a file, and to a heading of it where it names one."""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "style"))
import sources

LINK = re.compile(r"\]\(([^)\s]+)\)")
LISTING = re.compile(r"^[ \t]*```.*?^[ \t]*```[ \t]*$", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^#+ +(.+?) *$", re.MULTILINE)


def anchor(heading):
    """As code hosts make it: words in lower case, joined by hyphens, without punctuation."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def faults_of(page):
    for link in LINK.findall(LISTING.sub("", page.read_text())):
        if re.match(r"[a-z]+:", link):
            continue
        name, _, heading = link.partition("#")
        target = page.parent / name if name else page
        if not target.exists():
            yield f"{page}: no file {link}"
        elif heading and heading not in map(anchor, HEADING.findall(LISTING.sub("", target.read_text()))):
            yield f"{page}: no heading {link}"


def main():
    pages = [file for file in sources.files(pathlib.Path(sys.argv[1])) if file.suffix == ".md"]
    faults = [fault for page in pages for fault in faults_of(page)]
    print("\n".join(faults))
    print(f"{len(pages)} pages, {len(faults)} links that lead nowhere")
    return 1 if faults or not pages else 0


sys.exit(main())
