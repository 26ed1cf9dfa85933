/** Functions as Chebyshev series, piece by piece: what Python sends of families and rows that the page does not know. */

import type { Functions } from "./functions";

/** Coefficients of one piece: by derivative 0 to 2, by degree, by function. */
type Piece = readonly (readonly (readonly number[])[])[];

/** Each derivative has a series of its own, so that none is worse than the values (Clenshaw 1955). */
export class Chebyshev implements Functions {
  readonly size: number;
  constructor(readonly breaks: readonly number[], readonly series: readonly Piece[]) {
    this.size = series[0]![0]![0]!.length;
  }

  derivatives(t: Float64Array, n: number, out: Float64Array): void {
    const { breaks, series, size } = this;
    for (let p = 0; p < n; p++) {
      let piece = 0;
      while (piece < series.length - 1 && breaks[piece + 1]! <= t[p]!) piece++;
      const a = breaks[piece]!, b = breaks[piece + 1]!, x = (t[p]! - a - (b - t[p]!)) / (b - a);
      series[piece]!.forEach((terms, k) => {
        for (let i = 0; i < size; i++) {
          let next = 0, last = 0;
          for (let degree = terms.length - 1; degree > 0; degree--) [next, last] = [2 * x * next - last + terms[degree]![i]!, next];
          out[(k * n + p) * size + i] = x * next - last + terms[0]![i]!;
        }
      });
    }
  }
}
