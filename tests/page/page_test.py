#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""page_test.py TERN ROOT FOLDER: the pages of --html in headless Chromium. They load from a file:// address without an
error on the console, the slider sets the time, and the readouts have the numbers of `tern plan --csv` there. Leaves its
screenshots in FOLDER. Exit status 77 without a browser."""
import csv
import math
import pathlib
import re
import subprocess
import sys

import browser

DRAWN = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
# Colours on the canvas: a scene that is drawn has many.
COLOURS = """(() => {
  page.draw();
  const canvas = document.getElementById("scene");
  const flat = document.createElement("canvas");
  [flat.width, flat.height] = [canvas.width, canvas.height];
  const context = flat.getContext("2d");
  context.drawImage(canvas, 0, 0);
  const {data} = context.getImageData(0, 0, flat.width, flat.height);
  const colours = new Set();
  for (let i = 0; i < data.length; i += 4) colours.add(data[i] * 65536 + data[i + 1] * 256 + data[i + 2]);
  return colours.size;
})()"""

failures = []


def check(condition, text):
    if not condition:
        failures.append(text)
        print("FAILED:", text)


def tern(program, *arguments):
    subprocess.run([program, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def readout(tab, title, run=0):
    return tab.run(f"document.querySelectorAll('[data-readout=\"{title}\"]')[{run}].textContent")


def look(tab, page, folder, name, **screen):
    tab.screen(**screen)
    tab.open(page.as_uri(), "window.page")
    tab.run("page.player.set(0.4 * page.player.end)")
    tab.run(DRAWN)
    tab.picture(folder / f"{name}.png")
    check(tab.run(COLOURS) > 10, f"{name}: the scene is drawn")


def check_readouts(tab, table):
    """The readouts at some times beside the plan's own table; speeds have two decimals."""
    for part in (0.25, 0.5, 0.75):
        row = table[int(part * (len(table) - 1))]
        tab.run(f"page.player.set({row['t']})")
        for title, kind in (("speed", "v"), ("accel.", "a"), ("jerk", "j")):
            expected = math.hypot(*(float(row[kind + axis]) for axis in "xyz"))
            # Between the page's rows numbers are interpolated.
            check(abs(float(readout(tab, title)) - expected) < 0.006 + 0.01 * expected,
                  f"{title} at {row['t']}: {readout(tab, title)}, not {expected}")


def check_slider(tab):
    """The slider, dragged with the mouse; play and pause."""
    left, top, width, height = tab.run(
        "(({left, top, width, height}) => [left, top, width, height])(document.getElementById('time').getBoundingClientRect())")
    tab.run("page.player.set(0)")
    middle = top + height / 2
    tab.drag(left + 8, middle, left + width / 2, middle)
    time, end = tab.run("[page.player.time, page.player.end]")
    check(abs(time - end / 2) < 0.03 * end, f"the slider was dragged to the middle, the time is {time} of {end}")
    check(tab.run("document.getElementById('clock').textContent") == f"{time:.2f} / {end:.2f} s",
          "the clock shows the time")
    tab.run("document.getElementById('play').click()")
    tab.wait(f"page.player.time > {time} + 0.05")
    tab.run("document.getElementById('play').click()")
    check(not tab.run("page.player.playing"), "it pauses")


def check_turn(tab):
    """The scene is turned with the mouse, and its time set on a plot."""
    before = tab.run("page.stage.camera.position.x")
    tab.drag(300, 300, 420, 330)
    check(abs(tab.run("page.stage.camera.position.x") - before) > 1e-3, "dragging turns the scene")
    left, top, width = tab.run(
        "(({left, top, width}) => [left, top, width])(document.querySelector('.plot canvas').getBoundingClientRect())")
    gutter = tab.run("GUTTER")
    tab.drag(left + gutter + 5, top + 20, left + gutter + (width - gutter) / 4, top + 20)
    time, end = tab.run("[page.player.time, page.player.end]")
    check(abs(time - end / 4) < 0.02 * end, f"a plot sets the time: {time} of {end}")


def check_keys(tab):
    """The space bar plays and pauses, whatever was used last."""
    def press_space():
        before = tab.run("page.player.playing")
        tab.key(" ", "Space")
        return tab.run("page.player.playing") != before

    check(press_space() and press_space(), "the space bar plays and pauses after the slider was used")
    for name in ("follow", "theme"):
        tab.click(f"#{name}")
        check(press_space() and press_space(), f"the space bar plays and pauses after a click on {name}")
    tab.click("#follow")
    tab.run("document.getElementById('follow').focus()")
    tab.key(" ", "Space")
    check(tab.run("document.getElementById('follow').checked"), "the keyboard reaches the checkbox")
    tab.key(" ", "Space")
    tab.run("document.activeElement.blur(), page.player.set(1)")
    tab.key("ArrowRight", "ArrowRight")
    check(abs(tab.run("page.player.time") - 1.1) < 1e-9, "an arrow key steps by 0.1 s")


def check_plan(tab, program, root, folder):
    page, table = folder / "plan.html", folder / "plan.csv"
    tern(program, "plan", root / "docs/forest.txt", "--html", page, "--csv", table)
    for dark in (False, True):
        name = "dark" if dark else "light"
        look(tab, page, folder, f"plan_{name}", width=1280, height=800, dark=dark)
        check(tab.run("document.documentElement.dataset.theme") == name, f"the page is {name}")
        look(tab, page, folder, f"phone_{name}", width=390, height=844, phone=True, dark=dark)
        check(tab.run("document.documentElement.scrollWidth") <= 390, "the page is as wide as the phone")
    tab.screen(width=1280, height=800)
    check_readouts(tab, list(csv.DictReader(table.open())))
    check_slider(tab)
    check_keys(tab)
    check_turn(tab)


def check_table(tab, program, root, folder):
    """Several plans share their time; the shorter ones wait at their ends. Joined pages show the same."""
    maps = [root / f"bench/maps/map{i}.txt" for i in (1, 2, 3)]
    pages = []
    for path in maps:
        pages.append(folder / f"{path.stem}.html")
        tern(program, "plan", path, "--html", pages[-1])
    tern(program, "table", *maps, "--repeat", 1, "--html", folder / "table.html")
    tern(program, "page", *pages, "--out", folder / "joined.html")
    for name in ("table", "joined"):
        look(tab, folder / f"{name}.html", folder, name, width=1280, height=800)
        check(tab.run("page.views.length") == 3, "three views")
        check(tab.run("page.player.end === Math.max(...page.views.map((view) => view.end))"), "the longest plan counts")
        tab.run("page.player.set(page.player.end)")
        check(all(readout(tab, "speed", i) == "0.00" for i in range(3)), "all plans are at rest at the end")


def check_flight(tab, program, folder):
    """What a flight knew grows with time, and each tick has its readouts."""
    page, samples = folder / "flight.html", folder / "flight.csv"
    tern(program, "fly", "P25:7", "--html", page, "--csv", samples)
    table = list(csv.DictReader(samples.open()))
    look(tab, page, folder, "flight_phone", width=390, height=844, phone=True)
    look(tab, page, folder, "flight", width=1280, height=800, dark=True)
    for row in table[200::400]:
        tab.run(f"page.player.set({row['t']} + 1e-6)")
        check(readout(tab, "work") == row["tick_work"], f"work at {row['t']}: {readout(tab, 'work')}")
        check(readout(tab, "state") == row["state"], f"state at {row['t']}: {readout(tab, 'state')}")
        speed = math.hypot(*(float(row[f"true_v_{axis}"]) for axis in "xyz"))
        check(abs(float(readout(tab, "speed")) - speed) < 0.011, f"speed at {row['t']}: {readout(tab, 'speed')}")
    commits = sum(row["event"] == "commit" for row in table)
    check(tab.run("page.runs[0].film.commits.length") == commits, f"{commits} commits")
    # Obstacles and floor that are known at a time: more and more.
    known = [tab.run(f"""(() => {{
      const {{known: {{blocks}}, seen: {{times}}}} = page.runs[0].film;
      let count = 0;
      for (let i = 5; i < blocks.length; i += 7) count += blocks[i] <= {t};
      return [count, times.filter((time) => time >= 0 && time <= 10 * {t}).length];
    }})()""") for t in (1, 6, 12)]
    check(all(0 < a < b for pair in zip(known, known[1:]) for a, b in zip(*pair)), f"what is known grows: {known}")


def check_blocked(tab, program, folder):
    """What is in the way at the end of a flight has a mark that can be hidden."""
    page = folder / "blocked.html"
    done = subprocess.run([program, "fly", "O:2", "--set", "time_limit=2", "--html", page],
                          capture_output=True, text=True)
    words = re.search("in the way: .* at (.*)", done.stdout).group(1).split()
    look(tab, page, folder, "blocked", width=1280, height=800)
    check(tab.run("page.runs[0].blocked.map((x) => x.toFixed(2))") == words, f"the page has the point {words}")
    places = tab.run("page.views[0].layers.blocked.children.slice(0, 1).map((cube) => cube.position.toArray())")
    check([f"{x:.2f}" for x in places[0]] == words, f"the mark is there: {places}")
    tab.run("document.querySelector('[data-layer=blocked]').click()")
    tab.wait("!page.views[0].layers.blocked.visible")


def check_things(tab, program, root, folder):
    """Things have their names while they are there, and keep-outs for a while are fences."""
    page = folder / "things.html"
    tern(program, "plan", root / "docs/tracks.txt", "--html", page)

    def names():
        return tab.run("[...document.querySelectorAll('#labels .point')].filter((e) => !e.hidden).map((e) => e.textContent)")

    look(tab, page, folder, "things", width=1280, height=800)
    check(names() == ["start", "goal", "man", "bird", "keepout 1"], f"what is there has its name: {names()}")
    facts = tab.run("document.getElementById('facts').textContent")
    check(re.search(r"0\.\d+ m from blocks; nearest (man|bird|keepout 1) at 0\.\d+ m", facts), f"both clearances: {facts}")
    man, closed = tab.run("[2, 4].map((k) => document.querySelectorAll('#labels .point')[k].style.color)")
    check(man != closed, "things and keep-outs for a while have two colours")
    tab.run("page.player.set(6.5)")
    tab.run(DRAWN)
    check(names() == ["start", "goal", "man", "bird"], f"what has gone has no name: {names()}")
    tab.run("page.player.set(1), document.querySelector('[data-layer=things]').click()")
    tab.wait("!page.views[0].layers.things.visible")
    tab.run(DRAWN)
    check(names() == ["start", "goal", "keepout 1"], f"what is hidden has no name: {names()}")


def check_no_plan(tab, program, root, folder):
    """A scenario without a plan has a page all the same; a name like markup does not spoil it."""
    page = folder / "none.html"
    name = folder / "<!--<script>.txt"
    name.write_text((root / "bench/maps/map1.txt").read_text())
    result = subprocess.run([program, "plan", name, "--set", "radius=5", "--html", page], stderr=subprocess.DEVNULL)
    check(result.returncode == 3, "there is no plan")
    look(tab, page, folder, "none", width=1280, height=800)
    check("<!--<script>.txt" in tab.run("document.title"), "the page has the name")
    check(re.search("occupied|clear", tab.run("document.getElementById('facts').textContent")), "the page says why")


def check_without_webgl(tab, folder):
    """The pages that were made before, in a browser without WebGL: they say so, and plots and figures are there."""
    for name in ("plan", "table", "flight"):
        tab.screen(width=1280, height=800)
        tab.open((folder / f"{name}.html").as_uri(), "window.page")
        tab.run("page.player.set(0.1 * page.player.end)")
        tab.run(DRAWN)
        tab.picture(folder / f"{name}_without_webgl.png")
        check(tab.run("page.stage.renderer === null"), f"{name}: the browser has no WebGL")
        check(tab.run("document.getElementById('missing').offsetHeight > 0"), f"{name}: the page says what is missing")
        check("WebGL" in tab.run("document.getElementById('missing').textContent"), f"{name}: and why")
        check(tab.run("document.getElementById('fault').hidden"), f"{name}: nothing else is wrong")
        check(tab.run("document.querySelectorAll('.plot canvas').length > 3"), f"{name}: the plots are there")
        check(tab.run("document.querySelectorAll('#facts dd').length > 3"), f"{name}: the facts are there")
        check(float(readout(tab, "speed")) > 0, f"{name}: the readouts follow the time")
    check_slider(tab)


def main():
    program, root, folder = sys.argv[1], *map(pathlib.Path, sys.argv[2:])
    path = browser.needed()
    folder.mkdir(parents=True, exist_ok=True)
    with browser.Browser(path) as tab:
        for part in (check_plan, check_table, check_things, check_no_plan):
            part(tab, program, root, folder)
        check_flight(tab, program, folder)
        check_blocked(tab, program, folder)
        check(not tab.faults, f"errors in the browser: {tab.faults}")
    with browser.Browser(path, flags=["--disable-3d-apis"]) as tab:
        check_without_webgl(tab, folder)
        check(not tab.faults, f"errors in a browser without WebGL: {tab.faults}")
    sys.exit(1 if failures else 0)


main()
