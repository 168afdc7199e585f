# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Changes of one token in the core's sources: where they are possible, and the order in which a seed takes them."""
import collections
import hashlib
import random
import re

Mutant = collections.namedtuple("Mutant", "id path line column kind before after")

# The sources are formatted, so that a binary operator has blanks around it; a template's or a pointer's has not.
SWAPS = [("comparison", {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}),
         ("reversed comparison", {"<": ">=", "<=": ">", ">": "<=", ">=": "<"}),
         ("arithmetic", {"+": "-", "-": "+", "*": "/", "/": "*", "+=": "-=", "-=": "+="}),
         ("bits", {"&": "|", "|": "&", "<<": ">>", ">>": "<<", "|=": "&=", "&=": "|="}),
         ("logic", {"&&": "||", "||": "&&"})]
OPERATOR = re.compile(r"(?<= )(<=|>=|==|!=|<<|>>|&&|\|\||\+=|-=|\|=|&=|[-+*/<>&|])(?= )")
NUMBER = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?(?:[eE][-+]?\d+)?)(?![\w.])")
WORD = re.compile(r"\bstd::(?:min|max)\b|\b(?:true|false)\b|\+\+|--")
WORDS = {"std::min": "std::max", "std::max": "std::min", "true": "false", "false": "true", "++": "--", "--": "++"}
STATEMENT = re.compile(r"^(\s+)((?:[\w.\[\]]|->)+(?: [-+*/|&]?= .+|\(.*\));)$")
PAIR = re.compile(r"\b\w+\((\w+(?:\.\w+)?), (\w+(?:\.\w+)?)\)")
NOT_CODE = re.compile(r"^\s*(#|//|\*|static_assert|template|using|namespace|return;|break;|continue;)")


def code_of(line):
    """The line with comments and strings blanked out, of the same length."""
    blank = lambda match: " " * len(match.group())
    return re.sub(r"//.*|\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])+'", blank, line)


def number_changes(text):
    if "." in text or "e" in text.lower():
        return ["(2.0 * %s)" % text, "(0.5 * %s)" % text] if float(text) else ["1e-3"]
    return [str(int(text) + 1), str(int(text) - 1)] if int(text) else ["1"]


def changes_of(line):
    """(column, kind, before, after) of each change that one line allows."""
    code = code_of(line)
    if NOT_CODE.match(code):
        return
    for match in OPERATOR.finditer(code):
        for kind, swaps in SWAPS:
            if match.group() in swaps:
                yield match.start(), kind, match.group(), swaps[match.group()]
    for match in NUMBER.finditer(code):
        for after in number_changes(match.group()):
            yield match.start(), "constant", match.group(), after
    for match in WORD.finditer(code):
        yield match.start(), "word", match.group(), WORDS[match.group()]
    for match in PAIR.finditer(code):
        if match.group(1) != match.group(2):
            yield match.start(1), "swapped arguments", f"{match.group(1)}, {match.group(2)}", \
                f"{match.group(2)}, {match.group(1)}"
    match = STATEMENT.match(code.rstrip())
    if match:
        yield match.start(2), "dropped statement", line[match.start(2):], ";"


def all_of(root, pattern=""):
    """All mutants of files whose path matches."""
    mutants, seen = [], collections.Counter()
    for path in sorted(root.glob("core/src/**/*.cpp")):
        name = str(path.relative_to(root))
        if not re.search(pattern, name):
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            for column, kind, before, after in changes_of(line):
                # A name stays if other lines or comments change. Equal lines of a file are told apart by their order.
                words = f"{name} {code_of(line).strip()} {column - len(line) + len(line.lstrip())} {kind} {after}"
                seen[words] += 1
                identity = hashlib.sha256(f"{words} {seen[words]}".encode()).hexdigest()[:10]
                mutants.append(Mutant(identity, name, number, column, kind, before, after))
    return mutants


def chosen(root, seed, pattern):
    """All mutants whose file matches, in the order that the seed gives them. A kind is drawn first, so that constants,
    which are many, are not nearly all."""
    rng = random.Random(seed)
    by_kind = collections.defaultdict(list)
    for mutant in all_of(root, pattern):
        by_kind[mutant.kind].append(mutant)
    for mutants in by_kind.values():
        rng.shuffle(mutants)
    order = []
    while by_kind:
        kind = rng.choice(sorted(by_kind))
        order.append(by_kind[kind].pop())
        if not by_kind[kind]:
            del by_kind[kind]
    return order


def apply(mutant, text):
    lines = text.split("\n")
    line = lines[mutant.line - 1]
    assert line[mutant.column:].startswith(mutant.before)
    lines[mutant.line - 1] = line[:mutant.column] + mutant.after + line[mutant.column + len(mutant.before):]
    return "\n".join(lines)
