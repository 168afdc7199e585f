# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of a campaign: one row a family. It depends on the runs alone and not on who made them in which order:
sums are whole numbers, or rounded once (math.fsum)."""
import csv
import math
import pathlib
import statistics

COLUMNS = ["family", "runs", "success", "contacts", "invariants broken", "mean speed, m/s",
           "time over full knowledge, mean", "p95", "tracking error, m", "least clearance, m", "plans", "units a plan",
           "most units a tick", "plans dropped", "s of threat"]

FLY_COLUMNS = [*COLUMNS, "time over straight way, median", "longest, s", "standing, s, mean"]

SWARM_COLUMNS = ["swarms", "links", "runs", "all arrived", "vehicles", "arrived", "contacts", "not as agreed",
                 "least gap, mm", "travel, s, mean", "travel, s, largest mean", "last arrival, s", "brakes unasked"]

FAULT_COLUMNS = ["family", "fault", "runs", "reached", "at rest, says why", "still flying", "threats",
                 "contacts, assumption broken", "contacts", "invariants broken", "least clearance, m",
                 "fastest contact, m/s", "above an immediate brake, m/s", "s of threat"]


def numbers(key, entries):
    return [float(entry[key]) for entry in entries if entry.get(key)]


def total(key, entries):
    return sum(int(entry[key]) for entry in entries if entry.get(key))


def mean(values):
    return math.fsum(values) / len(values) if values else 0.0


def quantile(values, part):
    return sorted(values)[min(len(values) - 1, int(part * len(values)))] if values else 0.0


def count(entries, *statuses):
    return sum(entry["status"] in statuses for entry in entries)


def share(work, plans):
    return f"{work / max(1, plans):.0f}"


def fly_row(row, flights):
    reached = [entry for entry in flights if entry["status"] == "reached"]
    ratio = [float(entry["time_s"]) / float(entry["full_knowledge_s"]) for entry in reached
             if float(entry["full_knowledge_s"]) > 0.0]
    asked = total("asked", flights)
    return [row, len(flights), len(reached), count(flights, "collision"),
            count(flights, "invariant", "crash", "too_long"),
            f"{mean(numbers('mean_speed', reached)):.2f}",
            f"{mean(ratio):.3f}" if ratio else "", f"{quantile(ratio, 0.95):.3f}" if ratio else "",
            f"{max(numbers('tracking_max', flights), default=0.0):.3f}",
            f"{min(numbers('min_clearance', flights), default=0.0):.3f}",
            asked, share(total("work_total", flights), asked),
            f"{max(numbers('work_max', flights), default=0.0):.0f}",
            total("dropped", flights), f"{math.fsum(numbers('threat_s', flights)):.2f}", *straight_columns(reached)]


def straight_columns(reached):
    ratio = [float(entry["time_s"]) / float(entry["straight_s"]) for entry in reached if entry.get("straight_s")]
    return [f"{statistics.median(ratio):.2f}" if ratio else "", f"{max(numbers('time_s', reached), default=0.0):.2f}",
            f"{mean(numbers('standing_s', reached)):.2f}"]


def faults_row(row, flights):
    """A threat met what appeared, as slowly as could be; `contacts` had no excuse."""
    family, _, fault = row.partition("/")
    touched = [entry for entry in flights if entry["status"] == "collision"]
    excused = sum(bool(entry.get("broken_assumption")) for entry in touched)
    above = [float(entry["commanded_speed"]) - float(entry["brake_speed"])
             for entry in flights if entry.get("brake_speed")]
    return [family, fault, len(flights), count(flights, "reached"), count(flights, "stuck"), count(flights, "timeout"),
            count(flights, "threat"), excused, len(touched) - excused,
            count(flights, "invariant", "crash", "too_long"),
            f"{min(numbers('min_clearance', flights), default=0.0):.3f}",
            f"{max(numbers('contact_speed', flights)):.2f}" if numbers("contact_speed", flights) else "",
            f"{max(above):.2f}" if above else "", f"{math.fsum(numbers('threat_s', flights)):.2f}"]


def plan_row(row, plans):
    """The clearance column is what is left beyond the radius asked for, as sampled."""
    made = [entry for entry in plans if entry["status"] == "ok"]
    speeds = [float(entry["length_m"]) / float(entry["duration_s"]) for entry in made
              if float(entry["duration_s"]) > 0.0]
    clear = [float(entry["least_clearance"]) for entry in plans if entry.get("least_clearance")]
    return [row, len(plans), len(made), count(plans, "collision"), count(plans, "crash", "check_failed"),
            f"{mean(speeds):.2f}", "", "", "", f"{min(clear):.3f}" if clear else "", len(plans),
            share(total("work", plans), len(plans)), "", "", ""]


def attack_row(row, blocks):
    plans = total("plans", blocks)
    broken = sum(len(entry["violations"].split(";")) for entry in blocks if entry.get("violations"))
    contacts = total("contacts", blocks)
    return [row, total("cases", blocks), total("ok", blocks), contacts, broken - contacts + count(blocks, "crash"), "",
            "", "", "", "", plans, share(total("work", blocks), plans), "", "", ""]


def swarm_row(row, runs):
    family, _, links = row.partition("/")
    travel = numbers("travel_s", runs)
    return [family, links.replace(",", " ") or "perfect", len(runs), count(runs, "arrived"), total("vehicles", runs),
            total("arrived", runs), total("contacts", runs), count(runs, "disagreed", "crash", "too_long"),
            f"{1000.0 * min(numbers('least_gap', runs), default=0.0):.1f}", f"{mean(travel):.2f}",
            f"{max(travel, default=0.0):.2f}", f"{max(numbers('last_s', runs), default=0.0):.2f}",
            total("unasked", runs)]


ROWS = {"fly": fly_row, "faults": faults_row, "plan": plan_row, "attack": attack_row,
        "swarm": swarm_row}


def write_tables(kind, rows, stem):
    columns = {"faults": FAULT_COLUMNS, "fly": FLY_COLUMNS, "swarm": SWARM_COLUMNS}.get(kind, COLUMNS)
    with open(f"{stem}-table.csv", "w", newline="") as file:
        csv.writer(file).writerows([columns, *rows])
    lines = [columns, ["---"] * len(columns), *rows]
    text = "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)
    pathlib.Path(f"{stem}-table.md").write_text(text)
    print(text, end="", flush=True)
