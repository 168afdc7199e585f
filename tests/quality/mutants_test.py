#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""mutants_test.py TOOLS SOURCE: which changes of a line of C++ tools/mutate makes, and that a seed always takes the
same ones in the same order."""
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from expectations import expect, status  # noqa: E402

sys.path.insert(0, sys.argv[1])
import mutants  # noqa: E402

SOURCE = pathlib.Path(sys.argv[2])


def texts(line):
    """The line as each of its changes makes it."""
    path = "core/src/x.cpp"
    return {mutants.apply(mutants.Mutant("", path, 1, column, kind, before, after), line)
            for column, kind, before, after in mutants.changes_of(line)}


def names_of(text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "core/src/x.cpp")
        path.parent.mkdir(parents=True)
        path.write_text(text)
        return {mutant.id for mutant in mutants.all_of(pathlib.Path(folder))}


def main():
    expect("comparisons, both ways", texts("  if (a < b) return c;") ==
           {"  if (a <= b) return c;", "  if (a >= b) return c;"})
    expect("templates and pointers are no operators", texts("  const Vec<Real>* p = q->at;") == set())
    expect("comments and strings stay", texts('  call("a + b", x);  // 3 * 4') == {"  ;"})
    expect("a declaration is not dropped", "  ;" not in texts("  double sum = a + b;"))
    expect("an assignment is dropped", "  ;" in texts("  sum += a;"))
    expect("arguments are swapped", "  return f(b, a.x);" in texts("  return f(a.x, b);"))
    expect("numbers: one more, one less", texts("  x[3]") == {"  x[4]", "  x[2]"})
    expect("numbers with a fraction: twice, half", texts("  y(0.5)") == {"  y((2.0 * 0.5))", "  y((0.5 * 0.5))"})
    expect("static assertions stay", texts("static_assert(kA + 1 < kB);") == set())
    first, again = (mutants.chosen(SOURCE, 7, "core/src/path/")[:200] for _ in range(2))
    expect("a seed gives the same order", first == again and len(first) == 200)
    expect("another seed gives another", first != mutants.chosen(SOURCE, 8, "core/src/path/")[:200])
    every = mutants.all_of(SOURCE)
    expect("names are unique", len({m.id for m in every}) == len(every))
    names = [names_of("int f(int a) {\n  return a + 1;  // One.\n}\n"),
             names_of("// Two.\nint f(int a) {\n\n  return a + 1;\n}\n")]
    expect("and do not depend on comments or the places of lines", len(names[0]) == 3 and names[0] == names[1])
    fits = True
    for mutant in first:
        text = (SOURCE / mutant.path).read_text()
        changed = mutants.apply(mutant, text).split("\n")
        differing = [k for k, (a, b) in enumerate(zip(text.split("\n"), changed), 1) if a != b]
        fits = fits and differing == [mutant.line]
    expect("each changes its line alone", fits)
    return status()


if __name__ == "__main__":
    sys.exit(main())
