// Cords, springs and dampers: made between the origin and one unit along z, and stretched to where they end.
import {
  type BufferGeometry,
  CatmullRomCurve3,
  CylinderGeometry,
  Matrix4,
  Mesh,
  TorusGeometry,
  TubeGeometry,
  Vector3,
} from "three";
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

// The thickness of what is thin, as a part of the size of the scene.
const thickness = 0.004;

// Lengths along z are parts of the link.
function shapeOf(link: Link, size: number): BufferGeometry {
  const thin = thickness * size;
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

// The arc of a cord on a wheel, in the plane across its axis z from x on. Its shape is made anew where its angle or
// radius has changed by what can be seen.
export class WrapNode {
  readonly mesh: Mesh;
  private radius = 0;
  private angle = 0;

  constructor(
    private readonly size: number,
    paints: Paints,
    name: string,
  ) {
    this.mesh = new Mesh(undefined, paints.ink);
    this.mesh.name = name;
  }

  // Right-handed about the axis from one place to the other.
  lay(center: Vector3, axis: Vector3, from: Vector3, to: Vector3): void {
    const across = (place: Vector3): Vector3 => place.clone().sub(center).projectOnPlane(axis);
    const x = across(from);
    const radius = x.length();
    this.mesh.visible = radius > 0;
    if (radius === 0) return;
    x.divideScalar(radius);
    const y = axis.clone().cross(x);
    const end = across(to);
    let angle = Math.atan2(end.dot(y), end.dot(x));
    // What is as good as nothing may come out a little below zero.
    if (angle < -1e-9) angle += 2 * Math.PI;
    angle = Math.max(0, angle);
    if (Math.abs(angle - this.angle) > 1e-3 || Math.abs(radius - this.radius) > 1e-3 * radius) {
      this.mesh.geometry.dispose();
      const pieces = Math.max(2, Math.ceil(angle / 0.1));
      this.mesh.geometry = new TorusGeometry(radius, thickness * this.size, 8, pieces, angle);
      this.angle = angle;
      this.radius = radius;
    }
    this.mesh.position.copy(center);
    this.mesh.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(x, y, axis));
  }

  // What is shown, for tests: the radius and the angle.
  told(): { name: string; radius: number; angle: number } {
    return { name: this.mesh.name, radius: this.radius, angle: this.angle };
  }
}
