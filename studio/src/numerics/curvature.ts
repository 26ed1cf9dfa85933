/**
 * The curvature formulas at a point, from a, b, c, the second fundamental form in the orthonormal frame along S_u:
 * H = (a + c)/2, R = hypot((a - c)/2, b), κ1, κ2 = H ± R, K = a c - b² (do Carmo 1976, §3.2-3.3).
 */

/** R = (κ1 - κ2)/2, length⁻¹. */
export function halfDifference(a: number, b: number, c: number): number {
  const d = 0.5 * (a - c);
  return Math.sqrt(d * d + b * b);
}

/** S = -(2/π) atan2(H, R) (Koenderink and van Doorn 1992); NaN where the curvedness is not above `flat`. */
export function shapeIndex(mean: number, halfDifference: number, curvedness: number, flat: number): number {
  return curvedness > flat ? (-2 / Math.PI) * Math.atan2(mean, halfDifference) : NaN;
}

/** Results of the last `principalDirection`, which returns nothing so that it allocates nothing. */
export let directionCos = 1;
export let directionSin = 0;

/** Set cos θ, sin θ of the direction of κ1 in the frame, from the form of the eigenvector without cancellation. */
export function principalDirection(a: number, b: number, c: number, halfDifference: number): void {
  const d = 0.5 * (a - c);
  const x = d >= 0 ? halfDifference + d : b;
  const y = d >= 0 ? b : halfDifference - d;
  const length = Math.sqrt(x * x + y * y);
  directionCos = x / length;
  directionSin = y / length;
}
