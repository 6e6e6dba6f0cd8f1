// Line drawings, as the program made them. They are read as XML, so that they hold drawings and nothing else.
import type { Figure } from "../document";
import { element, fresh, scrolling } from "../element";

const forbidden = "script, foreignObject, iframe, a, image, use[href^='http'], animate, set";

// Several drawings stand on one page: each gets identifiers of its own.
function renameIdentifiers(svg: Element): void {
  const names = new Map<string, string>();
  for (const one of svg.querySelectorAll("[id]")) {
    names.set(one.id, fresh("drawing"));
    one.id = names.get(one.id) ?? one.id;
  }
  const renamed = (old: string): string => names.get(old) ?? old;
  for (const one of [svg, ...svg.querySelectorAll("*")]) {
    for (const attribute of [...one.attributes]) {
      if (attribute.name.startsWith("aria-")) {
        if (/^aria-(labelled|described)by$/.test(attribute.name)) {
          one.setAttribute(attribute.name, attribute.value.split(/\s+/).map(renamed).join(" "));
        }
      } else if (attribute.value.includes("#")) {
        const value = attribute.value.replace(/^#(.+)$|url\(#([^)]+)\)/g, (_, plain?: string, inside?: string) =>
          plain === undefined ? `url(#${renamed(inside ?? "")})` : `#${renamed(plain)}`,
        );
        if (value !== attribute.value) one.setAttribute(attribute.name, value);
      }
    }
  }
}

export function drawing(svg: string, title: string): Element {
  const parsed = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  if (parsed.nodeName !== "svg") return element("p", {}, "The drawing cannot be read.");
  for (const unwanted of parsed.querySelectorAll(forbidden)) unwanted.remove();
  renameIdentifiers(parsed);
  parsed.setAttribute("role", "img");
  if (!parsed.hasAttribute("aria-labelledby")) parsed.setAttribute("aria-label", title);
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
