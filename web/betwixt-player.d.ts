// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0

/** An error, a warning or a notice about a script. Lines and columns begin at 1; columns count characters (code points). */
export interface Diagnostic {
  severity: "error" | "warning" | "notice";
  text: string;
  /** A suggestion; may be empty. */
  hint: string;
  file: string;
  /** 0 if the message is about the whole file. */
  line: number;
  column: number;
  /** The text of the line. */
  source: string;
}

/** A number, numbers (a vector, a colour, the 16 of a matrix row by row), points, a boolean, a text, names, or null for no object. */
export type Value = number | number[] | number[][] | boolean | string | string[] | null;

/** An open film. Times are those of its script, in seconds: frame 1 is 0. */
export interface Film {
  /** False if the film has errors; then only `diagnostics`, `message` and `wants` are valid. */
  readonly ok: boolean;
  readonly diagnostics: Diagnostic[];
  /** All diagnostics as a terminal shows them, with caret lines. */
  readonly message: string;
  /** Files that the film needs and that are missing. */
  readonly wants: string[];
  readonly start: number;
  readonly end: number;
  readonly duration: number;
  readonly fps: number;
  readonly firstFrame: number;
  readonly lastFrame: number;
  /** What the film says to people who cannot see it, in the order of time. */
  readonly descriptions: { seconds: number; text: string }[];
  /** The notes of the script, in the order of time. */
  readonly notes: { seconds: number; text: string }[];
  /** The script's `size`, or 1280 x 720. */
  readonly width: number;
  readonly height: number;
  /** True with `background transparent`: the canvas is transparent where the film is empty. */
  readonly clear: boolean;
  /** Draws in the canvas's width and height. */
  draw(canvas: HTMLCanvasElement | OffscreenCanvas, seconds: number): void;
  /** Returns a value as `betwixt eval --json` gives it. */
  eval<T extends Value = Value>(target: string, time: number | string, how?: { text?: false }): T;
  /** Returns a value as `betwixt eval` prints it. */
  eval(target: string, time: number | string, how: { text: true }): string;
  /** Returns several values at several times, as the object of `betwixt eval --json`. */
  evalAll(targets: string[], times: (number | string)[], how?: { text?: false }): unknown;
  evalAll(targets: string[], times: (number | string)[], how: { text: true }): string;
  /**
   * Replaces all events of a track. `times` are seconds, in order. `values` has a number for each, or two or three, row
   * after row: metres, radians, or sRGB from 0 to 1. `twerper` is the interpolation, such as "linear". Throws if
   * something is wrong; then nothing changes.
   */
  setTrack(target: string, times: ArrayLike<number>, values: ArrayLike<number> | ArrayLike<number>[],
           how?: { twerper?: string }): void;
  /** Returns the events of a track as `setTrack` takes them, with `width` numbers for each time. */
  trackNumbers(target: string): { times: Float64Array; values: Float64Array; width: number };
  /** Takes back the last `setTrack`. Returns a line that names it; throws if there is none. */
  undo(): string;
  /** Repeats what `undo` took back. */
  redo(): string;
  /** The script, with the tracks that were set. */
  readonly text: string;
  /** Called after each edit, for example to draw again. A player uses it for its own film. */
  changed: ((otherDuration: boolean) => void) | null;
  /** Whether the film has sounds. */
  readonly sounds: boolean;
  /** Returns samples of the film's sound track, 48,000 a second, from a sample of the film on. */
  sound(first: number, count: number): { left: Float32Array; right: Float32Array };
  /** Returns the errors of the script's code while pictures were drawn. */
  problems(): Diagnostic[];
  /** Frees the film's memory. */
  dispose(): void;
}

export interface Engine {
  readonly version: string;
  /** Loads the reader of meshes, scenes, drawings and pictures if one of these files needs it, and the fonts of
   * formulas and code if the text has any. Decodes sounds. */
  prepare(files: Record<string, Uint8Array>, text?: string): Promise<void>;
  /** Opens a film. Does not throw for errors in the script: see `Film.ok`. */
  open(text: string, how?: {
    name?: string;
    files?: Record<string, Uint8Array>;
    /** Other values for the script's lets. */
    lets?: Record<string, string | number>;
    /** The path of a catalogue of its texts (.po) among the files; "" shows them as they are written. */
    language?: string | null;
  }): Film;
  readonly algebra: Algebra;
}

/** An error in a string of motions; column and length in characters, both 0 for the whole string. */
export interface AlgebraError {
  error: { message: string; hint: string; column: number; length: number };
}
/** Twelve numbers: the upper three rows of a matrix, row by row. */
export type Rows = number[];
/** x, y, z. */
export type Place = [number, number, number];

/** The algebra of motions, for lessons: src/algebra/lesson.h. */
export interface Algebra {
  string(text: string, points?: Place[]): AlgebraError | {
    text: string;
    planar: boolean;
    unit: number;
    factors: { kind: "T" | "R" | "S"; text: string; by?: Place; turns?: number; centre?: Place; axis?: Place; linear?: boolean }[];
    symbols: object;
    alone: object[];
  };
  /** Returns A(t) at count + 1 even times, or undefined if the text is no motion. */
  frames(text: string, from: number, to: number, count: number, linear?: boolean): Rows[] | undefined;
  moment(text: string, t: number): AlgebraError | { matrix: Rows; letters: number[]; parts: Place[]; alone: Rows[] };
  changed(text: string, factor: number, what: "by" | "centre" | "axis" | "angle" | "linear", to: number[]): AlgebraError | { text: string };
}

export interface PlayerEventMap extends HTMLElementEventMap {
  /** A script was read, with or without errors. */
  diagnostics: CustomEvent<{ diagnostics: Diagnostic[] }>;
  /** The film reached a note of its script. */
  note: CustomEvent<{ text: string; time: number }>;
}

/** `<betwixt-player>`: a film with the interface of a video. */
export class BetwixtPlayer extends HTMLElement {
  static readonly observedAttributes: string[];
  static readonly NETWORK_EMPTY: 0;
  static readonly NETWORK_IDLE: 1;
  static readonly NETWORK_LOADING: 2;
  static readonly NETWORK_NO_SOURCE: 3;
  static readonly HAVE_NOTHING: 0;
  static readonly HAVE_METADATA: 1;
  static readonly HAVE_CURRENT_DATA: 2;
  static readonly HAVE_FUTURE_DATA: 3;
  static readonly HAVE_ENOUGH_DATA: 4;

  src: string;
  readonly currentSrc: string;
  poster: string;
  alt: string;
  autoplay: boolean;
  loop: boolean;
  controls: boolean;
  /** Whether the film is silent. The attribute of this name sets it first. */
  muted: boolean;
  /** The attribute `muted`. */
  defaultMuted: boolean;
  /** From 0 to 1. */
  volume: number;
  /** Shows only the film's own frames, and none between them. */
  stepped: boolean;
  /** "none" loads nothing until the film plays. */
  preload: string;
  /** "eager" loads the film wherever on the page it is. */
  loading: "eager" | "lazy";
  width: number;
  height: number;

  readonly networkState: number;
  readonly readyState: number;
  readonly error: { readonly code: number; readonly message: string } | null;
  readonly paused: boolean;
  readonly ended: boolean;
  readonly seeking: boolean;
  /** NaN while there is no film. */
  readonly duration: number;
  readonly videoWidth: number;
  readonly videoHeight: number;
  /** Seconds since the film's beginning. */
  currentTime: number;
  /** Negative rates run backwards; 0 stops. */
  playbackRate: number;

  play(): Promise<void>;
  pause(): void;
  /** Starts again with the page's own source. */
  load(): void;
  getVideoPlaybackQuality(): { creationTime: number; totalVideoFrames: number; droppedVideoFrames: number };

  /** The engine's film, or null. It is disposed of when you set another script. */
  readonly film: Film | null;
  readonly diagnostics: Diagnostic[];
  /** The diagnostics as text; empty if there are none. */
  readonly message: string;
  /** The film's text. Set it to show another film at the same time; if it has errors, the last good film stays. */
  script: string;
  /** The film's files, by their names in the script. */
  get files(): Record<string, Uint8Array>;
  set files(all: Record<string, string | Uint8Array | ArrayBuffer>);
  /** Other values for the script's lets. */
  get lets(): Record<string, string | number>;
  set lets(all: Record<string, string | number>);
  /** Returns a value at a time since the film's beginning, by default now. `eval<number[]>(…)` declares its type. */
  eval<T extends Value = Value>(target: string, time?: number | string): T;

  addEventListener<K extends keyof PlayerEventMap>(
    type: K, listener: (this: BetwixtPlayer, event: PlayerEventMap[K]) => void,
    options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject,
                   options?: boolean | AddEventListenerOptions): void;
}

/** `<betwixt-editor>`: a text box beside the player inside it. */
export class BetwixtEditor extends HTMLElement {
  readonly player: BetwixtPlayer | null;
  text: string;
  /** Puts the cursor at a line and column, both from 1. */
  go(line: number, column?: number): void;
}

/** Returns the engine of the page. The first call makes it. */
export function engine(): Promise<Engine>;

/** The attributes of the player's tag in TypeScript markup. */
export interface PlayerAttributes {
  src?: string | undefined;
  alt?: string | undefined;
  poster?: string | undefined;
  autoplay?: boolean | "" | undefined;
  loop?: boolean | "" | undefined;
  controls?: boolean | "" | undefined;
  muted?: boolean | "" | undefined;
  volume?: number | string | undefined;
  stepped?: boolean | "" | undefined;
  preload?: string | undefined;
  loading?: "eager" | "lazy" | undefined;
  width?: number | string | undefined;
  height?: number | string | undefined;
  playbackrate?: number | string | undefined;
  class?: string | undefined;
  part?: string | undefined;
  /** These are properties. React sets them from version 19 on. */
  script?: string | undefined;
  files?: Record<string, string | Uint8Array | ArrayBuffer> | undefined;
  currentTime?: number | undefined;
  playbackRate?: number | undefined;
}
/** React listens to events of elements from version 19 on. */
export type PlayerHandlers = {
  [K in "loadstart" | "durationchange" | "resize" | "loadedmetadata" | "loadeddata" | "canplay" | "canplaythrough" | "play"
    | "playing" | "waiting" | "pause" | "timeupdate" | "seeking" | "seeked" | "ratechange" | "ended" | "emptied" | "error"
    as `on${K}`]?: ((event: Event) => void) | undefined;
} & {
  [K in "diagnostics" | "note" as `on${K}`]?: ((event: PlayerEventMap[K]) => void) | undefined;
};
type Tag<Usual, Own> = Own & Omit<Usual, keyof Own>;

// Each of these takes effect if the framework is installed; otherwise the compiler ignores it.
// @ts-ignore
import type {} from "react";
// @ts-ignore
declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      // @ts-ignore
      "betwixt-player": Tag<DetailedHTMLProps<HTMLAttributes<BetwixtPlayer>, BetwixtPlayer>, PlayerAttributes & PlayerHandlers>;
      // @ts-ignore
      "betwixt-editor": Tag<DetailedHTMLProps<HTMLAttributes<BetwixtEditor>, BetwixtEditor>, { class?: string | undefined }>;
    }
  }
}
// @ts-ignore
import type {} from "preact";
// @ts-ignore
declare module "preact" {
  namespace JSX {
    interface IntrinsicElements {
      // @ts-ignore
      "betwixt-player": Tag<IntrinsicElements["div"], PlayerAttributes & PlayerHandlers & { ref?: import("preact").Ref<BetwixtPlayer> }>;
      // @ts-ignore
      "betwixt-editor": Tag<IntrinsicElements["div"], { class?: string | undefined; ref?: import("preact").Ref<BetwixtEditor> }>;
    }
  }
}
// @ts-ignore
import type {} from "solid-js";
// @ts-ignore
declare module "solid-js" {
  namespace JSX {
    interface IntrinsicElements {
      // @ts-ignore
      "betwixt-player": Tag<HTMLAttributes<BetwixtPlayer>, PlayerAttributes & PlayerHandlers & SolidPlayer>;
      // @ts-ignore
      "betwixt-editor": Tag<HTMLAttributes<BetwixtEditor>, { class?: string | undefined }>;
    }
  }
}
interface SolidPlayer {
  "on:diagnostics"?: PlayerHandlers["ondiagnostics"];
  "on:note"?: PlayerHandlers["onnote"];
  "prop:script"?: string | undefined;
  "prop:files"?: PlayerAttributes["files"];
}

declare global {
  interface HTMLElementTagNameMap {
    "betwixt-player": BetwixtPlayer;
    "betwixt-editor": BetwixtEditor;
  }
  /** The global that betwixt-player.js defines. */
  var Betwixt: { engine: typeof engine; Player: typeof BetwixtPlayer; Editor: typeof BetwixtEditor };
}
