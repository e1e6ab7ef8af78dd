// SPDX-License-Identifier: Apache-2.0
// The flight recorder aboard (FTI-13): what it holds, the fetch of its rows
// after a landing, and the rows that are missing.

import { byId, put, say } from "./draw.js";
import { Overlay } from "./overlay.js";

const ROWS_PER_SECOND = 50;

const seconds = (rows) => `${(rows / ROWS_PER_SECOND).toFixed(
  rows < 10 * ROWS_PER_SECOND ? 1 : 0)} s`;

const duration = (time) => time < 90 ? `${Math.round(time)} s`
  : `${Math.round(time / 60)} min`;

export class Recorder {
  constructor(send) {
    this.overlay = new Overlay("recorder", "open_recorder",
      "close_recorder");
    const says = (what) => () => {
      const last = Number(byId("fetch_last").value);
      send({ t: "recorder", what,
        last: byId("fetch_last").value === "" ? null : last });
      // The keys fly again.
      document.activeElement?.blur();
    };
    byId("ask_recorder").addEventListener("click", says("ask"));
    byId("stop_fetch").addEventListener("click", says("stop"));
    byId("fetching").addEventListener("submit", (event) => {
      event.preventDefault();
      says("fetch")();
    });
  }

  draw(recorder, may, there) {
    const { state, busy } = recorder;
    const button = byId("open_recorder");
    const share = recorder.wanted === 0 ? 0
      : Math.floor(100 * recorder.fetched / recorder.wanted);
    say(button, state === "fetching" ? `rec ${share} %` : "rec");
    button.classList.toggle("runs", busy);
    for (const [id, able] of [["ask_recorder", !busy], ["fetch", !busy],
      ["fetch_last", !busy], ["stop_fetch", busy]]) {
      byId(id).disabled = !able || !may || !there || !recorder.can;
    }
    const left = recorder.wanted - recorder.fetched;
    const shown = {
      none: ["", "not asked yet"], asking: ["", "\u2026 asked"],
      known: ["", "answers"],
      fetching: ["runs", `\u2026 ${recorder.rate.toFixed(0)} rows a second`
        + (recorder.rate > 0 ? `, ${duration(left / recorder.rate)} left`
          : "")],
      complete: ["taken", "\u2713 complete"],
      gaps: ["caution", `\u25c6 rows are missing: ${left}`],
      stopped: ["", "stopped; fetch goes on with the rest"],
      failed: ["caution", `\u25c6 ${recorder.text}`] };
    const [kind, text] = !there ? ["caution", "station lost: not known"]
      : !recorder.can ? ["", "this station only watches"] : shown[state];
    say(byId("recorder_state"), text);
    put(byId("recorder_state"), "class", kind);
    say(byId("recorder_holds"), recorder.held === null ? "\u2013\u2013"
      : `${recorder.held} rows, ${seconds(recorder.held)}, of `
        + seconds(recorder.length));
    say(byId("recorder_fetched"), recorder.wanted === 0 ? "\u2013\u2013"
      : `${recorder.fetched} of ${recorder.wanted} rows, ${share} %`);
    const bar = byId("recorder_bar");
    bar.max = Math.max(recorder.wanted, 1);
    bar.value = recorder.fetched;
    say(byId("recorder_missing"), state !== "gaps" ? "\u2013\u2013"
      : `${recorder.missing}: ${recorder.text}`);
    put(byId("recorder_missing"), "class", state === "gaps" ? "caution" : "");
    say(byId("recorder_file"), recorder.file || "\u2013\u2013");
    say(byId("who_fetches"), may ? "" : "take the sticks to fetch");
  }
}
