#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""demo_test.py DEMO FOLDER: the demo in headless Chromium, from a file:// address. What is dragged or set is planned anew.
Leaves screenshots in FOLDER. Exit status 77 without a browser."""
import pathlib
import sys

import browser

DRAWN = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
# Where a point of the world is on the screen.
ON_SCREEN = """((x, y, z) => {
  const {left, top} = page.stage.canvas.getBoundingClientRect();
  const p = page.stage.project(0, new THREE.Vector3(x, y, z));
  return [left + p.x, top + p.y];
})"""

failures = []


def check(condition, text):
    if not condition:
        failures.append(text)
        print("FAILED:", text)


def result(tab):
    """What the page says about the plan, once there is one of all that was dragged or set."""
    tab.run(DRAWN)
    tab.wait("!demo.busy && !demo.waits")
    tab.run(DRAWN)
    return tab.run("document.getElementById('result').textContent")


def drag(tab, start, end):
    """Drags what is at a point of the world over to another one."""
    tab.drag(*tab.run(f"{ON_SCREEN}(...{start})"), *tab.run(f"{ON_SCREEN}(...{end})"))
    return result(tab)


def touch_drag(tab, start, end):
    """The same with a finger."""
    ends = [tab.run(f"{ON_SCREEN}(...{point})") for point in (start, end)]
    for kind, point in (("touchStart", ends[0]), ("touchMove", ends[1]), ("touchEnd", None)):
        points = [{"x": point[0], "y": point[1]}] if point else []
        tab.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)
    return result(tab)


def set_limit(tab, key, value):
    tab.run(f"""(() => {{
      const input = document.querySelector("[data-setting={key}]");
      input.value = {value};
      input.dispatchEvent(new Event("input"));
    }})()""")
    return result(tab)


def check_thread(tab):
    """The page goes on while a plan is made: what is moved meanwhile is shown at once, and planned next."""
    busy, plans, shown = tab.run("""(() => {
      const [block] = demo.scenario.blocks;
      demo.plan();
      demo.scenario.moveBox(block, [0.1, 0, 0], 2);
      demo.plan();
      return [demo.busy, demo.plans, page.runs[0].boxes[0] === block[0]];
    })()""")
    check(busy and shown, f"a plan is being made: {busy}; the moved block is shown: {shown}")
    check(result(tab).startswith("ok"), f"a plan with the moved block: {result(tab)}")
    check(tab.run("demo.plans") == plans + 2 and tab.run("demo.run.boxes[0] === demo.scenario.blocks[0][0]"),
          "the moved block was planned with")


def main():
    demo, folder = map(pathlib.Path, sys.argv[1:])
    path = browser.needed()
    with browser.Browser(path) as tab:
        tab.screen(width=1280, height=800)
        tab.open(demo.as_uri(), "window.demo && demo.run")
        tab.run("page.player.playing && page.player.toggle()")
        check("Shift" in tab.run("document.getElementById('editor').textContent"), "a mouse moves things up and down")
        check(result(tab).startswith("ok: planned in "), f"there is a plan: {result(tab)}")
        tab.picture(folder / "demo.png")
        print(f"{demo.stat().st_size} bytes; {result(tab)}")
        before, plans = tab.run("page.views[0].end"), tab.run("demo.plans")
        set_limit(tab, "v_max", 1)
        check(tab.run("page.views[0].end") > before, "a lower limit of speed makes a longer plan")
        goal = tab.run("demo.scenario.records.goal")
        drag(tab, goal, [goal[0] - 1.0, goal[1] - 2.0, goal[2]])
        moved = tab.run("demo.scenario.records.goal")
        check(abs(moved[0] - goal[0] + 1.0) < 0.1 and abs(moved[1] - goal[1] + 2.0) < 0.1, f"the goal moved to {moved}")
        end = tab.run("[...'xyz'].map((axis) => page.views[0].motion.columns['p' + axis].slice(-1)[0])")
        check(all(abs(a - b) < 2e-3 for a, b in zip(end, moved)), f"the plan ends at {end}")
        check(tab.run("demo.plans") > plans + 1, "each step was planned")
        touch_drag(tab, tab.run("demo.scenario.records.start"), [1.0, 3.0, 1.5])
        start = tab.run("demo.scenario.records.start")
        check(abs(start[1] - 3.0) < 0.1, f"a finger moved the start to {start}")
        x0, y0, _, x1, y1, top = tab.run("demo.scenario.blocks[5]")
        middle = [(x0 + x1) / 2, (y0 + y1) / 2, top]
        text = drag(tab, middle, [moved[0], moved[1], top])
        check(text.startswith("goal_occupied"), f"a block on the goal: {text}")
        tab.run("document.getElementById('remove').click()")
        check(result(tab).startswith("ok"), "without the block there is a plan again")
        check_thread(tab)
        camera = tab.run("page.stage.camera.position.toArray()")
        tab.drag(20, 500, 120, 500)
        turned = tab.run("page.stage.camera.position.toArray()")
        check(turned != camera, "the scene turns where nothing is grabbed")
        set_limit(tab, "v_max", 2)
        check(tab.run("page.stage.camera.position.toArray()") == turned, "the camera stays where it was turned to")
        tab.screen(width=390, height=844, phone=True, dark=True)
        tab.open(demo.as_uri(), "window.demo && demo.run")
        tab.run(DRAWN)
        tab.picture(folder / "demo_phone.png")
        hint = tab.run("document.getElementById('editor').textContent")
        check("Shift" not in hint and "Sliders" in hint, f"a phone has no key to press: {hint}")
        check(tab.run("document.documentElement.scrollWidth") <= 390, "the page is as wide as the phone")
        check(not tab.faults, f"errors in the browser: {tab.faults}")
    sys.exit(1 if failures else 0)


main()
