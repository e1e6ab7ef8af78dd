// SPDX-License-Identifier: Apache-2.0
// Orders besides the sticks (GND-35): the laws' gains, and the times of a lost
// link. The aircraft's answer is shown below them.

import { byId, put, say } from "./draw.js";
import { Overlay } from "./overlay.js";

const SHAPE = { waiting: "\u2026 ", taken: "\u2713 ", refused: "\u25c6 ",
  lost: "\u25c6 " };

export class Orders {
  constructor(send) {
    this.overlay = new Overlay("orders", "configure", "close_orders");
    byId("ordering").addEventListener("submit", (event) => {
      event.preventDefault();
      const tenths = (id) => Math.round(Number(byId(id).value) * 10);
      send({ t: "order", table: Number(byId("gains").value),
        orbit: tenths("orbit_after"), end: tenths("end_after") });
      // The keys fly again.
      document.activeElement?.blur();
    });
  }

  draw(order, mine, silent) {
    const { state, text, in_force } = order;
    say(byId("in_force"), silent ? "\u2013\u2013" : in_force);
    const told = byId("ordered");
    say(told, silent ? "no frames: not known"
      : state === "none" ? "nothing ordered yet"
        : (SHAPE[state] ?? "") + text);
    put(told, "class", silent || state === "refused" || state === "lost"
      ? "caution" : state === "taken" ? "taken" : "");
    const send = byId("send_order");
    send.disabled = !mine || silent || state === "waiting";
    say(byId("who_orders"), mine ? "" : "take the sticks to order");
  }
}
