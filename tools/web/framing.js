// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** Degrees above the horizon from which worlds are seen at first, and turns of a world that are tried. */
const ELEVATIONS = [28, 36, 44];
const TURNS = [...Array(24)].map((_, k) => ((k + 0.5) * Math.PI) / 12);
const MOST_BOXES = 1500;
const MOST_POINTS = 24;

/** Towards a camera that looks along y from `elevation` degrees above. */
function towardsCamera(elevation) {
  const angle = (elevation * Math.PI) / 180;
  return new THREE.Vector3(0, -Math.cos(angle), Math.sin(angle));
}

/** Every n-th item of a list, so that there are `most` at most. */
function thinned(list, most) {
  const every = Math.ceil(list.length / most) || 1;
  return list.filter((_, i) => i % every === 0);
}

/** Corners of the boxes around all obstacles of a run. */
function boxesOf({boxes, cylinders}) {
  const list = [];
  for (let i = 0; i < boxes.length; i += 6) list.push(boxes.slice(i, i + 6));
  for (let i = 0; i < cylinders.length; i += 5) {
    const [x, y, bottom, top, r] = cylinders.slice(i, i + 5);
    list.push([x - r, y - r, bottom, x + r, y + r, top]);
  }
  return thinned(list, MOST_BOXES);
}

/** Does the ray from a point into a direction, all of them components, meet a box? */
function meets(point, direction, box) {
  let [from, to] = [0, Infinity];
  for (let axis = 0; axis < 3; ++axis) {
    if (Math.abs(direction[axis]) < 1e-12) {
      if (point[axis] < box[axis] || point[axis] > box[axis + 3]) return false;
      continue;
    }
    const a = (box[axis] - point[axis]) / direction[axis];
    const b = (box[axis + 3] - point[axis]) / direction[axis];
    from = Math.max(from, Math.min(a, b));
    to = Math.min(to, Math.max(a, b));
  }
  return from < to;
}

/** The part of a run's way that is seen from a direction. Without a way: the part of the ends. */
function visiblePart(view, direction) {
  if (!view.boxes) {
    const {start, goal, motion} = view.run;
    const way = motion ? motion.columns.px.map((x, i) => [x, motion.columns.py[i], motion.columns.pz[i]]) : [start, goal];
    view.boxes = boxesOf(view.run);
    view.way = thinned(way, MOST_POINTS);
  }
  const seen = view.way.filter((point) => !view.boxes.some((box) => meets(point, direction, box)));
  return seen.length / view.way.length;
}

/** How good it is to see a view's world turned by `turn`: its size in pixels, and how much of the way is seen. */
function worthOf(view, turn, elevation, width, height) {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const {x, y, z} = view.extent;
  const angle = (elevation * Math.PI) / 180;
  const across = Math.abs(c) * x + Math.abs(s) * y;
  const high = Math.sin(angle) * (Math.abs(s) * x + Math.abs(c) * y) + Math.cos(angle) * z;
  const size = Math.min(width / across, height / high) * view.size;
  const key = `${turn}/${elevation}`;
  view.visible = view.visible || {};
  if (!(key in view.visible)) {
    const direction = towardsCamera(elevation).applyAxisAngle(new THREE.Vector3(0, 0, 1), -turn);
    view.visible[key] = visiblePart(view, direction.toArray());
  }
  // A way is easiest to read across the screen, from left to right.
  const {start, goal} = view.run;
  const [dx, dy] = [goal[0] - start[0], goal[1] - start[1]];
  const ahead = (c * dx - s * dy) / Math.max(Math.hypot(dx, dy), 1e-6);
  return size * (0.25 + view.visible[key]) * (0.8 + 0.2 * ahead);
}

/** The best turn of a view's world in a rectangle, and its worth. */
function bestTurn(view, elevation, width, height) {
  return TURNS.map((turn) => ({turn, worth: worthOf(view, turn, elevation, width, height)}))
    .reduce((best, other) => (other.worth > best.worth ? other : best));
}

/**
 * The look with which all of a world is within a camera's picture and fills it; and the box around the world there, in
 * parts of the picture, from -1 to 1.
 */
function fitted(view, camera, fill) {
  camera.updateMatrixWorld();
  const toCamera = new THREE.Matrix4().getInverse(camera.matrixWorld);
  const [x0, y0, z0, x1, y1, z1] = view.run.boundary;
  const corners = [...Array(8)].map((_, i) => new THREE.Vector3(i & 1 ? x1 : x0, i & 2 ? y1 : y0, i & 4 ? z1 : z0));
  const distance = camera.position.length();
  const slope = Math.tan((camera.fov * Math.PI) / 360);
  const focus = view.middle.clone();
  let scale = (0.5 * distance) / view.size;
  const box = new THREE.Box2();
  for (let i = 0; i < 20; ++i) {
    box.makeEmpty();
    for (const corner of corners) {
      const p = corner.clone().sub(focus).applyAxisAngle(camera.up, view.turn).multiplyScalar(scale).applyMatrix4(toCamera);
      box.expandByPoint(new THREE.Vector2(p.x / (-p.z * slope * camera.aspect), p.y / (-p.z * slope)));
    }
    const middle = box.getCenter(new THREE.Vector2());
    const size = box.getSize(new THREE.Vector2());
    const by = new THREE.Vector3(middle.x * slope * camera.aspect, middle.y * slope, 0).multiplyScalar(distance / scale);
    focus.add(by.applyQuaternion(camera.quaternion).applyAxisAngle(camera.up, -view.turn));
    scale *= Math.sqrt((2 * fill) / Math.max(size.x, size.y));
  }
  return {focus, scale, box};
}
