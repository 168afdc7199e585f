// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** Frees what the graphics processor holds of an object and all below it. */
function dispose(object) {
  object.traverse((part) => {
    if (part.geometry) part.geometry.dispose();
    if (part.material && part.material.uniforms && part.material.uniforms.times) {
      part.material.uniforms.times.value.dispose();
    }
    if (part.material) part.material.dispose();
  });
}

/**
 * The scene of one run. Everything hangs on `root`. A *look* is where and how large the world is: `focus`, the point that
 * is at the scene's origin; `scale`; and `turn`, the angle by which the world is turned upright.
 */
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
    this.turn = 0;
    this.time = 0;
    // Shared by the shaders: metres a pixel at unit depth; the vehicle's place for the camera and its radius; solid.js.
    this.shared = {pixel: {value: 0.001}, vehicle: {value: new THREE.Vector4(0, 0, -1, 0)}, hole: {value: 0},
      walls: [...Array(6)].map(() => new THREE.Plane())};
    this.build(palette);
  }

  dispose() {
    dispose(this.scene);
    this.scene.dispose();
  }

  build(palette) {
    const {run} = this;
    if (this.scene) this.dispose();
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(palette.paper);
    this.root = new THREE.Group();
    this.layers = {};
    // What faces upwards has its own colour: 0.81 + 0.26 * 0.72 = 1.
    const sun = new THREE.DirectionalLight(0xffffff, 0.26);
    sun.position.set(-0.4, -0.57, 0.72);
    const sky = new THREE.HemisphereLight(0xffffff, 0xc8cdd6, 0.81);
    sky.position.set(0, 0, 1);
    this.scene.add(this.root, sun, sky);
    const mark = Math.max(0.6 * run.radius, 0.005 * this.size);
    this.root.add(floorAndFrame(run, palette), endsAndVias(run, palette, mark));
    if (run.blocked) this.addLayer("blocked", blockedMark(run, palette, 0.7 * mark));
    if (run.film) this.addFilm(palette); else this.addLayer("known", knownObstacles(run, palette, this.shared));
    this.things = run.things && run.things.length > 0 ? new Things(run, palette, this.shared.pixel) : null;
    const closed = this.things ? this.things.closed : new THREE.Group();
    if (run.fences.length + run.keepout.length + closed.children.length > 0) {
      this.addLayer("fences", fences(run, palette));
      this.layers.fences.add(closed);
    }
    if (this.things && this.things.group.children.length > closed.children.length) this.addLayer("things", this.things.group);
    if (run.path) this.addLayer("path", this.paths(palette));
    if (run.corridor) {
      this.addLayer("corridor", polyhedraMesh(this.run.corridor, volumeMaterials(palette.corridor, 0.04, 0.28)));
    }
    if (this.motion) this.addFlight(palette);
    this.setTime(this.time);
  }

  addLayer(name, object) {
    this.layers[name] = object;
    this.root.add(object);
  }

  paths(palette) {
    const group = new THREE.Group();
    for (const [name, colour, pixels] of [["search", palette.search, 1.5], ["short", palette.ink, 2]]) {
      group.add(plainTubes([pointsOf(this.run.path[name])], colour, tubeMaterial(0, pixels, this.shared.pixel)));
    }
    return group;
  }

  addFilm(palette) {
    this.film = new Film(this.run, palette, Math.max(0.008 * this.size, 1.2 * this.run.radius), this.shared);
    this.addLayer("ghost", ghostObstacles(this.run, palette));
    for (const [name, group] of Object.entries(this.film.groups)) this.addLayer(name, group);
    this.addLayer("sensor", sensorVolume(this.run.film.sensor, palette, this.shared.walls));
  }

  /** The way flown, its shadow, and the vehicle. */
  addFlight(palette) {
    const {px, py, pz} = this.motion.columns;
    this.stride = Math.max(1, Math.ceil(this.motion.count / 1500));
    const rows = [];
    for (let i = 0; i < this.motion.count; i += this.stride) rows.push(i);
    if (rows[rows.length - 1] !== this.motion.count - 1) rows.push(this.motion.count - 1);
    const speeds = this.motion.lengths("v");
    const points = rows.map((i) => new THREE.Vector3(px[i], py[i], pz[i]));
    const shape = tubeGeometry([points], (_, i) => speedColour(speeds[rows[i]] / this.fastest, palette));
    this.flown = tubeMesh(shape, tubeMaterial(0.08 * this.run.radius, 3, this.shared.pixel));
    const flown = new THREE.Group();
    flown.add(this.flown);
    if (this.run.kind === "plan") {  // the rest of a plan, through whatever hides it
      flown.add(tubeMesh(shape.clone(), tubeMaterial(0, 2, this.shared.pixel,
        {opacity: 0.55, depthTest: false, depthWrite: false})));
    }
    const floor = this.run.boundary[2] + 0.03;
    this.shadow = new THREE.Line(
      new THREE.BufferGeometry().setFromPoints(points.map((p) => new THREE.Vector3(p.x, p.y, floor))),
      lineMaterial(palette.ink, 0.35));
    this.shadow.frustumCulled = false;
    this.shadow.renderOrder = ON_FLOOR.shadow;
    this.drop = new THREE.Line(new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(), new THREE.Vector3(0, 0, -1)]),
      lineMaterial(palette.ink, 0.5));
    this.drop.frustumCulled = false;
    flown.add(this.shadow);
    this.addLayer("flown", flown);
    this.vehicle = quadrotor(this.run.radius, palette);
    this.ball = ball([0, 0, 0], this.run.radius, palette.known, 0.16);
    this.root.add(this.vehicle, this.ball, this.drop);
  }

  setTime(t) {
    this.time = Math.min(t, this.end);
    if (this.things) this.things.setTime(this.time);
    if (this.layers.fences) showFences(this.layers.fences, this.time);
    if (!this.motion) return;
    this.motion.vector("p", this.time, this.vehicle.position);
    this.motion.quaternion(this.time, this.vehicle.quaternion);
    this.ball.position.copy(this.vehicle.position);
    this.drop.position.copy(this.vehicle.position);
    this.drop.scale.set(1, 1, Math.max(this.vehicle.position.z - this.run.boundary[2], 1e-3));
    const pieces = Math.ceil(this.motion.at(this.time)[0] / this.stride);
    this.flown.geometry.setDrawRange(0, 6 * TUBE_SIDES * pieces);
    this.shadow.geometry.setDrawRange(0, pieces + 1);
    if (!this.film) return;
    this.film.setTime(this.time);
    const cone = this.layers.sensor;
    cone.position.copy(this.vehicle.position);
    cone.rotation.z = this.motion.number("yaw", this.time);
  }

  /**
   * Places the world for a camera that draws it `height` pixels high. The vehicle is drawn `least` pixels wide at least.
   * `hole`: in radii of the vehicle, how far around it nothing solid hides it.
   */
  place({focus, scale}, camera, height, least, hole) {
    const {root, shared} = this;
    root.rotation.z = this.turn;
    root.scale.setScalar(scale);
    root.position.copy(focus).applyAxisAngle(camera.up, this.turn).multiplyScalar(-scale);
    root.updateMatrixWorld();
    const unit = (2 * Math.tan((camera.fov * Math.PI) / 360)) / height;  // of the scene, a pixel at unit depth
    shared.pixel.value = unit / scale;
    const [x0, y0, z0, x1, y1, z1] = this.run.boundary;
    [[1, 0, 0, -x0], [-1, 0, 0, x1], [0, 1, 0, -y0], [0, -1, 0, y1], [0, 0, 1, -z0], [0, 0, -1, z1]].forEach(
      ([x, y, z, offset], i) => shared.walls[i].setComponents(x, y, z, offset).applyMatrix4(root.matrixWorld));
    if (!this.vehicle) return;
    camera.updateMatrixWorld();
    const seen = root.localToWorld(this.vehicle.position.clone())
      .applyMatrix4(new THREE.Matrix4().getInverse(camera.matrixWorld));
    const radius = this.run.radius * scale;
    shared.vehicle.value.set(seen.x, seen.y, seen.z, radius);
    shared.hole.value = hole;
    const larger = Math.max(1, (0.5 * least * unit * -seen.z) / radius);
    this.vehicle.scale.setScalar(larger);
    this.ball.visible = larger === 1;
  }
}
