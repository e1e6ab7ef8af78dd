// SPDX-License-Identifier: Apache-2.0
// What the browser keeps. A page may be forbidden to keep anything: then it
// keeps it for as long as it is open.

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
