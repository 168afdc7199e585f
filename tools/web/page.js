// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

const element = (id) => document.getElementById(id);

/** The page: one player, one stage, and readouts and plots that follow them. */
class Page {
  constructor() {
    this.stage = new Stage(element("scene"), element("names"));
    this.player = new Player(() => this.changed());
    this.plots = new Plots(element("plots"), (t) => this.player.set(t));
    this.hidden = new Set(LAYERS.filter(([, , , shown]) => shown === false).map(([name]) => name));
    this.dirty = true;
    this.setTheme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    this.listen();
    requestAnimationFrame((now) => this.tick(now));
  }

  listen() {
    element("play").addEventListener("click", () => this.player.toggle());
    element("time").addEventListener("input", (event) => this.player.set(Number(event.target.value)));
    element("speed").addEventListener("change", (event) => { this.player.speed = Number(event.target.value); });
    element("follow").addEventListener("change", (event) => {
      this.stage.follow(event.target.checked);
      this.dirty = true;
    });
    element("theme").addEventListener("click", () => this.setTheme(this.theme === "dark" ? "light" : "dark"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", (event) =>
      this.setTheme(event.matches ? "dark" : "light"));
    this.stage.controls.addEventListener("change", () => { this.dirty = true; });
    window.addEventListener("resize", () => {
      this.resized();
      if (this.views && !this.stage.follows) this.stage.frame();
    });
    window.addEventListener("keydown", (event) => this.key(event));
  }

  key(event) {
    if (["INPUT", "SELECT", "BUTTON"].includes(event.target.tagName)) return;
    const steps = {ArrowLeft: -0.1, ArrowRight: 0.1};
    if (event.key === " ") this.player.toggle();
    else if (event.key in steps) this.player.set(this.player.time + steps[event.key]);
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
    this.writeNames();
    this.writeLayers();
    this.writeFacts();
    this.buildReadouts();
    this.plots.show(runs, this.player.end, this.palette);
    this.stage.show(this.views, keepsCamera);
    this.resized();
    this.player.set(Math.min(this.player.time, this.player.end));
  }

  setTheme(theme) {
    this.theme = theme;
    this.palette = PALETTES[theme];
    document.documentElement.dataset.theme = theme;
    if (!this.runs) return;
    for (const view of this.views) view.build(this.palette);
    this.writeNames();
    this.writeLayers();
    this.plots.show(this.runs, this.player.end, this.palette);
    this.buildReadouts();
    this.resized();
    this.changed();
  }

  resized() {
    this.stage.resize();
    this.plots.draw();
    this.dirty = true;
  }

  writeNames() {
    element("names").textContent = "";
    if (this.runs.length < 2) return;
    this.runs.forEach((run, i) => {
      const label = document.createElement("span");
      label.textContent = run.name;
      label.style.borderColor = runColour(i, this.palette);
      element("names").append(label);
    });
  }

  writeLayers() {
    const parent = element("layers");
    parent.textContent = "";
    const there = (name) => this.views.some((view) => view.layers[name]);
    for (const [name, text, colour, shown] of LAYERS) {
      if (!there(shown === null ? "plans" : name)) continue;
      const label = document.createElement("label");
      const swatch = document.createElement("i");
      swatch.style.background = `#${new THREE.Color(this.palette[colour]).getHexString()}`;
      if (shown !== null) {
        const box = document.createElement("input");
        box.type = "checkbox";
        box.checked = !this.hidden.has(name);
        box.dataset.layer = name;
        box.addEventListener("change", () => {
          if (box.checked) this.hidden.delete(name); else this.hidden.add(name);
          this.dirty = true;
        });
        label.append(box);
      }
      label.append(swatch, text);
      parent.append(label);
    }
    if (this.fastest > 0) this.writeScale(parent);
  }

  /** The key of the colours of speed. */
  writeScale(parent) {
    const scale = document.createElement("span");
    const swatch = document.createElement("i");
    const colours = this.palette.speeds.map((colour) => `#${new THREE.Color(colour).getHexString()}`);
    swatch.className = "scale";
    swatch.style.background = `linear-gradient(to right, ${colours.join(", ")})`;
    scale.append("0 ", swatch, `${this.fastest.toFixed(1)} m/s`);
    parent.append(scale);
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

  /** The columns of the readouts: a title, and its text for a view. */
  readoutColumns() {
    const length = (kind) => (view) => view.motion.vector(kind, view.time).length().toFixed(2);
    const columns = [
      ["speed", length("v")], ["accel.", length("a")], ["jerk", length("j")],
      ["height", (view) => view.motion.number("pz", view.time).toFixed(2)],
      ["clear", (view) => {
        const clear = view.motion.columns.clearance[0] === null ? null : view.motion.number("clearance", view.time);
        return clear === null ? "-" : clear.toFixed(2);
      }],
    ];
    if (this.runs.some((run) => run.film)) {
      const row = (view) => view.motion.at(view.time)[0];
      columns.push(
        ["work", (view) => (view.film ? String(view.motion.columns.work[row(view)]) : "")],
        ["state", (view) => (view.film ? Object.keys(STATE_COLOURS)[view.motion.columns.state[row(view)]] : "")]);
    }
    return columns;
  }

  buildReadouts() {
    const table = element("readouts");
    table.textContent = "";
    this.columns = this.readoutColumns();
    const head = table.insertRow();
    for (const title of ["", ...this.columns.map(([name]) => name)]) {
      const cell = document.createElement("th");
      cell.textContent = title;
      head.append(cell);
    }
    this.cells = this.runs.map((run, i) => {
      const row = table.insertRow();
      const name = row.insertCell();
      name.textContent = run.name;
      if (this.runs.length > 1) name.style.color = runColour(i, this.palette);
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
    element("clock").textContent = `${time.toFixed(2)} s`;
    element("play").textContent = playing ? "❚❚" : "▶";
    (this.views || []).forEach((view, i) => {
      view.setTime(time);
      if (!view.motion) return;
      this.columns.forEach(([, text], k) => { this.cells[i][k].textContent = text(view); });
    });
    this.plots.setTime(time);
    this.dirty = true;
  }

  draw() {
    for (const view of this.views) {
      for (const [name, object] of Object.entries(view.layers)) object.visible = !this.hidden.has(name);
    }
    this.stage.render();
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
