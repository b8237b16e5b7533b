// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The theme sends its search worker one message at a time, and keeps only the last one that waits. So a word that is
// typed early could replace the message with the index, and search would never be ready. Until the index is sent, this
// worker answers each query itself: nothing is found.
const ThemeWorker = Worker;
window.Worker = class extends ThemeWorker {
  #waits = false;
  constructor(url, ...options) {
    super(url, ...options);
    this.#waits = String(url).includes("/workers/search.") || url === window.__search.worker;
  }
  postMessage(message, ...rest) {
    const isQuery = message.type === 2;
    if (!isQuery) this.#waits = false;
    if (!this.#waits) return super.postMessage(message, ...rest);
    queueMicrotask(() => this.dispatchEvent(new MessageEvent("message", { data: { type: 3, data: { items: [] } } })));
  }
};
