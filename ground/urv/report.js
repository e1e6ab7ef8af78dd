// SPDX-License-Identifier: Apache-2.0

// Draws the panels of a report. For the displayed time a series is drawn as the
// least and the most of the values on each pixel.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
const POINTS = 900;
const PRINTED_WIDTH = 690;
const DASHES = ["solid", "dash"];
const MARGIN = { l: 58, r: 14, t: 6, b: 30 };

let numbers;
let flights;
let plots = [];
let shown = null;

async function unpacked(id) {
  const text = document.getElementById(id).textContent;
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream()
    .pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

function array(place) {
  const types = { u1: Uint8Array, u2: Uint16Array, u4: Uint32Array,
                  i4: Int32Array, f4: Float32Array, f8: Float64Array };
  return new types[place.type](numbers, place.at, place.many);
}

function colour(name) {
  return getComputedStyle(document.documentElement)
    .getPropertyValue(`--${name}`).trim();
}

// plotly reads some HTML in labels: text from files must not be HTML.
function plain(text) {
  return text.replace(/&/g, "&amp;").replace(/</g, "&lt;")
    .replace(/>/g, "&gt;");
}

// The first row at or after a time.
function rowAt(times, time) {
  let low = 0, high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] < time) low = middle + 1; else high = middle;
  }
  return low;
}

// The points of a series between two times, gaps as null.
function points(series, flight, from, to) {
  const times = series.times ? array(series.times) : flight.times;
  const raw = array(series);
  const first = Math.max(rowAt(times, from) - 1, 0);
  const last = Math.min(rowAt(times, to) + 1, times.length);
  const bucket = Math.max(Math.ceil(2 * (last - first) / POINTS), 1);
  const x = [], y = [];
  const isGap = (row) => (series.gaps && flight.stale[row])
    || raw[row] === series.missing;
  const put = (row) => {
    x.push(times[row]);
    y.push(series.per * (raw[row] - series.zero));
  };
  for (let begin = first; begin < last; begin += bucket) {
    const end = Math.min(begin + bucket, last);
    let least = -1, most = -1, broken = false;
    for (let row = begin; row < end; row++) {
      if (!series.times && flight.broken.has(row)) {
        if (row === begin) { x.push(times[row]); y.push(null); }
        else broken = true;
      }
      if (isGap(row)) { broken = true; continue; }
      if (least < 0 || raw[row] < raw[least]) least = row;
      if (most < 0 || raw[row] > raw[most]) most = row;
    }
    if (least >= 0) {
      put(Math.min(least, most));
      if (least !== most) put(Math.max(least, most));
    }
    if (broken) { x.push(times[end - 1]); y.push(null); }
  }
  return { x, y };
}

function legend(entries) {
  const keys = document.createElement("div");
  keys.className = "keys";
  for (const { label, role, dash } of entries) {
    const key = document.createElement("span");
    key.innerHTML = '<svg width="26" height="8" aria-hidden="true"><line x1="0"'
      + ' y1="4" x2="26" y2="4" stroke-width="2.5"/></svg>';
    const line = key.querySelector("line");
    line.style.stroke = `var(--${role})`;
    if (dash !== "solid") {
      line.setAttribute("stroke-dasharray", dash === "dot" ? "2 3" : "7 4");
    }
    key.append(label);
    keys.append(key);
  }
  return keys;
}

function figure(title, note, entries) {
  const made = document.createElement("figure");
  const caption = document.createElement("figcaption");
  caption.append(title);
  if (note) {
    const small = document.createElement("small");
    small.textContent = ` ${note}`;
    caption.append(small);
  }
  const plot = document.createElement("div");
  plot.className = "plot";
  made.append(caption, legend(entries), plot);
  document.getElementById("panels").append(made);
  return plot;
}

const dashOf = (trace, which) =>
  trace.role === "truth" ? "dot" : DASHES[which];

function baseLayout(height) {
  const axis = {
    gridcolor: colour("line"), linecolor: colour("faint"), zeroline: false,
    tickfont: { size: 11 }, exponentformat: "none",
  };
  return {
    height, margin: { ...MARGIN }, showlegend: false, hovermode: "x",
    paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
    font: { color: colour("ink"), size: 11,
            family: "system-ui, DejaVu Sans, sans-serif" },
    hoverlabel: { font: { size: 11 }, namelength: -1 },
    dragmode: "zoom", xaxis: { ...axis, ticksuffix: " s" },
    yaxis: { ...axis },
  };
}

const CONFIG = { displayModeBar: false, responsive: false, doubleClick: false };

function extent(traces) {
  let low = Infinity, high = -Infinity;
  for (const trace of traces) {
    for (const value of trace.y) {
      if (value === null) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return low > high ? [0, 1] : [low, high];
}

// Beyond the limits; bands far from all values need no room.
function bands(limits, low, high) {
  const shapes = [];
  if (!limits.length) return { shapes, low, high };
  const [warningLow, cautionLow, cautionHigh, warningHigh] = limits;
  const between = cautionLow !== null && cautionHigh !== null
    ? 0.6 * (cautionHigh - cautionLow) : 0;
  const room = Math.max(high - low, between, 1e-9);
  for (const limit of limits) {
    if (limit === null) continue;
    if (limit > high && limit - high < 0.6 * room) high = limit + 0.1 * room;
    if (limit < low && low - limit < 0.6 * room) low = limit - 0.1 * room;
  }
  const far = 10 * (Math.abs(low) + Math.abs(high) + room);
  const put = (from, to, name) => {
    if (to <= low || from >= high) return;
    shapes.push({
      type: "rect", layer: "below", xref: "paper", x0: 0, x1: 1, y0: from,
      y1: to, line: { width: 0 }, fillcolor: colour(`${name}-band`),
    });
  };
  if (cautionHigh !== null) put(cautionHigh, warningHigh ?? far, "caution");
  if (warningHigh !== null) put(warningHigh, far, "warning");
  if (cautionLow !== null) put(warningLow ?? -far, cautionLow, "caution");
  if (warningLow !== null) put(-far, warningLow, "warning");
  return { shapes, low, high };
}

class TimePlot {
  constructor(panel) {
    this.panel = panel;
    const entries = [];
    this.series = [];
    for (const trace of panel.traces) {
      trace.series.forEach((series, which) => {
        if (!series) return;
        const letter = flights.length > 1 ? `${"AB"[which]}: ` : "";
        const dash = dashOf(trace, which);
        entries.push({ label: letter + trace.label, role: trace.role, dash });
        this.series.push({ trace, series, which, dash,
                           label: letter + trace.label });
      });
    }
    const unit = panel.unit ? `, ${panel.unit}` : "";
    this.element = figure(panel.title + unit, panel.note, entries);
    this.limits = panel.limits;
    this.height = panel.levels.length ? 46 + 26 * panel.levels.length : 180;
    this.element.style.minHeight = `${this.height}px`;
  }

  traces() {
    const { panel } = this;
    return this.series.map(({ trace, series, which, dash, label }) => {
      const drawn = points(series, flights[which], ...shown);
      const dots = series.times !== undefined;
      return {
        ...drawn, name: plain(label), type: "scatter",
        mode: dots ? "markers" : "lines", connectgaps: false,
        line: { color: colour(trace.role), dash,
                width: trace.role === "truth" ? 1.2 : 1.5,
                shape: trace.step ? "hv" : "linear" },
        marker: { size: 3, color: colour(trace.role) },
        hovertemplate: panel.levels.length ? "%{fullData.name}<extra></extra>"
          : `%{y:.${series.decimals}f} ${plain(panel.unit)}`
            + " %{fullData.name}<extra></extra>",
      };
    });
  }

  draw() {
    const traces = this.traces();
    const layout = baseLayout(this.height);
    const [least, most] = extent(traces);
    const fitted = bands(this.limits, least, most);
    const room = Math.max(fitted.high - fitted.low, 1e-6);
    layout.xaxis.range = [...shown];
    layout.yaxis.range = [fitted.low - 0.06 * room, fitted.high + 0.06 * room];
    layout.yaxis.fixedrange = true;
    if (most - least < 1e-6) {
      const around = Math.max(Math.abs(most) * 0.05, 1);
      // A count of 0 is never below it.
      const below = least === 0 ? 0.1 * around : around;
      layout.yaxis.range = [Math.min(fitted.low, least - below),
                            Math.max(fitted.high, most + around)];
    }
    if (this.panel.levels.length) {
      layout.yaxis.range = [-0.3, this.panel.levels.length];
      layout.yaxis.tickvals = this.panel.levels.map((_, n) => n + 0.35);
      layout.yaxis.ticktext = this.panel.levels.map(
        (name) => name.replace(/switch (\d+).*/, "$1"));
    }
    layout.shapes = fitted.shapes;
    layout.width = width();
    Plotly.react(this.element, traces, layout, CONFIG);
  }
}

// A line for each kind of event, from its first to its last time.
class EventPlot {
  constructor(happened) {
    this.happened = happened;
    this.element = figure("Events", "", []);
    this.height = 44 + 28 * Math.max(happened.length, 1);
  }

  draw() {
    const roles = { law: "first", event: "ink", gap: "faint",
                    caution: "caution", warning: "warning" };
    const traces = this.happened.map((one, row) => {
      const x = [], y = [];
      for (const [begin, end] of one.spans) {
        x.push(begin, end, null);
        y.push(row, row, null);
      }
      const shape = one.level === "warning" ? "square"
        : one.level === "caution" ? "triangle-up" : "circle";
      return {
        x, y, type: "scatter", mode: "lines+markers", connectgaps: false,
        name: plain(one.label), line: { color: colour(roles[one.level]),
                                        width: one.level === "event" ? 1 : 6,
                                        dash: one.level === "event" ? "dot"
                                          : "solid" },
        marker: { size: 7, symbol: shape, color: colour(roles[one.level]) },
        hovertemplate: `%{x:.2f} s ${plain(one.label)} ${plain(one.text)}`
          + "<extra></extra>",
      };
    });
    const layout = baseLayout(this.height);
    layout.width = width();
    layout.hovermode = "closest";
    layout.xaxis.range = [...shown];
    layout.yaxis.range = [this.happened.length - 0.5, -0.9];
    layout.yaxis.fixedrange = true;
    layout.yaxis.tickvals = [];
    // The names are in the plot, above their lines: beside it there is no room
    // on a narrow page.
    layout.annotations = this.happened.map((one, row) => ({
      xref: "paper", x: 0, xanchor: "left", y: row - 0.1, yanchor: "bottom",
      text: plain(one.label), showarrow: false,
      font: { size: 11, color: colour(roles[one.level]) },
    }));
    Plotly.react(this.element, traces, layout, CONFIG);
  }
}

class TrackPlot {
  constructor(track) {
    this.lines = [];
    track.forEach((one, which) => {
      const letter = flights.length > 1 ? `${"AB"[which]}: ` : "";
      const dash = DASHES[which];
      if (one.reckoned) {
        this.lines.push({ axes: one.reckoned, which, role: "first", dash,
                          label: `${letter}reckoned` });
      }
      if (one.truth) {
        this.lines.push({ axes: one.truth, which, role: "truth", dash: "dot",
                          label: `${letter}true` });
      }
    });
    const named = data.headings.every((heading) => heading === 0)
      ? "; the first heading is taken for north" : "";
    this.element = figure(
      "Ground track, ft",
      "reckoned from airspeed and heading rate, in still air" + named,
      this.lines);
    this.height = 420;
    this.isTrack = true;
  }

  draw() {
    const traces = this.lines.map((line) => {
      const [east, north] = line.axes.map(array);
      const times = flights[line.which].times;
      const missing = line.axes[0].missing;
      const step = Math.max(Math.ceil(east.length / 3000), 1);
      const x = [], y = [], text = [];
      for (let row = 0; row < east.length; row += step) {
        const none = missing !== undefined && east[row] < missing / 2;
        const inside = times[row] >= shown[0] && times[row] <= shown[1];
        x.push(none || !inside ? null : east[row]);
        y.push(none || !inside ? null : north[row]);
        text.push(times[row].toFixed(2));
      }
      return {
        x, y, text, type: "scatter", mode: "lines", connectgaps: false,
        name: plain(line.label), line: { color: colour(line.role), width: 1.8,
                                         dash: line.dash },
        hovertemplate: "%{text} s: east %{x:.0f} ft, north %{y:.0f} ft"
          + "<extra></extra>",
      };
    });
    for (const line of this.lines) {
      const [east, north] = line.axes.map(array);
      const missing = line.axes[0].missing;
      const row = missing === undefined ? 0
        : east.findIndex((value) => value > missing / 2);
      if (line.role !== "truth") {
        traces.push({
          x: [east[row]], y: [north[row]], type: "scatter",
          mode: "markers+text", text: ["begin"],
          textposition: "top center", hoverinfo: "skip",
          marker: { size: 9, color: colour(line.role) },
        });
      }
    }
    const layout = baseLayout(this.height);
    layout.width = width();
    layout.hovermode = "closest";
    layout.xaxis.ticksuffix = "";
    layout.xaxis.title = { text: "east", standoff: 4 };
    layout.yaxis.title = { text: "north", standoff: 4 };
    layout.yaxis.scaleanchor = "x";
    layout.margin.b = 44;
    layout.margin.l = 70;
    layout.xaxis.fixedrange = layout.yaxis.fixedrange = true;
    Plotly.react(this.element, traces, layout, CONFIG);
  }
}

let printing = false;

function width() {
  return printing ? PRINTED_WIDTH
    : document.getElementById("panels").clientWidth;
}

let generation = 0;

function draw(plot) {
  plot.draw();
  link(plot);
}

// Visible panels first, the others when there is time; on paper all.
function drawAll() {
  const mine = ++generation;
  const left = [];
  delete document.documentElement.dataset.drawn;
  for (const plot of plots) {
    const { top, bottom } = plot.element.getBoundingClientRect();
    if (printing || (bottom > 0 && top < innerHeight)) draw(plot);
    else left.push(plot);
  }
  const goOn = () => {
    if (mine !== generation) return;
    const plot = left.shift();
    if (plot) {
      draw(plot);
      setTimeout(goOn);
    } else {
      document.documentElement.dataset.drawn = plots.length;
    }
  };
  if (left.length) setTimeout(goOn); else goOn();
  const [from, to] = shown;
  document.getElementById("range").textContent =
    `${from.toFixed(2)} s to ${to.toFixed(2)} s`;
  document.getElementById("whole").disabled =
    from <= whole[0] && to >= whole[1];
}

let whole;

function show(from, to) {
  from = Math.max(from, whole[0]);
  to = Math.min(to, whole[1]);
  if (to - from < 0.1) return;
  shown = [from, to];
  drawAll();
}

function link(plot) {
  if (plot.isTrack || plot.isLinked) return;
  plot.isLinked = true;
  plot.element.on("plotly_relayout", (change) => {
    const from = change["xaxis.range[0]"], to = change["xaxis.range[1]"];
    if (from !== undefined && to !== undefined) show(from, to);
  });
  plot.element.on("plotly_doubleclick", () => show(...whole));
}

async function begin() {
  numbers = await unpacked("numbers");
  flights = data.timing.map((one) => ({
    times: array(one.times), stale: array(one.stale),
    broken: new Set(array(one.breaks)),
  }));
  whole = [Math.min(...flights.map(({ times }) => times[0])),
           Math.max(...flights.map(({ times }) => times[times.length - 1]))];
  if (whole[1] <= whole[0]) whole[1] = whole[0] + 0.02;
  shown = [...whole];
  const library = document.createElement("script");
  library.textContent = new TextDecoder().decode(await unpacked("plotly"));
  document.head.append(library);
  if (data.happened.length) plots.push(new EventPlot(data.happened));
  for (const panel of data.panels) plots.push(new TimePlot(panel));
  if (data.track.some((one) => one.reckoned || one.truth)) {
    plots.push(new TrackPlot(data.track));
  }
  drawAll();
  document.getElementById("whole").onclick = () => show(...whole);
  for (const row of document.querySelectorAll("#exceedances tr[data-begin]")) {
    row.querySelector("button").onclick = () => {
      const from = Number(row.dataset.begin), to = Number(row.dataset.end);
      const room = Math.max(5, 0.5 * (to - from));
      show(from - room, to + room);
      document.getElementById("bar").scrollIntoView();
    };
  }
  let drawnWidth = width();
  new ResizeObserver(() => {
    if (printing || width() === drawnWidth) return;
    drawnWidth = width();
    drawAll();
  }).observe(document.getElementById("panels"));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAll);
  const print = matchMedia("print");
  const forPaper = (on) => {
    if (printing === on) return;
    printing = on;
    drawAll();
  };
  print.addEventListener("change", () => forPaper(print.matches));
  addEventListener("beforeprint", () => forPaper(true));
  addEventListener("afterprint", () => forPaper(false));
}

begin().catch((fault) => {
  const trouble = document.getElementById("trouble");
  trouble.hidden = false;
  trouble.textContent = `The plots cannot be drawn: ${fault.message}`;
});
