#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""layout_test.py TERN ROOT FOLDER: what the reader sees of the pages of --html in headless Chromium, on desktops and phones.
Worlds fill their cells and nothing covers them; ways, vehicles and dropped plans can be seen; and what is drawn has the
colours of its key. Exit status 77 without a browser."""
import pathlib
import subprocess
import sys

import browser

DRAWN = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
SCREENS = {"desktop": {"width": 1280, "height": 800}, "upright phone": {"width": 390, "height": 844, "phone": True},
           "phone on its side": {"width": 844, "height": 390, "phone": True}}
# Probes of the page. Boxes are left, top, right, bottom in CSS pixels of the window.
PROBES = """window.probe = {
  box(element) {
    const {left, top, right, bottom} = element.getBoundingClientRect();
    return [left, top, right, bottom];
  },
  boxes(selector) {
    return [...document.querySelectorAll(selector)].filter((one) => one.offsetParent).map(probe.box);
  },
  cells() {
    return page.views.map((view, i) => {
      const {left, top, width, height} = page.stage.main(i);
      return [left, top, left + width, top + height];
    });
  },
  worlds() {
    return page.views.map((view, i) => {
      const [x0, y0, z0, x1, y1, z1] = view.run.boundary;
      const corners = [...Array(8)].map((_, k) =>
        page.stage.project(i, new THREE.Vector3(k & 1 ? x1 : x0, k & 2 ? y1 : y0, k & 4 ? z1 : z0)));
      const [xs, ys] = [corners.map((p) => p.x), corners.map((p) => p.y)];
      return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
    });
  },
  /** The picture within a box of the canvas. */
  pixels([left, top, right, bottom]) {
    page.draw();
    const canvas = document.getElementById("scene");
    const scale = canvas.width / canvas.clientWidth;
    const flat = document.createElement("canvas");
    [flat.width, flat.height] = [Math.round((right - left) * scale), Math.round((bottom - top) * scale)];
    const context = flat.getContext("2d");
    context.drawImage(canvas, -left * scale, -top * scale);
    return context.getImageData(0, 0, flat.width, flat.height).data;
  },
  /** How many pixels have each of these colours of the palette. */
  counts(names, box) {
    const data = probe.pixels(box);
    return names.map((name) => {
      const colour = new THREE.Color(page.palette[name]);
      const [r, g, b] = [colour.r, colour.g, colour.b].map((part) => 255 * part);
      const near = (i) => Math.abs(data[i] - r) < 4 && Math.abs(data[i + 1] - g) < 4 && Math.abs(data[i + 2] - b) < 4;
      let count = 0;
      for (let i = 0; i < data.length; i += 4) count += near(i);
      return count;
    });
  },
  /** Pixels that differ when something is hidden: how many, and the box around them. */
  difference(hide, show, box) {
    const before = probe.pixels(box);
    hide();
    const after = probe.pixels(box);
    show();
    const width = Math.round(box[2] - box[0]);
    const found = {count: 0, box: [1e9, 1e9, -1e9, -1e9]};
    for (let i = 0; i < before.length; i += 4) {
      if ([0, 1, 2].every((k) => Math.abs(before[i + k] - after[i + k]) < 6)) continue;
      const [x, y] = [box[0] + (i / 4) % width, box[1] + Math.floor(i / 4 / width)];
      ++found.count;
      found.box = [Math.min(found.box[0], x), Math.min(found.box[1], y), Math.max(found.box[2], x), Math.max(found.box[3], y)];
    }
    return found;
  },
  /** Pixels of the vehicle, and how many there would be in an empty world. */
  vehicle(box) {
    const shown = probe.vehiclePixels(box);
    const {legend} = page;
    const shows = legend.shows;
    legend.shows = () => false;
    const alone = probe.vehiclePixels(box);
    legend.shows = shows;
    return [shown, alone];
  },
  vehiclePixels(box) {
    const {vehicle} = page.views[0];
    return probe.difference(() => { vehicle.visible = false; }, () => { vehicle.visible = true; }, box).count;
  },
  /** The part of a way that is seen from where the camera is. */
  visible(view) {
    const towards = page.stage.camera.position.clone().normalize();
    return visiblePart(view, towards.applyAxisAngle(page.stage.camera.up, -view.turn).toArray());
  },
};"""

failures = []


def check(condition, text):
    if not condition:
        failures.append(text)
        print("FAILED:", text)


def tern(program, *arguments):
    subprocess.run([program, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def show(tab, page, **screen):
    """The page on a screen of this size. One that is open already stays open: its shaders take seconds to compile."""
    tab.screen(**screen)
    if tab.run("location.href") != page.as_uri():
        tab.open(page.as_uri(), "window.page")
        tab.run(PROBES)
    tab.run("page.player.set(0.4 * page.player.end)")
    tab.run(DRAWN)


def overlap(a, b):
    """Pixels by which two boxes overlap."""
    return min(min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1]))


def check_layout(tab, name, width, height, least_share=0.4):
    worlds, cells = tab.run("probe.worlds()"), tab.run("probe.cells()")
    for selector in (".name", ".closeup", "#layers", "#controls", "#panel"):
        for box in tab.run(f"probe.boxes('{selector}')"):
            deep = max(overlap(box, world) for world in worlds)
            check(deep <= 0, f"{name}: {selector} covers {deep:.0f} pixels of a world")
            check(box[0] >= 0 and box[2] <= width + 0.5, f"{name}: {selector} is on the screen: {box}")
    for world, cell in zip(worlds, cells):
        fill = max((world[2] - world[0]) / (cell[2] - cell[0]), (world[3] - world[1]) / (cell[3] - cell[1]))
        check(fill > 0.9 and overlap(world, cell) > 0, f"{name}: a world fills {fill:.2f} of its cell")
        check(world[0] >= cell[0] and world[1] >= cell[1] and world[2] <= cell[2] and world[3] <= cell[3],
              f"{name}: a world leaves its cell: {world}, {cell}")
    canvas = tab.run("probe.boxes('#scene')[0]")
    share = (canvas[2] - canvas[0]) * (canvas[3] - canvas[1]) / (width * height)
    check(share > least_share, f"{name}: the scene has {share:.2f} of the screen")
    slider = tab.run("probe.boxes('#time')[0]")
    least = 0.85 * width if width < 700 else 140
    check(slider[2] - slider[0] >= least, f"{name}: the slider is {slider[2] - slider[0]:.0f} pixels wide")
    rows = tab.run("probe.boxes('#layers input')")
    tops = sorted({round(box[1]) for box in rows})
    check(all(b - a > 10 for a, b in zip(tops, tops[1:])), f"{name}: the rows of the key are level: {tops}")
    check(tab.run("document.documentElement.scrollWidth") <= width, f"{name}: the page is as wide as the screen")
    check(tab.run("element('panel').scrollWidth <= element('panel').clientWidth"), f"{name}: the panel has room")


def check_pages(tab, pages):
    for name, page in pages.items():
        for screen, size in SCREENS.items():
            show(tab, page, **size)
            check_layout(tab, f"{name}, {screen}", size["width"], size["height"])
            if size.get("phone"):
                tab.click("#key")
                tab.run(DRAWN)
                check(len(tab.run("probe.boxes('#layers label')")) > 3, f"{name}, {screen}: the key opens")
                check_layout(tab, f"{name}, {screen}, with its key", size["width"], size["height"], 0.35)
                tab.click("#key")


def check_opened_on_phone(tab, page):
    size = SCREENS["upright phone"]
    show(tab, page, **size)
    check_layout(tab, "opened on a phone", size["width"], size["height"])


def check_ways(tab, page):
    """The plans of the six maps are not hidden behind their walls."""
    show(tab, page, **SCREENS["desktop"])
    parts = tab.run("page.views.map(probe.visible)")
    check(min(parts) > 0.5, f"parts of the ways that are seen: {parts}")


def check_vehicle(tab, page):
    """Where the camera follows the vehicle, obstacles hide nothing of it; and in the close-up."""
    show(tab, page, width=800, height=600)
    boxes = {"close-up": tab.run("(({left, top, width, height}) => [left, top, left + width, top + height])"
                                 "(page.stage.closeupOf(0))")}
    for name in ("close-up", "follow"):
        if name == "follow":
            tab.click("#follow")
            left, top, right, bottom = tab.run("probe.cells()[0]")
            x, y = (left + right) / 2, (top + bottom) / 2
            boxes[name] = [x - 60, y - 60, x + 60, y + 60]
        seen = []
        for part in range(1, 12):
            tab.run(f"page.player.set(page.player.end * {part} / 12)")
            seen.append(tab.run(f"probe.vehicle({boxes[name]})"))
        least, part = min(shown for shown, _ in seen), min(shown / max(alone, 1) for shown, alone in seen)
        print(f"{name}: {least} pixels of the vehicle at least; of what an empty world shows, {part:.2f}")
        check(least > 120 and part > 0.8, f"{name}: the vehicle is seen")


def check_colours(tab, page):
    """The key's colours are drawn; a dropped plan stands out."""
    show(tab, page, width=800, height=600)
    # Dropped plans are drawn for a moment, and so are the plans that brake for longest.
    times = tab.run("[...page.runs[0].film.dropped.map((drop) => drop.t + 0.05), "
                    "...page.runs[0].film.commits.map(({t, branch, step, points}) => "
                    "({t, brakes: step * points.length / 3 - (branch - t)})).sort((a, b) => b.brakes - a.brakes)"
                    ".slice(0, 12).map(({t}) => t + 0.04), "
                    "...Array.from({length: 47}, (_, i) => page.player.end * (i + 1) / 48)]")
    for theme in ("light", "dark"):
        tab.run(f"page.setTheme('{theme}')")
        names = ["known", "commit", "brake", "dropped", "seen"]
        most = dict.fromkeys(names, 0)
        for time in times:
            tab.run(f"page.player.set({time})")
            for name, count in zip(names, tab.run(f"probe.counts({names}, probe.cells()[0])")):
                most[name] = max(most[name], count)
        print(f"{theme}: pixels of", most)
        check(all(count >= 20 for count in most.values()), f"{theme}: what has the colours of its key: {most}")
        key = tab.run("[...document.querySelectorAll('.swatch:not(.scale)')].map((one) => one.style.color).length")
        check(key == tab.run("new Set([...document.querySelectorAll('.swatch:not(.scale)')]"
                             ".map((one) => one.style.color + one.className)).size"), f"{theme}: no two keys are alike")


def check_sensor(tab, page):
    """What the sensor sees ends at the world's boundary, and so on the screen."""
    show(tab, page, width=800, height=600)
    world = tab.run("probe.worlds()[0]")
    hide, draw = (f"() => {{ page.legend.hidden.{verb}('sensor'); }}" for verb in ("add", "delete"))
    found = tab.run(f"probe.difference({hide}, {draw}, probe.cells()[0])")
    box = found["box"]
    check(found["count"] > 200, f"the sensor is drawn: {found}")
    check(box[0] > world[0] - 3 and box[1] > world[1] - 3 and box[2] < world[2] + 3 and box[3] < world[3] + 3,
          f"the sensor's view {box} is within the world {world}")


def main():
    program, root, folder = sys.argv[1], *map(pathlib.Path, sys.argv[2:])
    path = browser.needed()
    folder.mkdir(parents=True, exist_ok=True)
    pages = {name: folder / f"{name}.html" for name in ("plan", "maps", "flight", "both", "twelve")}
    tern(program, "plan", root / "docs/forest.txt", "--html", pages["plan"])
    tern(program, "table", *(root / f"bench/maps/map{i}.txt" for i in range(1, 7)), "--repeat", 1, "--html", pages["maps"])
    tern(program, "fly", "P25:8", "--html", pages["flight"])
    dropped = folder / "dropped.html"
    tern(program, "fly", "C@8:1", "--html", dropped)
    tern(program, "page", pages["plan"], pages["flight"], "--out", pages["both"])
    tern(program, "page", pages["maps"], pages["maps"], "--out", pages["twelve"])
    with browser.Browser(path) as tab:
        check_pages(tab, pages)
        check_ways(tab, pages["maps"])
        check_sensor(tab, pages["flight"])
        check_vehicle(tab, pages["flight"])
        check_colours(tab, dropped)
        check_opened_on_phone(tab, pages["plan"])
        check(not tab.faults, f"errors in the browser: {tab.faults}")
    sys.exit(1 if failures else 0)


main()
