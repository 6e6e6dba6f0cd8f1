// Typeset formulas. KaTeX makes MathML beside what is seen, which screen readers read.
import katex from "katex";
import { element } from "../element";

export function math(tex: string, display = false): HTMLElement {
  const place = element("span", { class: display ? "math display" : "math" });
  try {
    katex.render(tex, place, { displayMode: display, throwOnError: true, strict: "ignore", maxExpand: 1000 });
  } catch {
    place.replaceChildren(element("code", {}, tex));
  }
  return place;
}
