/** The one surface type: rows Q_j(u), curves in u, blended by scalar functions D_j(v). */

import data from "../data.json";
import type { Functions } from "./functions";
import type { Loop } from "./trim";

/** The curves Q_j(u) of a surface: 3 coordinates, or 4 homogeneous ones. */
export interface Rows {
  readonly size: number;
  readonly dimension: number;
  /** Write derivatives 0 to 2 by u to out[((k n + p) size + j) dimension + x]. */
  derivatives(u: Float64Array, n: number, out: Float64Array): void;
}

/** Points (n, m, dimension) in one array, row by row. */
export interface Points {
  readonly values: Float64Array;
  readonly n: number;
  readonly m: number;
  readonly dimension: number;
}

/** Rows that share their functions: Q_j(u) = Σ_i f_i(u) P_ij. */
export class Net implements Rows {
  readonly size: number;
  readonly dimension: number;
  private scratch = new Float64Array(0);
  constructor(readonly points: Points, readonly functions: Functions) {
    this.size = points.m;
    this.dimension = points.dimension;
  }

  derivatives(u: Float64Array, n: number, out: Float64Array): void {
    const size = this.functions.size, width = this.size * this.dimension, p = this.points.values;
    if (this.scratch.length < 3 * n * size) this.scratch = new Float64Array(3 * n * size);
    const f = this.scratch;
    this.functions.derivatives(u, n, f);
    for (let q = 0; q < 3 * n; q++) {
      for (let x = 0; x < width; x++) {
        let sum = 0;
        for (let i = 0; i < size; i++) sum += f[q * size + i]! * p[i * width + x]!;
        out[q * width + x] = sum;
      }
    }
  }
}

/**
 * S(u, v) = Σ_j Q_j(u) D_j(v) over [0, 1]²; the normal points along S_u × S_v, against it when `flip`. `net` is the
 * control net to draw. Homogeneous rows make a rational surface. Rows hold points as seen from `origin`. `trim` holds the
 * closed loops of (u, v) that bound a face cut from the surface.
 */
export interface Surface {
  readonly rows: Rows;
  readonly blend: Functions;
  readonly flip: boolean;
  readonly net: Points | null;
  readonly origin?: readonly number[];
  readonly trim?: readonly Loop[];
}

/** Which way the normal points, against or along S_u × S_v; closed forms turn it outwards by themselves. */
export const normalSide = (surface: Surface): "along" | "against" => (surface.flip ? "against" : "along");

const { stepsForSize: SIDE, farOff: FAR_OFF, samePoint: SAME_POINT } = data.limits;
const STEPS = Float64Array.from({ length: SIDE }, (_, i) => i / (SIDE - 1));

const found = new Float64Array(3 * SIDE * SIDE);
const away = new Float64Array(SIDE * SIDE);

/**
 * Smallest and largest coordinates of a grid of points of the surface, and the diagonal between them, length¹. Points that
 * lie as good as at infinity are left out.
 */
export function extent(surface: Surface): { low: number[]; high: number[]; size: number } {
  const { rows, blend, origin = [0, 0, 0] } = surface;
  const m = rows.size, d = rows.dimension;
  const q = new Float64Array(3 * SIDE * m * d), f = new Float64Array(3 * SIDE * m);
  rows.derivatives(STEPS, SIDE, q);
  blend.derivatives(STEPS, SIDE, f);
  let count = 0;
  const sum = [0, 0, 0, 1];
  for (let i = 0; i < SIDE; i++) {
    for (let k = 0; k < SIDE; k++) {
      for (let x = 0; x < d; x++) {
        sum[x] = 0;
        for (let j = 0; j < m; j++) sum[x]! += q[(i * m + j) * d + x]! * f[k * m + j]!;
      }
      const w = d === 4 ? sum[3]! : 1;
      for (let x = 0; x < 3; x++) found[3 * count + x] = sum[x]! / w;
      if (Number.isFinite(found[3 * count]! + found[3 * count + 1]! + found[3 * count + 2]!)) count++;
    }
  }
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  const [mx, my, mz] = [0, 1, 2].map((x) => {
    for (let p = 0; p < count; p++) away[p] = found[3 * p + x]!;
    return median(away.subarray(0, count));
  }) as [number, number, number];
  for (let p = 0; p < count; p++) {
    away[p] = Math.max(Math.abs(found[3 * p]! - mx), Math.abs(found[3 * p + 1]! - my), Math.abs(found[3 * p + 2]! - mz));
  }
  const reach = FAR_OFF * median(away.slice(0, count)) || Infinity;
  for (let p = 0; p < count; p++) {
    if (away[p]! > reach) continue;
    for (let x = 0; x < 3; x++) {
      low[x] = Math.min(low[x]!, found[3 * p + x]!);
      high[x] = Math.max(high[x]!, found[3 * p + x]!);
    }
  }
  // From points near the origin of the surface, so that the size loses no digits to the distance.
  const diagonal = count ? Math.sqrt(low.reduce((total, value, x) => total + (high[x]! - value) ** 2, 0)) : 0;
  for (let x = 0; x < 3; x++) {
    low[x]! += origin[x]!;
    high[x]! += origin[x]!;
  }
  const largest = Math.max(...low.map(Math.abs), ...high.map(Math.abs));
  return { low, high, size: diagonal > SAME_POINT * largest ? diagonal : 0 };
}

function median(values: Float64Array): number {
  values.sort();
  const half = values.length >> 1;
  return values.length % 2 ? values[half]! : 0.5 * (values[half - 1]! + values[half]!);
}
