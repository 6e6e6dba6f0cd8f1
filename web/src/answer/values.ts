// Values and formulas of answers, typeset.
import type { Datum } from "../document";
import { type Child, element, scrolling } from "../element";
import { math } from "../text/math";
import { numberTex, rounded, roundedTogether } from "../text/numbers";
import { escapedTex, formulaTex, unitTex } from "../text/tex";

const allNumbers = (list: Datum[]): list is number[] => list.every((item) => typeof item === "number");

function listTex(list: Datum[], vector: boolean): string {
  if (list.length > 1 && list.every((row) => Array.isArray(row) && row.length > 1)) {
    const rows = (list as Datum[][]).map((row) =>
      (allNumbers(row) ? roundedTogether(row).map(numberTex) : row.map((item) => datumTex(item, false))).join(" & "),
    );
    return `\\begin{bmatrix} ${rows.join(" \\\\ ")} \\end{bmatrix}`;
  }
  const items = allNumbers(list)
    ? (vector ? roundedTogether(list) : list.map(rounded)).map(numberTex)
    : list.map((item) => datumTex(item, false));
  const inside = items.join(",\\; ");
  return vector ? `\\left(${inside}\\right)` : `\\left[${inside}\\right]`;
}

// The TeX of a value, or of formulas, which are texts in a document.
export function datumTex(datum: Datum, vector: boolean): string {
  if (typeof datum === "number") return numberTex(rounded(datum));
  if (typeof datum === "string") return formulaTex(datum) ?? `\\texttt{${escapedTex(datum)}}`;
  if (typeof datum === "boolean") return `\\text{${String(datum)}}`;
  if (datum === null) return "\\text{none}";
  return datum.length === 0 ? "\\text{none}" : listTex(datum, vector);
}

// A value with its unit. A text that is a value stays a text.
export function valueNode(datum: Datum, unit: string, vector: boolean): Child {
  if (typeof datum === "string") return datum;
  if (typeof datum === "boolean") return datum ? "yes" : "no";
  if (Array.isArray(datum) && datum.length > 0 && datum.every((item) => typeof item === "string")) {
    return datum.join(", ");
  }
  const gap = unit === "" || unit === "deg" ? "" : "\\;";
  return math(datumTex(datum, vector) + gap + unitTex(unit));
}

// A formula; those of a vector one below the other, where side by side they would be long.
export function formulaLines(datum: Datum, axes: string[], label: string): HTMLElement {
  if (Array.isArray(datum) && axes.length === datum.length && JSON.stringify(datum).length > 60) {
    const lines = datum.map((item, i) => `\\text{${escapedTex(axes[i] ?? "")}:} && ${datumTex(item, false)}`);
    return scrolling(label, math(`\\begin{aligned} ${lines.join(" \\\\[0.4em] ")} \\end{aligned}`, true));
  }
  const on = axes.length > 0 && element("span", { class: "faint" }, ` on ${axes.join(", ")}`);
  return scrolling(label, math(`\\displaystyle ${datumTex(datum, axes.length > 0)}`), on);
}

// A comparison such as "a > 0", typeset if it is one of formulas.
export function conditionNode(text: string): Child {
  const tex = formulaTex(text);
  return tex === null ? element("span", {}, text) : math(tex);
}
