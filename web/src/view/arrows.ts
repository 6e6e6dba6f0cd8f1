// Arrows of a diagram. Couples and turning have two heads and a curved arrow around the axis; inertial terms a hollow
// shaft of dashes, so that they differ from forces by more than their colour.
import { BufferGeometry, ConeGeometry, CylinderGeometry, Group, Mesh, Quaternion, TorusGeometry, Vector3 } from "three";
import type { Arrow } from "../scene";
import type { Paints } from "./paints";

const zAxis = new Vector3(0, 0, 1);
const turning = new Set([
  "couple",
  "angular_impulse",
  "angular_velocity",
  "angular_acceleration",
  "angular_momentum",
  "rate_of_angular_momentum",
  "angular_displacement",
]);
const inertial = new Set(["rate_of_momentum", "rate_of_angular_momentum", "linear_momentum", "angular_momentum"]);

const words: Record<string, string> = {
  force: "forces",
  weight: "weights",
  couple: "couples",
  impulse: "impulses",
  angular_impulse: "angular impulses",
  velocity: "velocities",
  angular_velocity: "angular velocities",
  acceleration: "accelerations",
  angular_acceleration: "angular accelerations",
  linear_momentum: "momenta",
  angular_momentum: "angular momenta",
  rate_of_momentum: "mass times acceleration",
  rate_of_angular_momentum: "rates of angular momentum",
  displacement: "shaken supports",
  angular_displacement: "shaken supports",
  unbalance: "unbalances",
};
export const quantityWords = (quantity: string): string => words[quantity] ?? quantity.replaceAll("_", " ");

// Arrows of one kind share a scale; the smallest stay visible. One of an open size is half as long as the longest.
export function arrowLengths(arrows: Arrow[], size: number): number[] {
  const largest = new Map<string, number>();
  const length = (arrow: Arrow): number => Math.hypot(...arrow.vector);
  for (const arrow of arrows)
    if (arrow.open !== true) largest.set(arrow.quantity, Math.max(largest.get(arrow.quantity) ?? 0, length(arrow)));
  return arrows.map((arrow) =>
    arrow.open === true
      ? 0.17 * size
      : size * Math.max(0.1, (0.34 * length(arrow)) / (largest.get(arrow.quantity) ?? 1)),
  );
}

function cylinder(radius: number, from: number, to: number): BufferGeometry {
  return new CylinderGeometry(radius, radius, to - from, 10).rotateX(Math.PI / 2).translate(0, 0, (from + to) / 2);
}

function head(radius: number, height: number, tip: number): BufferGeometry {
  return new ConeGeometry(radius, height, 16).rotateX(Math.PI / 2).translate(0, 0, tip - height / 2);
}

export function arrowNode(
  arrow: Pick<Arrow, "quantity" | "vector" | "swings">,
  length: number,
  size: number,
  paints: Paints,
): Group {
  const group = new Group();
  const thickness = 0.006 * size;
  const cap = Math.min(0.05 * size, 0.5 * length);
  const material = paints.arrow(arrow.quantity);
  const pieces: BufferGeometry[] = [head(2.6 * thickness, cap, length)];
  const isTurning = turning.has(arrow.quantity);
  if (isTurning) pieces.push(head(2.6 * thickness, cap, length - 0.8 * cap));
  const shaft = length - cap * (isTurning ? 1.7 : 0.9);
  if (inertial.has(arrow.quantity)) {
    const dashes = 5;
    for (let i = 0; i < dashes; ++i)
      pieces.push(cylinder(thickness, (shaft * i) / dashes, (shaft * (i + 0.6)) / dashes));
  } else {
    pieces.push(cylinder(thickness, 0, shaft));
  }
  if (isTurning) {
    const radius = 0.05 * size;
    pieces.push(new TorusGeometry(radius, 0.5 * thickness, 6, 32, 1.6 * Math.PI).translate(0, 0, 0.55 * shaft));
    const angle = 1.6 * Math.PI;
    pieces.push(
      new ConeGeometry(1.6 * thickness, 0.03 * size, 10)
        .rotateZ(angle)
        .translate(radius * Math.cos(angle), radius * Math.sin(angle), 0.55 * shaft),
    );
  }
  // What acts to and fro has a head at both ends.
  if (arrow.swings)
    pieces.push(
      head(2.6 * thickness, cap, length)
        .rotateX(Math.PI)
        .translate(0, 0, length),
    );
  const behind = paints.hiddenArrow(arrow.quantity);
  for (const piece of pieces) group.add(new Mesh(piece, material), new Mesh(piece, behind));
  group.quaternion.copy(new Quaternion().setFromUnitVectors(zAxis, new Vector3(...arrow.vector).normalize()));
  return group;
}

// Whether the shaft is meant to end at its point: what pushes is drawn toward it. All begin there today.
export function tipOf(arrow: Arrow, at: Vector3, length: number): Vector3 {
  return new Vector3(...arrow.vector).normalize().multiplyScalar(length).add(at);
}
