// Elements of the page. Text becomes text, never HTML.

export type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | undefined | ((event: never) => void)>;

// An element with attributes; one whose name begins with "on" is a listener. Attributes that are undefined or false are
// left out.
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") made.addEventListener(name.slice(2), value as EventListener);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== undefined && value !== false) made.setAttribute(name, String(value));
  }
  append(made, children);
  return made;
}

export function append(parent: Node, children: Child[]): void {
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    parent.appendChild(typeof child === "string" ? document.createTextNode(child) : child);
  }
}

let ids = 0;
// An identifier that no other element of the page has.
export function fresh(prefix: string): string {
  ids += 1;
  return `${prefix}-${ids}`;
}

// What may be wider than a phone scrolls by itself, by keyboard too.
export function scrolling(label: string, ...children: Child[]): HTMLElement {
  return element("div", { class: "scrolling", role: "group", "aria-label": label, tabindex: 0 }, ...children);
}

// A section of the page with its heading.
export function section(title: string, ...children: Child[]): HTMLElement {
  const id = fresh("section");
  return element("section", { "aria-labelledby": id }, element("h2", { id }, title), ...children);
}
