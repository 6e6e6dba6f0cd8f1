// Joints and supports by small symbols, on the axes of the body that is held.
import {
  BoxGeometry,
  type BufferGeometry,
  CylinderGeometry,
  Group,
  Mesh,
  Quaternion,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from "three";
import type { JointSymbol } from "../scene";
import type { Paints } from "./paints";

const sleeve = (s: number): BufferGeometry =>
  new CylinderGeometry(0.028 * s, 0.028 * s, 0.07 * s, 20, 1, true).rotateX(Math.PI / 2);
const ring = (s: number): BufferGeometry => new TorusGeometry(0.03 * s, 0.007 * s, 8, 24);
const block = (s: number): BufferGeometry => new BoxGeometry(0.05 * s, 0.05 * s, 0.09 * s);
const socket = (s: number): BufferGeometry => new SphereGeometry(0.03 * s, 16, 12);
const plate = (s: number): BufferGeometry => new BoxGeometry(0.1 * s, 0.1 * s, 0.008 * s);

// The parts of each symbol, with the axis along z.
const parts: Record<string, ((size: number) => BufferGeometry)[]> = {
  weld: [(s) => new BoxGeometry(0.035 * s, 0.035 * s, 0.035 * s)],
  revolute: [sleeve],
  hinge: [sleeve],
  journal: [sleeve],
  thrust: [sleeve, plate],
  cylindrical: [sleeve, ring],
  screw: [sleeve, ring],
  prismatic: [block],
  collar: [block],
  slot: [block],
  universal: [ring, (s) => ring(s).rotateX(Math.PI / 2)],
  fork: [ring],
  clevis: [ring],
  ball: [socket],
  ball_support: [socket],
  listed_support: [socket],
  planar: [plate],
  contact: [plate],
  rolling_contact: [plate],
};

export function symbolNode(symbol: JointSymbol, size: number, paints: Paints): Group {
  const group = new Group();
  const axis = new Vector3(...symbol.axis);
  if (axis.lengthSq() > 0)
    group.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), axis.normalize()));
  group.position.set(...symbol.place.at);
  for (const part of parts[symbol.kind] ?? [socket]) group.add(new Mesh(part(0.7 * size), paints.metal));
  return group;
}
