// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

const DISTANCE = 10;        // of the camera from what it looks at, in units of the scene
const FOLLOW_SIZE = 0.32;   // the vehicle's radius there, where the camera follows it
const STRIP = 30;           // pixels above each world, for its name
const VEHICLE_PIXELS = [12, 26];  // width of the vehicle at least, where all of the world is seen: in small and large cells
const HOLE = {follow: 4, closeup: 100};  // in radii of the vehicle: nothing solid hides what is that near to it
// Close-ups: their share of a cell, below or beside the world, and their least size in pixels. A close-up is worth a
// world that is smaller by its share.
const INSETS = [{}, {below: 0.3}, {below: 0.42}, {beside: 0.3}, {beside: 0.4}];
const LEAST_CLOSEUP = {width: 200, height: 120, aspects: [0.8, 5]};  // width over height

/** Draws on a canvas; null if the browser has no WebGL. */
function rendererOn(canvas) {
  const probe = document.createElement("canvas");
  const context = probe.getContext("webgl2") || probe.getContext("webgl");
  if (context === null) return null;
  // Browsers have few contexts.
  const loses = context.getExtension("WEBGL_lose_context");
  if (loses) loses.loseContext();
  try {
    return new THREE.WebGLRenderer({canvas, antialias: true});
  } catch (error) {
    return null;
  }
}

/** All runs on one canvas, a cell each, under one camera. A cell has the world and, where there is room, a close-up. */
class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = rendererOn(canvas);
    if (this.renderer !== null) this.renderer.localClippingEnabled = true;
    this.camera = new THREE.PerspectiveCamera(32, 1, 0.05, 1000);
    this.camera.up.set(0, 0, 1);
    this.closeup = new THREE.PerspectiveCamera(46, 1, 0.05, 5000);
    this.closeup.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.maxPolarAngle = 0.498 * Math.PI;
    this.views = [];
    this.width = this.height = 0;  // of the canvas, in CSS pixels
    this.columns = 1;
    this.follows = false;
    this.hasCloseups = true;  // if there is room
    this.inset = {};  // one of INSETS
  }

  /** Shows views; those that replace others of the same worlds may keep the camera. */
  show(views, keepsCamera) {
    const before = this.views;
    this.views = views;
    if (!keepsCamera) return this.frame();
    views.forEach((view, i) => Object.assign(view, {turn: before[i].turn, fit: before[i].fit}));
  }

  /** Turns worlds and camera so that the ways are seen and the worlds are large, in the best arrangement. */
  frame() {
    let best = {worth: -1};
    for (let columns = 1; columns <= this.views.length; ++columns) {
      for (const inset of INSETS) {
        Object.assign(this, {columns, inset});
        if (!this.hasRoom()) continue;
        const {width, height} = this.main(0);
        for (const elevation of ELEVATIONS) {
          const found = this.views.map((view) => bestTurn(view, elevation, width, height));
          const worth = found.reduce((sum, one) => sum + one.worth, 0) * (1 + (inset.below || inset.beside || 0));
          if (worth > best.worth) best = {worth, columns, inset, elevation, turns: found.map((one) => one.turn)};
        }
      }
    }
    Object.assign(this, {columns: best.columns, inset: best.inset});
    this.views.forEach((view, i) => { view.turn = best.turns[i]; });
    this.camera.position.copy(towardsCamera(best.elevation));
    this.layOut();
  }

  /** For the close-ups that this arrangement has. */
  hasRoom() {
    const closeup = this.closeupOf(0);
    return closeup === null || (this.hasCloseups && !this.follows && this.views.every((view) => view.vehicle) &&
      closeup.width >= LEAST_CLOSEUP.width && closeup.height >= LEAST_CLOSEUP.height &&
      closeup.width >= LEAST_CLOSEUP.aspects[0] * closeup.height &&
      closeup.width <= LEAST_CLOSEUP.aspects[1] * closeup.height);
  }

  /** Fits the worlds into their cells as they are turned. */
  layOut() {
    if (this.views.length === 0 || this.width === 0 || this.height === 0) return;
    this.controls.target.set(0, 0, 0);
    this.camera.position.setLength(DISTANCE);
    this.controls.update();
    if (!this.hasRoom()) this.inset = INSETS[0];
    const {width, height} = this.main(0);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    for (const view of this.views) view.fit = fitted(view, this.camera, 0.97);
  }

  /** Where view i is on the canvas, whole CSS pixels from the top left: with its name, its world and its close-up. */
  cell(i) {
    const {width, height} = this;
    const columns = Math.min(this.columns, Math.max(this.views.length, 1));
    const rows = Math.ceil(this.views.length / columns) || 1;
    const [w, h] = [Math.floor(width / columns), Math.floor(height / rows)];
    return {left: (i % columns) * w, top: Math.floor(i / columns) * h, width: w, height: h};
  }

  /** The world of view i. */
  main(i) {
    const {left, top, width, height} = this.cell(i);
    const {beside = 0, below = 0} = this.inset;
    return {left, top: top + STRIP, width: width - Math.floor(beside * width),
      height: Math.max(height - STRIP - Math.floor(below * height), 1)};
  }

  /** The close-up of view i, or null. */
  closeupOf(i) {
    const {left, top, width, height} = this.cell(i);
    const main = this.main(i);
    if (this.inset.below) {
      const from = main.top + main.height;
      return {left: left + 8, top: from, width: width - 16, height: top + height - from - 8};
    }
    if (!this.inset.beside) return null;
    return {left: left + main.width, top: main.top, width: width - main.width - 8, height: main.height - 8};
  }

  /** The camera stays with the vehicle, or shows all of the worlds. */
  follow(follows) {
    this.follows = follows;
    this.frame();
  }

  resize() {
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    if (this.renderer === null) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(this.width, this.height, false);
  }

  leastVehicle() {
    return Math.min(Math.max(0.05 * this.main(0).width, VEHICLE_PIXELS[0]), VEHICLE_PIXELS[1]);
  }

  /** Places view i for the main camera. */
  place(i) {
    const view = this.views[i];
    const follows = this.follows && view.vehicle;
    const look = follows ? {focus: view.vehicle.position, scale: FOLLOW_SIZE / view.run.radius} : view.fit;
    view.place(look, this.camera, this.main(i).height, follows ? 0 : this.leastVehicle(), follows ? HOLE.follow : 0);
  }

  /** Behind, above and a little to the right of the vehicle, so that the way that it came does not hide it. */
  placeCloseup(view, {width, height}) {
    const angle = view.motion.heading(view.time) + view.turn;
    const turned = (x, y, z) => new THREE.Vector3(x, y, z).applyAxisAngle(this.closeup.up, angle);
    this.closeup.position.copy(turned(-8, -3.5, 5));
    this.closeup.lookAt(turned(3, 0.8, 0));
    this.closeup.aspect = width / height;
    this.closeup.fov = 46 * Math.max(1, Math.min(1.3 / this.closeup.aspect, 1.6));
    this.closeup.updateProjectionMatrix();
    view.place({focus: view.vehicle.position, scale: 1 / view.run.radius}, this.closeup, height, 0, HOLE.closeup);
  }

  /** Where a point of view i's world is, in CSS pixels from the canvas' top left. */
  project(i, point) {
    const {left, top, width, height} = this.main(i);
    this.place(i);
    this.camera.updateMatrixWorld();
    this.camera.matrixWorldInverse.getInverse(this.camera.matrixWorld);
    const p = this.views[i].root.localToWorld(point.clone()).project(this.camera);
    return {x: left + ((1 + p.x) / 2) * width, y: top + ((1 - p.y) / 2) * height};
  }

  /** The ray below a point of the canvas, in the frame of view i's world. */
  rayAt(i, x, y) {
    const {left, top, width, height} = this.main(i);
    const caster = new THREE.Raycaster();
    this.place(i);
    this.camera.updateMatrixWorld();
    caster.setFromCamera(new THREE.Vector2((2 * (x - left)) / width - 1, 1 - (2 * (y - top)) / height), this.camera);
    return caster.ray.applyMatrix4(new THREE.Matrix4().getInverse(this.views[i].root.matrixWorld));
  }

  draw(view, camera, {left, top, width, height}) {
    const bottom = this.height - top - height;
    this.renderer.setViewport(left, bottom, width, height);
    this.renderer.setScissor(left, bottom, width, height);
    this.renderer.render(view.scene, camera);
  }

  render() {
    if (this.renderer === null) return;
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(this.views[0].scene.background);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    this.views.forEach((view, i) => {
      this.place(i);
      this.draw(view, this.camera, this.main(i));
      const closeup = this.closeupOf(i);
      if (closeup === null || !view.vehicle) return;
      this.placeCloseup(view, closeup);
      this.draw(view, this.closeup, closeup);
    });
  }
}
