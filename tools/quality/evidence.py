#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes docs/measurements/evidence.md from the results that the other tools left in docs/measurements: campaigns.csv,
proofs.csv, capacities.csv, coverage.csv, mutation.csv and fuzz.csv. What has no results has no rows. Says of each table
whether it was measured on the present core.

  add NAME [FOLDER]   first adds the table of a campaign of build/campaign, or a state of build/attack, or of FOLDER.
                      Other seeds of the same family and settings add up if the core is the same. Runs of an earlier core
                      stay until there are as many of this one; --replace: drops them
  check               writes nothing; exit status 1 where the page is not what its tables say"""
import csv
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/campaigns"))
import bounds  # noqa: E402
import campaign_rows  # noqa: E402
import core_id  # noqa: E402

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
FAILED = {"plan": "no plan (seed, reason)", "fly": "not reached (seed, reason)", "attack": "violations (case, kind)"}
# What the rate of a kind counts.
RATED = {"plan": ("runs", "plans/s"), "fly": ("runs", "flights/s"), "attack": ("plans", "plans/s")}

HEAD = """# Evidence

How often failures were looked for, and how many were found. `tools/evidence` writes this page from the results of the
commands below; [how it is measured](../evidence.md) explains them.

Written for the core `{core}`, a hash of the sources under `core/`. What was measured on an earlier core says so.
"""
HEAD_CORE = re.compile(r"^Written for the core `(\w+)`", re.M)


class Page:
    """The page for one core, and what it says of each table."""

    def __init__(self, core):
        self.core, self.said, self.campaigns = core, [], campaign_rows.totals(parts())

    def age(self, what, cores):
        """Notes which cores a table is of, and says so: in one sentence."""
        cores = set(cores)
        old = cores - {self.core}
        text = "measured on this core" if not old else \
            "measured on an earlier core" if self.core not in cores else "measured in part on an earlier core"
        self.said.append(f"{what}: {text}")
        return f"{text[0].upper()}{text[1:]}."

    def label(self, core):
        return "this" if core == self.core else "earlier"

    def text(self):
        self.said = []
        parts_of_page = (in_all, campaigns, proofs, capacities, coverage, mutation, fuzzers)
        return HEAD.format(core=self.core) + "".join(part(self) for part in parts_of_page)


def read(name):
    path = FOLDER / name
    lines = path.read_text().splitlines() if path.exists() else []
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def table(columns, rows):
    lines = [columns, ["---"] * len(columns), *rows]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)


def percent(part, whole):
    return f"{100.0 * part / whole:.1f} %" if whole else "-"


# ---- campaigns

def parts():
    """The rows of campaigns.csv. The first ones did not say of which core they are."""
    return [{column: row.get(column) or "" for column in campaign_rows.COLUMNS} for row in read("campaigns.csv")]


def rate(row, kind):
    hours = row["core hours"]
    return f"{int(row[RATED[kind][0]]) / (3600.0 * hours):.3g}" if hours else ""


def campaigns(page):
    text = ""
    for kind, title in (("plan", "Plans"), ("fly", "Flights"), ("attack", "The attack")):
        chosen = [row for row in page.campaigns if row["kind"] == kind]
        if not chosen:
            continue
        shown = SHOWN[kind]
        number = lambda column: sum(int(row[column] or 0) for row in chosen)
        body = [[row["date"], page.label(row["core"]), row["seeds"], row["settings"], *(row[column] for column in shown),
                 rate(row, kind), row["failed"]] for row in chosen]
        body.append(["all", "", "", "",
                     *(number(column) if column in campaign_rows.SUMMED else "" for column in shown), "", ""])
        runs, contacts = number("runs"), number("contacts")
        text += (f"\n## {title}\n\n`tools/campaign {kind}` ([campaigns](../campaigns.md)). "
                 f"{page.age(title, (row['core'] for row in chosen))} Rates are those of one "
                 "process; several may have shared a core.\n\n" +
                 table(["date", "core", "seeds", "settings", *(title or column for column, title in shown.items()),
                        RATED[kind][1], FAILED[kind]], body) +
                 f"\n{contacts} contacts in {runs} {shown['runs']}: with 95 % confidence less than 1 in "
                 f"{1.0 / bounds.upper(contacts, runs):.0f} of such {shown['runs']}.\n")
    return text


def in_all(page):
    """What was run: sums over all campaigns and fuzzers, on this core and on all."""
    fuzzed = read("fuzz.csv")

    def sums(is_meant):
        here = [row for row in page.campaigns if is_meant(row)]
        number = lambda column, *chosen: sum(int(row[column] or 0) for row in here if row["kind"] in chosen)
        inputs = [row for row in fuzzed if is_meant(row)]
        flown = number("plans", "fly")
        plans = flown + number("runs", "plan") + number("plans", "attack")
        return [f"{plans}, of them {flown} in flights", number("runs", "fly"), number("runs", "attack"),
                f"{sum(row['core hours'] or 0 for row in here):.1f}", number("contacts", *SHOWN),
                number("invariants broken", *SHOWN),
                f"{sum(int(row['inputs']) for row in inputs)} in "
                f"{sum(int(row['seconds']) for row in inputs) / 3600.0:.1f} hours"]

    what = ["random plans", "random flights", "cases of the attack", "hours of these campaigns' processes", "contacts",
            "other broken promises", "fuzzed inputs"]
    rows = zip(what, sums(lambda row: row.get("core") == page.core), sums(lambda row: True))
    return "\n## In all\n\n" + table(["what", "on this core", "with the runs on earlier cores"], rows)


# ---- exact proofs

def proofs(page):
    """The columns of proofs.csv as they are; its `core` says of which core they are."""
    rows = read("proofs.csv")
    if not rows:
        return ""
    columns = [column for column in rows[0] if column != "core"]
    body = [[page.label(row.get("core")), *(row[column] for column in columns)] for row in rows]
    return (f"\n## Exact proofs\n\n`tern verify`, in rational numbers ([verification](../verify.md)). "
            f"{page.age('Exact proofs', (row.get('core') for row in rows))}\n\n" + table(["core", *columns], body))


# ---- statuses and capacities

def capacities(page):
    rows = read("capacities.csv")
    if not rows:
        return ""
    return (f"\n## Statuses and capacities\n\n`tools/capacities`, {rows[0]['date']}, in the tiny profile. "
            f"{page.age('Statuses and capacities', (row['core'] for row in rows))}\n\n" +
            table(["what", "number", "failed"], [[row["what"], row["number"], row["failed"]] for row in rows]))


# ---- branches

def coverage(page):
    rows = read("coverage.csv")
    if not rows:
        return ""
    body = []
    for row in rows:
        total, taken, named = (int(row[column]) for column in ("branches", "taken", "named"))
        body.append([row["stage"], total, taken, percent(taken, total), named, total - taken - named])
    return (f"\n## Branches\n\n`tools/coverage`, {rows[0]['date']}: {rows[0]['tests']} test programs. "
            f"{page.age('Branches', (row.get('core') for row in rows))} Named exceptions stand in "
            "`tests/coverage/exceptions.txt`.\n\n" +
            table(["stage", "branches", "taken", "share", "named exceptions", "not taken"], body))


# ---- mutants

def mutants_row(name, rows, named):
    count = lambda result: sum(row["result"] == result for row in rows)
    killed, survived = count("killed"), count("survived")
    known = sum(row["result"] == "survived" and row["id"] in named for row in rows)
    matter = killed + survived
    least = f"{100.0 * bounds.lower(killed, matter):.1f} %" if matter else "-"
    return [name, len(rows), killed, survived, known, count("equivalent"), count("not built"),
            percent(killed, matter), least]


def mutation(page):
    path = FOLDER / "mutation.csv"
    rows = list({row["id"]: row for row in read("mutation.csv")}.values())  # one that was tried again counts once
    if not rows:
        return ""
    survivors = ROOT / "tests/mutation/survivors.txt"
    named = {line.split()[0] for line in survivors.read_text().splitlines() if line and not line.startswith("#")}
    columns = ["tried", "killed", "survived", "of them named", "no result changed", "not built", "killed share",
               "at least"]
    stage = lambda row: row["path"].split("/")[2]
    of_kind = [mutants_row(kind, [row for row in rows if row["kind"] == kind], named)
               for kind in sorted({row["kind"] for row in rows})]
    of_stage = [mutants_row(name, [row for row in rows if stage(row) == name], named)
                for name in sorted({stage(row) for row in rows})]
    whole = mutants_row("all", rows, named)
    seeds = ", ".join(sorted({row["seed"] for row in rows}, key=int))
    core = path.read_text().split("\n", 1)[0].removeprefix("# core ")
    return (f"\n## Mutants\n\n`tools/mutate`, seeds {seeds}, {max(row['date'] for row in rows)}. "
            f"{page.age('Mutants', [core])} Killed share: of those that change a result; at least: its lower bound with "
            "95 % confidence (exact binomial). Named survivors stand in `tests/mutation/survivors.txt`.\n\n" +
            table(["change", *columns], [*of_kind, whole]) + "\n" + table(["stage", *columns], [*of_stage, whole]))


# ---- fuzzers

def fuzzers(page):
    rows = read("fuzz.csv")
    if not rows:
        return ""
    body = []
    for entry in dict.fromkeys(row["entry"] for row in rows):
        chosen = [row for row in rows if row["entry"] == entry]
        total = lambda column, some: sum(int(row[column]) for row in some)
        seconds, inputs = total("seconds", chosen), total("inputs", chosen)
        recent = total("seconds", (row for row in chosen if row.get("core") == page.core))
        body.append([entry, chosen[-1]["date"], len(chosen), f"{seconds / 3600.0:.2f}", f"{recent / 3600.0:.2f}", inputs,
                     f"{inputs / max(1, seconds):.0f}", max(int(row["coverage edges"]) for row in chosen),
                     total("found wrong", chosen)])
    return (f"\n## Fuzzers\n\n`tools/fuzz`: libFuzzer with address and undefined-behaviour sanitizers. "
            f"{page.age('Fuzzers', (row.get('core') for row in rows))}\n\n" +
            table(["entry", "last run", "runs", "hours", "of them on this core", "inputs", "inputs/s", "edges",
                   "found wrong"], body))


# ---- the command

def state_of(name, folder):
    """The state of a campaign or of tools/attack; None where there is none."""
    folders = [pathlib.Path(folder)] if folder else [ROOT / "build/campaign", ROOT / "build/attack"]
    found = [path for place in folders for path in (place / f"{name}.csv", place / f"{name}.state") if path.exists()]
    if not found:
        print(f"tools/evidence: no {name}.csv or {name}.state in {' or '.join(map(str, folders))}", file=sys.stderr)
    return found[0] if found else None


def add(words, replaces):
    path = state_of(words[0], words[1] if len(words) == 2 else "")
    return 1 if path is None else campaign_rows.add(path, FOLDER / "campaigns.csv", parts(), replaces)


def check():
    """The page may be of an earlier core, which it then says; but it must be what its tables say."""
    text = PAGE.read_text() if PAGE.exists() else ""
    found = HEAD_CORE.search(text)
    page = Page(found.group(1) if found else core_id.present())
    if page.text() != text:
        print(f"{PAGE} is not what tools/evidence writes: run it")
        return 1
    if page.core != core_id.present():
        print(f"as it would be written, but the core has changed since: it was {page.core}")
        page = Page(core_id.present())
        page.text()
    print("\n".join(page.said))
    return 0


def main():
    words = [word for word in sys.argv[1:] if word != "--replace"]
    if words == ["check"]:
        return check()
    if words[:1] == ["add"] and len(words) in (2, 3):
        if add(words[1:], "--replace" in sys.argv):
            return 1
    elif words:
        print(__doc__, file=sys.stderr)
        return 2
    page = Page(core_id.present())
    PAGE.write_text(page.text())
    print("\n".join([*page.said, f"{PAGE.relative_to(ROOT)} is written"]))
    return 0


if __name__ == "__main__":
    sys.exit(main())
