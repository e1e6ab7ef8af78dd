// SPDX-License-Identifier: Apache-2.0
// The age of a message by its sender's time, as in urv/ages.py (GND-56). Times
// are in ms: sent by the sender's clock, now by the page's.

const DRIFT = 500e-6;

export class SenderClock {
  constructor() {
    this.offset = Infinity;
    this.at = 0;
  }

  age(sent, now) {
    const best = this.offset + DRIFT * (now - this.at);
    this.offset = Math.min(now - sent, best);
    this.at = now;
    return now - sent - this.offset;
  }
}
