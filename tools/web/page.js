// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

const element = (id) => document.getElementById(id);

/** The page: one player, one stage, and a key, readouts and plots that follow them. */
class Page {
  constructor() {
    this.stage = new Stage(element("scene"));
    this.showScene(this.stage.renderer !== null);
    this.labels = new Labels(element("labels"));
    this.legend = new Legend(element("layers"), (name) => this.shownOrHidden(name));
    this.player = new Player(() => this.changed());
    this.plots = new Plots(element("plots"), (t) => this.player.set(t));
    this.dirty = true;
    this.turned = false;  // by the reader
    this.setTheme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    this.listen();
    requestAnimationFrame((now) => this.tick(now));
  }

  listen() {
    element("play").addEventListener("click", () => this.player.toggle());
    element("time").addEventListener("input", (event) => this.player.set(Number(event.target.value)));
    element("speed").addEventListener("change", (event) => { this.player.speed = Number(event.target.value); });
    element("follow").addEventListener("change", (event) => this.arrange(() => this.stage.follow(event.target.checked)));
    element("key").addEventListener("click", (event) => {
      const isOpen = document.body.classList.toggle("key");
      event.currentTarget.setAttribute("aria-expanded", isOpen);
    });
    element("theme").addEventListener("click", () => this.setTheme(this.theme === "dark" ? "light" : "dark"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", (event) =>
      this.setTheme(event.matches ? "dark" : "light"));
    this.stage.controls.addEventListener("start", () => { this.turned = true; });
    this.stage.controls.addEventListener("change", () => { this.dirty = true; });
    element("scene").addEventListener("webglcontextlost", () => this.showScene(false));
    element("scene").addEventListener("webglcontextrestored", () => this.showScene(true));
    new ResizeObserver(() => this.resized()).observe(element("stage"));
    window.addEventListener("keydown", (event) => this.key(event));
    // What was clicked gives the keyboard back: the space bar plays again.
    for (const kind of ["click", "change"]) {
      window.addEventListener(kind, (event) => {
        if (event.detail > 0 || event.target.tagName === "SELECT") event.target.blur();
      });
    }
  }

  /** Without WebGL, the page says so in place of the scene, and has all the rest. */
  showScene(isThere) {
    document.body.classList.toggle("flat", !isThere);
    element("missing").hidden = isThere;
    this.dirty = true;
  }

  key(event) {
    const {tagName, type, id} = event.target;
    if (["SELECT", "BUTTON"].includes(tagName) || ["checkbox", "text"].includes(type)) return;
    const steps = {ArrowLeft: -0.1, ArrowRight: 0.1};
    if (event.key === " ") this.player.toggle();
    else if (event.key in steps && (type !== "range" || id === "time")) this.player.set(this.player.time + steps[event.key]);
    else return;
    event.preventDefault();
  }

  /** Shows runs. A camera that the reader has turned stays where it is. */
  show(runs, keepsCamera = false) {
    this.runs = runs;
    for (const view of this.views || []) view.dispose();
    this.fastest = fastestOf(runs);
    this.views = runs.map((run) => new RunView(run, this.palette, this.fastest));
    this.player.end = Math.max(1e-3, ...this.views.map((view) => view.end));
    document.title = `Tern: ${runs.map((run) => run.name).join(", ")}`;
    element("time").max = this.player.end;
    this.writeFacts();
    this.write();
    this.stage.resize();
    this.arrange(() => this.stage.show(this.views, keepsCamera));
    this.player.set(Math.min(this.player.time, this.player.end));
  }

  setTheme(theme) {
    this.theme = theme;
    this.palette = PALETTES[theme];
    document.documentElement.dataset.theme = theme;
    if (!this.runs) return;
    for (const view of this.views) view.build(this.palette);
    this.write();
    this.arrange(() => {});
    this.changed();
  }

  /** All that has the palette's colours, but for the scene. */
  write() {
    this.labels.build(this.runs, this.palette);
    this.legend.build(this.views, this.palette, this.fastest);
    this.plots.show(this.runs, this.player.end, this.palette);
    this.buildReadouts();
  }

  /** Something happens to the stage, and the texts on it follow. */
  arrange(action) {
    action();
    this.labels.layOut(this.stage);
    this.dirty = true;
  }

  resized() {
    this.stage.resize();
    if (!this.views) return;
    this.arrange(() => this.frame());
    this.plots.draw();
  }

  /** Shows all of the worlds, from where the reader has turned them to. */
  frame() {
    if (this.turned) this.stage.layOut(); else this.stage.frame();
  }

  shownOrHidden(name) {
    this.stage.hasCloseups = this.legend.shows("closeup");
    this.arrange(() => { if (name === "closeup") this.frame(); });
  }

  writeFacts() {
    element("facts").textContent = "";
    for (const run of this.runs) {
      const title = document.createElement("h2");
      title.textContent = run.name;
      const list = document.createElement("dl");
      const stages = (run.stages || []).map(({name, work, us}) => [name, `${us} µs, ${work} units`]);
      for (const [label, text] of [...run.facts, ...stages]) {
        const term = document.createElement("dt");
        const value = document.createElement("dd");
        term.textContent = label;
        value.textContent = text;
        list.append(term, value);
      }
      element("facts").append(title, list);
    }
  }

  /** The columns of the readouts: a title, its unit, and its text for a view. */
  readoutColumns() {
    const length = (kind) => (view) => view.motion.vector(kind, view.time).length().toFixed(2);
    const columns = [
      ["speed", "m/s", length("v")], ["accel.", "m/s²", length("a")], ["jerk", "m/s³", length("j")],
      ["height", "m", (view) => view.motion.number("pz", view.time).toFixed(2)],
      ["clear", "m", (view) => {
        const clear = view.motion.columns.clearance[0] === null ? null : view.motion.number("clearance", view.time);
        return clear === null ? "-" : clear.toFixed(2);
      }],
    ];
    if (this.runs.some((run) => run.film)) {
      const row = (view) => view.motion.at(view.time)[0];
      columns.push(
        ["work", "units", (view) => (view.film ? String(view.motion.columns.work[row(view)]) : "")],
        ["state", "", (view) => (view.film ? STATES[view.motion.columns.state[row(view)]][0] : "")]);
    }
    return columns;
  }

  buildReadouts() {
    const table = element("readouts");
    table.textContent = "";
    this.columns = this.readoutColumns();
    const head = table.insertRow();
    for (const [title, unit] of [["", ""], ...this.columns]) {
      const cell = document.createElement("th");
      const small = document.createElement("small");
      small.textContent = unit;
      cell.append(title, small);
      head.append(cell);
    }
    head.firstChild.hidden = this.runs.length === 1;
    this.cells = this.runs.map((run, i) => {
      const row = table.insertRow();
      const name = row.insertCell();
      name.hidden = this.runs.length === 1;
      if (this.runs.length > 1) name.append(runKey(i, this.palette));
      name.append(run.name);
      return this.columns.map(([title]) => {
        const cell = row.insertCell();
        cell.dataset.readout = title;
        return cell;
      });
    });
  }

  /** The time changed, or it began or ceased to play. */
  changed() {
    const {time, playing} = this.player;
    element("time").value = time;
    element("clock").textContent = `${time.toFixed(2)} / ${this.player.end.toFixed(2)} s`;
    element("play").textContent = playing ? "❚❚" : "▶";
    (this.views || []).forEach((view, i) => {
      view.setTime(time);
      if (!view.motion) return;
      this.columns.forEach(([, , text], k) => { this.cells[i][k].textContent = text(view); });
    });
    this.plots.setTime(time);
    this.dirty = true;
  }

  draw() {
    for (const view of this.views) {
      for (const [name, object] of Object.entries(view.layers)) object.visible = this.legend.shows(name);
    }
    this.stage.render();
    this.labels.move(this.stage);
  }

  tick(now) {
    requestAnimationFrame((next) => this.tick(next));
    this.player.advance(Math.min((now - (this.before || now)) / 1000, 0.25));
    this.before = now;
    if (!this.dirty || !this.views) return;
    this.dirty = false;
    this.draw();
  }
}

/** A page that cannot be shown says why. */
function start() {
  const data = JSON.parse(element("data").textContent);
  if (data.format !== "tern-page/1") throw new Error(`unknown format of data: ${data.format}`);
  window.page = new Page();
  if (data.demo) startDemo(window.page, data.demo); else window.page.show(data.runs);
}

try {
  start();
} catch (error) {
  element("fault").hidden = false;
  element("fault").textContent = `This page cannot be shown: ${error.message}`;
  throw error;
}
