// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Decodes the sound files of films by the browser, to the samples that the program gets of them by ffmpeg.
const sound_rate = 48000;
const is_sound = (path) => /\.(wav|w64|aiff?|au|caf|flac|og[ag]|opus|mp3|aac|mov|mp4|m4a|mk[av]|webm|avi|ac3|amr|wv)$/i.test(path);

// How much of each channel is heard at the left, and at the right, as ffmpeg mixes them.
const half = Math.SQRT1_2;
const shares_of_channels = {
  1: [[half], [half]],
  4: [[1, 0, half, 0], [0, 1, 0, half]],
  6: [[1, 0, half, 0, half, 0], [0, 1, half, 0, 0, half]],
};

// Returns left and right alternately, or { trouble }; null where nothing decodes, as in Node.
const decoded_sound = async (bytes) => {
  if (!globalThis.OfflineAudioContext) return null;
  try {
    const context = new OfflineAudioContext(2, 1, sound_rate);
    const sound = await context.decodeAudioData(bytes.slice().buffer), stereo = new Float32Array(2 * sound.length);
    (shares_of_channels[sound.numberOfChannels] ?? [[1], [0, 1]]).forEach((shares, side) => shares.forEach((share, i) => {
      if (!share) return;
      const channel = sound.getChannelData(i);
      for (let k = 0; k < sound.length; ++k) stereo[2 * k + side] += share * channel[k];
    }));
    return { stereo };
  } catch (error) {
    return { stereo: new Float32Array(0), trouble: error.message || String(error) };
  }
};

// The numbers of the files' samples in the engine. A file that the page forgets is forgotten there too.
class DecodedSounds {
  #engine;
  #numbers = new WeakMap();  // by the bytes of a file
  #coming = new WeakMap();   // promises
  #forgotten;
  #count = 0;

  constructor(engine) {
    this.#engine = engine;
    this.#forgotten = new FinalizationRegistry((number) => engine.call("betwixt_drop_sound", number));
  }
  lacks(files) { return this.#of(files).some(([, bytes]) => !this.#numbers.has(bytes)); }
  async decode(files) {
    await Promise.all(this.#of(files).filter(([, bytes]) => !this.#numbers.has(bytes)).map(([, bytes]) => {
      if (!this.#coming.has(bytes)) this.#coming.set(bytes, this.#decode(bytes));
      return this.#coming.get(bytes);
    }));
  }
  // Tells the engine which of a film's files are which sounds, while it opens the film.
  give(files) {
    for (const [path, bytes] of this.#of(files)) {
      const number = this.#numbers.get(bytes);
      if (number) this.#engine.call("betwixt_give_sound", "/film/" + parts_of(path).join("/"), number);
    }
  }
  give_none() { this.#engine.call("betwixt_give_no_sounds"); }

  #of(files) { return Object.entries(files).filter(([path, bytes]) => typeof bytes === "object" && is_sound(path)); }
  async #decode(bytes) {
    const sound = await decoded_sound(bytes), number = sound ? ++this.#count : 0;
    if (sound) this.#engine.add_sound(number, sound.trouble ?? "", sound.stereo);
    this.#numbers.set(bytes, number);
    if (sound) this.#forgotten.register(bytes, number);
  }
}
