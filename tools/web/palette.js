// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/**
 * The colours of scene and plots; the page's own are in page.css. One meaning, one colour: green is what is committed
 * and flown, orange its brake, magenta what was dropped, violet the corridor, yellow what the sensor looks at, red what
 * is forbidden, brown what moves, blue how fast was flown. Greys are obstacles and floor: the darker, the surer. tests/page/palette_test.py
 * holds them apart, for colour-blind readers as well.
 */
const PALETTES = {
  light: {
    paper: 0xf4f6f9, fog: 0xcfd6e0, ground: 0xfdfefe, grid: 0xbfc8d4, frame: 0xaab4c2, ink: 0x1c2430,
    known: 0x66738a, ghost: 0x6d7a8e, seen: 0xfdfefe, fresh: 0xb5ddf5, frontier: 0x2f8fd0,
    commit: 0x0a9467, brake: 0xc03406, dropped: 0xe54fa5, corridor: 0x6741d9, sensor: 0xb18900, fence: 0x93170c, thing: 0x5a4b4b,
    search: 0x8a93a0, speeds: [0x3a92d2, 0x1f63bd, 0x0a2a78],
    runs: ["#1668c9", "#c2500a", "#00805a", "#8e3fb0", "#9a7200", "#56606e"], axes: ["#c2410c", "#00805a", "#1668c9"],
  },
  dark: {
    paper: 0x0f1318, fog: 0x161b23, ground: 0x2c3747, grid: 0x3d4a5c, frame: 0x4a5869, ink: 0xe8ecf1,
    known: 0x8793a8, ghost: 0x9aa8bc, seen: 0x2c3747, fresh: 0x2f668c, frontier: 0x5cb8f2,
    commit: 0x2fd595, brake: 0xf58a2e, dropped: 0xff90d0, corridor: 0x9c86ff, sensor: 0xffd83a, fence: 0xf84a4a, thing: 0xa57878,
    search: 0x8793a5, speeds: [0x3f86c4, 0x58b0f0, 0x98e6ff],
    runs: ["#6cb0ff", "#ff9a57", "#3fd39a", "#cf9bf0", "#e3bd3a", "#a3afbe"], axes: ["#ff9a57", "#3fd39a", "#6cb0ff"],
  },
};

/** Parts of the scene that can be hidden: name, text, colour, the shape of the swatch, and whether it is shown at first. */
const LAYERS = [
  ["known", "obstacles", "known", "block", true],
  ["ghost", "true obstacles", "ghost", "volume", true],
  ["seen", "seen free", "seen", "area", true],
  ["fences", "fences", "fence", "volume", true],
  ["things", "what moves", "thing", "volume", true],
  ["corridor", "corridor", "corridor", "volume", true],
  ["plan", "committed plan", "commit", "line", true],
  ["brake", "brake", "brake", "line", true],
  ["dropped", "dropped plan", "dropped", "dashes", true],
  ["blocked", "in the way at the end", "fence", "block", true],
  ["path", "path", "ink", "line", false],
  ["sensor", "sensor", "sensor", "volume", true],
  ["flown", "flown", null, "scale", true],
  ["closeup", "close-up", null, null, true],
];

/** The state of a flight at its number, and the colour that it shares with a layer. */
const STATES = [["rest", "search"], ["look", "sensor"], ["fly", "commit"], ["stop", "brake"], ["threat", "fence"]];

function css(hex) {
  return `#${hex.toString(16).padStart(6, "0")}`;
}

/** The colour of run i where there are several. From the seventh on, lines are dashed. */
function runColour(i, palette) {
  return palette.runs[i % palette.runs.length];
}

function runIsDashed(i, palette) {
  return i >= palette.runs.length;
}

/** The colour of part t in [0, 1] of the scale of speeds. */
function speedColour(t, palette) {
  const [slow, middle, fast] = palette.speeds.map((hex) => new THREE.Color(hex));
  return t < 0.5 ? slow.lerp(middle, 2 * t) : middle.lerp(fast, 2 * t - 1);
}
