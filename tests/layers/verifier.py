#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""verifier.py ROOT NM VERIFIER ARCHIVE...: the exact verifier shares nothing with what it checks (docs/verify.md). Fails
where a file of tools/verify includes a header that is neither its own, the C++ library's, GMP's, Boost's nor
nlohmann-json's, or where the archive VERIFIER needs or has a symbol of the core or of the host tools, ARCHIVE...

--self-test: breaches of each kind are found."""
import pathlib
import re
import subprocess
import sys
import tempfile

LIBRARIES = ("boost/", "nlohmann/")
INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')
# Namespaces in mangled names, and the C interface.
FOREIGN = re.compile(r"(?<!\d)(4tern|9tern_host|8tern_cli)[A-Z0-9]|^tern_")


def foreign_includes(folder):
    for path in sorted(folder.glob("*.[ch]pp")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            quoted, name = match.group(1) == '"', match.group(2)
            own = name.startswith("verify/") and (folder / name[len("verify/"):]).exists()
            library = name.startswith(LIBRARIES) or "/" not in name and "." not in name
            if not (own if quoted else library):
                yield f"{path}:{number}: includes {name}"


def symbols(nm, archive):
    """Undefined ones, and those defined for others, without what templates and inline functions define everywhere."""
    text = subprocess.run([nm, archive], capture_output=True, text=True, check=True).stdout
    pairs = [line.split()[-2:] for line in text.splitlines() if len(line.split()) > 1 and not line.endswith(":")]
    return {name for kind, name in pairs if kind == "U"}, {name for kind, name in pairs if kind in "ABCDGRST"}


def foreign_symbols(needed, defined, others):
    for name in sorted(needed & others):
        yield f"needs {name}, which it shares with the core or the host tools"
    for name in sorted(needed | defined):
        if FOREIGN.search(name):
            yield f"has {name}, which is of the core or of the host tools"


def self_test():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "a.hpp").write_text('#include <vector>\n#include <boost/x.hpp>\n#include "verify/a.hpp"\n')
        assert not list(foreign_includes(folder))
        for line in ('"tern/vec3.hpp"', "<tern/vec3.hpp>", '"host/number.hpp"', '"verify/other.hpp"', '"check/check.hpp"',
                     "<stdio.h>"):
            (folder / "b.cpp").write_text(f"#include {line}\n")
            assert len(list(foreign_includes(folder))) == 1, line
    own = {"_ZN11tern_verify5proveERKNS_6FlightE", "_ZNSt6vectorIN11tern_verify5ClaimE", "__gmpq_add"}
    assert not list(foreign_symbols(own, own, {"_ZN4tern8evaluateE"}))
    for name in ("_ZN4tern8evaluateERKNS_10TrajectoryEd", "_ZNK4tern7Planner4planEv", "_ZN9tern_host6numberEd", "tern_plan",
                 "_ZNSt6vectorIN4tern4Vec3E"):
        assert list(foreign_symbols(own | {name}, own, set())), name
    assert list(foreign_symbols({"shared_helper"}, own, {"shared_helper"}))
    print("breaches of each kind are found")
    return 0


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    root, nm, verifier, *archives = sys.argv[1:]
    folder = pathlib.Path(root) / "tools/verify"
    needed, defined = symbols(nm, verifier)
    others = set().union(*(symbols(nm, archive)[1] for archive in archives))
    found = [*foreign_includes(folder), *foreign_symbols(needed, defined, others)]
    print("\n".join(found) or f"{len(needed)} symbols needed, none of {len(others)} of the core and the host tools")
    return 1 if found or not defined or not others else 0


sys.exit(main())
