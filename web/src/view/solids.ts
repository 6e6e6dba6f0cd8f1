// Bodies: surfaces with the normals of the true shape, and the edges that a draughtsman draws.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  CylinderGeometry,
  Group,
  LineSegments,
  Matrix4,
  Mesh,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Body, Shape, Vector } from "../scene";
import type { Paints } from "./paints";
import { matrixOf } from "./poses";

const zAxis = new Vector3(0, 0, 1);

// A round bar from point to point, its axis along z before it is turned.
export function bar(from: Vector3, to: Vector3, radius: number, sides = 10): BufferGeometry {
  const along = to.clone().sub(from);
  const length = along.length();
  const geometry = new CylinderGeometry(radius, radius, length, sides, 1, false);
  geometry.rotateX(Math.PI / 2);
  geometry.translate(0, 0, length / 2);
  const turn = new Quaternion().setFromUnitVectors(zAxis, along.divideScalar(length || 1));
  return geometry.applyMatrix4(new Matrix4().compose(from, turn, new Vector3(1, 1, 1)));
}

function ball(at: Vector3, radius: number): BufferGeometry {
  return new SphereGeometry(radius, 12, 8).translate(at.x, at.y, at.z);
}

// Bars along a line of points, round at its corners.
export function wire(points: Vector3[], radius: number): BufferGeometry | null {
  const pieces: BufferGeometry[] = [];
  points.forEach((point, i) => {
    const next = points[i + 1];
    if (next && next.distanceTo(point) > 0) pieces.push(bar(point, next, radius));
    pieces.push(ball(point, radius));
  });
  return pieces.length > 0 ? mergeGeometries(pieces) : null;
}

function surface(shape: Shape): BufferGeometry {
  const places: number[] = [];
  const normals: number[] = [];
  shape.triangles.forEach((corners, i) => {
    corners.forEach((corner, k) => {
      places.push(...(shape.vertices[corner] ?? [0, 0, 0]));
      normals.push(...(shape.normals[i]?.[k] ?? [0, 0, 1]));
    });
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(places), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(normals), 3));
  return geometry;
}

function edgeLines(shape: Shape): BufferGeometry {
  const places: number[] = [];
  for (const edge of shape.edges) {
    for (let i = 0; i + 1 < edge.length; ++i) {
      for (const corner of [edge[i], edge[i + 1]]) places.push(...(shape.vertices[corner ?? 0] ?? [0, 0, 0]));
    }
  }
  return new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(places), 3));
}

const vector = (v: Vector): Vector3 => new Vector3(...v);

// The bodies within whose boxes others lie with all that they have, as a drum in its casing: they let these be seen.
export function casings(bodies: Body[]): Set<number> {
  const boxes = bodies.map((body) => {
    const pose = matrixOf(body.pose);
    const box = new Box3();
    for (const shape of body.shapes) {
      if (shape.kind === "arm" || body.frame) continue;
      for (const vertex of shape.vertices) box.expandByPoint(vector(vertex).applyMatrix4(pose));
    }
    return box;
  });
  const found = new Set<number>();
  boxes.forEach((box, one) => {
    const solid = bodies[one]?.shapes.some((shape) => shape.triangles.length > 0) ?? false;
    if (!solid || box.isEmpty()) return;
    boxes.forEach((other, two) => {
      const [large, small] = [box.getSize(new Vector3()), other.getSize(new Vector3())];
      if (one !== two && !other.isEmpty() && small.length() < large.length() && box.containsBox(other)) found.add(one);
    });
  });
  return found;
}

function shapeNodes(
  shape: Shape,
  body: Body,
  number: number,
  size: number,
  paints: Paints,
  casing: boolean,
): (Mesh | LineSegments)[] {
  const faint = shape.hole || shape.stand_in || body.massless || casing;
  const look = faint ? "faint" : shape.added ? "added" : "matter";
  if (shape.extent === "point") {
    return shape.vertices.map((at) => new Mesh(ball(vector(at), 0.02 * size), paints.solid(number, look)));
  }
  if (shape.extent === "line") {
    const lines = shape.edges.map((edge) =>
      wire(
        edge.map((i) => vector(shape.vertices[i] ?? [0, 0, 0])),
        0.009 * size,
      ),
    );
    return lines.flatMap((line) =>
      line ? [new Mesh(line, paints.solid(number, look === "faint" ? "matter" : look))] : [],
    );
  }
  const nodes: (Mesh | LineSegments)[] = [];
  if (shape.triangles.length > 0 && !shape.hole) nodes.push(new Mesh(surface(shape), paints.solid(number, look)));
  if (shape.edges.length > 0) nodes.push(new LineSegments(edgeLines(shape), paints.edge));
  return nodes;
}

// A frame of reference: three axes.
function triad(size: number, paints: Paints): Mesh[] {
  return [0, 1, 2].map((k) => {
    const end = new Vector3().setComponent(k, 0.2 * size);
    return new Mesh(bar(new Vector3(), end, 0.004 * size), paints.ink);
  });
}

export function bodyNode(body: Body, number: number, size: number, paints: Paints, casing: boolean): Group {
  const group = new Group();
  group.name = body.name;
  if (body.frame) group.add(...triad(size, paints));
  // Of a body whose shape is not stated, its mass center is all that is known.
  if (body.shapes.every((shape) => shape.kind === "arm" || shape.stand_in) && body.mass > 0) {
    group.add(new Mesh(ball(vector(body.center), 0.02 * size), paints.solid(number, "matter")));
  }
  for (const shape of body.shapes) {
    const nodes = shapeNodes(shape, body, number, size, paints, casing);
    if (nodes.length > 0) group.add(...nodes);
  }
  return group;
}
