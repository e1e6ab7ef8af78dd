// SPDX-License-Identifier: Apache-2.0
// A panel over the sticks, beside the instruments: the flight continues. One
// is open at a time, for all have the same place (GND-28).

import { byId } from "./draw.js";

const overlays = [];

export class Overlay {
  // closes is called when the panel closes.
  constructor(id, opens, closer, closes = () => {}) {
    this.dialog = byId(id);
    this.closes = closes;
    overlays.push(this);
    byId(opens).addEventListener("click", () => this.turn());
    byId(closer).addEventListener("click", () => this.close());
  }

  get open() {
    return this.dialog.open;
  }

  turn() {
    const was_open = this.open;
    for (const each of overlays) each.close();
    if (!was_open) this.dialog.show();
    // The keys fly again.
    document.activeElement?.blur();
  }

  close() {
    if (!this.open) return;
    this.closes();
    this.dialog.close();
    document.activeElement?.blur();
  }
}

// Esc closes it wherever the keys are; in a note it only leaves the note, and
// in the list of keys it closes that.
addEventListener("keydown", (event) => {
  if (event.key !== "Escape" || event.target.id === "mark"
    || byId("keys").open) return;
  for (const each of overlays) each.close();
});
