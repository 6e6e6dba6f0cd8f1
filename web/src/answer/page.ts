// The page of an answer, from top to bottom.
import type { PageData } from "../document";
import { type Child, element, fresh, section } from "../element";
import { coloured } from "../text/colours";
import { solutionNodes } from "./solution";
import { statementSection } from "./statement";
import { rounded } from "../text/numbers";

// A button that keeps a text as a file.
function download(name: string, type: string, text: string, label: string): HTMLElement {
  const address = URL.createObjectURL(new Blob([text], { type }));
  return element("a", { class: "button", href: address, download: name }, label);
}

const baseName = (path: string): string => path.replace(/^.*[\\/]/, "").replace(/\.[^.]*$/, "") || "problem";

function warnings(page: PageData): Child {
  const { document } = page;
  const texts = [...document.warnings];
  if (document.ended === "interrupted") texts.push("It was interrupted: this is what was found until then.");
  if (document.ended === "deadline") texts.push("Its time ended: this is what was found until then.");
  return (
    texts.length > 0 &&
    element("section", { class: "warnings", "aria-label": "Warnings" }, ...texts.map((text) => element("p", {}, text)))
  );
}

// Values of the unknowns that tell solutions apart.
function solutionName(page: PageData, index: number): string {
  const unknowns = Object.entries(page.document.solutions[index]?.unknowns ?? {})
    .filter(([, unknown]) => typeof unknown.value === "number")
    .slice(0, 2)
    .map(([name, unknown]) => `${name} = ${rounded(unknown.value as number)} ${unknown.unit}`.trim());
  return unknowns.length > 0 ? `${index + 1}: ${unknowns.join(", ")}` : `Solution ${index + 1}`;
}

// Several solutions stand behind tabs; what is behind a tab is made when it is first looked at.
function tabs(page: PageData): HTMLElement {
  const list = element("div", { role: "tablist", "aria-label": "Solutions", class: "tabs" });
  const panels: HTMLElement[] = [];
  const buttons: HTMLButtonElement[] = [];
  const select = (chosen: number, focus: boolean): void => {
    buttons.forEach((button, i) => {
      button.setAttribute("aria-selected", String(i === chosen));
      button.tabIndex = i === chosen ? 0 : -1;
      const panel = panels[i];
      if (!panel) return;
      panel.hidden = i !== chosen;
      if (i === chosen && !panel.hasChildNodes()) {
        for (const node of solutionNodes(page, i)) if (node) panel.append(node);
      }
    });
    if (focus) buttons[chosen]?.focus();
  };
  const onKey = (event: KeyboardEvent): void => {
    const now = buttons.indexOf(event.target as HTMLButtonElement);
    const count = buttons.length;
    const goals: Record<string, number> = {
      ArrowRight: (now + 1) % count,
      ArrowLeft: (now + count - 1) % count,
      Home: 0,
      End: count - 1,
    };
    const goal = goals[event.key];
    if (goal === undefined) return;
    event.preventDefault();
    select(goal, true);
  };
  page.document.solutions.forEach((_, i) => {
    const id = fresh("tab");
    const button = element(
      "button",
      {
        role: "tab",
        id,
        "aria-controls": `${id}-panel`,
        onclick: () => {
          select(i, false);
        },
        onkeydown: onKey,
      },
      solutionName(page, i),
    );
    buttons.push(button);
    panels.push(element("div", { role: "tabpanel", id: `${id}-panel`, "aria-labelledby": id }));
  });
  list.append(...buttons);
  // The first is filled when the page is complete, for what is drawn needs its width.
  queueMicrotask(() => {
    select(0, false);
  });
  return element("div", {}, list, ...panels);
}

export function pageNodes(page: PageData): Child[] {
  const { document } = page;
  const title = document.title || document.file;
  const solutions = document.solutions.length;
  const holder = element("div", {});
  if (solutions === 1)
    queueMicrotask(() => {
      for (const node of solutionNodes(page, 0)) if (node) holder.append(node);
    });
  return [
    element(
      "header",
      {},
      page.gallery !== "" &&
        element("nav", { "aria-label": "Gallery" }, element("a", { href: page.gallery }, "← All problems")),
      element("h1", {}, title),
      element("p", { class: "faint" }, page.problem.name.replace(/^.*[\\/]/, "")),
    ),
    element(
      "main",
      {},
      warnings(page),
      statementSection(page),
      solutions === 0 && section("Answers", element("p", { class: "verdict fails" }, "There is no solution.")),
      solutions > 1 ? tabs(page) : holder,
      element(
        "details",
        { class: "folded" },
        element("summary", {}, element("h2", {}, "Problem file")),
        element(
          "pre",
          { class: "file", tabindex: 0, role: "group", "aria-label": "Problem file" },
          coloured(page.problem.text),
        ),
      ),
      section(
        "Take with you",
        element(
          "p",
          { class: "downloads" },
          download(
            `${baseName(page.problem.name)}.json`,
            "application/json",
            JSON.stringify(document, null, 1),
            "Answer document (JSON)",
          ),
          download(`${baseName(page.problem.name)}.yaml`, "text/yaml", page.problem.text, "Problem file (YAML)"),
        ),
      ),
    ),
    element("footer", { class: "faint" }, `poinsot ${document.poinsot}`),
  ];
}
