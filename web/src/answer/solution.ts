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

// Diagrams that belong to a section stand at its end; a heading may tell more after a comma.
function workedSolution(solution: Solution, diagrams: Figure[]): Child {
  if (solution.explanation === undefined) return null;
  const parts = sections(solution.explanation).filter(
    (part) => part.heading !== "" && part.heading !== "Model" && part.heading !== "Answers",
  );
  if (parts.length === 0) return null;
  const shown = new Set<Figure>();
  const belongsHere = (figure: Figure, heading: string): boolean => {
    const here = !shown.has(figure) && figure.section !== "" && `${heading},`.startsWith(`${figure.section},`);
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
    stand_in: false,
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

// What is seen of one situation.
function situationNodes(scene: Scene | undefined, figures: Figure[], arms: [Vector, Vector][][], of = ""): Child[] {
  const first = figures.filter(isOfStatement);
  return [
    first.length > 0 && section(of === "" ? "Figure" : `Figure: ${of}`, ...first.map(figureNode)),
    scene ? motionSection(withArms(scene, arms), of) : null,
  ];
}

function situationName(scene: Scene): string {
  return scene.situation.replaceAll("_", " ") || "situation";
}

// The first situation is open; the others are made when they are first looked at.
function situations(scenes: Scene[], figures: Figure[], arms: [Vector, Vector][][][]): Child[] {
  return scenes.map((scene, i) => {
    const own = (): Child[] =>
      situationNodes(
        scene,
        figures.filter((figure) => figure.situation === scene.situation),
        arms[i] ?? [],
        situationName(scene),
      );
    const holder = element("div", {});
    const details = element(
      "details",
      { class: "situation", ...(i === 0 ? { open: true } : {}) },
      element("summary", {}, element("h2", {}, `Situation: ${situationName(scene)}`)),
      holder,
    );
    const fill = (): void => {
      if (holder.hasChildNodes()) return;
      for (const node of own()) if (node) holder.append(node);
    };
    if (i === 0) fill();
    details.addEventListener("toggle", fill);
    return details;
  });
}

export function solutionNodes(page: PageData, index: number): Child[] {
  const solution = page.document.solutions[index];
  if (!solution) return [];
  const figures = page.figures[index] ?? [];
  const arms = page.arms[index] ?? [];
  const scenes = [...(solution.scene ? [solution.scene] : []), ...(solution.other_scenes ?? [])];
  const shown = scenes.map((scene) => figures.filter((figure) => figure.situation === scene.situation));
  const diagrams = shown.flatMap((own) => own.filter((figure, i) => !isOfStatement(figure, i)));
  return [
    ...(scenes.length > 1 ? situations(scenes, figures, arms) : situationNodes(scenes[0], figures, arms[0] ?? [])),
    answersSection(solution),
    diagrams.length > 0 && section("Diagrams", ...diagrams.map(figureNode)),
    workedSolution(solution, diagrams),
  ];
}
