// The answers of a solution: unknowns, questions, claims, the conditions under which they hold, and the checks.
import type { Answer, Column, Solution } from "../document";
import { type Child, element, scrolling, section } from "../element";
import { math } from "../text/math";
import { residual, rounded } from "../text/numbers";
import { nameTex, unitTex } from "../text/tex";
import { conditionNode, formulaLines, valueNode } from "./values";

const onAxes = (axes: string[] | undefined): Child =>
  axes !== undefined && axes.length > 0 && element("span", { class: "faint" }, ` on ${axes.join(", ")}`);

function table(columns: Column[], label: string): HTMLElement {
  const rows = Math.max(0, ...columns.map((column) => column.value.length));
  const head = columns.map((column) =>
    element(
      "th",
      { scope: "col" },
      column.name,
      column.unit !== "" && element("span", { class: "faint" }, " ", math(unitTex(column.unit))),
    ),
  );
  const lines = Array.from({ length: rows }, (_, row) =>
    element(
      "tr",
      {},
      ...columns.map((column) => element("td", { class: "number" }, rounded(column.value[row] ?? NaN))),
    ),
  );
  return scrolling(
    label,
    element("table", {}, element("thead", {}, element("tr", {}, ...head)), element("tbody", {}, ...lines)),
  );
}

function claimNodes(answer: Answer): Child[] {
  if (answer.holds) {
    return [element("p", { class: "verdict holds" }, `holds, ${answer.how ?? ""}`), assumed(answer)];
  }
  const counter = answer.counterexample;
  const values = Object.entries(counter?.letters ?? {}).map(([name, at]) => [
    " ",
    math(`${nameTex(name)} =`),
    " ",
    valueNode(at.value, at.unit, false),
  ]);
  const sides =
    counter?.left !== undefined && counter.right !== undefined
      ? element(
          "p",
          {},
          "The left side is ",
          valueNode(counter.left, counter.unit ?? "", false),
          ", the right ",
          valueNode(counter.right, counter.unit ?? "", false),
          ...(counter.difference === undefined
            ? []
            : ["; the difference is ", valueNode(counter.difference, counter.unit ?? "", false)]),
          ".",
        )
      : null;
  return [
    element("p", { class: "verdict fails" }, "does not hold"),
    values.length > 0 && element("p", {}, "For", ...values.flatMap((one, i) => (i > 0 ? [",", ...one] : one)), "."),
    sides,
    assumed(answer),
  ];
}

const assumed = (answer: Answer): Child =>
  answer.assumptions !== undefined &&
  element(
    "p",
    { class: "faint" },
    "if ",
    ...answer.assumptions.flatMap((one, i) => [i > 0 ? ", " : "", conditionNode(one)]),
  );

function answerNodes(name: string, answer: Answer): Child[] {
  if (answer.holds !== undefined) return claimNodes(answer);
  if (answer.determined === false)
    return [element("p", { class: "verdict fails" }, "not determined"), element("p", {}, answer.reason ?? "")];
  if (answer.refused)
    return [
      element("p", { class: "verdict fails" }, "refused: the check failed"),
      element("p", {}, answer.reason ?? ""),
    ];
  const nodes: Child[] = [];
  const axes = answer.axes ?? [];
  if (answer.formulas) {
    for (const one of answer.formulas)
      nodes.push(
        formulaLines(one.formula, axes, `formula of ${name}`),
        element(
          "p",
          { class: "faint" },
          "where ",
          ...one.where.flatMap((words, i) => [i > 0 ? ", " : "", conditionNode(words)]),
        ),
      );
  } else if (answer.formula !== undefined && answer.formula !== null) {
    nodes.push(formulaLines(answer.formula, axes, `formula of ${name}`));
  }
  if (answer.table) {
    const { over, columns } = answer.table;
    nodes.push(table(over ? [over, ...columns] : columns, `table of ${name}`));
  } else if (answer.value !== undefined && answer.value !== null) {
    nodes.push(
      scrolling(`value of ${name}`, valueNode(answer.value, answer.unit ?? "", axes.length > 0), onAxes(axes)),
    );
  } else if (answer.letters && nodes.length === 0) {
    const why = answer.no_formula ? `: ${answer.no_formula}` : "";
    nodes.push(element("p", { class: "verdict open" }, `needs values for ${answer.letters.join(", ")}${why}`));
  }
  return nodes;
}

const checkWords: Record<string, string> = {
  newton_euler: "Newton-Euler",
  energy_drift: "energy along the motion",
  motion_error: "error of the motion",
  roots: "roots by a scan",
  facts: "the facts stated",
  formulas: "formulas against numbers",
};

function checks(solution: Solution): Child {
  const entries = Object.entries(solution.checks);
  if (entries.length === 0) return null;
  const texts = entries.map(([name, value]) => `${checkWords[name] ?? name.replaceAll("_", " ")} ${residual(value)}`);
  return element(
    "p",
    { class: "faint" },
    `Checked with the bodies as particles, relative misfits: ${texts.join(", ")}.`,
  );
}

function conditions(solution: Solution): Child {
  // What stands beside one of several formulas is not said again.
  const beside = Object.entries(solution.answers).flatMap(([name, answer]) =>
    (answer.formulas ?? []).flatMap((one) => one.where.map((words) => `${words} for '${name}'`)),
  );
  const told = (solution.assumptions ?? []).filter((words) => !beside.includes(words));
  if (told.length === 0) return null;
  const parts = told.flatMap((words, i) => {
    const condition = solution.conditions?.find((one) => one.words === words);
    return [i > 0 ? ", " : "", conditionNode(words), ...(condition ? [": ", conditionNode(condition.formula)] : [])];
  });
  return element("p", {}, "where ", ...parts);
}

export function answersSection(solution: Solution): HTMLElement {
  const rows = Object.entries(solution.answers).map(([name, answer]) =>
    element(
      "div",
      { class: "answer" },
      element("dt", {}, math(nameTex(name)), " ", element("span", { class: "words" }, answer.words ?? answer.ask)),
      element("dd", {}, ...answerNodes(name, answer)),
    ),
  );
  const unknowns = Object.entries(solution.unknowns).map(([name, unknown]) =>
    element(
      "li",
      {},
      math(`${nameTex(name)} =`),
      " ",
      unknown.value === null && unknown.formula !== undefined
        ? formulaLines(unknown.formula, [], `formula of ${name}`)
        : valueNode(unknown.value, unknown.unit, Array.isArray(unknown.value)),
    ),
  );
  return section(
    "Answers",
    unknowns.length > 0 &&
      element("div", { class: "found" }, element("h3", {}, "Found"), element("ul", { class: "given" }, ...unknowns)),
    element("dl", { class: "answers" }, ...rows),
    conditions(solution),
    ...(solution.notes ?? []).map((note) => element("p", {}, note)),
    checks(solution),
  );
}
