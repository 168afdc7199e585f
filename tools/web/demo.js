// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** What the reader can set with a slider: key, text, least, most, step, unit. */
const SETTINGS = [
  ["v_max", "speed limit", 0.5, 8, 0.1, "m/s"],
  ["a_max", "acceleration limit", 1, 15, 0.5, "m/s²"],
  ["radius", "radius", 0.1, 0.8, 0.05, "m"],
];

// The planner's thread: a scenario's text in, a run of the page and the milliseconds that it took out.
const WORKER = `
  const ready = new Promise((done) => { if (Module.calledRun) done(); else Module.onRuntimeInitialized = done; });
  onmessage = async ({data}) => {
    await ready;
    const began = performance.now();
    const answer = Module.cwrap("tern_demo_plan", "string", ["string"])(data);
    postMessage({answer, milliseconds: performance.now() - began});
  };`;

/** The page with a planner in it: what is dragged or set is planned anew, in a thread of its own. */
class Demo {
  constructor(page, text) {
    this.page = page;
    this.scenario = new Scenario(text);
    this.run = null;      // shown last
    this.plans = 0;
    this.grabbed = null;
    this.chosen = null;
    this.waits = false;   // for the next frame
    this.busy = false;    // planning
    this.stale = false;   // something changed since that plan began
    this.engine = new Worker(URL.createObjectURL(
      new Blob([element("engine").textContent, WORKER], {type: "text/javascript"})));
    this.engine.onmessage = ({data}) => this.planned(data);
    this.buildEditor();
    this.listen();
    this.plan();
  }

  buildEditor() {
    const editor = element("editor");
    editor.hidden = false;
    const hint = document.createElement("p");
    hint.textContent = matchMedia("(pointer: coarse)").matches
      ? "Drag the start, the goal, a block or where something that moves begins. Sliders set the heights."
      : "Drag the start, the goal, a block or where something that moves begins; with Shift, up and down.";
    editor.append(hint);
    for (const [key, text, least, most, step, unit] of SETTINGS) {
      editor.append(this.slider(key, text, least, most, step, unit, this.scenario.records[key]));
    }
    const [, , z0, , , z1] = this.scenario.records.boundary;
    for (const key of ["start", "goal"]) {
      editor.append(this.slider(key, `${key} height`, z0, z1, 0.1, "m", this.scenario.records[key], 2));
    }
    const buttons = document.createElement("div");
    buttons.append(
      this.button("add", "Add a block", () => this.addBlock()),
      this.button("remove", "Remove the block", () => this.removeBlock()),
      this.button("forest", "New forest", () => this.scenario.scatter(40)));
    this.result = document.createElement("output");
    Object.assign(this.result, {id: "result", textContent: "planning"});
    editor.append(buttons, this.result);
  }

  /** A slider for one of a record's numbers. */
  slider(key, text, least, most, step, unit, numbers, index = 0) {
    const label = document.createElement("label");
    const input = document.createElement("input");
    const value = document.createElement("b");
    Object.assign(input, {type: "range", min: least, max: most, step, value: numbers[index]});
    input.dataset.setting = key;
    const show = () => { value.textContent = `${Number(input.value).toFixed(2)} ${unit}`; };
    input.addEventListener("input", () => {
      numbers[index] = Number(input.value);
      show();
      this.planSoon();
    });
    this.refreshers = [...(this.refreshers || []), () => { input.value = numbers[index]; show(); }];
    show();
    label.append(text, input, value);
    return label;
  }

  button(id, text, action) {
    const button = document.createElement("button");
    Object.assign(button, {id, type: "button", textContent: text});
    button.addEventListener("click", () => { action(); this.planSoon(); });
    return button;
  }

  addBlock() {
    const [x0, y0, z0, x1, y1, z1] = this.scenario.records.boundary;
    const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
    this.chosen = [x - 0.4, y - 0.4, z0, x + 0.4, y + 0.4, z1];
    this.scenario.blocks.push(this.chosen);
  }

  /** The block that was dragged last, or the last one. */
  removeBlock() {
    const {blocks} = this.scenario;
    const index = blocks.indexOf(this.chosen);
    blocks.splice(index < 0 ? blocks.length - 1 : index, 1);
  }

  listen() {
    const canvas = element("scene");
    // Before the camera's controls hear of it.
    canvas.addEventListener("pointerdown", (event) => this.grab(event), true);
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => this.release());
  }

  /** The ray under the pointer, in the world's frame. */
  ray(event) {
    const {left, top} = element("scene").getBoundingClientRect();
    return this.page.stage.rayAt(0, event.clientX - left, event.clientY - top);
  }

  grab(event) {
    if (this.run === null) return;
    const ray = this.ray(event);
    let nearest = Infinity;
    for (const handle of this.scenario.handles()) {
      const [a, b, c, d, e, f] = handle.box;
      const box = new THREE.Box3(new THREE.Vector3(a, b, c), new THREE.Vector3(d, e, f));
      const hit = ray.intersectBox(box, new THREE.Vector3());
      if (hit === null || hit.distanceTo(ray.origin) >= nearest) continue;
      nearest = hit.distanceTo(ray.origin);
      this.grabbed = {...handle, at: hit};
    }
    if (this.grabbed === null) return;
    this.chosen = this.grabbed.block || this.chosen;
    this.page.stage.controls.enabled = false;
    element("scene").setPointerCapture(event.pointerId);
  }

  /** Over the plane of the hit: level, or upright with Shift. */
  drag(event) {
    if (this.grabbed === null) return;
    const ray = this.ray(event);
    const upright = new THREE.Vector3(ray.direction.x, ray.direction.y, 0).normalize();
    const normal = event.shiftKey ? upright : new THREE.Vector3(0, 0, 1);
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(normal, this.grabbed.at);
    const hit = ray.intersectPlane(plane, new THREE.Vector3());
    if (hit === null) return;
    const by = hit.clone().sub(this.grabbed.at);
    this.grabbed.move(event.shiftKey ? [0, 0, by.z] : [by.x, by.y, 0]);
    this.grabbed.at = hit;
    for (const refresh of this.refreshers) refresh();
    this.planSoon();
  }

  release() {
    this.grabbed = null;
    this.page.stage.controls.enabled = true;
  }

  /** Once for all that happens before the next frame. */
  planSoon() {
    if (this.waits) return;
    this.waits = true;
    requestAnimationFrame(() => {
      this.waits = false;
      this.plan();
    });
  }

  /** One plan at a time. Until the next one, the last one is shown among what was moved. */
  plan() {
    this.stale = this.busy;
    if (this.busy) return this.page.show([{...this.run, ...this.scenario.places()}], true);
    this.busy = true;
    this.engine.postMessage(this.scenario.text());
  }

  planned({answer, milliseconds}) {
    const run = JSON.parse(answer);
    ++this.plans;
    this.busy = false;
    if (run.error) {
      this.result.textContent = run.error;
    } else {
      const isFirst = this.run === null;
      this.run = run;
      this.tell(run, milliseconds);
      this.page.show([run], !isFirst);
      if (isFirst) this.page.player.toggle();
    }
    if (this.stale) this.plan();
  }

  tell(run, milliseconds) {
    const fact = (name) => (run.facts.find(([label]) => label === name) || ["", "-"])[1];
    this.result.textContent = `${fact("status")}: planned in ${fact("computed in")}` +
      (run.motion ? `, ${fact("duration")} long` : `; ${fact("why")}`) + ` (${milliseconds.toFixed(1)} ms with its data)`;
  }
}

function startDemo(page, text) {
  window.demo = new Demo(page, text);
}
