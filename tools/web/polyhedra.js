// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** The faces of the bounded polyhedron that half-spaces [nx, ny, nz, offset] share, as lists of THREE.Vector3. */
function facesOf(halfspaces) {
  return halfspaces
    .map((own, index) => halfspaces.reduce((face, other, k) => (k === index ? face : clipped(face, other)), square(own)))
    .filter((face) => face.length > 2);
}

/** A large square on the plane of a half-space. */
function square([x, y, z, offset]) {
  const size = 1e4;
  const normal = new THREE.Vector3(x, y, z);
  const helper = Math.abs(z) < 0.9 ? new THREE.Vector3(0, 0, 1) : new THREE.Vector3(1, 0, 0);
  const u = new THREE.Vector3().crossVectors(normal, helper).normalize().multiplyScalar(size);
  const v = new THREE.Vector3().crossVectors(normal, u);
  const middle = normal.clone().multiplyScalar(offset);
  return [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([a, b]) =>
    middle.clone().addScaledVector(u, a).addScaledVector(v, b));
}

/** The part of a convex polygon inside a half-space. */
function clipped(polygon, [x, y, z, offset]) {
  const excess = (p) => x * p.x + y * p.y + z * p.z - offset;
  const inside = [];
  polygon.forEach((p, i) => {
    const q = polygon[(i + 1) % polygon.length];
    const [a, b] = [excess(p), excess(q)];
    if (a <= 1e-6) inside.push(p);
    if ((a < -1e-6 && b > 1e-6) || (a > 1e-6 && b < -1e-6)) inside.push(p.clone().lerp(q, a / (a - b)));
  });
  return inside;
}

/** Of translucent faces, and of their edges; cut off at `planes`. */
function volumeMaterials(colour, opacity, edgeOpacity, planes = []) {
  const faces = new THREE.MeshBasicMaterial({color: colour, transparent: true, opacity, side: THREE.DoubleSide,
    depthWrite: false});
  const edges = lineMaterial(colour, edgeOpacity);
  faces.clippingPlanes = edges.clippingPlanes = planes;
  return {faces, edges};
}

/** Polyhedra, each a list of half-spaces. */
function polyhedraMesh(polyhedra, {faces, edges}) {
  const [corners, ends] = [[], []];
  for (const face of polyhedra.map(facesOf).flat()) {
    face.forEach((p, i) => {
      ends.push(p, face[(i + 1) % face.length]);
      if (i > 1) corners.push(face[0], face[i - 1], p);
    });
  }
  const group = new THREE.Group();
  group.add(new THREE.Mesh(new THREE.BufferGeometry().setFromPoints(corners), faces),
    new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(ends), edges));
  for (const part of group.children) part.frustumCulled = false;
  return group;
}
