// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** What is plotted over time: [title, unit, kind of a vector or name of a column, name of the limit, its words]. */
const PLOTS = [
  ["velocity", "m/s", "v", "v", "axis limit"],
  ["acceleration", "m/s²", "a", "a", "axis limit"],
  ["jerk", "m/s³", "j", "j", "axis limit"],
  ["clearance from obstacles", "m", "clearance", "radius", "radius"],
  ["work per tick", "units", "work", "work", "limit"],
];

const GUTTER = 30;  // pixels left of the curves, for numbers

/** A step of 1, 2 or 5 times a power of ten with which `span` has `most` steps at most. */
function niceStep(span, most) {
  const power = 10 ** Math.floor(Math.log10(span / most));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => span / step <= most * (1 + 1e-9));
}

/** Least, largest and mean of the numbers that fall on each of `width` pixels; null where there is none. */
function bandOf(numbers, perPixel, width) {
  const band = [...Array(width)].map(() => null);
  numbers.forEach((value, i) => {
    const x = Math.min(Math.floor(i / perPixel), width - 1);
    const {least, most, sum, count} = band[x] || {least: value, most: value, sum: 0, count: 0};
    band[x] = {least: Math.min(least, value), most: Math.max(most, value), sum: sum + value, count: count + 1};
  });
  return band;
}

/** Canvas plots below each other with one time axis. A pointer on any of them sets the time. */
class Plots {
  constructor(parent, onTime) {
    this.parent = parent;
    this.onTime = onTime;
    this.items = [];
  }

  show(runs, end, palette) {
    Object.assign(this, {runs, end, palette, items: []});
    this.parent.textContent = "";
    this.motions = runs.map((run) => (run.motion ? new Motion(run.motion) : null));
    for (const [title, unit, name, limit, words] of PLOTS) {
      const curves = this.curvesOf(name);
      if (!curves.some(({numbers}) => numbers.some((value) => value !== null))) continue;
      const largest = name.length === 1 && runs.length > 1 ? ", largest component" : "";
      const item = this.add(`${title}${largest}, ${unit}`);
      const limits = [...new Set(runs.map((run) => (limit === "radius" ? run.radius : run.limits[limit]) || null))]
        .filter((value) => value !== null);
      item.draw = () => this.drawCurves(item, curves, limits, name === "work");
      if (name.length === 1 && runs.length === 1) {
        ["x", "y", "z"].forEach((axis, k) => this.key(item, `|${axis}|`, `2px solid ${palette.axes[k]}`));
      }
      if (limits.length > 0) this.key(item, `${words} ${limits.slice(0, 3).join(", ")}`, "2px dashed");
    }
    runs.forEach((run, i) => {
      if (run.film) this.addStates(run, i);
    });
    if (this.motions.some((motion) => motion)) this.addAxis();
    this.draw();
  }

  /** Curves with their colours: of a single run, a vector's components; of several, the largest of them. */
  curvesOf(name) {
    const curves = [];
    this.motions.forEach((motion, i) => {
      if (!motion) return;
      const style = this.runs.length > 1
        ? {colour: runColour(i, this.palette), dashed: runIsDashed(i, this.palette)} : {colour: css(this.palette.ink)};
      if (name.length > 1) {
        if (motion.columns[name]) curves.push({numbers: motion.columns[name], step: motion.step, ...style});
      } else if (this.runs.length > 1) {
        curves.push({numbers: motion.largest(name), step: motion.step, ...style});
      } else {
        ["x", "y", "z"].forEach((axis, k) => curves.push({numbers: motion.columns[name + axis].map(Math.abs),
          step: motion.step, colour: this.palette.axes[k]}));
      }
    });
    return curves;
  }

  add(title, kind = "") {
    const box = document.createElement("div");
    box.className = `plot ${kind}`;
    box.innerHTML = "<header><span></span><b></b></header><canvas></canvas><div class=cursor></div>";
    box.querySelector("span").textContent = title;
    const item = {box, legend: box.querySelector("b"), canvas: box.querySelector("canvas"),
      cursor: box.querySelector(".cursor")};
    const seek = (event) => {
      const {left, width} = item.canvas.getBoundingClientRect();
      this.onTime(Math.min(Math.max((event.clientX - left - GUTTER) / (width - GUTTER), 0), 1) * this.end);
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

  /** An entry of a plot's key. */
  key(item, text, line) {
    const word = document.createElement("i");
    const sample = document.createElement("u");
    sample.style.borderTop = line;
    word.append(sample, text);
    item.legend.append(word);
  }

  addStates(run, i) {
    const item = this.add(this.runs.length > 1 ? `state of ${run.name}` : "state", "strip");
    item.draw = () => drawStates(this.prepare(item.canvas, false), run, this.motions[i], this.palette);
    if (this.runs.slice(0, i).some((other) => other.film)) return;
    for (const [name, colour] of [...STATES, ["dropped", "dropped"]]) {
      this.key(item, name, `6px solid ${css(this.palette[colour])}`);
    }
  }

  addAxis() {
    const item = this.add("", "axis");
    item.draw = () => {
      const {context, width, x} = this.prepare(item.canvas, false);
      context.fillStyle = css(this.palette.ink);
      const {step, digits} = this.timeStep(width - GUTTER);
      for (let t = 0; t <= this.end * (1 + 1e-9); t += step) {
        const text = t === 0 ? "0 s" : t.toFixed(digits);
        const half = context.measureText(text).width / 2;
        context.fillText(text, Math.min(x(t) - half, width - 2 * half), 11);
      }
    };
  }

  timeStep(width) {
    const step = niceStep(this.end, Math.max(width / 45, 1));
    return {step, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9))};
  }

  /** A canvas as sharp as the screen, its size in CSS pixels, and where times are on it. */
  prepare(canvas, hasGrid) {
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const scale = window.devicePixelRatio;
    canvas.width = Math.max(1, Math.round(width * scale));
    canvas.height = Math.max(1, Math.round(height * scale));
    const context = canvas.getContext("2d");
    context.scale(scale, scale);
    context.font = "10px system-ui, sans-serif";
    const x = (t) => GUTTER + (t / this.end) * (width - GUTTER);
    if (hasGrid) {
      context.strokeStyle = Plots.colour("--line");
      context.strokeRect(GUTTER + 0.5, 0.5, width - GUTTER - 1, height - 1);
      const {step} = this.timeStep(width - GUTTER);
      for (let t = step; t < this.end; t += step) stroke(context, [[x(t), 0], [x(t), height]]);
    }
    return {context, width, height, x};
  }

  /** One of the page's own colours. */
  static colour(name) {
    return getComputedStyle(document.documentElement).getPropertyValue(name);
  }

  drawCurves(item, curves, limits, isBand) {
    const {context, width, height, x} = this.prepare(item.canvas, true);
    const most = curves.reduce((top, {numbers}) => numbers.reduce((a, b) => Math.max(a, b), top), 1e-9);
    const top = 1.12 * Math.max(most, ...limits);
    const y = (value) => height - 1 - (value / top) * (height - 2);
    this.drawScale(context, width, top, y);
    context.strokeStyle = Plots.colour("--soft");
    context.setLineDash([4, 4]);
    for (const limit of limits) stroke(context, [[GUTTER, y(limit)], [width, y(limit)]]);
    for (const {numbers, step, colour, dashed} of curves) {
      context.strokeStyle = context.fillStyle = colour;
      context.lineWidth = 1.5;
      context.setLineDash(dashed ? [5, 3] : []);
      if (isBand) this.drawBand(context, curves.length === 1, numbers, this.end / step / (width - GUTTER), width - GUTTER, y);
      else drawCurve(context, numbers, (i) => x(i * step), y);
    }
  }

  /** A line at the mean of each pixel's numbers; and all that is between the least and the largest of them, if asked for. */
  drawBand(context, isFilled, numbers, perPixel, width, y) {
    const band = bandOf(numbers, perPixel, Math.max(Math.round(width), 1));
    context.globalAlpha = 0.35;
    band.forEach((pixel, x) => {
      if (pixel && isFilled) context.fillRect(GUTTER + x, y(pixel.most), 1, Math.max(y(pixel.least) - y(pixel.most), 1));
    });
    context.globalAlpha = 1;
    context.lineWidth = 1;
    drawCurve(context, band.map((pixel) => (pixel ? pixel.sum / pixel.count : null)), (x) => GUTTER + x + 0.5, y);
  }

  /** Numbers in the gutter, with lines across. */
  drawScale(context, width, top, y) {
    const step = niceStep(top, 4.5);
    context.fillStyle = Plots.colour("--soft");
    context.strokeStyle = Plots.colour("--line");
    context.textAlign = "right";
    for (let value = 0; value <= top; value += step) {
      const text = String(Number(value.toPrecision(6)));
      context.fillText(text, GUTTER - 4, Math.min(Math.max(y(value) + 3.5, 8), y(0)));
      if (value > 0) stroke(context, [[GUTTER, y(value)], [width, y(value)]]);
    }
    context.textAlign = "left";
  }

  draw() {
    for (const item of this.items) item.draw();
  }

  setTime(t) {
    for (const item of this.items) {
      item.cursor.style.left = `calc(${GUTTER}px + (100% - ${GUTTER}px) * ${t / this.end})`;
    }
  }
}

function stroke(context, points) {
  context.beginPath();
  points.forEach(([x, y], i) => { if (i === 0) context.moveTo(x, y); else context.lineTo(x, y); });
  context.stroke();
}

/** A line through numbers; null interrupts it. */
function drawCurve(context, numbers, x, y) {
  context.beginPath();
  let drawing = false;
  numbers.forEach((value, i) => {
    if (value === null) { drawing = false; return; }
    if (drawing) context.lineTo(x(i), y(value)); else context.moveTo(x(i), y(value));
    drawing = true;
  });
  context.stroke();
}

/** The states of a flight as a strip, and below it a mark for each plan that was dropped. */
function drawStates({context, height, x}, run, motion, palette) {
  const {state} = motion.columns;
  for (let i = 0; i < state.length;) {
    let last = i;
    while (last < state.length && state[last] === state[i]) ++last;
    context.fillStyle = css(palette[STATES[state[i]][1]]);
    const [from, to] = [x(i * motion.step), x(last * motion.step)];
    context.fillRect(from, 0, Math.max(to - from, 1), height - 6);
    i = last;
  }
  context.fillStyle = css(palette.dropped);
  for (const {t} of run.film.dropped) context.fillRect(x(t) - 1, height - 5, 2, 5);
}
