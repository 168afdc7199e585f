# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of the evidence: totals of what the steps of `tools/evidence release` left in their folder."""
import collections
import csv
import pathlib
import re
import sys

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / folder) for folder in ("campaigns", "verify")]
import bounds  # noqa: E402
import registry  # noqa: E402
import subjects  # noqa: E402
import table  # noqa: E402

HEAD = """# Evidence for Tern {version}

Core `{core}`, a hash of the code under `core/`; {date}; {machine}; {hours:.1f} hours.
`tools/evidence release` made this page: [evidence](../evidence.md) explains it.
"""
SURVIVORS = pathlib.Path(__file__).resolve().parents[2] / "tests/mutation/survivors.txt"
NAMED = 20  # failed runs of a campaign that are named
# Campaigns, and what the page calls them.
CAMPAIGNS = {"plans": "plans with full knowledge", "flights": "flights", "rigid": "flights of a rigid body",
             "faults": "flights with faults", "attack": "cases of the attack"}


def read(path):
    """The rows of a table, without the line that says what they are of, and that line."""
    lines = path.read_text().splitlines() if path.exists() else []
    head = lines[0] if lines and lines[0].startswith("#") else ""
    return head, list(csv.DictReader(line for line in lines if not line.startswith("#")))


def table_of(columns, rows):
    lines = [columns, ["---"] * len(columns), *rows]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)


def percent(part, whole):
    return f"{100.0 * part / whole:.1f} %" if whole else "-"


# ---- campaigns

def campaign(path):
    """A campaign's row of the page and the lines of its failed runs; None without runs."""
    head, entries = read(path)
    if not entries:
        return None
    kind, settings = re.match(r"# (\w+) .*settings (.*?)(?:, seed \d+)?$", head).groups()
    columns = table.FAULT_COLUMNS if kind == "faults" else table.COLUMNS
    families = collections.defaultdict(list)
    for entry in entries:
        families[entry["row"]].append(entry)
    rows = [dict(zip(columns, map(str, table.ROWS[kind](family, own)))) for family, own in families.items()]
    total = lambda column: sum(int(row[column] or 0) for row in rows) if column in columns else 0
    kind = registry.KINDS[kind]("tern", settings.split(), 0)
    failed = [entry for entry in entries if kind.failed(entry) or kind.excess(entry)]
    lines = [f"- `{entry['row']}:{entry['seed']}`: {entry['status']} {entry.get('reason') or kind.excess(entry)}\n"
             for entry in failed[:NAMED]]
    lines += [f"- and {len(failed) - NAMED} more\n"] if len(failed) > NAMED else []
    row = [" ".join(sorted({family.partition("/")[0] for family in families})), total("runs"),
           total("success") + total("reached"), total("contacts"), total("invariants broken"),
           total("plans") or sum(int(entry.get("asked") or 0) for entry in entries)]
    return row, lines


def campaigns(folder):
    rows, failed = [], ""
    for name, title in CAMPAIGNS.items():
        found = campaign(folder / f"{name}.csv")
        if found:
            row, lines = found
            rows.append([title, *row, f"1 in {1.0 / bounds.upper(row[3], row[1]):.0f}"])
            failed += f"\n{title[0].upper()}{title[1:]} that did not succeed:\n\n{''.join(lines)}" if lines else ""
    if not rows:
        return ""
    columns = ["what", "families", "runs", "succeeded", "contacts", "other broken promises", "plans",
               "contacts with 95 % confidence less than"]
    return ("\n## Random runs\n\n[Campaigns](../campaigns.md) explains families and columns. Of the attack, plans "
            "succeed; contacts that a fault explains\nare not counted.\n\n" + table_of(columns, rows) + failed)


# ---- exact proofs

def proofs(folder):
    rows = []
    for name, kind in (("proven-plans", subjects.Plans), ("proven-flights", subjects.Flights)):
        _, runs = read(folder / f"{name}.csv")
        used = [float(value) for run in runs for column, value in run.items() if column.endswith(" used") and value]
        if runs:
            proven, claims = sum(run["status"] == "proven" for run in runs), sum(int(run["claims"] or 0) for run in runs)
            rows.append([kind.name, len(runs), kind.counts(runs)[kind.name], proven, claims,
                         percent(max(used, default=0.0), 1.0)])
    if not rows:
        return ""
    columns = ["of", "runs", "made", "proven", "claims", "largest part of a tolerance that is used"]
    return "\n## Exact proofs\n\n[Verify](../verify.md) explains the claims.\n\n" + table_of(columns, rows)


# ---- what the tests reach

def capacities(folder):
    _, rows = read(folder / "capacities.csv")
    return "\n## Statuses and capacities\n\n" + table_of(rows[0], [row.values() for row in rows]) if rows else ""


def coverage(folder):
    _, rows = read(folder / "coverage.csv")
    whole = next((row for row in rows if row["stage"] == "all"), None)
    if whole is None:
        return ""
    number, taken, named = (int(whole[column]) for column in ("branches", "taken", "named"))
    return (f"\n## Branches\n\nTests take {taken} of {number} branches of the core ({percent(taken, number)}); {named} "
            f"are named in\n`tests/coverage/exceptions.txt`, {number - taken - named} are neither.\n")


def mutants(folder):
    _, rows = read(folder / "mutants.csv")
    if not rows:
        return ""
    rows = list({row["id"]: row for row in rows}.values())  # one that was tried again counts once
    lines = SURVIVORS.read_text().splitlines()
    named = {line.split()[0] for line in lines if line and not line.startswith("#")}
    count = lambda result: sum(row["result"] == result for row in rows)
    alive = [row["id"] for row in rows if row["result"] == "survived"]
    matter = count("killed") + len(alive)
    columns = ["tried", "killed", "survived", "of them named", "no result changed", "not built", "killed share",
               "at least"]
    body = [len(rows), count("killed"), len(alive), len(named.intersection(alive)), count("equivalent"),
            count("not built"), percent(count("killed"), matter), percent(bounds.lower(count("killed"), matter), 1.0)]
    return ("\n## Mutants\n\nThe killed share is of those that change a result; at least: with 95 % confidence.\n\n" +
            table_of(columns, [body]) + (f"\nSurvived: {', '.join(alive)}.\n" if alive else ""))


def fuzzers(folder):
    _, rows = read(folder / "fuzz.csv")
    body = []
    for entry in sorted({row["entry"] for row in rows}):
        total = lambda column: sum(int(row[column]) for row in rows if row["entry"] == entry)
        edges = max(int(row["coverage edges"]) for row in rows if row["entry"] == entry)
        body.append([entry, f"{total('seconds') / 3600.0:.2f}", total("inputs"), edges, total("found wrong")])
    columns = ["entry", "hours", "inputs", "edges", "found wrong"]
    return "\n## Fuzzers\n\n" + table_of(columns, body) if body else ""


def text(version, core, folder, steps, missing):
    """The whole page. `steps` is what the journal has of each step; `missing` are names of those that did not end."""
    head = HEAD.format(version=version, core=core, date=max(step["date"] for step in steps.values()),
                       machine=" and ".join(sorted({step["machine"] for step in steps.values()})),
                       hours=sum(step["seconds"] for step in steps.values()) / 3600.0)
    head += f"Not run to the end: {', '.join(missing)}.\n" if missing else ""
    return head + "".join(part(folder) for part in (campaigns, proofs, capacities, coverage, mutants, fuzzers))
