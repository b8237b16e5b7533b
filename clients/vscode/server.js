// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Starts a language server and exchanges JSON messages with it. A header with its length comes before each message.
"use strict";
const { spawn } = require("child_process");

class Server {
  /**
   * @param {string} program
   * @param {{told: (method: string, params: any) => void, ended: (why: string) => void}} doors
   */
  constructor(program, doors) {
    this.doors = doors;
    this.last = 0;
    /** @type {Map<number, {resolve: (result: any) => void, reject: (why: Error) => void}>} */
    this.waiting = new Map();
    this.bytes = Buffer.alloc(0);
    this.over = false;
    this.child = spawn(program, ["lsp"], { stdio: ["pipe", "pipe", "ignore"] });
    this.child.on("error", (why) => this.end(why.message));
    this.child.on("exit", (code) => this.end(`it has ended (${code})`));
    this.child.stdin.on("error", () => {});
    this.child.stdout.on("data", (bytes) => this.take(bytes));
  }

  /** @param {string} why */
  end(why) {
    if (this.over) return;
    this.over = true;
    for (const { reject } of this.waiting.values()) reject(new Error(why));
    this.waiting.clear();
    this.doors.ended(why);
  }

  /** @param {Buffer} bytes */
  take(bytes) {
    this.bytes = Buffer.concat([this.bytes, bytes]);
    for (;;) {
      const head = this.bytes.indexOf("\r\n\r\n");
      if (head < 0) return;
      const length = Number(/content-length: *(\d+)/i.exec(this.bytes.toString("latin1", 0, head))?.[1]);
      const end = head + 4 + length;
      if (!(this.bytes.length >= end)) return;
      const message = JSON.parse(this.bytes.toString("utf8", head + 4, end));
      this.bytes = this.bytes.subarray(end);
      this.hear(message);
    }
  }

  /** @param {any} message */
  hear(message) {
    if (message.method) return this.doors.told(message.method, message.params);
    const asker = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) asker?.reject(new Error(message.error.message));
    else asker?.resolve(message.result);
  }

  /** @param {object} message */
  send(message) {
    if (this.over) return;
    const text = Buffer.from(JSON.stringify({ jsonrpc: "2.0", ...message }));
    this.child.stdin.write(Buffer.concat([Buffer.from(`Content-Length: ${text.length}\r\n\r\n`), text]));
  }

  /** @param {string} method @param {object} params */
  tell(method, params) {
    this.send({ method, params });
  }

  /**
   * @param {string} method @param {object} params
   * @param {{onCancellationRequested: (listener: () => void) => any}} [token]
   * @returns {Promise<any>}
   */
  ask(method, params, token) {
    if (this.over) return Promise.resolve(null);
    const id = ++this.last;
    token?.onCancellationRequested(() => this.waiting.has(id) && this.tell("$/cancelRequest", { id }));
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.send({ id, method, params });
    });
  }

  async stop() {
    if (this.over) return;
    this.doors.ended = () => {};
    await this.ask("shutdown", {}).catch(() => {});
    this.tell("exit", {});
    this.child.stdin.end();
  }
}

module.exports = { Server };
