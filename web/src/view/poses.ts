// Where bodies are at a time of the motion: as recorded, and between records interpolated.
import { Matrix4, Quaternion, Vector3 } from "three";
import type { Motion, Pose } from "../scene";

export function matrixOf(pose: Pose): Matrix4 {
  const [a = 1, b = 0, c = 0, d = 0, e = 1, f = 0, g = 0, h = 0, i = 1] = pose.R;
  const [x, y, z] = pose.p;
  return new Matrix4().set(a, b, c, x, d, e, f, y, g, h, i, z, 0, 0, 0, 1);
}

// The index of the last time that is not after `time`, and the part of the way to the next.
export function placeInTimes(times: number[], time: number): { index: number; part: number } {
  const last = times.length - 1;
  if (last < 1 || time <= (times[0] ?? 0)) return { index: 0, part: 0 };
  if (time >= (times[last] ?? 0)) return { index: last, part: 0 };
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((times[middle] ?? 0) <= time) low = middle;
    else high = middle;
  }
  const begin = times[low] ?? 0;
  return { index: low, part: (time - begin) / ((times[high] ?? 0) - begin) };
}

export class Track {
  private readonly from = new Quaternion();
  private readonly to = new Quaternion();

  constructor(private readonly motion: Motion) {}

  pose(body: number, time: number, position: Vector3, turn: Quaternion): void {
    const { index, part } = placeInTimes(this.motion.times, time);
    this.recorded(body, index, position, turn);
    if (part === 0) return;
    const next = new Vector3();
    this.from.copy(turn);
    this.recorded(body, index + 1, next, this.to);
    position.lerp(next, part);
    turn.slerpQuaternions(this.from, this.to, part);
  }

  // Brings the ends of the links that have places of their own there.
  links(time: number, put: (link: number, from: Vector3, to: Vector3) => void): void {
    const { index, part } = placeInTimes(this.motion.times, time);
    const place = (flat: number[]): Vector3 => {
      const at = new Vector3().fromArray(flat, 3 * index);
      return part === 0 ? at : at.lerp(new Vector3().fromArray(flat, 3 * (index + 1)), part);
    };
    for (const { link, from, to } of this.motion.links ?? []) put(link, place(from), place(to));
  }

  private recorded(body: number, index: number, position: Vector3, turn: Quaternion): void {
    const track = this.motion.bodies[body];
    if (!track) return;
    const q = track.orientation;
    position.fromArray(track.position, 3 * index);
    turn.set(q[4 * index + 1] ?? 0, q[4 * index + 2] ?? 0, q[4 * index + 3] ?? 0, q[4 * index] ?? 1);
  }
}
