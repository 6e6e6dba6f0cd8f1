// A parallel view that is turned, moved and enlarged by mouse, touch and keys.
import { OrthographicCamera, Vector3 } from "three";

// Straight from above it would not be said what is up in the picture.
const steepest = Math.PI / 2 - 1e-4;

export class Viewpoint {
  readonly camera = new OrthographicCamera();
  private readonly target = new Vector3();
  private readonly ridden = new Vector3(); // how far what is looked at has gone since the instant of the statement
  private radius = 1; // half of what is seen
  private home: { target: Vector3; radius: number } = { target: new Vector3(), radius: 1 };
  private readonly pointers = new Map<number, { x: number; y: number }>();
  // Directions of the turn about `up`: where the view begins, and at a right angle to it.
  private readonly front: Vector3;
  private readonly side: Vector3;
  private turn = 0;
  private height = 0;
  private aspect = 1;

  constructor(
    private readonly up: Vector3,
    private readonly canvas: HTMLElement,
    private readonly changed: () => void,
    private readonly wanted: Vector3 | null = null, // from where it is looked at first
  ) {
    this.front = mainAxis(up, 1);
    this.front.addScaledVector(up, -this.front.dot(up)).normalize();
    this.side = up.clone().cross(this.front);
    this.camera.up.copy(up);
    this.asDrawn();
    this.listen();
  }

  fit(center: Vector3, radius: number): void {
    this.home = { target: center.clone(), radius };
    this.goHome();
  }

  // Goes with what is looked at.
  ride(way: Vector3): void {
    if (this.ridden.equals(way)) return;
    this.ridden.copy(way);
    this.update();
  }

  goHome(): void {
    this.target.copy(this.home.target);
    this.radius = this.home.radius;
    this.asDrawn();
  }

  // The usual view of figures: the axis that comes after the upward one points to the left and toward the reader.
  asDrawn(): void {
    if (this.wanted) {
      this.along(this.wanted);
      return;
    }
    this.turn = 0.6;
    this.height = 0.42;
    this.update();
  }

  // Looks against a direction.
  along(direction: Vector3): void {
    this.height = Math.asin(Math.max(-1, Math.min(1, direction.dot(this.up))));
    this.height = Math.max(-steepest, Math.min(steepest, this.height));
    if (Math.abs(this.height) < steepest) this.turn = Math.atan2(direction.dot(this.side), direction.dot(this.front));
    else this.turn = Math.abs(this.up.z) > 0.7 ? -Math.PI / 2 : 0; // with x to the right
    this.update();
  }

  resize(width: number, height: number): void {
    this.aspect = width / height;
    this.update();
  }

  private update(): void {
    const c = Math.cos(this.height);
    const direction = this.front
      .clone()
      .multiplyScalar(c * Math.cos(this.turn))
      .addScaledVector(this.side, c * Math.sin(this.turn))
      .addScaledVector(this.up, Math.sin(this.height));
    const away = 10 * Math.max(this.radius, this.home.radius);
    const { camera } = this;
    const target = this.target.clone().add(this.ridden);
    camera.position.copy(target).addScaledVector(direction, away);
    const half = this.aspect >= 1 ? this.radius : this.radius / this.aspect;
    camera.left = -half * this.aspect;
    camera.right = half * this.aspect;
    camera.top = half;
    camera.bottom = -half;
    camera.near = 0;
    camera.far = 2 * away;
    camera.lookAt(target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    this.changed();
  }

  private rotate(right: number, up: number): void {
    this.turn -= right;
    this.height = Math.max(-steepest, Math.min(steepest, this.height + up));
    this.update();
  }

  private pan(right: number, up: number): void {
    const perPixel = (this.camera.top - this.camera.bottom) / Math.max(1, this.canvas.clientHeight);
    const axis = new Vector3();
    this.target.addScaledVector(axis.setFromMatrixColumn(this.camera.matrixWorld, 0), -right * perPixel);
    this.target.addScaledVector(axis.setFromMatrixColumn(this.camera.matrixWorld, 1), -up * perPixel);
    this.update();
  }

  private zoom(factor: number): void {
    this.radius = Math.max(this.home.radius / 50, Math.min(this.home.radius * 20, this.radius * factor));
    this.update();
  }

  private listen(): void {
    const { canvas } = this;
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    for (const name of ["pointerup", "pointercancel"] as const) {
      canvas.addEventListener(name, (event) => this.pointers.delete(event.pointerId));
    }
    canvas.addEventListener("pointermove", (event) => {
      this.drag(event);
    });
    canvas.addEventListener("contextmenu", (event) => {
      event.preventDefault();
    });
    // Without Ctrl the wheel moves the page, unless the reader has chosen the picture.
    canvas.addEventListener(
      "wheel",
      (event) => {
        if (!event.ctrlKey && document.activeElement !== canvas) return;
        event.preventDefault();
        this.zoom(Math.exp(0.0015 * event.deltaY));
      },
      { passive: false },
    );
    canvas.addEventListener("keydown", (event) => {
      if (this.key(event.key, event.shiftKey)) event.preventDefault();
    });
  }

  private drag(event: PointerEvent): void {
    const last = this.pointers.get(event.pointerId);
    if (!last) return;
    const now = { x: event.clientX, y: event.clientY };
    const right = now.x - last.x;
    const down = now.y - last.y;
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    this.pointers.set(event.pointerId, now);
    if (other) {
      const before = Math.hypot(last.x - other.x, last.y - other.y);
      const after = Math.hypot(now.x - other.x, now.y - other.y);
      if (before > 0 && after > 0) this.zoom(before / after);
      this.pan(right / 2, -down / 2);
    } else if (event.shiftKey || event.buttons === 2 || event.buttons === 4) {
      this.pan(right, -down);
    } else {
      this.rotate(right * 0.01, down * 0.01);
    }
  }

  // Whether the key is one of the view's.
  private key(key: string, shift: boolean): boolean {
    const arrows: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    const step = arrows[key];
    if (step && shift) this.pan(20 * step[0], 20 * step[1]);
    else if (step) this.rotate(0.1 * step[0], 0.1 * step[1]);
    else if (key === "+" || key === "=") this.zoom(1 / 1.15);
    else if (key === "-") this.zoom(1.15);
    else if (key === "0" || key === "Home") this.goHome();
    else return false;
    return true;
  }
}

// The unit vector of the axis that comes so many places after the one nearest to `up`.
export function mainAxis(up: Vector3, after: number): Vector3 {
  const parts = up.toArray().map(Math.abs);
  const nearest = parts.indexOf(Math.max(...parts));
  return new Vector3().setComponent((nearest + after) % 3, 1);
}
