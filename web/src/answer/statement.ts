// The statement in words: what the machine is, what is given, what is asked.
import type { Named, PageData, Situation } from "../document";
import { type Child, element, section } from "../element";
import { math } from "../text/math";
import { sections } from "../text/markdown";
import { formulaTex, nameTex, unitTex } from "../text/tex";

// A datum as written, "1200 rpm" or "m*r^2/2": typeset if it is a formula.
function datumNode(text: string): Child {
  const tex = /^[\w.*/^+() -]+$/.test(text) && !/^[-0-9.]+ [A-Za-z]/.test(text) ? formulaTex(text) : null;
  if (tex !== null) return math(tex);
  const quantity = /^(-?[0-9][0-9.e+-]*) ([A-Za-z][\w*/^]*)$/.exec(text);
  if (quantity) {
    const number = (quantity[1] ?? "").replace(/e[+]?(-?)0*([0-9]+)$/, "\\cdot 10^{$1$2}");
    return math(`${number}${quantity[2] === "deg" ? "" : "\\;"}${unitTex(quantity[2] ?? "")}`);
  }
  return element("code", {}, text);
}

function given(situation: Situation): Child[] {
  const data = situation.data.map((one) => element("li", {}, math(`${nameTex(one.name)} =`), " ", datumNode(one.text)));
  const letters = situation.letters.map((one) =>
    element(
      "li",
      {},
      math(nameTex(one.name)),
      element("span", { class: "faint" }, one.unit === "" ? ", a letter" : ", a letter in "),
      one.unit !== "" && math(unitTex(one.unit)),
    ),
  );
  const unknowns = situation.unknowns.map((one) =>
    element("li", {}, math(nameTex(one.name)), element("span", { class: "faint" }, ", to be found")),
  );
  const all = [...data, ...letters, ...unknowns];
  if (all.length === 0) return [];
  return [
    situation.name !== "" && element("h4", {}, situation.name.replaceAll("_", " ")),
    element("ul", { class: "given" }, ...all),
  ];
}

function asked(page: PageData): Child[] {
  const answers = page.document.solutions[0]?.answers ?? {};
  const line = (one: Named): HTMLElement => {
    const words = answers[one.name]?.words;
    return element("li", {}, math(nameTex(one.name)), ": ", words ?? element("code", {}, one.text));
  };
  const list = (title: string, items: Named[]): Child[] =>
    items.length > 0 ? [element("h3", {}, title), element("ul", { class: "asked" }, ...items.map(line))] : [];
  return [...list("Asked", page.questions), ...list("Claimed", page.claims)];
}

export function statementSection(page: PageData): HTMLElement {
  const explanation = page.document.solutions[0]?.explanation;
  const model = explanation === undefined ? undefined : sections(explanation).find((one) => one.heading === "Model");
  const data = page.situations.flatMap(given);
  return section(
    "Statement",
    // What it says of data stands below.
    ...(model?.body ?? []).filter((node) => node.nodeName === "UL"),
    ...(data.length > 0 ? [element("h3", {}, "Given"), ...data] : []),
    ...asked(page),
  );
}
