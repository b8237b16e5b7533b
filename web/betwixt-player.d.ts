// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0

/** What there is to say of a script. Lines and columns begin at 1; columns count characters (code points). */
export interface Diagnostic {
  severity: "error" | "warning" | "notice";
  text: string;
  /** What may help; may be empty. */
  hint: string;
  file: string;
  /** 0: of the file as a whole. */
  line: number;
  column: number;
  /** The text of the line. */
  source: string;
}

/** A number, several (a vector, a colour, the 16 of a matrix row by row), points, on or off, words, names, no object. */
export type Value = number | number[] | number[][] | boolean | string | string[] | null;

/** A film that has been opened. Times are those of its script, in seconds: frame 1 is 0. */
export interface Film {
  /** false: it has errors, and only the diagnostics can be asked for. */
  readonly ok: boolean;
  readonly diagnostics: Diagnostic[];
  /** All of them as a terminal shows them, with caret lines. */
  readonly message: string;
  /** Files that it asked for and that were not given. */
  readonly wants: string[];
  readonly start: number;
  readonly end: number;
  readonly duration: number;
  readonly fps: number;
  readonly firstFrame: number;
  readonly lastFrame: number;
  /** What `note` says in the script, in the order of time. */
  readonly notes: { seconds: number; text: string }[];
  /** What the script says of its pictures, else 1280 x 720. */
  readonly width: number;
  readonly height: number;
  /** `background transparent`: where nothing is, the canvas is clear. */
  readonly clear: boolean;
  /** Draws in the canvas's own width and height. */
  draw(canvas: HTMLCanvasElement | OffscreenCanvas, seconds: number): void;
  /** A value, as `betwixt eval --json` has it. */
  eval<T extends Value = Value>(target: string, time: number | string, how?: { text?: false }): T;
  /** The same as `betwixt eval` prints it. */
  eval(target: string, time: number | string, how: { text: true }): string;
  /** Several at several times, as JSON of `betwixt eval --json`. */
  evalAll(targets: string[], times: (number | string)[], how?: { text?: false }): unknown;
  evalAll(targets: string[], times: (number | string)[], how: { text: true }): string;
  /** What code in the script did wrong while pictures were drawn. */
  problems(): Diagnostic[];
  /** Gives its memory back. */
  dispose(): void;
}

export interface Engine {
  readonly version: string;
  /** Brings what reads such files (meshes, scenes, drawings, pictures), where a film wants some. */
  prepare(files: Record<string, Uint8Array>): Promise<void>;
  /** Never throws for what is wrong with a script: see `Film.ok`. */
  open(text: string, how?: { name?: string; files?: Record<string, Uint8Array> }): Film;
  readonly algebra: Algebra;
}

/** What is wrong with a string of motions; column and length in characters, 0: of it as a whole. */
export interface AlgebraError {
  error: { message: string; hint: string; column: number; length: number };
}
/** Twelve numbers: the upper three rows of a matrix, row by row. */
export type Rows = number[];
/** x, y, z. */
export type Place = [number, number, number];

/** The algebra of motions, as lessons ask it: src/algebra/lesson.h. */
export interface Algebra {
  string(text: string, points?: Place[]): AlgebraError | {
    text: string;
    planar: boolean;
    unit: number;
    factors: { kind: "T" | "R" | "S"; text: string; by?: Place; turns?: number; centre?: Place; axis?: Place; linear?: boolean }[];
    symbols: object;
    alone: object[];
  };
  /** A(t) at count + 1 even times; undefined where the text is no motion. */
  frames(text: string, from: number, to: number, count: number, linear?: boolean): Rows[] | undefined;
  moment(text: string, t: number): AlgebraError | { matrix: Rows; letters: number[]; parts: Place[]; alone: Rows[] };
  changed(text: string, factor: number, what: "by" | "centre" | "axis" | "angle" | "linear", to: number[]): AlgebraError | { text: string };
}

export interface PlayerEventMap extends HTMLElementEventMap {
  /** A script has been read, well or not. */
  diagnostics: CustomEvent<{ diagnostics: Diagnostic[] }>;
  /** The film has come to a note of its script. */
  note: CustomEvent<{ text: string; time: number }>;
}

/** `<betwixt-player>`: a film that is used as a video is. */
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
  /** Films are silent in pages; it is here because videos have it. */
  muted: boolean;
  /** Shows the film's own frames only, and nothing between them. */
  stepped: boolean;
  /** "none": nothing is loaded before it is played. */
  preload: string;
  /** "eager": it is loaded wherever on the page it is. */
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
  /** Below 0 it runs backwards, at 0 it stands. */
  playbackRate: number;

  play(): Promise<void>;
  pause(): void;
  /** Begins anew with what the page says. */
  load(): void;
  getVideoPlaybackQuality(): { creationTime: number; totalVideoFrames: number; droppedVideoFrames: number };

  /** The engine's film; null while there is none. It goes when another text is given. */
  readonly film: Film | null;
  readonly diagnostics: Diagnostic[];
  /** The same as text; empty where nothing is wrong. */
  readonly message: string;
  /** The film's text. Another one is another film at the same time; a wrong one leaves the last good film where it is. */
  script: string;
  /** Files that the film uses, by the names that it has for them. */
  get files(): Record<string, Uint8Array>;
  set files(all: Record<string, string | Uint8Array | ArrayBuffer>);
  /** A value at a time since the film's beginning; now, where none is said. `eval<number[]>(…)` says what it is. */
  eval<T extends Value = Value>(target: string, time?: number | string): T;

  addEventListener<K extends keyof PlayerEventMap>(
    type: K, listener: (this: BetwixtPlayer, event: PlayerEventMap[K]) => void,
    options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject,
                   options?: boolean | AddEventListenerOptions): void;
}

/** `<betwixt-editor>`: the text beside the picture of the player within. */
export class BetwixtEditor extends HTMLElement {
  readonly player: BetwixtPlayer | null;
  text: string;
  /** Puts the cursor there. */
  go(line: number, column?: number): void;
}

/** The engine of the page, made when it is first asked for. */
export function engine(): Promise<Engine>;

/** What may stand in the player's tag, where markup is written in TypeScript. */
export interface PlayerAttributes {
  src?: string | undefined;
  alt?: string | undefined;
  poster?: string | undefined;
  autoplay?: boolean | "" | undefined;
  loop?: boolean | "" | undefined;
  controls?: boolean | "" | undefined;
  muted?: boolean | "" | undefined;
  stepped?: boolean | "" | undefined;
  preload?: string | undefined;
  loading?: "eager" | "lazy" | undefined;
  width?: number | string | undefined;
  height?: number | string | undefined;
  playbackrate?: number | string | undefined;
  class?: string | undefined;
  part?: string | undefined;
  /** These are properties: React sets them from 19 on. */
  script?: string | undefined;
  files?: Record<string, string | Uint8Array | ArrayBuffer> | undefined;
  currentTime?: number | undefined;
  playbackRate?: number | undefined;
}
/** React hears events of elements from 19 on. */
export type PlayerHandlers = {
  [K in "loadstart" | "durationchange" | "resize" | "loadedmetadata" | "loadeddata" | "canplay" | "canplaythrough" | "play"
    | "playing" | "waiting" | "pause" | "timeupdate" | "seeking" | "seeked" | "ratechange" | "ended" | "emptied" | "error"
    as `on${K}`]?: ((event: Event) => void) | undefined;
} & {
  [K in "diagnostics" | "note" as `on${K}`]?: ((event: PlayerEventMap[K]) => void) | undefined;
};
type Tag<Usual, Own> = Own & Omit<Usual, keyof Own>;

// Each of these counts where the framework is there; elsewhere the compiler has nothing to say about it.
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
  /** What the classic file, betwixt-player.js, leaves behind. */
  var Betwixt: { engine: typeof engine; Player: typeof BetwixtPlayer; Editor: typeof BetwixtEditor };
}
