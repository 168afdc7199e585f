#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""names.py ROOT: every name of the public interface, the core's and that for flight stacks, must be explained: in the glossary, or by a comment in its header,
on its own line or above it in the same paragraph. And every file and name that the glossary speaks of must exist."""
import pathlib
import re
import sys

NAMES = [re.compile(pattern) for pattern in (
    r"^\s*(?:typedef )?(?:struct|class|enum class|enum)(?: alignas\([^)]*\))? (\w+)(?: :[^{;]*)? \{",  # types
    r"^\} (tern_\w+);",  # C types
    r"^typedef .*[ *](tern_\w+);",
    r"^using (\w+) =",
    r"^#define (TERN_\w+)(?<!_HPP)(?<!_H)\b",
    r"^\s*(?:static )?constexpr [\w:<> ]*?\b(k[A-Z]\w*) = ",  # constants
    r"^\s*(k[A-Z]\w*|TERN_\w+)(?: = [^,]*)?(?:,|$| *//| *///| */\*)",  # enumerators
    r"^\s*(?:(?:static|inline|constexpr|explicit|const) )*[\w:]+[*&]? [*&]?(\w+)\((?!\))[^;]*$",  # functions that go on
    r"^\s*(?:(?:static|inline|constexpr|explicit|const) )*[\w:]+[*&]? [*&]?(\w+)\(.*\)(?: const)?(?: noexcept)?[ ;{]",
    r"^  (?:const )?[\w:]+[*&]? [*&]?(\w+)(?:\[\w+\])*(?:\{.*\}| = [^;]*)?;",  # fields
)]
KEYWORDS = {"return", "if", "for", "while", "static_assert", "sizeof", "typedef"}


def public_headers(root):
    return sorted([*(root / "core/include/tern").glob("*.h*"), *(root / "port/stacks/include/tern_stacks").glob("*.h*")])


def public_paragraphs(text):
    """Paragraphs without private parts and bodies of functions."""
    text = re.sub(r"\n private:\n.*?\n\};", "\n};", text, flags=re.DOTALL)
    return re.split(r"\n\s*\n", text)


def unexplained(text):
    for paragraph in public_paragraphs(text):
        commented = False
        for line in paragraph.split("\n"):
            commented = commented or "//" in line or "/*" in line
            for name in {m.group(1) for pattern in NAMES for m in [pattern.search(line)] if m} - KEYWORDS:
                yield name, commented


def missing_places(root, glossary):
    """Names in code spans of the glossary that are neither in a public header nor a file."""
    headers = "\n".join(p.read_text() for p in public_headers(root))
    for span in re.findall(r"`([^`]+)`", glossary):
        if "/" in span or span.endswith(".hpp"):
            folders = ("core/src", "core/include/tern", ".")
            if not any((root / folder / span).exists() for folder in folders):
                yield f"docs/glossary.md speaks of the file {span}, which does not exist"
        else:
            for part in span.split("::"):
                if not re.search(rf"\b{re.escape(part)}\b", headers):
                    yield f"docs/glossary.md speaks of {span}, which no public header has"


def main():
    root = pathlib.Path(sys.argv[1])
    glossary = (root / "docs/glossary.md").read_text()
    faults, count = list(missing_places(root, glossary)), 0
    for header in public_headers(root):
        for name, commented in unexplained(header.read_text()):
            count += 1
            if not commented and not re.search(rf"\b{name}\b", glossary):
                faults.append(f"{header}: neither this header nor docs/glossary.md explains {name}")
    print("\n".join(faults))
    print(f"{count} names, {len(faults)} faults")
    return 1 if faults or count == 0 else 0


sys.exit(main())
