# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The rows of docs/measurements/campaigns.csv: parts of campaigns that add up. A part is what one campaign, or one run
of tools/attack, made of a family with some settings and some seeds on one core."""
import collections
import csv
import datetime
import pathlib
import re
import sys

import kinds
import table

# Of a part; the columns of a campaign's table are between `family` and `core`.
COLUMNS = ["kind", "date", "seeds", "settings", *table.COLUMNS, "core", "core hours", "failed"]
MOST_FAILED = 20  # runs that are named
Seeds = collections.namedtuple("Seeds", "of first last")  # `of`: the seed of an attack, whose cases are numbered


def seeds_of(part):
    """What a part has run: `1 to 1000`, or `seed 7` or `seed 7 from 5000` for so many cases of an attack."""
    words = re.match(r"(?:seed (\d+)(?: from (\d+))?|(\d+) to (\d+))$", part["seeds"]).groups()
    if words[0] is None:
        return Seeds("", int(words[2]), int(words[3]))
    first = int(words[1] or 0)
    return Seeds(words[0], first, first + int(part["runs"]) - 1)


def key(part):
    return part["kind"], part["family"], part["settings"], part["core"]


def contains(a, b):
    return a.of == b.of and a.first <= b.first and b.last <= a.last


def overlap(a, b):
    return a.of == b.of and a.first <= b.last and b.first <= a.last


# ---- what there is to add

def failed_of(kind, entries):
    """Seeds of runs that did not succeed, with the reason."""
    bad = [entry for entry in entries if entry["status"] != kinds.KINDS[kind].good]
    words = [f"{entry['seed']} {entry['status']}{': ' if entry.get('reason') else ''}{entry.get('reason') or ''}"
             for entry in bad[:MOST_FAILED]]
    return "; ".join(words) + (f"; and {len(bad) - MOST_FAILED} more" if len(bad) > MOST_FAILED else "")


def hours_of(entries):
    seconds = [float(entry["seconds"]) for entry in entries if entry.get("seconds")]
    return f"{sum(seconds) / 3600.0:.4f}" if seconds else ""


def campaign_parts(path):
    """The rows of a campaign's table with its state; None where the table has not all of the state's runs."""
    head, *lines = path.read_text().splitlines()
    kind = head.split()[1]
    given = re.search(r"settings (.*?)(, seed \d+)?$", head)
    defaults = kinds.KINDS[kind].settings_default
    settings = " ".join(word for word in (given.group(1).split() if given else []) if word not in defaults)
    seed, core = (re.search(pattern, head) for pattern in (r", seed (\d+)", r", core (\w+)"))
    date = datetime.date.fromtimestamp(path.stat().st_mtime).isoformat()
    entries = collections.defaultdict(list)
    for entry in csv.DictReader(lines):
        entries[entry["row"]].append(entry)
    parts = []
    for row in csv.DictReader(path.with_name(f"{path.stem}-table.csv").read_text().splitlines()):
        runs = entries[row["family"]]
        which = sorted(int(entry["seed"]) for entry in runs)
        block = kinds.BLOCK if seed else 1
        whole = which == list(range(which[0], which[0] + len(which) * block, block)) if which else False
        if not whole or len(which) * block != int(row["runs"]):
            print(f"tools/evidence: the seeds of {row['family']} have a gap, or the table has not all of them: run the "
                  "campaign again with all its seeds first", file=sys.stderr)
            return None
        said = f"seed {seed.group(1)}" if seed else f"{which[0]} to {which[-1]}"
        parts.append({"kind": kind, "date": date, "seeds": said, "settings": settings, **row,
                      "core": core.group(1) if core else "", "core hours": hours_of(runs),
                      "failed": failed_of(kind, runs)})
    return parts


def attack_parts(path):
    """The families of a state of tools/attack; None where a block of cases between others is missing."""
    seed, family, first = re.match(r"seed(\d+)(?:-([a-z]+))?(?:-from(\d+))?$", path.stem).groups()
    lines = collections.defaultdict(list)
    for line in path.read_text().splitlines():
        lines[line.split()[0]].append(line.split()[1:])
    families, violations = (lines["families"] or [[]])[0], [words[:2] for words in lines["violation"]]
    blocks = sorted(int(words[0]) for words in lines["block"])
    if blocks != list(range(len(blocks))) or not families:
        print(f"tools/evidence: {path} lacks blocks of cases: finish its run first", file=sys.stderr)
        return None
    core = (lines["core"] or [[""]])[0][0]
    date = datetime.date.fromtimestamp(path.stat().st_mtime).isoformat()
    parts = []
    for index, own in enumerate(families):
        tally = [int(word) for word in lines["tally"][index]]
        if tally[0] == 0:
            continue
        head, rest = dict(zip(kinds.FIRST_TALLIES, tally)), tally[len(kinds.FIRST_TALLIES):]
        found = [(number, kind) for number, kind in violations if int(number) % len(families) == index]
        contacts = sum(kind in kinds.TOUCHING for _, kind in found)
        # The first case is counted over all families, or over the one that was asked for.
        begin = int(first or 0) if family else int(first or 0) // len(families)
        row = {column: "" for column in table.COLUMNS}
        row.update({"family": own, "runs": head["cases"], "success": dict(zip(rest[::2], rest[1::2])).get(0, 0),
                    "contacts": contacts, "invariants broken": len(found) - contacts, "plans": head["plans"],
                    "units a plan": table.share(head["work"], head["plans"])})
        parts.append({"kind": "attack", "date": date, "seeds": f"seed {seed}" + (f" from {begin}" if begin else ""),
                      "settings": "", **row, "core": core, "core hours": "",
                      "failed": "; ".join(f"{number} {kind}" for number, kind in found[:MOST_FAILED])})
    return parts


# ---- how parts add up

def place(part, parts, replaces):
    """Puts a part among the others: None, or why it is refused. It takes the place of parts whose seeds it has, too.
    Parts of other cores stay until there are as many runs on this one, or until `replaces` says so."""
    seeds = seeds_of(part)
    for other in [other for other in parts if key(other) == key(part)]:
        there = seeds_of(other)
        if contains(seeds, there):
            parts.remove(other)
        elif overlap(seeds, there):
            return f"{part['family']} has {part['seeds']}, and {other['seeds']} is there already: runs would count twice"
    parts.append(part)
    runs = sum(int(other["runs"]) for other in parts if key(other) == key(part))
    for other in [other for other in parts if key(other)[:3] == key(part)[:3] and other["core"] != part["core"]]:
        if replaces or int(other["runs"]) <= runs:
            parts.remove(other)
        else:
            print(f"tools/evidence: {part['family']} keeps {other['runs']} runs of an earlier core until there are as "
                  "many of this one; --replace drops them", file=sys.stderr)
    return None


def add(path, file, parts, replaces):
    """Adds a campaign or a state of tools/attack to `parts`, and writes them to `file`. Returns the exit status."""
    added = attack_parts(path) if path.suffix == ".state" else campaign_parts(path)
    for part in added or []:
        why = place(part, parts, replaces)
        if why:
            print(f"tools/evidence: {why}: nothing is added", file=sys.stderr)
            return 1
    if not added:
        return 1
    with pathlib.Path(file).open("w", newline="") as out:
        writer = csv.DictWriter(out, COLUMNS, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(sorted(parts, key=lambda part: (*key(part), seeds_of(part))))
    return 0


# ---- sums

SUMMED = {"runs", "success", "contacts", "invariants broken", "plans", "plans dropped"}
LEAST, MOST = {"least clearance, m"}, {"tracking error, m", "most units a tick", "p95"}
# Means, and what they are means over.
MEANS = {"mean speed, m/s": "success", "time over full knowledge, mean": "success", "units a plan": "plans"}
DIGITS = {"units a plan": 0, "mean speed, m/s": 2}


def total(parts):
    """One row of parts with the same key."""
    row = {column: parts[-1][column] for column in COLUMNS}
    row["date"] = max(part["date"] for part in parts)
    row["seeds"] = ", ".join(dict.fromkeys(part["seeds"] for part in parts))
    row["failed"] = "; ".join(part["failed"] for part in parts if part["failed"])
    hours = [float(part["core hours"]) for part in parts if part["core hours"]]
    row["core hours"] = sum(hours) if len(hours) == len(parts) else ""
    for column in SUMMED:
        row[column] = sum(int(part[column] or 0) for part in parts) if any(part[column] for part in parts) else ""
    for column, pick in [*((column, min) for column in LEAST), *((column, max) for column in MOST)]:
        values = [part[column] for part in parts if part[column]]
        row[column] = pick(values, key=float) if values else ""
    for column, over in MEANS.items():
        weights = [(float(part[column]), int(part[over])) for part in parts if part[column] and int(part[over] or 0)]
        whole = sum(weight for _, weight in weights)
        row[column] = f"{sum(value * weight for value, weight in weights) / whole:.{DIGITS.get(column, 3)}f}" \
            if whole else ""
    return row


def totals(parts):
    """One row for each kind, family, settings and core."""
    grouped = collections.defaultdict(list)
    for part in parts:
        grouped[key(part)].append(part)
    return [total(group) for group in grouped.values()]
