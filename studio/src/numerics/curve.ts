/** Curves, in the plane or in space: points, curvature, torsion, combs and length (Python: geometry/curve.py). */

import { chosenOf, isClassical, isStandard } from "./chosen";
import type { Formulas } from "./formulas";
import { ModelError, valueOf, type Patch } from "./kinds";
import { localOrigin, seenFrom } from "./origin";

type Vec = readonly number[];

const SINGULAR = 1e-13; // speed below this share of the polygon's length: the tangent is lost to rounding
const STRAIGHT = 1e-10; // curvature times the polygon's length below which a comb would be made of rounding
const SIDE = 400; // steps of the sums for length

/** What a curve is at one parameter: lengths in model units, curvature signed in the plane (left turns positive), NaN where there is none. */
export interface CurvePoint {
  readonly t: number;
  readonly point: Vec;
  readonly curvature: number;
  readonly torsion: number;
  /** Towards the centre of curvature, as long as the curvature. */
  readonly bend: Vec;
  readonly speed: number;
}

export const isCurve = (patch: Patch): boolean => patch.kind === "curve";

/** z(t) = Σ P_i f_i(t), t in [0, 1]; a plane curve lies at z = 0. */
export class Curve {
  readonly flat: boolean;
  /** Length of the control polygon. */
  readonly polygon: number;
  private readonly origin: Vec;
  private readonly local: readonly Vec[];

  constructor(readonly points: readonly Vec[], private readonly functions: Formulas, private readonly backwards = false) {
    this.flat = points[0]!.length === 2;
    const whole = points.map((p) => [p[0]!, p[1]!, p[2] ?? 0]);
    this.origin = functions.partition ? localOrigin(whole) : [0, 0, 0];
    this.local = whole.map((p) => seenFrom(p, this.origin));
    this.polygon = this.local.slice(1).reduce((sum, p, i) => sum + Math.hypot(...p.map((x, k) => x - this.local[i]![k]!)), 0);
  }

  /** Derivatives 0 to 3 at t, each (x, y, z). */
  derivatives(t: number): [number[], number[], number[], number[]] {
    const series = this.functions.series(this.backwards ? 1 - t : t, 3), turn = this.backwards ? -1 : 1;
    const sum = (k: number, factor: number) => [0, 1, 2].map((x) => factor * this.local.reduce((all, p, i) => all + series[i]![k]! * p[x]!, 0));
    return [sum(0, 1).map((x, i) => x + this.origin[i]!), sum(1, turn), sum(2, 2), sum(3, 6 * turn)];
  }

  at(t: number): CurvePoint {
    const [point, first, second, third] = this.derivatives(t);
    const speed = Math.hypot(...first), lost = !(speed > SINGULAR * this.polygon);
    const normal = cross(first, second), turn = Math.hypot(...normal);
    const sign = this.flat && normal[2]! < 0 ? -1 : 1;
    const noise = 1e-13 * speed * Math.max(Math.hypot(...second), this.polygon);
    const along = dot(first, second) / speed ** 4;
    return {
      t, point, speed,
      curvature: lost ? NaN : (sign * turn) / speed ** 3,
      torsion: lost || turn <= noise ? NaN : dot(normal, third) / turn ** 2,
      bend: second.map((x, i) => (lost ? NaN : x / speed ** 2 - first[i]! * along)),
    };
  }

  /** So many points evenly spaced in t. */
  sample(count: number): CurvePoint[] {
    return Array.from({ length: count }, (_, i) => this.at(i / (count - 1)));
  }

  /** Arc length by Gauss's rule with two nodes a step. */
  get length(): number {
    const away = 0.5 / Math.sqrt(3), steps = Array.from({ length: SIDE }, (_, i) => i);
    const speed = (t: number) => Math.hypot(...this.derivatives(t)[1]);
    return steps.reduce((sum, i) => sum + speed((i + 0.5 - away) / SIDE) + speed((i + 0.5 + away) / SIDE), 0) / (2 * SIDE);
  }

  /** Whether a curvature is more than rounding. */
  bends = (curvature: number): boolean => Math.abs(curvature) * this.polygon > STRAIGHT;
}

const known = new WeakMap<Patch, Curve | ModelError>();

/** The curve of a patch; ModelError where its values do not go together. */
export function curveOf(patch: Patch): Curve {
  let found = known.get(patch);
  if (!found) {
    try {
      found = made(patch);
    } catch (error) {
      found = new ModelError(`patch "${patch.name}": ${(error as Error).message}`);
    }
    known.set(patch, found);
  }
  if (found instanceof ModelError) throw found;
  return found;
}

function made(patch: Patch): Curve {
  const own = valueOf(patch, "points") as Vec[];
  if (own.some((p) => p.length !== own[0]!.length)) throw new Error("points: expected points all [x, y] or all [x, y, z]");
  const [basis] = chosenOf(patch);
  const backwards = valueOf(patch, "flip") === true;
  if (backwards && !isStandard(patch) && !isClassical(patch)) throw new Error("flip: expected the quintic or the Bernstein basis, whose ends can be exchanged");
  return new Curve(valueOf(patch, "close") === true ? [...own, own[0]!] : own, basis!.formulas(), backwards);
}

const dot = (p: Vec, q: Vec): number => p[0]! * q[0]! + p[1]! * q[1]! + p[2]! * q[2]!;
const cross = (p: Vec, q: Vec): number[] => [p[1]! * q[2]! - p[2]! * q[1]!, p[2]! * q[0]! - p[0]! * q[2]!, p[0]! * q[1]! - p[1]! * q[0]!];
