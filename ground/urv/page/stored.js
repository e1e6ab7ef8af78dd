// SPDX-License-Identifier: Apache-2.0
// Settings stored in the browser. A page without permission to store them keeps
// them only while it is open.

const here = new Map();

export function stored(name, otherwise) {
  try {
    return localStorage.getItem(`urv.${name}`) ?? here.get(name) ?? otherwise;
  } catch {
    return here.get(name) ?? otherwise;
  }
}

export function store(name, value) {
  here.set(name, value);
  try {
    localStorage.setItem(`urv.${name}`, value);
  } catch {
    // Nothing else can be done.
  }
}
