// Typeset formulas. KaTeX makes MathML beside what is seen, which screen readers read.
import katex from "katex";
import { element } from "../element";

// Mechanics writes its angle as a round letter; a name that asks for the other form gets it.
const roundPhi = (tex: string): string =>
  tex.replace(/\\(var)?phi(?![A-Za-z])/g, (_, other?: string) => (other === undefined ? "\\varphi" : "\\phi"));

export function math(tex: string, display = false): HTMLElement {
  const place = element("span", { class: display ? "math display" : "math" });
  try {
    katex.render(roundPhi(tex), place, { displayMode: display, throwOnError: true, strict: "ignore", maxExpand: 1000 });
  } catch {
    place.replaceChildren(element("code", {}, tex));
  }
  return place;
}
