// Materials of the view. Lines take the colour of the page's text, so that they are seen in light and in dark.
import {
  Color,
  DoubleSide,
  GreaterDepth,
  LineBasicMaterial,
  LineDashedMaterial,
  MeshBasicMaterial,
  MeshLambertMaterial,
} from "three";

// Tones that the colour-blind tell apart (Okabe and Ito), in the order of the bodies.
const tones = ["#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#0072b2", "#d55e00", "#999999"];

// Quantities share the colour of their kind. Inertial terms are told apart by their heads as well.
const arrowTones: Record<string, string> = {
  force: "#c1272d",
  weight: "#8a5a00",
  couple: "#b5179e",
  impulse: "#c1272d",
  angular_impulse: "#b5179e",
  velocity: "#0b6e4f",
  angular_velocity: "#0b6e4f",
  acceleration: "#5b3fd6",
  angular_acceleration: "#5b3fd6",
  linear_momentum: "#1257b8",
  angular_momentum: "#1257b8",
  rate_of_momentum: "#1257b8",
  rate_of_angular_momentum: "#1257b8",
  displacement: "#0b6e4f",
  angular_displacement: "#0b6e4f",
  unbalance: "#1a1a1a",
};

export class Paints {
  readonly edge = new LineBasicMaterial();
  readonly faintLine = new LineDashedMaterial({ dashSize: 0.02, gapSize: 0.015, transparent: true, opacity: 0.7 });
  readonly metal = new MeshLambertMaterial({ color: "#8b95a1" });
  readonly ink = new MeshBasicMaterial();
  readonly cone = new MeshLambertMaterial({
    color: "#7b61ff",
    transparent: true,
    opacity: 0.25,
    side: DoubleSide,
    depthWrite: false,
  });
  readonly curve = new LineBasicMaterial({ color: "#d55e00" });
  private readonly solids = new Map<string, MeshLambertMaterial>();
  private readonly arrows = new Map<string, MeshBasicMaterial>();
  private readonly hiddenArrows = new Map<string, MeshBasicMaterial>();

  // What a body's matter looks like; what is added is darker, and what is cut out or has no mass lets the light
  // through.
  solid(body: number, look: "matter" | "added" | "faint"): MeshLambertMaterial {
    const key = `${body} ${look}`;
    let material = this.solids.get(key);
    if (!material) {
      const color = new Color(tones[body % tones.length] ?? "#999999");
      if (look === "added") color.multiplyScalar(0.6);
      material = new MeshLambertMaterial({
        color,
        side: DoubleSide,
        polygonOffset: true,
        polygonOffsetFactor: 2,
        polygonOffsetUnits: 8,
        ...(look === "faint" ? { transparent: true, opacity: 0.25, depthWrite: false } : {}),
      });
      this.solids.set(key, material);
    }
    return material;
  }

  // Of what stands behind a body: it shines through.
  hiddenArrow(quantity: string): MeshBasicMaterial {
    let material = this.hiddenArrows.get(quantity);
    if (!material) {
      material = this.arrow(quantity).clone();
      material.setValues({ transparent: true, opacity: 0.35, depthFunc: GreaterDepth, depthWrite: false });
      this.hiddenArrows.set(quantity, material);
    }
    return material;
  }

  arrow(quantity: string): MeshBasicMaterial {
    let material = this.arrows.get(quantity);
    if (!material) {
      material = new MeshBasicMaterial({ color: arrowTones[quantity] ?? "#c1272d" });
      this.arrows.set(quantity, material);
    }
    return material;
  }

  // In the dark, arrows are lighter.
  follow(ink: string, dark: boolean): void {
    for (const material of [this.edge, this.faintLine, this.ink]) material.color.set(ink);
    for (const [quantity, material] of [...this.arrows, ...this.hiddenArrows]) {
      material.color.set(arrowTones[quantity] ?? "#c1272d");
      if (dark) material.color.lerp(new Color("#ffffff"), 0.45);
    }
  }
}
