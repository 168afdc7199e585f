// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** Points of a flat list x, y, z, x, ... */
function pointsOf(flat) {
  const points = [];
  for (let i = 0; i + 2 < flat.length; i += 3) points.push(new THREE.Vector3(flat[i], flat[i + 1], flat[i + 2]));
  return points;
}

function lineMaterial(colour, opacity) {
  return new THREE.LineBasicMaterial({color: colour, transparent: true, opacity});
}

/** What lies on the floor is drawn in this order, above what is solid below it. */
const ON_FLOOR = {seen: -4, grid: -3, shadow: -2};

/** The grid's lines are a metre apart, or 5 or 10 metres in a large world. */
function gridPitch([x0, y0, , x1, y1]) {
  const size = Math.max(x1 - x0, y1 - y0);
  return size > 120 ? 10 : size > 30 ? 5 : 1;
}

/** The floor, its grid, and the frame of the boundary. The floor of a flight is dark until it is seen. */
function floorAndFrame(run, palette) {
  const [x0, y0, z0, x1, y1, z1] = run.boundary;
  const group = new THREE.Group();
  const floor = new THREE.Mesh(new THREE.PlaneBufferGeometry(x1 - x0, y1 - y0), new THREE.MeshBasicMaterial({
    color: run.film ? palette.fog : palette.ground, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2}));
  floor.position.set((x0 + x1) / 2, (y0 + y1) / 2, z0);
  const step = gridPitch(run.boundary);
  const [lines, z] = [[], z0 + 0.02];
  for (let x = x0; x <= x1 + 1e-9; x += step) lines.push(new THREE.Vector3(x, y0, z), new THREE.Vector3(x, y1, z));
  for (let y = y0; y <= y1 + 1e-9; y += step) lines.push(new THREE.Vector3(x0, y, z), new THREE.Vector3(x1, y, z));
  const grid = new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(lines), lineMaterial(palette.grid, 0.8));
  grid.renderOrder = ON_FLOOR.grid;
  group.add(floor, grid, outlines({boxes: run.boundary, cylinders: []}, palette.frame, 0.9));
  return group;
}

function ball([x, y, z], radius, colour, opacity) {
  const mesh = new THREE.Mesh(new THREE.SphereBufferGeometry(radius, 20, 12), new THREE.MeshLambertMaterial({
    color: colour, transparent: opacity < 1, opacity, depthWrite: opacity === 1}));
  mesh.position.set(x, y, z);
  return mesh;
}

/** What is known of a plan's world: all of it. */
function knownObstacles(run, palette, shared) {
  const group = new THREE.Group();
  const material = solidMaterial(palette.known, run.boundary, shared, null);
  if (run.boxes.length > 0) group.add(boxesMesh(run.boxes, material));
  if (run.cylinders.length > 0) group.add(cylindersMesh(run.cylinders, material));
  group.add(outlines(run, palette.paper, 0.35));
  return group;
}

/** The true world of a flight, which is there to be discovered: see-through. */
function ghostObstacles(run, palette) {
  const group = new THREE.Group();
  const material = new THREE.MeshLambertMaterial({color: palette.ghost, transparent: true, opacity: 0.16,
    depthWrite: false});
  if (run.boxes.length > 0) group.add(boxesMesh(run.boxes, material));
  if (run.cylinders.length > 0) group.add(cylindersMesh(run.cylinders, material));
  group.add(outlines(run, palette.ghost, 0.5));
  return group;
}

/** What must be kept out of is filled; of what must be stayed in, the edges are drawn. Fences may have no end: the part
 * in the boundary is shown. */
function fences(run, palette) {
  const group = new THREE.Group();
  const [x0, y0, z0, x1, y1, z1] = run.boundary;
  const boundary = [[1, 0, 0, x1], [-1, 0, 0, -x0], [0, 1, 0, y1], [0, -1, 0, -y0], [0, 0, 1, z1], [0, 0, -1, -z0]];
  run.fences.forEach((fence, i) => {
    const opacities = fence.keep_in ? [0.02, 0.8] : [0.28, 0.9];
    const mesh = polyhedraMesh([[...fence.halfspaces, ...boundary]], volumeMaterials(palette.fence, ...opacities));
    mesh.userData.window = run.windows ? run.windows[i] : null;
    group.add(mesh);
  });
  if (run.keepout.length > 0) {
    group.add(
      boxesMesh(run.keepout, new THREE.MeshLambertMaterial({color: palette.fence, transparent: true, opacity: 0.28,
        depthWrite: false})),
      outlines({boxes: run.keepout, cylinders: []}, palette.fence, 0.9));
  }
  return group;
}

/** A fence for a while is there while it holds. */
function showFences(group, time) {
  group.children.forEach((mesh) => {
    const {window} = mesh.userData;
    if (window) mesh.visible = window[0] <= time && time <= window[1];
  });
}

/** Where a flight was blocked at its end: a cube of this size on a pole from the floor, through whatever hides it. */
function blockedMark(run, palette, size) {
  const [x, y, z] = run.blocked;
  const around = [x - size, y - size, z - size, x + size, y + size, z + size];
  const cube = new THREE.Mesh(new THREE.BoxBufferGeometry(2 * size, 2 * size, 2 * size),
    new THREE.MeshBasicMaterial({color: palette.fence, transparent: true, opacity: 0.4, depthTest: false,
      depthWrite: false}));
  cube.position.set(x, y, z);
  const pole = new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(x, y, run.boundary[2]), cube.position]);
  const lines = [outlines({boxes: around, cylinders: []}, palette.fence, 1),
    new THREE.LineSegments(pole, lineMaterial(palette.fence, 0.8))];
  for (const line of lines) line.material.depthTest = false;
  const group = new THREE.Group();
  group.add(cube, ...lines);
  return group;
}

/** A pole from the floor, with a ball at the start and a pin's head at the goal; vias with their tolerances. */
function endsAndVias(run, palette, size) {
  const group = new THREE.Group();
  const ink = new THREE.MeshLambertMaterial({color: palette.ink});
  const poles = [];
  for (const [x, y, z] of [run.start, run.goal, ...run.vias]) {
    poles.push(new THREE.Vector3(x, y, run.boundary[2]), new THREE.Vector3(x, y, z));
  }
  const goal = new THREE.Mesh(new THREE.OctahedronBufferGeometry(1.5 * size), ink);
  goal.position.set(...run.goal);
  group.add(new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(poles), lineMaterial(palette.ink, 0.6)),
    ball(run.start, size, palette.ink, 1), goal);
  for (const [x, y, z, tolerance] of run.vias) {
    group.add(ball([x, y, z], 0.5 * size, palette.ink, 1),
      ball([x, y, z], Math.max(tolerance, size), palette.ink, 0.15));
  }
  return group;
}
