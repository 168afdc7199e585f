// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

const MOST_NAMES = 40;  // of things: more would hide the world

/**
 * Texts over the canvas: the runs' names above their worlds, start and goal at their places, things that move by their
 * names, frames of close-ups.
 */
class Labels {
  constructor(parent) {
    this.parent = parent;
  }

  build(runs, palette) {
    this.parent.textContent = "";
    this.items = runs.map((run, i) => {
      const name = this.add("name", "");
      const title = document.createElement("b");
      title.textContent = run.name;
      if (runs.length > 1) {
        name.append(runKey(i, palette));
      }
      const rest = document.createElement("span");
      rest.textContent = Labels.summary(run);
      name.append(title, rest);
      const points = [["start", run.start], ["goal", run.goal]].map(([text, [x, y, z]]) =>
        ({label: this.add("point", text), place: new THREE.Vector3(x, y, z)}));
      const things = run.things && run.things.length <= MOST_NAMES ? run.things.map((thing) => {
        const label = this.add("point", thing.name);
        label.style.color = css(thing.fence ? palette.fence : palette.thing);
        return {label, layer: thing.fence ? "fences" : "things"};
      }) : [];
      return {name, points, things, closeup: this.add("closeup", "")};
    });
  }

  add(kind, text) {
    const label = document.createElement("span");
    label.className = kind;
    label.textContent = text;
    this.parent.append(label);
    return label;
  }

  /** The kind of a run and how it ended, and the pitch of the grid that it is drawn on. */
  static summary(run) {
    const fact = (name) => (run.facts.find(([label]) => label === name) || [])[1];
    return [run.kind, fact("status"), fact("duration"), `grid ${gridPitch(run.boundary)} m`].filter(Boolean).join(" · ");
  }

  /** Names and frames follow the cells. */
  layOut(stage) {
    this.items.forEach(({name, closeup}, i) => {
      const {left, top, width} = stage.cell(i);
      name.lastChild.hidden = width < 250;
      Object.assign(name.style, {left: `${left + 8}px`, top: `${top + 4}px`, maxWidth: `${width - 16}px`});
      const inset = stage.closeupOf(i);
      closeup.hidden = inset === null || !stage.views[i].vehicle;
      for (const side of inset ? ["left", "top", "width", "height"] : []) closeup.style[side] = `${inset[side]}px`;
    });
  }

  /** Start, goal and things follow the camera. Small cells go without. */
  move(stage) {
    this.items.forEach(({points, things}, i) => {
      const view = stage.views[i];
      for (const {label, place} of points) Labels.place(stage, i, label, place);
      things.forEach(({label, layer}, k) => {
        Labels.place(stage, i, label, view.layers[layer].visible ? view.things.top(k) : null);
      });
    });
  }

  /** Null: nowhere. */
  static place(stage, i, label, place) {
    const {left, top, width, height} = stage.main(i);
    label.hidden = place === null || stage.follows || width < 280;
    if (label.hidden) return;
    const {x, y} = stage.project(i, place);
    const at = Math.min(Math.max(x, left + 16), left + width - 16);
    label.hidden = x < left || x > left + width || y < top || y > top + height;
    if (!label.hidden) label.style.transform = `translate(-50%, -100%) translate(${Math.round(at)}px, ${Math.round(y) - 8}px)`;
  }
}

/** A short line in the colour of run i. */
function runKey(i, palette) {
  const key = document.createElement("i");
  key.className = "run";
  key.style.borderTop = `4px ${runIsDashed(i, palette) ? "dotted" : "solid"} ${runColour(i, palette)}`;
  return key;
}
