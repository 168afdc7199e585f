#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""evidence_test.py TOOLS: how runs of campaigns add up, what the page says of their core, and the bounds."""
import csv
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from expectations import expect, status  # noqa: E402

TOOLS = pathlib.Path(sys.argv[1])
sys.path[:0] = [str(TOOLS / "quality"), str(TOOLS / "campaigns")]
import bounds  # noqa: E402
import campaign_rows  # noqa: E402
import core_id  # noqa: E402
import evidence  # noqa: E402


def state(folder, name, seeds, core, bad=()):
    """A campaign of flights that all reach the goal in 10 s, but those of `bad`."""
    runs = [f"P25,{seed},{'stuck' if seed in bad else 'reached'},{'no way' if seed in bad else ''},10" for seed in seeds]
    (folder / f"{name}.csv").write_text("\n".join([f"# fly program 1, core {core}, settings tracking=bounded v_max=9",
                                                   "row,seed,status,reason,seconds", *runs]) + "\n")
    row = dict.fromkeys(campaign_rows.table.COLUMNS, "")
    row.update({"family": "P25", "runs": len(runs), "success": len(runs) - len(bad), "contacts": 0, "plans": 7,
                "units a plan": 100 * len(runs), "least clearance, m": 0.01 * len(runs)})
    with (folder / f"{name}-table.csv").open("w", newline="") as file:
        csv.writer(file).writerows([row.keys(), row.values()])
    return folder / f"{name}.csv"


def attack_state(folder, name, cases, core):
    (folder / f"{name}.state").write_text(
        f"program 1\ncore {core}\nseconds 9\nfamilies noise boxes\ntally {cases} 30 0 0 0 0 0 0 0 600 0 20 30 10\n"
        f"tally {cases} 40 0 0 0 0 0 0 0 400 0 40\nblock 0\nviolation 3 clearance by much\nviolation 4 work more\n")
    return folder / f"{name}.state"


def adding(folder):
    file = folder / "campaigns.csv"
    parts = []
    add = lambda path, replaces=False: campaign_rows.add(path, file, parts, replaces)
    expect("a campaign is added", add(state(folder, "a", range(1, 11), "aa", bad=[3])) == 0 and len(parts) == 1)
    expect("with its core, its hours and what failed", (parts[0]["core"], parts[0]["settings"], parts[0]["failed"]) ==
           ("aa", "v_max=9", "3 stuck: no way") and abs(float(parts[0]["core hours"]) - 100 / 3600) < 1e-4)
    expect("other seeds add up", add(state(folder, "b", range(11, 31), "aa")) == 0 and len(parts) == 2)
    total = campaign_rows.totals(parts)[0]
    expect("sums", (total["runs"], total["success"], total["plans"], total["seeds"]) == (30, 29, 14, "1 to 10, 11 to 30"))
    expect("weighted means, and the least", (total["units a plan"], total["least clearance, m"]) == ("1500", "0.1"))
    expect("more runs take the place of fewer", add(state(folder, "a", range(1, 11), "aa")) == 0 and len(parts) == 2)
    before = file.read_text()
    expect("runs do not count twice", add(state(folder, "c", range(25, 40), "aa")) == 1 and file.read_text() == before)
    expect("an unfinished campaign is refused", add(state(folder, "d", [100, 102], "aa")) == 1)
    expect("an earlier core's runs stay", add(state(folder, "e", range(1, 6), "bb")) == 0 and len(parts) == 3)
    expect("until there are as many", add(state(folder, "f", range(6, 31), "bb")) == 0 and
           {part["core"] for part in parts} == {"bb"})
    expect("or until they are dropped", add(state(folder, "g", range(1, 3), "cc"), True) == 0 and
           {part["core"] for part in parts} == {"cc"})
    said = summary(parts, "cc")
    expect("the page sums up what this core flew", "| random flights | 2 |" in said and "| random plans | 7, " in said)
    expect("and nothing that another did", "| random flights | 0 |" in summary(parts, "aa"))


def summary(parts, core):
    page = evidence.Page(core)
    page.campaigns = campaign_rows.totals(parts)
    return evidence.in_all(page)


def adding_attacks(folder):
    file, parts = folder / "campaigns.csv", []
    add = lambda path: campaign_rows.add(path, file, parts, False)
    expect("a state of the attack is added", add(attack_state(folder, "seed7", 10, "aa")) == 0 and
           [(part["family"], part["runs"], part["success"], part["contacts"], part["invariants broken"])
            for part in parts] == [("noise", 10, 20, 0, 1), ("boxes", 10, 40, 1, 0)])
    expect("another seed adds up", add(attack_state(folder, "seed8", 10, "aa")) == 0 and
           [total["runs"] for total in campaign_rows.totals(parts)] == [20, 20])
    expect("more cases of a seed take its place", add(attack_state(folder, "seed8", 50, "aa")) == 0 and
           [total["runs"] for total in campaign_rows.totals(parts)] == [60, 60])
    expect("later cases of a seed add up", add(attack_state(folder, "seed8-from100", 10, "aa")) == 0 and
           [total["runs"] for total in campaign_rows.totals(parts)] == [70, 70])


def bounding():
    expect("nothing in 100 trials", abs(bounds.upper(0, 100) - (1.0 - 0.05 ** 0.01)) < 1e-9)
    expect("all of 100 trials", abs(bounds.lower(100, 100) - 0.05 ** 0.01) < 1e-9)
    expect("95 of 100 trials", abs(bounds.lower(95, 100) - 0.897747) < 1e-6)
    expect("no trials", bounds.upper(0, 0) == 1.0 and bounds.lower(0, 0) == 0.0)


def ages():
    page = evidence.Page("aa")
    said = [page.age("t", cores) for cores in (["aa"], ["bb", ""], ["aa", "bb"])]
    expect("of which core a table is", said == ["Measured on this core.", "Measured on an earlier core.",
                                                "Measured in part on an earlier core."])
    expect("the page is checked for the core that it names", evidence.HEAD_CORE.search(page.text()).group(1) == "aa")


def programs(folder):
    program = folder / "program"
    program.write_text("one")
    expect("without a note, a program's core is unknown", core_id.built_from(program) == "unknown")
    core_id.note(program)
    expect("with a note, it is that of the sources", core_id.built_from(program) == core_id.present())
    program.write_text("two")
    expect("built anew, it is unknown", core_id.built_from(program) == "unknown")


def main():
    for check in (adding, adding_attacks, programs):
        with tempfile.TemporaryDirectory() as folder:
            check(pathlib.Path(folder))
    bounding()
    ages()
    return status()


if __name__ == "__main__":
    sys.exit(main())
