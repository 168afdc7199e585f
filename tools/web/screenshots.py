#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""screenshots.py TERN DEMO FOLDER: page and demo on a desktop and a phone, light and dark, to FOLDER/page/; and a flight
without controls around it to FOLDER/flight.png.

screenshots.py --flight PAGE FILE: the flight of a page without controls around it.

screenshots.py --at SECONDS PAGE FILE: a page as it is then."""
import base64
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tests/page"))
import browser  # noqa: E402

PAGE_WORLD = "P12:3"
STILL_WORLD = "S10:2"
SCREENS = {"desktop": {"width": 1280, "height": 800}, "phone": {"width": 390, "height": 844, "phone": True}}
STILL = {"width": 1400, "height": 560}
DRAWN = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
STAGE_ALONE = """(() => {
  const style = document.createElement("style");
  style.textContent = "main { grid-template: 1fr / 1fr } #panel, #controls, #layers { display: none }";
  document.head.append(style);
})()"""
# The commit with the most to see between two parts of a flight: a way before the brake and a brake, not behind obstacles.
TELLING = """((from, to) => {
  const {views: [view], runs: [{film}], stage: {camera}} = page;
  const towards = camera.position.clone().normalize().applyAxisAngle(camera.up, -view.turn).toArray();
  const length = (points) => points.slice(1).reduce((sum, p, i) => sum + p.distanceTo(points[i]), 0);
  let best = {worth: -1, t: 0};
  for (const {t, branch, step, points, corridor} of film.commits) {
    if (!corridor || t < from * view.end || t > to * view.end) continue;
    const way = pointsOf(points);
    const cut = Math.max(0, Math.round((branch - t) / step));
    const least = Math.min(length(way.slice(0, cut + 1)), length(way.slice(cut)));
    const seen = way.filter((p) => !view.boxes.some((box) => meets(p.toArray(), towards, box))).length / way.length;
    const worth = least * seen ** 2;
    if (worth > best.worth) best = {worth, t};
  }
  return best.t + 0.04;
})"""


def compress(tab, path):
    """Writes a picture again as PNG without filters, which suits flat colours: a fifth smaller than the browser's."""
    text = base64.b64encode(path.read_bytes()).decode()
    width, height, pixels = tab.run(f"""(async () => {{
      const image = new Image();
      image.src = "data:image/png;base64,{text}";
      await image.decode();
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [image.width, image.height];
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      const {{data}} = context.getImageData(0, 0, image.width, image.height);
      let text = "";
      for (let i = 0; i < data.length; i += 4) text += String.fromCharCode(data[i], data[i + 1], data[i + 2]);
      return [image.width, image.height, btoa(text)];
    }})()""")
    rgb = base64.b64decode(pixels)
    rows = b"".join(b"\0" + rgb[3 * width * y:3 * width * (y + 1)] for y in range(height))
    chunks = ((b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)), (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b""))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)) for kind, data in chunks))


def take(tab, path):
    tab.run(DRAWN)
    tab.picture(path)
    compress(tab, path)
    print(f"{path}: {path.stat().st_size} bytes")


def fly(program, world, folder):
    page = pathlib.Path(folder) / f"{world.replace(':', '_')}.html"
    subprocess.run([program, "fly", world, "--html", page], check=True)
    return page


def take_still(tab, page, path):
    tab.screen(**STILL)
    tab.open(page.as_uri(), "window.page && page.views")
    tab.run(STAGE_ALONE)
    tab.run(f"page.player.set({TELLING}(0.6, 0.9))")
    take(tab, path)


def take_at(tab, seconds, page, path):
    tab.screen(width=1000, height=700)
    tab.open(page.as_uri(), "window.page && page.views")
    tab.run("page.player.playing && page.player.toggle()")
    tab.run(f"page.player.set({seconds})")
    take(tab, path)


def main():
    if sys.argv[1] == "--at":
        page, path = (pathlib.Path(name).resolve() for name in sys.argv[3:])
        with browser.Browser(browser.find()) as tab:
            take_at(tab, float(sys.argv[2]), page, path)
        return
    if sys.argv[1] == "--flight":
        page, path = (pathlib.Path(name).resolve() for name in sys.argv[2:])
        with browser.Browser(browser.find()) as tab:
            take_still(tab, page, path)
        return
    program, demo, folder = sys.argv[1], *(pathlib.Path(path).resolve() for path in sys.argv[2:])
    (folder / "page").mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch, browser.Browser(browser.find()) as tab:
        pages = {"page": fly(program, PAGE_WORLD, scratch), "demo": demo}
        for name, page in pages.items():
            for screen, size in SCREENS.items():
                for theme in ("light", "dark"):
                    tab.screen(**size, dark=theme == "dark")
                    tab.open(page.as_uri(), "window.page && page.views")
                    tab.run("page.player.playing && page.player.toggle()")
                    tab.run(f"page.player.set(page.runs[0].film ? {TELLING}(0.5, 0.9) : 0.37 * page.player.end)")
                    take(tab, folder / "page" / f"{name}_{screen}_{theme}.png")
        take_still(tab, fly(program, STILL_WORLD, scratch), folder / "flight.png")
        if tab.faults:
            sys.exit(f"errors in the browser: {tab.faults}")


main()
