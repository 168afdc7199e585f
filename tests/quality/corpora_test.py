#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""corpora_test.py TOOLS: which inputs `tools/fuzz --merge` keeps, with a program in place of the fuzzer that says that
an input reaches a feature for each of its letters."""
import argparse
import hashlib
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from expectations import expect, status  # noqa: E402

sys.path.insert(0, sys.argv[1])
import fuzz  # noqa: E402

PRETENDER = """#!/usr/bin/env python3
import pathlib, sys
control = next(word.split("=")[1] for word in sys.argv if word.startswith("-merge_control_file="))
files = sorted(path for folder in sys.argv[-2:] for path in pathlib.Path(folder).iterdir())
lines = [len(files), 0, *files]
for number, path in enumerate(files):
    lines += [f"STARTED {number} 1", " ".join(["FT", str(number), *(str(ord(c)) for c in path.read_text())])]
pathlib.Path(control).write_text("".join(f"{line}\\n" for line in lines))
"""


def name(text):
    return hashlib.sha1(text.encode()).hexdigest()[:16]


def main():
    with tempfile.TemporaryDirectory() as folder:
        fuzz.ROOT = root = pathlib.Path(folder)
        program = root / "build/tests/fuzz/solve_fuzzer"
        corpus = root / "tests/fuzz/corpus/solve"
        for made in (program.parent, corpus):
            made.mkdir(parents=True)
        program.write_text(PRETENDER)
        program.chmod(0o755)
        for file, text in ((name("a"), "a"), ("joint_far_away", "b"), (name("abc"), "abc")):
            (corpus / file).write_text(text)
        arguments = argparse.Namespace(build=str(root / "build"))
        names = lambda: {path.name for path in corpus.iterdir()}
        fuzz.merge(arguments, "solve")
        expect("before anything was found, inputs that reach nothing more go; names given by hand stay",
               names() == {name("abc"), "joint_far_away"} and (corpus / "joint_far_away").read_text() == "b")
        (root / "build/found/solve/input").write_text("abcd")
        fuzz.merge(arguments, "solve")
        expect("what reaches more takes the place of what reaches less", names() == {name("abcd"), "joint_far_away"})
        fuzz.merge(arguments, "solve")
        expect("merging again changes nothing", names() == {name("abcd"), "joint_far_away"})
    return status()


if __name__ == "__main__":
    sys.exit(main())
