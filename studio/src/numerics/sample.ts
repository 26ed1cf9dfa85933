/** Analysis of a surface at parameters, as in Python: arrays by the key of the quantity. */

import { THRESHOLDS, type Thresholds } from "./classify";
import { Grid } from "./kernel";
import { QUANTITIES, QUANTITY } from "./quantity";
import type { Surface } from "./surface";

export type Sample = Record<string, Float64Array>;

/** Quantities (all by default) at the grid u × v, or at the pairs (u[i], v[i]) when `scattered`. */
export function analyse(
  surface: Surface, u: ArrayLike<number>, v: ArrayLike<number>, scattered = false,
  keys: readonly string[] = QUANTITIES.map((q) => q.key), thresholds: Thresholds = THRESHOLDS,
): Sample {
  for (const t of [...Array.from(u), ...Array.from(v)]) {
    if (!(t >= 0 && t <= 1)) throw new Error(`parameter ${t} is outside the domain [0, 1]`);
  }
  const grid = new Grid();
  grid.evaluateAt(surface, Float64Array.from(u), Float64Array.from(v), !scattered);
  return Object.fromEntries(
    keys.map((key) => {
      const out = new Float64Array(grid.count * (QUANTITY[key]?.components ?? 1));
      grid.quantity(key, out, thresholds);
      return [key, out];
    }),
  );
}
