// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** The key to the scene. Each entry shows or hides its part of it. */
class Legend {
  /** Calls `onChange` when something is to be shown or hidden. */
  constructor(parent, onChange) {
    this.parent = parent;
    this.onChange = onChange;
    this.hidden = new Set(LAYERS.filter(([, , , , shown]) => !shown).map(([name]) => name));
  }

  shows(name) {
    return !this.hidden.has(name);
  }

  build(views, palette, fastest) {
    this.parent.textContent = "";
    const there = (name) => (name === "closeup" ? views.some((view) => view.vehicle)
      : views.some((view) => view.layers[name]));
    const hasFilm = views.some((view) => view.film);
    for (const [name, text, colour, shape] of LAYERS) {
      if (!there(name)) continue;
      const label = document.createElement("label");
      const box = document.createElement("input");
      box.type = "checkbox";
      box.checked = this.shows(name);
      box.dataset.layer = name;
      box.addEventListener("change", () => {
        if (box.checked) this.hidden.delete(name); else this.hidden.add(name);
        this.onChange(name);
      });
      label.append(box);
      if (shape) label.append(Legend.swatch(shape, palette, palette[colour]));
      const known = name === "known" && hasFilm ? "known obstacles" : text;
      label.append(name === "flown" ? `${hasFilm ? "flown" : "plan"}, 0 to ${fastest.toFixed(1)} m/s` : known);
      this.parent.append(label);
    }
  }

  static swatch(shape, palette, colour) {
    const swatch = document.createElement("i");
    swatch.className = `swatch ${shape}`;
    if (shape === "scale") {
      swatch.style.background = `linear-gradient(to right, ${palette.speeds.map(css).join(", ")})`;
    } else {
      swatch.style.color = css(colour);
    }
    return swatch;
  }
}
