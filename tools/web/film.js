// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** What a flight knew and meant to do at each time: obstacles seen, space seen, committed and dropped plans. */
class Film {
  constructor(film, palette, width, floor) {
    this.film = film;
    this.palette = palette;
    this.width = width;
    this.now = {value: 0};  // shared by the shaders
    this.known = new THREE.Group();
    this.plans = new THREE.Group();
    this.shown = -1;
    this.begins = [];
    if (film.known.blocks.length > 0) this.known.add(this.knownMesh(film.known));
    this.known.add(this.seenMesh(film.seen, floor));
    this.plan = new THREE.Group();
    this.lost = new THREE.Group();
    this.plans.add(this.plan, this.lost);
    this.corridor = new THREE.Group();
  }

  /** Blocks of voxels, each for as long as the map holds it for solid, in the order of their beginning. */
  knownMesh({cell, origin, blocks}) {
    const corners = [];
    const lives = [];
    for (let i = 0; i < blocks.length; i += 7) {
      const [x, y, z, width, height, from, until] = blocks.slice(i, i + 7);
      corners.push(origin[0] + cell * x, origin[1] + cell * y, origin[2] + cell * z,
        origin[0] + cell * (x + 1), origin[1] + cell * (y + width), origin[2] + cell * (z + height));
      lives.push(from, until < 0 ? 1e9 : until);
      this.begins.push({t: from});
    }
    const material = new THREE.MeshLambertMaterial({color: this.palette.known});
    material.onBeforeCompile = (shader) => {
      shader.uniforms.now = this.now;
      shader.vertexShader = "attribute vec2 life;\nuniform float now;\n" + shader.vertexShader.replace(
        "#include <begin_vertex>",
        "#include <begin_vertex>\ntransformed *= step(life.x, now) * (1.0 - step(life.y, now));");
    };
    const mesh = boxesMesh(corners, material);
    mesh.geometry.setAttribute("life", new THREE.InstancedBufferAttribute(new Float32Array(lives), 2));
    this.blocks = mesh;
    return mesh;
  }

  /** The floor below what was seen free. A texel holds the time of the first look; a shader compares it with now. */
  seenMesh({cell, origin, size, times}, floor) {
    const [nx, ny] = size;
    const data = new Float32Array(4 * nx * ny);
    times.forEach((time, i) => { data[4 * i] = time < 0 ? 1e9 : time / 10; });
    const texture = new THREE.DataTexture(data, nx, ny, THREE.RGBAFormat, THREE.FloatType);
    texture.needsUpdate = true;
    const mesh = new THREE.Mesh(new THREE.PlaneBufferGeometry(nx * cell, ny * cell), new THREE.ShaderMaterial({
      uniforms: {now: this.now, times: {value: texture}, colour: {value: new THREE.Color(this.palette.seen)}},
      vertexShader: "varying vec2 place; void main() { place = uv; " +
        "gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
      fragmentShader: "uniform float now; uniform sampler2D times; uniform vec3 colour; varying vec2 place; " +
        "void main() { if (texture2D(times, place).r > now) discard; gl_FragColor = vec4(colour, 0.55); }",
      transparent: true, depthWrite: false,
    }));
    mesh.position.set(origin[0] + (nx * cell) / 2, origin[1] + (ny * cell) / 2, floor + 0.01);
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

  /** Other objects in a group. */
  static replace(group, objects) {
    group.traverse((old) => {
      if (old.geometry) old.geometry.dispose();
      if (old.material) old.material.dispose();
    });
    group.remove(...group.children);
    if (objects.length > 0) group.add(...objects);
  }

  /** Green up to the branch, orange where it brakes; the thin line is how the plan would go on. */
  commitMeshes(commit) {
    const finer = 4;  // points of a smooth curve for each of the commit's
    const corners = pointsOf(commit.points);
    const points = new THREE.CatmullRomCurve3(corners).getPoints(finer * (corners.length - 1));
    const colours = points.map((_, i) =>
      new THREE.Color(commit.t + (i * commit.step) / finer < commit.branch ? this.palette.commit : this.palette.brake));
    return [
      new THREE.Mesh(tube(points, this.width, colours),
        new THREE.MeshBasicMaterial({vertexColors: THREE.VertexColors})),
      line(pointsOf(commit.wished), this.palette.commit, 0.6),
    ];
  }

  /** The corridor of the last new plan: where a plan goes on, its corridor stays. */
  corridorMeshes(number) {
    for (let i = number; i >= 0; --i) {
      const {corridor} = this.film.commits[i];
      if (corridor) return corridor.map((halfspaces) => polyhedronMesh(halfspaces, this.palette.corridor, 0.05));
    }
    return [];
  }

  setTime(t) {
    this.now.value = t;
    if (this.blocks) this.blocks.count = Film.last(this.begins, t) + 1;
    const {commits, dropped} = this.film;
    const commit = Film.last(commits, t);
    const drop = Film.last(dropped, t);
    const fresh = drop >= 0 && t - dropped[drop].t < 0.5 ? drop : -1;
    const key = commit + "/" + fresh;
    if (key === this.shown) return;
    this.shown = key;
    Film.replace(this.plan, commit >= 0 ? this.commitMeshes(commits[commit]) : []);
    Film.replace(this.corridor, this.corridorMeshes(commit));
    Film.replace(this.lost, fresh >= 0 ? [line(pointsOf(dropped[fresh].points), this.palette.dropped)] : []);
  }
}
