# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random scenarios in families, as text: scenario `seed` of a family is the same in every run and on every machine."""
import math
import random

# What the paper's six maps say, for starts and goals elsewhere in them.
MAPS = [f"map{number}" for number in range(1, 7)]


def line(key, *numbers):
    return " ".join([key, *(repr(round(float(number), 6)) for number in numbers)])


def point_in(rng, lower, upper, off):
    return [rng.uniform(a + off, b - off) for a, b in zip(lower, upper)]


def box_around(rng, middle, least, most, lower, upper):
    half = [rng.uniform(least, most) / 2 for _ in range(3)]
    corners = [max(a, m - h) for a, m, h in zip(lower, middle, half)] + \
              [min(b, m + h) for b, m, h in zip(upper, middle, half)]
    return line("block", *corners)


def query(rng, lower, upper, off):
    """A start and a goal at opposite ends along x."""
    start, goal = point_in(rng, lower, upper, off), point_in(rng, lower, upper, off)
    reach = 0.15 * (upper[0] - lower[0])
    start[0] = rng.uniform(lower[0] + off, lower[0] + off + reach)
    goal[0] = rng.uniform(upper[0] - off - reach, upper[0] - off)
    return start, goal


def basic(rng, lower, upper, off):
    start, goal = query(rng, lower, upper, off)
    return [line("boundary", *lower, *upper), line("start", *start), line("goal", *goal)]


def forest(rng):
    """Trunks as high as the map, with a limit on the horizontal speed."""
    lower, upper, radius = [0, 0, 0], [rng.uniform(20, 44), 14, 3], rng.choice([0.2, 0.25, 0.3])
    lines = basic(rng, lower, upper, 0.5)
    for _ in range(rng.randint(20, 110)):
        x, y, half = rng.uniform(2.5, upper[0] - 2.5), rng.uniform(0, 14), rng.uniform(0.2, 0.4)
        lines.append(line("block", x - half, max(0, y - half), 0, x + half, min(14, y + half), 3))
    speed = rng.uniform(1.5, 6)
    return lines + [line("radius", radius), line("v_max", speed), line("a_max", rng.uniform(2, 8)),
                    line("v_horizontal", speed)]


def boxes(rng):
    """Boxes of all sizes anywhere."""
    lower, upper = [0, 0, 0], [rng.uniform(6, 14), rng.uniform(5, 10), rng.uniform(3, 5)]
    lines = basic(rng, lower, upper, 0.4)
    for _ in range(rng.randint(5, 40)):
        lines.append(box_around(rng, point_in(rng, [1.5, 0, 0], [upper[0] - 1.5, *upper[1:]], 0), 0.1, 2.0, lower, upper))
    return lines + [line("radius", rng.uniform(0.05, 0.3)), line("resolution", rng.choice([0.1, 0.15, 0.2]))]


def walls(rng):
    """Walls across the way, each with one opening."""
    count, radius = rng.randint(2, 5), rng.uniform(0.1, 0.25)
    lower, upper = [0, 0, 0], [3.0 * count + 3.0, 6, 4]
    lines = basic(rng, lower, upper, 0.5)
    for k in range(count):
        x, y, z = 3.0 * (k + 1), rng.uniform(0.2, 4.5), rng.uniform(0.2, 2.6)
        wide, high, thick = rng.uniform(1.0, 1.4), rng.uniform(1.0, 1.2), rng.uniform(0.1, 0.8)
        for part in ([0, 0, y, 4], [y + wide, 0, 6, 4], [y, 0, y + wide, z], [y, z + high, y + wide, 4]):
            lines.append(line("block", x, part[0], part[1], x + thick, part[2], part[3]))
    return lines + [line("radius", radius), line("time_weight", rng.choice([10, 40, 200, 1000]))]


def limits(rng):
    """Limits that differ from axis to axis and up and down, and limits on the jerk."""
    lines = boxes(rng)
    lines += [line("v_max", *(rng.uniform(0.8, 3) for _ in range(3))), line("a_max", *(rng.uniform(1, 5) for _ in range(3))),
              line("v_min", *(-rng.uniform(0.8, 3) for _ in range(3))), line("a_min", *(-rng.uniform(1, 5) for _ in range(3))),
              line("v_horizontal", rng.uniform(0.9, 3)), line("a_horizontal", rng.uniform(1.2, 5))]
    lines.append(line("j_max", *(rng.choice([0, rng.uniform(8, 40)]) for _ in range(3))))
    return lines + [line("j_horizontal", rng.uniform(8, 40))]


def fences(rng):
    """Keep-ins and keep-outs: prisms, pyramids and skewed boxes."""
    lower, upper = [0, 0, 0], [12, 8, 4]
    lines = basic(rng, lower, upper, 0.7)
    for _ in range(rng.randint(1, 8)):
        lines.append(box_around(rng, point_in(rng, [2, 0, 0], [10, 8, 4], 0), 0.2, 1.5, lower, upper))
    lines.append(line("keepin", 0.1, 0.1, 0.1, 11.9, 7.9, 3.9))
    for _ in range(rng.randint(1, 4)):
        middle, planes = point_in(rng, [3, 1, 0.5], [9, 7, 3.5], 0), []
        for _ in range(rng.randint(4, 8)):
            normal = [rng.gauss(0, 1) for _ in range(3)]
            size = sum(n * n for n in normal) ** 0.5
            planes += [*normal, sum(n * m for n, m in zip(normal, middle)) + size * rng.uniform(0.2, 0.9)]
        lines.append(line("keepout_halfspaces", *planes))
    return lines + [line("radius", rng.uniform(0.1, 0.3))]


def zones(rng):
    """Zones of a city: more upright prisms than a request takes fences, with bottoms and tops, a quarter for a while."""
    lower, upper, radius = [0, 0, 0], [120, 80, 20], rng.uniform(0.3, 0.8)
    lines = basic(rng, lower, upper, 3.0)
    ends = [[float(word) for word in text.split()[1:3]] for text in lines[1:]]
    for _ in range(rng.randint(20, 60)):
        middle, reach = [rng.uniform(0, 120), rng.uniform(0, 80)], rng.uniform(1, 6)
        if any(math.dist(middle, end) < 3 * reach + 1 for end in ends):
            continue
        corners, turned, planes = rng.randint(3, 6), rng.uniform(0, 2 * math.pi), []
        for k in range(corners):
            angle = turned + 2 * math.pi * (k + rng.uniform(-0.2, 0.2)) / corners
            normal = [math.cos(angle), math.sin(angle), 0]
            planes += [*normal, sum(n * m for n, m in zip(normal, middle)) + reach * rng.uniform(0.5, 1)]
        if rng.random() < 0.5:
            bottom = rng.uniform(0, 12)
            planes += [0, 0, -1, -bottom, 0, 0, 1, bottom + rng.uniform(2, 10)]
        begin = rng.uniform(-10, 30)
        during = f" during {begin:.3f} {begin + rng.uniform(1, 40):.3f} {rng.choice([0, 0.5])}"
        lines.append(line("keepout_halfspaces", *planes) + (during if rng.random() < 0.25 else ""))
    return lines + [line("radius", radius), line("resolution", 1), line("v_max", rng.uniform(3, 12)),
                    line("a_max", rng.uniform(2, 6)), line("rest_clear", rng.choice([0, 5]))]


def motion(rng):
    """Starts and goals that move."""
    lines = boxes(rng)
    for end in ("start", "goal"):
        lines.append(line(f"{end}_velocity", *(rng.uniform(-0.8, 0.8) for _ in range(3))))
        lines.append(line(f"{end}_acceleration", *(rng.uniform(-0.5, 0.5) for _ in range(3))))
        if rng.random() < 0.5:
            lines.append(line(f"{end}_jerk", *(rng.uniform(-1, 1) for _ in range(3))))
    return lines


def vehicles(rng):
    """Thrust, tilt and body rates of vehicles from a racer to a loaded carrier, half of them in motion."""
    motion_of = motion if rng.random() < 0.5 else boxes
    lines = motion_of(rng) + [line("v_max", rng.uniform(2, 10)), line("a_max", rng.uniform(4, 40))]
    lines += [line("thrust_max", rng.uniform(13, 49)), line("thrust_min", rng.uniform(1, 4))]
    return lines + [line("tilt_tangent", rng.uniform(0.5, 3.7)), line("rate_max", rng.uniform(2, 12))]


def vias(rng):
    """Points on the way, some of them stops, some with a velocity."""
    lines = boxes(rng)
    upper = [float(word) for word in lines[0].split()[4:]]
    for _ in range(rng.randint(1, 4)):
        point = point_in(rng, [1, 0.5, 0.5], [upper[0] - 1, upper[1] - 0.5, upper[2] - 0.5], 0)
        via = line("via", *point, rng.choice([0, 0.2, 0.5]))
        kind = rng.random()
        lines.append(via + (" stop" if kind < 0.2 else
                            " velocity 0.5 0.1 0" if kind < 0.3 else ""))
    return lines


def beyond(rng):
    """Blocks that stick out of the boundary, a tracking margin, and voxels that do not divide it."""
    lower, upper = [-0.37, 0.11, 0.05], [rng.uniform(7, 11), rng.uniform(5, 8), rng.uniform(2.5, 4)]
    lines = basic(rng, lower, upper, 0.6)
    for _ in range(rng.randint(4, 25)):
        middle = point_in(rng, [1.5, -1, -1], [upper[0] - 1.5, upper[1] + 1, upper[2] + 1], 0)
        lines.append(box_around(rng, middle, 0.1, 2.5, [-9, -9, -9], [99, 99, 99]))
    return lines + [line("radius", rng.uniform(0, 0.2)), line("tracking_margin", rng.uniform(0, 0.15)),
                    line("resolution", rng.uniform(0.07, 0.23))]


def far(rng):
    """As `boxes`, 1 km to 1000 km from the world's origin."""
    away = [10 ** rng.uniform(3, 6) * rng.choice([-1, 1]) for _ in range(3)]
    moved = []
    for text in boxes(rng):
        key, *numbers = text.split()
        if key in ("boundary", "block", "start", "goal"):
            numbers = [float(number) + away[i % 3] for i, number in enumerate(numbers)]
        moved.append(line(key, *numbers))
    return moved


def maps(rng, folder):
    """One of the paper's maps from anywhere to anywhere."""
    kept = [text for text in (folder / f"{rng.choice(MAPS)}.txt").read_text().splitlines()
            if text.split("#")[0].split() and text.split()[0] not in ("start", "goal")]
    boundary = next([float(word) for word in text.split()[1:]] for text in kept if text.startswith("boundary"))
    for end in ("start", "goal"):
        kept.append(line(end, *point_in(rng, boundary[:3], boundary[3:], 0.15)))
    return kept


FAMILIES = {"forest": forest, "boxes": boxes, "walls": walls, "limits": limits, "fences": fences, "zones": zones, "motion": motion,
            "vehicles": vehicles, "vias": vias, "beyond": beyond, "far": far, "maps": maps}


ROOM = 0.45  # metres around starts, goals and vias that random blocks leave


def covers(block, points):
    corners = [float(word) for word in block.split()[1:7]]
    return any(all(corners[a] - ROOM < point[a] < corners[a + 3] + ROOM for a in range(3)) for point in points)


def scenario(family, seed, maps_folder):
    rng = random.Random(f"{family}:{seed}")
    lines = maps(rng, maps_folder) if family == "maps" else FAMILIES[family](rng)
    points = [[float(word) for word in text.split()[1:4]] for text in lines if text.split()[0] in ("start", "goal", "via")]
    if family != "maps":
        lines = [text for text in lines if not (text.startswith("block") and covers(text, points))]
    return "\n".join([f"# {family}:{seed}", *lines]) + "\n"
