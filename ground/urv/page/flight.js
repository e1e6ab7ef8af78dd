// SPDX-License-Identifier: Apache-2.0
// Attitude indicator and tapes.

import { bands, byId, clamp, cross, fixed, level, put, signed, svg, say }
  from "./draw.js";

const DEGREE = 6;
const SHAPE = { warning: "\u25b2", caution: "\u25c6", "": "" };
const BANKS = [10, 20, 30, 45, 60];

function ladder() {
  const lines = svg("g");
  for (let pitch = -90; pitch <= 90; pitch += 5) {
    if (pitch === 0) continue;
    const half = pitch % 10 === 0 ? 46 : 22;
    const y = -pitch * DEGREE;
    // Below the horizon the lines are broken.
    const line = svg("path", { class: "tick", d: `M${-half} ${y}h${2 * half}` });
    if (pitch < 0) line.setAttribute("stroke-dasharray", "8 5");
    lines.append(line);
    if (pitch % 10 === 0) {
      for (const side of [-1, 1]) {
        lines.append(svg("text", { x: side * (half + 16), y: y + 5,
          "text-anchor": "middle" }, String(Math.abs(pitch))));
      }
    }
  }
  return lines;
}

function bankScale() {
  const scale = svg("g");
  const radius = 128;
  const at = (degrees, r) => {
    const angle = (degrees - 90) * Math.PI / 180;
    return [r * Math.cos(angle), r * Math.sin(angle)];
  };
  const [x, y] = at(60, radius);
  scale.append(svg("path", { class: "tick",
    d: `M${-x} ${y}A${radius} ${radius} 0 0 1 ${x} ${y}` }));
  for (const bank of BANKS) {
    for (const side of [-1, 1]) {
      const [x0, y0] = at(side * bank, radius);
      const [x1, y1] = at(side * bank, radius + (bank % 30 ? 7 : 13));
      scale.append(svg("path", { class: "tick",
        d: `M${x0} ${y0}L${x1} ${y1}` }));
    }
  }
  scale.append(svg("path", { class: "white",
    d: `M0 ${-radius}l-8 -14h16z` }));
  return scale;
}

// Label and digits of one value in a corner of the attitude indicator.
class Corner {
  constructor(label, across, along) {
    Object.assign(this, { across, along });
    this.value = svg("text", { x: 104, y: 15, "text-anchor": "end" });
    this.group = svg("g", { class: "ages corner" },
      svg("rect", { class: "plate", rx: 3, width: 109, height: 20 }),
      svg("text", { x: 5, y: 15 }, label), this.value);
  }

  layout(width, height) {
    const x = this.across < 0 ? -width / 2 + 4 : width / 2 - 113;
    const y = this.along < 0 ? -height / 2 + 4 : height / 2 - 24;
    put(this.group, "transform", `translate(${x} ${y})`);
  }
}

// Draws an instrument again for the size of its panel.
function fit(panel, instrument) {
  new ResizeObserver(() => {
    if (panel.clientWidth > 0) {
      instrument.layout(panel.clientWidth, panel.clientHeight);
    }
  }).observe(panel);
}

class Attitude {
  constructor() {
    this.pitching = svg("g", {},
      svg("rect", { class: "sky", x: -1500, y: -2000, width: 3000,
        height: 2000 }),
      svg("rect", { class: "ground", x: -1500, y: 0, width: 3000,
        height: 2000 }),
      svg("path", { class: "tick", d: "M-1500 0h3000",
        "stroke-width": 2.5 }));
    this.rolling = svg("g", {}, this.pitching);
    // The ladder keeps clear of the scale above and the ball below.
    this.rungs = ladder();
    this.turning = svg("g", {}, this.rungs);
    this.bank = svg("path", { class: "white", d: "M0 -126l-8 14h16z" });
    this.path = svg("g", { class: "path" },
      svg("circle", { r: 8 }), svg("path", { d: "M-8 0h-14M8 0h14M0 -8v-9" }));
    this.ball = svg("circle", { class: "white", r: 8, cy: 124 });
    const plane = "M-95 0h55l0 12M95 0h-55l0 12M0 -2v4";
    this.corners = {
      pitch: new Corner("pitch", -1, -1), bank: new Corner("bank", 1, -1),
      alpha: new Corner("alpha", -1, 1), beta: new Corner("beta", 1, 1) };
    this.turn = svg("rect", { class: "white", y: 94, height: 7, width: 0 });
    this.turnText = svg("text", { x: 0, y: 89, "text-anchor": "middle",
      class: "turn" });
    this.cross = svg("g");
    this.root = svg("svg", {},
      svg("clipPath", { id: "ladder_window" },
        svg("rect", { x: -108, y: -108, width: 216, height: 180 })),
      svg("g", { class: "ages" }, this.rolling,
        svg("g", { "clip-path": "url(#ladder_window)" }, this.turning),
        bankScale(), this.bank,
        svg("rect", { class: "plate", x: -66, y: 76, width: 132, height: 30,
          rx: 3 }),
        svg("path", { class: "tick", d: "M-45 92v11M45 92v11M0 92v11" }),
        this.turn, this.turnText,
        svg("path", { class: "edge", d: plane }),
        svg("path", { class: "plane", d: plane }), this.path,
        svg("rect", { class: "tube", x: -62, y: 114, width: 124, height: 20,
          rx: 10 }),
        this.ball,
        svg("path", { class: "tick", d: "M-10 114v20M10 114v20" })),
      ...Object.values(this.corners).map((corner) => corner.group),
      this.cross);
    const panel = byId("attitude");
    panel.append(this.root);
    fit(panel, this);
  }

  layout(across, along) {
    const ratio = across / along;
    const width = Math.max(234, 300 * ratio);
    const height = width / ratio;
    put(this.root, "viewBox", `${-width / 2} ${-height / 2} ${width} ${height}`);
    for (const corner of Object.values(this.corners)) {
      corner.layout(width, height);
    }
    this.cross.replaceChildren(cross(-width / 2 + 8, -height / 2 + 8,
      width - 16, height - 16));
  }

  draw(value, derived) {
    const roll = value["gsc.downlink.roll_attitude"];
    const pitch = value["gsc.downlink.pitch_attitude"];
    if (roll === null || pitch === null) return;
    const alpha = value["gsc.downlink.alpha"];
    const beta = value["gsc.downlink.beta"];
    for (const rolling of [this.rolling, this.turning]) {
      put(rolling, "transform", `rotate(${-roll})`);
    }
    for (const pitching of [this.pitching, this.rungs]) {
      put(pitching, "transform", `translate(0 ${pitch * DEGREE})`);
    }
    put(this.bank, "transform", `rotate(${-roll})`);
    put(this.path, "transform", `translate(${clamp(beta * DEGREE, -150, 150)} `
      + `${clamp(alpha * DEGREE, -120, 120)})`);
    // The ball is opposite to the lateral force.
    const felt = value["gsc.downlink.lateral_acceleration"];
    put(this.ball, "cx", String(clamp(-felt * 400, -52, 52)));
    const turn = derived.heading_rate;
    const length = clamp(turn * 15, -60, 60);
    put(this.turn, "x", String(Math.min(0, length)));
    put(this.turn, "width", String(Math.abs(length)));
    say(this.turnText, `turn ${side(turn, 1)} deg/s`);
    const { corners } = this;
    say(corners.pitch.value, `${signed(pitch, 1, 5)} deg`);
    say(corners.bank.value, `${side(roll, 1)} deg`);
    say(corners.alpha.value, `${signed(alpha, 1, 5)} deg`);
    say(corners.beta.value, `${side(beta, 1)} deg`);
  }
}

const side = (value, places) =>
  `${Math.abs(value) < 0.05 ? "\u2007" : value > 0 ? "R" : "L"}`
  + fixed(Math.abs(value), places, 4);

// Digits on drums: each turns when the one to its right passes nine.
class Drums {
  constructor(x, y, count, size) {
    this.step = size * 1.25;
    this.drums = [];
    this.group = svg("g", { class: "ages" });
    for (let place = 0; place < count; place++) {
      const drum = svg("g");
      for (let digit = -1; digit <= 10; digit++) {
        drum.append(svg("text", { x: x + place * size * 0.68,
          y: y - digit * this.step + size * 0.37, "font-size": size,
          "text-anchor": "middle", class: "drum" },
        String((digit + 10) % 10)));
      }
      this.drums.push(drum);
      this.group.append(drum);
    }
  }

  show(value) {
    let below = null;
    let unit = 1;
    const known = Math.max(0, value);
    for (let place = this.drums.length - 1; place >= 0; place--) {
      let turned = below === null ? known % 10
        : Math.floor(known / unit) % 10 + Math.max(0, below - 9);
      put(this.drums[place], "transform",
        `translate(0 ${(turned * this.step).toFixed(2)})`);
      // A leading zero is not drawn.
      const leading = place < this.drums.length - 1 && known < unit * 0.999
        && turned < 0.001;
      put(this.drums[place], "visibility", leading ? "hidden" : "inherit");
      below = turned;
      unit *= 10;
    }
  }
}

class Tape {
  constructor(id, column, options) {
    Object.assign(this, options, { column });
    const { per, minor, major, low, high, side, width } = options;
    const panel = byId(id);
    this.moving = svg("g");
    const edge = side === "right" ? width - 34 : 34;
    const out = side === "right" ? -1 : 1;
    for (let mark = low; mark <= high; mark += minor) {
      const long = mark % major === 0;
      const y = -mark * per;
      this.moving.append(svg("path", { class: "tick",
        d: `M${edge} ${y}h${out * (long ? 14 : 8)}` }));
      if (long) {
        this.moving.append(svg("text", { x: edge + out * 20, y: y + 5,
          "text-anchor": side === "right" ? "end" : "start" },
        String(mark)));
      }
    }
    this.bands = svg("g");
    this.moving.append(this.bands);
    this.edge = edge;
    this.out = out;
    this.drums = new Drums(18, 0, options.digits, 24);
    this.value = svg("text", { class: "ages exact",
      "text-anchor": "middle" });
    this.title = svg("text", { class: "small", "text-anchor": "middle" },
      options.title);
    this.window = svg("rect", { x: -40, width: 600 });
    this.cross = svg("g");
    this.root = svg("svg", {},
      svg("clipPath", { id: `${id}_tape` }, this.window),
      svg("clipPath", { id: `${id}_digits` },
        svg("rect", { x: 4, y: -20, width: options.box, height: 40 })),
      svg("g", { "clip-path": `url(#${id}_tape)`, class: "ages" },
        svg("path", { class: "thin", d: `M${edge} -900v1800` }),
        this.moving),
      svg("rect", { class: "box", x: 4, y: -21, width: options.box,
        height: 42, rx: 3 }),
      svg("g", { "clip-path": `url(#${id}_digits)` }, this.drums.group),
      svg("text", { class: "small", x: options.box, y: 16,
        "text-anchor": "end" }, options.unit),
      this.title, this.value, this.cross);
    panel.append(this.root);
    fit(panel, this);
  }

  layout(across, along) {
    // In a narrow panel the tape alone stays.
    this.narrow = this.slim !== undefined && across < 150;
    const width = this.narrow ? this.slim : this.width;
    const height = width * along / across;
    put(this.root, "viewBox", `0 ${-height / 2} ${width} ${height}`);
    put(this.root, "class", this.narrow ? "slim" : "");
    put(this.window, "y", String(-height / 2 + 22));
    put(this.window, "height", String(height - 44));
    const middle = String(this.narrow ? width / 2 : this.middle);
    put(this.title, "x", middle);
    put(this.title, "y", String(-height / 2 + 15));
    put(this.value, "x", middle);
    put(this.value, "y", String(height / 2 - 7));
    this.cross.replaceChildren(cross(6, -height / 2 + 24, width - 12,
      height - 48));
    this.half = height / 2;
    this.beside?.layout(this.half, this.narrow);
  }

  limits(item) {
    this.item = item;
    this.bands.replaceChildren(...bands(item, this.low, this.high).map(
      ([kind, from, to]) => {
        // A caution is half as wide as a warning: a shape, not colour alone.
        const wide = kind === "warning" ? 10 : 5;
        return svg("rect", { class: `band ${kind}`, width: wide,
          x: this.out < 0 ? this.edge : this.edge - wide,
          y: -to * this.per, height: (to - from) * this.per });
      }));
  }

  draw(value) {
    const now = value[this.column];
    if (now === null || now === undefined) return;
    put(this.moving, "transform", `translate(0 ${(now * this.per).toFixed(2)})`);
    this.drums.show(now);
    const beyond = level(this.item, now);
    say(this.value, `${SHAPE[beyond]}${fixed(now, 1, 5)} ${this.unit}`);
    put(this.root, "data-level", beyond);
    put(this.root, "data-value", String(now));
  }
}

class Climb {
  // Beside the altitude: vertical speed.
  constructor(tape) {
    this.needle = svg("rect", { class: "needle", x: 142, width: 7 });
    this.text = svg("text", { class: "ages exact", "text-anchor": "end" });
    this.title = svg("text", { class: "small", x: 186,
      "text-anchor": "end" }, "climb");
    this.scale = svg("g", { class: "scale" });
    for (const speed of [-1500, -1000, -500, 0, 500, 1000, 1500]) {
      const y = -speed * 0.08;
      this.scale.append(svg("path", { class: "tick", d: `M142 ${y}h9` }),
        svg("text", { x: 154, y: y + 4, class: "small" },
          String(Math.abs(speed))));
    }
    this.scale.append(svg("g", { class: "ages" },
      svg("path", { class: "thin", d: "M142 -124v248" }), this.needle));
    tape.root.append(this.scale, this.title, this.text);
    tape.beside = this;
  }

  layout(half, narrow) {
    put(this.text, "x", narrow ? "106" : "186");
    put(this.text, "y", String(half - (narrow ? 24 : 7)));
    put(this.title, "y", String(-half + 15));
  }

  draw(derived) {
    const speed = derived.vertical_speed;
    if (speed === null || speed === undefined) return;
    const y = clamp(speed * 0.08, -124, 124);
    put(this.needle, "y", String(Math.min(0, -y)));
    put(this.needle, "height", String(Math.abs(y)));
    say(this.text, `${signed(speed, 0, 5)} ft/min`);
  }
}

export class Flight {
  constructor() {
    this.attitude = new Attitude();
    this.speed = new Tape("speed", "gsc.downlink.airspeed", {
      title: "airspeed", unit: "kt", per: 4, minor: 5, major: 10, low: 0,
      high: 130, side: "right", width: 118, middle: 59, box: 76, digits: 3 });
    this.height = new Tape("height", "gsc.downlink.altitude", {
      title: "altitude", unit: "ft", per: 0.5, minor: 20, major: 100, low: 0,
      high: 2100, side: "left", width: 190, slim: 110, middle: 52, box: 96,
      digits: 4 });
    this.climb = new Climb(this.height);
  }

  learn(items) {
    this.speed.limits(items["gsc.downlink.airspeed"]);
    this.height.limits(items["gsc.downlink.altitude"]);
  }

  draw(value, derived) {
    this.attitude.draw(value, derived);
    this.speed.draw(value);
    this.height.draw(value);
    this.climb.draw(derived);
  }
}
