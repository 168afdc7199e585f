#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""plot.py DURATIONS.csv OUT.svg: the duration of each map's plans over their snap, one line a map, each time weight
marked. The table is that of tools/bench durations on bench/maps, its first ladder."""
import csv
import math
import pathlib
import sys

WIDTH, HEIGHT = 720, 560
LEFT, RIGHT, TOP, BOTTOM = 60, 40, 30, 50
COLOURS = ["#0b6e99", "#c4501b", "#3a7d34", "#7b4fa3", "#a3323a", "#5b5b5b"]


def plans_of(path):
    """{map: [(weight, snap, seconds)]} of the first ladder of weights, at the scenarios' own limits."""
    maps = {}
    for row in csv.DictReader(open(path)):
        name, weight = pathlib.Path(row["case"]).stem, float(row["time_weight"])
        plans = maps.setdefault(name, [])
        if any(known == weight for known, _, _ in plans):
            continue
        plans.append((weight, float(row["snap"]), float(row["duration_s"])))
    return {name: sorted(plans) for name, plans in sorted(maps.items())}


def ticks(lowest, highest):
    powers = range(math.floor(math.log10(lowest)), math.ceil(math.log10(highest)) + 1)
    return [10.0**k for k in powers]


class Page:
    def __init__(self, maps):
        points = [plan for plans in maps.values() for plan in plans]
        self.snaps = ticks(min(p[1] for p in points), max(p[1] for p in points))
        self.longest = 5 * math.ceil(max(p[2] for p in points) / 5)
        self.lines = []

    def x(self, snap):
        low, high = math.log10(self.snaps[0]), math.log10(self.snaps[-1])
        return LEFT + (WIDTH - LEFT - RIGHT) * (math.log10(snap) - low) / (high - low)

    def y(self, seconds):
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * seconds / self.longest

    def text(self, x, y, words, anchor="middle", colour="#333"):
        self.lines.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}">{words}</text>')

    def line(self, x0, y0, x1, y1):
        self.lines.append(f'<line x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1:.1f}" y2="{y1:.1f}" stroke="#ddd"/>')

    def axes(self):
        for snap in self.snaps:
            self.line(self.x(snap), TOP, self.x(snap), HEIGHT - BOTTOM)
            self.text(self.x(snap), HEIGHT - BOTTOM + 18, f"{snap:g}")
        for seconds in range(0, self.longest + 1, 5):
            self.line(LEFT, self.y(seconds), WIDTH - RIGHT, self.y(seconds))
            self.text(LEFT - 8, self.y(seconds) + 4, str(seconds), "end")
        self.text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 10, "integral of squared snap, m²/s⁷")
        self.text(LEFT - 8, TOP - 12, "seconds", "end")

    def draw(self, name, plans, colour):
        path = " ".join(f"{self.x(snap):.1f},{self.y(seconds):.1f}" for _, snap, seconds in plans)
        self.lines.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
        for weight, snap, seconds in plans:
            radius = 4.5 if weight == 40 else 3
            title = f"{name}, weight {weight:g}: {seconds:.2f} s"
            self.lines.append(f'<circle cx="{self.x(snap):.1f}" cy="{self.y(seconds):.1f}" r="{radius}" '
                              f'fill="{colour}"><title>{title}</title></circle>')
        _, snap, seconds = plans[0]
        self.text(self.x(snap) - 8, self.y(seconds) + 4, name, "end", colour)

    def mark_weights(self, plans):
        for weight, snap, seconds in plans:
            if weight in (10, 40, 200):
                self.text(self.x(snap), self.y(seconds) - 9, f"{weight:g}")
            elif weight == 1000:
                self.text(self.x(snap) + 8, self.y(seconds) + 4, f"{weight:g}", "start")

    def write(self, path):
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" '
                f'font-size="12">\n<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>\n')
        with open(path, "w") as out:
            out.write(head + "\n".join(self.lines) + "\n</svg>\n")


def main():
    maps = plans_of(sys.argv[1])
    page = Page(maps)
    page.axes()
    for (name, plans), colour in zip(maps.items(), COLOURS):
        page.draw(name, plans, colour)
    page.mark_weights(max(maps.values(), key=lambda plans: plans[0][2]))
    page.write(sys.argv[2])


main()
