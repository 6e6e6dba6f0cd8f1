// The scene in space: bodies, joints, links, arrows and labels, at the shown instant or at a time of the motion.
import {
  AmbientLight,
  Box3,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  ConeGeometry,
  DirectionalLight,
  Group,
  Line,
  Matrix4,
  Mesh,
  type Object3D,
  Quaternion,
  Scene as Space,
  Sphere,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
} from "three";
import { element } from "../element";
import type { Arrow, Curve, Place, Scene } from "../scene";
import { equations, math } from "../text/math";
import { nameTex } from "../text/tex";
import { arrowLengths, arrowNode, tipOf } from "./arrows";
import { mainAxis, Viewpoint } from "./camera";
import { type Label, Labels } from "./labels";
import { linkNode, stretch, WrapNode } from "./links";
import { MovingArrows } from "./moving_arrows";
import { Paints } from "./paints";
import { matrixOf, Track } from "./poses";
import { bodyNode, casings } from "./solids";
import { symbolNode } from "./symbols";

interface Shown {
  diagram: number; // -1: no arrows
  quantities: Set<string>; // those that are left out
  names: boolean;
}

export class Stage {
  readonly viewpoint: Viewpoint;
  scriptTime = 0; // ms that the last frame took, without the work of the graphics
  private readonly space = new Space();
  private readonly renderer: WebGLRenderer;
  private readonly paints = new Paints();
  private readonly bodies: Group[];
  private readonly links: Mesh[];
  private readonly wraps: WrapNode[];
  private readonly arrows = new Group();
  private readonly moving: MovingArrows;
  private readonly labels: Labels;
  private readonly track: Track | null;
  private readonly size: number;
  private time: number | null = null; // null: the instant of the statement
  private waiting = false;
  private home: Vector3[] = []; // where the bodies stand at that instant
  private riding = false;
  readonly shown: Shown = { diagram: -1, quantities: new Set(), names: true };

  constructor(
    private readonly scene: Scene,
    private readonly canvas: HTMLCanvasElement,
    layer: HTMLElement,
  ) {
    this.size = scene.length;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.labels = new Labels(layer);
    this.track = scene.motion ? new Track(scene.motion) : null;
    const around = casings(scene.bodies);
    this.bodies = scene.bodies.map((body, i) => bodyNode(body, i, this.size, this.paints, around.has(i)));
    this.links = scene.links.map((link) => linkNode(link, this.size, this.paints));
    this.wraps = (scene.wraps ?? []).map((wrap) => new WrapNode(this.size, this.paints, wrap.name));
    const up = new Vector3(...scene.up);
    this.viewpoint = new Viewpoint(
      up,
      canvas,
      () => {
        this.ask();
      },
      scene.viewer ? new Vector3(...scene.viewer).normalize() : null,
    );
    this.moving = new MovingArrows(scene, this.size, this.paints, this.shown.quantities);
    this.space.add(new AmbientLight("#ffffff", 2.0), ...this.bodies, ...this.links, this.arrows, this.moving.group);
    // Nothing at all must not be added: that would be told as a mistake.
    for (const wrap of this.wraps) this.space.add(wrap.mesh);
    const sun = new DirectionalLight("#ffffff", 1.6);
    // The light stands to the left above the reader, wherever he looks from.
    this.viewpoint.camera.add(sun);
    sun.position.set(-1, 2, 3);
    this.space.add(this.viewpoint.camera);
    for (const symbol of scene.symbols) this.on(symbol.to).add(symbolNode(symbol, this.size, this.paints));
    this.addCurves();
    this.addCones();
    this.setPoses(null);
    this.fit();
    this.chooseDiagram(this.firstDiagram());
  }

  // The diagram that is shown first: that of the answers, else the first that has arrows.
  private firstDiagram(): number {
    const answers = this.scene.diagrams.findIndex((one) => one.kind === "answers" && one.arrows.length > 0);
    return answers >= 0 ? answers : this.scene.diagrams.findIndex((one) => one.arrows.length > 0);
  }

  private on(body: number): Object3D {
    return this.bodies[body] ?? this.space;
  }

  private whereIs(place: Place): Vector3 {
    const at = new Vector3(...place.at);
    const body = this.bodies[place.body];
    return body ? at.applyMatrix4(body.matrixWorld) : at;
  }

  private addCurves(): void {
    for (const curve of this.scene.curves) {
      if (curve.kind === "surface" || curve.kind === "attractor") {
        this.on(curve.body).add(this.held(curve));
        continue;
      }
      const points = curve.closed && curve.points[0] ? [...curve.points, curve.points[0]] : curve.points;
      const geometry = new BufferGeometry().setAttribute(
        "position",
        new BufferAttribute(new Float32Array(points.flat()), 3),
      );
      this.on(curve.body).add(new Line(geometry, this.paints.curve));
    }
  }

  // A piece of a surface that is touched later, or the center that pulls.
  private held(curve: Curve): Mesh {
    const place = new Vector3(...(curve.points[0] ?? [0, 0, 0]));
    const surface = curve.kind === "surface";
    const shape = surface
      ? new BoxGeometry(0.3 * this.size, 0.3 * this.size, 0.004 * this.size)
      : new SphereGeometry(0.03 * this.size, 24, 16);
    const node = new Mesh(shape, this.paints.metal);
    node.position.copy(place);
    if (surface)
      node.quaternion.setFromUnitVectors(
        new Vector3(0, 0, 1),
        new Vector3(...(curve.points[1] ?? [0, 0, 1])).sub(place).normalize(),
      );
    return node;
  }

  private addCones(): void {
    for (const cone of this.scene.cones) {
      const height = 0.5 * this.size * Math.cos(cone.half_angle);
      const radius = 0.5 * this.size * Math.sin(cone.half_angle);
      // A cone of three.js has its apex up; here it stands on its apex along z.
      const geometry = new ConeGeometry(radius, height, 48, 1, true).rotateX(-Math.PI / 2).translate(0, 0, height / 2);
      const node = new Mesh(geometry, this.paints.cone);
      node.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...cone.axis).normalize());
      node.position.set(...cone.apex);
      this.on(cone.body).add(node);
    }
  }

  private setPoses(time: number | null): void {
    this.time = time;
    const position = new Vector3();
    const turn = new Quaternion();
    this.bodies.forEach((node, i) => {
      const body = this.scene.bodies[i];
      if (time !== null && this.track) this.track.pose(i, time, position, turn);
      else if (body) matrixOf(body.pose).decompose(position, turn, new Vector3());
      node.position.copy(position);
      node.quaternion.copy(turn);
      node.updateMatrixWorld(true);
    });
    const ends = this.scene.links.map((link) => ({ from: this.whereIs(link.from), to: this.whereIs(link.to) }));
    if (time !== null)
      this.track?.links(time, (link, from, to) => {
        ends[link] = { from, to };
      });
    ends.forEach(({ from, to }, i) => {
      const node = this.links[i];
      if (node) stretch(node, from, to);
    });
    this.scene.wraps?.forEach((wrap, i) => {
      const comes = ends[wrap.comes];
      const leaves = ends[wrap.leaves];
      const axis = new Vector3(...wrap.axis).applyQuaternion(this.on(wrap.center.body).quaternion);
      if (comes && leaves) this.wraps[i]?.lay(this.whereIs(wrap.center), axis, comes.from, leaves.to);
    });
  }

  goesFar = false; // whether the bodies go together so far that they would be small beside their way

  // How far the bodies have gone on the average.
  private way(): Vector3 {
    const sum = new Vector3();
    let count = 0;
    this.bodies.forEach((node, i) => {
      const home = this.home[i];
      if (!home || this.scene.bodies[i]?.frame) return;
      sum.add(node.position).sub(home);
      ++count;
    });
    return sum.divideScalar(Math.max(1, count));
  }

  // Whether the view goes with the bodies.
  ride(on: boolean): void {
    this.riding = on;
    this.viewpoint.ride(on && this.time !== null ? this.way() : new Vector3());
    this.ask();
  }

  // Everything that is seen at any time, but no farther away than three sizes of the scene.
  private fit(): void {
    const box = new Box3();
    const home = new Box3();
    this.home = this.bodies.map((node) => node.position.clone());
    for (const node of this.bodies) home.expandByObject(node, true);
    for (const point of this.scene.points) home.expandByPoint(this.whereIs(point.place));
    for (const link of this.scene.links) {
      home.expandByPoint(this.whereIs(link.from));
      home.expandByPoint(this.whereIs(link.to));
    }
    // Arrows of every diagram, so that to choose another moves nothing.
    for (const { arrows } of this.scene.diagrams) {
      const lengths = arrowLengths(arrows, this.size);
      arrows.forEach((arrow, i) => {
        const at = this.whereIs(arrow.at);
        home.expandByPoint(at).expandByPoint(tipOf(arrow, at, lengths[i] ?? 0));
      });
    }
    if (home.isEmpty())
      home
        .set(new Vector3(-1, -1, -1), new Vector3(1, 1, 1))
        .applyMatrix4(new Matrix4().makeScale(this.size, this.size, this.size));
    box.copy(home);
    const { motion } = this.scene;
    if (motion) {
      const far = home.clone().expandByScalar(3 * this.size);
      const stride = Math.max(1, Math.floor(motion.times.length / 60));
      const whole = home.clone();
      const along = home.clone();
      for (let i = 0; i < motion.times.length; i += stride) {
        this.setPoses(motion.times[i] ?? 0);
        const back = this.way().negate();
        for (const node of this.bodies) {
          const own = new Box3().setFromObject(node);
          whole.union(own);
          along.union(own.clone().translate(back));
          box.union(own.intersect(far));
        }
      }
      this.setPoses(null);
      const part = along.getBoundingSphere(new Sphere()).radius / whole.getBoundingSphere(new Sphere()).radius;
      this.goesFar = part < 0.5;
      this.riding = this.goesFar;
      if (this.riding) box.copy(along);
    }
    const sphere = box.getBoundingSphere(new Sphere());
    this.viewpoint.fit(sphere.center, Math.max(sphere.radius * 1.08, 0.62 * this.size));
  }

  // The arrows of a diagram; the bodies that it leaves out are not drawn.
  chooseDiagram(index: number): void {
    this.shown.diagram = index;
    const diagram = this.scene.diagrams[index];
    const arrows = diagram?.arrows ?? [];
    const lengths = arrowLengths(arrows, this.size);
    this.arrows.clear();
    this.arrowLabels = [];
    arrows.forEach((arrow, i) => {
      this.addArrow(arrow, lengths[i] ?? this.size);
    });
    this.bodies.forEach((node, i) => {
      node.visible = !diagram || diagram.bodies.length === 0 || diagram.bodies.includes(i);
    });
    this.refreshLabels();
    this.followTheme();
  }

  private arrowLabels: Label[] = [];

  private addArrow(arrow: Arrow, length: number): void {
    const node = arrowNode(arrow, length, this.size, this.paints);
    const at = this.whereIs(arrow.at);
    node.position.copy(at);
    node.name = arrow.name;
    this.arrows.add(node);
    const tip = tipOf(arrow, at, length);
    this.arrowLabels.push({
      node: element("span", { class: "label arrow-label" }, math(arrow.symbol || nameTex(arrow.text))),
      rank: 0,
      place: () => tip,
      shown: () => this.arrows.visible && node.visible,
    });
    const { quantity } = arrow;
    node.userData.quantity = quantity;
    node.visible = !this.shown.quantities.has(quantity);
  }

  toggleQuantity(quantity: string, on: boolean): void {
    if (on) this.shown.quantities.delete(quantity);
    else this.shown.quantities.add(quantity);
    for (const node of this.arrows.children)
      node.visible = !this.shown.quantities.has(node.userData.quantity as string);
    this.moving.setTime(this.time, (place) => this.whereIs(place));
    this.ask();
  }

  showNames(on: boolean): void {
    this.shown.names = on;
    this.ask();
  }

  private refreshLabels(): void {
    const names = (): boolean => this.shown.names;
    const points = this.scene.points.map((point): Label => ({
      node: element("span", { class: "label" }, math(nameTex(point.name))),
      rank: 1,
      place: () => this.whereIs(point.place),
      shown: names,
    }));
    const axes = this.scene.axes.map((name, k): Label => {
      const end = new Vector3().setComponent(k, 0.5 * this.size).add(this.axesAt());
      return {
        node: element("span", { class: "label axis-label" }, math(nameTex(name))),
        rank: 2,
        place: () => end,
        shown: () => true,
      };
    });
    const dimensions = this.scene.dimensions
      .filter((one) => !one.angle)
      .map((one): Label => ({
        node: element("span", { class: "label faint" }, ...equations(one.text)),
        rank: 3,
        place: () => this.whereIs(one.from).add(this.whereIs(one.to)).multiplyScalar(0.5),
        shown: () => names() && this.time === null,
      }));
    this.labels.set([...this.arrowLabels, ...this.moving.labels, ...points, ...axes, ...dimensions]);
    if (!this.axesDrawn) this.drawAxes();
  }

  private axesDrawn = false;

  // Where the ground's axes are drawn: at their origin if that is near what is seen.
  private axesAt(): Vector3 {
    return new Vector3();
  }

  private drawAxes(): void {
    this.axesDrawn = true;
    for (let k = 0; k < 3; ++k) {
      const end = new Vector3().setComponent(k, 0.5 * this.size);
      const geometry = new BufferGeometry().setFromPoints([new Vector3(), end]);
      const line = new Line(geometry, this.paints.faintLine);
      this.paints.faintLine.dashSize = 0.02 * this.size;
      this.paints.faintLine.gapSize = 0.012 * this.size;
      line.computeLineDistances();
      line.position.copy(this.axesAt());
      this.space.add(line);
    }
  }

  // null: the instant of the statement, to which the arrows belong.
  setTime(time: number | null): void {
    this.setPoses(time);
    this.arrows.visible = time === null;
    if (this.goesFar) this.ride(this.riding);
    this.moving.setTime(time, (place) => this.whereIs(place));
    this.ask();
  }

  look(axis: number | null): void {
    if (axis === null) this.viewpoint.goHome();
    else this.viewpoint.along(mainAxis(new Vector3(1, 0, 0), axis));
  }

  followTheme(): void {
    const style = getComputedStyle(this.canvas);
    this.paints.follow(style.getPropertyValue("--ink").trim() || "#222222", style.colorScheme === "dark");
    this.ask();
  }

  // Draws the next frame, once however often it is asked.
  ask(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  draw(): void {
    const begin = performance.now();
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (width === 0 || height === 0) return;
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    if (this.canvas.width !== Math.floor(width * ratio) || this.canvas.height !== Math.floor(height * ratio)) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
      this.viewpoint.resize(width, height);
    }
    this.renderer.render(this.space, this.viewpoint.camera);
    this.labels.arrange(this.viewpoint.camera, width, height);
    this.scriptTime = performance.now() - begin;
  }

  // What the arrows of the motion show, for tests.
  movingArrows(): { name: string; quantity: string; visible: boolean; direction: number[]; length: number }[] {
    return this.moving.told();
  }

  // The arcs of cords on wheels, for tests.
  wrapped(): { name: string; radius: number; angle: number }[] {
    return this.wraps.map((wrap) => wrap.told());
  }

  // Where the bodies stand in the picture, for tests: position and turn (x y z w) of each.
  poses(): { name: string; position: number[]; turn: number[] }[] {
    return this.bodies.map((node) => {
      const position = new Vector3();
      const turn = new Quaternion();
      node.matrixWorld.decompose(position, turn, new Vector3());
      return { name: node.name, position: position.toArray(), turn: turn.toArray() };
    });
  }
}
