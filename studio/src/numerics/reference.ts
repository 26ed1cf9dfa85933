/** Surfaces with curvature in closed form, as rows and a blend like every other surface. */

import { packed } from "./construct";
import { Circular, Hyperbolic, Joined, Powers, type Functions } from "./functions";
import { Net, type Points, type Surface } from "./surface";

const ONE = new Powers(0, 1, 0);
type Row = readonly [number, number, number];

export const sphere = (radius: number, flip: boolean): Surface => ellipsoid(radius, radius, radius, flip);

export function ellipsoid(a: number, b: number, c: number, flip: boolean): Surface {
  return turned(new Circular(-1, 1), [[a, b, 0], [0, 0, c]], !flip);
}

export function cylinder(r: number, h: number, flip: boolean): Surface {
  return turned(new Powers(0, 1, 1), [[r, r, 0], [0, 0, h]], !flip);
}

export function cone(r: number, h: number, flip: boolean): Surface {
  return turned(new Powers(0, 1, 1), [[r, r, 0], [-r, -r, h]], !flip);
}

export function torus(big: number, small: number, flip: boolean): Surface {
  return turned(new Joined([new Circular(0, 4), ONE]), [[small, small, 0], [0, 0, small], [big, big, 0]], !flip);
}

export function catenoid(a: number, h: number, flip: boolean): Surface {
  const end = (0.5 * h) / a;
  const profile = new Joined([new Hyperbolic(-end, end), new Powers(-end, end, 1)]);
  return turned(profile, [[a, a, 0], [0, 0, 0], [0, 0, 0], [0, 0, a]], !flip);
}

export function helicoid(r: number, pitch: number, flip: boolean): Surface {
  const points = packed([
    [[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, pitch / (2 * Math.PI)]],
    [[1, 0, 0], [0, 1, 0], [0, 0, 0], [0, 0, 0]],
  ]);
  const blend = new Joined([new Circular(0, 4), new Powers(0, 2 * Math.PI, 1)]);
  return { rows: new Net(points, new Powers(-r, r, 1)), blend, flip, net: null };
}

export const hyperbolicParaboloid = (size: number, flip: boolean): Surface =>
  polynomial(size, [[1, 0, 1, 0, 0], [0, 1, 0, 1, 0], [1, 1, 0, 0, 1]], flip);

export const monkeySaddle = (size: number, flip: boolean): Surface =>
  polynomial(size, [[1, 0, 1, 0, 0], [0, 1, 0, 1, 0], [3, 0, 0, 0, 1], [1, 2, 0, 0, -3]], flip);

export function enneper(size: number, flip: boolean): Surface {
  const third = 1 / 3;
  const terms = [
    [1, 0, 1, 0, 0], [3, 0, -third, 0, 0], [1, 2, 1, 0, 0], [0, 1, 0, 1, 0],
    [0, 3, 0, -third, 0], [2, 1, 0, 1, 0], [2, 0, 0, 0, 1], [0, 2, 0, 0, -1],
  ];
  return polynomial(size, terms, flip);
}

/** (Σ a_i p_i cos w, Σ b_i p_i sin w, Σ c_i p_i), w = 2πv, from coefficients (a_i, b_i, c_i). */
function turned(profile: Functions, coefficients: readonly Row[], flip: boolean): Surface {
  const points = packed(coefficients.map(([a, b, c]) => [[a, 0, 0], [0, b, 0], [0, 0, c]]));
  return { rows: new Net(points, profile), blend: new Joined([new Circular(0, 4), ONE]), flip, net: null };
}

/** Σ c x^p y^q over |x|, |y| <= size, from terms (p, q, cx, cy, cz). */
function polynomial(size: number, terms: readonly (readonly number[])[], flip: boolean): Surface {
  const n = Math.max(...terms.map((term) => term[0]!)) + 1, m = Math.max(...terms.map((term) => term[1]!)) + 1;
  const points: Points = { values: new Float64Array(n * m * 3), n, m, dimension: 3 };
  for (const [p, q, ...value] of terms) points.values.set(value, (p! * m + q!) * 3);
  return { rows: new Net(points, new Powers(-size, size, n - 1)), blend: new Powers(-size, size, m - 1), flip, net: null };
}
