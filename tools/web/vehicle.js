// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/**
 * A quadrotor within a ball of the robot's radius: x ahead, y left, z along the thrust. Nose and front rotors have the
 * sensor's colour. Nothing hides it: it is drawn last, on a depth buffer that it clears.
 */
function quadrotor(radius, palette) {
  const group = new THREE.Group();
  const coloured = (color, opacity = 1) => new THREE.MeshLambertMaterial({color, opacity, transparent: true,
    side: THREE.DoubleSide});
  const [dark, front] = [coloured(palette.ink), coloured(palette.sensor)];
  const add = (geometry, material, x, y, z) => {
    const mesh = new THREE.Mesh(geometry, material);
    mesh.position.set(x * radius, y * radius, z * radius);
    mesh.renderOrder = 100 + group.children.length;
    mesh.frustumCulled = false;
    group.add(mesh);
    return mesh;
  };
  const hull = add(new THREE.BoxBufferGeometry(0.6 * radius, 0.36 * radius, 0.2 * radius), dark, 0, 0, 0);
  hull.onBeforeRender = (renderer) => renderer.clearDepth();
  add(new THREE.ConeBufferGeometry(0.17 * radius, 0.36 * radius, 12), front, 0.46, 0, 0).rotation.z = -Math.PI / 2;
  for (const [x, y] of [[-1, 1], [-1, -1], [1, 1], [1, -1]]) {
    const arm = add(new THREE.BoxBufferGeometry(0.75 * radius, 0.09 * radius, 0.09 * radius), dark, 0.27 * x, 0.27 * y, 0);
    arm.rotation.z = Math.atan2(y, x);
    const rotor = add(new THREE.CylinderBufferGeometry(0.36 * radius, 0.36 * radius, 0.035 * radius, 24),
      x > 0 ? front : dark, 0.5 * x, 0.5 * y, 0.12);
    rotor.rotation.x = Math.PI / 2;
  }
  return group;
}

/** What a lidar sees at most: the band of a sphere. `fov`: across and up, rad. */
function bandFaces({range, fov}) {
  const band = new THREE.SphereBufferGeometry(range, 48, 4, 0, 2 * Math.PI, 0.5 * (Math.PI - fov[1]), fov[1]);
  return band.rotateX(Math.PI / 2);
}

/** What the sensor sees at most. A camera: a level pyramid along x, from its eye to its range. Cut off at `planes`. */
function sensorVolume({range, fov}, palette, planes) {
  const group = new THREE.Group();
  const {faces, edges} = volumeMaterials(palette.sensor, 0.1, 0.8, planes);
  if (fov[0] > Math.PI) {
    group.add(new THREE.Mesh(bandFaces({range, fov}), faces));
    return group;
  }
  const [half, high] = fov.map((angle) => range * Math.tan(0.5 * angle));
  const corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([a, b]) => new THREE.Vector3(range, a * half, b * high));
  const eye = new THREE.Vector3();
  const [triangles, ends] = [[], []];
  corners.forEach((corner, i) => {
    const next = corners[(i + 1) % 4];
    triangles.push(eye, corner, next);
    ends.push(eye, corner, corner, next);
  });
  group.add(new THREE.Mesh(new THREE.BufferGeometry().setFromPoints(triangles), faces),
    new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(ends), edges));
  return group;
}
