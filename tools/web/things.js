// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** The geometry of a thing's shape, grown by `error`; upright cylinders stand along z. */
function thingGeometry({shape, radius, half}, error) {
  if (shape === "box") {
    return new THREE.BoxBufferGeometry(...half.map((size) => Math.max(2 * (size + error), 1e-3)));
  }
  if (shape === "ball") return new THREE.SphereBufferGeometry(Math.max(radius + error, 1e-3), 20, 12);
  const geometry = new THREE.CylinderBufferGeometry(radius + error, radius + error, 2 * (half[2] + error), 24);
  return geometry.rotateX(Math.PI / 2);
}

/**
 * Things that move: each with its tube's width now, and the way of its centre. `run.things`: for each its name, its shape,
 * and rows `step` seconds apart of its place and its error; a place of null while it is not there. `run.film.tubes`,
 * likewise: the tubes of the plan that is flown, without things in them. Keep-outs for a while are in `closed`, all else is
 * in `group`.
 */
class Things {
  constructor(run, palette, pixel) {
    [this.group, this.closed] = [new THREE.Group(), new THREE.Group()];
    const tubes = (run.film && run.film.tubes) || [];
    this.things = [...run.things.map((thing) => this.add(thing, this.addSolid(thing, palette, pixel), palette)),
      ...tubes.map((tube) => this.add(tube, null, palette))];
  }

  add(thing, solid, palette) {
    const shell = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshLambertMaterial({color: palette.thing,
      transparent: true, opacity: 0.22, depthWrite: false}));
    this.group.add(shell);
    return {...thing, solid, shell, drawn: -1};
  }

  addSolid(thing, palette, pixel) {
    const solid = new THREE.Mesh(thingGeometry(thing, 0), new THREE.MeshLambertMaterial(thing.fence
      ? {color: palette.fence, transparent: true, opacity: 0.28, depthWrite: false} : {color: palette.thing}));
    (thing.fence ? this.closed : this.group).add(solid);
    if (thing.fence) return solid;
    const lists = [[]];
    thing.rows.forEach((row) => {
      if (row === null) lists.push([]);
      else lists[lists.length - 1].push(new THREE.Vector3(row[0], row[1], row[2]));
    });
    this.group.add(plainTubes(lists, palette.thing, tubeMaterial(0, 1.5, pixel, {opacity: 0.6})));
    return solid;
  }

  /** Where the name of thing k belongs now, above it; null while it is not there. */
  top(k) {
    const {solid, shape, radius, half} = this.things[k];
    if (!solid.visible) return null;
    const {x, y, z} = solid.position;
    return new THREE.Vector3(x, y, z + (shape === "ball" ? radius : half[2]));
  }

  setTime(t) {
    for (const thing of this.things) {
      const x = Math.min(Math.max(t / thing.step, 0), thing.rows.length - 1);
      const before = Math.floor(x);
      const [row, next] = [thing.rows[before], thing.rows[Math.min(before + 1, thing.rows.length - 1)] || thing.rows[before]];
      const solid = thing.solid;
      thing.shell.visible = row !== null && (solid === null || row[3] > 0);
      if (solid !== null) solid.visible = row !== null;
      if (row === null) continue;
      const at = row.map((number, i) => number + (x - before) * (next[i] - number));
      if (solid !== null) solid.position.set(at[0], at[1], at[2]);
      thing.shell.position.set(at[0], at[1], at[2]);
      const error = Math.round(100 * at[3]) / 100;
      if (error === thing.drawn) continue;
      thing.drawn = error;
      thing.shell.geometry.dispose();
      thing.shell.geometry = thingGeometry(thing, error);
    }
  }
}
