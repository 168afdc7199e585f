#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""frame_time.py TERN [--windows N]: how long a frame of the pages of --html takes in headless Chromium at 1280 x 800, as a
table in Markdown. It is the processor time of the page's main thread, so what else the machine does counts little; the
graphics processor's part, which Chromium computes on the processor here, does not count. N windows (10) of 60 frames, a
60th of a second of the plan or the flight apart, are spread over it; the first frame of a window does not count."""
import argparse
import pathlib
import statistics
import subprocess
import tempfile

import browser

NOISE = ("--set", "depth_noise=0.01", "--set", "outliers=0.01")
ROOT = pathlib.Path(__file__).parents[2]
PAGES = {
    "one plan (`docs/forest.txt`)": ("plan", ROOT / "docs/forest.txt"),
    "six plans (`bench/maps`)": ("table", *sorted(ROOT.glob("bench/maps/map*.txt")), "--repeat", "1"),
    "a flight of 14 s (`P25:7`)": ("fly", "P25:7"),
    "a flight of 61 s (`P25@1:5`, noise)": ("fly", "P25@1:5", *NOISE),
    "a flight of 60 s (`O:2`, noise)": ("fly", "O:2", *NOISE),
}
FRAMES = 60
# Each mark carries the time that the thread has had so far. The first frame of a window has a mark of its own.
PLAY = """new Promise((done) => {
  const {player} = page;
  let count = 0;
  const step = () => {
    const [window, frame] = [Math.floor(count / %(frames)d), count %% %(frames)d];
    performance.mark(frame === 0 ? "window" : "frame");
    if (window === %(windows)d) return done();
    player.set(((window + 0.5) / %(windows)d) * Math.max(player.end - 1, 0) + frame / 60);
    ++count;
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
})"""


class TracingBrowser(browser.Browser):
    """Keeps the events of a trace."""

    def __init__(self, program):
        self.events = []
        self.traced = False
        super().__init__(program, timeout=1800)

    def note(self, message):
        if message.get("method") == "Tracing.dataCollected":
            self.events += message["params"]["value"]
        self.traced = self.traced or message.get("method") == "Tracing.tracingComplete"
        super().note(message)

    def trace(self, script):
        """The events while a script runs."""
        self.events, self.traced = [], False
        self.call("Tracing.start", transferMode="ReportEvents",
                  traceConfig={"includedCategories": ["blink.user_timing", "devtools.timeline"]})
        self.run(script)
        self.call("Tracing.end")
        while not self.traced:
            self.note(self.receive())
        return sorted(self.events, key=lambda event: event.get("ts", 0))


def frame_times(events):
    """Milliseconds of the main thread, and of them of the scripts, a frame."""
    marks = [event for event in events if event["name"] in ("window", "frame") and event.get("cat") == "blink.user_timing"]
    scripts = [event for event in events if event["name"] == "FireAnimationFrame" and event["tid"] == marks[0]["tid"]
               and "tdur" in event]
    whole, own = [], []
    for before, after in zip(marks, marks[1:]):
        if before["name"] == "window":
            continue
        whole.append((after["tts"] - before["tts"]) / 1000)
        own.append(sum(event["tdur"] for event in scripts if before["ts"] <= event["ts"] + event["dur"] < after["ts"]) / 1000)
    return whole, own


def percentile(numbers, part):
    return sorted(numbers)[min(int(part * len(numbers)), len(numbers) - 1)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tern")
    parser.add_argument("--windows", type=int, default=10)
    arguments = parser.parse_args()
    print("| page | bytes | median | 99 % | scripts, median | most triangles |")
    print("| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder, TracingBrowser(browser.find()) as tab:
        tab.screen(width=1280, height=800)
        for title, command in PAGES.items():
            page = pathlib.Path(folder) / "page.html"
            subprocess.run([arguments.tern, *command, "--html", page], check=True, stdout=subprocess.DEVNULL)
            tab.open(page.as_uri(), "window.page")
            # Shaders are compiled once.
            tab.run("(async () => { for (const part of [0.2, 0.5, 0.8]) { page.player.set(part * page.player.end); "
                    "await new Promise(requestAnimationFrame); } })()")
            tab.run("page.stage.renderer.info.autoReset = false")
            whole, own = frame_times(tab.trace(PLAY % {"frames": FRAMES, "windows": arguments.windows}))
            triangles = tab.run("(() => { const {info} = page.stage.renderer; info.reset(); page.player.set(page.player.end); "
                                "page.draw(); return info.render.triangles; })()")
            print(f"| {title} | {page.stat().st_size:,} | {statistics.median(whole):.1f} ms | {percentile(whole, 0.99):.1f} ms "
                  f"| {statistics.median(own):.1f} ms | {triangles:,} |", flush=True)


main()
