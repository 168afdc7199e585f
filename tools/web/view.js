// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** Parts of the scene: name, text and colour of its key, and whether it is shown at first. Null: it cannot be hidden. */
const LAYERS = [
  ["world", "obstacles", "solid", true],
  ["known", "known", "known", true],
  ["plans", "committed plan", "commit", true],
  ["brake", "its brake", "brake", null],
  ["lost", "dropped plan", "dropped", null],
  ["corridor", "corridor", "corridor", true],
  ["path", "path", "short", false],
  ["sensor", "sensor", "sensor", true],
];

/** A round picture for points. */
function disc() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 32;
  const context = canvas.getContext("2d");
  context.fillStyle = "#ffffff";
  context.arc(16, 16, 15, 0, 2 * Math.PI);
  context.fill();
  return new THREE.CanvasTexture(canvas);
}

/** The highest speed of several runs, where there is one. */
function fastestOf(runs) {
  const motions = runs.filter((run) => run.motion).map((run) => new Motion(run.motion));
  return motions.reduce((most, motion) => motion.lengths("v").reduce((a, b) => Math.max(a, b), most), 0);
}

/** The scene of one run. Everything hangs on `root`, which moves so that what is looked at stays at the origin. */
class RunView {
  /** `fastest`: the speed at the end of the scale of colours, which all runs share. */
  constructor(run, palette, fastest) {
    this.run = run;
    this.fastest = Math.max(fastest, 1e-9);
    this.motion = run.motion ? new Motion(run.motion) : null;
    this.end = this.motion ? this.motion.end : 0;
    const [x0, y0, z0, x1, y1, z1] = run.boundary;
    this.middle = new THREE.Vector3((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2);
    this.extent = new THREE.Vector3(x1 - x0, y1 - y0, z1 - z0);
    this.size = this.extent.length();
    this.focus = this.middle.clone();
    this.time = 0;
    this.build(palette);
  }

  /** Frees what the graphics processor holds. */
  dispose() {
    this.scene.traverse((object) => {
      if (object.geometry) object.geometry.dispose();
      if (object.material) object.material.dispose();
    });
    this.scene.dispose();
  }

  build(palette) {
    const {run} = this;
    if (this.scene) this.dispose();
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(palette.paper);
    this.root = new THREE.Group();
    this.layers = {};
    const sun = new THREE.DirectionalLight(0xffffff, 0.65);
    sun.position.set(-0.4, -0.7, 1);
    this.scene.add(this.root, sun, new THREE.HemisphereLight(0xffffff, 0x8a90a0, 0.65));
    this.root.add(floorAndFrame(run.boundary, palette), fences(run, palette), endsAndVias(run, palette));
    this.addLayer("world", obstacles(run, palette));
    if (run.path) this.addLayer("path", this.paths(palette));
    if (run.corridor) this.addLayer("corridor", this.corridor(palette));
    if (run.film) this.addFilm(palette);
    if (this.motion) this.addFlight(palette);
    this.setTime(this.time);
  }

  addLayer(name, object) {
    this.layers[name] = object;
    this.root.add(object);
  }

  paths(palette) {
    const group = new THREE.Group();
    group.add(line(pointsOf(this.run.path.search), palette.search), line(pointsOf(this.run.path.short), palette.short));
    return group;
  }

  corridor(palette) {
    const group = new THREE.Group();
    for (const halfspaces of this.run.corridor) group.add(polyhedronMesh(halfspaces, palette.corridor, 0.05));
    return group;
  }

  addFilm(palette) {
    this.film = new Film(this.run.film, palette, Math.max(0.25 * this.run.radius, 0.0013 * this.size),
      this.run.boundary[2]);
    this.addLayer("known", this.film.known);
    this.addLayer("plans", this.film.plans);
    this.addLayer("corridor", this.film.corridor);
    this.addLayer("sensor", sensorCone(this.run.film.sensor, palette));
  }

  /** The way flown, bright up to now, its shadow and the vehicle. */
  addFlight(palette) {
    const {px, py, pz} = this.motion.columns;
    this.stride = Math.max(1, Math.ceil(this.motion.count / 1500));
    const rows = [];
    for (let i = 0; i < this.motion.count; i += this.stride) rows.push(i);
    if (rows[rows.length - 1] !== this.motion.count - 1) rows.push(this.motion.count - 1);
    const speeds = this.motion.lengths("v");
    const points = rows.map((i) => new THREE.Vector3(px[i], py[i], pz[i]));
    const shape = tube(points, Math.max(0.16 * this.run.radius, 0.0009 * this.size), rows.map((i) => speedColour(speeds[i] / this.fastest, palette)));
    this.flown = new THREE.Mesh(shape, new THREE.MeshBasicMaterial({vertexColors: THREE.VertexColors}));
    this.flown.frustumCulled = false;
    this.root.add(this.flown);
    if (this.run.kind === "plan") {
      this.root.add(new THREE.Mesh(shape.clone(), new THREE.MeshBasicMaterial({
        vertexColors: THREE.VertexColors, transparent: true, opacity: 0.4, depthTest: false, depthWrite: false})));
    }
    const floor = this.run.boundary[2] + 0.02;
    this.shadow = line(points.map((p) => new THREE.Vector3(p.x, p.y, floor)), palette.body, 0.3);
    this.shadow.frustumCulled = false;
    this.root.add(this.shadow);
    this.vehicle = quadrotor(this.run.radius, palette);
    this.ball = marker([0, 0, 0], this.run.radius, palette.rotor, 0.15);
    this.dot = new THREE.Points(new THREE.BufferGeometry().setFromPoints([new THREE.Vector3()]),
      new THREE.PointsMaterial({color: palette.rotor, size: 9, sizeAttenuation: false, depthTest: false,
        transparent: true, alphaTest: 0.5, map: disc()}));
    this.root.add(this.vehicle, this.ball, this.dot);
  }

  setTime(t) {
    this.time = Math.min(t, this.end);
    if (!this.motion) return;
    this.motion.vector("p", this.time, this.vehicle.position);
    this.motion.quaternion(this.time, this.vehicle.quaternion);
    this.ball.position.copy(this.vehicle.position);
    this.dot.position.copy(this.vehicle.position);
    const pieces = Math.ceil(this.motion.at(this.time)[0] / this.stride);
    this.flown.geometry.setDrawRange(0, 6 * TUBE_SIDES * pieces);
    this.shadow.geometry.setDrawRange(0, pieces + 1);
    if (!this.film) return;
    this.film.setTime(this.time);
    const cone = this.layers.sensor;
    cone.position.copy(this.vehicle.position);
    cone.rotation.z = this.motion.number("yaw", this.time);
  }

  /** What is looked at: the vehicle, or the world's middle, where `size` is how large the world appears. */
  look(follows, size) {
    const scale = follows ? 1 : size / this.size;
    this.focus.copy(follows && this.vehicle ? this.vehicle.position : this.middle);
    this.root.scale.setScalar(scale);
    this.root.position.copy(this.focus).multiplyScalar(-scale);
    if (this.dot) this.dot.visible = !follows;
  }
}

/** All runs on one canvas, a rectangle each, under one camera. */
class Stage {
  constructor(canvas, names) {
    this.canvas = canvas;
    this.names = names;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true});
    this.camera = new THREE.PerspectiveCamera(45, 1, 0.05, 5000);
    this.camera.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.views = [];
    this.columns = 1;
    this.follows = false;
  }

  show(views, keepsCamera) {
    this.views = views;
    const size = this.size = views.reduce((most, view) => Math.max(most, view.size), 1);
    if (keepsCamera) return;
    const {x, y} = views[0].extent;
    const across = x >= y ? [-0.1, -0.7] : [0.7, -0.1];  // the longer side runs across the screen
    this.camera.position.set(across[0] * size, across[1] * size, 0.5 * size);
    this.camera.near = size / 2000;
    this.camera.far = 20 * size;
    this.frame();
  }

  /** The camera far enough away for all of the worlds, seen from where it is; and as many columns as show them largest. */
  frame() {
    const direction = this.camera.position.clone().normalize();
    let best = {size: 0};
    for (let columns = 1; columns <= this.views.length; ++columns) {
      this.columns = columns;
      const {height} = this.place();
      const distance = this.views.reduce((most, view) => Math.max(most, this.distanceFor(view, direction)), 1);
      if (height / distance > best.size) best = {size: height / distance, columns, distance};
    }
    this.columns = best.columns;
    this.place();
    this.camera.position.copy(direction.multiplyScalar(best.distance));
    this.controls.update();
  }

  /** The camera and the names follow the rectangles. */
  place() {
    const first = this.rectangle(0);
    this.camera.aspect = first.width / first.height;
    this.camera.updateProjectionMatrix();
    [...this.names.children].forEach((label, i) => {
      const {left, top} = this.rectangle(i);
      label.style.left = `${left + 10}px`;
      label.style.top = `${top + 10}px`;
    });
    return first;
  }

  /** At which all corners of a view's world are on the screen. */
  distanceFor(view, direction) {
    const forward = direction.clone().negate();
    const right = new THREE.Vector3().crossVectors(forward, this.camera.up).normalize();
    const up = new THREE.Vector3().crossVectors(right, forward);
    const slope = Math.tan((this.camera.fov * Math.PI) / 360) * 0.94;
    const [x0, y0, z0, x1, y1, z1] = view.run.boundary;
    let most = 0;
    for (let i = 0; i < 8; ++i) {
      const corner = new THREE.Vector3(i & 1 ? x1 : x0, i & 2 ? y1 : y0, i & 4 ? z1 : z0).sub(view.middle)
        .multiplyScalar(this.size / view.size);
      const across = Math.max(Math.abs(corner.dot(right)) / (slope * this.camera.aspect),
        Math.abs(corner.dot(up)) / slope);
      most = Math.max(most, across - corner.dot(forward));
    }
    return most;
  }

  /** Where view i is on the canvas, whole CSS pixels from the top left. */
  rectangle(i) {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    const columns = Math.min(this.columns, Math.max(this.views.length, 1));
    const rows = Math.ceil(this.views.length / columns) || 1;
    const [w, h] = [Math.floor(width / columns), Math.floor(height / rows)];
    return {left: (i % columns) * w, top: Math.floor(i / columns) * h, width: w, height: h};
  }

  /** The camera near to the vehicle, or back to where all of the worlds are seen. */
  follow(follows) {
    this.follows = follows;
    if (!follows) return this.frame();
    this.camera.position.setLength(Math.min(this.camera.position.length(), 16 * this.views[0].run.radius));
    this.controls.update();
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.place();
  }

  render() {
    const height = this.canvas.clientHeight;
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(this.views[0].scene.background);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    this.views.forEach((view, i) => {
      const r = this.rectangle(i);
      view.look(this.follows, this.size);
      this.renderer.setViewport(r.left, height - r.top - r.height, r.width, r.height);
      this.renderer.setScissor(r.left, height - r.top - r.height, r.width, r.height);
      this.renderer.render(view.scene, this.camera);
    });
  }
}
