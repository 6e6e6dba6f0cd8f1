// The scene of a solution, as the program's own description of it says (poinsot/scene.h). Numbers are in SI units.

export type Vector = [number, number, number];
export const ground = -1;

export interface Place {
  body: number;
  at: Vector;
}

export interface Pose {
  R: number[]; // row by row
  p: Vector;
}

export interface Shape {
  kind: string;
  part: string;
  extent: "point" | "line" | "surface" | "volume";
  hole: boolean;
  added: boolean;
  stand_in: boolean; // a solid with the moments of inertia of a body whose shape is not stated
  vertices: Vector[];
  triangles: [number, number, number][];
  normals: [Vector, Vector, Vector][];
  edges: number[][];
}

export interface Body {
  name: string;
  frame: boolean;
  massless: boolean;
  mass: number;
  center: Vector;
  shapes: Shape[];
  pose: Pose;
}

export interface NamedPoint {
  name: string;
  place: Place;
}

export interface JointSymbol {
  kind: string;
  name: string;
  from: number;
  to: number;
  place: Place;
  axis: Vector;
  second_axis: Vector;
}

export interface Link {
  kind: "cord" | "spring" | "damper" | "torsion";
  name: string;
  from: Place;
  to: Place;
  far: boolean;
  slack: boolean;
  symbol?: string; // TeX, of a part whose tension is asked for
}

export interface Arrow {
  quantity: string;
  name: string;
  body: number;
  at: Place;
  vector: Vector;
  symbol: string; // TeX
  text: string;
  value?: number; // left out with its unit where it is open
  unit?: string;
  formula: string;
  known: boolean;
  swings?: boolean; // whether it is an amplitude
  open?: boolean; // whether the equations leave its size open: `vector` is then a unit vector
}

export interface Diagram {
  kind: string;
  title: string;
  group: number;
  bodies: number[];
  arrows: Arrow[];
}

export interface Dimension {
  name: string;
  text: string;
  angle: boolean;
  from: Place;
  to: Place;
  corner: Place;
  axis?: Vector;
}

export interface Curve {
  kind: string;
  name: string;
  body: number;
  closed: boolean;
  points: Vector[];
}

// Where a cord lies on a wheel: from the end of one straight part, right-handed about the axis, to the next one's.
export interface Wrap {
  name: string;
  comes: number; // the link at whose `from` it begins
  leaves: number; // the link at whose `to` it ends
  center: Place;
  axis: Vector;
}

export interface Cone {
  name: string;
  body: number;
  apex: Vector;
  axis: Vector;
  half_angle: number;
  touching_line: Vector;
}

export interface Plot {
  name: string;
  words: string;
  unit: string;
  labels: string[];
  values: number[][];
}

// A vector that changes during a motion.
export interface MovingArrow {
  quantity: string;
  name: string;
  at: Place;
  symbol: string;
  text: string;
  unit: string;
  factor: number; // SI of one of the unit
  vectors: number[]; // three for each time
}

// The ends of a link that do not ride on its bodies, on ground axes: three numbers for each time.
export interface MovingLink {
  link: number;
  from: number[];
  to: number[];
}

export interface Motion {
  times: number[];
  bodies: { position: number[]; orientation: number[] }[]; // three and four numbers (w x y z) for each time
  plots: Plot[];
  arrows: MovingArrow[];
  links?: MovingLink[];
  events: { time: number; words: string }[];
  complete: boolean;
  stopped: string;
}

export interface Scene {
  situation: string;
  axes: [string, string, string];
  up: Vector;
  viewer?: Vector; // from where the statement wants it to be looked at
  gravity: boolean;
  length: number;
  bodies: Body[];
  points: NamedPoint[];
  symbols: JointSymbol[];
  links: Link[];
  wraps?: Wrap[];
  diagrams: Diagram[];
  dimensions: Dimension[];
  curves: Curve[];
  cones: Cone[];
  motion?: Motion;
  drawn_letters: { name: string; unit: string; value: number }[];
}
