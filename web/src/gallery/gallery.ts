// The index of a folder: a card for each problem, found by words and by kind.
import type { GalleryData, GalleryEntry } from "../document";
import { type Child, element } from "../element";

export function matches(entry: GalleryEntry, words: string, kinds: Set<string>): boolean {
  const text = `${entry.title} ${entry.file}`.toLowerCase();
  return (
    words
      .toLowerCase()
      .split(/\s+/)
      .every((word) => text.includes(word)) && [...kinds].every((kind) => entry.kinds.includes(kind))
  );
}

function card(entry: GalleryEntry): HTMLElement {
  const picture =
    entry.figure !== "" && element("img", { class: "thumb", src: entry.figure, alt: "", loading: "lazy" });
  const title = entry.title || entry.file;
  const name = entry.page === "" ? element("span", {}, title) : element("a", { href: entry.page }, title);
  return element(
    "li",
    { class: "card" },
    picture,
    element("h2", {}, name),
    element("p", { class: "faint" }, entry.file),
    entry.note !== "" && element("p", { class: "verdict fails" }, entry.note),
    entry.kinds.length > 0 &&
      element("p", { class: "kinds" }, ...entry.kinds.map((kind) => element("span", { class: "kind" }, kind))),
  );
}

export function galleryNodes(data: GalleryData): Child[] {
  const chosen = new Set<string>();
  const cards = data.entries.map((entry) => ({ entry, node: card(entry) }));
  const count = element("p", { role: "status", class: "faint" });
  const search = element("input", { type: "search", placeholder: "words of a title or file", "aria-label": "Search" });
  const refresh = (): void => {
    let found = 0;
    for (const { entry, node } of cards) {
      const shown = matches(entry, search.value.trim(), chosen);
      node.hidden = !shown;
      if (shown) found += 1;
    }
    count.textContent = `${found} of ${cards.length} problems`;
  };
  search.addEventListener("input", refresh);
  const kinds = [...new Set(data.entries.flatMap((entry) => entry.kinds))].sort();
  const filters = kinds.map((kind) => {
    const button = element("button", { type: "button", "aria-pressed": "false" }, kind);
    button.addEventListener("click", () => {
      if (!chosen.delete(kind)) chosen.add(kind);
      button.setAttribute("aria-pressed", String(chosen.has(kind)));
      refresh();
    });
    return button;
  });
  refresh();
  return [
    element("header", {}, element("h1", {}, data.title)),
    element(
      "main",
      { class: "gallery" },
      element("div", { class: "controls", role: "group", "aria-label": "Search and kinds" }, search, ...filters),
      count,
      element("ul", { class: "cards" }, ...cards.map((one) => one.node)),
    ),
  ];
}
