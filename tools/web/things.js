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
 * Things that move: each with its tube's width now, and the way of its centre. `run.things`: for each its shape, and rows
 * `step` seconds apart of its place and its error; a place of null while it is not there.
 */
class Things {
  constructor(run, palette, pixel) {
    this.group = new THREE.Group();
    this.things = run.things.map((thing) => {
      const solid = new THREE.Mesh(thingGeometry(thing, 0), new THREE.MeshLambertMaterial(thing.fence
        ? {color: palette.fence, transparent: true, opacity: 0.28, depthWrite: false} : {color: palette.thing}));
      const shell = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshLambertMaterial({color: palette.thing,
        transparent: true, opacity: 0.22, depthWrite: false}));
      this.group.add(solid, shell);
      const lists = [[]];
      thing.rows.forEach((row) => {
        if (row === null) lists.push([]);
        else lists[lists.length - 1].push(new THREE.Vector3(row[0], row[1], row[2]));
      });
      this.group.add(plainTubes(lists, palette.thing, tubeMaterial(0, 1.5, pixel, {opacity: 0.6})));
      return {...thing, solid, shell, drawn: -1};
    });
  }

  setTime(t) {
    for (const thing of this.things) {
      const x = Math.min(Math.max(t / thing.step, 0), thing.rows.length - 1);
      const before = Math.floor(x);
      const [row, next] = [thing.rows[before], thing.rows[Math.min(before + 1, thing.rows.length - 1)] || thing.rows[before]];
      thing.solid.visible = thing.shell.visible = row !== null;
      if (row === null) continue;
      const at = row.map((number, i) => number + (x - before) * (next[i] - number));
      thing.solid.position.set(at[0], at[1], at[2]);
      thing.shell.position.copy(thing.solid.position);
      const error = Math.round(100 * at[3]) / 100;
      if (error === thing.drawn) continue;
      thing.drawn = error;
      thing.shell.geometry.dispose();
      thing.shell.geometry = thingGeometry(thing, error);
    }
  }
}
