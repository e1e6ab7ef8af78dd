// SPDX-License-Identifier: Apache-2.0
// The page: receives the station's messages, computes ages (GND-25), draws
// changes.

import { SenderClock } from "./ages.js";
import { Cards } from "./cards.js";
import { byId, html, put, say } from "./draw.js";
import { Flight } from "./flight.js";
import { Hands } from "./hands.js";
import { Orders } from "./orders.js";
import { showAlerts, showLines } from "./panels.js";
import { Recorder } from "./recorder.js";
import { store, stored } from "./stored.js";
import { Systems } from "./systems.js";
import { learn, tables } from "./tables.js";

const OLD_FRAMES = 2;
const LOST = 500;
// States come every 40 ms; a state is late only after this time.
const BETWEEN = 60;
const AGAIN = 500;
const SECOND = 1000;
// Fewer are no news: each busy machine occasionally leaves out one.
const SLOW = 3;
const BARS = 5;
// The version of the messages between page and station.
const PROTOCOL = 2;
// More bytes than this wait in the browser when the network is blocked.
const MOST_WAITING = 4096;

let socket = null;
// The station's first message, kept when the station falls silent.
let hello = null;
let there = false;
let state = null;
let came = 0;
// The waiting time of the newest state at its arrival (GND-56).
let waited = 0;
let clock = new SenderClock();
let closed = performance.now();
let drawing = false;
let told = 0;

// The arrival of each state, and the station's count of omitted ones by then.
const left = [];

// Each message has a number, and the page's time: late input is dropped
// (GND-51). Sticks that cannot be sent now are never sent.
let sequence = 0;

const send = (message) => {
  if (socket?.readyState !== WebSocket.OPEN
    || (hello !== null && hello.protocol !== PROTOCOL)) return;
  if (message.t === "sticks" && socket.bufferedAmount > MOST_WAITING) return;
  sequence += 1;
  socket.send(JSON.stringify({ ...message, sequence,
    sent_ms: Math.round(performance.now() * 10) / 10 }));
};

// The station sends a state only when it knows that there is room for it.
const drawn = () => send({ t: "drawn", number: state.number });

document.addEventListener("visibilitychange", () => {
  if (document.hidden && state !== null) drawn();
});

const flight = new Flight();
const systems = new Systems();
const hands = new Hands(send);
const orders = new Orders(send);
const cards = new Cards(send, hands);
const recorder = new Recorder(send);
const acknowledge = (key) => send({ t: "seen", key });

function connect() {
  socket = new WebSocket(`ws://${location.host}/ws`);
  sequence = 0;
  clock = new SenderClock();
  socket.addEventListener("message", (event) => {
    const message = JSON.parse(event.data);
    if (message.t === "state") {
      state = message;
      came = performance.now();
      waited = clock.age(message.sent_ms ?? came, came);
      hands.heard = came;
      keep_left(message.left_out);
      if (hello) draw_soon();
      // A hidden page is not drawn, but must not be old when it becomes
      // visible.
      if (!hello || document.hidden) drawn();
    } else if (message.t === "hello") {
      hello = message;
      there = true;
      left.length = 0;
      told = 0;
      byId("lines").replaceChildren();
      if (hello.protocol !== PROTOCOL) {
        draw_soon();
        return;
      }
      learn(hello);
      flight.learn(hello.items);
      systems.learn(hello.items);
      hands.learn(hello.switches);
      hands.met();
    } else if (message.t === "alerts") {
      showAlerts(message.alerts, acknowledge);
    } else if (message.t === "log") {
      showLines(message.lines);
    }
  });
  socket.addEventListener("close", () => {
    hands.holding = false;
    hands.there = false;
    if (there) closed = performance.now();
    there = false;
    draw_soon();
    setTimeout(connect, AGAIN);
  });
}

function draw_soon() {
  if (drawing) return;
  drawing = true;
  requestAnimationFrame(() => {
    drawing = false;
    draw();
    if (state !== null && there && state.number !== told) {
      told = state.number;
      drawn();
    }
  });
}

const aged = (age) =>
  age === null ? "never" : age >= LOST ? "lost"
    : age >= OLD_FRAMES * tables.frame_ms ? "old" : "fresh";

function draw() {
  const now = performance.now();
  const late = Math.max(0, now - came + waited - BETWEEN);
  const frame = state === null || state.age_ms === null ? null
    : Math.max(0, state.age_ms - tables.frame_ms) + late;
  const down = state === null || state.down_ms === null ? null
    : state.down_ms + late;
  const body = document.body;
  body.dataset.station = there ? "there" : "lost";
  body.dataset.frame = there ? aged(frame) : "lost";
  body.dataset.down = there ? aged(frame === null ? null : down) : "lost";
  show_lost(now, frame, down, late);
  show_slow();
  if (state === null || state.values === undefined || hello === null) return;
  const value = {};
  const words = {};
  hello.columns.forEach((column, at) => {
    value[column] = state.values[at];
    words[column] = state.words[at];
  });
  hands.state(state, hello.console, words);
  const lost = body.dataset.down === "lost" || body.dataset.down === "never";
  const silent = body.dataset.frame === "lost";
  if (!lost) flight.draw(value, state.derived);
  systems.draw(value, words, lost, state.laws);
  hands.draw(value, words, silent, lost ? "unknown" : state.laws_state);
  show_status(value, lost, silent);
  show_laws(lost);
  show_holder(silent);
  orders.draw(state.order, state.holder === hello.console, silent || !there);
  cards.draw(state.cards, state.holder === hello.console, silent || !there);
  recorder.draw(state.recorder, state.holder === null
    || state.holder === hello.console, there);
  body.dataset.seq = state.seq;
  body.dataset.late = (Date.now() - state.time_us / 1000).toFixed(0);
}

function show_lost(now, frame, down, late) {
  let what = "";
  let why = "";
  let age = null;
  if (hello !== null && hello.protocol !== PROTOCOL) {
    what = "OLD PAGE: RELOAD IT";
  } else if (!there) {
    what = "STATION LOST";
    age = now - closed;
  } else if (frame === null) {
    what = "NO FRAMES YET";
  } else if (frame >= LOST && state.silent_ms + late < LOST) {
    what = "FRAMES LATE";
    why = `by ${(frame / 1000).toFixed(1)} s`;
  } else if (frame >= LOST) {
    what = "NO FRAMES";
    age = frame;
  } else if (state.refusing && state.link !== "heard") {
    what = "LINK REFUSED";
    why = `${state.refused} blocks`;
    age = down;
  } else if (down === null) {
    what = "NO DOWNLINK YET";
  } else if (down >= LOST) {
    what = state.answers ? "SENSORS OLD" : "LINK LOST";
    age = down;
  }
  byId("lost").hidden = what === "";
  say(byId("lost_what"), what);
  say(byId("lost_for"), age === null ? why
    : `${why} for ${(age / 1000).toFixed(1)} s`.trim());
}

const bars = Array.from({ length: BARS }, (_, at) => {
  const bar = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  for (const [name, amount] of Object.entries({ x: at * 9, width: 6,
    y: 12 - at * 3, height: 4 + at * 3 })) bar.setAttribute(name, amount);
  byId("bars").append(bar);
  return bar;
});

function show_status(value, lost, silent) {
  const a_second = SECOND / tables.frame_ms;
  const fresh = silent ? 0 : Math.min(state.fresh, a_second);
  bars.forEach((bar, at) => put(bar, "class",
    fresh > a_second * at / BARS ? "on" : ""));
  say(byId("fresh"), silent ? "--/--" : `${String(fresh).padStart(2, "\u2007")}/`
    + `${a_second}`);
  for (const shown of document.querySelectorAll("output[data-column]")) {
    const column = shown.dataset.column;
    const item = hello.items[column];
    const now = value[column];
    say(shown, lost || now === null ? `\u2013\u2013 ${item.unit}`
      : `${now.toFixed(1).replace("-", "\u2212")} ${item.unit}`);
    shown.classList.toggle("gone", lost);
  }
  say(byId("stick_ms"), silent || state.stick_ms === null ? "\u2013\u2013 ms"
    : `${state.stick_ms.toFixed(0).padStart(3, "\u2007")} ms`);
  say(byId("bad"), String(state.counts.downlink_bad));
  say(byId("scrapped"), String(state.counts.uplink_scrapped));
  say(byId("resets"), String(state.counts.resets));
  const seconds = Math.floor(state.seq / a_second);
  const two = (number) => String(number).padStart(2, "0");
  say(byId("clock"), `${two(Math.floor(seconds / 3600))}:`
    + `${two(Math.floor(seconds / 60) % 60)}:${two(seconds % 60)}`);
  const archive = byId("archive");
  const kept = state.archive === null ? "none" : state.archive.text;
  say(archive, !there ? "\u2013\u2013" : kept.replace(" frames", ""));
  archive.title = kept;
  archive.classList.toggle("caution", state.archive?.lost ?? false);
}

// A hidden page is not drawn, but still receives states: they are not kept.
function keep_left(left_out) {
  left.push([came, left_out]);
  drop_left();
}

function drop_left() {
  const now = performance.now();
  while (left.length > 2 && now - left[1][0] > SECOND) left.shift();
}

// The number of states omitted in the last second, because this page or the
// network is too slow for them: the page still shows the newest.
function show_slow() {
  drop_left();
  const out = there && left.length > 0 ? left.at(-1)[1] - left[0][1] : 0;
  byId("slow").hidden = out < SLOW;
  if (out >= SLOW) {
    say(byId("slow"), `\u25c6 slow page: ${left.length - 1} pictures a second,`
      + ` ${out} left out`);
  }
}

// The sensors of an instrument: it marks those that the laws reject.
const SHOWN_BY = {
  speed: ["airspeed"],
  attitude: ["roll_attitude", "pitch_attitude", "alpha", "beta",
    "lateral_acceleration", "yaw_rate"],
  height: ["altitude"],
};
const doubts = Object.entries(SHOWN_BY).map(([panel, sensors]) => {
  const told = html("p", { class: "doubt down" });
  told.hidden = true;
  byId(panel).append(told);
  return [told, sensors];
});

function show_laws(lost) {
  const laws = lost ? null : state.laws;
  const shown = byId("laws");
  say(shown, lost ? "\u2013\u2013" : laws === null
    ? state.laws_state === "off" ? "off" : "none"
    : (laws.alone ? "\u25b2 " : "") + laws.short);
  shown.title = laws === null ? "no report of the control laws"
    : `laws: ${laws.mode}, ${laws.link}`;
  put(shown, "class", `down ${lost ? "gone" : laws?.alone ? "warning" : ""}`);
  for (const [told, sensors] of doubts) {
    const wrong = sensors.filter((name) => laws?.not_valid.includes(name));
    told.hidden = wrong.length === 0;
    say(told, "\u25c6 "
      + `${wrong.map((name) => name.replace("_", " ")).join(", ")} not valid`);
  }
}

function flies(silent) {
  if (silent) {
    return ["warning", "\u25b2 not known", "\u25b2 who flies is not known"];
  }
  const mine = state.holder === hello.console;
  const holder = state.holder === null ? "nobody"
    : mine ? "you" : `console ${state.holder}`;
  const sends = state.holder !== null && state.live;
  // The node's answer counts, not this station's packets (GND-58).
  if (state.flies === "pilot") return ["", "sim pilot", "simulated pilot flies"];
  if (state.flies === "other") {
    return sends ? ["warning", "\u25b2 other station",
      `\u25b2 ANOTHER STATION flies, ${holder} REFUSED`]
      : ["", "other station", "another station flies"];
  }
  if (state.sticks_refused) {
    return ["warning", `\u25b2 ${holder}: REFUSED`,
      `\u25b2 ${holder}: sticks REFUSED by the ground's node`];
  }
  if (sends && state.flies === "us") {
    return mine ? ["mine", "YOU", `YOU fly (console ${hello.console})`]
      : ["", holder, `${holder} flies`];
  }
  const holds = state.holder === null ? holder
    : `${holder}, not ${sends ? "flown" : "live"}`;
  const by = { held: ["warning", `\u25b2 ${holds}: HELD`,
    `\u25b2 ${holds}: console lost, sticks HELD`],
  neutral: ["warning", `\u25b2 ${holds}: NEUTRAL`,
    `\u25b2 ${holds}: console lost, sticks NEUTRAL`],
  none: ["", "script", "a script flies, no console"],
  live: [mine ? "mine" : "", holds, holds] };
  return by[state.console] ?? ["", holds, holds];
}

function show_holder(silent) {
  const [kind, short, long] = flies(silent);
  const who = byId("who");
  say(who, short);
  put(who, "class", kind);
  const holder = byId("holder");
  say(holder, long);
  put(holder, "class", kind);
  const mine = state.holder === hello.console;
  const [caution, source] = hands.source();
  const asks = state.asker === hello.console;
  say(byId("source"), source || (asks
    ? `asked console ${state.holder}: ${state.left.toFixed(0)} s`
    : `you are console ${hello.console}`));
  put(byId("source"), "class", caution);
  byId("asked").hidden = !hands.asked;
  if (hands.asked) {
    say(byId("asking"), `console ${state.asker} asks for the sticks: `
      + `${state.left.toFixed(0)} s`);
  }
  byId("take").disabled = !there || !hello.can_fly || asks
    || (mine && hands.blocked === "");
  byId("pilot").disabled = state.pilot !== "hands_off"
    || !(mine || state.holder === null);
  byId("release").disabled = !(mine || (state.pilot === "flies"
    && state.holder === null));
}

// Clicks and keys

byId("take").addEventListener("click", () => hands.take());
byId("pilot").addEventListener("click", () => send({ t: "pilot" }));
byId("release").addEventListener("click",
  () => send({ t: "release" }));
byId("give").addEventListener("click", () => hands.answer(true));
byId("keep").addEventListener("click", () => hands.answer(false));
byId("seen").addEventListener("click", () => acknowledge(null));
byId("help").addEventListener("click", () => byId("keys").showModal());
byId("marking").addEventListener("submit", (event) => {
  event.preventDefault();
  send({ t: "mark", text: byId("mark").value });
  byId("mark").value = "";
  byId("mark").blur();
});
byId("mark").addEventListener("keydown", (event) => {
  if (event.key === "Escape") byId("mark").blur();
});
addEventListener("keydown", (event) => {
  if (event.target.matches?.("#mark, #orders input, #orders select,"
    + " #recorder input") || event.repeat
    || event.ctrlKey
    || event.metaKey || event.altKey) return;
  if (event.key === "m" || event.key === "M") {
    byId("mark").focus();
    event.preventDefault();
  } else if (event.key === "k" || event.key === "K") {
    acknowledge(null);
  } else if (event.key === "l" || event.key === "L") {
    turn_theme();
  } else if (event.key === "c" || event.key === "C") {
    orders.overlay.turn();
  } else if (event.key === "f" || event.key === "F") {
    cards.overlay.turn();
  } else if (event.key === "e" || event.key === "E") {
    hands.endCard();
  } else if (event.key === "r" || event.key === "R") {
    recorder.overlay.turn();
  } else if (event.key === "?") {
    byId("keys").showModal();
  }
});

// Dark, unless the system or the button selects light.

const system_light = matchMedia("(prefers-color-scheme: light)");
let theme = stored("theme", "");

function show_theme() {
  if (theme) document.documentElement.dataset.theme = theme;
  const light = theme ? theme === "light" : system_light.matches;
  say(byId("theme"), light ? "dark" : "light");
}

function turn_theme() {
  const light = theme ? theme === "light" : system_light.matches;
  theme = light ? "dark" : "light";
  store("theme", theme);
  show_theme();
}
byId("theme").addEventListener("click", turn_theme);
system_light.addEventListener("change", show_theme);

show_theme();
connect();
// Ages increase even without messages.
setInterval(() => {
  if (performance.now() - came > BETWEEN) draw_soon();
}, 100);
draw_soon();
