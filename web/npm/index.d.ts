/** A preset's name, "real", "d3d11", "vulkan", ..., or a profile as an object. */
export type Profile = string | { [key: string]: unknown };
export type Outcome = "holds" | "violated" | "inconclusive";
export type Numbers = ArrayLike<number>;

/** A draw onto its own empty target. Coordinates are exact: float32 numbers, unless asked for more. */
export interface Request {
  width: number;
  height: number;
  /** Of a pixel; the profile says where they lie. */
  samples: number;
  /** Clip space: x and y already in pixels, window = x/w, y/w. */
  clip: boolean;
  cull: "front" | "back" | null;
  /** x0, y0, x1, y1: half-open, rows from the top. */
  scissor: [number, number, number, number] | null;
  /** x, y, z, w of each vertex. */
  vertices: Float64Array;
  /** Three vertices of each triangle. */
  triangles: Int32Array;
  /** Of fragments, what is to be returned beside ids. */
  wants: ("barycentrics" | "depths" | "centroids" | "values" | "derivatives")[];
  /** What is to be interpolated. */
  channels: Channel[];
}
export interface Channel {
  interpolation: "flat" | "linear" | "perspective" | "inverse-w";
  at: "sample" | "centre" | "centroid";
  /** A number a vertex; null of 1/w. */
  values: Float64Array | null;
}
/** What is visible at each sample, [height][width][sample], top row first; anything where nothing is. */
export interface Fragments {
  /** The triangle; -1: none. */
  ids: Numbers;
  /** Three a sample. */
  barycentrics?: Numbers;
  depths?: Numbers;
  /** The barycentrics where values at the centroid are evaluated. */
  centroids?: Numbers;
  /** One of each channel, in their order. */
  values?: Numbers;
  /** Of each channel its derivatives by x and by y. */
  derivatives?: Numbers;
}

/** How many triangles cover each sample, [height][width][sample], top row first; or fragments. */
export type Drawing = Numbers | Fragments;
export type Draw = (request: Request) => Drawing | Promise<Drawing>;

export interface SubjectOptions {
  name?: string;
  input?: "float32" | "float64";
  /** What draw() returns. Of facing-counts those of back faces follow those of front faces. */
  coverage?: "counts" | "facing-counts" | "mask" | "primitive-id" | "fragments";
  visible?: "last-drawn" | "first-drawn";
  /** Of fragments, beside barycentrics and depths. Which values is said by the profile. */
  shows?: ("centroids" | "values" | "derivatives")[];
  takes?: ("window" | "clip" | "culling" | "scissor")[];
}
export interface CheckOptions {
  subject?: SubjectOptions;
  /** Names of the catalogue; all of them if left out. */
  properties?: string[];
  /** Of each property; 1000 if left out. */
  cases?: number;
  seed?: number;
  /** The most evaluations that shrinking takes. */
  shrink?: number;
  /** Finds the model by experiment, too: some thousands of draws. */
  infer?: boolean;
  /** Looks for what explains the failures, too, by some hundreds of draws. check() does unless false. */
  causes?: boolean;
  onProgress?: (progress: { done: number; of: number }) => void;
}
/** Counts of each sample, [height][width][sample], of the failing scene around the failing pixel. */
export interface Picture {
  /** Its first column and row. */
  x: number;
  y: number;
  width: number;
  height: number;
  samples: number;
  expected: number[];
  actual: number[];
  /** The exact E opposite each vertex at the failing sample; none of a triangle that is not finite. */
  edges: { triangle: number; values: string[] }[];
}
/** All models that explain every draw. */
export interface Model {
  subpixelBits: (number | "none")[];
  snap: string[];
  ties: string;
  samples: string;
}
export interface Failure {
  property: string;
  outcome: string;
  clause: string;
  required_by: string[];
  fails: boolean;
  /** The name of its cause, a section of docs/causes.md, or "none"; null: none was looked for. */
  cause: string | null;
  message: string;
  pixel?: [number, number];
  sample?: number;
  triangle?: number;
  expected: string;
  actual: string;
  /** The case before it was shrunk. */
  drawn_as: string;
  /** A case file: `rasterproof replay` runs it. */
  case: unknown;
  /** The command that does so. */
  next: string;
  /** The sentences of the specification that require the property. */
  clauses: { id: string; place: string; sentence: string; reading: string }[];
  picture?: Picture;
}
/** What explains failures. */
export interface Cause {
  cause: string;
  text: string;
  /** The different scenes, drawn wrong, that it rests on. */
  wrong_scenes: number;
  too_few: boolean;
  properties: string[];
}
export interface PropertyOutcome {
  property: string;
  outcome: string;
  fails: boolean;
  cases: number;
  exercised: number;
  refused: number;
  message: string;
}
/** What `rasterproof check --json` writes of one subject. */
export interface Result {
  subject: string;
  profile: string;
  version: string;
  status: number;
  outcome: Outcome;
  unasked: { statement: string; by: string }[];
  failures: Failure[];
  causes: Cause[];
  properties: PropertyOutcome[];
  /** If asked for by `infer`: null if none fits, and what `rasterproof infer` says in a line. */
  model?: Model | null;
  model_text?: string;
}

export class Refused extends Error {}
export function check(draw: Draw, profile?: Profile, options?: CheckOptions): Promise<Result>;
export function describe(result: Result): string;
export function assertRasterizes(
  draw: Draw,
  profile?: Profile,
  options?: CheckOptions,
): Promise<Result>;
export const matchers: {
  toRasterize(
    draw: Draw,
    profile?: Profile,
    options?: CheckOptions,
  ): Promise<{ pass: boolean; message: () => string }>;
};

export type Point = [number, number];
export interface CoversQuestion {
  triangle: [Point, Point, Point];
  /** Column and row of the pixel. */
  pixel: Point;
  sample?: number;
  profile?: Profile;
  width?: number;
  height?: number;
}
export interface CoversAnswer {
  /** "may": legal rasterizers differ. */
  covers: "must" | "may" | "must not";
  facing: -1 | 0 | 1;
  at: Point;
  placed?: number[];
  edges?: number[];
  edges_exact?: string[];
  barycentrics?: number[];
  barycentrics_exact?: string[];
}
/** A scene file of rasterproof. */
export type Scene = { rasterproof_scene: 1; [key: string]: unknown };
export interface Drawn {
  width: number;
  height: number;
  profile: Profile;
  counts: number[];
  triangles?: { edges: number[] | null; barycentrics: number[] | null }[];
}
export const oracle: {
  covers(question: CoversQuestion): Promise<CoversAnswer>;
  draw(method: string, scene: Scene, at?: Point): Promise<Drawn>;
  methods(): Promise<string[]>;
};

export type Answer = { counts: Numbers } | { fragments: Fragments } | { refused: string } | { fault: string };
/** One instance of the module, and one check at a time: for drawers of a page. */
export class Engine {
  static create(): Promise<Engine>;
  readonly memoryBytes: number;
  open(options: Omit<CheckOptions, "onProgress"> & { profile?: Profile }): void;
  next(): Request[];
  answer(answers: Answer[]): void;
  progress(): { done: number; of: number };
  save(): Uint8Array;
  load(saved: Uint8Array): void;
  /** `opened` is what open() was given: with save() the command derives all of it again. */
  result(): {
    version: string;
    status: number;
    opened: object;
    subjects: Omit<Result, "outcome" | "version">[];
  };
  covers(question: CoversQuestion): CoversAnswer;
  draw(method: string, scene: Scene, at?: Point): Drawn;
  methods(): string[];
}
export function useModule(bytesOrModule: BufferSource | WebAssembly.Module): void;
