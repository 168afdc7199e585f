// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** What is plotted over time: [title, unit, the run's numbers by row, name of its limit]. */
const PLOTS = [
  ["speed", "m/s", (motion) => motion.lengths("v"), "v", "v"],
  ["acceleration", "m/s²", (motion) => motion.lengths("a"), "a", "a"],
  ["jerk", "m/s³", (motion) => motion.lengths("j"), "j", "j"],
  ["clearance", "m", (motion) => motion.columns.clearance, null, "radius"],
  ["work per tick", "units", (motion) => motion.columns.work, null, "work"],
];

const STATE_COLOURS = {rest: "#8a93a0", look: "#e0a100", fly: "#2f8f5b", stop: "#d9480f", threat: "#c1121f"};

/** Canvas plots below each other with one time axis. A pointer on any of them sets the time. */
class Plots {
  constructor(parent, onTime) {
    this.parent = parent;
    this.onTime = onTime;
  }

  show(runs, end, palette) {
    this.parent.textContent = "";
    this.end = end;
    this.palette = palette;
    this.items = [];
    const motions = runs.map((run) => (run.motion ? new Motion(run.motion) : null));
    for (const [title, unit, numbers, kind, limit] of PLOTS) {
      const curves = motions.map((motion) => (motion ? numbers(motion) : undefined));
      if (!curves.some((curve) => curve && curve.some((value) => value !== null))) continue;
      const item = this.add(title, unit);
      item.draw = () => this.drawCurves(item, runs, motions, curves, kind, limit);
    }
    runs.forEach((run, i) => {
      if (!run.film) return;
      const item = this.add(runs.length > 1 ? `state of ${run.name}` : "state", "");
      item.box.classList.add("strip");
      item.draw = () => this.drawStates(item, motions[i]);
    });
    this.draw();
  }

  add(title, unit) {
    const box = document.createElement("div");
    box.className = "plot";
    box.innerHTML = "<header><span></span><b></b></header><canvas></canvas><div class=cursor></div>";
    box.querySelector("span").textContent = unit ? `${title}, ${unit}` : title;
    const item = {box, legend: box.querySelector("b"), canvas: box.querySelector("canvas"),
      cursor: box.querySelector(".cursor")};
    const seek = (event) => {
      const {left, width} = item.canvas.getBoundingClientRect();
      this.onTime(Math.min(Math.max((event.clientX - left) / width, 0), 1) * this.end);
    };
    item.canvas.addEventListener("pointerdown", (event) => {
      item.canvas.setPointerCapture(event.pointerId);
      seek(event);
    });
    item.canvas.addEventListener("pointermove", (event) => { if (event.buttons > 0) seek(event); });
    this.parent.append(box);
    this.items.push(item);
    return item;
  }

  /** A canvas as sharp as the screen, and its size in CSS pixels. */
  static prepare(canvas) {
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const scale = window.devicePixelRatio;
    canvas.width = Math.max(1, Math.round(width * scale));
    canvas.height = Math.max(1, Math.round(height * scale));
    const context = canvas.getContext("2d");
    context.scale(scale, scale);
    return {context, width, height};
  }

  static curve(context, numbers, step, x, y) {
    context.beginPath();
    let drawing = false;
    numbers.forEach((value, i) => {
      if (value === null) { drawing = false; return; }
      if (drawing) context.lineTo(x(i * step), y(value)); else context.moveTo(x(i * step), y(value));
      drawing = true;
    });
    context.stroke();
  }

  drawCurves(item, runs, motions, curves, kind, limit) {
    const {context, width, height} = Plots.prepare(item.canvas);
    const limits = runs.map((run) => (limit === "radius" ? run.radius : run.limits[limit]) || null);
    const finite = (list) => (list || []).filter((value) => value !== null);
    const top = 1.08 * Math.max(1e-9, ...limits, ...curves.map((c) => finite(c).reduce((a, b) => Math.max(a, b), 0)));
    const x = (t) => (t / this.end) * width;
    const y = (value) => height - 2 - (value / top) * (height - 4);
    const style = getComputedStyle(document.documentElement);
    context.strokeStyle = style.getPropertyValue("--line");
    context.strokeRect(0.5, 0.5, width - 1, height - 1);
    context.setLineDash([4, 4]);
    new Set(limits).forEach((value) => {
      if (value === null) return;
      context.strokeStyle = style.getPropertyValue("--soft");
      Plots.curve(context, [value, value], this.end, x, y);
    });
    context.setLineDash([]);
    if (kind && runs.length === 1) {
      ["x", "y", "z"].forEach((axis, k) => {
        context.strokeStyle = this.palette.axes[k];
        context.globalAlpha = 0.75;
        Plots.curve(context, motions[0].columns[kind + axis].map(Math.abs), motions[0].step, x, y);
      });
      context.globalAlpha = 1;
    }
    context.lineWidth = 1.6;
    curves.forEach((numbers, i) => {
      if (!numbers) return;
      context.strokeStyle = runs.length === 1 ? style.getPropertyValue("--ink") : runColour(i, this.palette);
      Plots.curve(context, numbers, motions[i].step, x, y);
    });
    this.writeLegend(item, kind && runs.length === 1, limits, top / 1.08);
  }

  writeLegend(item, axes, limits, top) {
    item.legend.textContent = "";
    const say = (text, colour) => {
      const word = document.createElement("i");
      word.textContent = text;
      word.style.color = colour;
      item.legend.append(word);
    };
    if (axes) ["|x|", "|y|", "|z|"].forEach((name, k) => say(name, this.palette.axes[k]));
    if (limits.some((value) => value !== null)) say(`- - ${[...new Set(limits)].filter((v) => v !== null).join(", ")}`, "");
    say(`top ${top >= 100 ? top.toFixed(0) : top.toPrecision(3)}`, "");
  }

  drawStates(item, motion) {
    const {context, width, height} = Plots.prepare(item.canvas);
    const {state} = motion.columns;
    const scale = (width * motion.step) / this.end;
    for (let i = 0; i < state.length;) {
      let last = i;
      while (last < state.length && state[last] === state[i]) ++last;
      context.fillStyle = STATE_COLOURS[Object.keys(STATE_COLOURS)[state[i]]];
      context.fillRect(i * scale, 0, Math.max((last - i) * scale, 1), height);
      i = last;
    }
    item.legend.textContent = "";
    for (const [name, colour] of Object.entries(STATE_COLOURS)) {
      const word = document.createElement("i");
      word.textContent = name;
      word.style.color = colour;
      item.legend.append(word);
    }
  }

  draw() {
    for (const item of this.items) item.draw();
  }

  setTime(t) {
    for (const item of this.items) item.cursor.style.left = `${(100 * t) / this.end}%`;
  }
}

/** The colour of run i where there are several. */
function runColour(i, palette) {
  return palette.runs[i % palette.runs.length];
}
