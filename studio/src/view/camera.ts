/** The camera: turns about a target, zooms and pans; orthographic and perspective show the same at the target. */

import { Matrix4, OrthographicCamera, PerspectiveCamera, Vector3 } from "three";

export type Projection = "perspective" | "orthographic";
export type ViewName = "iso" | "top" | "side" | "back" | "front" | "bottom";

/** Azimuth about z from the x axis and elevation above the xy plane, in degrees, as in the figures of the report. */
export const VIEWS: Readonly<Record<ViewName, readonly [number, number]>> = {
  iso: [-55, 26], top: [-90, 90], side: [-90, 0], back: [0, 0], front: [180, 0], bottom: [-90, -90],
};

const HALF_FIELD = (14 * Math.PI) / 180;
const RADIANS = Math.PI / 180;

export interface Axes {
  readonly right: Vector3;
  readonly up: Vector3;
  readonly towards: Vector3;
}

/** Unit vectors to the right, upwards and towards the eye, seen from a direction. */
export function axesOf(azimuth: number, elevation: number): Axes {
  const a = azimuth * RADIANS, e = elevation * RADIANS;
  return {
    right: new Vector3(-Math.sin(a), Math.cos(a), 0),
    up: new Vector3(-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e)),
    towards: new Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)),
  };
}

export class Orbit {
  azimuth = VIEWS.iso[0];
  elevation = VIEWS.iso[1];
  /** Half the height of what is seen at the target, in scene lengths. */
  span = 1.1;
  readonly target = new Vector3();
  /** The projection chosen; a view along an axis is parallel whatever is chosen, until it is turned. */
  chosen: Projection = "perspective";
  straight = false;
  /** Whether it was turned, panned or zoomed by hand since it last went to a view. */
  moved = false;
  private readonly perspective = new PerspectiveCamera((2 * HALF_FIELD) / RADIANS, 1, 0.01, 100);
  private readonly orthographic = new OrthographicCamera();
  private goal: { azimuth: number; elevation: number; span: number; target: Vector3; start: number } | null = null;
  private from = { azimuth: 0, elevation: 0, span: 1, target: new Vector3() };

  get projection(): Projection {
    return this.straight ? "orthographic" : this.chosen;
  }

  /** The three.js camera for a viewport of this shape. */
  camera(aspect: number): PerspectiveCamera | OrthographicCamera {
    const camera = this.projection === "perspective" ? this.perspective : this.orthographic;
    // A narrow viewport shows as much across as a square one.
    const half = this.span / Math.min(1, aspect);
    const distance = half / Math.tan(HALF_FIELD);
    const { right, up, towards } = this.axes();
    camera.position.copy(this.target).addScaledVector(towards, distance);
    camera.matrixWorld.copy(new Matrix4().makeBasis(right, up, towards)).setPosition(camera.position);
    camera.matrixWorld.decompose(camera.position, camera.quaternion, camera.scale);
    if (camera instanceof PerspectiveCamera) {
      camera.aspect = aspect;
      camera.near = Math.max(distance - 6, 0.02 * distance);
      camera.far = distance + 12;
    } else {
      camera.left = -half * aspect;
      camera.right = half * aspect;
      camera.top = half;
      camera.bottom = -half;
      camera.near = distance - 12;
      camera.far = distance + 12;
    }
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld(true);
    return camera;
  }

  /** Unit vectors to the right, upwards and towards the eye. */
  axes(): Axes {
    return axesOf(this.azimuth, this.elevation);
  }

  turn(dx: number, dy: number): void {
    this.goal = null;
    this.moved = true;
    this.straight = false;
    this.azimuth -= dx * 0.35;
    this.elevation = Math.max(-90, Math.min(90, this.elevation + dy * 0.35));
  }

  /** Move the target by a share of the height of a viewport of this shape. */
  pan(dx: number, dy: number, aspect = 1): void {
    this.goal = null;
    this.moved = true;
    const { right, up } = this.axes(), height = (2 * this.span) / Math.min(1, aspect);
    this.target.addScaledVector(right, -dx * height).addScaledVector(up, dy * height);
  }

  /** Zoom about a point of a viewport of this shape, by shares of its height to the right of and below its middle. */
  zoom(factor: number, x = 0, y = 0, aspect = 1): void {
    this.goal = null;
    const before = this.span;
    this.span = Math.max(1e-4, Math.min(20, this.span * factor));
    const kept = before / this.span - 1;
    this.pan(-x * kept, -y * kept, aspect);
  }

  /** Glide to a view; `still` (reduced motion) jumps. */
  go(azimuth: number, elevation: number, span: number, target: Vector3, still: boolean): void {
    this.moved = false;
    if (still) {
      this.azimuth = azimuth;
      this.elevation = elevation;
      this.span = span;
      this.target.copy(target);
      return;
    }
    let turn = (azimuth - this.azimuth) % 360;
    if (turn > 180) turn -= 360;
    if (turn < -180) turn += 360;
    this.from = { azimuth: this.azimuth, elevation: this.elevation, span: this.span, target: this.target.clone() };
    this.goal = { azimuth: this.azimuth + turn, elevation, span, target: target.clone(), start: performance.now() };
  }

  /** Advance a glide; true while there is more to come. */
  step(now: number): boolean {
    if (!this.goal) return false;
    const share = Math.min(1, Math.max(0, (now - this.goal.start) / 260));
    const t = 1 - (1 - share) ** 3;
    const mix = (a: number, b: number) => a + (b - a) * t;
    this.azimuth = mix(this.from.azimuth, this.goal.azimuth);
    this.elevation = mix(this.from.elevation, this.goal.elevation);
    this.span = mix(this.from.span, this.goal.span);
    this.target.lerpVectors(this.from.target, this.goal.target, t);
    if (share >= 1) this.goal = null;
    return share < 1;
  }
}
