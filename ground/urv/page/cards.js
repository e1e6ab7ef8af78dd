// SPDX-License-Identifier: Apache-2.0
// The test cards aboard (FTI-8): as the aircraft has reported them, with what
// runs, its envelope, and why the last one ended.

import { byId, html, put, say } from "./draw.js";
import { Overlay } from "./overlay.js";

const SHAPE = { waiting: "\u2026 ", taken: "\u2713 ", refused: "\u25c6 ",
  lost: "\u25c6 " };
const LONGEST = 3_500;
const WARNED_MS = 10_000;

export class Cards {
  constructor(send, hands) {
    this.send = send;
    this.overlay = new Overlay("cards", "open_cards", "close_cards");
    this.shown = "";
    this.said = "";
    this.saidAt = 0;
    byId("end_card").addEventListener("click", () => {
      hands.endCard();
      document.activeElement?.blur();
    });
    byId("card_file").addEventListener("change", (event) =>
      this.read(event.target));
  }

  async read(input) {
    const [file] = input.files;
    if (file === undefined) return;
    this.said = "";
    try {
      const text = (await file.text()).split("\n")
        .filter((line) => line.trim() !== "" && !line.trim().startsWith("#"))
        .join("\n");
      if (text.length > LONGEST) this.warn(`${file.name} is too long`);
      else this.send({ t: "cards", text });
    } catch {
      this.warn(`${file.name} cannot be read`);
    }
    input.value = "";
    // The keys fly again.
    document.activeElement?.blur();
  }

  // After 10 s the state of the last sent cards is shown again.
  warn(text) {
    this.said = `\u25c6 ${text}`;
    this.saidAt = performance.now();
  }

  draw(cards, mine, silent) {
    const runs = !silent && cards.running > 0;
    const button = byId("open_cards");
    say(button, runs ? `card ${cards.running} runs` : "cards");
    button.classList.toggle("runs", runs);
    const ended = cards.last > 0 && cards.ended !== "none";
    const odd = !runs && ended && !cards.expected;
    say(byId("card_state"), silent ? "no frames: not known"
      : runs ? `card ${cards.running} runs`
        : ended ? `${odd ? "\u25c6 " : ""}card ${cards.last}: ${cards.ended}`
          : "no card has run");
    put(byId("card_state"), "class", silent || odd ? "caution"
      : runs ? "runs" : "");
    byId("end_card").disabled = !mine || silent;
    byId("card_file").disabled = !mine || silent
      || cards.state === "waiting";
    const { state, text } = cards;
    if (performance.now() - this.saidAt > WARNED_MS) this.said = "";
    say(byId("card_order"), this.said || (!mine ? "take the sticks to send"
      : state === "none" ? "" : (SHAPE[state] ?? "") + text));
    put(byId("card_order"), "class", this.said !== "" || state === "refused"
      || state === "lost" ? "caution" : state === "taken" ? "taken" : "");
    byId("no_cards").hidden = cards.slots.length > 0;
    this.list(cards, silent);
  }

  // The list changes rarely, and states come often.
  list(cards, silent) {
    const key = JSON.stringify([cards.slots, cards.chosen, cards.running,
      cards.last, cards.ended, silent]);
    if (key === this.shown) return;
    this.shown = key;
    byId("card_slots").replaceChildren(...cards.slots.map((each) => {
      const runs = cards.running === each.slot;
      const mark = silent ? "" : runs ? "runs"
        : cards.last === each.slot && cards.ended !== "none" ? cards.ended
          : cards.chosen === each.slot ? "next" : "";
      const row = html("li", { class: silent ? "gone" : runs ? "runs" : "" },
        html("b", {}, String(each.slot)),
        html("span", { class: "what" }, each.name || each.kind),
        html("span", {}, `${each.kind}, ${each.seconds.toFixed(1)} s, `
          + each.moves),
        html("span", { class: "mark" }, mark),
        html("span", { class: "envelope" }, `envelope: ${each.envelope}`));
      return row;
    }));
  }
}
