// SPDX-License-Identifier: Apache-2.0
// Cautions and warnings, the log, the marks. Text from outside is inserted as
// text only (GND-27). A row with a bad time affects no other row (GND-57).

import { byId, html, say } from "./draw.js";

const SHAPE = { warning: "\u25b2", caution: "\u25c6" };
const LINES = 200;

// Any number: a time outside the calendar must not cost the other rows.
const clock = (time_us) => {
  const at = new Date(time_us / 1000);
  return Number.isNaN(at.getTime()) ? "--:--:--"
    : at.toISOString().slice(-13, -5);
};

export function showAlerts(alerts, acknowledge) {
  const unseen = alerts.filter((alert) => !alert.seen);
  const active = (level) =>
    alerts.filter((alert) => alert.active && alert.level === level).length;
  say(byId("counted"), alerts.length === 0 ? "no alert"
    : `${SHAPE.warning} ${active("warning")}  ${SHAPE.caution} `
      + `${active("caution")}  ${unseen.length} unseen`);
  byId("counted").title = `${active("warning")} warnings and `
    + `${active("caution")} cautions now`;
  byId("seen").disabled = unseen.length === 0;
  byId("alert_list").replaceChildren(...alerts.map((alert) => {
    const row = html("li", { class: [alert.level,
      alert.seen ? "" : "unseen", alert.active ? "" : "past"].join(" "),
    "data-key": alert.key },
    html("span", { class: "what" },
      `${SHAPE[alert.level]} ${alert.level.toUpperCase()} ${alert.name}`),
    html("span", { class: "when" }, clock(alert.came_us)),
    html("span", { class: "text" }, alert.text
      + (alert.count > 1 ? `, ${alert.count} times` : "")
      + (alert.active ? "" : " (past)")
      + (alert.seen ? "" : " \u2013 not acknowledged")));
    row.addEventListener("click", () => acknowledge(alert.key));
    return row;
  }));
}

export function showLines(lines) {
  const list = byId("lines");
  for (const line of lines) {
    list.prepend(html("li", { class: line.level },
      html("time", {}, clock(line.time_us)), " ",
      html("span", { class: "level" }, line.level === "info"
        ? line.kind : `${SHAPE[line.level]} ${line.level}`), " ",
      line.text));
  }
  while (list.childElementCount > LINES) list.lastChild.remove();
}
