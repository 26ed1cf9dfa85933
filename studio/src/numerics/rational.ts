/** The exact rational form: a quintic trigonometric curve is a rational Bézier curve of degree 10 in w = tan(πt/4). */

import { binomial } from "./basis";

type Rows = readonly (readonly number[])[];

/** Weights of the eleven control points, which do not depend on the shape parameters. */
export const WEIGHTS = [1, 1, 10 / 9, 4 / 3, 12 / 7, 148 / 63, 24 / 7, 16 / 3, 80 / 9, 16, 32] as const;

/** The eleven control points of the rational form of a curve of six. */
export function degreeTen(p: Rows, alpha: number, zeta: number): number[][] {
  const middle = p[2]!.map((x, i) => 0.5 * (x + p[3]![i]!));
  return [...half(p, alpha), middle, ...half([...p].reverse(), zeta).reverse()];
}

/** Bernstein products U ⊗ V of the two points that de Casteljau's last step joins: (2n - 1) matrices, row by row. */
export function wedgePoints(homogeneous: Rows): Float64Array[] {
  const n = homogeneous.length - 1, d = homogeneous[0]!.length;
  const result = Array.from({ length: 2 * n - 1 }, () => new Float64Array(d * d));
  for (let k = 0; k < n; k++) {
    for (let j = 0; j < n; j++) {
      const factor = (binomial(n - 1, k) * binomial(n - 1, j)) / binomial(2 * n - 2, k + j);
      const first = homogeneous[k]!, second = homogeneous[j + 1]!, sum = result[k + j]!;
      for (let a = 0; a < d; a++) for (let b = 0; b < d; b++) sum[a * d + b]! += factor * (first[a]! * second[b]!);
    }
  }
  return result;
}

/** Divide a Bernstein form by w where `atStart` and by 1 - w where `atEnd`; exact. */
export function withoutFactor(coefficients: Float64Array[], atStart: boolean, atEnd: boolean): Float64Array[] {
  let result = coefficients;
  if (atStart) result = lowered(result.slice(1));
  if (atEnd) result = lowered(result.slice(0, -1).reverse()).reverse();
  return result;
}

/** b_0 to b_4; written in differences, so that α = -4 gives b_1 = b_0 to the last bit. */
function half(p: Rows, alpha: number): number[][] {
  const [p0, p1, p2, p3] = p as [number[], number[], number[], number[]];
  return [
    [...p0],
    p0.map((x, i) => x + ((4 + alpha) / 5) * (p1[i]! - x)),
    p0.map((x, i) => x + ((12 + alpha) / 25) * (p1[i]! - x) + (12 / 25) * (p2[i]! - x)),
    p1.map((x, i) => x + 0.8 * (p2[i]! - x)),
    p2.map((x, i) => x + (4 * (p1[i]! - x) + 17 * (p3[i]! - x)) / 90),
  ];
}

/** The coefficients in degree n - 1 of Σ_{m>=1} c_m B_m^n / w, given c_1, ..., c_n. */
function lowered(rest: Float64Array[]): Float64Array[] {
  const n = rest.length;
  return rest.map((row, k) => row.map((x) => x * (binomial(n, k + 1) / binomial(n - 1, k))));
}
