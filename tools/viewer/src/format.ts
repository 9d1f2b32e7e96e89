// What a report holds: the contract between the writer (engine/report) and this viewer.
//
// A report is one page. Its data are chunks: <script type="application/x-campuswalk" data-chunk="N">, numbered
// from 0 in the order of the file, and one named "index" after all others. A chunk's text is base64 of gzip of
// bytes; a picture's, which has a data-type, is base64 of the picture itself.
//
// Lengths are metres, +Y is up, angles as named. Lists may be missing where they are optional (`?`), and unknown
// keys are ignored, so that an older viewer reads a newer report of the same version.

export type Point = [number, number, number];

export type Outcome = 'passed' | 'failed' | 'skipped' | 'bad_input' | 'broken' | 'interrupted';
export type Mode = 'solid' | 'trigger' | 'ray';
export type Shape = 'mesh' | 'box' | 'sphere' | 'capsule' | 'wheel';

/** The chunk "index". */
export interface Index {
  campuswalk_report: 1;
  title: string;
  generator: string;
  /** Whether every planned walk is in it. */
  complete: boolean;
  /** What the writer couldn't do, one sentence each. */
  problems?: string[];
  campuses: CampusEntry[];
  walks: WalkRow[];
  against?: Against | null;
  findings?: Finding[] | null;
  /** The command that the run was started with. */
  command?: string;
  /** Plays one walk again; {file}, {project}, {config} and {name} are replaced, and what is in [brackets] is left
   * out if a placeholder in it is empty. */
  replay?: string;
}

export interface CampusEntry {
  name: string;
  file: string;
  /** Null: boxes of the objects stand in for it. */
  geometry: { chunk: number; kind: 'exact' | 'simplified'; error: number } | null;
  min: Point;
  max: Point;
  objects: CampusObject[];
  buildings: Building[];
  spawns?: { name: string; at: Point; yaw_deg?: number }[];
  places?: { name: string; at: Point }[];
  /** Height of each floor, ascending. */
  storeys?: number[];
  light?: { sun_direction?: Point };
}

/** An object of the campus; nodes of the geometry name it by its index (`extras.objects`). */
export interface CampusObject {
  id: string;
  /** Index of its building, or -1. */
  building: number;
  modes: Mode[];
  shape: Shape;
  /** Bounds in the world. */
  min: Point;
  max: Point;
  /** Of every shape but a mesh. */
  center?: Point;
  /** Of a box. */
  size?: Point;
  /** Columns: the shape's axes in the world. A capsule lies along Y, a wheel's axle along X. */
  axes?: number[];
  radius?: number;
  /** Of a capsule, from end to end. */
  height?: number;
  /** Of a wheel. */
  width?: number;
}

export interface Building {
  id: string;
  title: string;
  text?: string;
  kind?: string;
  hours?: string;
  floors?: number;
  info?: { name: string; value: string }[];
}

/** A line of the list; what a walk did in detail is in chunk `chunk`, line `line`. */
export interface WalkRow {
  id: string;
  file: string;
  name: string;
  project: string;
  repetition: number;
  tags: string[];
  outcome: Outcome;
  expected_to_fail: boolean;
  status_reason?: string;
  seconds: number;
  ticks: number;
  distance: number;
  /** Index, or -1. */
  campus: number;
  /** -1: there is nothing more to know. */
  chunk: number;
  line: number;
  /** Chunk of a picture, or -1. */
  thumbnail?: number;
  /** The first failure or diagnostic, shortened. */
  message?: string;
  code?: string;
  /** The path in a few points: x, z, x, z … in decimetres, each minus the one before. */
  plan?: number[];
}

export interface Against {
  name: string;
  /** Those that ended otherwise, or walked elsewhere. */
  walks: AgainstRow[];
}

export interface AgainstRow extends WalkRow {
  /** Of the same walk in `walks`, or -1 if this run lacks it: then there are no details either. */
  index: number;
  /** The first tick at which the two differ; null if their paths don't, -1 if not both were recorded. */
  parts_at: number | null;
}

export interface Finding {
  campus: number;
  number: number;
  kind: string;
  subject: string;
  text: string;
  /** None: it is nowhere, as a building that nothing belongs to. */
  at?: Point;
}

/** A line of a chunk of details. */
export interface Details {
  result: WalkResult;
  recording: Recording | null;
  /** From an artifact's path to the chunk of its picture. */
  pictures?: Record<string, number>;
  /** Texts of the files that failures point into. */
  source?: Record<string, string> | null;
}

/** A line of `--reporter jsonl`: config/schema/report.schema.json. */
export interface WalkResult {
  id: string;
  file: string;
  name: string;
  project: string;
  config?: string;
  repetition: number;
  tags: string[];
  status_reason: string;
  expected_to_fail: boolean;
  outcome: Outcome;
  failures: Failure[];
  complaints: Complaint[];
  campus: string;
  ticks_per_second: number;
  timeout: number | null;
  ticks: number;
  events: number;
  distance: number | string;
  not_evaluated: number;
  hash: string;
  artifacts: Artifact[];
}

/** An error about an input file, which kept the walk from being played. */
export interface Complaint {
  code: string;
  message: string;
  file: string;
  /** From 1; 0 for the file as a whole. */
  line: number;
  column: number;
}

export interface Failure {
  code: string;
  message: string;
  file: string;
  line: number;
  column: number;
  scene?: FailureScene | null;
  /** What kept the visitor from where it should have got; the message words it. */
  reason?: Reason;
  /** Id of the object that it is about. */
  object?: string;
  /** What happened, and what was expected instead, where the message has both in few words. */
  actual?: string;
  expected?: string;
}

/** engine/events/reason.h; members that are empty are left out. */
export interface Reason {
  /** "riser", "no_ground" … */
  kind: string;
  object?: string;
  node?: string;
  at?: Point;
  look_at?: Point;
  measured?: number;
  allowed?: number;
  /** Of slopes. */
  measured_deg?: number;
  allowed_deg?: number;
  parts?: Reason[];
}

export interface FailureScene {
  tick: number;
  time: number;
  position: Point;
  yaw_rad: number;
  pitch_rad: number;
  building: string;
  nearest: string;
  nearest_distance: number;
  /** Where the reason was measured, or what the body touches. */
  contact?: Point | null;
  last_events: string[];
}

export interface Artifact {
  name: string;
  path: string;
  media_type: string;
}

/** What `--record report` keeps of a walk. */
export interface Recording {
  campuswalk_recording: 1;
  ticks_per_second: number;
  ticks: number;
  avatar: Avatar;
  way: KeyFrames;
  steps?: Step[];
  popups?: Popup[];
  contacts?: Contact[];
  /** Lines of the text log, without its header. */
  log: string[];
}

export interface Avatar {
  radius: number;
  height: number;
  eye_height: number;
  crouch_height?: number;
  crouch_eye_height?: number;
  gaze_distance?: number;
}

/** Between key frames everything is linear in the tick. Each number but the first is a difference. */
export interface KeyFrames {
  tick: number[];
  /** Whole millimetres. */
  x: number[];
  y: number[];
  z: number[];
  /** Whole tenths of a degree, yaw unwrapped. */
  yaw: number[];
  pitch: number[];
  /** Indexes of key frames that are reached by a jump: the one before holds until then. */
  cut?: number[];
}

export interface Step {
  text: string;
  file: string;
  line: number;
  from: number;
  to: number;
}

export interface Popup {
  building: string;
  title: string;
  text: string;
  from: number;
  to: number;
}

export interface Contact {
  tick: number;
  to: number;
  object: string;
  point: Point;
  normal: Point;
}
