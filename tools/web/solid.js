// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** Where a shader needs to know where on the mesh a fragment lies, and whether it is in front of the vehicle. */
const SOLID_VERTEX = `
  placed = mvPosition.xyz;
  #ifdef USE_INSTANCING
    lift = (instanceMatrix * vec4(transformed, 1.0)).z;
  #else
    lift = transformed.z;
  #endif`;
// A solid thing is cut away where it is nearer than the vehicle and would hide what is within `hole` of its radii. The
// cut is dithered: unlike transparency, that needs no sorting.
const SOLID_FRAGMENT = `
  float eye = length(vehicle.xyz);
  float along = dot(placed, vehicle.xyz) / eye;
  float off = length(placed - vehicle.xyz * (along / eye)) * eye / max(along, 1e-6);
  float dither = fract(52.98 * fract(dot(gl_FragCoord.xy, vec2(0.0671, 0.00584))));
  if (along < eye - (1.2 + 4.0 * dither) * vehicle.w && off < hole * vehicle.w * (0.75 + 0.25 * dither)) discard;`;

/**
 * The material of solid things, a little darker near the floor. `shared`: uniforms of the view, `vehicle` (its place in
 * the camera's frame, and its radius) and `hole`. With `now`, each instance has a `life`: from when until when it is there.
 */
function solidMaterial(colour, [, , z0, , , z1], {vehicle, hole}, now) {
  const material = new THREE.MeshLambertMaterial({color: colour});
  const height = {value: new THREE.Vector2(z0, Math.max(z1 - z0, 1e-6))};
  if (now) material.defines = {LIFE: ""};
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, {vehicle, hole, height, now: now || {value: 0}});
    shader.vertexShader = "varying vec3 placed;\nvarying float lift;\n#ifdef LIFE\nattribute vec2 life;\n" +
      "uniform float now;\n#endif\n" + shader.vertexShader
        .replace("#include <begin_vertex>", "#include <begin_vertex>\n#ifdef LIFE\n" +
          "transformed *= step(life.x, now) * (1.0 - step(life.y, now));\n#endif")
        .replace("#include <project_vertex>", "#include <project_vertex>" + SOLID_VERTEX);
    shader.fragmentShader = "varying vec3 placed;\nvarying float lift;\nuniform vec4 vehicle;\nuniform float hole;\nuniform vec2 height;\n" +
      shader.fragmentShader
        .replace("#include <clipping_planes_fragment>", "#include <clipping_planes_fragment>" + SOLID_FRAGMENT)
        .replace("#include <color_fragment>", "#include <color_fragment>\n" +
          "diffuseColor.rgb *= mix(0.82, 1.0, clamp((lift - height.x) / height.y, 0.0, 1.0));");
  };
  return material;
}

/** One mesh for `count` instances of a shape; `place(i, matrix)` sets the place of each. */
function instances(geometry, material, count, place) {
  const mesh = new THREE.InstancedMesh(geometry, material, count);
  const matrix = new THREE.Matrix4();
  for (let i = 0; i < count; ++i) {
    place(i, matrix);
    mesh.setMatrixAt(i, matrix);
  }
  mesh.frustumCulled = false;
  return mesh;
}

/** Boxes, which are a flat list of lower and upper corners. */
function boxesMesh(flat, material) {
  return instances(new THREE.BoxBufferGeometry(1, 1, 1), material, flat.length / 6, (i, matrix) => {
    const [a, b, c, d, e, f] = flat.slice(6 * i, 6 * i + 6);
    matrix.makeScale(Math.max(d - a, 1e-3), Math.max(e - b, 1e-3), Math.max(f - c, 1e-3));
    matrix.setPosition((a + d) / 2, (b + e) / 2, (c + f) / 2);
  });
}

/** Likewise upright cylinders: x, y, bottom, top, radius. */
function cylindersMesh(flat, material) {
  const geometry = new THREE.CylinderBufferGeometry(1, 1, 1, 20);
  geometry.rotateX(Math.PI / 2);
  return instances(geometry, material, flat.length / 5, (i, matrix) => {
    const [x, y, bottom, top, radius] = flat.slice(5 * i, 5 * i + 5);
    matrix.makeScale(radius, radius, top - bottom);
    matrix.setPosition(x, y, (bottom + top) / 2);
  });
}

/** The edges of boxes, and the rims of cylinders. */
function outlines({boxes, cylinders}, colour, opacity) {
  const ends = [];
  const edge = (...numbers) => ends.push(...numbers);
  for (let i = 0; i < boxes.length; i += 6) {
    const [a, b, c, d, e, f] = boxes.slice(i, i + 6);
    for (const [y, z] of [[b, c], [b, f], [e, c], [e, f]]) edge(a, y, z, d, y, z);
    for (const [x, z] of [[a, c], [a, f], [d, c], [d, f]]) edge(x, b, z, x, e, z);
    for (const [x, y] of [[a, b], [a, e], [d, b], [d, e]]) edge(x, y, c, x, y, f);
  }
  for (let i = 0; i < cylinders.length; i += 5) {
    const [x, y, bottom, top, radius] = cylinders.slice(i, i + 5);
    const at = (k) => [x + radius * Math.cos((Math.PI * k) / 10), y + radius * Math.sin((Math.PI * k) / 10)];
    for (const z of [bottom, top]) for (let k = 0; k < 20; ++k) edge(...at(k), z, ...at(k + 1), z);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(ends, 3));
  const lines = new THREE.LineSegments(geometry,
    new THREE.LineBasicMaterial({color: colour, transparent: true, opacity}));
  lines.frustumCulled = false;
  return lines;
}
