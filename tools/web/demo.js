// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** What the reader can set with a slider: key, text, least, most, step, unit. */
const SETTINGS = [
  ["v_max", "speed limit, each axis", 0.5, 8, 0.1, "m/s"],
  ["a_max", "acceleration limit", 1, 15, 0.5, "m/s²"],
  ["radius", "radius of the robot", 0.1, 0.8, 0.05, "m"],
];

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

/** The page with a planner in it: what is dragged or set is planned anew. */
class Demo {
  constructor(page, text, engine) {
    this.page = page;
    this.scenario = new Scenario(text);
    this.engine = engine;
    this.plans = 0;
    this.grabbed = null;
    this.chosen = null;
    this.waiting = false;
    this.buildEditor();
    this.listen();
    this.plan(false);
    page.player.toggle();
  }

  buildEditor() {
    const editor = element("editor");
    editor.hidden = false;
    const hint = document.createElement("p");
    hint.textContent = "Drag the start (green), the goal (orange) or a block; with Shift, up and down.";
    editor.append(hint);
    for (const [key, text, least, most, step, unit] of SETTINGS) {
      editor.append(this.slider(key, text, least, most, step, unit, this.scenario.records[key]));
    }
    const [, , z0, , , z1] = this.scenario.records.boundary;
    for (const key of ["start", "goal"]) {
      editor.append(this.slider(key, `height of the ${key}`, z0, z1, 0.1, "m", this.scenario.records[key], 2));
    }
    const buttons = document.createElement("div");
    buttons.append(
      this.button("add", "Add a block", () => this.addBlock()),
      this.button("remove", "Remove the block", () => this.removeBlock()),
      this.button("forest", "New forest", () => this.scenario.scatter(40)));
    this.result = document.createElement("output");
    this.result.id = "result";
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
    const {left, top, width, height} = element("scene").getBoundingClientRect();
    const pointer = new THREE.Vector2(2 * (event.clientX - left) / width - 1, 1 - 2 * (event.clientY - top) / height);
    const caster = new THREE.Raycaster();
    caster.setFromCamera(pointer, this.page.stage.camera);
    const {stage, views: [{root}]} = this.page;
    // A view that was just made anew has no place before it is drawn.
    this.page.views[0].look(stage.follows, stage.size);
    root.updateMatrixWorld();
    return caster.ray.applyMatrix4(new THREE.Matrix4().getInverse(root.matrixWorld));
  }

  grab(event) {
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
    const {camera} = this.page.stage;
    const forward = camera.getWorldDirection(new THREE.Vector3());
    const normal = event.shiftKey ? new THREE.Vector3(forward.x, forward.y, 0).normalize() : new THREE.Vector3(0, 0, 1);
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(normal, this.grabbed.at);
    const hit = this.ray(event).intersectPlane(plane, new THREE.Vector3());
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
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.plan(true);
    });
  }

  plan(keepsCamera) {
    const began = performance.now();
    const run = JSON.parse(this.engine(this.scenario.text()));
    const milliseconds = performance.now() - began;
    ++this.plans;
    if (run.error) {
      this.result.textContent = run.error;
      return;
    }
    const fact = (name) => (run.facts.find(([label]) => label === name) || ["", "-"])[1];
    this.result.textContent = `${fact("status")}: planned in ${fact("computed in")}` +
      (run.motion ? `, ${fact("duration")} long` : `; ${fact("why")}`) + ` (${milliseconds.toFixed(1)} ms with its data)`;
    this.page.player.time = keepsCamera ? this.page.player.time : 0;
    this.page.show([run], keepsCamera);
  }
}

/** The demo in a page, once its planner is there. */
function startDemo(page, text) {
  const begin = () => { window.demo = new Demo(page, text, Module.cwrap("tern_demo_plan", "string", ["string"])); };
  if (Module.calledRun) begin(); else Module.onRuntimeInitialized = begin;
}
