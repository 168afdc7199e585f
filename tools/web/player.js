// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
"use strict";

/** The time that is shown: it plays, pauses and can be set. */
class Player {
  constructor(onChange) {
    this.onChange = onChange;
    this.time = 0;
    this.end = 1;
    this.speed = 1;
    this.playing = false;
  }

  setEnd(end) {
    this.end = Math.max(end, 1e-3);
    this.set(Math.min(this.time, this.end));
  }

  set(time) {
    this.time = Math.min(Math.max(time, 0), this.end);
    this.onChange();
  }

  toggle() {
    if (!this.playing && this.time >= this.end) this.time = 0;
    this.playing = !this.playing;
    this.onChange();
  }

  /** Moves on by `seconds` of the clock on the wall. */
  advance(seconds) {
    if (!this.playing) return;
    const time = this.time + this.speed * seconds;
    if (time >= this.end) this.playing = false;
    this.set(time);
  }
}
