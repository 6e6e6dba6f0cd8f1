// The problem file with syntax colours: keys, numbers with their units, comments, texts between quotes.
import { element } from "../element";

const token = /(#.*$)|("[^"]*"|'[^']*')|([A-Za-z_][\w ]*?)(?=\s*:(?:\s|$))|(-?\b[0-9][\w.]*)|([{}[\],:>|-])/gm;

export function coloured(text: string): HTMLElement {
  const code = element("code");
  let end = 0;
  const plainUpTo = (index: number): void => {
    if (index > end) code.append(text.slice(end, index));
  };
  for (const match of text.matchAll(token)) {
    const [whole, comment, quoted, key, number] = match;
    const isComment = comment !== undefined && (match.index === 0 || /\s/.test(text[match.index - 1] ?? ""));
    const kind = isComment ? "comment" : quoted ? "quoted" : key ? "key" : number ? "number" : comment ? "" : "mark";
    plainUpTo(match.index);
    if (kind === "") code.append(whole);
    else code.append(element("span", { class: `code-${kind}` }, whole));
    end = match.index + whole.length;
  }
  plainUpTo(text.length);
  return code;
}
