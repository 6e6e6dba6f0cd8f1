// Typeset formulas. KaTeX makes MathML beside what is seen, which screen readers read.
import katex from "katex";
import { type Child, element } from "../element";
import { nameTex } from "./tex";

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

// Who shows the page in a frame may forbid its fonts, as notebooks in VS Code do: then the browser sets the MathML.
export function setByBrowserWithoutFonts(): void {
  document.addEventListener("securitypolicyviolation", ({ effectiveDirective }) => {
    if (effectiveDirective === "font-src") document.documentElement.classList.add("without-fonts");
  });
}

// Names with their values, "L = 600 mm" or "mu_s = 0.5, mu_k = 0.4": the names typeset, angles with their sign.
export function equations(text: string): Child[] {
  return text.split(", ").flatMap((one, k): Child[] => {
    const [name = "", ...value] = one.split(" = ");
    const rest = value.length > 0 ? ` = ${value.join(" = ").replace(/ deg$/, "°")}` : "";
    return [k > 0 && ", ", math(nameTex(name)), rest];
  });
}
