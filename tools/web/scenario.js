// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** A scenario that is edited: numbers by their keys, blocks, and balls that move along a velocity. */
class Scenario {
  constructor(text) {
    this.records = {};
    this.blocks = [];
    this.tracks = [];
    for (const line of text.split("\n")) {
      const [key, ...numbers] = line.trim().split(/\s+/);
      if (key === "block") this.blocks.push(numbers.map(Number));
      else if (key === "track") this.tracks.push(Scenario.track(line.trim().split(/\s+/)));
      else if (key) this.records[key] = numbers.map(Number);
    }
  }

  /** track NAME ball RADIUS at x y z velocity vx vy vz and further words. */
  static track([, name, , radius, , x, y, z, , vx, vy, vz, ...words]) {
    return {name, radius: Number(radius), at: [x, y, z].map(Number), velocity: [vx, vy, vz].map(Number), words};
  }

  static trackText({name, radius, at, velocity, words}) {
    return `track ${name} ball ${radius} at ${at.join(" ")} velocity ${velocity.join(" ")} ${words.join(" ")}`;
  }

  /** As a file (docs/formats.md). */
  text() {
    const records = Object.entries(this.records).map(([key, numbers]) => `${key} ${numbers.join(" ")}`);
    return [...records, ...this.blocks.map((block) => `block ${block.join(" ")}`),
      ...this.tracks.map(Scenario.trackText)].join("\n") + "\n";
  }

  /** Something that has a place: its corners, and how to move it. */
  handles() {
    const {start, goal, radius: [radius]} = this.records;
    const size = Math.max(radius, 0.3);
    const ends = [start, goal].map((point) => ({
      box: [...point.map((x) => x - size), ...point.map((x) => x + size)],
      move: (by) => this.moveBox(point, by, 1),
    }));
    const things = this.tracks.map(({at, radius: of}) => ({
      box: [...at.map((x) => x - Math.max(of, 0.3)), ...at.map((x) => x + Math.max(of, 0.3))],
      move: (by) => this.moveBox(at, by, 1),
    }));
    return [...ends, ...things, ...this.blocks.map((block) => ({box: block, block, move: (by) => this.moveBox(block, by, 2)}))];
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
