// What is shown of one solution: figure, motion, answers, diagrams, worked solution.
import type { Figure, PageData, Solution } from "../document";
import { type Child, element, section } from "../element";
import { motionSection } from "../motion/player";
import type { Scene, Shape, Vector } from "../scene";
import { sections } from "../text/markdown";
import { answersSection } from "./answers";
import { figureNode } from "./figures";

// What is drawn of the statement comes first; diagrams of the worked solution belong below the answers.
const isOfStatement = (figure: Figure, index: number): boolean => index === 0 && figure.svg !== "";

// Diagrams that belong to a section stand at its end; a heading may tell after a comma which instant it is about.
function workedSolution(solution: Solution, diagrams: Figure[]): Child {
  if (solution.explanation === undefined) return null;
  const parts = sections(solution.explanation).filter(
    (part) => part.heading !== "" && part.heading !== "Model" && part.heading !== "Answers",
  );
  if (parts.length === 0) return null;
  const shown = new Set<Figure>();
  const belongsHere = (figure: Figure, heading: string): boolean => {
    const here = !shown.has(figure) && figure.section === heading.split(",")[0];
    if (here) shown.add(figure);
    return here;
  };
  return element(
    "details",
    { class: "folded" },
    element("summary", {}, element("h2", {}, "Worked solution")),
    ...parts.flatMap((part) => [
      element("h3", {}, part.heading),
      ...part.body,
      ...diagrams.filter((figure) => belongsHere(figure, part.heading)).map(figureNode),
    ]),
  );
}

// The scene with the arms of its bodies as thin shapes of their own.
function withArms(scene: Scene, arms: [Vector, Vector][][]): Scene {
  const armShape = (arm: [Vector, Vector]): Shape => ({
    kind: "arm",
    part: "",
    extent: "line",
    hole: false,
    added: false,
    vertices: arm,
    triangles: [],
    normals: [],
    edges: [[0, 1]],
  });
  const bodies = scene.bodies.map((body, i) => ({
    ...body,
    shapes: [...body.shapes, ...(arms[i] ?? []).map(armShape)],
  }));
  return { ...scene, bodies };
}

export function solutionNodes(page: PageData, index: number): Child[] {
  const solution = page.document.solutions[index];
  if (!solution) return [];
  const figures = page.figures[index] ?? [];
  const first = figures.filter(isOfStatement);
  const diagrams = figures.filter((figure, i) => !isOfStatement(figure, i));
  return [
    first.length > 0 && section("Figure", ...first.map(figureNode)),
    solution.scene ? motionSection(withArms(solution.scene, page.arms[index] ?? [])) : null,
    answersSection(solution),
    diagrams.length > 0 && section("Diagrams", ...diagrams.map(figureNode)),
    workedSolution(solution, diagrams),
  ];
}
