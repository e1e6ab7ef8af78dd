// SPDX-License-Identifier: Apache-2.0
// Engine, electrical, and the surfaces with command and position.

import { bands, byId, clamp, cross, fixed, html, level, put, say, svg }
  from "./draw.js";
import { isOn, tables } from "./tables.js";

const METERS = [
  ["engine", "rpm", 0, 8190],
  ["battery", "battery_volts", 16, 32],
  ["alternator", "alternator_volts", 16, 32],
  ["load factor", "vertical_acceleration", -2, 6],
  ["forward", "longitudinal_acceleration", -1, 1],
  ["field", "altitude_offset", 0, 5000],
];
const WIDTH = 120;

class Meter {
  constructor(name, item, low, high) {
    this.column = `gsc.downlink.${item}`;
    Object.assign(this, { name: item, low, high });
    this.bands = svg("g");
    this.bar = svg("path", { class: "needle ages", d: "M0 12l-5 8h10z" });
    this.text = html("output", { class: "down", id: item });
    this.row = html("div", { class: "meter down" },
      html("span", { class: "name" }, name),
      svg("svg", { viewBox: `-6 0 ${WIDTH + 12} 20`,
        preserveAspectRatio: "none" },
      svg("rect", { class: "track", x: 0, y: 4, width: WIDTH, height: 8 }),
      this.bands, this.bar, cross(0, 2, WIDTH, 16)),
      this.text);
  }

  at(value) {
    return clamp((value - this.low) / (this.high - this.low), 0, 1) * WIDTH;
  }

  learn(items) {
    this.item = items[this.column];
    this.bands.replaceChildren(...bands(this.item, this.low, this.high).map(
      ([kind, from, to]) => svg("rect", { class: `band ${kind}`,
        x: this.at(from), width: this.at(to) - this.at(from),
        y: kind === "warning" ? 4 : 8, height: kind === "warning" ? 8 : 4 })));
  }

  draw(value, lost, doubted) {
    const now = value[this.column];
    if (lost || now === null || !this.item) {
      say(this.text, `\u2013\u2013 ${this.item?.unit ?? ""}`);
      put(this.text, "class", "down gone");
      put(this.row, "class", "meter down");
      return;
    }
    put(this.text, "class", "down");
    put(this.bar, "transform", `translate(${this.at(now).toFixed(1)} 0)`);
    // A warning has priority over the doubt about its value.
    const beyond = level(this.item, now) || (doubted ? "caution" : "");
    const shape = { warning: "\u25b2 ", caution: "\u25c6 ", "": "" }[beyond];
    say(this.text, shape + fixed(now, this.item.places, 0) + " "
      + this.item.unit);
    put(this.row, "class", `meter down ${beyond}`);
  }
}

// Name, sensor, servo channel, commanding stick.
const SURFACES = [
  ["left\nflap 2", "left_flap_2", "switch8"],
  ["left\nflap 1", "left_flap_1", "switch8"],
  ["left\naileron", "left_aileron", "roll"],
  ["left\nelevator", "left_elevator", "pitch"],
  ["left\nrudder", "left_rudder", "yaw"],
  ["right\nrudder", "right_rudder", "yaw"],
  ["right\nelevator", "right_elevator", "pitch"],
  ["right\naileron", "right_aileron", "roll"],
  ["right\nflap 1", "right_flap_1", "switch8"],
  ["right\nflap 2", "right_flap_2", "switch8"],
];
const HALF = 44;

class Surface {
  constructor(name, sensor, stick) {
    this.column = `gsc.downlink.${sensor}`;
    this.stick = `gsc.uplink.${stick}`;
    this.position = svg("g", { class: "ages" },
      svg("rect", { class: "position", x: -16, y: -2, width: 32,
        height: 4 }));
    this.command = svg("g", {}, svg("path", { class: "picked",
      d: "M10 0l11 -6v12z" }));
    this.text = html("output", { class: "down", id: sensor });
    this.name = sensor;
    // Along the track, so that it covers neither position nor command.
    this.failed = svg("g", { class: "failed ages" },
      svg("path", { d: "M-19 -49l5 9h-10z" }),
      svg("text", { transform: "translate(-15 0) rotate(-90)",
        "text-anchor": "middle" }, "FAILED"));
    const [first, second] = name.split("\n");
    this.box = html("div", { class: "surface" },
      html("span", { class: "name" }, first, html("br"), second),
      svg("svg", { viewBox: "-24 -50 48 100" },
        svg("rect", { class: "track", x: -4, y: -HALF, width: 8,
          height: 2 * HALF }),
        svg("path", { class: "thin", d: "M-12 0h24" }), this.failed,
        svg("g", { class: "down" }, this.position,
          cross(-18, -HALF, 36, 2 * HALF)),
        svg("g", { class: "ages" }, this.command)),
      this.text);
  }

  // The stick's request for this surface: the servo's scale is the sensor's.
  wanted(value, words) {
    const { at_0, at_4095 } = this.item;
    const word = words[this.stick];
    const servo = this.stick.endsWith("switch8")
      ? (isOn(word) ? tables.largest : tables.middle) : word;
    return at_0 + (at_4095 - at_0) * servo / tables.largest;
  }

  at(degrees) {
    const full = Math.max(Math.abs(this.item.at_0), this.item.at_4095);
    return -clamp(degrees / full, -1, 1) * HALF;
  }

  draw(value, words, lost, failed) {
    if (!this.item) return;
    this.box.classList.toggle("has_failed", Boolean(failed) && !lost);
    const asked = this.wanted(value, words);
    put(this.command, "transform",
      `translate(0 ${this.at(asked).toFixed(1)})`);
    const now = value[this.column];
    if (lost || now === null) {
      say(this.text, "\u2013\u2013 deg");
      put(this.text, "class", "down gone");
      return;
    }
    put(this.text, "class", "down");
    put(this.position, "transform", `translate(0 ${this.at(now).toFixed(1)})`);
    say(this.text, `${fixed(now, 1, 5)} deg`);
  }
}

export class Systems {
  constructor() {
    this.meters = METERS.map((meter) => new Meter(...meter));
    byId("engine").append(...this.meters.map((meter) => meter.row));
    this.surfaces = SURFACES.map((surface) => new Surface(...surface));
    const row = html("div", { id: "surface_row" });
    row.append(...this.surfaces.map((surface) => surface.box));
    this.surfaces[5].box.classList.add("gap");
    byId("surfaces").append(row);
  }

  learn(items) {
    for (const meter of this.meters) meter.learn(items);
    for (const surface of this.surfaces) {
      surface.item = items[surface.column];
    }
  }

  draw(value, words, lost, laws) {
    for (const meter of this.meters) {
      meter.draw(value, lost, laws?.not_valid.includes(meter.name));
    }
    for (const surface of this.surfaces) {
      surface.draw(value, words, lost, laws?.failed.includes(surface.name));
    }
  }
}
