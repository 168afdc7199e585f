#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes docs/measurements/evidence.md from the results that the other tools left in docs/measurements: campaigns.csv,
coverage.csv, mutation.csv and fuzz.csv. What has no results has no rows.

  add NAME [FOLDER]   first takes over the table of a campaign, with the date and the seeds of its state. It takes the
                      place of an earlier one of the same families and settings; --replace: even if that has more runs
  check               writes nothing; exit status 1 where the page is not what would be written"""
import collections
import csv
import datetime
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/campaigns"))
import kinds  # noqa: E402

FOLDER = ROOT / "docs/measurements"
PAGE = FOLDER / "evidence.md"
# Of each kind, the columns of a campaign's table, with titles of their own where a campaign's say too little.
SHOWN = {
    "plan": {"family": "", "runs": "plans", "success": "status ok", "contacts": "", "invariants broken": "crashes",
             "units a plan": ""},
    "fly": {"family": "", "runs": "flights", "success": "reached", "contacts": "", "invariants broken": "",
            "time over full knowledge, mean": "", "plans": "", "units a plan": ""},
    "attack": {"family": "", "runs": "cases", "plans": "", "success": "plans with status ok", "contacts": "",
               "invariants broken": "other violations", "units a plan": ""},
}
SUMMED = {"runs", "success", "contacts", "invariants broken", "plans"}

HEAD = """# Evidence

How often failures were looked for, and how many were found. `tools/evidence` writes this page from the results of the
commands below; [how it is measured](../evidence.md) explains them.
"""


def read(name):
    path = FOLDER / name
    lines = path.read_text().splitlines() if path.exists() else []
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def table(columns, rows):
    lines = [columns, ["---"] * len(columns), *rows]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)


def percent(part, whole):
    return f"{100.0 * part / whole:.1f} %" if whole else "-"


def add_campaign(name, folder, replaces):
    """A campaign takes the place of an earlier one of the same kind, family, settings and first seed; if that had more
    runs, only where `replaces` says so. Returns the exit status."""
    state = (folder / f"{name}.csv").read_text().splitlines()
    kind = state[0].split()[1]
    given = re.search(r"settings (.*?)(, seed \d+)?$", state[0])
    defaults = kinds.KINDS[kind].settings_default
    settings = " ".join(word for word in (given.group(1).split() if given else []) if word not in defaults)
    date = datetime.date.fromtimestamp((folder / f"{name}.csv").stat().st_mtime).isoformat()
    seeds = collections.defaultdict(list)
    for row in csv.DictReader(state[1:]):
        seeds[row["row"]].append(int(row["seed"]))
    seed = re.search(r", seed (\d+)", state[0])
    added = []
    for row in csv.DictReader((folder / f"{name}-table.csv").read_text().splitlines()):
        which = seeds[row["family"]]
        if not seed and len(which) != int(row["runs"]):
            print(f"tools/evidence: {row['family']} has {len(which)} runs, and the table {row['runs']} of them: run "
                  "the campaign again with all its seeds first", file=sys.stderr)
            return 1
        said = f"seed {seed.group(1)}" if seed else f"{min(which)} to {max(which)}"
        added.append({"kind": kind, "date": date, "seeds": said, "settings": settings, **row})
    key = lambda row: (row["kind"], row["family"], row["settings"], row["seeds"].split(" to ")[0])
    before = {key(row): row for row in read("campaigns.csv")}
    for row in added:
        larger = before.get(key(row), row)
        if int(larger["runs"]) > int(row["runs"]) and not replaces:
            print(f"tools/evidence: {row['family']} is there already with {larger['runs']} runs, more than "
                  f"{row['runs']}: nothing is added; --replace adds it all the same", file=sys.stderr)
            return 1
    kept = [row for at, row in before.items() if at not in set(map(key, added))]
    with (FOLDER / "campaigns.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, list(added[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(sorted([*kept, *added], key=key))
    return 0


def campaigns():
    rows = read("campaigns.csv")
    text = ""
    for kind, title in (("plan", "Plans"), ("fly", "Flights"), ("attack", "The attack")):
        chosen = [row for row in rows if row["kind"] == kind]
        if not chosen:
            continue
        shown = SHOWN[kind]
        number = lambda column: sum(int(row[column] or 0) for row in chosen)
        text += f"\n## {title}\n\n`tools/campaign {kind}` ([campaigns](../campaigns.md)).\n\n"
        body = [[row["date"], row["seeds"], row["settings"], *(row[column] for column in shown)] for row in chosen]
        body.append(["all", "", "", *(number(column) if column in SUMMED else "" for column in shown)])
        text += table(["date", "seeds", "settings", *(title or column for column, title in shown.items())], body)
    return text


def coverage():
    rows = read("coverage.csv")
    if not rows:
        return ""
    body = []
    for row in rows:
        total, taken, named = (int(row[column]) for column in ("branches", "taken", "named"))
        body.append([row["stage"], total, taken, percent(taken, total), named, total - taken - named])
    return (f"\n## Branches\n\n`tools/coverage`, {rows[0]['date']}: {rows[0]['tests']} test programs. Named exceptions "
            "stand in `tests/coverage/exceptions.txt`.\n\n" +
            table(["stage", "branches", "taken", "share", "named exceptions", "not taken"], body))


def mutation():
    rows = list({row["id"]: row for row in read("mutation.csv")}.values())  # one that was tried again counts once
    if not rows:
        return ""
    path = ROOT / "tests/mutation/survivors.txt"
    named = path.read_text() if path.exists() else ""
    body = []
    for kind in [*sorted({row["kind"] for row in rows}), "all"]:
        chosen = [row for row in rows if kind in ("all", row["kind"])]
        count = lambda result: sum(row["result"] == result for row in chosen)
        matter = count("killed") + count("survived")
        known = sum(row["result"] == "survived" and row["id"] in named for row in chosen)
        body.append([kind, len(chosen), count("killed"), count("survived"), known, count("equivalent"),
                     count("not built"), percent(count("killed"), matter)])
    seeds = ", ".join(sorted({row["seed"] for row in rows}))
    return (f"\n## Mutants\n\n`tools/mutate`, seed {seeds}, {rows[-1]['date']}. Killed share: of those that change a "
            "result. Named survivors stand in `tests/mutation/survivors.txt`.\n\n" +
            table(["change", "tried", "killed", "survived", "of them named", "no result changed", "not built",
                   "killed share"], body))


def fuzzers():
    rows = read("fuzz.csv")
    if not rows:
        return ""
    body = []
    for entry in dict.fromkeys(row["entry"] for row in rows):
        chosen = [row for row in rows if row["entry"] == entry]
        seconds, inputs = (sum(int(row[column]) for row in chosen) for column in ("seconds", "inputs"))
        body.append([entry, chosen[-1]["date"], len(chosen), f"{seconds / 3600.0:.2f}", inputs,
                     f"{inputs / max(1, seconds):.0f}", max(int(row["coverage edges"]) for row in chosen),
                     sum(int(row["found wrong"]) for row in chosen)])
    return ("\n## Fuzzers\n\n`tools/fuzz`: libFuzzer with address and undefined-behaviour sanitizers.\n\n" +
            table(["entry", "last run", "runs", "hours", "inputs", "inputs/s", "edges", "found wrong"], body))


def main():
    words = [word for word in sys.argv[1:] if word != "--replace"]
    if words[:1] == ["add"] and len(words) in (2, 3):
        folder = pathlib.Path(words[2]) if len(words) == 3 else ROOT / "build/campaign"
        if add_campaign(words[1], folder, "--replace" in sys.argv):
            return 1
    elif words and words != ["check"]:
        print(__doc__, file=sys.stderr)
        return 2
    text = HEAD + campaigns() + coverage() + mutation() + fuzzers()
    if words == ["check"]:
        is_same = PAGE.exists() and PAGE.read_text() == text
        print("as it would be written" if is_same else f"{PAGE} is not what tools/evidence writes: run it")
        return 0 if is_same else 1
    PAGE.write_text(text)
    print(f"{PAGE.relative_to(ROOT)} is written")
    return 0


if __name__ == "__main__":
    sys.exit(main())
