// SPDX-License-Identifier: Apache-2.0
// The flying gamepad, and the functions of its axes and buttons (GND-52).
//
// One gamepad is chosen, by name and place. Another one never takes its place:
// the pilot chooses it on the page. A gamepad without the standard mapping is
// used only after the pilot has mapped it; the mapping is kept under its name.
// An axis counts after it has passed through its rest position, a throttle
// lever after it has matched the throttle, a button after it was seen released.

import { clamp } from "./draw.js";
import { store, stored } from "./stored.js";

export const AXES = ["roll", "pitch", "yaw", "throttle", "brake"];
export const BUTTONS = [...Array.from({ length: 8 },
  (_, number) => `switch${number + 1}`), "take", "release"];
const NEEDED = ["roll", "pitch"];

// The place of each function: an axis with its positive sense, or a button.
const STANDARD = {
  roll: { axis: 2, sign: 1 }, pitch: { axis: 3, sign: 1 },
  yaw: { axis: 0, sign: 1 }, throttle: { axis: 1, sign: -1 },
  brake: { button: 7 },
  switch1: { button: 1 }, switch2: { button: 2 }, switch3: { button: 3 },
  switch4: { button: 5 }, switch5: { button: 14 }, switch6: { button: 15 },
  switch7: { button: 4 }, switch8: { button: 0 },
  take: { button: 9 }, release: { button: 8 },
};
const STANDARD_AXES = 4;
const STANDARD_BUTTONS = 16;

const REST = 0.05;
const MET = 0.02;
const MOVED = 0.5;

const nameOf = (pad) => pad.id.slice(0, 200);
const placeOf = (pad) => `${pad.index} ${pad.id}`;

function connected() {
  return [...(navigator.getGamepads?.() ?? [])].filter(
    (one) => one && one.connected);
}

const isCount = (value, below) =>
  Number.isInteger(value) && value >= 0 && value < below;

// True if this gamepad has the place of a function.
function isThere(pad, place) {
  if (place === null || typeof place !== "object") return false;
  return isCount(place.button, pad.buttons.length)
    || (isCount(place.axis, pad.axes.length) && Math.abs(place.sign) === 1);
}

// The pilot's mapping, without invalid entries.
function remembered(pad) {
  let found = null;
  try {
    found = JSON.parse(stored(`pad.${pad.id}`, "null"));
  } catch {
    return null;
  }
  if (found === null || typeof found !== "object") return null;
  const known = [...AXES, ...BUTTONS].filter(
    (name) => isThere(pad, found[name]));
  return Object.fromEntries(known.map((name) => [name, found[name]]));
}

const isStandard = (pad) => pad.mapping === "standard"
  && pad.axes.length >= STANDARD_AXES
  && pad.buttons.length >= STANDARD_BUTTONS;

export const mappingOf = (pad) =>
  remembered(pad) ?? (isStandard(pad) ? STANDARD : {});

export const isMapped = (pad) => {
  const mapping = mappingOf(pad);
  return NEEDED.every((name) => name in mapping);
};

// An axis from -1 to 1 in its positive sense, a button from 0 to 1. Invalid
// values count as none.
export function valueOf(pad, place) {
  if (!place) return null;
  const value = place.button !== undefined
    ? pad.buttons[place.button]?.value
    : place.sign * pad.axes[place.axis];
  return Number.isFinite(value) ? clamp(value, -1, 1) : null;
}

function isPressed(pad, place) {
  if (!place) return false;
  return place.button !== undefined
    ? pad.buttons[place.button]?.pressed === true
    : (valueOf(pad, place) ?? 0) > MOVED;
}

export class Gamepads {
  // A call tell(what, name) sends a report to the station.
  constructor(tell) {
    this.tell = tell;
    this.chosen = null;
    this.lost = false;
    this.told = new Set();
    this.learning = null;
    this.mapping = {};
    this.rearm();
  }

  // No input of the gamepad counts until it has been seen at rest.
  rearm() {
    this.armed = new Set();
    this.last = {};
    this.pressed = new Set(BUTTONS);
  }

  // A new connection to the station: all is reported again.
  met() {
    this.told.clear();
    if (this.chosen !== null && !this.lost) this.tell("chosen", this.chosen.name);
  }

  all() {
    return connected();
  }

  choose(pad) {
    this.chosen = { id: pad.id, name: nameOf(pad), index: pad.index, mapping: pad.mapping,
      axes: pad.axes.length, buttons: pad.buttons.length };
    this.lost = false;
    this.mapping = mappingOf(pad);
    this.rearm();
    this.tell("chosen", nameOf(pad));
  }

  isChosen(pad) {
    const { chosen } = this;
    return chosen !== null && pad.index === chosen.index
      && pad.id === chosen.id && pad.mapping === chosen.mapping
      && pad.axes.length === chosen.axes
      && pad.buttons.length === chosen.buttons;
  }

  once(what, pad) {
    const key = `${what} ${placeOf(pad)}`;
    if (this.told.has(key)) return;
    this.told.add(key);
    this.tell(what, nameOf(pad));
  }

  // The gamepad that flies now, or null.
  poll() {
    const pads = connected();
    if (this.learning !== null) this.learn(pads);
    if (this.chosen === null) {
      for (const pad of pads.filter((one) => !isMapped(one))) {
        this.once("unmapped", pad);
      }
      const [only] = pads;
      if (pads.length === 1 && isMapped(only)) this.choose(only);
      else if (pads.length > 1) for (const pad of pads) this.once("other", pad);
      return null;
    }
    const pad = pads.find((one) => this.isChosen(one)) ?? null;
    if (pad === null) {
      if (!this.lost) {
        this.lost = true;
        this.told.clear();
        this.tell("lost", this.chosen.name);
      }
      for (const other of pads) this.once("other", other);
      return null;
    }
    if (this.lost) {
      this.lost = false;
      this.rearm();
      this.tell("back", nameOf(pad));
    }
    return pad;
  }

  // The value of a stick, from -1 to 1; 0 until it was at rest.
  centred(pad, name, zone) {
    const value = valueOf(pad, this.mapping[name]);
    const before = this.last[name];
    this.last[name] = value;
    if (value === null) {
      this.armed.delete(name);
      return 0;
    }
    const rest = Math.max(zone, REST);
    if (Math.abs(value) <= rest
      || (before !== undefined && before !== null && before * value < 0)) {
      this.armed.add(name);
    }
    if (!this.armed.has(name)) return 0;
    const far = Math.abs(value);
    return far <= zone ? 0 : Math.sign(value) * (far - zone) / (1 - zone);
  }

  isLever(name) {
    return this.mapping[name]?.lever === true;
  }

  // The value of a lever, from 0 to 1; null until it has matched the present
  // value.
  lever(pad, name, now) {
    const place = this.mapping[name];
    const value = valueOf(pad, place);
    if (value === null) {
      this.armed.delete(name);
      return null;
    }
    const at = place.button !== undefined ? value : (value + 1) / 2;
    const before = this.last[name] ?? at;
    this.last[name] = at;
    if (Math.abs(at - now) <= MET || (before - now) * (at - now) < 0) {
      this.armed.add(name);
    }
    return this.armed.has(name) ? at : null;
  }

  // The value of the brake, from 0 to 1; 0 until it was released.
  brake(pad) {
    const place = this.mapping.brake;
    const value = valueOf(pad, place);
    if (value === null) return 0;
    const at = place.button !== undefined ? value : (value + 1) / 2;
    if (at <= REST) this.armed.add("brake");
    return this.armed.has("brake") && at > REST ? at : 0;
  }

  // The buttons pressed since the last call.
  down(pad) {
    const found = [];
    for (const name of BUTTONS) {
      if (!isPressed(pad, this.mapping[name])) {
        this.pressed.delete(name);
      } else if (!this.pressed.has(name)) {
        this.pressed.add(name);
        found.push(name);
      }
    }
    return found;
  }

  // The controls that the pilot must move before they count.
  waiting(pad, zone, throttle) {
    const found = ["roll", "pitch", "yaw"].filter((name) =>
      !this.armed.has(name)
      && Math.abs(valueOf(pad, this.mapping[name]) ?? 0)
        > Math.max(zone, REST)).map((name) => `${name} to the middle`);
    if (this.isLever("throttle") && !this.armed.has("throttle")) {
      found.push(`throttle lever to ${Math.round(throttle * 100)} %`);
    }
    if (this.mapping.brake && !this.armed.has("brake")
      && valueOf(pad, this.mapping.brake) !== null) {
      found.push("release the brake");
    }
    return found;
  }

  // Mapping

  // The next axis or button that moves becomes the place of this function.
  startLearning(pad, name) {
    this.learning = { name, place: placeOf(pad), axes: [...pad.axes],
      pressed: pad.buttons.map((button) => button.pressed) };
  }

  learn(pads) {
    const { name, place, axes, pressed } = this.learning;
    const pad = pads.find((one) => placeOf(one) === place);
    if (pad === undefined) {
      this.learning = null;
      return;
    }
    const axis = pad.axes.findIndex((value, at) =>
      Math.abs(value - axes[at]) > MOVED);
    pad.buttons.forEach((button, at) => {
      if (!button.pressed) pressed[at] = false;
    });
    const button = pad.buttons.findIndex((one, at) =>
      one.pressed && !pressed[at]);
    if (button >= 0 && !["roll", "pitch", "yaw", "throttle"].includes(name)) {
      this.set(pad, name, { button });
    } else if (axis >= 0) {
      this.set(pad, name, { axis, sign: Math.sign(pad.axes[axis] - axes[axis]),
        ...(name === "throttle" ? { lever: true } : {}) });
    }
  }

  // One place has one function.
  set(pad, name, place) {
    this.learning = null;
    const kept = Object.entries(mappingOf(pad)).filter(([other, at]) =>
      other !== name && !(at.button === place.button
        && at.axis === place.axis && (at.axis === undefined
          || AXES.includes(name) || at.sign === place.sign)));
    this.keep(pad, Object.fromEntries([...kept, [name, place]]));
  }

  change(pad, name, change) {
    const mapping = mappingOf(pad);
    if (name in mapping) {
      this.keep(pad, { ...mapping, [name]: { ...mapping[name], ...change } });
    }
  }

  forget(pad) {
    store(`pad.${pad.id}`, "null");
    this.changed(pad);
  }

  keep(pad, mapping) {
    store(`pad.${pad.id}`, JSON.stringify(mapping));
    this.changed(pad);
  }

  // A chosen gamepad that lacks a required function does not fly any more.
  changed(pad) {
    if (!this.isChosen(pad)) return;
    this.mapping = mappingOf(pad);
    this.rearm();
  }
}
