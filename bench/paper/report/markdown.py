# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results as the program wrote them, and tables of Markdown."""
import csv
import pathlib
import textwrap


class Results:
    """The folder of one run; parts that were not run are empty."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def lines(self, part, name):
        path = self.folder / part / name
        return path.read_text().splitlines() if path.exists() else []

    def rows(self, part, name):
        lines = [line for line in self.lines(part, name) if not line.startswith("#")]
        return list(csv.DictReader(lines))

    def machine(self, part, name):
        """What the part was measured on, as its table says."""
        lines = self.lines(part, name)
        return lines[0][2:] if lines else ""

    def pictures(self, part):
        return sorted((self.folder / part).glob("*.svg"))


def table(header, rows):
    """A table; every cell is text already."""
    lines = ["| " + " | ".join(header) + " |", "|" + " --- |" * len(header)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def number(text, decimals):
    return f"{float(text):.{decimals}f}"


def milliseconds(text):
    """Three significant digits, without an exponent."""
    value = float(text)
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 else f"{value:.2f}" if value >= 1 else f"{value:.3f}"


def percent(value, decimals=1):
    return f"{100 * value:.{decimals}f} %"


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else 0.0


def picture(name, text):
    return f"![{text}](paper/{name})\n"


def _is_prose(block):
    return not block.startswith(("|", "#", "!", "`"))


def _wrapped_block(block):
    items = []
    for line in block.split("\n"):
        if line.startswith("- ") or not items:
            items.append(line.strip())
        else:
            items[-1] += " " + line.strip()
    return "\n".join(textwrap.fill(item, 120, subsequent_indent="  " if item.startswith("- ") else "",
                                    break_long_words=False, break_on_hyphens=False) for item in items)


def wrapped(text):
    """The page with its paragraphs and lists filled to 120 columns; tables, headings and pictures as they are."""
    blocks = [block.strip("\n") for block in text.split("\n\n")]
    return "\n\n".join(_wrapped_block(b) if _is_prose(b) else b for b in blocks if b) + "\n"
