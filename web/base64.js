// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Returns the bytes of a text in base64. Browsers since 2025 do it in a tenth of the time.
const bytes_of = Uint8Array.fromBase64?.bind(Uint8Array) ?? ((base64) => {
  const held = atob(base64), bytes = new Uint8Array(held.length);  // a loop: Uint8Array.from takes ten times as long
  for (let i = 0; i < held.length; ++i) bytes[i] = held.charCodeAt(i);
  return bytes;
});
