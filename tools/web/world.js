// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** What the colours of the scene are. The page's own are in page.css. */
const PALETTES = {
  light: {
    paper: 0xf5f6f8, ground: 0xe6e9ee, grid: 0xd3d8df, solid: 0x97a2b3, ghost: 0x7d8898, keepout: 0xd04a3a,
    keepin: 0x2f8f5b, corridor: 0x2f8f5b, search: 0x8a93a0, short: 0x1c2430, body: 0x1c2430, rotor: 0x0f62c8,
    sensor: 0xe0a100, known: 0x6f7fa0, seen: 0x9cc3ee, commit: 0x0f8a4f, brake: 0xd9480f, dropped: 0x8b95a3,
    start: 0x2f8f5b, goal: 0xd9480f, via: 0x7b3fa0,
    speeds: [0x2c3e9e, 0xb0307f, 0xf0a020], runs: ["#0f62c8", "#d9480f", "#2f8f5b", "#7b3fa0", "#b8860b", "#008b8b"],
    axes: ["#c8553d", "#2f8f5b", "#2b6cb0"],
  },
  dark: {
    paper: 0x10141a, ground: 0x1a2029, grid: 0x2a323e, solid: 0x657286, ghost: 0x8d9bb0, keepout: 0xff7061,
    keepin: 0x58c98b, corridor: 0x58c98b, search: 0x8793a5, short: 0xe8ecf1, body: 0xe8ecf1, rotor: 0x6cb0ff,
    sensor: 0xffce4a, known: 0x8ba0c8, seen: 0x2f557f, commit: 0x4ade94, brake: 0xff8a4c, dropped: 0x7d899a,
    start: 0x58c98b, goal: 0xff8a4c, via: 0xc792ea,
    speeds: [0x5c78ff, 0xf062b4, 0xffc857], runs: ["#6cb0ff", "#ff8a4c", "#58c98b", "#c792ea", "#ffc857", "#4dd0e1"],
    axes: ["#ff8f76", "#58c98b", "#6cb0ff"],
  },
};

/** Points of a flat list x, y, z, x, ... */
function pointsOf(flat) {
  const points = [];
  for (let i = 0; i + 2 < flat.length; i += 3) points.push(new THREE.Vector3(flat[i], flat[i + 1], flat[i + 2]));
  return points;
}

/** One mesh for all boxes, which are a flat list of lower and upper corners. */
function boxesMesh(flat, material) {
  const count = flat.length / 6;
  const mesh = new THREE.InstancedMesh(new THREE.BoxBufferGeometry(1, 1, 1), material, count);
  const matrix = new THREE.Matrix4();
  for (let i = 0; i < count; ++i) {
    const [a, b, c, d, e, f] = flat.slice(6 * i, 6 * i + 6);
    matrix.makeScale(Math.max(d - a, 1e-3), Math.max(e - b, 1e-3), Math.max(f - c, 1e-3));
    matrix.setPosition((a + d) / 2, (b + e) / 2, (c + f) / 2);
    mesh.setMatrixAt(i, matrix);
  }
  mesh.frustumCulled = false;
  return mesh;
}

/** Likewise upright cylinders: x, y, bottom, top, radius. */
function cylindersMesh(flat, material) {
  const count = flat.length / 5;
  const geometry = new THREE.CylinderBufferGeometry(1, 1, 1, 20);
  geometry.rotateX(Math.PI / 2);
  const mesh = new THREE.InstancedMesh(geometry, material, count);
  const matrix = new THREE.Matrix4();
  for (let i = 0; i < count; ++i) {
    const [x, y, bottom, top, radius] = flat.slice(5 * i, 5 * i + 5);
    matrix.makeScale(radius, radius, top - bottom);
    matrix.setPosition(x, y, (bottom + top) / 2);
    mesh.setMatrixAt(i, matrix);
  }
  mesh.frustumCulled = false;
  return mesh;
}

function line(points, colour, opacity = 1) {
  return new THREE.Line(new THREE.BufferGeometry().setFromPoints(points), new THREE.LineBasicMaterial({
    color: colour, transparent: opacity < 1, opacity,
  }));
}

/** The floor with a line every metre, or every 5 or 10 metres of a large world, and the frame of the boundary. */
function floorAndFrame([x0, y0, z0, x1, y1, z1], palette) {
  const group = new THREE.Group();
  const floor = new THREE.Mesh(new THREE.PlaneBufferGeometry(x1 - x0, y1 - y0),
    new THREE.MeshBasicMaterial({color: palette.ground, polygonOffset: true, polygonOffsetFactor: 2,
      polygonOffsetUnits: 2}));
  floor.position.set((x0 + x1) / 2, (y0 + y1) / 2, z0);
  const size = Math.max(x1 - x0, y1 - y0);
  const step = size > 120 ? 10 : size > 30 ? 5 : 1;
  const lines = [];
  for (let x = x0; x <= x1 + 1e-9; x += step) lines.push(new THREE.Vector3(x, y0, z0), new THREE.Vector3(x, y1, z0));
  for (let y = y0; y <= y1 + 1e-9; y += step) lines.push(new THREE.Vector3(x0, y, z0), new THREE.Vector3(x1, y, z0));
  const grid = new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(lines),
    new THREE.LineBasicMaterial({color: palette.grid}));
  const frame = new THREE.Box3Helper(new THREE.Box3(new THREE.Vector3(x0, y0, z0), new THREE.Vector3(x1, y1, z1)),
    palette.grid);
  group.add(floor, grid, frame);
  return group;
}

function marker([x, y, z], radius, colour, opacity = 0.9) {
  const mesh = new THREE.Mesh(new THREE.SphereBufferGeometry(radius, 20, 12),
    new THREE.MeshLambertMaterial({color: colour, transparent: opacity < 1, opacity}));
  mesh.position.set(x, y, z);
  return mesh;
}

/** The obstacles of a run: solid, or see-through where they are there to be discovered. */
function obstacles(run, palette) {
  const group = new THREE.Group();
  const ghost = run.kind === "flight";
  const material = new THREE.MeshLambertMaterial(
    ghost ? {color: palette.ghost, transparent: true, opacity: 0.16, depthWrite: false} : {color: palette.solid});
  if (run.boxes.length > 0) group.add(boxesMesh(run.boxes, material));
  if (run.cylinders.length > 0) group.add(cylindersMesh(run.cylinders, material));
  return group;
}

function fences(run, palette) {
  const group = new THREE.Group();
  for (const fence of run.fences) {
    group.add(polyhedronMesh(fence.halfspaces, fence.keep_in ? palette.keepin : palette.keepout,
      fence.keep_in ? 0.04 : 0.25));
  }
  if (run.keepout.length > 0) {
    group.add(boxesMesh(run.keepout, new THREE.MeshLambertMaterial({color: palette.keepout, transparent: true,
      opacity: 0.35, depthWrite: false})));
  }
  return group;
}

function endsAndVias(run, palette) {
  const group = new THREE.Group();
  const [x0, y0, z0, x1, y1, z1] = run.boundary;
  const size = Math.max(0.6 * run.radius, 0.005 * Math.hypot(x1 - x0, y1 - y0, z1 - z0));
  group.add(marker(run.start, size, palette.start), marker(run.goal, size, palette.goal));
  for (const [x, y, z, tolerance] of run.vias) {
    group.add(marker([x, y, z], 0.4 * size, palette.via), marker([x, y, z], Math.max(tolerance, size), palette.via, 0.2));
  }
  return group;
}

/** A tube along points with a colour for each: WebGL's lines are a pixel wide. Its triangles follow the points. */
const TUBE_SIDES = 6;

function tube(points, radius, colours) {
  const positions = [];
  const shades = [];
  const faces = [];
  const ahead = new THREE.Vector3();
  const side = new THREE.Vector3(0, 1, 0);
  const up = new THREE.Vector3();
  points.forEach((p, i) => {
    ahead.subVectors(points[Math.min(i + 1, points.length - 1)], points[Math.max(i - 1, 0)]);
    if (ahead.lengthSq() > 1e-12) {
      side.set(-ahead.y, ahead.x, 0);
      if (side.lengthSq() < 1e-12) side.set(0, 1, 0);
      side.normalize();
      up.crossVectors(ahead, side).normalize();
    }
    for (let k = 0; k < TUBE_SIDES; ++k) {
      const angle = (2 * Math.PI * k) / TUBE_SIDES;
      const [c, s] = [radius * Math.cos(angle), radius * Math.sin(angle)];
      positions.push(p.x + c * side.x + s * up.x, p.y + c * side.y + s * up.y, p.z + c * side.z + s * up.z);
      shades.push(colours[i].r, colours[i].g, colours[i].b);
      if (i === 0) continue;
      const [a, b] = [TUBE_SIDES * i + k, TUBE_SIDES * i + ((k + 1) % TUBE_SIDES)];
      faces.push(a - TUBE_SIDES, b - TUBE_SIDES, a, b - TUBE_SIDES, b, a);
    }
  });
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(positions, 3));
  geometry.setAttribute("color", new THREE.Float32BufferAttribute(shades, 3));
  geometry.setIndex(faces);
  return geometry;
}

/** The colour of part t in [0, 1] of the scale of speeds. */
function speedColour(t, palette) {
  const [slow, middle, fast] = palette.speeds.map((hex) => new THREE.Color(hex));
  return t < 0.5 ? slow.lerp(middle, 2 * t) : middle.lerp(fast, 2 * t - 1);
}
