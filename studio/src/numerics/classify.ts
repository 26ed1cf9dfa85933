/** Classes of points (thesis tables 3.1-3.4); every decision that a curvature is zero is made here. */

import data from "../data.json";

/** When a curvature counts as zero: `flat` relative to 1/size, `relative` to the point's curvedness. */
export interface Thresholds {
  readonly relative: number;
  readonly flat: number;
}

/** Python's own. */
export const THRESHOLDS: Thresholds = data.limits;

/** Besl's number of the signs of K and H; 0 for NaN. `flat` is a curvedness, length⁻¹. */
export function besl(gaussian: number, mean: number, curvedness: number, relative: number, flat: number): number {
  if (!(Math.abs(curvedness) < 1e300)) return 0;
  if (curvedness <= flat) return 5;
  const k = Math.abs(gaussian) <= relative * curvedness * curvedness ? 0 : gaussian > 0 ? 1 : -1;
  const h = Math.abs(mean) <= relative * curvedness ? 0 : mean > 0 ? 1 : -1;
  return 1 + 3 * (1 + h) + (1 - k);
}

/** The point type from Besl's number; umbilic where R <= relative C. */
export function pointType(code: number, radius: number, curvedness: number, relative: number): number {
  if (code === 0) return 0;
  if (code === 5) return 4;
  const column = (code - 1) % 3; // 0: K > 0, 1: K = 0, 2: K < 0
  if (column === 0) return radius <= relative * curvedness ? 5 : 1;
  return column === 1 ? 3 : 2;
}

/** Koenderink's class of a shape index; 10 where Besl's number says flat, 0 where undefined. */
export function shapeClass(index: number, code: number): number {
  if (code === 0) return 0;
  if (code === 5) return 10;
  let result = 1;
  for (const edge of data.shapeBreaks) {
    if (index >= -edge) result++;
    if (index > edge) result++;
  }
  return result;
}
