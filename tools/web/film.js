// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** Seconds for which a dropped plan is shown. */
const DROPPED_FOR = 1;

// What was seen just now is brighter. The edge of what is known is a line of 2 pixels, or of a cell if that is less.
const SEEN_FRAGMENT = `
  uniform float now;
  uniform sampler2D times;
  uniform vec2 cells;
  uniform vec3 seen, fresh, frontier;
  varying vec2 place;
  float edge(vec2 by, float pixels) {
    return step(now, texture2D(times, place + by / cells).r) * step(pixels, 2.0);
  }
  void main() {
    float time = texture2D(times, place).r;
    if (time > now) discard;
    vec2 width = fwidth(place * cells);
    vec2 low = fract(place * cells) / width;
    vec2 high = (1.0 - fract(place * cells)) / width;
    float line = max(max(edge(vec2(1, 0), high.x), edge(vec2(-1, 0), low.x)),
      max(edge(vec2(0, 1), high.y), edge(vec2(0, -1), low.y)));
    vec3 colour = mix(fresh, seen, smoothstep(0.2, 2.5, now - time));
    gl_FragColor = vec4(mix(colour, frontier, line), 1.0);
  }`;

/** What a flight knew and meant to do at each time: obstacles seen, space seen, committed and dropped plans. */
class Film {
  /** `run`: a flight; `dash`: length of a dash in metres; `shared`: uniforms of the view. */
  constructor(run, palette, dash, shared) {
    this.film = run.film;
    this.palette = palette;
    this.dash = dash;
    // Shared by all plans: a material that goes takes its shader with it, and compiling takes long.
    this.thick = tubeMaterial(0.1 * run.radius, 4, shared.pixel);
    this.thin = tubeMaterial(0, 1.5, shared.pixel);
    this.volume = volumeMaterials(palette.corridor, 0.05, 0.45, shared.walls);
    this.now = {value: 0};
    this.begins = [];
    this.shown = "";
    const {known, seen} = run.film;
    this.groups = {seen: this.seenMesh(seen, run.boundary[2])};
    for (const name of ["known", "corridor", "plan", "brake", "dropped"]) this.groups[name] = new THREE.Group();
    if (known.blocks.length > 0) this.groups.known.add(this.knownMesh(known, run.boundary, shared));
  }

  /** Blocks of voxels, each for as long as the map holds it for solid, in the order of their beginning. */
  knownMesh({cell, origin, blocks}, boundary, shared) {
    const corners = [];
    const lives = [];
    for (let i = 0; i < blocks.length; i += 7) {
      const [x, y, z, width, height, from, until] = blocks.slice(i, i + 7);
      corners.push(origin[0] + cell * x, origin[1] + cell * y, origin[2] + cell * z,
        origin[0] + cell * (x + 1), origin[1] + cell * (y + width), origin[2] + cell * (z + height));
      lives.push(from, until < 0 ? 1e9 : until);
      this.begins.push({t: from});
    }
    this.blocks = boxesMesh(corners, solidMaterial(this.palette.known, boundary, shared, this.now));
    this.blocks.geometry.setAttribute("life", new THREE.InstancedBufferAttribute(new Float32Array(lives), 2));
    return this.blocks;
  }

  /** The floor below what was seen free. A texel holds the time of the first look; a shader compares it with now. */
  seenMesh({cell, origin, size, times}, floor) {
    const [nx, ny] = size;
    const data = new Float32Array(4 * nx * ny);
    times.forEach((time, i) => { data[4 * i] = time < 0 ? 1e9 : time / 10; });
    const texture = new THREE.DataTexture(data, nx, ny, THREE.RGBAFormat, THREE.FloatType);
    texture.needsUpdate = true;
    const colours = {};
    for (const name of ["seen", "fresh", "frontier"]) colours[name] = {value: new THREE.Color(this.palette[name])};
    const mesh = new THREE.Mesh(new THREE.PlaneBufferGeometry(nx * cell, ny * cell), new THREE.ShaderMaterial({
      uniforms: {now: this.now, times: {value: texture}, cells: {value: new THREE.Vector2(nx, ny)}, ...colours},
      vertexShader: "varying vec2 place; void main() { place = uv; " +
        "gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
      fragmentShader: SEEN_FRAGMENT, extensions: {derivatives: true}, transparent: true, depthWrite: false,
    }));
    mesh.position.set(origin[0] + (nx * cell) / 2, origin[1] + (ny * cell) / 2, floor + 0.01);
    mesh.renderOrder = ON_FLOOR.seen;
    return mesh;
  }

  /** Number of the last entry of a list that has begun. */
  static last(list, t) {
    let [low, high] = [0, list.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (list[middle].t <= t) low = middle + 1; else high = middle;
    }
    return low - 1;
  }

  /** What a group has from now on. */
  replace(name, ...objects) {
    const group = this.groups[name];
    group.traverse((old) => { if (old.geometry) old.geometry.dispose(); });
    group.remove(...group.children);
    if (objects.length > 0) group.add(...objects);
  }

  /** What is flown up to the branch, its brake, and the thin line of how the planner's plan would go on. */
  showCommit(commit) {
    const finer = 4;  // points of a smooth curve for each of the commit's
    const corners = pointsOf(commit.points);
    const points = corners.length > 1 ? new THREE.CatmullRomCurve3(corners).getPoints(finer * (corners.length - 1)) : [];
    const branch = Math.max(Math.ceil(((commit.branch - commit.t) * finer) / commit.step), 0);
    this.replace("plan", plainTubes([points.slice(0, branch + 1)], this.palette.commit, this.thick),
      plainTubes([pointsOf(commit.wished)], this.palette.commit, this.thin));
    this.replace("brake", plainTubes([points.slice(branch)], this.palette.brake, this.thick));
  }

  /** The corridor of the last new plan: where a plan goes on, its corridor stays. */
  showCorridor(number) {
    const {commits} = this.film;
    let i = number;
    while (i >= 0 && !commits[i].corridor) --i;
    this.replace("corridor", polyhedraMesh(i < 0 ? [] : commits[i].corridor, this.volume));
  }

  showDropped(drop) {
    this.replace("dropped", plainTubes(dashes(pointsOf(drop.points), this.dash), this.palette.dropped, this.thick));
  }

  setTime(t) {
    this.now.value = t;
    if (this.blocks) this.blocks.count = Film.last(this.begins, t) + 1;
    const {commits, dropped} = this.film;
    const commit = Film.last(commits, t);
    const drop = Film.last(dropped, t);
    const fresh = drop >= 0 && t - dropped[drop].t < DROPPED_FOR ? drop : -1;
    if (`${commit}/${fresh}` === this.shown) return;
    this.shown = `${commit}/${fresh}`;
    const nothing = {t: 0, branch: 0, step: 1, points: [], wished: []};
    this.showCommit(commits[commit] || nothing);
    this.showCorridor(commit);
    this.showDropped(dropped[fresh] || nothing);
  }
}
