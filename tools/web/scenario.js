// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** A scenario that is edited: numbers by their keys, and blocks. */
class Scenario {
  constructor(text) {
    this.records = {};
    this.blocks = [];
    for (const line of text.split("\n")) {
      const [key, ...numbers] = line.trim().split(/\s+/);
      if (key === "block") this.blocks.push(numbers.map(Number));
      else if (key) this.records[key] = numbers.map(Number);
    }
  }

  /** As a file (docs/formats.md). */
  text() {
    const records = Object.entries(this.records).map(([key, numbers]) => `${key} ${numbers.join(" ")}`);
    return [...records, ...this.blocks.map((block) => `block ${block.join(" ")}`)].join("\n") + "\n";
  }

  /** Something that has a place: its corners, and how to move it. */
  handles() {
    const {start, goal, radius: [radius]} = this.records;
    const size = Math.max(radius, 0.3);
    const ends = [start, goal].map((point) => ({
      box: [...point.map((x) => x - size), ...point.map((x) => x + size)],
      move: (by) => this.moveBox(point, by, 1),
    }));
    return [...ends, ...this.blocks.map((block) => ({box: block, block, move: (by) => this.moveBox(block, by, 2)}))];
  }

  /** Moves `corners` points of three numbers together; they stay within the boundary. */
  moveBox(numbers, by, corners) {
    const {boundary} = this.records;
    for (let axis = 0; axis < 3; ++axis) {
      const least = boundary[axis] - numbers[axis];
      const most = boundary[axis + 3] - numbers[axis + 3 * (corners - 1)];
      const step = Math.min(Math.max(by[axis], least), most);
      for (let i = axis; i < numbers.length; i += 3) numbers[i] = Math.round((numbers[i] + step) * 100) / 100;
    }
  }

  /** Its places as those of a run that the page shows. */
  places() {
    const {start, goal, radius: [radius]} = this.records;
    return {boxes: this.blocks.flat(), start: [...start], goal: [...goal], radius};
  }

  /** Trunks at random places, none near to start or goal. */
  scatter(count) {
    const {boundary: [x0, y0, z0, x1, y1, z1], start, goal} = this.records;
    this.blocks = [];
    for (let tries = 0; this.blocks.length < count && tries < 50 * count; ++tries) {
      const size = 0.3 + 0.5 * Math.random();
      const [x, y] = [x0 + Math.random() * (x1 - x0 - size), y0 + Math.random() * (y1 - y0 - size)];
      if ([start, goal].some((p) => Math.hypot(p[0] - x, p[1] - y) < 1.8)) continue;
      this.blocks.push([x, y, z0, x + size, y + size, z1].map((number) => Math.round(number * 100) / 100));
    }
  }
}
