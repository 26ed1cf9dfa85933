/** The enveloping developable: the strip that a one-parameter family of planes touches (thesis §3.3). */

import { Bernstein, TangentBernstein } from "./basis";
import type { Vector } from "./construct";
import { degreeTen, wedgePoints, WEIGHTS, withoutFactor } from "./rational";
import { Net, Projected, type Surface } from "./surface";

/** The strip enveloped by Π(t) = Σ f_i(t; α, ζ) L_i between two bounding planes; Error where there is none. */
export function developable(planes: readonly Vector[], bounds: readonly Vector[], shape: readonly number[], flip: boolean): Surface {
  const alpha = shape[0]!, zeta = shape[1]!;
  const ten = degreeTen(planes, alpha, zeta).map((row, i) => row.map((x) => x * WEIGHTS[i]!));
  const rulings = withoutFactor(wedgePoints(ten), alpha === -4, zeta === -4);
  const n = rulings.length;
  const values = new Float64Array(n * 2 * 4);
  let largest = 0, weight = 0;
  bounds.forEach((plane, j) =>
    rulings.forEach((ruling, i) => {
      const point = meet(ruling, plane);
      values.set(point, (2 * i + j) * 4);
      largest = Math.max(largest, ...point.map(Math.abs));
      weight = Math.max(weight, Math.abs(point[3]!));
    }),
  );
  if (!(weight > 1e-12 * largest)) {
    throw new Error(
      "planes: the control planes envelop no strip that the bounding planes cut (they are equal, parallel, or all " +
        "contain one line that a bounding plane contains too); change the planes or the bounds",
    );
  }
  const net = new Net({ values, n, m: 2, dimension: 4 }, new TangentBernstein(n - 1));
  return { rows: new Projected(net), blend: new Bernstein(1), flip, net: null };
}

/** Parameters u in [0, 1], `samples` of them evenly spaced, at which the edge of regression lies inside the strip. */
export function regression(surface: Surface, samples = 257): { start: number; end: number }[] {
  const u = Float64Array.from({ length: samples }, (_, i) => i / (samples - 1));
  const q = new Float64Array(3 * samples * 6);
  surface.rows.derivatives(u, samples, q);
  const intervals: { start: number; end: number }[] = [];
  let open = false;
  for (let p = 0; p < samples; p++) {
    const inside = jacobians(q, samples, p) <= 0;
    if (inside && !open) intervals.push({ start: u[p]!, end: u[p]! });
    if (inside) intervals[intervals.length - 1]!.end = u[p]!;
    open = inside;
  }
  return intervals;
}

/** The product of S_u × S_v at both boundaries along the common normal; at most 0 where it vanishes between them. */
function jacobians(q: Float64Array, n: number, p: number): number {
  const at = (k: number, j: number, x: number) => q[((k * n + p) * 2 + j) * 3 + x]!;
  const ruling = [0, 1, 2].map((x) => at(0, 1, x) - at(0, 0, x));
  const [a, b] = [0, 1].map((j) => cross([at(1, j, 0), at(1, j, 1), at(1, j, 2)], ruling)) as [number[], number[]];
  return a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;
}

const cross = (a: number[], b: number[]): number[] => [
  a[1]! * b[2]! - a[2]! * b[1]!, a[2]! * b[0]! - a[0]! * b[2]!, a[0]! * b[1]! - a[1]! * b[0]!,
];

/** The homogeneous point where a ruling, U ⊗ V of two planes, meets a plane: the alternating product of the three. */
function meet(ruling: Float64Array, plane: Vector): number[] {
  const p = (i: number, j: number) => ruling[4 * i + j]! - ruling[4 * j + i]!;
  const minor = (i: number, j: number, k: number) => p(i, j) * plane[k]! - p(i, k) * plane[j]! + p(j, k) * plane[i]!;
  return [minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)];
}
