/** The B-spline functions: rows and blend of surfaces that come from CAD files. */

import type { Functions } from "./functions";

/** The B-spline functions of knots over any interval, scaled to [0, 1] (Piegl and Tiller 1997, eq. 2.5 and 2.7). */
export class BSpline implements Functions {
  readonly size: number;
  readonly knots: readonly number[];
  constructor(knots: readonly number[], readonly degree: number) {
    this.size = knots.length - degree - 1;
    const start = knots[degree]!, end = knots[this.size]!;
    if (!(end > start)) throw new Error(`knots: expected them to rise from ${start} over the domain, found them to end at ${end}`);
    this.knots = knots.map((knot) => (knot === end ? 1 : (knot - start) / (end - start)));
  }

  derivatives(t: Float64Array, n: number, out: Float64Array): void {
    const { knots, degree, size } = this;
    const levels = Array.from({ length: degree + 1 }, () => new Float64Array(knots.length - 1));
    for (let p = 0; p < n; p++) {
      let span = degree;
      while (span < size - 1 && knots[span + 1]! <= t[p]!) span++;
      levels[0]!.fill(0);
      levels[0]![span] = 1;
      for (let d = 1; d <= degree; d++) {
        const lower = levels[d - 1]!;
        const up = (i: number) => (t[p]! - knots[i]!) * inverse(knots[i + d]! - knots[i]!) * lower[i]!;
        for (let i = 0; i < knots.length - 1 - d; i++) levels[d]![i] = up(i) + lower[i + 1]! - up(i + 1);
      }
      for (let k = 0; k < 3; k++) {
        let values: Float64Array = k <= degree ? levels[degree - k]! : new Float64Array(knots.length - 1);
        for (let d = degree - k + 1; k <= degree && d <= degree; d++) {
          const lower = values;
          const slope = (i: number) => d * inverse(knots[i + d]! - knots[i]!) * lower[i]!;
          values = Float64Array.from({ length: knots.length - 1 - d }, (_, i) => slope(i) - slope(i + 1));
        }
        for (let i = 0; i < size; i++) out[(k * n + p) * size + i] = values[i]!;
      }
    }
  }
}

/** 1 / width, and 0 where knots coincide: those functions vanish. */
const inverse = (width: number): number => (width > 0 ? 1 / width : 0);
