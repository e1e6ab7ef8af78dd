// SPDX-License-Identifier: Apache-2.0
// Numbers of the flight software, from the station's hello. Before that none of
// them is shown.

export const tables = { frame_ms: NaN, middle: NaN, largest: NaN };

export function learn(hello) {
  Object.assign(tables, hello.tables);
}

export const isOn = (word) => word >= tables.middle;
