# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a campaign of proofs proves: plans of random scenarios, or flights through random worlds."""
import json
import subprocess

from scenarios import FAMILIES, scenario

FLOWN = "P49 P36 P25 P12 S05 S10 S20 C B O M L G I D".split()
# As in campaigns of flights: errors of the sensor, besides the vehicle's.
SETTINGS = ["depth_noise=0.01", "outliers=0.01"]

# Claims that plans and flights have where the vehicle has such limits. That of thrust is one on acceleration.
VEHICLE = {"tilt": "tilt", "body": "body rate"}


class Plans:
    """Planned with `tern plan`. Of a scenario without a plan, the planner's status is kept."""
    name, families = "plans", list(FAMILIES)
    # Claims of one kind share a column.
    groups = {"joint": "joints", "start": "ends", "goal": "ends", "reachable": "ends", "via": "vias",
              "boundary": "boundary", "curve": "curve", "fence": "fences",
              "velocity": "velocity", "acceleration": "acceleration", "jerk": "jerk", **VEHICLE}

    def __init__(self, tern, maps, settings):
        self.tern, self.maps, self.settings = tern, maps, settings
        if settings:
            raise SystemExit("tools/prove: --set is for --flights")

    def make(self, family, seed, folder, row):
        """What `tern verify` is to prove, or nothing. Puts what else is to be known into the row."""
        world, plan = folder / "scenario.txt", folder / "plan.json"
        world.write_text(scenario(family, seed, self.maps))
        done = subprocess.run([self.tern, "plan", world, "--json", plan], capture_output=True, text=True)
        if done.returncode == 3:
            row["status"] = json.loads(plan.read_text())["status"]
            return None
        return [plan, world]

    @staticmethod
    def counts(rows):
        return {"scenarios": len(rows), "plans": sum(bool(row.get("claims")) for row in rows)}


class Flights:
    """Flown with `tern fly`, and held against the worlds that `tern world` writes."""
    name, families = "flights", FLOWN
    groups = {"joint": "joints", "rest": "rest", "takeover": "takeovers", "goal": "goal", "curve": "curve",
              "velocity": "velocity", "acceleration": "acceleration", "jerk": "jerk", **VEHICLE,
              "flown: commands": "commands", "flown: tracking": "tracking", "flown: body": "body"}

    def __init__(self, tern, maps, settings):
        self.tern, self.settings = tern, SETTINGS + settings

    def make(self, family, seed, folder, row):
        log, world = folder / "flight.json", f"{family}:{seed}"
        chosen = [word for setting in self.settings for word in ("--set", setting)]
        subprocess.run([self.tern, "fly", world, *chosen, "--json", log, "--commits"], capture_output=True, text=True)
        if log.exists():
            flight = json.loads(log.read_text())
            row["flight"], row["commits"] = flight["status"], flight["plans"]["committed"]
        return [log, world, *chosen]

    @staticmethod
    def counts(rows):
        commits = [int(row["commits"]) for row in rows if row.get("commits")]
        return {"flights": len(rows), "reached": sum(row.get("flight") == "reached" for row in rows),
                "commits": sum(commits)}


class Pairs:
    """Random plans beside random tracks, a thousand a run: the core's proofs of them against exact numbers. `tern` is
    the program tern_track_pairs, which proves them at once."""
    name, families, groups, settings = "thousands of pairs", ["pairs"], {}, []

    def __init__(self, tern, maps, settings):
        self.tern = tern
        if settings:
            raise SystemExit("tools/prove: --set is for --flights")

    def make(self, family, seed, folder, row):
        done = subprocess.run([self.tern, str(seed), "1000"], capture_output=True, text=True)
        *cases, last = done.stdout.splitlines() or [""]
        row["status"] = {0: "proven", 1: "REFUTED"}.get(done.returncode, "FAILED")
        if row["status"] != "FAILED":
            row["claims"], row["refused"], _ = last.split()
        if row["status"] != "proven":
            print("\n".join(cases + [f"not proven: seed {seed}"]), flush=True)

    @staticmethod
    def counts(rows):
        def total(column):
            return sum(int(row[column]) for row in rows if row.get(column))
        return {"thousands of pairs": len(rows), "claims": total("claims"), "refused": total("refused")}


def columns_of(kind):
    return list(dict.fromkeys(kind.groups.values()))


def summary_of(kind, claims):
    """Of each kind of claim: the least margin, and the largest part of a tolerance that is used."""
    row = {"claims": len(claims)}
    for claim in claims:
        words = claim["claim"].split()
        group = kind.groups[" ".join(words[:2]) if words[0] == "flown:" else words[0]]
        margin, tolerance = float(claim["margin_at_least"]), float(claim["tolerance"])
        used = max(0.0, -margin / tolerance) if tolerance > 0.0 else float(margin < 0.0)
        row[group] = min(margin, row.get(group, margin))
        row[f"{group} used"] = max(used, row.get(f"{group} used", 0.0))
    return row


def least(rows, column):
    """The least margin of all rows; None where no row has one."""
    return min((float(row[column]) for row in rows if row.get(column)), default=None)
