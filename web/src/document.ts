// What the program writes into the page: the answer document, and what belongs to it. Names are those of the JSON.
import type { Scene, Vector } from "./scene";

export type Datum = number | boolean | string | null | Datum[];

export interface Column {
  name: string;
  unit: string;
  value: number[];
}

export interface Answer {
  ask: string;
  words?: string;
  value?: Datum;
  unit?: string;
  si?: Datum;
  axes?: string[];
  table?: { columns: Column[]; over?: Column };
  letters?: string[];
  determined?: boolean;
  refused?: boolean;
  reason?: string;
  formula?: Datum;
  no_formula?: string;
  formulas?: { formula: Datum; where: string[] }[];
  holds?: boolean;
  how?: string;
  counterexample?: {
    letters: Record<string, { value: number; unit: string }>;
    left?: number;
    right?: number;
    difference?: number;
    unit?: string;
  };
  assumptions?: string[];
}

export interface Unknown {
  value: Datum;
  unit: string;
  formula?: Datum;
}

export interface Solution {
  unknowns: Record<string, Unknown>;
  answers: Record<string, Answer>;
  checks: Record<string, number | null>;
  assumptions?: string[];
  conditions?: { words: string; formula: string }[];
  notes?: string[];
  explanation?: string;
  scene?: Scene;
  other_scenes?: Scene[]; // of the other situations
}

export interface AnswerDocument {
  poinsot: string;
  file: string;
  title: string;
  solutions: Solution[];
  warnings: string[];
  ended?: string;
}

export interface Named {
  name: string;
  text: string;
}

export interface Situation {
  name: string;
  data: Named[];
  letters: { name: string; unit: string }[];
  unknowns: { name: string; unit: string }[];
}

export interface Figure {
  title: string;
  section: string; // the heading of the worked solution's section to which it belongs; "" for none
  situation: string; // of several: which one it shows
  svg: string;
}

// One page: an answer document with the statement that it answers.
export interface PageData {
  document: AnswerDocument;
  problem: { name: string; text: string };
  situations: Situation[];
  questions: Named[];
  claims: Named[];
  figures: Figure[][]; // of each solution
  // Of each body of each scene of each solution: what joins its shapes with what holds it.
  arms: [Vector, Vector][][][][];
  gallery: string; // the address of the index; "" if the page stands alone
}

export interface GalleryEntry {
  page: string;
  figure: string; // the address of the thumbnail; "" if there is none
  title: string;
  file: string;
  kinds: string[];
  note: string; // why there is no page; else ""
}

export interface GalleryData {
  title: string;
  entries: GalleryEntry[];
}
