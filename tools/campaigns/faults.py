# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flights with faults as a kind of campaign: what goes wrong, and the settings that make it (docs/formats.md)."""
from kinds import Fly, settings_words

FAULTS = {
    "none": [],
    **{f"dropped-{part}": [f"dropout={part / 100:g}"] for part in (10, 30, 50, 70, 90)},
    **{f"late-{late}": [f"sensor_latency={late / 1000:g}"] for late in (0, 100, 200, 300)},
    **{f"frames-until-{t}": [f"frames_until={t}"] for t in (0, 1, 3)},
    "jumps-within": ["pose_jump=0.2,1", "pose_margin=0.2"],
    "jumps-beyond": ["pose_jump=0.2,1"],
    "skipped-1": ["tick_skip=0.4,1"],
    **{f"skipped-{longest}": [f"tick_skip=0.5,{longest}"] for longest in (5, 20, 50)},
    "skipped-most": ["tick_skip=0.9,50"],
    "goal-moves": ["goal_jitter=5,10"],
    "goal-occupied": ["goal_place=occupied"],
    "goal-outside": ["goal_place=outside"],
    **{f"appears-{ahead:g}": [f"appear_ahead=3,{ahead:g}"] for ahead in (0.5, 1, 1.5, 2, 3, 4, 6)},
}
# Flights that have no goal to reach end then.
SETTINGS = ["time_limit=60"]


def rows_of(row):
    """A family with every fault, or with the one that is named: P25@5, P25@5/dropped-50."""
    family, _, fault = row.partition("/")
    return [row] if fault else [f"{family}/{name}" for name in FAULTS]


def split(row):
    """The family, and the settings of the fault; None where there is no such fault."""
    family, _, fault = row.partition("/")
    return family, FAULTS.get(fault)


class Faults(Fly):
    """Flight k of a row FAMILY/FAULT is the world FAMILY:k with the settings of the fault."""
    name = "faults"

    def rows(self, given):
        return [row for one in given for row in rows_of(one)]

    def settings_of(self, row):
        chosen = dict(text.split("=", 1) for text in [*SETTINGS, *self.settings, *(split(row)[1] or [])])
        return [f"{key}={value}" for key, value in chosen.items()]

    def command(self, row, seed):
        return [self.program, "fly", f"{split(row)[0]}:{seed}", *settings_words(self.settings_of(row))]

    def probe(self, row, folder):
        return [*self.command(row, self.seed)[1:], "--set", "time_limit=0.1"]

    def refusal(self, row):
        if split(row)[1] is None:
            return f"there is no such fault; these are {', '.join(FAULTS)}"
        return super().refusal(row)

    def failed(self, entry):
        """Flights that are stopped by what went wrong did what they could."""
        return self.is_defect(entry)

    def world_file(self, entry):
        return super().world_file({**entry, "row": split(entry["row"])[0]})
