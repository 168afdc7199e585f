#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""definitions.py ROOT: fails where two files of the core, of the formats for flight stacks or of the host's tools define
a type with one name in one namespace. No compiler sees both, and a program that links both may take either for the other.
definitions.py --self-test: fails where it does not find that."""
import collections
import pathlib
import re
import sys

SILENT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)
OPENS = re.compile(r"\b(?:inline\s+)?namespace\s+([\w:]*)\s*\{"
                   r"|\b(?:struct|class|union|enum(?:\s+class|\s+struct)?)\s+(\w+)(?:\s+final)?\s*(?::(?!:)[^;{}()]*)?\{"
                   r"|[{}]")


def defined(text):
    """Types in named namespaces, with those. What is in an anonymous one, a type or a function is that file's alone."""
    scopes = []  # names of namespaces; None for everything else
    for match in OPENS.finditer(SILENT.sub(" ", text)):
        if match.group(0) == "}":
            if scopes:
                scopes.pop()
        elif match.group(1):
            scopes.append(match.group(1))
        else:
            if match.group(2) and None not in scopes:
                yield "::".join(scopes + [match.group(2)])
            scopes.append(None)


def problems(files):
    places = collections.defaultdict(set)
    for name, text in files.items():
        for type_name in defined(text):
            places[type_name].add(name)
    for type_name, where in sorted(places.items()):
        if len(where) > 1:
            yield f"{type_name} is defined in {' and '.join(sorted(where))}: rename one by what it is"


def self_test():
    files = {
        "a.hpp": "namespace a {\nnamespace b {\n// struct Y {\nstruct X final : Base<int> {\n  struct In {};\n};\n}\n}",
        "b.cpp": "namespace a::b {\nclass X {\n enum class In : int { k };\n};\nvoid f() { struct Y {}; }\n}",
        "c.cpp": "namespace a::b {\nnamespace {\nstruct X {};\n}\nstruct Y;\ntemplate <class X> struct X Z() { }\n}",
        "d.cpp": "namespace a {\nstruct X {};\nstruct Y::In { };\nconst char* g() { return \"struct\"; }\nstruct Y { };\n}",
    }
    wrong = list(problems(files)) != ["a::b::X is defined in a.hpp and b.cpp: rename one by what it is"]
    print("does not find what it should" if wrong else "finds the one type that two files define")
    return 1 if wrong else 0


def main():
    if sys.argv[1] == "--self-test":
        return self_test()
    root = pathlib.Path(sys.argv[1])
    paths = [path for folder in ("core", "port/stacks", "tools/host") for path in sorted((root / folder).rglob("*.[ch]pp"))]
    files = {str(path.relative_to(root)): path.read_text() for path in paths}
    found = list(problems(files))
    print("\n".join(found) or f"{len(files)} files define no type twice in one namespace")
    return 1 if found or not files else 0


sys.exit(main())
