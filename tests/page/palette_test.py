#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""palette_test.py PALETTE.JS [--table]: the colours of the page. Lines have a contrast of 3:1 to what they are drawn on (WCAG
2.1, 1.4.11); and colours with different meanings stay apart for readers without red, green or blue cones. --table prints
the nearest pairs."""
import itertools
import re
import sys

CONTRAST = 3.0
DISTANCE = 12.0  # in CIELAB; 2.3 is just noticeable side by side
LINES = ("ink", "known", "commit", "brake", "dropped", "corridor", "sensor", "fence", "thing")
FLOORS = ("paper", "ground")
# Machado, Oliveira and Fernandes (2009), severity 1: what remains of linear RGB.
EYES = {
    "all cones": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "no red": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    "no green": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
    "no blue": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
}


def linear(colour):
    parts = [(colour >> shift & 255) / 255 for shift in (16, 8, 0)]
    return [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]


def seen(colour, eye):
    rgb = linear(colour)
    return [min(max(sum(m * c for m, c in zip(row, rgb)), 0.0), 1.0) for row in EYES[eye]]


def luminance(rgb):
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]


def contrast(a, b):
    high, low = sorted((luminance(linear(a)), luminance(linear(b))), reverse=True)
    return (high + 0.05) / (low + 0.05)


def lab(rgb):
    r, g, b = rgb
    xyz = (0.4124 * r + 0.3576 * g + 0.1805 * b, luminance(rgb), 0.0193 * r + 0.1192 * g + 0.9505 * b)
    x, y, z = (t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116 for t in (v / w for v, w in zip(xyz, (0.9505, 1, 1.089))))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def distance(a, b, eye):
    return sum((p - q) ** 2 for p, q in zip(lab(seen(a, eye)), lab(seen(b, eye)))) ** 0.5


def palettes(text):
    for theme in ("light", "dark"):
        body = re.search(rf"{theme}: {{(.*?)\n  }},", text, re.S)[1]
        colours = {name: int(value, 16) for name, value in re.findall(r"(\w+): 0x([0-9a-f]{6})", body)}
        speeds = [int(value, 16) for value in re.findall(r"0x([0-9a-f]{6})", re.search(r"speeds: \[(.*?)\]", body)[1])]
        yield theme, {**colours, **{f"speed {i}": speed for i, speed in enumerate(speeds)}}


def main():
    failures = 0
    for theme, colours in palettes(open(sys.argv[1]).read()):
        lines = [*LINES, *(name for name in colours if name.startswith("speed"))]
        pairs = [(contrast(colours[line], colours[floor]), line, floor) for line in lines for floor in FLOORS]
        near = [(distance(colours[a], colours[b], eye), a, b, eye)
                for a, b in itertools.combinations(lines, 2) for eye in EYES if (a[:5], b[:5]) != ("speed", "speed")]
        if "--table" in sys.argv:
            print(theme, *sorted(pairs)[:6], *sorted(near)[:14], sep="\n  ")
        for value, line, floor in pairs:
            if value < CONTRAST:
                failures += 1
                print(f"FAILED: {theme}: {line} on {floor} has a contrast of {value:.2f}")
        for value, a, b, eye in near:
            if value < DISTANCE:
                failures += 1
                print(f"FAILED: {theme}: {a} and {b} are {value:.1f} apart with {eye}")
    sys.exit(1 if failures else 0)


main()
