// Cords, springs and dampers: made between the origin and one unit along z, and stretched to where they end.
import { type BufferGeometry, CatmullRomCurve3, CylinderGeometry, Mesh, TubeGeometry, Vector3 } from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Link } from "../scene";
import type { Paints } from "./paints";
import { bar } from "./solids";

const start = new Vector3();
const end = new Vector3(0, 0, 1);

// A coil between straight ends.
function coil(radius: number, thickness: number): BufferGeometry {
  const points: Vector3[] = [start.clone(), new Vector3(0, 0, 0.1)];
  const turns = 8;
  for (let i = 0; i <= turns * 12; ++i) {
    const angle = (2 * Math.PI * i) / 12;
    points.push(new Vector3(radius * Math.cos(angle), radius * Math.sin(angle), 0.12 + (0.76 * i) / (turns * 12)));
  }
  points.push(new Vector3(0, 0, 0.9), end.clone());
  return new TubeGeometry(new CatmullRomCurve3(points, false, "centripetal"), 320, thickness, 6);
}

function cylinder(radius: number, from: number, to: number): BufferGeometry {
  return new CylinderGeometry(radius, radius, to - from, 16).rotateX(Math.PI / 2).translate(0, 0, (from + to) / 2);
}

// Thickness is a part of the size of the scene; lengths along z are parts of the link.
function shapeOf(link: Link, size: number): BufferGeometry {
  const thin = 0.004 * size;
  switch (link.kind) {
    case "spring":
    case "torsion":
      return coil(0.025 * size, thin);
    case "damper":
      return mergeGeometries([bar(start, end, thin), cylinder(0.025 * size, 0.35, 0.65)]);
    case "cord":
      return bar(start, end, thin);
  }
}

export function linkNode(link: Link, size: number, paints: Paints): Mesh {
  return new Mesh(shapeOf(link, size), link.kind === "cord" ? paints.ink : paints.metal);
}

export function stretch(node: Mesh, from: Vector3, to: Vector3): void {
  const along = to.clone().sub(from);
  const length = along.length();
  node.visible = length > 0;
  if (length === 0) return;
  node.position.copy(from);
  node.quaternion.setFromUnitVectors(end, along.divideScalar(length));
  node.scale.set(1, 1, length);
}
