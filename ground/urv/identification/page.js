// SPDX-License-Identifier: Apache-2.0

// Draws the fits of an identification (GND-63). Times of all plots zoom together.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
const CONFIG = { displayModeBar: false, responsive: false, doubleClick: false };
const HEIGHT = 170;
let range = null;

async function unpacked(id) {
  const text = document.getElementById(id).textContent;
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream()
    .pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).text();
}

function colour(name) {
  return getComputedStyle(document.documentElement)
    .getPropertyValue(`--${name}`).trim();
}

function figure(plot) {
  const made = document.createElement("figure");
  const caption = document.createElement("figcaption");
  caption.append(`${plot.title}, ${plot.unit}`);
  const keys = document.createElement("div");
  keys.className = "keys";
  for (const trace of plot.traces) {
    const key = document.createElement("span");
    key.innerHTML = '<svg width="26" height="8" aria-hidden="true"><line x1="0"'
      + ' y1="4" x2="26" y2="4" stroke-width="2.5"/></svg>';
    key.querySelector("line").style.stroke = `var(--${trace.role})`;
    key.append(trace.label);
    keys.append(key);
  }
  if (plot.bands.length) {
    const key = document.createElement("span");
    key.append("shaded: validation, not used for the estimate");
    keys.append(key);
  }
  const element = document.createElement("div");
  element.className = "plot";
  element.style.minHeight = `${HEIGHT}px`;
  made.append(caption, keys, element);
  document.getElementById("panels").append(made);
  return element;
}

function draw(plot) {
  const axis = { gridcolor: colour("line"), linecolor: colour("faint"),
                 zeroline: false, exponentformat: "none" };
  Plotly.react(plot.element, plot.traces.map((trace) => ({
    x: plot.x, y: trace.y, type: "scatter", mode: "lines", connectgaps: false,
    name: trace.label, line: { color: colour(trace.role), width: 1.5 },
    hovertemplate: `%{y:.3f} ${plot.unit} %{fullData.name}<extra></extra>`,
  })), {
    height: HEIGHT, width: document.getElementById("panels").clientWidth,
    margin: { l: 58, r: 14, t: 6, b: 30 }, showlegend: false, hovermode: "x",
    paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
    font: { color: colour("ink"), size: 11 },
    xaxis: { ...axis, ticksuffix: " s", range: range ?? undefined,
             autorange: range === null },
    yaxis: { ...axis, fixedrange: true },
    shapes: plot.bands.map(([x0, x1]) => ({
      type: "rect", layer: "below", yref: "paper", x0, x1, y0: 0, y1: 1,
      line: { width: 0 }, fillcolor: colour("caution-band"),
    })),
  }, CONFIG);
}

function drawAll() {
  data.plots.forEach(draw);
}

unpacked("plotly").then((text) => {
  const script = document.createElement("script");
  script.textContent = text;
  document.head.append(script);
  for (const plot of data.plots) plot.element = figure(plot);
  drawAll();
  for (const plot of data.plots) {
    plot.element.on("plotly_relayout", (change) => {
      if (change["xaxis.range[0]"] === undefined) return;
      range = [change["xaxis.range[0]"], change["xaxis.range[1]"]];
      drawAll();
    });
    plot.element.on("plotly_doubleclick", () => { range = null; drawAll(); });
  }
  addEventListener("resize", drawAll);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAll);
  document.body.dataset.drawn = "yes";
}).catch((fault) => {
  const trouble = document.getElementById("trouble");
  trouble.textContent = `The plots cannot be drawn: ${fault}`;
  trouble.hidden = false;
});
