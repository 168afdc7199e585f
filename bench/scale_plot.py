#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""scale_plot.py SCALE.csv OUT.svg: the work of each stage over what grows, both logarithmic, one panel for each part of
the table of tools/bench scale."""
import csv
import math
import sys

STAGES = {"search": "#0b6e99", "shortcut": "#c4501b", "corridor": "#3a7d34", "trajectory": "#7b4fa3", "tracks": "#8a6d00",
          "check": "#a3323a", "far": "#0b6e99", "flight": "#c4501b", "fleet": "#3a7d34"}
PANEL, HEIGHT, LEFT, TOP, BOTTOM = 340, 380, 75, 40, 50
ACROSS = 4  # panels
UNITS = (1.0, 1e6)


def share(value, low, high):
    return (math.log10(value) - math.log10(low)) / (math.log10(high) - math.log10(low))


def text(x, y, words, anchor="middle", colour="#333"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}">{words}</text>'


def line(points, colour, width):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}"/>'


def panel(what, rows, left, top):
    right, low = left + PANEL - LEFT - 20, top + HEIGHT - BOTTOM
    high = top + TOP
    rows = sorted(rows, key=lambda row: float(row["size"]))
    sizes = [float(row["size"]) for row in rows]

    def x(size):
        return left + (right - left) * share(size, sizes[0], sizes[-1])

    def y(units):
        return low - (low - high) * share(max(units, UNITS[0]), *UNITS)

    out = [text((left + right) / 2, low + BOTTOM - 10, what)]
    for power in range(7):
        out.append(line([(left, y(10**power)), (right, y(10**power))], "#ddd", 1))
        out.append(text(left - 6, y(10**power) + 4, f"{10**power:,}", "end"))
    for size in sizes:
        label = f"{size:g}" if size < 1e4 else f"{size:.0e}".replace("e+0", "e")
        out.append(text(x(size), low + 18, label))
    for stage, colour in STAGES.items():
        if not any(float(row[stage]) > 0 for row in rows):
            continue
        points = [(x(float(row["size"])), y(float(row[stage]))) for row in rows]
        out.append(line(points, colour, 2))
    return out


def main():
    table, out = sys.argv[1:]
    rows = [row for row in csv.DictReader(open(table)) if int(row["planned"]) > 0]
    kinds = list(dict.fromkeys(row["what"] for row in rows))
    parts = []
    for k, what in enumerate(kinds):
        down, across = divmod(k, ACROSS)
        parts += panel(what, [row for row in rows if row["what"] == what], LEFT + across * PANEL, down * HEIGHT)
    width, height = PANEL * min(ACROSS, len(kinds)), HEIGHT * -(-len(kinds) // ACROSS)
    for k, (stage, colour) in enumerate(STAGES.items()):
        parts.append(text(LEFT + 90 * k, 20, stage, "start", colour))
    parts.append(text(width - 20, 20, "units; flight and fleet: of a tick", "end"))
    with open(out, "w") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
                   'font-family="sans-serif" font-size="12">\n<rect width="100%" height="100%" fill="#fff"/>\n')
        file.write("\n".join(parts) + "\n</svg>\n")


if __name__ == "__main__":
    main()
