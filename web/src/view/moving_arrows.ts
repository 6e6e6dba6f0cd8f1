// Velocities and other vectors that change during a motion. All of one kind share a scale over the whole motion.
import { Group, Quaternion, Vector3 } from "three";
import { element } from "../element";
import type { MovingArrow, Place, Scene } from "../scene";
import { math } from "../text/math";
import { nameTex } from "../text/tex";
import { arrowNode } from "./arrows";
import type { Label } from "./labels";
import type { Paints } from "./paints";
import { placeInTimes } from "./poses";

const zAxis = new Vector3(0, 0, 1);
const longest = 0.3; // of the picture
const shortest = 0.02; // of the longest: what is shorter is not drawn
const smallest = 0.3; // of the longest: heads do not get smaller

interface Moving {
  arrow: MovingArrow;
  node: Group;
  largest: number;
  tip: Vector3;
}

export class MovingArrows {
  readonly group = new Group();
  readonly labels: Label[];
  private readonly moving: Moving[];
  private readonly times: number[];

  constructor(
    scene: Scene,
    private readonly size: number,
    paints: Paints,
    private readonly leftOut: Set<string>,
  ) {
    const arrows = scene.motion?.arrows ?? [];
    this.times = scene.motion?.times ?? [];
    const largest = new Map<string, number>();
    for (const arrow of arrows) {
      for (let i = 0; i + 2 < arrow.vectors.length; i += 3) {
        const length = Math.hypot(...arrow.vectors.slice(i, i + 3));
        if (length > (largest.get(arrow.quantity) ?? 0)) largest.set(arrow.quantity, length);
      }
    }
    this.moving = arrows.map((arrow) => {
      const along = { ...arrow, vector: [0, 0, 1] as [number, number, number] };
      const node = arrowNode(along, longest * size, size, paints);
      node.visible = false;
      this.group.add(node);
      return { arrow, node, largest: largest.get(arrow.quantity) ?? 0, tip: new Vector3() };
    });
    this.labels = this.moving.map(({ arrow, node, tip }) => ({
      node: element("span", { class: "label arrow-label" }, math(arrow.symbol || nameTex(arrow.text))),
      rank: 0,
      place: () => tip,
      shown: () => node.visible,
    }));
  }

  // null: the instant of the statement, which has arrows of its own.
  setTime(time: number | null, whereIs: (place: Place) => Vector3): void {
    const { index, part } = placeInTimes(this.times, time ?? 0);
    for (const { arrow, node, largest, tip } of this.moving) {
      const vector = new Vector3().fromArray(arrow.vectors, 3 * index);
      if (part > 0) vector.lerp(new Vector3().fromArray(arrow.vectors, 3 * index + 3), part);
      const length = vector.length();
      node.visible = time !== null && !this.leftOut.has(arrow.quantity) && length > shortest * largest;
      if (!node.visible) continue;
      vector.divideScalar(length);
      const scale = Math.max(smallest, length / largest);
      node.position.copy(whereIs(arrow.at));
      node.quaternion.copy(new Quaternion().setFromUnitVectors(zAxis, vector));
      node.scale.setScalar(scale);
      tip.copy(node.position).addScaledVector(vector, scale * longest * this.size);
    }
  }

  told(): { name: string; quantity: string; visible: boolean; direction: number[]; length: number }[] {
    return this.moving.map(({ arrow, node }) => ({
      name: arrow.name,
      quantity: arrow.quantity,
      visible: node.visible,
      direction: zAxis.clone().applyQuaternion(node.quaternion).toArray(),
      length: node.scale.x,
    }));
  }
}
