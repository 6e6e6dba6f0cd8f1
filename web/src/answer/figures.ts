// Line drawings, as the program made them. They are read as XML, so that they hold drawings and nothing else.
import type { Figure } from "../document";
import { element } from "../element";

const forbidden = "script, foreignObject, iframe, a, image, use[href^='http'], animate, set";

export function drawing(svg: string, title: string): Element {
  const parsed = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  if (parsed.nodeName !== "svg") return element("p", {}, "The drawing cannot be read.");
  for (const unwanted of parsed.querySelectorAll(forbidden)) unwanted.remove();
  parsed.setAttribute("role", "img");
  if (!parsed.hasAttribute("aria-labelledby")) parsed.setAttribute("aria-label", title);
  return document.importNode(parsed, true);
}

export function figureNode(figure: Figure): HTMLElement {
  return element("figure", {}, drawing(figure.svg, figure.title), element("figcaption", {}, figure.title));
}
