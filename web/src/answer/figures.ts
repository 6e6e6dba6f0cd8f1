// Line drawings, as the program made them. They are read as XML, so that they hold drawings and nothing else.
import type { Figure } from "../document";
import { element, scrolling } from "../element";

const forbidden = "script, foreignObject, iframe, a, image, use[href^='http'], animate, set";

export function drawing(svg: string, title: string): Element {
  const parsed = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  if (parsed.nodeName !== "svg") return element("p", {}, "The drawing cannot be read.");
  for (const unwanted of parsed.querySelectorAll(forbidden)) unwanted.remove();
  parsed.setAttribute("role", "img");
  parsed.setAttribute("aria-label", title);
  return document.importNode(parsed, true);
}

const figureTitle = (figure: Figure): string =>
  figure.situation === "" ? figure.title : `${figure.title} (${figure.situation.replaceAll("_", " ")})`;

// In units of a drawing: one that is wider has letters that nobody reads at the width of a phone.
const readable = 640;

export function figureNode(figure: Figure): HTMLElement {
  const shown = drawing(figure.svg, figure.title);
  const wide = Number(shown.getAttribute("width")) > readable;
  if (wide) shown.classList.add("wide");
  return element(
    "figure",
    {},
    wide ? scrolling(figureTitle(figure), shown) : shown,
    element("figcaption", {}, figureTitle(figure)),
  );
}
