// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** A quadrotor within a ball of the robot's radius: x ahead, y left, z along the thrust. */
function quadrotor(radius, palette) {
  const group = new THREE.Group();
  const dark = new THREE.MeshLambertMaterial({color: palette.body});
  const blades = new THREE.MeshLambertMaterial({color: palette.rotor, transparent: true, opacity: 0.75,
    side: THREE.DoubleSide});
  const hull = new THREE.Mesh(new THREE.BoxBufferGeometry(0.6 * radius, 0.4 * radius, 0.22 * radius), dark);
  const nose = new THREE.Mesh(new THREE.ConeBufferGeometry(0.2 * radius, 0.4 * radius, 12),
    new THREE.MeshLambertMaterial({color: palette.goal}));
  nose.rotation.z = -Math.PI / 2;
  nose.position.x = 0.45 * radius;
  group.add(hull, nose);
  for (const [x, y] of [[1, 1], [1, -1], [-1, 1], [-1, -1]]) {
    const arm = new THREE.Mesh(new THREE.BoxBufferGeometry(0.75 * radius, 0.08 * radius, 0.08 * radius), dark);
    arm.rotation.z = Math.atan2(y, x);
    arm.position.set(0.27 * x * radius, 0.27 * y * radius, 0);
    const rotor = new THREE.Mesh(new THREE.CylinderBufferGeometry(0.36 * radius, 0.36 * radius, 0.03 * radius, 24), blades);
    rotor.rotation.x = Math.PI / 2;
    rotor.position.set(0.5 * x * radius, 0.5 * y * radius, 0.1 * radius);
    group.add(arm, rotor);
  }
  return group;
}

/** What a lidar sees at most: the band of a sphere. */
function sensorBand({range, fov}, palette) {
  const high = (fov[1] * Math.PI) / 180;
  const band = new THREE.SphereBufferGeometry(range, 48, 4, 0, 2 * Math.PI, 0.5 * (Math.PI - high), high);
  band.rotateX(Math.PI / 2);
  return new THREE.Mesh(band, new THREE.MeshBasicMaterial({
    color: palette.sensor, transparent: true, opacity: 0.06, side: THREE.DoubleSide, depthWrite: false}));
}

/** What the sensor sees at most. A camera: a level pyramid along x, from its eye to its range. */
function sensorCone({range, fov}, palette) {
  if (fov[0] >= 360) return sensorBand({range, fov}, palette);
  const [half, high] = fov.map((degrees) => range * Math.tan((degrees * Math.PI) / 360));
  const corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([a, b]) => new THREE.Vector3(range, a * half, b * high));
  const eye = new THREE.Vector3();
  const faces = [];
  const edges = [];
  corners.forEach((corner, i) => {
    const next = corners[(i + 1) % 4];
    faces.push(eye, corner, next);
    edges.push(eye, corner, corner, next);
  });
  const group = new THREE.Group();
  group.add(new THREE.Mesh(new THREE.BufferGeometry().setFromPoints(faces), new THREE.MeshBasicMaterial({
    color: palette.sensor, transparent: true, opacity: 0.06, side: THREE.DoubleSide, depthWrite: false})));
  group.add(new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(edges),
    new THREE.LineBasicMaterial({color: palette.sensor, transparent: true, opacity: 0.5})));
  return group;
}

/** The rows of a run's motion by time. Between rows, numbers are interpolated. */
class Motion {
  constructor({step, columns}) {
    this.step = step;
    this.columns = columns;
    this.count = columns.px.length;
    this.end = step * (this.count - 1);
  }

  /** Row before time t, and how far t is towards the next one. */
  at(t) {
    const x = Math.min(Math.max(t / this.step, 0), this.count - 1);
    const row = Math.min(Math.floor(x), Math.max(this.count - 2, 0));
    return [row, this.count > 1 ? x - row : 0];
  }

  number(name, t) {
    const [row, part] = this.at(t);
    const column = this.columns[name];
    return part > 0 ? column[row] + part * (column[row + 1] - column[row]) : column[row];
  }

  vector(kind, t, into = new THREE.Vector3()) {
    return into.set(this.number(kind + "x", t), this.number(kind + "y", t), this.number(kind + "z", t));
  }

  quaternion(t, into = new THREE.Quaternion()) {
    const [row, part] = this.at(t);
    const {qw, qx, qy, qz} = this.columns;
    const of = (i) => new THREE.Quaternion(qx[i], qy[i], qz[i], qw[i]);
    into.copy(of(row));
    return part > 0 ? into.slerp(of(row + 1), part) : into;
  }

  /** Lengths of the vectors of one kind, row by row. */
  lengths(kind) {
    const [x, y, z] = ["x", "y", "z"].map((axis) => this.columns[kind + axis]);
    return x.map((value, i) => Math.hypot(value, y[i], z[i]));
  }
}
