#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""flight_report.py LOG [--map MAP]: what a log of PX4 (ULog) or ArduPilot (DataFlash) says of a flight in offboard or
guided mode: how far the vehicle was from the plan, and from the blocks of the map (a scenario). If the mode was entered
several times, the last time counts."""
import argparse
import bisect
import math
import sys

from flight_log import LogError, read_log

OFFBOARD, GUIDED = 14, 4
SWITCH = 0.1  # s after the switch, in which setpoints may still be PX4's own
GAP = 1.0  # s between samples of the plan beyond which nothing is interpolated


class Curve:
    """Positions over time, east, north, up. With velocities, cubics lead from one to the next; otherwise lines."""

    def __init__(self, samples):
        self.samples = sorted(samples)
        self.times = [sample[0] for sample in self.samples]

    def at(self, t):
        """The position at time t; None before the first sample, after the last, and in gaps."""
        k = bisect.bisect_right(self.times, t)
        if k == len(self.times) and k > 0 and t == self.times[-1]:
            return self.samples[-1][1]
        if k == 0 or k == len(self.times):
            return None
        (t0, p0, v0), (t1, p1, v1) = self.samples[k - 1], self.samples[k]
        h = t1 - t0
        if h > GAP:
            return None
        s = (t - t0) / h
        if v0 is None:
            return [a + s * (b - a) for a, b in zip(p0, p1)]
        a, b, c, d = (1 + 2 * s) * (1 - s) ** 2, s * (1 - s) ** 2 * h, s * s * (3 - 2 * s), s * s * (s - 1) * h
        return [a * x0 + b * u0 + c * x1 + d * u1 for x0, u0, x1, u1 in zip(p0, v0, p1, v1)]


class Flight:
    """Curves of one flight: `plan`, `estimate`, and `truth`, which only simulators log; and from when to when."""

    def __init__(self, mode, span, plan, estimate, truth):
        self.mode, (self.begin, self.end) = mode, span
        self.plan, self.estimate, self.truth = Curve(plan), Curve(estimate), Curve(truth)


def last_span(modes, wanted, end):
    """When the mode was entered for the last time, and left; `modes`: (time, mode)."""
    span = None
    before = None
    for t, mode in sorted(modes):
        if mode == wanted and before != wanted:
            span = [t, end]
        if mode != wanted and before == wanted:
            span[1] = t
        before = mode
    return span


def flight_of_ulog(path):
    log = read_log(path, ["vehicle_status", "trajectory_setpoint", "vehicle_local_position",
                          "vehicle_local_position_groundtruth"])

    def vector(record, *names):
        north, east, down = (record[name] for name in names)
        return [east, north, -down]

    def positions(name):
        return [(1e-6 * r["timestamp"], vector(r, "x", "y", "z"), vector(r, "vx", "vy", "vz")) for r in log[name]]

    estimate = positions("vehicle_local_position")
    plan = [(1e-6 * r["timestamp"], vector(r, *(f"position[{k}]" for k in range(3))),
             vector(r, *(f"velocity[{k}]" for k in range(3)))) for r in log["trajectory_setpoint"]]
    plan = [sample for sample in plan if all(map(math.isfinite, sample[1] + sample[2]))]
    modes = [(1e-6 * r["timestamp"], r["nav_state"]) for r in log["vehicle_status"]]
    span = last_span(modes, OFFBOARD, estimate[-1][0] if estimate else 0.0)
    if span is None or not plan:
        raise LogError(f"{path}: PX4 was not in offboard, or got no setpoints")
    plan = [sample for sample in plan if span[0] + SWITCH <= sample[0] < span[1]]
    return Flight("offboard", span, plan, estimate, positions("vehicle_local_position_groundtruth"))


def flight_of_dataflash(path):
    log = read_log(path, ["MODE", "PSCN", "PSCE", "PSCD", "SIM2"])
    for name in ("PSCN", "PSCE", "PSCD"):
        if not log[name]:
            raise LogError(f"{path}: no {name} records. Set LOG_BITMASK to its default, and fly again")

    def line(prefix):
        """ArduPilot's desired position (before 4.7, the target) or its estimate, from the records of three axes."""
        axes = []
        for axis, sign in (("E", 1.0), ("N", 1.0), ("D", -1.0)):
            records = log["PSC" + axis]
            field = prefix + "P" + axis if prefix + "P" + axis in records[0] else "T" * len(prefix) + "P" + axis
            axes.append(Curve([(1e-6 * r["TimeUS"], [sign * r[field]], None) for r in records]))
        points = [(t, [axis.at(t) for axis in axes]) for t in axes[0].times]
        return [(t, [p[0] for p in point], None) for t, point in points if None not in point]

    estimate = line("")
    truth = [(1e-6 * r["TimeUS"], [r["PE"], r["PN"], -r["PD"]], None) for r in log["SIM2"] if "PN" in r]
    modes = [(1e-6 * r["TimeUS"], r.get("ModeNum", r.get("Mode"))) for r in log["MODE"]]
    span = last_span(modes, GUIDED, estimate[-1][0] if estimate else 0.0)
    if span is None:
        raise LogError(f"{path}: ArduPilot was not in guided mode")
    return Flight("guided", span, line("D"), estimate, truth)


def read_map(path):
    """Blocks of a scenario as (lower, upper), and its radius or 0."""
    blocks, radius = [], 0.0
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            words = line.split("#")[0].split()
            try:
                if words and words[0] in ("block", "keepout"):
                    corners = [float(word) for word in words[1:7]]
                    blocks.append((corners[:3], corners[3:6] if len(corners) == 6 else corners[9]))
                if words and words[0] == "radius":
                    radius = float(words[1])
            except (ValueError, IndexError):
                raise LogError(f"{path}:{number}: '{words[0]}' lacks numbers") from None
    return blocks, radius


def distance_to(block, point):
    """From a point to a block; 0 inside."""
    lower, upper = block
    return math.hypot(*(max(a - p, p - b, 0.0) for a, p, b in zip(lower, point, upper)))


def errors(flight):
    """How far the estimate was from the plan, m, at each of its samples in the flight."""
    found = []
    for t, position, _ in flight.estimate.samples:
        wanted = flight.plan.at(t) if flight.begin <= t <= flight.end else None
        if wanted is not None:
            found.append(math.dist(position, wanted))
    return found


def drifts(flight):
    """How far the estimate was from the truth."""
    return [math.dist(position, flight.truth.at(t)) for t, position, _ in flight.estimate.samples
            if flight.begin <= t <= flight.end and flight.truth.at(t) is not None]


def clearance(flight, blocks):
    """The least distance of the vehicle's centre from a block: of the truth, or of the estimate without one."""
    curve = flight.truth if flight.truth.samples else flight.estimate
    points = [position for t, position, _ in curve.samples if flight.begin <= t <= flight.end]
    return min((distance_to(block, point) for block in blocks for point in points), default=math.inf)


def report(path, map_path):
    """The lines that are printed."""
    with open(path, "rb") as file:
        flight = (flight_of_ulog if file.read(4) == b"ULog" else flight_of_dataflash)(path)
    found = errors(flight)
    if not found:
        raise LogError(f"{path}: no sample of the plan and the estimate at the same time")
    lines = [f"flight     {flight.end - flight.begin:.1f} s in {flight.mode}",
             f"error      largest {max(found):.2f} m, mean {sum(found) / len(found):.2f} m, estimate against plan "
             f"({len(found)} samples)"]
    off = drifts(flight)
    if off:
        lines.append(f"estimate   largest {max(off):.2f} m off the simulator's truth")
    if map_path is not None:
        blocks, radius = read_map(map_path)
        least = clearance(flight, blocks)
        lines.append(f"clearance  {least:.2f} m from the blocks to the vehicle's centre, {least - radius:.2f} m to its "
                     f"body, by the {'truth' if off else 'estimate'}")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("log", metavar="LOG")
    parser.add_argument("--map", metavar="MAP", help="a scenario: its blocks, and its radius")
    arguments = parser.parse_args()
    try:
        print("\n".join(report(arguments.log, arguments.map)))
    except (LogError, OSError) as error:
        sys.exit(f"flight_report: {error}")


if __name__ == "__main__":
    main()
