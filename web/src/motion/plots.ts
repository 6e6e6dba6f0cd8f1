// Diagrams of quantities over the time of the motion. Their cursor is the slider of the player.
import uPlot from "uplot";
import { element } from "../element";
import type { Motion, Plot } from "../scene";
import { math } from "../text/math";
import { rounded } from "../text/numbers";
import { unitTex } from "../text/tex";
import { placeInTimes } from "../view/poses";

const strokes = ["var(--line-1)", "var(--line-2)", "var(--line-3)", "var(--line-4)"];
const dashes = [[], [6, 3], [2, 3], [8, 3, 2, 3]];

function colour(name: string): string {
  const variable = /^var\((.*)\)$/.exec(name)?.[1] ?? "";
  return getComputedStyle(document.documentElement).getPropertyValue(variable).trim();
}

// A quantity at a time between records.
export function valueAt(times: number[], values: number[], time: number): number {
  const { index, part } = placeInTimes(times, time);
  const from = values[index] ?? NaN;
  return part === 0 ? from : from + part * ((values[index + 1] ?? from) - from);
}

export class PlotView {
  readonly node: HTMLElement;
  private readonly chart: uPlot;
  private readonly cells: HTMLElement[];
  private readonly place = element("div", { class: "chart", "aria-hidden": "true" });
  private time = 0;

  constructor(
    private readonly plot: Plot,
    private readonly motion: Motion,
    choose: (time: number) => void,
  ) {
    const labels = plot.labels.length > 0 ? plot.labels : [plot.name];
    this.cells = labels.map(() => element("output", { class: "number" }));
    const unit = plot.unit === "" ? null : element("span", { class: "faint" }, " in ", math(unitTex(plot.unit)));
    this.node = element(
      "figure",
      { class: "plot" },
      element("figcaption", {}, plot.words || plot.name, unit),
      this.place,
      element(
        "p",
        { class: "legend" },
        ...labels.map((label, i) =>
          element("span", { class: `line-${(i % strokes.length) + 1}` }, `${label || plot.name} = `, this.cells[i]),
        ),
      ),
    );
    this.chart = new uPlot(this.options(), [motion.times, ...plot.values] as uPlot.AlignedData, this.place);
    const atPointer = (event: PointerEvent): void => {
      const box = this.chart.over.getBoundingClientRect();
      choose(this.chart.posToVal(event.clientX - box.left, "x"));
    };
    this.chart.over.addEventListener("pointerdown", (event) => {
      this.chart.over.setPointerCapture(event.pointerId);
      atPointer(event);
    });
    this.chart.over.addEventListener("pointermove", (event) => {
      if (event.buttons > 0) atPointer(event);
    });
    this.setTime(motion.times[0] ?? 0);
  }

  private options(): uPlot.Options {
    const axis = {
      stroke: () => colour("var(--ink)"),
      grid: { stroke: () => colour("var(--rule)"), width: 1 },
      ticks: { show: false },
      font: "12px sans-serif",
    };
    return {
      width: 320,
      height: 190,
      legend: { show: false },
      cursor: { show: false },
      scales: { x: { time: false } },
      axes: [
        { ...axis, values: (_, splits) => splits.map((value) => `${rounded(value)} s`) },
        { ...axis, size: 64, values: (_, splits) => splits.map((value) => rounded(value)) },
      ],
      series: [
        {},
        ...this.plot.values.map((_, i) => ({
          stroke: () => colour(strokes[i % strokes.length] ?? ""),
          dash: dashes[i % dashes.length] ?? [],
          width: 2,
          points: { show: false },
        })),
      ],
      hooks: {
        draw: [
          (chart) => {
            this.drawCursor(chart);
          },
        ],
      },
    };
  }

  private drawCursor(chart: uPlot): void {
    const x = chart.valToPos(this.time, "x", true);
    const { ctx, bbox } = chart;
    ctx.save();
    ctx.strokeStyle = colour("var(--accent)");
    ctx.lineWidth = 2;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  }

  setTime(time: number): void {
    this.time = time;
    this.cells.forEach((cell, i) => {
      cell.textContent = rounded(valueAt(this.motion.times, this.plot.values[i] ?? [], time));
    });
    this.chart.redraw(false, false);
  }

  resize(): void {
    const width = Math.max(200, this.place.clientWidth);
    if (width !== this.chart.width) this.chart.setSize({ width, height: 190 });
    else this.chart.redraw(false, true);
  }
}
