// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How the player's tags are used where markup is written in TypeScript: the same in React, Preact and Solid. A line behind
// "wrong:" must be refused.
import "betwixt-player";

const files = { "words.txt": "words", "spot.obj": new Uint8Array(4) };
export const plain = <betwixt-player src="bounce.bx" controls loop autoplay width={320} height="180" alt="a ball" />;
export const full = (
  <betwixt-editor class="wide">
    <betwixt-player id="film" class="large" style={{ width: "50%" }} stepped preload="none" loading="eager" playbackrate={2}
      poster="still.png" tabIndex={0} aria-label="a film" script={"create ball sphere\n"} files={files} currentTime={1}
      onended={() => console.log("over")} onnote={(event) => console.log(event.detail.text, event.detail.time)}
      ondiagnostics={(event) => console.log(event.detail.diagnostics[0]?.line)}
      ref={(player) => { const rate: number | undefined = player?.playbackRate; console.log(rate); }} />
  </betwixt-editor>
);
// wrong:
export const looped = <betwixt-player loop="yes" />;
// wrong:
export const misspelt = <betwixt-player scr="bounce.bx" />;
// wrong:
export const late = <betwixt-player loading="later" />;
// wrong:
export const heard = <betwixt-player onnote={(event) => console.log(event.detail.words)} />;
// wrong:
export const unknown = <betwixt-theatre />;
