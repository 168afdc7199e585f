// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

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

  /** Where the nose points, seen from above. */
  heading(t) {
    const {x, y, z, w} = this.quaternion(t);
    return Math.atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z));
  }

  /** Lengths of the vectors of one kind, row by row. */
  lengths(kind) {
    const [x, y, z] = ["x", "y", "z"].map((axis) => this.columns[kind + axis]);
    return x.map((value, i) => Math.hypot(value, y[i], z[i]));
  }

  /** Likewise their largest components, which is what the limits of an axis bound. */
  largest(kind) {
    const [x, y, z] = ["x", "y", "z"].map((axis) => this.columns[kind + axis]);
    return x.map((value, i) => Math.max(Math.abs(value), Math.abs(y[i]), Math.abs(z[i])));
  }
}

/** The highest speed of several runs, where there is one. */
function fastestOf(runs) {
  const motions = runs.filter((run) => run.motion).map((run) => new Motion(run.motion));
  return motions.reduce((most, motion) => motion.lengths("v").reduce((a, b) => Math.max(a, b), most), 0);
}
