// Labels that face the viewer. Each takes the first free place around its point; one that finds none is not shown.
import { type Camera, Vector3 } from "three";

export interface Label {
  node: HTMLElement;
  rank: number; // those of lower rank find their place first
  place: () => Vector3;
  shown: () => boolean;
}

interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

const overlap = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

// The places around a point, nearest first: right, left, above, below, corners; then the same farther away.
export function candidates(x: number, y: number, width: number, height: number): Box[] {
  const boxes: Box[] = [];
  for (const gap of [6, 18]) {
    for (const [h, v] of [
      [1, -1],
      [1, 0],
      [-1, -1],
      [-1, 0],
      [0, -1],
      [1, 1],
      [0, 1],
      [-1, 1],
    ] as const) {
      const left = h > 0 ? x + gap : h < 0 ? x - gap - width : x - width / 2;
      const top = v > 0 ? y + gap : v < 0 ? y - gap - height : y - height / 2;
      boxes.push({ left, top, right: left + width, bottom: top + height });
    }
  }
  return boxes;
}

export class Labels {
  private labels: { label: Label; width: number; height: number }[] = [];

  constructor(private readonly layer: HTMLElement) {}

  set(labels: Label[]): void {
    this.layer.replaceChildren(...labels.map((label) => label.node));
    this.labels = labels.map((label) => ({ label, width: 0, height: 0 }));
    this.labels.sort((a, b) => a.label.rank - b.label.rank);
  }

  // A font that arrives changes sizes.
  measure(): void {
    for (const entry of this.labels) {
      entry.width = entry.label.node.offsetWidth;
      entry.height = entry.label.node.offsetHeight;
    }
  }

  arrange(camera: Camera, width: number, height: number): void {
    if (this.labels.some((entry) => entry.width === 0)) this.measure();
    const taken: Box[] = [];
    const point = new Vector3();
    for (const { label, width: w, height: h } of this.labels) {
      let free: Box | undefined;
      if (label.shown()) {
        point.copy(label.place()).project(camera);
        const x = (0.5 + 0.5 * point.x) * width;
        const y = (0.5 - 0.5 * point.y) * height;
        free = candidates(x, y, w, h).find(
          (box) =>
            box.left >= 0 &&
            box.top >= 0 &&
            box.right <= width &&
            box.bottom <= height &&
            !taken.some((one) => overlap(one, box)),
        );
      }
      if (free) {
        taken.push(free);
        label.node.style.transform = `translate(${free.left.toFixed(1)}px, ${free.top.toFixed(1)}px)`;
      }
      label.node.style.visibility = free ? "visible" : "hidden";
    }
  }
}
