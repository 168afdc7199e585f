// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

const TUBE_SIDES = 6;

/**
 * Tubes along lists of points with a colour for each point: WebGL's lines are a pixel wide. Its triangles follow the
 * points. A point's vertices all lie on it; `side` leads to the tube's surface, so that a shader can set the width.
 */
function tubeGeometry(lists, colourOf) {
  const positions = [];
  const sides = [];
  const shades = [];
  const faces = [];
  for (const points of lists) {
    const begin = positions.length / 3;
    const [ahead, side, up] = [new THREE.Vector3(), new THREE.Vector3(0, 1, 0), new THREE.Vector3(0, 0, 1)];
    points.forEach((p, i) => {
      ahead.subVectors(points[Math.min(i + 1, points.length - 1)], points[Math.max(i - 1, 0)]);
      if (ahead.lengthSq() > 1e-12) {
        side.set(-ahead.y, ahead.x, 0);
        if (side.lengthSq() < 1e-12) side.set(0, 1, 0);
        side.normalize();
        up.crossVectors(ahead, side).normalize();
      }
      const colour = colourOf(p, i);
      for (let k = 0; k < TUBE_SIDES; ++k) {
        const angle = (2 * Math.PI * k) / TUBE_SIDES;
        const [c, s] = [Math.cos(angle), Math.sin(angle)];
        positions.push(p.x, p.y, p.z);
        sides.push(c * side.x + s * up.x, c * side.y + s * up.y, c * side.z + s * up.z);
        shades.push(colour.r, colour.g, colour.b);
        if (i === 0) continue;
        const [a, b] = [begin + TUBE_SIDES * i + k, begin + TUBE_SIDES * i + ((k + 1) % TUBE_SIDES)];
        faces.push(a - TUBE_SIDES, b - TUBE_SIDES, a, b - TUBE_SIDES, b, a);
      }
    });
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(positions, 3));
  geometry.setAttribute("side", new THREE.Float32BufferAttribute(sides, 3));
  geometry.setAttribute("color", new THREE.Float32BufferAttribute(shades, 3));
  geometry.setIndex(faces);
  return geometry;
}

/**
 * Of tubes of `radius` metres, but at least `pixels` wide on the screen. `pixel` is a shared uniform: metres that a pixel is
 * wide, for each unit of depth in the camera's frame.
 */
function tubeMaterial(radius, pixels, pixel, options = {}) {
  const material = new THREE.MeshBasicMaterial({vertexColors: THREE.VertexColors, transparent: true, ...options});
  const width = {value: new THREE.Vector2(radius, pixels / 2)};
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, {pixel, width});
    shader.vertexShader = "attribute vec3 side;\nuniform float pixel;\nuniform vec2 width;\n" +
      shader.vertexShader.replace("#include <begin_vertex>",
        "float depth = -(modelViewMatrix * vec4(position, 1.0)).z;\n" +
        "vec3 transformed = position + side * max(width.x, width.y * pixel * depth);");
  };
  return material;
}

/** Drawn after volumes that are see-through, so that these do not change its colours. */
function tubeMesh(geometry, material) {
  const mesh = new THREE.Mesh(geometry, material);
  mesh.renderOrder = 10;
  mesh.frustumCulled = false;
  return mesh;
}

/** Tubes of one colour along lists of points. */
function plainTubes(lists, colour, material) {
  const shade = new THREE.Color(colour);
  return tubeMesh(tubeGeometry(lists.filter((points) => points.length > 1), () => shade), material);
}

/** The dashes of a line: lists of points, `length` metres long and as far apart. */
function dashes(points, length) {
  if (points.length < 2) return [];
  const lists = [];
  let [list, left, drawing] = [[points[0]], length, true];
  for (let i = 1; i < points.length; ++i) {
    let from = points[i - 1];
    for (let rest = from.distanceTo(points[i]); rest > 0; rest = from.distanceTo(points[i])) {
      const part = Math.min(rest, left);
      const to = part === rest ? points[i] : from.clone().lerp(points[i], part / rest);
      if (drawing) list.push(to);
      left -= part;
      from = to;
      if (left > 1e-9) break;
      if (drawing) lists.push(list);
      [list, left, drawing] = [[to], length, !drawing];
    }
  }
  if (drawing && list.length > 1) lists.push(list);
  return lists;
}
