// SPDX-License-Identifier: Apache-2.0
// The panel of the gamepads: the flying one, and the mapping of its controls
// (GND-52).

import { byId, fixed, html, put, say } from "./draw.js";
import { AXES, BUTTONS, isMapped, mappingOf, valueOf } from "./gamepads.js";
import { Overlay } from "./overlay.js";

const MOVES = {
  roll: "move the stick fully to the right",
  pitch: "pull the stick fully back",
  yaw: "move the rudder fully to the right",
  throttle: "move the throttle to full",
  brake: "press or move the brake fully",
};
const LABELS = { take: "take the sticks", release: "release the sticks" };

function told(place) {
  if (!place) return "\u2013";
  if (place.button !== undefined) return `button ${place.button}`;
  return `axis ${place.axis} ${place.sign > 0 ? "+" : "\u2212"}`;
}

export class PadPanel {
  constructor(gamepads) {
    this.gamepads = gamepads;
    this.overlay = new Overlay("gamepads", "choose_pad", "close_pads",
      () => {
        this.gamepads.learning = null;
        this.mapped = null;
      });
    this.uses = [];
    this.mapped = null;
    this.listed = "";
    this.cells = new Map();
    for (const name of [...AXES, ...BUTTONS]) this.cell(name);
  }

  cell(name) {
    const label = html("span", { class: "name" });
    const place = html("output", {});
    const set = html("button", { type: "button", class: "set" }, "set");
    set.addEventListener("click", () => {
      const pad = this.pad();
      if (pad !== undefined) this.gamepads.startLearning(pad, name);
      set.blur();
    });
    const cell = html("div", { class: "function", id: `map_${name}` }, label,
      place, set);
    const changed = { change: null };
    if (AXES.includes(name)) {
      const invert = html("button", { type: "button", class: "invert" },
        "invert");
      invert.addEventListener("click", () => {
        const pad = this.pad();
        const now = pad && mappingOf(pad)[name];
        if (now?.axis !== undefined) {
          this.gamepads.change(pad, name, { sign: -now.sign });
        }
        invert.blur();
      });
      changed.change = invert;
      cell.append(invert);
    }
    if (name === "throttle") {
      const springs = html("input", { type: "checkbox", id: "springs" });
      springs.addEventListener("change", () => {
        const pad = this.pad();
        if (pad) {
          this.gamepads.change(pad, name, { lever: !springs.checked });
        }
        springs.blur();
      });
      changed.springs = springs;
      cell.append(html("label", {}, springs, "springs back"));
    }
    this.cells.set(name, { label, place, set, ...changed });
    byId("pad_map").append(cell);
  }

  // The words of the switches come from the station.
  learn(switches) {
    this.uses = switches.map(({ use }) => use);
    const named = (name) => name.startsWith("switch")
      ? `${name.slice(6)} ${this.uses[Number(name.slice(6)) - 1]}`
      : LABELS[name] ?? name;
    for (const [name, { label }] of this.cells) say(label, named(name));
  }

  // The gamepad that is being mapped.
  pad() {
    return this.gamepads.all().find(
      (one) => `${one.index} ${one.id}` === this.mapped);
  }

  // A gamepad does not fly while it is being mapped.
  get isMapping() {
    return this.overlay.open && this.mapped !== null;
  }

  list(pads) {
    const key = JSON.stringify([this.mapped, this.gamepads.chosen, pads.map(
      (pad) => [pad.index, pad.id, isMapped(pad), this.gamepads.isChosen(pad)]),
    ]);
    if (key === this.listed) return;
    this.listed = key;
    const row = (pad) => {
      const chosen = this.gamepads.isChosen(pad);
      const use = html("button", { type: "button", class: "use" },
        chosen ? "in use" : "use");
      use.disabled = chosen || !isMapped(pad);
      use.addEventListener("click", () => this.gamepads.choose(pad));
      const map = html("button", { type: "button", class: "map" }, "map");
      map.addEventListener("click", () => {
        this.mapped = `${pad.index} ${pad.id}`;
        map.blur();
      });
      const forget = html("button", { type: "button", class: "forget" },
        "forget mapping");
      forget.addEventListener("click", () => {
        this.gamepads.forget(pad);
        this.listed = "";
      });
      return html("li", {}, html("span", { class: "pad_id" },
        `${pad.index}: ${pad.id}`), html("span", { class: isMapped(pad) ? ""
        : "caution" }, isMapped(pad) ? pad.mapping === "standard"
        ? "standard" : "mapped" : "\u25c6 map it first"), use, map, forget);
    };
    byId("pad_list").replaceChildren(...pads.map(row));
  }

  draw() {
    if (!this.overlay.open) return;
    const pads = this.gamepads.all();
    this.list(pads);
    const pad = this.pad();
    byId("pad_map").hidden = pad === undefined;
    const learning = this.gamepads.learning;
    const hint = byId("pad_hint");
    put(hint, "class", learning ? "caution" : "");
    say(hint, learning ? `\u25c6 now ${MOVES[learning.name]
      ?? "press its button"}`
      : pads.length === 0 ? "no gamepad: press one of its buttons"
        : pad !== undefined
          ? `mapping ${pad.index}: set roll and pitch at least; it flies when`
            + " this panel is closed"
          : "the gamepad in use flies; the others do nothing");
    if (pad === undefined) return;
    const mapping = mappingOf(pad);
    for (const [name, { place, set, change, springs }] of this.cells) {
      const value = valueOf(pad, mapping[name]);
      say(place, told(mapping[name]) + (value === null ? ""
        : ` ${fixed(value * 100, 0, 4)} %`));
      set.classList.toggle("now", learning?.name === name);
      if (change) change.disabled = mapping[name]?.axis === undefined;
      if (springs) {
        springs.disabled = mapping[name]?.axis === undefined;
        springs.checked = mapping[name]?.axis !== undefined
          && mapping[name].lever !== true;
      }
    }
  }
}
