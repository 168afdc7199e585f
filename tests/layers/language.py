#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""language.py ROOT: fails where core/ or port/ uses what GCC 9.4 (JetPack 5) lacks or takes otherwise than later
compilers: library parts that are missing there, and language of C++20. A guard on text, cheap and not complete.
language.py --self-test: every rule must find its own example."""
import pathlib
import re
import sys

# Name of the rule: (what it finds in code without comments and texts, an example that it must find).
RULES = {
    "<charconv> has no doubles": (r"\b(from|to)_chars\b|#\s*include\s*<charconv>", "#include <charconv>"),
    "<filesystem>": (r"#\s*include\s*<(experimental/)?filesystem>", "#include <filesystem>"),
    "<memory_resource>": (r"#\s*include\s*<memory_resource>|\bstd::pmr\b", "std::pmr::vector<int> v;"),
    "std::reduce and parallel algorithms": (
        r"\bstd::(reduce|transform_reduce|inclusive_scan|exclusive_scan|execution)\b", "std::reduce(a, b);"),
    "a header of C++20": (
        r"#\s*include\s*<(bit|compare|concepts|ranges|span|numbers|source_location|version|format|latch|barrier|"
        r"semaphore|stop_token|coroutine)>", "#include <bit>"),
    "__VA_OPT__": (r"\b__VA_OPT__\b", "#define LOG(f, ...) log(f __VA_OPT__(,) __VA_ARGS__)"),
    "__builtin_bit_cast": (r"\b__builtin_bit_cast\b|\bstd::bit_cast\b", "auto b = __builtin_bit_cast(long, x);"),
    "a designated initialiser": (r"[{,]\s*\.\s*[A-Za-z_]\w*\s*(=[^=]|\{)", "Limits l{.velocity = v};"),
    "a keyword of C++20": (
        r"\b(consteval|constinit|concept|requires|co_await|co_yield|co_return|char8_t)\b", "constinit int n = 0;"),
    "operator <=>": (r"<=>", "auto operator<=>(const Vec3&) const = default;"),
    "[[likely]]": (r"\[\[\s*(un)?likely\s*\]\]|\bno_unique_address\b", "if (x) [[likely]] f();"),
}
PATTERNS = {rule: re.compile(pattern) for rule, (pattern, _) in RULES.items()}
# Texts and comments, with as many lines as they have. An include's name in quotes is no text that a rule looks for.
SILENT = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|//[^\n]*|/\*.*?\*/', re.S)


def code_of(text):
    return SILENT.sub(lambda match: "\n" * match.group().count("\n"), text)


def problems(path, text):
    code = code_of(text)
    for rule, pattern in PATTERNS.items():
        for match in pattern.finditer(code):
            yield f"{path}:{code.count(chr(10), 0, match.start()) + 1}: {rule}: beyond GCC 9.4 in C++17"


def self_test():
    silent = 'call(x, "__VA_OPT__"); // #include <bit>\n/* consteval */ point.x = a.y; if (a <= b) f({x, y.z});\n'
    found = {rule: list(problems("example", example)) for rule, (_, example) in RULES.items()}
    faults = [f"{rule}: its example is not found" for rule in found if not found[rule]] + list(problems("clean", silent))
    print("\n".join(faults) or f"{len(RULES)} rules find their examples and nothing in clean code")
    return 1 if faults else 0


def main():
    if sys.argv[1] == "--self-test":
        return self_test()
    root = pathlib.Path(sys.argv[1])
    paths = [p for folder in ("core", "port") for p in sorted((root / folder).rglob("*.*")) if p.suffix in
             (".h", ".hpp", ".cpp", ".S")]
    found = [fault for path in paths for fault in problems(path, path.read_text())]
    print("\n".join(found) or f"{len(paths)} files of core/ and port/ stay within GCC 9.4 in C++17")
    return 1 if found or not paths else 0


sys.exit(main())
