// Worked solutions: the Markdown that the program writes, made into elements. What is none of its forms stays text.
import { type Child, append, element, scrolling } from "../element";
import { math } from "./math";

export interface MarkdownSection {
  heading: string;
  body: Node[];
}

const specials = /\\([\\`*_[\]<>#$|&~@.:])|(``? ?)(.*?)( ?``?)(?!`)|\$([^$]+)\$|\*\*(.+?)\*\*|\*(.+?)\*/s;

// Words with emphasis, code and formulas.
export function inline(text: string): Child[] {
  const children: Child[] = [];
  let rest = text;
  for (let match = specials.exec(rest); match; match = specials.exec(rest)) {
    children.push(rest.slice(0, match.index));
    rest = rest.slice(match.index + match[0].length);
    const [, escaped, , code, , tex, strong, emphasis] = match;
    if (escaped !== undefined) children.push(escaped);
    else if (code !== undefined) children.push(element("code", {}, code));
    else if (tex !== undefined) children.push(math(tex));
    else if (strong !== undefined) children.push(element("strong", {}, ...inline(strong)));
    else if (emphasis !== undefined) children.push(element("em", {}, ...inline(emphasis)));
  }
  children.push(rest);
  return children;
}

// Cells of a row between bars; a bar within a formula is none of the row's.
function cells(line: string): string[] {
  const parts =
    line
      .trim()
      .replace(/^\||\|$/g, "")
      .match(/(?:\\.|\$[^$]*\$|[^|])+/g) ?? [];
  return parts.map((part) => part.trim());
}

// A formula in words, as far as heads of columns have it: "I xy", "y bar".
function spoken(formula: string): string {
  return formula
    .replace(/\\bar\{(\w)\}/g, "$1 bar")
    .replace(/\\[a-z]+|[{}$]/g, "")
    .replaceAll("_", " ")
    .trim();
}

// In a formula no program that reads aloud finds a name for its column.
function headCell(cell: string): HTMLElement {
  if (!/^\$[^$]+\$$/.test(cell)) return element("th", { scope: "col" }, ...inline(cell));
  return element(
    "th",
    { scope: "col" },
    element("span", { "aria-hidden": "true" }, ...inline(cell)),
    element("span", { class: "spoken" }, spoken(cell)),
  );
}

function table(lines: string[]): Node {
  const [head = "", , ...rows] = lines;
  return scrolling(
    "table",
    element(
      "table",
      {},
      element("thead", {}, element("tr", {}, ...cells(head).map(headCell))),
      element(
        "tbody",
        {},
        ...rows.map((row) => element("tr", {}, ...cells(row).map((cell) => element("td", {}, ...inline(cell))))),
      ),
    ),
  );
}

function block(lines: string[]): Node {
  const first = lines[0] ?? "";
  if (first.startsWith("|")) return table(lines);
  if (first.startsWith("* ")) {
    const items: string[] = [];
    for (const line of lines) {
      if (line.startsWith("* ")) items.push(line.slice(2));
      else items.push(`${items.pop() ?? ""}\n${line}`);
    }
    return element("ul", {}, ...items.map((item) => element("li", {}, ...inline(item))));
  }
  return element("p", {}, ...inline(lines.join("\n")));
}

// The blocks of a text without headings.
function blocks(lines: string[]): Node[] {
  const made: Node[] = [];
  let open: string[] = [];
  const close = (): void => {
    if (open.length > 0) made.push(block(open));
    open = [];
  };
  for (let i = 0; i < lines.length; ++i) {
    const line = lines[i] ?? "";
    if (line === "$$") {
      close();
      const end = lines.indexOf("$$", i + 1);
      const tex = lines.slice(i + 1, end < 0 ? lines.length : end).join("\n");
      made.push(scrolling("equations", math(tex, true)));
      i = end < 0 ? lines.length : end;
    } else if (line.trim() === "") {
      close();
    } else {
      if (open.length > 0 && line.startsWith("* ") !== (open[0] ?? "").startsWith("* ") && line.startsWith("* "))
        close();
      open.push(line);
    }
  }
  close();
  return made;
}

// A worked solution by its headings. The title comes first, with an empty heading.
export function sections(markdown: string): MarkdownSection[] {
  const made: { heading: string; lines: string[] }[] = [{ heading: "", lines: [] }];
  for (const line of markdown.split("\n")) {
    if (line.startsWith("## ")) made.push({ heading: line.slice(3), lines: [] });
    else if (!line.startsWith("# ")) made[made.length - 1]?.lines.push(line);
  }
  return made.map(({ heading, lines }) => ({ heading, body: blocks(lines) }));
}

export function fill(parent: HTMLElement, section: MarkdownSection): void {
  append(parent, section.body);
}
