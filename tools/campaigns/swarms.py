# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Swarms as a kind of campaign. Run k of a row FAMILY-N/SETTING,... is the swarm FAMILY-N:k with links of seed k and
these settings, each an option of `tern swarm`: swap-16/loss=0.3,delay=0.1."""
import json
import pathlib
import tempfile
import time

from kinds import Kind, ended

LONGEST = 3600  # s of a process


def options(settings):
    """Settings KEY=VALUE as options of the program; a switch has no value."""
    words = []
    for text in settings:
        key, _, value = text.partition("=")
        words += [f"--{key}", *value.split(":")] if value else [f"--{key}"]
    return words


class Swarm(Kind):
    name, good, verb = "swarm", "arrived", "swarms"
    keeps = False  # a world is its name
    broken = {"collision", "disagreed", "crash", "too_long"}
    fields = ["row", "seed", "status", "reason", "vehicles", "arrived", "travel_s", "last_s", "contacts", "least_gap",
              "least_clearance", "unasked", "packets", "lost", "bytes", "fleet_units", "untold", "disagreed", "time_s",
              "hash", "seconds"]

    def jobs(self, row, first, count):
        return [(row, seed, 1) for seed in range(first, first + count)]

    def settings_of(self, row):
        chosen = dict(text.partition("=")[::2] for text in [*self.settings, *row.partition("/")[2].split(",")] if text)
        return [f"{key}={value}" if value else key for key, value in chosen.items()]

    def command(self, row, seed):
        return [self.program, *self.words(row, seed, self.settings_of(row))]

    @staticmethod
    def words(row, seed, settings):
        return ["swarm", f"{row.partition('/')[0]}:{seed}", "--seed", str(seed), *options(settings)]

    def probe(self, row, folder):
        settings = [text for text in self.settings_of(row) if not text.startswith("time-limit=")]
        return self.words(row, self.seed, [*settings, "time-limit=0.02"])

    def refusal(self, row):
        """What the program says where it knows no such swarm or option. The probe is too short to arrive, so status 3
        is no refusal."""
        done = self.call(self.probe(row, None), 300)
        return done.stderr.strip() if done is not None and done.returncode not in (0, 3) else None

    def run(self, job):
        row, seed, _ = job
        began = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder, "swarm.json")
            done = self.call([*self.command(row, seed)[1:], "--json", str(log)], LONGEST)
            if done is None:
                entry = {"status": "too_long", "reason": f"the process was ended after {LONGEST} s"}
            elif done.returncode in (0, 3):
                entry = self.read_log(json.loads(log.read_text()))
            else:
                entry = {"status": "crash", "reason": ended(done)}
        return [{"row": row, "seed": seed, **entry, "seconds": round(time.monotonic() - began, 2)}]

    @staticmethod
    def read_log(log):
        states = [member["state"] for member in log["members"] if "state" in member]
        status = "arrived" if not states else "resting"
        if log["disagreed"]:
            status = "disagreed"
        if log["contacts"]:
            status = "collision"
        return {"status": status, "reason": states[0] if states else "", "vehicles": log["vehicles"],
                "arrived": log["arrived"], "travel_s": log["mean_travel"], "last_s": log["last_arrival"],
                "contacts": len(log["contacts"]), "least_gap": log["least_distance"] - 2.0 * log["body_radius"],
                "least_clearance": log["least_clearance"],
                "unasked": sum(member["unasked"] for member in log["members"]), "packets": log["packets"],
                "lost": log["lost"], "bytes": log["bytes"], "fleet_units": log["fleet_units"],
                "untold": log["untold"], "disagreed": log["disagreed"], "time_s": log["time"],
                "hash": log["hash"]}
