// SPDX-License-Identifier: Apache-2.0
// The hand on the stick: mouse, keyboard or gamepad, 50 times a second.

import { byId, clamp, fixed, html, put, say, signed, svg } from "./draw.js";

const PERIOD = 20;
const KEY_RATE = 2.5;
const KEY_PART = 0.5;
const LEVER_RATE = 0.5;
const PAD = 60;

export const KEYS = [
  ["\u2190 \u2192", "roll; with Shift all the way"],
  ["\u2191 \u2193", "pitch: down is back, nose up"],
  ["A D", "yaw"], ["W S", "throttle"], ["B", "brake, while held"],
  ["1 to 8", "switches"],
  ["T H X", "take, hand to the pilot, disconnect"],
  ["Y N", "give, keep the sticks when asked"],
  ["M", "write a mark; Enter sets it, Esc leaves it"],
  ["K", "acknowledge all alerts"], ["L", "light or dark"],
  ["C", "orders: gains of the laws, times of a lost link"],
];
const BUTTONS = [
  ["right stick", "roll, pitch"],
  ["left stick, sideways", "yaw"],
  ["left stick, up and down", "moves the throttle"],
  ["right trigger", "brake"],
  ["buttons 0, 1, 2, 3", "switches 8, 1, 2, 3"],
  ["start (9), back (8)", "take, disconnect"],
];
const SWITCH_OF = { 0: 7, 1: 0, 2: 1, 3: 2 };
const TAKE_BUTTON = 9;
const DISCONNECT_BUTTON = 8;
const BRAKE_BUTTON = 7;

const centred = (part) => clamp(Math.round(2048 + part * 2048), 0, 4095);

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
    this.blocked = "";
    this.pad_used = false;
    this.stick = { roll: 0, pitch: 0, yaw: 0, throttle: 0, brake: 0,
      switches: Array(8).fill(false) };
    this.keyed = { roll: 0, pitch: 0, yaw: 0 };
    this.keys = new Set();
    this.dragged = new Map();
    this.pressed = new Set();
    this.zone = clamp(Number(stored("zone", "8")), 0, 30);
    this.asked = false;
    this.narrow = matchMedia("(max-width: 899px)");
    this.narrow.addEventListener("change", () => {
      if (this.narrow.matches && this.holding) this.send({ t: "disconnect" });
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
      html("span", { class: "name" },
        number === 8 ? "8 half flaps" : `${number} discrete ${number}`),
      state);
      button.addEventListener("click", () => this.flip(number - 1));
      this.switches.push({ button, state });
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

  drag(root, to, back) {
    const at = (event) => {
      const place = root.getScreenCTM().inverse();
      const point = new DOMPoint(event.clientX, event.clientY)
        .matrixTransform(place);
      return to(clamp(point.x / PAD, -1, 1), clamp(point.y / PAD, -1, 1));
    };
    root.addEventListener("pointerdown", (event) => {
      if (!this.holding) return;
      root.setPointerCapture(event.pointerId);
      this.dragged.set(root, at(event));
    });
    root.addEventListener("pointermove", (event) => {
      if (this.dragged.has(root)) this.dragged.set(root, at(event));
    });
    const end = () => {
      if (this.dragged.delete(root)) {
        for (const axis of back) this.stick[axis] = 0;
      }
    };
    root.addEventListener("pointerup", end);
    root.addEventListener("pointercancel", end);
    root.addEventListener("lostpointercapture", end);
  }

  listen() {
    addEventListener("keydown", (event) => this.key(event));
    addEventListener("keyup", (event) => this.keys.delete(named(event)));
    addEventListener("blur", () => this.keys.clear());
    document.addEventListener("visibilitychange", () => {
      this.keys.clear();
      this.dragged.clear();
      if (document.hidden && this.holding) {
        this.send({ t: "lost", what: "hidden" });
      }
    });
  }

  key(event) {
    if (event.target.matches?.(
      "input[type=range], #mark, #orders input, #orders select")) return;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const key = named(event);
    const once = !event.repeat;
    const actions = { t: () => this.take(), h: () => this.send({ t: "pilot" }),
      x: () => this.send({ t: "disconnect" }),
      y: () => this.answer(true), n: () => this.answer(false) };
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
      // The gamepad is gone: the mouse and the keys go on.
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

  // What the station says of the sticks.
  state(state, console_number, words) {
    const mine = state.holder === console_number;
    this.asked = mine && state.asker !== null;
    if (mine && !this.holding) {
      // From where the sticks are: taking them moves nothing.
      const part = (name) => (words[`console.${name}`] - 2048) / 2048;
      Object.assign(this.stick, { roll: 0, pitch: 0, yaw: 0,
        throttle: (words["console.throttle"] ?? 0) / 4095,
        brake: Math.max(0, part("brake") || 0) });
      this.stick.switches = this.stick.switches.map((_, number) =>
        words[`console.switch${number + 1}`] >= 0x800);
      this.blocked = "";
      this.pad_used = false;
      this.dragged.clear();
    }
    this.holding = mine;
  }

  gamepad() {
    return [...(navigator.getGamepads?.() ?? [])].find(
      (one) => one && one.connected && one.axes.length >= 4) ?? null;
  }

  tick() {
    const pad = this.gamepad();
    this.pad_name = pad?.id ?? "";
    if (!this.holding) return;
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
    if (pad !== null) {
      axes.roll = this.live(pad.axes[2]);
      axes.pitch = this.live(pad.axes[3]);
      axes.yaw = this.live(pad.axes[0]);
      lever -= this.live(pad.axes[1]);
      brake = Math.max(brake, pad.buttons[BRAKE_BUTTON]?.value ?? 0);
      this.buttons(pad);
      if (axes.roll || axes.pitch || axes.yaw) this.pad_used = true;
    }
    const stick = this.stick;
    for (const axis of ["roll", "pitch", "yaw"]) {
      stick[axis] = clamp(this.keyed[axis] + axes[axis], -1, 1);
    }
    stick.throttle = clamp(stick.throttle + lever * LEVER_RATE * second, 0, 1);
    if (brake > 0 || this.braked) stick.brake = brake;
    this.braked = brake > 0;
    for (const part of this.dragged.values()) Object.assign(stick, part);
    this.send({ t: "sticks", words: this.words() });
  }

  // Outside the dead zone, from there on without a step.
  live(axis) {
    const zone = this.zone / 100;
    const far = Math.abs(axis ?? 0);
    return far <= zone ? 0 : Math.sign(axis) * (far - zone) / (1 - zone);
  }

  buttons(pad) {
    pad.buttons.forEach((button, number) => {
      if (!button.pressed) {
        this.pressed.delete(number);
      } else if (!this.pressed.has(number)) {
        this.pressed.add(number);
        this.pad_used = true;
        if (number in SWITCH_OF) this.flip(SWITCH_OF[number]);
        if (number === DISCONNECT_BUTTON) this.send({ t: "disconnect" });
      }
    });
  }

  // The start button takes the sticks, so it is heard before they are held.
  watchStart() {
    const pressed = this.gamepad()?.buttons[TAKE_BUTTON]?.pressed ?? false;
    if (pressed && !this.startPressed && !this.holding) this.take();
    this.startPressed = pressed;
  }

  words() {
    const stick = this.stick;
    return [centred(stick.roll), centred(stick.pitch), centred(stick.yaw),
      Math.round(stick.throttle * 4095),
      Math.round(2048 + stick.brake * 2047),
      ...stick.switches.map((on) => (on ? 4095 : 0))];
  }

  draw(value, words, silent) {
    this.watchStart();
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
    this.switches.forEach(({ button, state }, number) => {
      const up = words[`gsc.uplink.switch${number + 1}`] >= 0x800;
      const picked = this.holding ? stick.switches[number] : up;
      button.classList.toggle("on", picked);
      button.disabled = !this.holding;
      say(state, silent ? "\u2013\u2013" : (picked ? "on" : "off")
        + (picked !== up ? ", on its way" : ""));
    });
    say(byId("pad_name"), this.pad_name
      || "no gamepad: press one of its buttons");
  }

  // What goes up, in digits.
  tell(percent) {
    say(this.right.text, `${signed(percent("roll"), 0, 4)} % `
      + `${signed(percent("pitch"), 0, 4)} %`);
    say(this.left.text, `${signed(percent("yaw"), 0, 4)} % `
      + `${fixed(percent("throttle"), 0, 3)} %`);
    say(this.brakeText, `${fixed(Math.max(0, percent("brake")), 0, 3)} %`);
  }

  // What moves the sticks, for the one who holds them.
  source() {
    if (!this.holding) return ["", ""];
    if (this.blocked === "gamepad") {
      return ["caution", "\u25c6 gamepad lost, no sticks go up: plug it in,"
        + " or press T for mouse and keyboard"];
    }
    return ["", this.pad_name ? `by gamepad, mouse, keyboard`
      : "by mouse and keyboard"];
  }
}

const named = (event) => event.key.toLowerCase();

// A page may be forbidden to keep anything: then it keeps nothing.
export function stored(name, otherwise) {
  try {
    return localStorage.getItem(`urv.${name}`) ?? otherwise;
  } catch {
    return otherwise;
  }
}

export function store(name, value) {
  try {
    localStorage.setItem(`urv.${name}`, value);
  } catch {
    // As good as it gets.
  }
}
