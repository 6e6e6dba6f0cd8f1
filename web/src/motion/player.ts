// The view in space with its controls, and for a motion the player: slider, play, speed, plots.
import { type Child, element, fresh, section } from "../element";
import type { Motion, Scene } from "../scene";
import { rounded } from "../text/numbers";
import { quantityWords } from "../view/arrows";
import { Stage } from "../view/stage";
import { PlotView } from "./plots";

// What tests read back.
declare global {
  interface Window {
    poinsotStages?: Stage[];
  }
}

const keysHelp =
  "Arrow keys turn, with Shift they move; + and − enlarge and reduce; 0 shows all. By mouse or touch: drag to turn, " +
  "drag with Shift or two fingers to move, wheel or pinch to enlarge.";

function describe(scene: Scene): string {
  const names = scene.bodies.filter((body) => !body.frame).map((body) => body.name);
  const points = scene.points.map((point) => point.name);
  return `View in space of ${names.join(", ")}${points.length > 0 ? ` with points ${points.join(", ")}` : ""}. ${keysHelp}`;
}

function viewButtons(scene: Scene, stage: Stage): HTMLElement {
  const button = (label: string, axis: number | null): HTMLElement =>
    element(
      "button",
      {
        type: "button",
        onclick: () => {
          stage.look(axis);
        },
      },
      label,
    );
  return element(
    "div",
    { role: "group", "aria-label": "Views", class: "controls" },
    button("as drawn", null),
    ...scene.axes.map((name, k) => button(`along ${name}`, k)),
  );
}

function arrowControls(scene: Scene, stage: Stage): Child {
  const toggles = element("span", { role: "group", "aria-label": "Kinds of arrows", class: "toggles" });
  const check = (label: string, on: boolean, change: (on: boolean) => void): HTMLElement => {
    const box = element("input", { type: "checkbox", ...(on ? { checked: true } : {}) });
    box.addEventListener("change", () => {
      change(box.checked);
    });
    return element("label", {}, box, ` ${label}`);
  };
  const refresh = (): void => {
    const arrows = [...(scene.diagrams[stage.shown.diagram]?.arrows ?? []), ...(scene.motion?.arrows ?? [])];
    toggles.replaceChildren(
      ...[...new Set(arrows.map((arrow) => arrow.quantity))].map((quantity) =>
        check(quantityWords(quantity), !stage.shown.quantities.has(quantity), (on) => {
          stage.toggleQuantity(quantity, on);
        }),
      ),
    );
  };
  const names = check("names", true, (on) => {
    stage.showNames(on);
  });
  const ride = stage.goesFar
    ? check("go with the bodies", true, (on) => {
        stage.ride(on);
      })
    : null;
  const withArrows = scene.diagrams
    .map((diagram, i) => ({ diagram, i }))
    .filter(({ diagram }) => diagram.arrows.length > 0);
  if (withArrows.length === 0) {
    refresh();
    return element("div", { class: "controls" }, toggles, names, ride);
  }
  const select = element(
    "select",
    {},
    ...withArrows.map(({ diagram, i }) =>
      element(
        "option",
        { value: i, ...(i === stage.shown.diagram ? { selected: true } : {}) },
        diagram.title || diagram.kind.replaceAll("_", " "),
      ),
    ),
    element("option", { value: -1 }, "none"),
  );
  select.addEventListener("change", () => {
    stage.chooseDiagram(Number(select.value));
    refresh();
  });
  refresh();
  return element("div", { class: "controls" }, element("label", {}, "Arrows: ", select), toggles, names, ride);
}

// The values behind the arrows, to be read without pointing.
function arrowTitle(scene: Scene, stage: Stage): string {
  const arrows = scene.diagrams[stage.shown.diagram]?.arrows ?? [];
  return arrows
    .map((arrow) =>
      arrow.value === undefined ? `${arrow.text}, open` : `${arrow.text} = ${rounded(arrow.value)} ${arrow.unit ?? ""}`,
    )
    .join("; ");
}

const speeds = [0.001, 0.003, 0.01, 0.03, 0.1, 0.25, 0.5, 1, 2, 4, 10, 30, 100, 1000, 10000, 100000];

const eventsShown = 8; // without being asked for more

class Player {
  readonly node: HTMLElement;
  readonly plots: PlotView[];
  private time: number;
  private last = 0;
  private playing = false;
  private speed: number;
  private readonly slider: HTMLInputElement;
  private readonly clock = element("output", { class: "clock number" });
  private readonly button: HTMLButtonElement;
  private readonly event = element("p", { class: "event", role: "status" });

  constructor(
    private readonly motion: Motion,
    private readonly stage: Stage,
  ) {
    const { times } = motion;
    const begin = times[0] ?? 0;
    const end = times[times.length - 1] ?? 0;
    this.time = begin;
    const wanted = (end - begin) / 8;
    this.speed = speeds.reduce(
      (best, one) => (Math.abs(Math.log(one / wanted)) < Math.abs(Math.log(best / wanted)) ? one : best),
      1,
    );
    const id = fresh("time");
    this.slider = element("input", { type: "range", id, min: begin, max: end, step: "any", value: begin });
    this.slider.addEventListener("input", () => {
      this.pause();
      this.go(Number(this.slider.value));
    });
    this.slider.addEventListener("keydown", (event) => {
      this.step(event);
    });
    this.button = element(
      "button",
      {
        type: "button",
        class: "play",
        onclick: () => {
          if (this.playing) this.pause();
          else this.play();
        },
      },
      "Play",
    );
    const rate = element(
      "select",
      {},
      ...speeds.map((one) =>
        element(
          "option",
          { value: one, ...(one === this.speed ? { selected: true } : {}) },
          one === 1 ? "real time" : `${one} ×`,
        ),
      ),
    );
    rate.addEventListener("change", () => {
      this.speed = Number(rate.value);
    });
    const instant = element(
      "button",
      {
        type: "button",
        onclick: () => {
          this.pause();
          this.stage.setTime(null);
          this.clock.textContent = "as stated";
        },
      },
      "Instant of the statement",
    );
    const events = motion.events.map((one) =>
      element(
        "button",
        {
          type: "button",
          onclick: () => {
            this.pause();
            this.go(one.time);
          },
        },
        `${rounded(one.time)} s: ${one.words}`,
      ),
    );
    this.node = element(
      "div",
      { class: "player" },
      element(
        "div",
        { class: "controls" },
        this.button,
        element("label", { for: id }, "Time"),
        this.slider,
        this.clock,
        element("label", {}, "Speed ", rate),
        instant,
      ),
      this.event,
      motion.events.length > 0 &&
        element(
          "div",
          { class: "controls", role: "group", "aria-label": "Events" },
          ...events.slice(0, eventsShown),
          // A ball that bounces has dozens.
          events.length > eventsShown &&
            element(
              "details",
              {},
              element("summary", {}, `${events.length - eventsShown} more`),
              ...events.slice(eventsShown),
            ),
        ),
      !motion.complete &&
        element("p", { class: "verdict open" }, motion.stopped || "The motion was followed no further."),
    );
    this.plots = motion.plots.map(
      (plot) =>
        new PlotView(plot, motion, (time) => {
          this.pause();
          this.go(time);
        }),
    );
    this.clock.textContent = "as stated";
  }

  // By keys the slider goes from record to record.
  private step(event: KeyboardEvent): void {
    const direction = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (direction === undefined) return;
    event.preventDefault();
    this.pause();
    const { times } = this.motion;
    const span = (times[times.length - 1] ?? 0) - (times[0] ?? 0);
    this.go(this.time + direction * (event.shiftKey ? span / 10 : span / 100));
  }

  go(time: number): void {
    const { times } = this.motion;
    this.time = Math.max(times[0] ?? 0, Math.min(times[times.length - 1] ?? 0, time));
    this.slider.value = String(this.time);
    this.slider.setAttribute("aria-valuetext", `${rounded(this.time)} s`);
    this.clock.textContent = `${rounded(Number(this.time.toPrecision(5)))} s`;
    const passed = this.motion.events.filter((one) => one.time <= this.time).pop();
    const words = passed ? `${rounded(passed.time)} s: ${passed.words}` : "";
    if (this.event.textContent !== words) this.event.textContent = words;
    this.stage.setTime(this.time);
    for (const plot of this.plots) plot.setTime(this.time);
  }

  play(): void {
    const { times } = this.motion;
    if (this.time >= (times[times.length - 1] ?? 0)) this.time = times[0] ?? 0;
    this.playing = true;
    this.button.textContent = "Pause";
    this.last = performance.now();
    const frame = (now: number): void => {
      if (!this.playing) return;
      const goal = this.time + (this.speed * Math.max(0, now - this.last)) / 1000;
      this.last = now;
      this.go(goal);
      if (this.time >= (times[times.length - 1] ?? 0)) this.pause();
      else requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  pause(): void {
    this.playing = false;
    this.button.textContent = "Play";
  }
}

function makeStage(scene: Scene, canvas: HTMLCanvasElement, layer: HTMLElement): Stage | null {
  try {
    return new Stage(scene, canvas, layer);
  } catch (error) {
    // A browser without WebGL shows the drawings alone.
    if (error instanceof Error && /WebGL/i.test(error.message)) return null;
    throw error;
  }
}

export function motionSection(scene: Scene, situation = ""): HTMLElement {
  const canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": describe(scene) });
  const layer = element("div", { class: "labels", "aria-hidden": "true" });
  const box = element("div", { class: "stage" }, canvas, layer);
  const stage = makeStage(scene, canvas, layer);
  if (!stage) return section("View in space", element("p", {}, "This browser shows no pictures in space (WebGL)."));
  (window.poinsotStages ??= []).push(stage);
  const player = scene.motion && scene.motion.times.length > 1 ? new Player(scene.motion, stage) : null;
  const controls = element("div", {}, viewButtons(scene, stage), arrowControls(scene, stage));
  const showValues = (): void => {
    canvas.title = arrowTitle(scene, stage);
  };
  controls.addEventListener("change", showValues);
  showValues();
  const letters = scene.drawn_letters.map((one) => `${one.name} = ${rounded(one.value)} ${one.unit}`.trim());
  const view = element(
    "div",
    {},
    box,
    element("p", { class: "faint help" }, keysHelp),
    controls,
    player?.node,
    letters.length > 0 && element("p", { class: "faint" }, `Drawn with ${letters.join(", ")}.`),
  );
  const resize = (): void => {
    stage.followTheme();
    for (const plot of player?.plots ?? []) plot.resize();
  };
  new ResizeObserver(resize).observe(box);
  window.addEventListener("themechange", resize);
  const plots =
    player && player.plots.length > 0
      ? // Many plots scroll, for which the keyboard has to reach them.
        element(
          "div",
          { class: "plots", tabindex: "0", role: "group", "aria-label": "Plots over time" },
          ...player.plots.map((plot) => plot.node),
        )
      : null;
  const heading = player ? "Motion" : "View in space";
  return section(
    situation === "" ? heading : `${heading}: ${situation}`,
    element("div", { class: plots ? "beside" : "" }, view, plots),
  );
}
