# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flies through pillars that only a depth camera shows, and draws the flight: fly.py [PICTURE]."""
import sys

import numpy as np
import tern

PILLARS = [((4, -1, -1), (5, 1, 4)), ((8, 0, -1), (9, 4, 4)), ((8, -6, -1), (9, -3, 4))]
START, GOAL = (0.0, 0.0, 1.5), (12.0, 1.0, 1.5)
WIDTH, HEIGHT, FOCAL = 80, 60, 45.0  # a camera of 83 by 67 degrees
CAMERA = (FOCAL, FOCAL, (WIDTH - 1) / 2, (HEIGHT - 1) / 2)


def depth_image(position, ahead, right, down):
    """What the camera measures: the nearest pillar along each pixel's ray, or 20 m."""
    v, u = np.mgrid[0:HEIGHT, 0:WIDTH]
    rays = ahead + (u - CAMERA[2])[..., None] / FOCAL * right + (v - CAMERA[3])[..., None] / FOCAL * down
    depth = np.full((HEIGHT, WIDTH), 20.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        for lower, upper in PILLARS:
            a, b = (lower - position) / rays, (upper - position) / rays
            enter, leave = np.minimum(a, b).max(axis=-1), np.maximum(a, b).min(axis=-1)
            depth = np.where((enter <= leave) & (enter > 0), np.minimum(depth, enter), depth)
    return depth


def look(rolling_map, command, now):
    """Takes an image from the commanded position towards the point that the flight wants to see."""
    towards = command.look_at[:2] - command.position[:2]
    c, s = towards / np.linalg.norm(towards) if np.linalg.norm(towards) > 1e-6 else (1.0, 0.0)
    right, down, ahead = np.array([s, -c, 0]), np.array([0, 0, -1]), np.array([c, s, 0])
    image = depth_image(command.position, ahead, right, down)
    w, z = np.cos(np.arctan2(s, c) / 2), np.sin(np.arctan2(s, c) / 2)
    quaternion = [(w + z) / 2, -(w + z) / 2, (w - z) / 2, (z - w) / 2]  # turns the camera's axes into right, down, ahead
    rolling_map.begin_depth(image, CAMERA, command.position, quaternion, now, furthest=30.0)


def fly():
    rolling_map = tern.RollingMap((-6.4, -9.6, -0.6), 0.2, (128, 96, 24), radius=0.35)
    rolling_map.assume_free(START, 1.5)
    flight = tern.Flight(tern.Limits((2, 2, 1), (4, 4, 4)), rolling_map, tern.Planner(), START, t=0)
    flight.set_goal(GOAL)
    now, path = 0, []
    while now < 60_000_000_000:
        command = flight.command(now)
        path.append(command.position)
        if now % 100_000_000 == 0 and not rolling_map.busy:
            look(rolling_map, command, now)
        if flight.tick(now).arrived:
            break
        now += flight.tick_ns
    return np.array(path), now / 1e9


def draw(path, picture):
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(7, 4.5), constrained_layout=True)
    for lower, upper in PILLARS:
        axes.add_patch(pyplot.Rectangle(lower[:2], upper[0] - lower[0], upper[1] - lower[1], color="0.4"))
    axes.plot(path[:, 0], path[:, 1], color="tab:blue")
    axes.plot(*GOAL[:2], "x", color="tab:blue")
    axes.set(xlabel="x, m", ylabel="y, m", aspect="equal", xlim=(-1, 13), ylim=(-5, 5))
    figure.savefig(picture)


if __name__ == "__main__":
    flown, seconds = fly()
    gap = min(np.linalg.norm(np.maximum(np.maximum(lower - flown, flown - upper), 0), axis=1).min()
              for lower, upper in (map(np.array, pillar) for pillar in PILLARS))
    print(f"{seconds:.1f} s, rests at {flown[-1].round(2)}, nearest pillar {gap:.2f} m from the centre")
    if len(sys.argv) > 1:
        draw(flown, sys.argv[1])
