// SPDX-License-Identifier: Apache-2.0
// The pilot's input: mouse, keyboard or gamepad, 50 times a second.
// GND-22: nothing is sent while this page cannot fly; GND-50: the function of
// each switch; GND-51: old input does not count.

import { byId, clamp, fixed, html, put, say, signed, svg } from "./draw.js";
import { Gamepads, isMapped } from "./gamepads.js";
import { PadPanel } from "./padpanel.js";
import { store, stored } from "./stored.js";
import { isOn, tables } from "./tables.js";

const PERIOD = 20;
const KEY_RATE = 2.5;
const KEY_PART = 0.5;
const LEVER_RATE = 0.5;
const PAD = 60;
// Input older than this, from a hung browser or a queued key, is dropped.
const OLD = 500;
// Without a state of the station for this time, no sticks are sent.
const DEAF = 1000;

// The place of switch 5.
const CARD_SWITCH = 4;

export const KEYS = [
  ["\u2190 \u2192", "roll; with Shift all the way"],
  ["\u2191 \u2193", "pitch: down is back, nose up"],
  ["A D", "yaw"], ["W S", "throttle"], ["B", "brake, while held"],
  ["1 to 8", "switches"], ["G", "gamepads: choose one, map it"],
  ["T H X", "take, hand to the pilot, release the sticks"],
  ["Y N", "give, keep the sticks when asked"],
  ["M", "write a mark; Enter sets it, Esc leaves it"],
  ["K", "acknowledge all alerts"], ["L", "light or dark"],
  ["C", "orders: gains of the laws, times of a lost link"],
  ["F E", "test cards; end the running one"],
  ["R", "flight recorder: fetch it after the landing"],
];
const BUTTONS = [
  ["right stick", "roll, pitch"],
  ["left stick, sideways", "yaw"],
  ["left stick, up and down", "moves the throttle"],
  ["right trigger", "brake"],
  ["buttons 1, 2, 3, 5", "switches 1, 2, 3, 4"],
  ["pad left, right (14, 15)", "switches 5, 6"],
  ["buttons 4, 0", "switches 7, 8"],
  ["start (9), back (8)", "take, release the sticks"],
];

const centred = (part) => clamp(
  Math.round(tables.middle * (1 + part)), 0, tables.largest);

function pad(name, across, along) {
  const ring = svg("circle", { class: "ring", r: 7 });
  const dot = svg("circle", { class: "dot ages", r: 4 });
  const root = svg("svg", { viewBox: "-68 -68 136 136", id: name },
    svg("rect", { class: "pad", x: -66, y: -66, width: 132, height: 132,
      rx: 4 }),
    svg("path", { class: "thin", d: "M-66 0h132M0 -66v132" }), dot, ring);
  const text = html("output", { id: `${name}_text` });
  const figure = html("figure", {}, root,
    html("figcaption", {}, `${across}, ${along}`, html("br"), text));
  return { root, ring, dot, text, figure };
}

export class Hands {
  constructor(say_to_station) {
    this.send = say_to_station;
    this.holding = false;
    this.there = false;
    this.blocked = "";
    this.pad_used = false;
    this.stick = { roll: 0, pitch: 0, yaw: 0, throttle: 0, brake: 0,
      switches: Array(8).fill(false) };
    this.keyed = { roll: 0, pitch: 0, yaw: 0 };
    this.keys = new Set();
    this.dragged = new Map();
    this.ticked = performance.now();
    this.heard = performance.now();
    this.gamepads = new Gamepads((what, name) => {
      this.send({ t: "gamepad", what, name });
    });
    this.panel = new PadPanel(this.gamepads);
    this.zone = clamp(Number(stored("zone", "8")), 0, 30);
    this.asked = false;
    this.narrow = matchMedia("(max-width: 899px)");
    this.narrow.addEventListener("change", () => {
      if (this.narrow.matches && this.holding) this.send({ t: "release" });
    });
    this.build();
    this.listen();
    setInterval(() => this.tick(), PERIOD);
  }

  build() {
    this.left = pad("left_stick", "yaw", "throttle");
    this.right = pad("right_stick", "roll", "pitch");
    this.brake = svg("svg", { viewBox: "-12 -68 24 136", id: "brake_lever" },
      svg("rect", { class: "pad", x: -10, y: -66, width: 20, height: 132,
        rx: 4 }));
    this.brakeDot = svg("rect", { class: "dot ages", x: -9, width: 18,
      height: 4 });
    this.brakeRing = svg("path", { class: "ring", d: "M-10 0h20" });
    this.brake.append(this.brakeDot, this.brakeRing);
    this.brakeText = html("output", { id: "brake_text" });
    byId("sticks").append(this.left.figure, this.right.figure,
      html("figure", {}, this.brake,
        html("figcaption", {}, "brake", html("br"), this.brakeText)));
    this.drag(this.left.root, (x, y) => ({ yaw: x, throttle: (1 - y) / 2 }),
      ["yaw"]);
    this.drag(this.right.root, (x, y) => ({ roll: x, pitch: y }),
      ["roll", "pitch"]);
    this.drag(this.brake, (_, y) => ({ brake: (1 - y) / 2 }), []);
    this.switches = [];
    const grid = html("div", { id: "switch_grid" });
    for (let number = 1; number <= 8; number++) {
      const state = html("span", { class: "state" }, "off");
      const button = html("button", { type: "button", class: "switch",
        id: `switch${number}` },
      html("span", { class: "name" }), html("span", { class: "note" }), state);
      button.addEventListener("click", (event) => {
        if (!isOld(event)) this.flip(number - 1);
      });
      this.switches.push({ button, state, name: button.children[0],
        note: button.children[1] });
      grid.append(button);
    }
    byId("switches").append(grid);
    const rows = (id, list) => byId(id).append(...list.map(([key, does]) =>
      html("tr", {}, html("td", {}, key), html("td", {}, does))));
    rows("key_rows", KEYS);
    rows("pad_rows", BUTTONS);
    const zone = byId("zone");
    zone.value = String(this.zone);
    const shown = () => say(byId("zone_shown"), `${this.zone} %`);
    zone.addEventListener("input", () => {
      this.zone = Number(zone.value);
      store("zone", zone.value);
      shown();
    });
    shown();
  }

  // A new connection: the station knows nothing of this page yet.
  met() {
    this.there = true;
    this.gamepads.met();
  }

  // A test card runs while switch 5 is on (D-96).
  endCard() {
    if (this.holding) this.stick.switches[CARD_SWITCH] = false;
  }

  // The function of each switch, from the station's table of items.
  learn(switches) {
    this.uses = switches;
    this.switches.forEach(({ name }, number) =>
      say(name, `${number + 1} ${switches[number].use}`));
    this.panel.learn(switches);
  }

  drag(root, to, back) {
    const at = (event) => {
      const place = root.getScreenCTM().inverse();
      const point = new DOMPoint(event.clientX, event.clientY)
        .matrixTransform(place);
      return to(clamp(point.x / PAD, -1, 1), clamp(point.y / PAD, -1, 1));
    };
    root.addEventListener("pointerdown", (event) => {
      // Another button opens a menu, and the page does not see its release.
      if (!this.holding || isOld(event) || event.button !== 0) return;
      root.setPointerCapture(event.pointerId);
      this.dragged.set(root, at(event));
    });
    const end = () => {
      if (this.dragged.delete(root)) {
        for (const axis of back) this.stick[axis] = 0;
      }
    };
    root.addEventListener("pointermove", (event) => {
      // The button was released where the page did not see it.
      if (event.buttons === 0) end();
      if (this.dragged.has(root)) this.dragged.set(root, at(event));
    });
    root.addEventListener("pointerup", end);
    root.addEventListener("pointercancel", end);
    root.addEventListener("lostpointercapture", end);
    addEventListener("blur", end);
  }

  listen() {
    addEventListener("keydown", (event) => this.key(event));
    addEventListener("keyup", (event) => {
      this.keys.delete(named(event));
      // Some systems hide the release of a key while this one is held. A key
      // that is still held repeats.
      if (event.key === "Meta") this.keys.clear();
    });
    // A menu takes the keys, and the page does not see their release.
    addEventListener("contextmenu", (event) => {
      this.keys.clear();
      if (this.holding && !event.target.matches?.("input")) {
        event.preventDefault();
      }
    });
    addEventListener("blur", () => this.keys.clear());
    // When the page is hidden, for whatever reason, its sticks fall silent.
    document.addEventListener("visibilitychange", () => {
      this.ticked = performance.now();
      if (document.hidden) this.leave("hidden");
      else this.letGo();
    });
    addEventListener("pagehide", () => this.leave("hidden"));
    document.addEventListener("freeze", () => this.leave("hidden"));
  }

  // Held keys and mouse buttons are released.
  letGo() {
    this.keys.clear();
    this.dragged.clear();
    Object.assign(this.keyed, { roll: 0, pitch: 0, yaw: 0 });
    Object.assign(this.stick, { roll: 0, pitch: 0, yaw: 0 });
    this.gamepads.rearm();
  }

  leave(what) {
    this.letGo();
    if (this.holding) this.send({ t: "lost", what });
  }

  key(event) {
    if (event.target.matches?.(
      "input[type=range], #mark, #orders input, #orders select,"
      + " #recorder input")) return;
    if (isOld(event)) return;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const key = named(event);
    const once = !event.repeat;
    const actions = { t: () => this.take(), h: () => this.send({ t: "pilot" }),
      x: () => this.send({ t: "release" }),
      y: () => this.answer(true), n: () => this.answer(false),
      g: () => this.panel.overlay.turn() };
    if (key in actions) {
      if (once) actions[key]();
    } else if (/^[1-8]$/.test(key)) {
      if (once) this.flip(Number(key) - 1);
    } else if (/^(arrow.*|[adwsb])$/.test(key)) {
      this.keys.add(key);
      this.shift = event.shiftKey;
      if (this.holding) event.preventDefault();
    }
  }

  take() {
    if (this.narrow.matches) return;
    if (this.holding) {
      // The gamepad is gone: mouse and keys continue.
      this.blocked = "";
      this.pad_used = false;
    } else {
      this.send({ t: "take" });
    }
  }

  answer(yes) {
    if (this.asked) this.send({ t: "answer", yes });
  }

  flip(number) {
    if (!this.holding) return;
    this.stick.switches[number] = !this.stick.switches[number];
  }

  // The station's report about the sticks.
  state(state, console_number, words) {
    const mine = state.holder === console_number;
    this.asked = mine && state.asker !== null;
    if (mine && !this.holding) {
      // Starts from the present sticks: taking them moves nothing.
      const part = (name) => words[`console.${name}`] / tables.middle - 1;
      Object.assign(this.stick, { roll: 0, pitch: 0, yaw: 0,
        throttle: (words["console.throttle"] ?? 0) / tables.largest,
        brake: Math.max(0, part("brake") || 0) });
      this.stick.switches = this.stick.switches.map((_, number) =>
        isOn(words[`console.switch${number + 1}`]));
      this.blocked = "";
      this.pad_used = false;
      this.letGo();
    }
    this.holding = mine;
  }

  tick() {
    const now = performance.now();
    const hung = now - this.ticked > OLD && !document.hidden;
    this.ticked = now;
    if (hung) {
      // Keys that were released meanwhile are handled before the next tick.
      if (this.holding) this.send({ t: "lost", what: "hung" });
      return;
    }
    // Changes of gamepads are reported, so a station must be connected.
    if (!this.there) return;
    const pad = this.gamepads.poll();
    if (pad !== null && this.panel.isMapping) this.gamepads.rearm();
    const down = pad === null ? [] : this.gamepads.down(pad);
    if (down.includes("take") && !this.holding && !document.hidden) this.take();
    if (!this.holding || now - this.heard > DEAF) return;
    const second = PERIOD / 1000;
    if (this.pad_used && pad === null && this.blocked === "") {
      this.blocked = "gamepad";
      this.send({ t: "lost", what: "gamepad" });
    } else if (this.blocked === "gamepad" && pad !== null) {
      this.blocked = "";
    }
    if (this.blocked || document.hidden) return;
    const held = (key) => this.keys.has(key) ? 1 : 0;
    const most = this.shift ? 1 : KEY_PART;
    for (const [axis, more, less] of [["roll", "arrowright", "arrowleft"],
      ["pitch", "arrowdown", "arrowup"], ["yaw", "d", "a"]]) {
      const wanted = (held(more) - held(less)) * most;
      const step = KEY_RATE * second;
      this.keyed[axis] += clamp(wanted - this.keyed[axis], -step, step);
    }
    let lever = held("w") - held("s");
    let brake = held("b");
    const axes = { roll: 0, pitch: 0, yaw: 0 };
    const stick = this.stick;
    let met = null;
    if (pad !== null && !this.panel.isMapping) {
      const zone = this.zone / 100;
      for (const axis of ["roll", "pitch", "yaw"]) {
        axes[axis] = this.gamepads.centred(pad, axis, zone);
      }
      if (this.gamepads.isLever("throttle")) {
        // The keys have moved the throttle away from the lever.
        if (lever) this.gamepads.armed.delete("throttle");
        else met = this.gamepads.lever(pad, "throttle", stick.throttle);
      } else {
        const moved = this.gamepads.centred(pad, "throttle", zone);
        if (moved) this.pad_used = true;
        lever += moved;
      }
      const pressed = this.gamepads.brake(pad);
      brake = Math.max(brake, pressed);
      this.buttons(down);
      if (axes.roll || axes.pitch || axes.yaw || pressed || met !== null) {
        this.pad_used = true;
      }
    }
    this.waits = pad === null ? []
      : this.gamepads.waiting(pad, this.zone / 100, stick.throttle);
    for (const axis of ["roll", "pitch", "yaw"]) {
      stick[axis] = clamp(this.keyed[axis] + axes[axis], -1, 1);
    }
    stick.throttle = met
      ?? clamp(stick.throttle + lever * LEVER_RATE * second, 0, 1);
    if (brake > 0 || this.braked) stick.brake = brake;
    this.braked = brake > 0;
    for (const part of this.dragged.values()) Object.assign(stick, part);
    this.send({ t: "sticks", words: this.words() });
  }

  buttons(down) {
    for (const name of down) {
      this.pad_used = true;
      if (name.startsWith("switch")) this.flip(Number(name.slice(6)) - 1);
      if (name === "release") this.send({ t: "release" });
    }
  }

  words() {
    const stick = this.stick;
    return [centred(stick.roll), centred(stick.pitch), centred(stick.yaw),
      Math.round(stick.throttle * tables.largest),
      centred(stick.brake),
      ...stick.switches.map((on) => (on ? tables.largest : 0))];
  }

  draw(value, words, silent, laws) {
    const part = (name) => (value[`gsc.uplink.${name}`] ?? 0) / 100;
    const percent = (name) => value[`gsc.uplink.${name}`] ?? 0;
    put(this.right.dot, "transform",
      `translate(${part("roll") * PAD} ${part("pitch") * PAD})`);
    put(this.left.dot, "transform", `translate(${part("yaw") * PAD} `
      + `${PAD - part("throttle") * 2 * PAD})`);
    put(this.brakeDot, "y",
      String(PAD - 2 - Math.max(0, part("brake")) * 2 * PAD));
    if (silent) {
      for (const text of [this.right.text, this.left.text, this.brakeText]) {
        say(text, "\u2013\u2013 %");
      }
    } else {
      this.tell(percent);
    }
    const rings = [this.left.ring, this.right.ring, this.brakeRing];
    for (const ring of rings) {
      put(ring, "visibility", this.holding ? "visible" : "hidden");
    }
    const stick = this.stick;
    put(this.right.ring, "transform",
      `translate(${stick.roll * PAD} ${stick.pitch * PAD})`);
    put(this.left.ring, "transform", `translate(${stick.yaw * PAD} `
      + `${PAD - stick.throttle * 2 * PAD})`);
    put(this.brakeRing, "transform",
      `translate(0 ${PAD - stick.brake * 2 * PAD})`);
    byId("sticks").classList.toggle("mine", this.holding);
    this.switches.forEach(({ button, state, note }, number) => {
      const up = isOn(words[`gsc.uplink.switch${number + 1}`]);
      const picked = this.holding ? stick.switches[number] : up;
      button.classList.toggle("on", picked);
      button.disabled = !this.holding;
      say(state, silent ? "\u2013\u2013" : (picked ? "on" : "off")
        + (picked !== up ? ", on its way" : ""));
      // A switch of the laws has no effect while they are off.
      const idle = laws !== "on" && this.uses?.[number].works === "laws";
      say(note, !idle ? "" : silent || laws === "unknown"
        ? "laws: not known" : "laws off");
      button.classList.toggle("idle", idle);
    });
    say(byId("pad_name"), this.padTold());
    this.panel.draw();
  }

  // The sent values, in digits.
  tell(percent) {
    say(this.right.text, `${signed(percent("roll"), 0, 4)} % `
      + `${signed(percent("pitch"), 0, 4)} %`);
    say(this.left.text, `${signed(percent("yaw"), 0, 4)} % `
      + `${fixed(percent("throttle"), 0, 3)} %`);
    say(this.brakeText, `${fixed(Math.max(0, percent("brake")), 0, 3)} %`);
  }

  // The state of the gamepad, in a few words.
  padTold() {
    const { chosen, lost } = this.gamepads;
    if (chosen !== null) return chosen.id + (lost ? " (lost)" : "");
    const pads = this.gamepads.all();
    return pads.length === 0 ? "no gamepad: press one of its buttons"
      : pads.length > 1 ? "several gamepads: press G to choose one"
        : `${pads[0].id}: press G to map it`;
  }

  // The source of the sticks, for their holder.
  source() {
    const pads = this.gamepads.all();
    const others = pads.filter((pad) => !this.gamepads.isChosen(pad));
    const { chosen, lost } = this.gamepads;
    if (this.holding && this.blocked === "gamepad") {
      return ["caution", "\u25c6 gamepad lost, no sticks go up: plug it in,"
        + ` or press T for mouse and keyboard${others.length > 0
          ? "; another one is there: G" : ""}`];
    }
    if (chosen === null && pads.length > 0) {
      return ["caution", pads.length > 1
        ? "\u25c6 several gamepads: press G to choose one"
        : isMapped(pads[0]) ? ""
          : "\u25c6 gamepad not mapped, not used: press G"];
    }
    const flying = pads.find((pad) => this.gamepads.isChosen(pad));
    if (flying !== undefined && !isMapped(flying)) {
      return ["caution", "\u25c6 gamepad not mapped any more, not used:"
        + " press G"];
    }
    if (lost && others.length > 0) {
      return ["caution", "\u25c6 another gamepad, not used: press G to"
        + " choose it"];
    }
    if (!this.holding) return ["", ""];
    if (this.waits?.length > 0) {
      return ["caution", `\u25c6 gamepad: ${this.waits.join(", ")}`];
    }
    return ["", chosen !== null && !lost ? "by gamepad, mouse, keyboard"
      : "by mouse and keyboard"];
  }
}

const named = (event) => event.key.toLowerCase();

// It waited in the queue of a hung browser.
const isOld = (event) => performance.now() - event.timeStamp > OLD;
